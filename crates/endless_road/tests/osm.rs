//! Real extracts become maps that hold together.
#![expect(clippy::print_stdout, reason = "says which files were there, and figures")]

use endless_road::osm::{self, OsmOptions};
use endless_road::{LaneId, RoadMap, RoadNetwork, WalkKind};
use std::path::PathBuf;

fn files() -> Vec<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/osm");
    let Ok(entries) = std::fs::read_dir(&folder) else {
        println!("no extracts in {}: nothing read", folder.display());
        return Vec::new();
    };
    let mut files: Vec<PathBuf> = entries.filter_map(|e| Some(e.ok()?.path())).collect();
    files.sort();
    files
}

fn maps(options: &OsmOptions) -> Vec<(String, RoadMap)> {
    files()
        .into_iter()
        .map(|file| {
            let name = file.file_name().expect("a file").to_string_lossy().into_owned();
            let bytes = std::fs::read(&file).expect("readable");
            let map = osm::read(&bytes, options).unwrap_or_else(|e| panic!("{name}: {e}"));
            (name, map)
        })
        .collect()
}

fn reached_from(network: &RoadNetwork, start: LaneId) -> usize {
    let mut seen = vec![false; network.lanes.len()];
    let mut open = vec![start];
    while let Some(id) = open.pop() {
        if !std::mem::replace(&mut seen[id.index()], true) {
            let lane = network.lane(id);
            open.extend(lane.successors.iter().chain(&lane.left).chain(&lane.right).copied());
        }
    }
    seen.into_iter().filter(|&s| s).count()
}

#[test]
fn successors_meet() {
    for (name, map) in maps(&OsmOptions::default()) {
        let mut worst = (0.0, 0.0);
        for lane in &map.network.lanes {
            let end = lane.centerline.at(f64::INFINITY);
            for &next in &lane.successors {
                let start = map.network.lane(next).centerline.at(0.0);
                let gap = end.position.distance(start.position);
                let bend = endless_world::math::f64::wrap_angle(end.heading_rad - start.heading_rad).abs().to_degrees();
                worst = (f64::max(worst.0, gap), f64::max(worst.1, bend));
                assert!(gap < 0.05, "{name}: {:?} to {next:?}: {gap} m apart", lane.id);
                assert!(bend < 2.0, "{name}: {:?} to {next:?}: {bend}° at {}", lane.id, end.position);
            }
        }
        println!("{name}: at most {:.4} m and {:.2}°", worst.0, worst.1);
    }
}

#[test]
fn lanes_do_not_kink() {
    for (name, map) in maps(&OsmOptions::default()) {
        for lane in &map.network.lanes {
            for three in lane.centerline.points().windows(3) {
                let (u, v) = ((three[1] - three[0]).truncate(), (three[2] - three[1]).truncate());
                assert!(u.angle_to(v).abs() < 0.7, "{name}: {:?} has a kink at {:?}", lane.id, three[1]);
            }
        }
    }
}

#[test]
fn every_crossing_joins_two_sidewalks() {
    for (name, map) in maps(&OsmOptions::default()) {
        let walk = &map.network.walk;
        let mut sidewalks = vec![0; walk.nodes.len()];
        let mut edges = vec![0; walk.nodes.len()];
        for edge in &walk.edges {
            for node in edge.nodes {
                edges[node.index()] += 1;
                sidewalks[node.index()] += usize::from(edge.kind == WalkKind::Sidewalk);
            }
        }
        assert!(edges.iter().all(|&n| n > 0), "{name}: a node that no edge touches");
        for edge in walk.edges.iter().filter(|e| e.kind != WalkKind::Sidewalk) {
            for node in edge.nodes {
                assert!(
                    sidewalks[node.index()] > 0,
                    "{name}: a crossing ends at {} in the void",
                    walk.nodes[node.index()]
                );
            }
        }
    }
}

#[test]
fn vehicles_get_around() {
    for (name, map) in maps(&OsmOptions::default()) {
        let network = &map.network;
        let circulating = network.circulating_lanes();
        let share = circulating.iter().filter(|c| **c).count() as f64 / network.lanes.len() as f64;
        println!(
            "{name}: {} lanes, {:.0} % circulate, {} spawn points",
            network.lanes.len(),
            100.0 * share,
            network.spawn_points.len()
        );
        assert!(network.spawn_points.len() > 5, "{name}");
        let components = network.lane_components();
        for point in &network.spawn_points {
            let own = components[point.lane.index()];
            let size = components.iter().filter(|c| **c == own).count();
            assert!(reached_from(network, point.lane) * 10 >= size * 8, "{name}: {:?}", point.lane);
        }
    }
}
