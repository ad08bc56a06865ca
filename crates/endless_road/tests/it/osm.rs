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

/// A village: a cross of two-way streets, a one-way pair, a roundabout, lights, crossings, a house with a court.
fn village() -> String {
    let mut text = String::from("<?xml version='1.0'?>\n<osm version='0.6'>\n");
    let mut node = |id: i64, x: f64, y: f64, tags: &str| {
        let (lat, lon) = (48.0 + y / 111_200.0, 11.0 + x / 74_600.0);
        text += &format!("<node id='{id}' lat='{lat:.7}' lon='{lon:.7}'>{tags}</node>\n");
    };
    node(1, 0.0, 0.0, "<tag k='highway' v='traffic_signals'/>");
    node(2, 150.0, 0.0, "");
    node(3, 0.0, 120.0, "");
    node(4, -140.0, 5.0, "");
    node(5, 0.0, -130.0, "");
    node(6, 70.0, 0.0, "<tag k='highway' v='crossing'/><tag k='crossing' v='zebra'/>");
    for (i, angle) in (0..12).map(|i| (i, f64::from(i) * 30f64.to_radians())) {
        let (sin, cos) = endless_world::math::f64::sin_cos(angle);
        node(20 + i64::from(i), 170.0 + 20.0 * cos, 20.0 * sin, "");
    }
    node(40, 260.0, 0.0, "");
    node(41, 60.0, -90.0, "");
    for (i, (x, y)) in [(15.0, 15.0), (40.0, 15.0), (40.0, 40.0), (15.0, 40.0)].into_iter().enumerate() {
        node(50 + i as i64, x, y, "");
    }
    node(60, 30.0, -10.0, "<tag k='natural' v='tree'/>");
    let mut way = |id: i64, nodes: &[i64], tags: &[(&str, &str)]| {
        text += &format!("<way id='{id}'>");
        nodes.iter().for_each(|n| text += &format!("<nd ref='{n}'/>"));
        tags.iter().for_each(|(k, v)| text += &format!("<tag k='{k}' v='{v}'/>"));
        text += "</way>\n";
    };
    let two = [("highway", "secondary"), ("sidewalk", "both"), ("lanes", "2")];
    way(100, &[4, 1, 6, 26], &two);
    way(101, &[3, 1, 5], &[("highway", "residential"), ("sidewalk", "both"), ("maxspeed", "30")]);
    let ring: Vec<i64> = (0..12).map(|i| 20 + i).chain([20]).collect();
    way(102, &ring, &[("highway", "secondary"), ("junction", "roundabout")]);
    way(103, &[20, 40], &two);
    way(
        104,
        &[5, 41, 6],
        &[("highway", "residential"), ("oneway", "yes"), ("turn:lanes", "left|right"), ("lanes", "2")],
    );
    way(105, &[50, 51, 52, 53, 50], &[("building", "apartments"), ("building:levels", "4")]);
    text += "</osm>\n";
    text
}

#[test]
fn a_village_is_read_on_either_side() {
    use endless_world::DrivingSide;
    let text = village();
    let read = |side| {
        let options = OsmOptions { driving_side: Some(side), ..OsmOptions::default() };
        osm::read(text.as_bytes(), &options).expect("a village")
    };
    let (right, left) = (read(DrivingSide::Right), read(DrivingSide::Left));
    assert!(!right.left_hand && left.left_hand);
    assert_eq!(right.footprints.len(), 1);
    assert_eq!(right.footprints[0].levels, Some(4.0));
    for map in [&right, &left] {
        let network = &map.network;
        assert!(network.junctions.iter().any(|j| j.program.is_some()), "the lights have a program");
        assert!(
            network.crossings.iter().any(|c| c.signal.is_some())
                && network.crossings.iter().any(|c| c.signal.is_none())
        );
        // Looking along a two-way street, who comes towards one is on the side away from one's own.
        let lanes: Vec<_> = network.lanes.iter().filter(|l| l.junction.is_none()).collect();
        let mut checked = 0;
        for a in &lanes {
            let here = a.centerline.at(0.5 * a.centerline.length());
            let (sin, cos) = endless_world::math::f64::sin_cos(here.heading_rad);
            let ahead = glam::DVec2::new(cos, sin);
            for b in &lanes {
                let (s, _) = b.centerline.project(here.position.truncate());
                let there = b.centerline.at(s);
                let across = (there.position - here.position).truncate();
                let oncoming = endless_world::math::f64::wrap_angle(there.heading_rad - here.heading_rad).abs() > 3.0;
                if oncoming && across.length() < 5.0 {
                    assert_eq!(ahead.perp_dot(across) > 0.0, !map.left_hand, "{:?} and {:?}", a.id, b.id);
                    checked += 1;
                }
            }
        }
        assert!(checked > 4);
    }
    // The same place is at the same place.
    let corner = |map: &RoadMap| map.footprints[0].outline.iter().fold(glam::DVec2::INFINITY, |a, b| a.min(*b));
    assert!(corner(&right).distance(corner(&left)) < 1e-6);
}

