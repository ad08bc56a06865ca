//! Steering, sliding, slopes, gears, and what clients do to a vehicle besides driving it.

use super::*;
use endless_world::math::f64::{atan2, sin_cos, wrap_angle};

/// Between where it goes and where its nose points, degrees.
fn slip_deg(body: &VehicleBody) -> f64 {
    let v = body.velocity();
    if v.truncate().length() < 0.1 {
        0.0
    } else {
        wrap_angle(atan2(v.y, v.x) - body.place().yaw_rad).abs().to_degrees()
    }
}

/// The largest slip while it steers for some seconds.
fn largest_slip_deg(mut body: VehicleBody, control: &VehicleControl, seconds: f64) -> f64 {
    let frames = (seconds / FRAME_S) as usize;
    (0..frames).fold(0.0, |largest: f64, _| {
        body.step(control, FRAME_S, &flat);
        largest.max(slip_deg(&body))
    })
}

#[test]
fn a_car_follows_its_wheels_in_town_and_slides_on_the_motorway() {
    let town = largest_slip_deg(at_kmh(model3(), 30.0), &control(0.2, 0.0, 0.3), 4.0);
    let motorway = largest_slip_deg(at_kmh(model3(), 120.0), &control(0.2, 0.0, 1.0), 4.0);
    let gentle = largest_slip_deg(at_kmh(model3(), 120.0), &control(0.2, 0.0, 0.02), 4.0);
    println!("slip: 30 km/h {town:.1}, 120 km/h {motorway:.1}, gentle {gentle:.1} degrees");
    assert!(town < 7.0 && motorway > 8.0 && gentle < 2.0, "{town} {motorway} {gentle}");

    // Within their grip tyres turn it as the geometry has it; beyond, it goes wide.
    let turn = |kmh: f64, steer: f32| {
        let mut body = at_kmh(model3(), kmh);
        (0..30).for_each(|_| body.step(&control(0.2, 0.0, steer), FRAME_S, &flat));
        let (v, [inner, outer, ..]) = (body.speed_mps(), body.wheel_angles_rad());
        let wanted = v * endless_world::math::f64::tan(0.5 * (inner + outer)) / 2.88;
        body.angular_velocity().z / wanted
    };
    assert!((0.9..1.1).contains(&turn(20.0, 0.3)), "{}", turn(20.0, 0.3));
    assert!(turn(120.0, 1.0) < 0.3, "{}", turn(120.0, 1.0));
}

#[test]
fn a_hand_brake_brings_the_tail_out() {
    let pulled = VehicleControl { hand_brake: true, steer: 0.3, ..VehicleControl::default() };
    let slip = largest_slip_deg(at_kmh(model3(), 60.0), &pulled, 3.0);
    assert!(slip > 25.0, "{slip}");
}

#[test]
fn brakes_in_a_bend_do_not_turn_it_round() {
    let four_wheeled = everyone().into_iter().filter(|(_, shape)| !shape.two_wheeled());
    for (name, shape) in four_wheeled {
        for kmh in [40.0, 75.0, 90.0, 130.0] {
            for (brake, steer) in [(0.3, 0.05), (0.7, 0.1), (0.7, -0.3), (1.0, 0.2), (0.5, 0.6), (1.0, 1.0)] {
                let mut body = at_kmh(VehicleBody::new(shape, Place::default()), kmh);
                // Slowly the middle of a vehicle goes elsewhere than its nose.
                while body.velocity().length() > 5.0 {
                    body.step(&control(0.0, brake, steer), FRAME_S, &flat);
                    let slip = slip_deg(&body);
                    assert!(slip < 12.0, "{name}, {kmh} km/h, brake {brake}, steer {steer}: {slip}");
                }
            }
        }
    }
}

#[test]
fn standing_is_standing() {
    for (name, shape) in everyone() {
        for control in [control(0.0, 0.0, 0.0), control(0.0, 1.0, 0.7), control(0.0, 0.0, -1.0)] {
            // 8 % across and along.
            let hill = |x: f64, y: f64, _: f64| Some(0.08 * x - 0.08 * y);
            let mut body = VehicleBody::new(shape, at(3.0, 4.0, 0.7));
            (0..20).for_each(|_| body.step(&control, FRAME_S, &hill));
            let before = body.place().position;
            (0..400).for_each(|_| body.step(&control, FRAME_S, &hill));
            let moved = (body.place().position - before).length();
            assert!(moved < 1e-3 && body.velocity().length() < 1e-3, "{name}: {moved} {:?}", body.velocity());
        }
    }
}

