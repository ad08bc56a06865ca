//! Watches a simulation and reports what no street ever shows.
#![allow(dead_code, reason = "each test file uses its part")]

use endless_road::RoadNetwork;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::math::f64::{sin_cos, wrap_angle};
use endless_world::walking::PedestrianSpec;
use endless_world::{Actor, Motion, ObjectClass, Pose, VehicleSpec};
use glam::DVec2;

/// Height of a person, metres.
const TALL_M: f64 = 1.8;

pub(crate) fn spec(
    name: &'static str,
    class: ObjectClass,
    size: [f32; 3],
    cruise_mps: f32,
    frequency: f64,
) -> VehicleSpec {
    let two_wheeled = class.two_wheeled();
    VehicleSpec {
        name,
        draw: 0,
        class,
        length_m: size[0],
        width_m: size[1],
        height_m: size[2],
        front_axle_m: size[0] * 0.3,
        rear_axle_m: size[0] * -0.3,
        wheel_radius_m: 0.33,
        cruise_mps,
        acceleration_mps2: if size[0] > 6.0 { 1.1 } else { 1.8 },
        frequency,
        parks: class == ObjectClass::Car,
        ridden: two_wheeled,
        trailer: None,
    }
}

pub(crate) fn specs() -> Vec<VehicleSpec> {
    vec![
        spec("car.hatchback", ObjectClass::Car, [4.1, 1.75, 1.5], 16.0, 5.0),
        spec("car.saloon", ObjectClass::Car, [4.8, 1.85, 1.45], 16.0, 5.0),
        spec("van.panel", ObjectClass::Van, [5.6, 2.0, 2.5], 15.0, 1.5),
        spec("truck.box", ObjectClass::Truck, [8.0, 2.5, 3.3], 12.0, 0.7),
        spec("bus.city", ObjectClass::Bus, [12.0, 2.55, 3.1], 12.0, 0.4),
        spec("motorcycle.street", ObjectClass::Motorcycle, [2.1, 0.8, 1.2], 16.0, 1.0),
        spec("bicycle.city", ObjectClass::Bicycle, [1.8, 0.6, 1.1], 5.0, 0.7),
    ]
}

/// Traffic of these vehicles, none of them parked, and of people who walk alike.
pub(crate) fn simulation(network: &RoadNetwork, specs: &[VehicleSpec], settings: &TrafficSettings) -> Simulation {
    Simulation::new(network, &Fleet { vehicles: specs, pedestrian: &pedestrian }, &[], settings).expect("few enough")
}

/// Somebody who walks as most do.
pub(crate) fn pedestrian(_: u64) -> PedestrianSpec {
    PedestrianSpec { walk_mps: 1.35, ..PedestrianSpec::default() }
}

/// The body seen from above: centre, axes, half sizes; and the heights between which it is.
#[derive(Clone, Copy)]
pub(crate) struct BodyFootprint {
    center: DVec2,
    bottom: f64,
    top: f64,
    axis: DVec2,
    half: DVec2,
}

impl BodyFootprint {
    pub(crate) fn of(pose: &Pose, spec: &VehicleSpec) -> Self {
        let (sin, cos) = sin_cos(f64::from(pose.yaw_rad));
        let half = DVec2::new(f64::from(spec.length_m), f64::from(spec.width_m)) * 0.5;
        let bottom = f64::from(pose.position.z);
        let top = bottom + f64::from(spec.height_m);
        Self { center: pose.position.as_dvec3().truncate(), bottom, top, axis: DVec2::new(cos, sin), half }
    }