#[test]
fn the_walks_of_a_village_hang_together() {
    let map = osm::read(village().as_bytes(), &OsmOptions::default()).expect("a village");
    let walk = &map.network.walk;
    let graph = endless_road::WalkGraph::new(walk);
    let first = graph.part(endless_road::WalkNodeId(0));
    let joined = (0..walk.nodes.len()).filter(|&i| graph.part(endless_road::WalkNodeId(i as u32)) == first).count();
    assert!(joined * 10 >= walk.nodes.len() * 8, "{joined} of {}", walk.nodes.len());
}

#[test]
fn what_is_no_map_says_so() {
    let read = |bytes: &[u8]| osm::read(bytes, &OsmOptions::default()).expect_err("no map").to_string();
    assert!(read(b"").contains("neither"));
    assert!(read(b"PK\x03\x04").contains("neither"));
    assert!(read(b"<osm>").contains("line 1"));
    assert!(read(b"<osm></osm>").contains("no road"));
    let half = village();
    assert!(read(&half.as_bytes()[..half.len() / 2]).contains("line"));
}

mod damage {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { cases: 160, ..ProptestConfig::default() })]

        /// Bytes changed and cut off anywhere: an error or a map, never a panic.
        #[test]
        fn never_panics(changes in prop::collection::vec((0usize..8000, any::<u8>()), 0..12), cut in 0usize..9000) {
            let mut bytes = village().into_bytes();
            for (at, byte) in changes {
                let n = bytes.len();
                bytes[at % n] = byte;
            }
            bytes.truncate(cut.max(10));
            let _ = osm::read(&bytes, &OsmOptions::default());
        }

        /// Nodes anywhere, in any order, joined by streets of any class.
        #[test]
        fn any_geometry_is_taken(
            places in prop::collection::vec((-120.0..120.0f64, -120.0..120.0f64), 4..14),
            ways in prop::collection::vec((prop::collection::vec(0usize..14, 2..7), 0usize..8, 0usize..6), 1..9),
        ) {
            let mut text = String::from("<osm>");
            for (i, (x, y)) in places.iter().enumerate() {
                text += &format!("<node id='{i}' lat='{:.7}' lon='{:.7}'/>", y / 111_200.0, x / 111_300.0);
            }
            let classes = ["motorway", "trunk_link", "primary", "secondary", "residential", "service", "footway", "living_street"];
            let extras = [
                "",
                "<tag k='oneway' v='yes'/><tag k='lanes' v='3'/>",
                "<tag k='junction' v='roundabout'/>",
                "<tag k='bridge' v='yes'/><tag k='layer' v='1'/>",
                "<tag k='tunnel' v='yes'/>",
                "<tag k='lanes' v='5'/><tag k='sidewalk' v='both'/>",
            ];
            for (id, (nodes, class, extra)) in ways.iter().enumerate() {
                text += &format!("<way id='{id}'>");
                nodes.iter().for_each(|n| text += &format!("<nd ref='{}'/>", n % places.len()));
                text += &format!("<tag k='highway' v='{}'/>{}</way>", classes[*class], extras[*extra]);
            }
            text += "</osm>";
            match osm::read(text.as_bytes(), &OsmOptions::default()) {
                Ok(map) => {
                    for lane in &map.network.lanes {
                        prop_assert!(lane.centerline.points().iter().all(|p| p.is_finite()));
                    }
                    for strip in &map.lane_surfaces {
                        prop_assert_eq!(strip.left.len(), strip.right.len());
                        prop_assert!(strip.left.iter().chain(&strip.right).all(|p| p.is_finite()));
                    }
                }
                Err(osm::OsmError::NoRoads { .. }) => {}
                Err(error) => return Err(TestCaseError::fail(format!("{error}\n{text}"))),
            }
        }
    }
}

#[test]
fn every_light_turns_green() {
    use endless_road::TrafficControl;
    use endless_world::SignalAspect::Green;
    for (name, map) in maps(&OsmOptions::default()) {
        let network = &map.network;
        let mut green = vec![false; usize::from(network.signal_groups)];
        for program in network.junctions.iter().filter_map(|j| j.program.as_ref()) {
            for phase in &program.phases {
                assert_eq!(phase.aspects.len(), program.phases[0].aspects.len(), "{name}");
                phase.aspects.iter().for_each(|&(id, aspect)| green[usize::from(id.0)] |= aspect == Green);
            }
        }
        for lane in &network.lanes {
            if let TrafficControl::Signal(id) = lane.end_control {
                assert!(green[usize::from(id.0)], "{name}: {id:?} stays red");
            }
        }
        for crossing in &network.crossings {
            assert!(crossing.signal.is_none_or(|id| green[usize::from(id.0)]), "{name}: people wait for ever");
        }
    }
}