#[test]
fn hills_make_it_fast_and_slow() {
    // Falls by a tenth to the east.
    let hill = |x: f64, _: f64, _: f64| Some(-0.1 * x);
    let neutral = VehicleControl { manual_gear_shift: true, gear: 0, ..VehicleControl::default() };
    let mut body = VehicleBody::new(VehicleShape::MODEL3, Place::default());
    (0..200).for_each(|_| body.step(&neutral, FRAME_S, &hill));
    // Ten seconds of a tenth of gravity, less rolling and air.
    assert!((7.0..9.7).contains(&body.speed_mps()), "{}", body.speed_mps());
    let place = body.place();
    assert!((place.position.z + 0.1 * place.position.x).abs() < 1e-3);
    assert!((place.pitch_rad + 0.0997).abs() < 0.01, "{}", place.pitch_rad);

    // Up it it needs its engine.
    let mut up = VehicleBody::new(VehicleShape::MODEL3, Place::level(DVec3::ZERO, std::f64::consts::PI));
    (0..100).for_each(|_| up.step(&control(0.4, 0.0, 0.0), FRAME_S, &hill));
    assert!(up.place().position.z > 1.0 && up.place().pitch_rad > 0.08);
}

#[test]
fn it_drives_backwards_and_stops_before_it_does() {
    let back = VehicleControl { throttle: 0.5, reverse: true, ..VehicleControl::default() };
    let mut body = model3();
    (0..40).for_each(|_| body.step(&back, FRAME_S, &flat));
    assert!(body.speed_mps() < -1.0 && body.gear() == -1);
    assert!(body.rolled_m() < -1.0 && (body.rolled_m() - body.place().position.x).abs() < 0.1);
}

#[test]
fn gears_are_shifted_by_speed_or_by_hand() {
    let mut body = VehicleBody::new(hatchback(), Place::default());
    let mut gears = vec![body.gear()];
    for _ in 0..500 {
        body.step(&control(0.8, 0.0, 0.0), FRAME_S, &flat);
        assert!(body.engine_rpm() < 6300.0);
        if gears.last() != Some(&body.gear()) {
            gears.push(body.gear());
        }
    }
    assert!(gears.len() >= 5 && gears.is_sorted(), "{gears:?}");
    // Down again, one after the other.
    (0..200).for_each(|_| body.step(&control(0.0, 0.4, 0.0), FRAME_S, &flat));
    assert_eq!(body.gear(), 1);

    let second = VehicleControl { throttle: 1.0, manual_gear_shift: true, gear: 2, ..VehicleControl::default() };
    (0..600).for_each(|_| body.step(&second, FRAME_S, &flat));
    assert_eq!(body.gear(), 2);
    // It goes no faster than its engine.
    assert!((18.0..26.5).contains(&body.speed_mps()), "{}", body.speed_mps());
}

#[test]
fn it_is_let_down_when_near_the_ground_and_falls_when_far() {
    let mut near = VehicleBody::new(VehicleShape::MODEL3, Place::level(DVec3::Z * 0.5, 0.0));
    near.step(&VehicleControl::default(), FRAME_S, &flat);
    assert_eq!((near.place().position, near.grounded()), (DVec3::ZERO, true));

    let mut far = VehicleBody::new(VehicleShape::MODEL3, Place::level(DVec3::Z * 5.0, 0.0));
    far.step(&VehicleControl::default(), FRAME_S, &flat);
    assert!(!far.grounded() && far.place().position.z > 4.9);
    (0..18).for_each(|_| far.step(&VehicleControl::default(), FRAME_S, &flat));
    assert!(far.place().position.z > 0.1, "not yet down: {:?}", far.place().position);
    (0..20).for_each(|_| far.step(&VehicleControl::default(), FRAME_S, &flat));
    assert!(far.grounded() && far.place().position.z.abs() < 1e-3);

    // Over an edge of two metres at 50 km/h it flies some seven metres.
    let edge = |x: f64, _: f64, _: f64| Some(if x < 20.0 { 2.0 } else { 0.0 });
    let start = Place::level(DVec3::new(10.0, 0.0, 2.0), 0.0);
    let mut body = VehicleBody::new(VehicleShape::MODEL3, start);
    body.step(&VehicleControl::default(), FRAME_S, &edge);
    body.set_target_velocity(DVec3::X * 14.0);
    let flew = (0..60).filter(|_| {
        body.step(&VehicleControl::default(), FRAME_S, &edge);
        !body.grounded()
    });
    let frames = flew.count();
    assert!((6..20).contains(&frames) && body.grounded(), "{frames}");
}

#[test]
fn without_friction_or_gravity_nothing_slows_it() {
    for glides in [false, true] {
        let mut body = at_kmh(model3(), 100.0);
        let mut physics = body.physics_control();
        physics.drag_coefficient = 0.0;
        if !glides {
            physics.wheels.iter_mut().for_each(|wheel| wheel.tire_friction = 0.0);
        }
        body.set_physics_control(&physics);
        body.set_gravity(!glides);
        (0..100).for_each(|_| body.step(&control(0.0, 1.0, 0.5), FRAME_S, &flat));
        assert!((3.6 * body.speed_mps() - 100.0).abs() < 1e-6, "{}", body.speed_mps());
    }
}

