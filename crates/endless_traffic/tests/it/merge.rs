//! Lanes that part and run together without a junction to order who goes first.

use endless_road::{Lane, LaneId, Polyline, RoadNetwork};
use endless_traffic::{AuditCheck, TrafficSettings};
use endless_world::math::f64::sin_cos;
use glam::DVec3;
use std::f64::consts::PI;

const FPS: f64 = 30.0;
const STRAIGHT_M: f64 = 220.0;
const RADIUS_M: f64 = 40.0;

fn lane(id: u32, points: Vec<DVec3>, successors: &[u32]) -> Lane {
    Lane {
        successors: successors.iter().map(|&s| LaneId(s)).collect(),
        ..Lane::new(LaneId(id), Polyline::new(points), 3.3, 13.9)
    }
}

/// From the end of the straight, round to one side, and back to its beginning.
fn around(side: f64) -> Vec<DVec3> {
    let bend = |from: DVec3, begin: f64| {
        (0..=80).map(move |k| {
            let (sin, cos) = sin_cos(begin + PI * f64::from(k) / 80.0);
            from + DVec3::new(RADIUS_M * cos, side * RADIUS_M * (1.0 + sin), 0.0)
        })
    };
    let there = bend(DVec3::new(STRAIGHT_M, 0.0, 0.0), -0.5 * PI);
    there.chain(bend(DVec3::ZERO, 0.5 * PI)).collect()
}

#[test]
fn those_who_come_together_let_one_another_in() {
    let straight = vec![DVec3::ZERO, DVec3::new(STRAIGHT_M, 0.0, 0.0)];
    let lanes = vec![lane(0, straight, &[1, 2]), lane(1, around(1.0), &[0]), lane(2, around(-1.0), &[0])];
    let network = RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a sound network");
    let specs = crate::watch::specs();
    for seed in 0..10 {
        let mut simulation = crate::watch::simulation(
            &network,
            &specs,
            &TrafficSettings { vehicles: 60, pedestrians: 0, seed, fps: FPS, ..TrafficSettings::default() },
        );
        let spawned = simulation.population().vehicles_spawned;
        let found = crate::watch::watch(&mut simulation, &network, &specs, 120.0, FPS);
        let driven = found.driven_m / f64::from(spawned) / 120.0;
        assert!(spawned > 40, "{spawned} vehicles");
        let stand_s = found.measured(AuditCheck::VehicleStands);
        assert!(found.passed(), "seed {seed}\n{found}");
        assert!(driven > 2.0 && stand_s < 40.0, "seed {seed}: {driven:.1} m/s, {stand_s:.0} s\n{found}");
    }
}
