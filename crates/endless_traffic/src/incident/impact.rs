//! Rigid bodies in the plane: the impulse of an impact (Coulomb friction, Poisson restitution), and how vehicles slide on
//! their tyres afterwards, drivers on the brake.

use super::sliding_body::SlidingBody;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::swept::OrientedRectangle;
use endless_world::math::f64::{sin_cos, wrap_angle};
use endless_world::{ObjectClass, Pose};
use glam::DVec2;

/// Share of the closing speed with which cars part again (Brach and Brach 2005: 0.1 to 0.3 at such speeds).
const RESTITUTION: f64 = 0.12;
/// Friction of metal on metal.
const FRICTION: f64 = 0.4;
/// Bodies give way until they overlap by the way of so many seconds of closing: about 3 cm for each m/s (Campbell 1974).
const CRUSH_S: f64 = 0.03;
/// What brakes take along the wheels and tyres across them, m/s².
const BRAKES_MPS2: f64 = 5.0;
const ACROSS_MPS2: f64 = 6.5;
/// Tyres turn with so much of a vehicle's length as lever.
const LEVER: f64 = 0.25;
/// Below this speed hazard lights are on, m/s.
const HAZARDS_MPS: f64 = 1.0;

/// A usual mass, kg.
fn mass_kg(class: ObjectClass) -> f64 {
    match class {
        ObjectClass::Bus => 12_000.0,
        ObjectClass::Truck => 9_000.0,
        ObjectClass::Van => 2_200.0,
        ObjectClass::Motorcycle => 270.0,
        ObjectClass::Bicycle => 95.0,
        _ => 1_450.0,
    }
}

/// Mass, moment of inertia (of a box) and motion of a vehicle.
fn dynamics(vehicle: &Vehicle, body: &OrientedRectangle) -> (f64, f64, SlidingBody) {
    let mass = mass_kg(vehicle.class);
    let inertia = mass * body.half.length_squared() / 3.0;
    let driven = SlidingBody { velocity: body.axis * vehicle.speed, yaw_rate: 0.0 };
    (mass, inertia, vehicle.order.and_then(|order| order.crash).unwrap_or(driven))
}

/// Lets those collide that are to and touch.
pub(crate) fn collide(roads: &Roads, vehicles: &mut [Vehicle]) {
    let to_collide = |vehicle: &Vehicle| vehicle.order.is_some_and(|order| order.collides);
    let who: Vec<usize> = (0..vehicles.len()).filter(|&i| to_collide(&vehicles[i])).collect();
    for (k, &i) in who.iter().enumerate() {
        for &j in &who[k + 1..] {
            let bodies = [i, j].map(|i| vehicles[i].footprint(&roads.specs, 0.0));
            let Some((normal, at, depth_m)) = contact(&bodies[0], &bodies[1]) else { continue };
            let [one, other] = [dynamics(&vehicles[i], &bodies[0]), dynamics(&vehicles[j], &bodies[1])];
            let arms = [at - bodies[0].center, at - bodies[1].center];
            let closing_mps = (one.2.velocity - other.2.velocity).dot(normal);
            if depth_m < CRUSH_S * closing_mps {
                continue;
            }
            let after = impulse([one, other], arms, normal);
            for (i, body) in [i, j].into_iter().zip(after) {
                let order = vehicles[i].order.get_or_insert_default();
                order.crash = Some(body);
                order.hazards_below_mps = HAZARDS_MPS;
            }
        }
    }
}