#[test]
fn tyres_that_grip_more_stop_sooner() {
    let way = |friction: f32| {
        let mut body = at_kmh(model3(), 100.0);
        let mut physics = body.physics_control();
        physics.wheels.iter_mut().for_each(|wheel| wheel.tire_friction = friction);
        body.set_physics_control(&physics);
        (0..150).for_each(|_| body.step(&control(0.0, 1.0, 0.0), FRAME_S, &flat));
        body.place().position.x
    };
    let ways = [0.0, 0.5, 3.0].map(way);
    assert!(ways[1] < 0.75 * ways[0] && ways[2] < 0.75 * ways[1], "{ways:?}");
}

#[test]
fn clients_push_and_turn_it() {
    let mut body = at_kmh(model3(), 0.0);
    body.add_impulse(DVec3::X * 18450.0);
    assert!((body.speed_mps() - 10.0).abs() < 1e-6);

    let mut body = at_kmh(model3(), 0.0);
    body.set_gravity(false);
    body.add_force(DVec3::Y * 1845.0);
    body.step(&VehicleControl::default(), 1.0, &flat);
    assert!((body.velocity().y - 1.0).abs() < 0.01);
    // A force lasts for a step.
    body.step(&VehicleControl::default(), 1.0, &flat);
    assert!((body.velocity().y - 1.0).abs() < 0.01);
    body.add_impulse_at(DVec3::Y * 1000.0, body.place().position + DVec3::X);
    assert!(body.angular_velocity().z > 0.1);

    let mut body = at_kmh(model3(), 0.0);
    body.set_constant_velocity(Some(DVec3::X * 8.0));
    (0..100).for_each(|_| body.step(&control(0.0, 1.0, 0.1), FRAME_S, &flat));
    assert!((body.speed_mps() - 8.0).abs() < 0.5 && body.place().yaw_rad.abs() > 0.05);
    body.set_constant_velocity(None);
    (0..100).for_each(|_| body.step(&control(0.0, 1.0, 0.0), FRAME_S, &flat));
    assert_eq!(body.speed_mps(), 0.0);
}

#[test]
fn what_is_not_simulated_stays_where_it_is_put() {
    let mut body = at_kmh(model3(), 50.0);
    body.set_simulated(false);
    let place = Place { position: DVec3::new(1.0, 2.0, 7.0), yaw_rad: 1.0, pitch_rad: 0.2, roll_rad: -0.1 };
    body.put(place);
    (0..20).for_each(|_| body.step(&control(1.0, 0.0, 0.3), FRAME_S, &flat));
    assert_eq!((body.place(), body.velocity()), (place, DVec3::ZERO));
    // Its wheels roll along.
    let rolled = body.rolled_m();
    let (sin, cos) = sin_cos(1.0);
    body.put(Place { position: place.position + DVec3::new(cos, sin, 0.0), ..place });
    assert!((body.rolled_m() - rolled - 1.0).abs() < 1e-9);
}

#[test]
fn bodies_nod_and_lean() {
    let mut body = at_kmh(model3(), 80.0);
    (0..10).for_each(|_| body.step(&control(0.0, 1.0, 0.0), FRAME_S, &flat));
    assert!((-4.0..-1.0).contains(&body.place().pitch_rad.to_degrees()), "nose down: {}", body.place().pitch_rad);
    let turned = |mut body: VehicleBody| {
        (0..40).for_each(|_| body.step(&control(0.2, 0.0, -0.15), FRAME_S, &flat));
        body.place().roll_rad.to_degrees()
    };
    // To the left: a car leans to the right, a rider to the left.
    assert!((0.5..4.0).contains(&turned(at_kmh(model3(), 40.0))));
    let rider = turned(at_kmh(VehicleBody::new(motorcycle(), Place::default()), 30.0));
    assert!((-50.0..-10.0).contains(&rider), "{rider}");
}

#[test]
fn telemetry_tells_what_it_does() {
    let mut body = at_kmh(model3(), 50.0);
    (0..20).for_each(|_| body.step(&control(0.6, 0.0, 0.1), FRAME_S, &flat));
    let told = body.telemetry();
    assert!((f64::from(told.speed) - body.speed_mps()).abs() < 1e-4);
    assert_eq!((told.wheels.len(), told.gear, told.throttle), (4, 1, 0.6));
    let load: f32 = told.wheels.iter().map(|wheel| wheel.tire_load).sum();
    assert!((load - 1845.0 * 9.81).abs() < 10.0);
    // To the right, as CARLA's axes have it.
    assert!(told.wheels.iter().all(|wheel| wheel.lat_force > 100.0 && wheel.long_force > 0.0 && wheel.omega > 30.0));
}
