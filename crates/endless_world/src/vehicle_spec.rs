//! Vehicles as traffic knows them: measures and habits of a model, and parked vehicles.

use crate::{ObjectClass, Pose, Stream, VehicleRef};

/// Measures and habits of a vehicle model.
#[derive(Debug, Clone, PartialEq)]
pub struct VehicleSpec {
    /// Name of the design, e.g. `car.hatchback`; vehicles of one design differ in size and equipment. `imported` of all
    /// vehicles from files.
    pub name: &'static str,
    /// Which vehicle of its design it is: the number of the draw, or a hash of the file's name.
    pub draw: u64,
    /// Class of the vehicle itself (the rider of a two-wheeler is an object of its own).
    pub class: ObjectClass,
    /// Foremost to rearmost point, metres; equals the mesh's bounds.
    pub length_m: f32,
    /// Without mirrors, metres.
    pub width_m: f32,
    /// Metres; equals the mesh's bounds.
    pub height_m: f32,
    /// x of the front axle in the object frame, metres.
    pub front_axle_m: f32,
    /// x of the rear axle, metres.
    pub rear_axle_m: f32,
    /// Metres.
    pub wheel_radius_m: f32,
    /// Comfortable speed on an empty road without a limit, m/s: of cars above all limits, of bicycles and lorries below.
    pub cruise_mps: f32,
    /// Comfortable acceleration, m/s².
    pub acceleration_mps2: f32,
    /// Relative frequency on the road.
    pub frequency: f64,
    /// Whether it may stand parked at a kerb.
    pub parks: bool,
    /// Whether it has a rider: two-wheelers, and three-wheelers whose driver sits in the open.
    pub ridden: bool,
    /// The trailer that it tows; the axles are then those of the towing vehicle.
    pub trailer: Option<TrailerSpec>,
}

/// Measures of a vehicle that draws another: x in the object frame while it goes straight on, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrailerSpec {
    /// About this the trailer turns.
    pub hitch_m: f32,
    /// Middle of the trailer's axles.
    pub axle_m: f32,
    /// Foremost point of the trailer.
    pub front_m: f32,
    /// Rearmost point of what draws it.
    pub towing_rear_m: f32,
}

impl Default for VehicleSpec {
    /// A hatchback of middle size.
    fn default() -> Self {
        Self {
            name: "car.hatchback",
            draw: 0,
            class: ObjectClass::Car,
            length_m: 4.2,
            width_m: 1.8,
            height_m: 1.5,
            front_axle_m: 1.3,
            rear_axle_m: -1.3,
            wheel_radius_m: 0.32,
            cruise_mps: 16.0,
            acceleration_mps2: 1.8,
            frequency: 1.0,
            parks: true,
            ridden: false,
            trailer: None,
        }
    }
}

impl VehicleSpec {
    /// Key in random choices: follows from [`Self::name`] and [`Self::draw`] alone, whatever else there is to choose
    /// from. Models of a fleet must differ in it.
    pub fn key(&self) -> u64 {
        Stream::named(self.draw, self.name, &[]).next_u64()
    }

    /// Length of its longest rigid part, metres: how tight it can turn.
    pub fn rigid_length_m(&self) -> f32 {
        let half = 0.5 * self.length_m;
        self.trailer.map_or(self.length_m, |t| (half - t.towing_rear_m).max(t.front_m + half))
    }
}

/// A vehicle that stands parked for the whole video.
#[derive(Debug, Clone, PartialEq)]
pub struct ParkedVehicle {
    /// Vehicle model and variant.
    pub vehicle: VehicleRef,
    /// Its pose.
    pub pose: Pose,
}