/// The unit vector along which an overlap is least, from the first to the second; where it is, and how deep, metres.
fn contact(one: &OrientedRectangle, other: &OrientedRectangle) -> Option<(DVec2, DVec2, f64)> {
    if !one.overlaps(other) {
        return None;
    }
    let apart = other.center - one.center;
    let reach = |f: &OrientedRectangle, n: DVec2| f.half.x * f.axis.dot(n).abs() + f.half.y * f.axis.perp_dot(n).abs();
    let axes = [one.axis, one.axis.perp(), other.axis, other.axis.perp()];
    let depth = |n: &DVec2| reach(one, *n) + reach(other, *n) - apart.dot(*n).abs();
    let normal = axes.into_iter().min_by(|a, b| depth(a).total_cmp(&depth(b)))?;
    let depth_m = depth(&normal);
    let normal = if normal.dot(apart) < 0.0 { -normal } else { normal };
    let corners = |f: &OrientedRectangle| {
        [(1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (-1.0, 1.0)].map(|(x, y)| f.place(x * f.half.x, y * f.half.y))
    };
    let inside = |f: &OrientedRectangle, p: &DVec2| f.local(*p).abs().cmple(f.half + 1e-6).all();
    let mut shared: Vec<DVec2> = corners(one).into_iter().filter(|p| inside(other, p)).collect();
    shared.extend(corners(other).into_iter().filter(|p| inside(one, p)));
    let count = shared.len().max(1) as f64;
    let middle = || 0.5 * (one.center + other.center);
    let at = if shared.is_empty() { middle() } else { shared.into_iter().sum::<DVec2>() / count };
    Some((normal, at, depth_m))
}

/// The motions after an impact of two bodies (mass, inertia, motion) that touch at these arms from their middles.
fn impulse(bodies: [(f64, f64, SlidingBody); 2], arms: [DVec2; 2], normal: DVec2) -> [SlidingBody; 2] {
    let relative = |motions: [SlidingBody; 2]| {
        let at_contact = |k: usize| motions[k].velocity + arms[k].perp() * motions[k].yaw_rate;
        at_contact(1) - at_contact(0)
    };
    let before = [bodies[0].2, bodies[1].2];
    let closing = -relative(before).dot(normal);
    if closing <= 0.0 {
        return before;
    }
    let yielding = |direction: DVec2| -> f64 {
        (0..2).map(|k| 1.0 / bodies[k].0 + arms[k].perp_dot(direction).powi(2) / bodies[k].1).sum()
    };
    let pushed = |motions: [SlidingBody; 2], push: DVec2| {
        let after = |k: usize, push: DVec2| SlidingBody {
            velocity: motions[k].velocity + push / bodies[k].0,
            yaw_rate: motions[k].yaw_rate + arms[k].perp_dot(push) / bodies[k].1,
        };
        [after(0, -push), after(1, push)]
    };
    let along_ns = (1.0 + RESTITUTION) * closing / yielding(normal);
    let parted = pushed(before, normal * along_ns);
    // Friction takes at most the sliding that is left.
    let across = normal.perp();
    let most_ns = FRICTION * along_ns;
    let across_ns = (-relative(parted).dot(across) / yielding(across)).clamp(-most_ns, most_ns);
    pushed(parted, across * across_ns)
}

/// Moves a vehicle that has collided on by one step.
pub(crate) fn slide(vehicle: &mut Vehicle, roads: &Roads, step_s: f64) {
    let Some(mut body) = vehicle.order.and_then(|order| order.crash) else { return };
    let (sin, cos) = sin_cos(vehicle.yaw);
    let ahead = DVec2::new(cos, sin);
    let slower = |value: f64, by: f64| value.signum() * (value.abs() - by * step_s).max(0.0);
    let along = slower(body.velocity.dot(ahead), BRAKES_MPS2);
    let across = slower(ahead.perp_dot(body.velocity), ACROSS_MPS2);
    body.velocity = ahead * along + ahead.perp() * across;
    let mass = mass_kg(vehicle.class);
    let half_width = 0.5 * f64::from(roads.specs[vehicle.asset.model.index()].width_m);
    let inertia = mass * DVec2::new(vehicle.half_length, half_width).length_squared() / 3.0;
    let torque = ACROSS_MPS2 * mass * LEVER * 2.0 * vehicle.half_length;
    body.yaw_rate = slower(body.yaw_rate, torque / inertia);
    let before = vehicle.speed;
    vehicle.speed = along.max(0.0);
    vehicle.acceleration = (vehicle.speed - before) / step_s;
    vehicle.yaw = wrap_angle(vehicle.yaw + body.yaw_rate * step_s);
    let lane = roads.network.lane(vehicle.lane());
    let moved = body.velocity * step_s;
    vehicle.s += moved.dot(lane.centerline.direction(vehicle.s));
    let length = roads.table(vehicle.lane()).length;
    if vehicle.s > length && vehicle.here + 1 < vehicle.route.len() {
        vehicle.s -= length;
        vehicle.here += 1;
    }
    let lane = roads.network.lane(vehicle.lane());
    vehicle.rolled += along * step_s;
    let at = vehicle.pose.position.as_dvec3() + moved.extend(0.0);
    let ground = lane.centerline.at(vehicle.s);
    let pitch = vehicle.pose.pitch_rad;
    vehicle.pose = Pose {
        position: at.truncate().extend(ground.position.z).as_vec3(),
        yaw_rad: vehicle.yaw as f32,
        pitch_rad: pitch,
        roll_rad: vehicle.roll as f32,
    };
    vehicle.velocity = body.velocity.extend(0.0).as_vec3();
    if let Some(order) = &mut vehicle.order {
        order.crash = Some(body);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn body(mass: f64, velocity: DVec2, yaw_rate: f64) -> (f64, f64, SlidingBody) {
        (mass, mass * 2.0, SlidingBody { velocity, yaw_rate })
    }

    #[test]
    fn who_is_hit_from_behind_is_pushed_on() {
        let bodies = [body(1500.0, DVec2::new(8.0, 0.0), 0.0), body(1500.0, DVec2::ZERO, 0.0)];
        let [a, b] = impulse(bodies, [DVec2::new(2.2, 0.0), DVec2::new(-2.2, 0.0)], DVec2::X);
        assert!((a.velocity.x - 0.5 * (1.0 - RESTITUTION) * 8.0).abs() < 1e-9, "{a:?}");
        assert!((b.velocity.x - 0.5 * (1.0 + RESTITUTION) * 8.0).abs() < 1e-9, "{b:?}");
        assert_eq!((a.yaw_rate, b.yaw_rate), (0.0, 0.0));
    }

    proptest! {
        #[test]
        fn momentum_stays_and_energy_does_not_grow(
            speeds in prop::array::uniform4(-10.0f64..10.0),
            yaw_rates in prop::array::uniform2(-1.0f64..1.0),
            arms in prop::array::uniform4(-2.0f64..2.0),
            masses in prop::array::uniform2(90.0f64..12_000.0),
            turn in -3.1f64..3.1,
        ) {
            let normal = { let (sin, cos) = sin_cos(turn); DVec2::new(cos, sin) };
            let arms = [DVec2::new(arms[0], arms[1]), DVec2::new(arms[2], arms[3])];
            let bodies = [0, 1].map(|k| body(masses[k], DVec2::new(speeds[2 * k], speeds[2 * k + 1]), yaw_rates[k]));
            let after = impulse(bodies, arms, normal);
            let momentum = |motions: [SlidingBody; 2]| masses[0] * motions[0].velocity + masses[1] * motions[1].velocity;
            let before = [bodies[0].2, bodies[1].2];
            prop_assert!((momentum(after) - momentum(before)).length() < 1e-6 * masses[0].max(masses[1]));
            let energy = |motions: [SlidingBody; 2]| -> f64 {
                (0..2).map(|k| {
                    masses[k] * motions[k].velocity.length_squared() + bodies[k].1 * motions[k].yaw_rate.powi(2)
                }).sum()
            };
            prop_assert!(energy(after) <= energy(before) * (1.0 + 1e-9) + 1e-6);
        }
    }
}