    /// The rigid pieces of a vehicle.
    pub(crate) fn pieces(actor: &Actor, spec: &VehicleSpec) -> Vec<Self> {
        let whole = Self::of(&actor.pose, spec);
        let (Some(t), Motion::Vehicle(motion)) = (spec.trailer, actor.motion) else { return vec![whole] };
        let [hitch, front, rear] = [t.hitch_m, t.front_m, t.towing_rear_m].map(f64::from);
        let piece = |from: DVec2, yaw: f64, x0: f64, x1: f64| {
            let (sin, cos) = sin_cos(yaw);
            let axis = DVec2::new(cos, sin);
            let half = DVec2::new(0.5 * (x1 - x0), whole.half.y);
            Self { center: from + axis * 0.5 * (x0 + x1), axis, half, ..whole }
        };
        let yaw = f64::from(actor.pose.yaw_rad);
        let joint = whole.center + whole.axis * hitch;
        let (half, turn) = (whole.half.x, yaw + f64::from(motion.hitch_rad));
        vec![piece(whole.center, yaw, rear, half), piece(joint, turn, -half - hitch, front - hitch)]
    }

    /// Whether one is above the other, as on a bridge.
    pub(crate) fn passes_over(&self, other: &Self) -> bool {
        self.bottom > other.top || other.bottom > self.top
    }

    /// How deep two footprints overlap (separating axes); not positive if they do not.
    pub(crate) fn depth(&self, other: &Self) -> f64 {
        if self.passes_over(other) {
            return -1.0;
        }
        let d = other.center - self.center;
        let radius = |f: &Self, n: DVec2| f.half.x * f.axis.dot(n).abs() + f.half.y * f.axis.perp().dot(n).abs();
        [self.axis, self.axis.perp(), other.axis, other.axis.perp()]
            .into_iter()
            .map(|n| radius(self, n) + radius(other, n) - d.dot(n).abs())
            .fold(f64::INFINITY, f64::min)
    }

    pub(crate) fn distance(&self, p: DVec2) -> f64 {
        let d = p - self.center;
        let local = DVec2::new(d.dot(self.axis), d.dot(self.axis.perp())).abs() - self.half;
        local.max(DVec2::ZERO).length()
    }
}

#[derive(Debug, Default)]
pub(crate) struct Findings {
    pub(crate) overlaps: Vec<String>,
    pub(crate) walker_hits: Vec<String>,
    pub(crate) jumps: Vec<String>,
    pub(crate) touching_walkers: usize,
    pub(crate) worst_slip_mps: f64,
    pub(crate) worst_acceleration: f64,
    pub(crate) worst_yaw_rate: f64,
    pub(crate) driven_m: f64,
    pub(crate) walked_m: f64,
    /// Longest time that a vehicle stood, seconds, with its number and place.
    pub(crate) longest_stand: (f64, usize, DVec2),
    pub(crate) longest_walker_stand: (f64, usize, DVec2),
}

