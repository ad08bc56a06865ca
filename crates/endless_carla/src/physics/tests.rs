//! Figures of vehicles against those of the road, and what no client may break.

mod crashes;
mod driving;
mod figures;
mod robustness;
mod traffic_manager;
mod walking;

use super::{Place, VehicleBody, VehicleShape};
use crate::wire::VehicleControl;
use endless_world::ObjectClass;
use glam::DVec3;

/// Of the client that drives.
const FRAME_S: f64 = 0.05;

fn flat(_: f64, _: f64, _: f64) -> Option<f64> {
    Some(0.0)
}

fn at(x: f64, y: f64, yaw_rad: f64) -> Place {
    Place::level(DVec3::new(x, y, 0.0), yaw_rad)
}

fn model3() -> VehicleBody {
    VehicleBody::new(VehicleShape::MODEL3, Place::default())
}

/// At a speed straight on to the east.
fn at_kmh(mut body: VehicleBody, kmh: f64) -> VehicleBody {
    body.step(&VehicleControl::default(), FRAME_S, &flat);
    body.set_target_velocity(DVec3::X * (kmh / 3.6));
    body
}

fn control(throttle: f32, brake: f32, steer: f32) -> VehicleControl {
    VehicleControl { throttle, brake, steer, ..VehicleControl::default() }
}

fn shape(class: ObjectClass, size: [f64; 3], axles: [f64; 2], wheel_radius_m: f64) -> VehicleShape {
    VehicleShape {
        class,
        length_m: size[0],
        width_m: size[1],
        height_m: size[2],
        front_axle_m: axles[0],
        rear_axle_m: axles[1],
        wheel_radius_m,
        mass_kg: None,
        electric: false,
    }
}

fn hatchback() -> VehicleShape {
    shape(ObjectClass::Car, [4.2, 1.8, 1.5], [1.3, -1.3], 0.32)
}

fn lorry() -> VehicleShape {
    shape(ObjectClass::Truck, [8.5, 2.5, 3.4], [2.9, -2.1], 0.5)
}

fn bus() -> VehicleShape {
    shape(ObjectClass::Bus, [12.0, 2.55, 3.1], [3.3, -2.7], 0.48)
}

fn motorcycle() -> VehicleShape {
    shape(ObjectClass::Motorcycle, [2.2, 0.8, 1.5], [0.72, -0.72], 0.31)
}

fn bicycle() -> VehicleShape {
    shape(ObjectClass::Bicycle, [1.8, 0.5, 1.6], [0.53, -0.53], 0.34)
}

fn everyone() -> [(&'static str, VehicleShape); 6] {
    [
        ("model 3", VehicleShape::MODEL3),
        ("hatchback", hatchback()),
        ("lorry", lorry()),
        ("bus", bus()),
        ("motorcycle", motorcycle()),
        ("bicycle", bicycle()),
    ]
}
