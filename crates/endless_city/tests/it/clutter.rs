//! Clutter stands beside the roads, on the ground, and nowhere else.

use crate::exactness::CATALOGUE;
use endless_city::{TownScene, clutter};
use endless_road::Lane;
use glam::{DVec2, DVec3, Vec3};

/// Distance of a place from a line between two points.
fn distance(place: DVec2, a: DVec2, b: DVec2) -> f64 {
    let along = b - a;
    let share = ((place - a).dot(along) / along.length_squared().max(1e-9)).clamp(0.0, 1.0);
    place.distance(a + along * share)
}

/// The least and the greatest coordinates of a lane's centre line.
fn bounds(lane: &Lane) -> [DVec2; 2] {
    let points = || lane.centerline.points().iter().map(|p| p.truncate());
    [points().fold(DVec2::INFINITY, DVec2::min), points().fold(DVec2::NEG_INFINITY, DVec2::max)]
}

#[test]
fn clutter_stands_on_no_lane_no_crossing_and_nobodys_way() {
    let mut total = 0;
    for name in ["Town02", "Town03", "Ladera", "Altstadt"] {
        let town = endless_town::load(name, &CATALOGUE).expect("a built-in town");
        let scene = TownScene::load(&town, &CATALOGUE).expect("few parked vehicles");
        let lanes: Vec<_> = town.network.lanes.iter().map(|lane| (lane, bounds(lane))).collect();
        for seed in 0..2 {
            let of = |strength| clutter(&town, &scene, &CATALOGUE, &town.cameras, strength, seed);
            let (some, many) = (of(0.3), of(1.0));
            assert!(some.len() * 2 < many.len(), "{name}: {} and {}", some.len(), many.len());
            total += many.len();
            for piece in some.iter().chain(&many) {
                let (foot, radius) = (piece.foot(), f64::from(piece.radius_m));
                let place = foot.truncate().as_dvec2();
                for (lane, [low, high]) in &lanes {
                    let reach = 0.5 * lane.width_m + radius;
                    if place.clamp(*low, *high).distance(place) > reach {
                        continue;
                    }
                    let to =
                        lane.centerline.points().windows(2).map(|p| distance(place, p[0].truncate(), p[1].truncate()));
                    let nearest = to.fold(f64::INFINITY, f64::min);
                    assert!(nearest >= reach, "{name} {seed}: {foot} on lane {:?}", lane.id);
                }
                for crossing in &town.network.crossings {
                    let [a, b] = crossing.ends.map(DVec3::truncate);
                    assert!(distance(place, a, b) >= 0.5 * crossing.width_m + radius, "{name}: {foot} on a crossing");
                }
                let walk = &town.network.walk;
                for edge in &walk.edges {
                    let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()].truncate());
                    // The way of the middles of walkers, and their breadth.
                    let walked = 0.85 * (0.5 * edge.width_m - 0.25) + 0.25;
                    assert!(distance(place, a, b) >= walked + radius, "{name}: {foot} where people walk");
                }
                let ground = scene.static_scene().first_surface(foot + Vec3::Z * 0.5, -Vec3::Z, 2.0).expect("ground");
                assert!((-0.001..0.08).contains(&(ground.position.z - foot.z)), "{name}: {foot} floats or sinks");
            }
        }
    }
    println!("{total} pieces");
    assert!(total > 400, "{total} pieces");
}
