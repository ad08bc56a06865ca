//! No control and no client makes a body leave the numbers, gain energy from nothing, or move otherwise the second time.

use super::*;
use crate::physics::{Body, Mover, Obstacle, WalkerBody, step_bodies};
use crate::wire::{GearPhysicsControl, Vector2D, Vector3D, VehiclePhysicsControl, WalkerControl, WheelPhysicsControl};
use glam::DVec2;
use proptest::collection::vec;
use proptest::prelude::*;

/// Any float, the strange ones more often than by chance.
fn float() -> impl Strategy<Value = f32> {
    prop_oneof![
        Just(f32::NAN),
        Just(f32::INFINITY),
        Just(f32::NEG_INFINITY),
        Just(f32::MAX),
        Just(0.0),
        -2.0..2.0f32,
        any::<f32>()
    ]
}

fn wild_control() -> impl Strategy<Value = VehicleControl> {
    (float(), float(), float(), any::<[bool; 3]>(), prop_oneof![-2..9i32, any::<i32>()]).prop_map(
        |(throttle, steer, brake, [hand_brake, reverse, manual_gear_shift], gear)| VehicleControl {
            throttle,
            steer,
            brake,
            hand_brake,
            reverse,
            manual_gear_shift,
            gear,
        },
    )
}

fn wild_vector() -> impl Strategy<Value = DVec3> {
    (float(), float(), float()).prop_map(|(x, y, z)| DVec3::new(x.into(), y.into(), z.into()))
}

fn wild_physics() -> impl Strategy<Value = VehiclePhysicsControl> {
    (vec(float(), 12), 0..6usize, 0..4usize, any::<bool>()).prop_map(|(n, wheels, gears, itself)| {
        let curve = vec![Vector2D { x: n[0], y: n[1] }, Vector2D { x: n[2], y: n[3] }];
        let wheel = WheelPhysicsControl {
            tire_friction: n[4],
            radius: n[5],
            max_brake_torque: n[6],
            max_steer_angle: n[7],
            lat_stiff_value: n[8],
            lat_stiff_max_load: n[0],
            ..WheelPhysicsControl::default()
        };
        VehiclePhysicsControl {
            torque_curve: curve.clone(),
            steering_curve: curve,
            max_rpm: n[9],
            mass: n[10],
            final_ratio: n[11],
            drag_coefficient: n[1],
            gear_switch_time: n[2],
            damping_rate_full_throttle: n[3],
            center_of_mass: Vector3D { x: n[4], y: n[5], z: n[6] },
            use_gear_autobox: itself,
            forward_gears: vec![GearPhysicsControl { ratio: n[7], down_ratio: n[8], up_ratio: n[9] }; gears],
            wheels: vec![wheel; wheels],
            ..VehiclePhysicsControl::default()
        }
    })
}

/// Hilly, with holes and strange places.
fn wild_ground(x: f64, y: f64, _: f64) -> Option<f64> {
    match (x as i64 ^ y as i64) & 15 {
        0 => None,
        1 => Some(f64::NAN),
        2 => Some(1e300),
        _ => Some(3.0 * endless_world::math::f64::sin(0.2 * x)),
    }
}