/// Runs for some seconds and looks at every frame.
pub(crate) fn watch(simulation: &mut Simulation, specs: &[VehicleSpec], seconds: f64, fps: f64) -> Findings {
    let mut f = Findings::default();
    let parked: Vec<Actor> = simulation.parked().to_vec();
    let mut before = simulation.state();
    let mut stood = vec![0.0; before.actors.len()];
    let mut touching_before: Vec<(usize, usize)> = Vec::new();
    for _ in 0..(seconds * fps) as usize {
        simulation.tick();
        let now = simulation.state();
        let vehicles: Vec<&Actor> = now.actors.iter().filter(|a| matches!(a.motion, Motion::Vehicle(_))).collect();
        let prints: Vec<Vec<BodyFootprint>> =
            vehicles.iter().copied().chain(&parked).map(|a| BodyFootprint::pieces(a, &specs[model_index(a)])).collect();
        let mut touching = Vec::new();
        for i in 0..vehicles.len() {
            for j in i + 1..prints.len() {
                let pairs = || prints[i].iter().flat_map(|a| prints[j].iter().map(move |b| (a, b)));
                let near = |a: &BodyFootprint, b: &BodyFootprint| a.center.distance_squared(b.center) < 300.0;
                if pairs().any(|(a, b)| near(a, b) && a.depth(b) > 0.0) {
                    touching.push((i, j));
                    if !touching_before.contains(&(i, j)) {
                        let at = prints[i][0].center;
                        let speeds = [i, j].map(|k| vehicles.get(k).map_or(0.0, |v| v.velocity_mps.length()));
                        let classes = [i, j].map(|k| vehicles.get(k).map(|v| v.class));
                        f.overlaps
                            .push(format!("t={:.1} {i}+{j} {classes:?} at {at:.1} speeds {speeds:.1?}", now.time_s));
                    }
                }
            }
        }
        touching_before = touching;
        let walkers: Vec<&Actor> = now.actors.iter().filter(|a| matches!(a.motion, Motion::Walker(_))).collect();
        for (k, w) in walkers.iter().enumerate() {
            let p = w.pose.position.as_dvec3().truncate();
            for (i, print) in prints.iter().enumerate().flat_map(|(i, all)| all.iter().map(move |p| (i, p))) {
                let feet = f64::from(w.pose.position.z);
                let level = feet < print.top && feet + TALL_M > print.bottom;
                if level && print.center.distance_squared(p) < 100.0 && print.distance(p) < 0.25 {
                    let (what, at) = (vehicles.get(i).map(|v| v.class), print.center);
                    f.walker_hits
                        .push(format!("t={:.1} walker {k} at {p:.1} vehicle {i} {what:?} at {at:.1}", now.time_s));
                }
            }
            for other in &walkers[k + 1..] {
                let apart = other.pose.position - w.pose.position;
                if apart.truncate().length() < 0.499 && apart.z.abs() < TALL_M as f32 {
                    f.touching_walkers += 1;
                }
            }
        }
        for (k, (a, b)) in now.actors.iter().zip(&before.actors).enumerate() {
            let moved = (a.pose.position - b.pose.position).as_dvec3().truncate();
            let speed = moved.length() * fps;
            stood[k] = if speed < 0.1 { stood[k] + 1.0 / fps } else { 0.0 };
            let at = a.pose.position.as_dvec3().truncate();
            match (a.motion, b.motion) {
                (Motion::Vehicle(m), Motion::Vehicle(n)) => {
                    f.driven_m += moved.length();
                    if stood[k] > f.longest_stand.0 {
                        f.longest_stand = (stood[k], k, at);
                    }
                    let spec = &specs[model_index(a)];
                    let rear = |x: &Actor| {
                        let (sin, cos) = sin_cos(f64::from(x.pose.yaw_rad));
                        x.pose.position.as_dvec3().truncate() + DVec2::new(cos, sin) * f64::from(spec.rear_axle_m)
                    };
                    let (sin, cos) =
                        sin_cos(0.5 * f64::from(wrap(a.pose.yaw_rad - b.pose.yaw_rad)) + f64::from(b.pose.yaw_rad));
                    let slip = (rear(a) - rear(b)).dot(DVec2::new(-sin, cos)).abs() * fps;
                    f.worst_slip_mps = f.worst_slip_mps.max(slip);
                    let forward = (rear(a) - rear(b)).dot(DVec2::new(cos, sin)) * fps;
                    assert!(forward > -0.05, "vehicle {k} rolls back at {forward} m/s, {at:.1}");
                    let change = f64::from(m.speed_mps - n.speed_mps).abs() * fps;
                    f.worst_acceleration = f.worst_acceleration.max(change);
                    let rate = f64::from(wrap(a.pose.yaw_rad - b.pose.yaw_rad)).abs() * fps;
                    f.worst_yaw_rate = f.worst_yaw_rate.max(rate);
                    assert!(
                        speed < f64::from(m.speed_mps) * 1.2 + 1.0,
                        "vehicle {k} jumps: {speed} at {}, {at:.1}",
                        m.speed_mps
                    );
                }
                (Motion::Walker(_), _) => {
                    f.walked_m += moved.length();
                    if stood[k] > f.longest_walker_stand.0 {
                        f.longest_walker_stand = (stood[k], k, at);
                    }
                    assert!(speed < 4.5, "walker {k} jumps: {speed}");
                }
                _ => unreachable!("actors keep their order"),
            }
        }
        before = now;
    }
    f
}

/// Index of a vehicle's model in the catalogue.
fn model_index(vehicle: &Actor) -> usize {
    vehicle.asset.vehicle().expect("a vehicle").model.index()
}

fn wrap(angle: f32) -> f32 {
    wrap_angle(f64::from(angle)) as f32
}
