//! Riders who pass queues at red lights.

use crate::grid::Grid;
use crate::watch;
use endless_traffic::{TrafficAudit, TrafficSettings};
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, Motion, Region, TrafficProfile};
use glam::Vec2;
use std::collections::BTreeMap;

const FPS: f64 = 30.0;
const SECONDS: f64 = 600.0;

/// How much faster riders were than each vehicle that they passed at a crawl, m/s, and how much room was between, metres; the audit
/// must be content.
fn passings(region: Region) -> Vec<[f32; 2]> {
    let (specs, network) = (watch::specs(), Grid { columns: 3, rows: 3, lanes: 2 }.network());
    let profile = TrafficProfile { region, two_wheelers: Some(0.4), ..TrafficProfile::default() };
    let settings =
        TrafficSettings { vehicles: 60, pedestrians: 30, seed: 5, fps: FPS, profile, ..TrafficSettings::default() };
    let mut simulation = watch::simulation(&network, &specs, &settings);
    let mut audit = TrafficAudit::new(&network, &specs, &[], FPS);
    let mut before: BTreeMap<(u16, u16), f32> = BTreeMap::new();
    let mut found = Vec::new();
    for _ in 0..(SECONDS * FPS) as usize {
        simulation.tick();
        let state = simulation.state();
        audit.look(&state);
        let driven = state.actors.iter().filter_map(|actor| match actor.motion {
            Motion::Vehicle(motion) => Some((actor, motion.speed_mps)),
            Motion::Walker(_) => None,
        });
        let driven: Vec<(&Actor, f32)> = driven.collect();
        let mut now = BTreeMap::new();
        for (rider, speed) in driven.iter().filter(|(actor, _)| actor.class.two_wheeled()) {
            for (other, theirs) in driven.iter().filter(|(actor, _)| !actor.class.two_wheeled()) {
                if other.pose.position.distance(rider.pose.position) > 8.0 {
                    continue;
                }
                let (sin, cos) = sin_cos(f64::from(other.pose.yaw_rad));
                let (ahead, away) = (Vec2::new(cos as f32, sin as f32), rider.pose.position - other.pose.position);
                let seen = Vec2::new(away.truncate().dot(ahead), ahead.perp_dot(away.truncate()));
                let along = rider.velocity_mps.truncate().dot(ahead);
                let width = |actor: &Actor| actor.asset.vehicle().map_or(0.0, |v| specs[v.model.index()].width_m);
                let pair = (rider.id.0, other.id.0);
                let passes = before.get(&pair).is_some_and(|x| *x < 0.0) && seen.x >= 0.0;
                if passes && seen.y.abs() < 2.2 && *theirs < 2.0 && along > theirs + 0.5 {
                    found.push([speed - theirs, seen.y.abs() - 0.5 * (width(rider) + width(other))]);
                }
                now.insert(pair, seen.x);
            }
        }
        before = now;
    }
    let report = audit.report();
    assert!(report.passed(), "{region}: {report}");
    found
}

#[test]
fn riders_pass_queues_slowly_and_with_room_and_more_so_where_motorcycles_are_many() {
    let many = passings(Region::LatinAmerican);
    assert!(many.len() > 5, "{}", many.len());
    for [faster_mps, room_m] in &many {
        assert!(*faster_mps < 5.0 && *room_m > 0.15, "{faster_mps} m/s faster, {room_m} m between");
    }
    let few = passings(Region::NorthAmerican);
    assert!(few.len() < many.len(), "{} and {}", few.len(), many.len());
}
