//! Maps from files become towns that can be filmed: real files where they are at hand, and a small map made here.
#![expect(clippy::print_stdout, clippy::unwrap_used, reason = "tests")]

use endless_asset::{Catalogue, Prop};
use endless_road::{
    BuildingFootprint, LandUse, LandUseArea, Lane, LaneId, LaneSurface, LaneType, Polyline, RoadMap, RoadNetwork,
};
use endless_town::{PlacedObject, Town, TownError, dress_map};
use endless_world::ClassTag;
use glam::{DVec2, DVec3, Vec3};
use std::path::PathBuf;

fn lane(id: u32, from: DVec3, to: DVec3) -> Lane {
    let steps = 40;
    Lane::new(LaneId(id), Polyline::new((0..=steps).map(|i| from.lerp(to, f64::from(i) / f64::from(steps)))), 3.5, 11.0)
}

/// A street of 240 m on a slope of 5 %, with sidewalks, a house, a courtyard block and a pond.
fn street() -> RoadMap {
    let at = |x: f64, y: f64| DVec3::new(x, y, 0.05 * x);
    let network = RoadNetwork {
        lanes: vec![lane(0, at(0.0, -1.75), at(240.0, -1.75)), lane(1, at(240.0, 1.75), at(0.0, 1.75))],
        ..RoadNetwork::default()
    };
    let strip = |kind, y0: f64, y1: f64, up: f64| {
        let line = |y: f64| (0..=24).map(|i| at(10.0 * f64::from(i), y) + DVec3::Z * up).collect();
        LaneSurface { kind, left: line(y1), right: line(y0), in_junction: false, unpaved: false, bridge: false }
    };
    let ring = |low: DVec2, high: DVec2| vec![low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)];
    let mut hole = ring(DVec2::new(68.0, 18.0), DVec2::new(78.0, 26.0));
    hole.reverse();
    let block = |outline, holes, kind: &str| BuildingFootprint {
        outline,
        holes,
        height_m: None,
        levels: None,
        kind: kind.to_owned(),
        color: None,
    };
    RoadMap {
        network: network.finish().unwrap(),
        lane_surfaces: vec![
            strip(LaneType::Driving, -3.5, 0.0, 0.0),
            strip(LaneType::Driving, 0.0, 3.5, 0.0),
            strip(LaneType::Sidewalk, 3.5, 6.0, 0.15),
            strip(LaneType::Sidewalk, -6.0, -3.5, 0.15),
        ],
        footprints: vec![
            block(ring(DVec2::new(20.0, 9.0), DVec2::new(31.0, 18.0)), vec![], "house"),
            block(ring(DVec2::new(60.0, 8.0), DVec2::new(86.0, 34.0)), vec![hole], "apartments"),
            // Across the road: left out.
            block(ring(DVec2::new(120.0, -8.0), DVec2::new(130.0, 8.0)), vec![], "yes"),
        ],
        areas: vec![LandUseArea {
            kind: LandUse::Water,
            outline: ring(DVec2::new(20.0, -40.0), DVec2::new(23.0, -20.0)),
            holes: vec![],
        }],
        georeference: Some("+proj=tmerc +lat_0=48 +lon_0=11.5 +datum=WGS84".to_owned()),
        ..RoadMap::default()
    }
}

fn files() -> Vec<(String, RoadMap)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data");
    let mut maps = Vec::new();
    let Ok(entries) = std::fs::read_dir(folder.join("opendrive")) else {
        println!("skipped: {} is not there", folder.display());
        return maps;
    };
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        maps.push((name, endless_road::opendrive::read(&std::fs::read_to_string(&path).unwrap()).unwrap()));
    }
    maps
}

/// Triangles of the town's own meshes in the world, with the tag of each.
fn still(town: &Town) -> impl Iterator<Item = ([Vec3; 3], ClassTag)> {
    town.placements
        .iter()
        .filter_map(|p| match p.object {
            PlacedObject::TownMesh(i) => Some((&town.meshes[i as usize], p.world_from_object)),
            PlacedObject::Prop(..) => None,
        })
        .flat_map(|(mesh, place)| {
            mesh.triangles.iter().zip(&mesh.triangle_materials).map(move |(t, &m)| {
                let corners = t.map(|k| place.transform_point3(mesh.positions[k as usize]));
                (corners, mesh.materials[usize::from(m)].tag)
            })
        })
}

