//! Vehicles stand on the road where it climbs.

use endless_road::{Lane, LaneId, Polyline, RoadNetwork};
use endless_traffic::TrafficSettings;
use endless_world::Pose;
use endless_world::math::f64::{atan, sin_cos};
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

const STRAIGHT_M: f64 = 120.0;
const RADIUS_M: f64 = 40.0;
/// Rise of the ground to the east and to the north.
const RISE: DVec2 = DVec2::new(0.08, 0.03);

/// A loop of two straights and two bends on tilted ground, one lane a half. As every road, it climbs along and is level
/// across.
fn loop_road() -> RoadNetwork {
    let half = |turn: f64| -> Vec<DVec3> {
        let straight = (0..60).map(|i| DVec2::new(-0.5 * STRAIGHT_M + 2.0 * f64::from(i), -RADIUS_M));
        let bend = (0..=60).map(|i| {
            let (sin, cos) = sin_cos(PI * (f64::from(i) / 60.0 - 0.5));
            DVec2::new(0.5 * STRAIGHT_M + RADIUS_M * cos, RADIUS_M * sin)
        });
        straight.chain(bend).map(|p| p * turn).map(|p| p.extend(p.dot(RISE))).collect()
    };
    let lane = |id: u32, points: Vec<DVec3>| Lane {
        successors: vec![LaneId(1 - id)],
        ..Lane::new(LaneId(id), Polyline::new(points), 3.4, 11.0)
    };
    let lanes = vec![lane(0, half(1.0)), lane(1, half(-1.0))];
    RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a sound network")
}

#[test]
fn vehicles_stand_on_a_sloped_road_and_pitch_with_it() {
    let specs = crate::watch::specs();
    let network = loop_road();
    let settings = TrafficSettings { vehicles: 12, pedestrians: 0, seed: 4, fps: 30.0, ..TrafficSettings::default() };
    let mut s = crate::watch::simulation(&network, &specs, &settings);
    assert_eq!(s.population().vehicles_spawned, 12);
    let height = |p: DVec2| {
        let on = network.lanes.iter().map(|lane| (&lane.centerline, lane.centerline.project(p)));
        let (line, (s, _)) = on.min_by(|a, b| a.1.1.abs().total_cmp(&b.1.1.abs())).expect("two lanes");
        line.position(s).z
    };
    let (mut climbed, mut fell) = (0, 0);
    for _ in 0..900 {
        s.tick();
        for actor in s.state().actors {
            let Pose { position, yaw_rad, pitch_rad, .. } = actor.pose;
            let at = position.as_dvec3();
            let above = at.z - height(at.truncate());
            assert!(above.abs() < 0.03, "{:?} is {above:.3} m above the road", actor.class);
            let (sin, cos) = sin_cos(f64::from(yaw_rad));
            let rise = atan(RISE.dot(DVec2::new(cos, sin)));
            assert!((f64::from(pitch_rad) - rise).abs() < 0.02, "pitch {pitch_rad} on a rise of {rise}");
            climbed += u32::from(pitch_rad > 0.05);
            fell += u32::from(pitch_rad < -0.05);
            // The velocity lies in the road too.
            let v = actor.velocity_mps.as_dvec3();
            assert!((v.z - v.truncate().dot(RISE)).abs() < 0.25, "{v}");
        }
    }
    assert!(climbed > 500 && fell > 500);
}
