//! Acceleration, braking, turning and top speed, as on the road.

use super::*;

/// Seconds to a speed with the throttle all open; infinite if it is not reached in a minute.
fn accelerate_s(shape: VehicleShape, kmh: f64) -> f64 {
    let mut body = VehicleBody::new(shape, Place::default());
    let reached = (1..1200).find(|_| {
        body.step(&control(1.0, 0.0, 0.0), FRAME_S, &flat);
        3.6 * body.speed_mps() >= kmh
    });
    reached.map_or(f64::INFINITY, |frames| f64::from(frames) * FRAME_S)
}

/// Way to standstill, metres.
fn brake_m(shape: VehicleShape, kmh: f64) -> f64 {
    let mut body = at_kmh(VehicleBody::new(shape, Place::default()), kmh);
    for _ in 0..600 {
        body.step(&control(0.0, 1.0, 0.0), FRAME_S, &flat);
    }
    assert_eq!(body.velocity(), DVec3::ZERO);
    body.place().position.x
}

fn top_kmh(shape: VehicleShape) -> f64 {
    let mut body = VehicleBody::new(shape, Place::default());
    for _ in 0..2400 {
        body.step(&control(1.0, 0.0, 0.0), FRAME_S, &flat);
    }
    3.6 * body.speed_mps()
}

/// Radius of the circle that the outer front wheel draws at full lock, at walking pace, metres.
fn turning_circle_m(shape: VehicleShape) -> f64 {
    let mut body = VehicleBody::new(shape, Place::default());
    let (mut low, mut high) = (f64::MAX, f64::MIN);
    for frame in 0..2400 {
        let throttle = if body.speed_mps() < 2.0 { 0.4 } else { 0.0 };
        body.step(&control(throttle, 0.0, -1.0), FRAME_S, &flat);
        if frame > 300 {
            let place = body.place();
            let (sin, cos) = endless_world::math::f64::sin_cos(place.yaw_rad);
            let x = place.position.x + shape.front_axle_m * cos + 0.43 * shape.width_m * sin;
            (low, high) = (low.min(x), high.max(x));
        }
    }
    0.5 * (high - low)
}

/// That a figure is within its bounds; tells it, for those who want to know.
fn check(name: &str, what: &str, value: f64, bounds: std::ops::RangeInclusive<f64>) {
    println!("{name}: {what} {value:.2}");
    assert!(bounds.contains(&value), "{name}: {what} {value}, not in {bounds:?}");
}

#[test]
fn an_electric_saloon_drives_as_on_the_road() {
    let (name, shape) = ("model 3", VehicleShape::MODEL3);
    check(name, "0 to 100 km/h, s", accelerate_s(shape, 100.0), 5.0..=9.0);
    check(name, "100 to 0 km/h, m", brake_m(shape, 100.0), 35.0..=55.0);
    check(name, "50 to 0 km/h, m", brake_m(shape, 50.0), 9.0..=14.0);
    check(name, "turning circle, m", turning_circle_m(shape), 5.2..=5.8);
    check(name, "top speed, km/h", top_kmh(shape), 180.0..=240.0);
}

#[test]
fn a_hatchback_drives_as_on_the_road() {
    let (name, shape) = ("hatchback", hatchback());
    check(name, "0 to 100 km/h, s", accelerate_s(shape, 100.0), 6.5..=12.0);
    check(name, "100 to 0 km/h, m", brake_m(shape, 100.0), 35.0..=55.0);
    check(name, "turning circle, m", turning_circle_m(shape), 4.7..=5.6);
    check(name, "top speed, km/h", top_kmh(shape), 160.0..=220.0);
}

#[test]
fn heavy_vehicles_drive_as_on_the_road() {
    for (name, shape) in [("lorry", lorry()), ("bus", bus())] {
        check(name, "0 to 50 km/h, s", accelerate_s(shape, 50.0), 6.0..=20.0);
        check(name, "50 to 0 km/h, m", brake_m(shape, 50.0), 10.0..=20.0);
        check(name, "turning circle, m", turning_circle_m(shape), 8.0..=12.5);
        check(name, "top speed, km/h", top_kmh(shape), 90.0..=140.0);
    }
}

#[test]
fn two_wheelers_drive_as_on_the_road() {
    check("motorcycle", "0 to 100 km/h, s", accelerate_s(motorcycle(), 100.0), 3.5..=8.0);
    check("motorcycle", "100 to 0 km/h, m", brake_m(motorcycle(), 100.0), 35.0..=60.0);
    check("motorcycle", "top speed, km/h", top_kmh(motorcycle()), 140.0..=220.0);
    check("bicycle", "0 to 20 km/h, s", accelerate_s(bicycle(), 20.0), 4.0..=15.0);
    check("bicycle", "20 to 0 km/h, m", brake_m(bicycle(), 20.0), 1.5..=5.0);
    check("bicycle", "top speed, km/h", top_kmh(bicycle()), 22.0..=40.0);
}