fn check(town: &Town) {
    let name = &town.name;
    for (mesh, m) in town.meshes.iter().zip(0..) {
        assert!(mesh.positions.iter().chain(&mesh.normals).all(|p| p.is_finite()), "{name}: mesh {m}");
        assert!(mesh.uvs.iter().all(|p| p.is_finite()), "{name}: mesh {m}");
    }
    assert!(town.cameras.len() >= 5, "{name}: {} cameras", town.cameras.len());
    // Pavement lies under every lane, and nothing of the land above it.
    let mut over: Vec<(DVec3, f64, bool)> = Vec::new();
    for lane in town.network.lanes.iter().filter(|l| l.centerline.length() > 2.0) {
        let p = lane.centerline.at(lane.centerline.length() / 2.0).position;
        over.push((p, f64::NEG_INFINITY, false));
    }
    for ([a, b, c], tag) in still(town) {
        let ground = matches!(tag, ClassTag::Terrain | ClassTag::Ground | ClassTag::Buildings | ClassTag::Water);
        if !ground && !matches!(tag, ClassTag::Roads | ClassTag::RoadLines | ClassTag::Sidewalks) {
            continue;
        }
        let area = (b - a).truncate().perp_dot((c - a).truncate());
        if area < 1e-6 {
            continue;
        }
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        for (p, top, covered) in &mut over {
            let q = p.as_vec3();
            if q.x < low.x || q.x > high.x || q.y < low.y || q.y > high.y {
                continue;
            }
            let q = q.truncate();
            let u = (b.truncate() - q).perp_dot(c.truncate() - q) / area;
            let v = (c.truncate() - q).perp_dot(a.truncate() - q) / area;
            if u >= 0.0 && v >= 0.0 && u + v <= 1.0 {
                let z = f64::from(a.z * u + b.z * v + c.z * (1.0 - u - v));
                // What passes over on a bridge does not count.
                if z < p.z + 2.5 {
                    if ground {
                        *top = top.max(z);
                    } else {
                        *covered |= (z - p.z).abs() < 0.25;
                    }
                }
            }
        }
    }
    let buried = over.iter().filter(|(p, top, _)| *top > p.z + 0.02).count();
    let bare = over.iter().filter(|(_, _, covered)| !covered).count();
    assert!(buried == 0, "{name}: {buried} of {} lanes under the ground", over.len());
    assert!(bare * 50 <= over.len(), "{name}: {bare} of {} lanes without pavement", over.len());
    let level = |what: PlacedObject| matches!(what, PlacedObject::Prop(Prop::Manhole | Prop::Drain, _));
    for placement in town.placements.iter().filter(|p| matches!(p.object, PlacedObject::Prop(..)) && !level(p.object)) {
        let at = placement.world_from_object.translation;
        let on = town.network.lanes.iter().find(|l| {
            let (s, t) = l.centerline.project(at.truncate().as_dvec2());
            let place = l.centerline.at(s).position;
            let beside = place.truncate().distance(at.truncate().as_dvec2());
            (t.abs() < 0.9 && beside < 0.9) && (place.z - f64::from(at.z)).abs() < 2.0
        });
        assert!(on.is_none(), "{name}: {:?} at {at} stands on a lane", placement.object);
    }
}

#[test]
fn a_street_on_a_slope_is_dressed() {
    let town = dress_map("slope", &street(), &Catalogue::builtin()).unwrap();
    check(&town);
    let buildings = town.meshes.iter().filter(|m| m.materials.iter().any(|m| m.tag == ClassTag::Buildings)).count();
    assert!(buildings > 6, "the map knows two, the rest of the street is built up: {buildings}");
    for (corners, _) in still(&town).filter(|(_, tag)| *tag == ClassTag::Buildings) {
        let clear = corners.iter().all(|c| c.y.abs() > 3.5 || !(0.0..240.0).contains(&c.x));
        assert!(clear, "a building on the road at {corners:?}");
    }
    let again = dress_map("slope", &street(), &Catalogue::builtin()).unwrap();
    assert_eq!(town.meshes, again.meshes);
    assert_eq!(town.placements, again.placements);
    assert_eq!(town.cameras, again.cameras);
    let origin = town.georeference.expect("the map says where it lies").wgs84(DVec3::Z);
    assert_eq!([origin.latitude_deg, origin.longitude_deg, origin.altitude_m], [48.0, 11.5, 1.0]);
}

#[test]
fn real_files_are_dressed() {
    let catalogue = Catalogue::builtin();
    for (name, map) in files() {
        let start = std::time::Instant::now();
        let town = dress_map(&name, &map, &catalogue).unwrap();
        let triangles: usize = town.meshes.iter().map(|m| m.triangles.len()).sum();
        println!("{name}: {} cameras, {triangles} triangles, {:?}", town.cameras.len(), start.elapsed());
        check(&town);
    }
}

#[test]
fn a_map_without_lanes_is_refused() {
    let error = dress_map("nothing", &RoadMap::default(), &Catalogue::builtin()).unwrap_err();
    assert_eq!(error, TownError::NoLanes { name: "nothing".into() });
    assert!(!error.to_string().contains('\n'));
}