/// Nodes at places in metres and ways with tags, as a file.
fn file(nodes: &[(i64, f64, f64)], ways: &[(i64, &[i64], &str)], rest: &str) -> String {
    let mut text = String::from("<osm version='0.6'>");
    for (id, x, y) in nodes {
        text += &format!("<node id='{id}' lat='{:.7}' lon='{:.7}'/>", y / 111_200.0, x / 111_300.0);
    }
    for (id, nodes, tags) in ways {
        text += &format!("<way id='{id}'>");
        nodes.iter().for_each(|n| text += &format!("<nd ref='{n}'/>"));
        for (k, v) in tags.split(' ').filter_map(|t| t.split_once('=')) {
            text += &format!("<tag k='{k}' v='{v}'/>");
        }
        text += "</way>";
    }
    text + rest + "</osm>"
}

#[test]
fn restrictions_are_obeyed() {
    use endless_road::Turn;
    let nodes = [(1, 0.0, 0.0), (2, 100.0, 0.0), (3, -100.0, 0.0), (4, 0.0, -100.0)];
    let ways: [(i64, &[i64], &str); 3] =
        [(10, &[3, 1], "highway=tertiary"), (11, &[1, 2], "highway=tertiary"), (12, &[4, 1], "highway=residential")];
    let rule = "<relation id='1'><member type='way' ref='12' role='from'/><member type='node' ref='1' role='via'/>\
        <member type='way' ref='10' role='to'/><tag k='type' v='restriction'/><tag k='restriction' v='no_left_turn'/></relation>";
    let turns = |rest: &str| {
        let map = osm::read(file(&nodes, &ways, rest).as_bytes(), &OsmOptions::default()).expect("a junction");
        map.network.lanes.iter().filter(|l| l.junction.is_some() && l.turn == Turn::Left).count()
    };
    assert_eq!(turns("") - turns(rule), 1);
}

#[test]
fn bridges_pass_over() {
    let nodes = [(1, -200.0, 0.0), (2, -20.0, 0.0), (3, 20.0, 0.0), (4, 200.0, 0.0), (5, 0.0, -150.0), (6, 0.0, 150.0)];
    let ways: [(i64, &[i64], &str); 4] = [
        (10, &[1, 2], "highway=secondary"),
        (11, &[2, 3], "highway=secondary bridge=yes layer=1"),
        (12, &[3, 4], "highway=secondary"),
        (13, &[5, 6], "highway=secondary"),
    ];
    let map = osm::read(file(&nodes, &ways, "").as_bytes(), &OsmOptions::default()).expect("a bridge");
    let high = map.network.lanes.iter().flat_map(|l| l.centerline.points()).map(|p| p.z).fold(0.0, f64::max);
    assert!((5.0..7.0).contains(&high), "{high}");
    let steepest = map.network.lanes.iter().map(|l| l.centerline.at(0.3 * l.centerline.length()).grade.abs());
    assert!(steepest.fold(0.0, f64::max) < 0.08);
    assert!(map.lane_surfaces.iter().any(|s| s.bridge && s.left.iter().all(|p| p.z > 4.0)));
    // Nobody turns from one road to the other.
    assert!(map.network.junctions.iter().all(|j| j.conflicts.is_empty()));
}

#[test]
fn roundabouts_turn_left_in_right_hand_traffic() {
    for (name, map) in maps(&OsmOptions::default()).into_iter().filter(|(name, _)| name.starts_with("tiny_roundabout"))
    {
        let turning = map.network.lanes.iter().filter(|l| l.junction.is_none()).filter(|l| {
            let end = l.centerline.at(f64::INFINITY).heading_rad;
            endless_world::math::f64::wrap_angle(end - l.centerline.at(0.0).heading_rad) > 1.0
        });
        assert!(turning.count() >= 2, "{name}");
    }
}

/// A node far from all others is an error that says which, at once.
#[test]
fn roads_reach_no_further_than_a_city() {
    let village = |node: &str| {
        format!(
            "<osm><node id='1' lat='48.0' lon='11.0'/><node id='2' lat='48.0' lon='11.002'/>\
             <node id='3' lat='48.001' lon='11.002'/>{node}<way id='7'><nd ref='1'/><nd ref='2'/><nd ref='3'/>\
             <tag k='highway' v='residential'/></way><way id='8'><nd ref='3'/><nd ref='4'/><nd ref='5'/>\
             <tag k='highway' v='residential'/></way></osm>"
        )
    };
    let near = village("<node id='4' lat='48.1' lon='11.1'/><node id='5' lat='48.15' lon='11.2'/>");
    assert!(osm::read(near.as_bytes(), &OsmOptions::default()).is_ok());
    let far = village("<node id='4' lat='48.15' lon='11.1'/><node id='5' lat='48.3' lon='11.2'/>");
    let error = osm::read(far.as_bytes(), &OsmOptions::default()).expect_err("33 km away").to_string();
    assert!(error.contains("node 5 of way 8 (48.30000, 11.20000)") && error.contains("33 km"), "{error}");
}
