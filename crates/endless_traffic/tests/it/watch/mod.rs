//! Simulations of a small fleet, and their audit.

use endless_road::RoadNetwork;
use endless_traffic::{AuditReport, Fleet, Simulation, TrafficAudit, TrafficSettings};
use endless_world::walking::PedestrianSpec;
use endless_world::{ObjectClass, VehicleSpec};

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

/// Runs for some seconds and looks at every frame.
pub(crate) fn watch(
    simulation: &mut Simulation,
    network: &RoadNetwork,
    specs: &[VehicleSpec],
    seconds: f64,
    fps: f64,
) -> AuditReport {
    let audit = TrafficAudit::new(network, specs, simulation.parked(), fps);
    watch_by(audit, simulation, seconds, fps)
}

/// The same with an audit that has not begun.
pub(crate) fn watch_by(
    mut audit: TrafficAudit<'_>,
    simulation: &mut Simulation,
    seconds: f64,
    fps: f64,
) -> AuditReport {
    audit.look(&simulation.state());
    for _ in 0..(seconds * fps) as usize {
        simulation.tick();
        audit.look(&simulation.state());
    }
    audit.report()
}
