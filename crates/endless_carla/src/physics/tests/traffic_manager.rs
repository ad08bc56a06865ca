//! Driven as CARLA's traffic manager drives: controllers of its gains at 20 frames a second, on a course through town.

use super::*;
use endless_world::math::f64::{acos, sin_cos};
use glam::DVec2;

/// A point every quarter of a metre: straight, a bend to the left, straight, a tighter one to the right, straight.
fn course(radii: [f64; 2]) -> Vec<DVec2> {
    let mut points = vec![DVec2::ZERO];
    let mut yaw = 0.0;
    let parts = [
        (80.0, 0.0),
        (radii[0] * std::f64::consts::FRAC_PI_2, 1.0 / radii[0]),
        (60.0, 0.0),
        (radii[1] * std::f64::consts::FRAC_PI_2, -1.0 / radii[1]),
        (120.0, 0.0),
    ];
    for (length, curvature) in parts {
        for _ in 0..(length / 0.25) as usize {
            yaw += 0.25 * curvature;
            let (sin, cos) = sin_cos(yaw);
            points.push(points[points.len() - 1] + DVec2::new(cos, sin) * 0.25);
        }
    }
    points
}

/// The traffic manager's controllers.
struct Driver {
    /// Of speed and of direction.
    gains: [[f64; 3]; 2],
    last: [f64; 2],
    sums: [f64; 2],
    steer: f64,
}

impl Driver {
    const STREET: [[f64; 3]; 2] = [[12.0, 0.05, 0.02], [4.0, 0.02, 0.08]];
    const MOTORWAY: [[f64; 3]; 2] = [[20.0, 0.05, 0.01], [2.0, 0.02, 0.04]];

    fn new(gains: [[f64; 3]; 2]) -> Self {
        Self { gains, last: [0.0; 2], sums: [0.0; 2], steer: 0.0 }
    }

    fn control(&mut self, body: &VehicleBody, target: DVec2, speed_mps: f64) -> VehicleControl {
        let place = body.place();
        let (sin, cos) = sin_cos(place.yaw_rad);
        let forward = DVec2::new(cos, sin);
        let there = (target - place.position.truncate()).normalize();
        let right = if forward.perp_dot(there) < 0.0 { 1.0 } else { -1.0 };
        let deviation = right * acos(forward.dot(there).clamp(-1.0, 1.0)) / std::f64::consts::PI;
        let wanting = speed_mps - body.velocity().length();
        let mut run = |index: usize, error: f64| {
            let gains = self.gains[index];
            self.sums[index] = (self.sums[index] + error * FRAME_S).clamp(-5.0, 5.0);
            let out = gains[0] * error + gains[1] * self.sums[index] + gains[2] * (error - self.last[index]) / FRAME_S;
            self.last[index] = error;
            out
        };
        let pedal = run(0, wanting);
        let steer = run(1, deviation);
        self.steer = steer.clamp(self.steer - 0.15, self.steer + 0.15).clamp(-0.8, 0.8);
        control(pedal.clamp(0.0, 0.85) as f32, (-pedal).clamp(0.0, 0.7) as f32, self.steer as f32)
    }
}

/// Largest distance from the course, metres, and difference from the speed on the last stretch, m/s.
fn drive(shape: VehicleShape, speed_mps: f64, in_bends_mps: f64, radii: [f64; 2]) -> (f64, f64) {
    let course = course(radii);
    // A quarter of a circle has so many points; brakes come twenty metres ahead.
    let [first, second] = radii.map(|radius| (radius * std::f64::consts::TAU) as usize);
    let bends =
        |index: usize| (240..320 + first).contains(&index) || (480 + first..560 + first + second).contains(&index);
    let mut body = VehicleBody::new(shape, Place::default());
    let mut driver = Driver::new(if speed_mps > 17.0 { Driver::MOTORWAY } else { Driver::STREET });
    let (mut nearest, mut worst_m) = (0, 0.0_f64);
    for _ in 0..2400 {
        let at = body.place().position.truncate();
        while nearest + 1 < course.len() && (course[nearest + 1] - at).length() <= (course[nearest] - at).length() {
            nearest += 1;
        }
        worst_m = worst_m.max((course[nearest] - at).length());
        let ahead_m = (0.5 * body.velocity().length()).max(3.0);
        let Some(&target) = course.get(nearest + (ahead_m / 0.25) as usize) else { break };
        let wanted = if bends(nearest) { in_bends_mps } else { speed_mps };
        let control = driver.control(&body, target, wanted);
        body.step(&control, FRAME_S, &flat);
    }
    (worst_m, (body.velocity().length() - speed_mps).abs())
}