fn sound(body: &VehicleBody) -> bool {
    let place = body.place();
    let told = body.telemetry();
    let vectors = [place.position, body.velocity(), body.acceleration(), body.angular_velocity()];
    vectors.iter().all(|v| v.is_finite())
        && [place.yaw_rad, place.pitch_rad, place.roll_rad, body.rolled_m(), body.engine_rpm()]
            .iter()
            .all(|x| x.is_finite())
        && body.velocity().length() < 400.0
        && told.wheels.iter().all(|wheel| wheel.long_force.is_finite() && wheel.lat_slip.is_finite())
        && body.wheel_angles_rad().iter().all(|angle| angle.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn no_control_makes_it_leave_the_numbers(
        frames in vec((wild_control(), prop_oneof![Just(0.05f32), 0.0..0.2f32, float()]), 1..12),
        which in 0..6usize,
    ) {
        let mut body = VehicleBody::new(everyone()[which].1, Place::level(DVec3::Z, 0.3));
        for (control, dt_s) in frames {
            body.step(&control, dt_s.into(), &wild_ground);
            prop_assert!(sound(&body), "{body:?}");
        }
    }

    #[test]
    fn no_client_makes_it_leave_the_numbers(
        vectors in vec(wild_vector(), 9), physics in wild_physics(), control in wild_control(), floats in vec(float(), 3),
    ) {
        let mut body = model3();
        body.set_physics_control(&physics);
        for flags in 0..4 {
            body.set_gravity(flags & 1 == 0);
            body.put(Place { position: vectors[0], yaw_rad: floats[0].into(), pitch_rad: floats[1].into(), roll_rad: floats[2].into() });
            body.set_target_velocity(vectors[1]);
            body.set_target_angular_velocity(vectors[2]);
            body.add_impulse_at(vectors[3], vectors[4]);
            body.add_angular_impulse(vectors[5]);
            body.add_force_at(vectors[6], vectors[0]);
            body.add_torque(vectors[7]);
            body.set_constant_velocity((flags & 2 == 0).then_some(vectors[8]));
            body.set_friction_here((flags == 3).then_some(floats[0].into()));
            for ground in [flat, wild_ground] {
                body.step(&control, FRAME_S, &ground);
                prop_assert!(sound(&body), "{body:?}");
            }
        }
        let told = body.physics_control();
        prop_assert!(told.mass.is_finite() && told.wheels.iter().all(|wheel| wheel.radius.is_finite()));
    }

    #[test]
    fn no_client_makes_a_walker_leave_the_numbers(vectors in vec(wild_vector(), 4), floats in vec(float(), 4), jump: bool) {
        let mut walker = WalkerBody::new(floats[0].into(), floats[1].into(), Place::default());
        let direction = Vector3D { x: vectors[0].x as f32, y: vectors[0].y as f32, z: floats[2] };
        let control = WalkerControl { direction, speed: floats[3], jump };
        for _ in 0..3 {
            walker.step(&control, floats[2].into(), &wild_ground);
            walker.add_impulse(vectors[1]);
            walker.step(&control, FRAME_S, &wild_ground);
            walker.put_walking(Place::level(vectors[2], floats[0].into()), floats[1].into());
            walker.step(&control, FRAME_S, &flat);
            walker.set_target_velocity(vectors[3]);
            let vectors = [walker.place().position, walker.velocity(), walker.acceleration(), walker.angular_velocity()];
            prop_assert!(vectors.iter().all(|v| v.is_finite()) && walker.walked_m().is_finite(), "{walker:?}");
        }
    }

    #[test]
    fn energy_does_not_come_from_nothing(
        speed in -40.0..40.0f64, aside in -15.0..15.0f64, turn in -4.0..4.0f64, which in 0..6usize,
        frames in vec((0.0..1.0f32, -1.0..1.0f32, any::<[bool; 2]>()), 1..30),
    ) {
        let mut body = at_kmh(VehicleBody::new(everyone()[which].1, Place::default()), 0.0);
        body.set_target_velocity(DVec3::new(speed, aside, 0.0));
        body.set_target_angular_velocity(DVec3::Z * turn);
        let energy = |body: &VehicleBody| {
            body.p.mass_kg * body.velocity().length_squared() + body.p.yaw_inertia * body.angular_velocity().z.powi(2)
        };
        for (brake, steer, [hand_brake, reverse]) in frames {
            let before = energy(&body);
            let control = VehicleControl { brake, steer, hand_brake, reverse, ..VehicleControl::default() };
            body.step(&control, FRAME_S, &flat);
            prop_assert!(energy(&body) <= before * (1.0 + 1e-12), "{} {before}", energy(&body));
        }
    }

    #[test]
    fn what_it_is_made_of_comes_back_as_it_went(numbers in vec(-1e5..1e5f32, 12), gears in 1..9usize, itself: bool) {
        let mut body = VehicleBody::new(hatchback(), at(3.0, 4.0, 1.0));
        let mut physics = body.physics_control();
        physics.torque_curve = vec![Vector2D { x: numbers[0], y: numbers[1] }];
        physics.steering_curve.push(Vector2D { x: numbers[2], y: numbers[3] });
        (physics.mass, physics.drag_coefficient, physics.max_rpm, physics.moi) = (numbers[4], numbers[5], numbers[6], numbers[7]);
        (physics.use_gear_autobox, physics.use_sweep_wheel_collision) = (itself, !itself);
        physics.forward_gears = vec![GearPhysicsControl { ratio: numbers[8], ..Default::default() }; gears];
        physics.wheels.iter_mut().for_each(|wheel| (wheel.tire_friction, wheel.long_stiff_value) = (numbers[9], numbers[10]));
        physics.center_of_mass.z = numbers[11];
        body.set_physics_control(&physics);
        prop_assert_eq!(body.physics_control(), physics);
    }
}

#[test]
fn friction_of_a_place_is_told_while_it_lasts() {
    let mut body = model3();
    body.set_friction_here(Some(0.0));
    assert_eq!(body.physics_control().wheels[0].tire_friction, 0.0);
    body.set_friction_here(None);
    assert_eq!(body.physics_control().wheels[0].tire_friction, 3.5);
}

/// Everything of a crowd of vehicles and walkers that drive into each other for some seconds.
fn melee(count: usize, frames: usize) -> Vec<[u64; 4]> {
    let mut vehicles: Vec<_> = (0..count)
        .map(|index| {
            let (x, y) = ((index % 10) as f64 * 7.0, (index / 10) as f64 * 7.0);
            VehicleBody::new(everyone()[index % 6].1, at(x, y, index as f64))
        })
        .collect();
    let controls: Vec<_> = (0..count).map(|index| control(0.6, 0.0, ((index % 7) as f32 - 3.0) / 10.0)).collect();
    let mut walkers: Vec<_> =
        (0..count / 4).map(|index| WalkerBody::new(1.7, 0.25, at(index as f64 * 3.0, 3.5, 0.0))).collect();
    let walk = WalkerControl { speed: 1.5, ..WalkerControl::default() };
    let fence = |low: DVec2, high: DVec2, found: &mut Vec<Obstacle>| {
        if high.x > 80.0 || low.x < -10.0 {
            let x = if high.x > 80.0 { 80.5 } else { -10.5 };
            let (centre, half) = (DVec2::new(x, 30.0), DVec2::new(0.5, 200.0));
            let outline = crate::physics::OrientedBox { centre, half, along: DVec2::X, low_m: 0.0, high_m: 2.0 };
            found.push(Obstacle { id: 1, outline });
        }
    };
    for _ in 0..frames {
        let driven = vehicles.iter_mut().zip(&controls).map(|(vehicle, control)| Mover::Vehicle(vehicle, control));
        let walking = walkers.iter_mut().map(|walker| Mover::Walker(walker, &walk));
        let mut bodies: Vec<_> =
            driven.chain(walking).enumerate().map(|(id, mover)| Body { id: id as u32, mover }).collect();
        let contacts = step_bodies(&mut bodies, FRAME_S, &flat, &fence);
        assert!(contacts.iter().all(|contact| contact.impulse.is_finite() && contact.point.is_finite()));
    }
    assert!(vehicles.iter().all(sound));
    let bits = |place: Place| [place.position.x, place.position.y, place.yaw_rad, place.roll_rad].map(f64::to_bits);
    vehicles
        .iter()
        .map(|vehicle| bits(vehicle.place()))
        .chain(walkers.iter().map(|walker| bits(walker.place())))
        .collect()
}

#[test]
fn the_same_again_is_the_same_to_the_last_bit() {
    assert_eq!(melee(40, 60), melee(40, 60));
}
