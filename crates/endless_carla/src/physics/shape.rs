//! What of a vehicle is seen, and so is no matter of choice.

use endless_world::{ObjectClass, VehicleSpec};

/// Measures of a vehicle, metres, in the object frame: x forward, y left, z up, the origin on the ground under its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VehicleShape {
    /// What it is.
    pub class: ObjectClass,
    /// Foremost to rearmost point.
    pub length_m: f64,
    /// Without mirrors.
    pub width_m: f64,
    /// From the ground.
    pub height_m: f64,
    /// x of the front axle.
    pub front_axle_m: f64,
    /// x of the rear axle.
    pub rear_axle_m: f64,
    /// Of all wheels.
    pub wheel_radius_m: f64,
    /// Kilograms; `None` for what such a vehicle usually weighs.
    pub mass_kg: Option<f64>,
    /// One gear and torque from standstill on.
    pub electric: bool,
}

impl VehicleShape {
    /// A saloon of the measures and mass of CARLA's `vehicle.tesla.model3`.
    pub const MODEL3: Self = Self {
        class: ObjectClass::Car,
        length_m: 4.79,
        width_m: 1.85,
        height_m: 1.49,
        front_axle_m: 1.44,
        rear_axle_m: -1.44,
        wheel_radius_m: 0.35,
        mass_kg: Some(1845.0),
        electric: true,
    };

    /// Whether it leans into bends.
    pub fn two_wheeled(&self) -> bool {
        self.class.two_wheeled() || self.class == ObjectClass::Rider
    }

    /// Kilograms, with those on two-wheelers: by volume, as its class has it.
    pub fn usual_mass_kg(&self) -> f64 {
        let volume = self.length_m * self.width_m * self.height_m;
        let mass_kg = match self.class {
            ObjectClass::Bicycle | ObjectClass::Rider => 90.0,
            ObjectClass::Motorcycle => 290.0,
            ObjectClass::Van => 125.0 * volume,
            ObjectClass::Truck => 150.0 * volume,
            ObjectClass::Bus => 135.0 * volume,
            ObjectClass::Car | ObjectClass::Pedestrian => 118.0 * volume,
        };
        self.mass_kg.unwrap_or(mass_kg)
    }
}

impl From<&VehicleSpec> for VehicleShape {
    fn from(spec: &VehicleSpec) -> Self {
        Self {
            class: spec.class,
            length_m: spec.length_m.into(),
            width_m: spec.width_m.into(),
            height_m: spec.height_m.into(),
            front_axle_m: spec.front_axle_m.into(),
            rear_axle_m: spec.rear_axle_m.into(),
            wheel_radius_m: spec.wheel_radius_m.into(),
            mass_kg: None,
            electric: false,
        }
    }
}
