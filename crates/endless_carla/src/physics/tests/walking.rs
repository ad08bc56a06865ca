//! Walkers.

use super::*;
use crate::physics::WalkerBody;
use crate::wire::{Vector3D, WalkerControl};
use endless_world::Gait;

fn walk(x: f32, y: f32, speed: f32) -> WalkerControl {
    WalkerControl { direction: Vector3D { x, y, z: 0.0 }, speed, jump: false }
}

#[test]
fn walks_where_it_is_told_and_turns_there() {
    let mut walker = WalkerBody::new(1.75, 0.25, Place::default());
    // CARLA's y is to the south.
    (0..100).for_each(|_| walker.step(&walk(0.0, 2.0, 1.5), FRAME_S, &flat));
    let place = walker.place();
    assert!(
        (place.position.y + 7.5).abs() < 0.3 && (place.yaw_rad + std::f64::consts::FRAC_PI_2).abs() < 1e-3,
        "{place:?}"
    );
    assert!((walker.walked_m() - 7.5).abs() < 0.3 && (walker.walking_mps() - 1.5).abs() < 1e-6);
    (0..20).for_each(|_| walker.step(&walk(1.0, 0.0, 0.0), FRAME_S, &flat));
    assert_eq!(walker.velocity(), DVec3::ZERO);
}

#[test]
fn follows_the_ground_jumps_and_falls_off_it() {
    let stairs = |x: f64, _: f64, _: f64| Some(if x < 10.0 { 0.17 * (x / 0.3).floor() } else { 0.0 });
    let mut walker = WalkerBody::new(1.75, 0.25, Place::level(DVec3::Z * 0.9, 0.0));
    walker.step(&walk(1.0, 0.0, 0.0), FRAME_S, &stairs);
    assert_eq!((walker.place().position.z, walker.grounded()), (0.0, true));
    (0..80).for_each(|_| walker.step(&walk(1.0, 0.0, 2.0), FRAME_S, &stairs));
    assert!(walker.grounded() && walker.place().position.z > 3.0);
    // At the end it falls, and does not fly.
    (0..30).for_each(|_| walker.step(&walk(1.0, 0.0, 2.0), FRAME_S, &stairs));
    let falling = (0..60).filter(|_| {
        walker.step(&walk(1.0, 0.0, 2.0), FRAME_S, &stairs);
        !walker.grounded()
    });
    assert!(falling.count() > 5 && walker.place().position.z == 0.0);

    walker.step(&WalkerControl { jump: true, ..walk(1.0, 0.0, 1.0) }, FRAME_S, &flat);
    let mut highest = 0.0_f64;
    for _ in 0..30 {
        walker.step(&walk(1.0, 0.0, 1.0), FRAME_S, &flat);
        highest = highest.max(walker.place().position.z);
    }
    assert!((0.6..1.2).contains(&highest) && walker.grounded(), "{highest}");
}

#[test]
fn is_carried_from_place_to_place_walking() {
    let mut walker = WalkerBody::new(1.75, 0.25, Place::default());
    for frame in 1..=100 {
        walker.put_walking(at(f64::from(frame) * 0.07, 1.0, 0.0), 1.4);
        walker.step(&WalkerControl::default(), FRAME_S, &flat);
    }
    assert!((walker.place().position - DVec3::new(7.0, 1.0, 0.0)).length() < 1e-9);
    assert!((walker.velocity() - DVec3::X * 1.4).length() < 1e-9);
    assert!((walker.walked_m() - 8.0).abs() < 0.1, "{}", walker.walked_m());
    // Who is let down from the sky has made no step.
    walker.put_walking(Place::level(DVec3::new(7.0, 1.5, 900.0), 0.0), 1.4);
    assert!((walker.walked_m() - 8.0).abs() < 0.1, "{}", walker.walked_m());
    walker.put_walking(at(7.0, 1.0, 0.0), 1.4);
    let motion = walker.motion(2.5);
    assert_eq!((motion.gait, motion.walked_m), (Gait::Walk, walker.walked_m() as f32));
    assert!((motion.walked_m - 8.0).abs() < 0.1, "{motion:?}");
    // Then it walks by itself.
    (0..20).for_each(|_| walker.step(&walk(1.0, 0.0, 1.0), FRAME_S, &flat));
    assert!(walker.place().position.x > 7.9);
}