#[test]
fn it_is_driven_through_town() {
    for (name, shape, radii) in [
        ("model 3", VehicleShape::MODEL3, [20.0, 9.0]),
        ("hatchback", hatchback(), [20.0, 9.0]),
        ("lorry", lorry(), [25.0, 16.0]),
        ("bus", bus(), [25.0, 18.0]),
        ("motorcycle", motorcycle(), [20.0, 9.0]),
        ("bicycle", bicycle(), [20.0, 9.0]),
    ] {
        let top = if name == "bicycle" { 6.0 } else { 11.0 };
        let (worst_m, off_mps) = drive(shape, top, 5.0, radii);
        println!("{name}: {worst_m:.2} m off, {off_mps:.2} m/s off");
        assert!(worst_m < 0.8 && off_mps < 0.6, "{name}: {worst_m} m, {off_mps} m/s");
    }
}

#[test]
fn it_is_driven_on_the_motorway() {
    for (name, shape) in [("model 3", VehicleShape::MODEL3), ("hatchback", hatchback()), ("bus", bus())] {
        let (worst_m, off_mps) = drive(shape, 25.0, 25.0, [200.0, 160.0]);
        println!("{name} on the motorway: {worst_m:.2} m off, {off_mps:.2} m/s off");
        assert!(worst_m < 0.8 && off_mps < 0.6, "{name}: {worst_m} m, {off_mps} m/s");
    }
}

#[test]
fn it_comes_to_a_halt_and_stays() {
    let mut body = at_kmh(model3(), 40.0);
    let mut driver = Driver::new(Driver::STREET);
    for _ in 0..100 {
        let ahead = body.place().position.truncate() + DVec2::X * 5.0;
        let control = driver.control(&body, ahead, 0.0);
        body.step(&control, FRAME_S, &flat);
    }
    let stood = body.place().position;
    for _ in 0..200 {
        let control = driver.control(&body, stood.truncate() + DVec2::X * 5.0, 0.0);
        body.step(&control, FRAME_S, &flat);
    }
    assert!((body.place().position - stood).length() < 1e-6);
}

#[test]
fn the_ackermann_controller_reaches_speed_and_angle_and_stops() {
    use crate::physics::AckermannController;
    use crate::wire::VehicleAckermannControl;
    let mut body = model3();
    let mut controller = AckermannController::default();
    let run = |body: &mut VehicleBody, controller: &mut AckermannController, speed: f32, steer: f32| {
        let wanted = VehicleAckermannControl { speed, steer, steer_speed: 0.5, ..Default::default() };
        for _ in 0..600 {
            let control = controller.run(&wanted, body, FRAME_S);
            body.step(&control, FRAME_S, &flat);
        }
    };
    run(&mut body, &mut controller, 10.0, 0.0);
    assert!((body.speed_mps() - 10.0).abs() < 1.0, "{}", body.speed_mps());
    run(&mut body, &mut controller, 0.0, 0.1);
    assert!(body.speed_mps().abs() < 1e-3, "{}", body.speed_mps());
    // To the right is positive there.
    assert!((body.wheel_angles_rad()[0] + 0.1).abs() < 0.02, "{:?}", body.wheel_angles_rad());
    run(&mut body, &mut controller, -3.0, 0.0);
    assert!((body.speed_mps() + 3.0).abs() < 1.0, "{}", body.speed_mps());
}
