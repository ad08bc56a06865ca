//! Vehicle models.

mod assemble;
mod bus;
mod car;
mod cars;
mod cycle;
mod motorcycle;
mod paint;
mod shell;
mod tint;
mod truck;
mod van;
mod wheel;

pub(crate) use assemble::{Built, RiderFit};
pub(crate) use tint::tint;

use crate::Mesh;
use endless_world::ObjectClass;
use glam::Vec3;

/// What traffic needs to know of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleSpec {
    /// Unique, e.g. `car.hatchback`.
    pub name: &'static str,
    /// Class of the vehicle itself (the rider of a two-wheeler is an object of its own).
    pub class: ObjectClass,
    /// Bumper to bumper, metres; equals the mesh's bounds.
    pub length_m: f32,
    /// Without mirrors, metres.
    pub width_m: f32,
    /// Metres.
    pub height_m: f32,
    /// x of the front axle in the object frame, metres.
    pub front_axle_m: f32,
    /// x of the rear axle, metres.
    pub rear_axle_m: f32,
    /// Metres.
    pub wheel_radius_m: f32,
    /// Comfortable cruising speed on an empty road, m/s (lower than the limit for bicycles and lorries).
    pub cruise_mps: f32,
    /// Comfortable acceleration, m/s².
    pub acceleration_mps2: f32,
    /// Relative frequency on the road.
    pub frequency: f64,
    /// Whether it may stand parked at a kerb.
    pub parks: bool,
    /// Whether somebody rides on it.
    pub ridden: bool,
}

/// A wheel of a vehicle.
#[derive(Debug, Clone, PartialEq)]
pub struct Wheel {
    /// Centre in the object frame.
    pub position: Vec3,
    /// Whether it turns with the steering.
    pub steered: bool,
    /// Whether the mesh is mirrored (y → −y) for this side.
    pub mirrored: bool,
}

/// One model of the catalogue.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleModel {
    /// Sizes and habits.
    pub spec: VehicleSpec,
    /// Everything but wheels and rider. [`crate::Surface::CarPaint`] is tinted per variant.
    pub body: Mesh,
    /// Wheels, all with `wheel_mesh`.
    pub wheels: Vec<Wheel>,
    /// Axis along y, centre at the origin, outer side towards +y.
    pub wheel_mesh: Mesh,
    /// Centres of the headlights' lenses in the object frame (one for two-wheelers, none for bicycles).
    pub headlights: Vec<Vec3>,
}

impl VehicleSpec {
    /// A spec without measures, which assembling the vehicle fills in.
    pub(crate) fn blank(name: &'static str, class: ObjectClass) -> Self {
        Self {
            name,
            class,
            length_m: 0.0,
            width_m: 0.0,
            height_m: 0.0,
            front_axle_m: 0.0,
            rear_axle_m: 0.0,
            wheel_radius_m: 0.0,
            cruise_mps: 13.0,
            acceleration_mps2: 1.5,
            frequency: 1.0,
            parks: false,
            ridden: false,
        }
    }
}

/// All models of the catalogue.
pub(crate) fn all() -> Vec<Built> {
    let mut all = cars::all();
    all.extend(van::all());
    all.extend(truck::all());
    all.extend(bus::all());
    all.extend(motorcycle::all());
    all.extend(cycle::all());
    all
}
