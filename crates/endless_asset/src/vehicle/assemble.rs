//! Putting body and wheels together and measuring the result.

use super::{VehicleModel, VehicleSpec, Wheel};
use crate::Mesh;
use crate::shape::Sculpt;
use glam::Vec3;

/// Where a rider touches a two-wheeler: left side, object frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RiderFit {
    /// Top of the seat.
    pub(crate) seat: Vec3,
    /// Middle of the left grip.
    pub(crate) grip: Vec3,
    /// Sole of the left foot, under the ball.
    pub(crate) foot: Vec3,
    /// How much higher the right foot is (pedals) and further ahead.
    pub(crate) right_foot: Vec3,
    /// Forward lean of the trunk, radians.
    pub(crate) lean_rad: f32,
    /// How likely a helmet is worn.
    pub(crate) helmet: f64,
}

/// A finished vehicle and how it is ridden.
#[derive(Debug, Clone)]
pub(crate) struct Built {
    pub(crate) model: VehicleModel,
    pub(crate) fit: Option<RiderFit>,
}

/// A vehicle before it is centred and measured.
#[derive(Debug, Clone)]
pub(crate) struct Assembly {
    pub(crate) spec: VehicleSpec,
    pub(crate) body: Sculpt,
    pub(crate) wheels: Vec<Wheel>,
    pub(crate) wheel_mesh: Mesh,
    pub(crate) headlights: Vec<Vec3>,
    pub(crate) fit: Option<RiderFit>,
    wheel_radius: f32,
}

impl Assembly {
    pub(crate) fn new(spec: VehicleSpec, body: Sculpt, wheel_mesh: Mesh, wheel_radius: f32) -> Self {
        Self { spec, body, wheels: Vec::new(), wheel_mesh, headlights: Vec::new(), fit: None, wheel_radius }
    }

    /// Two wheels on an axle at x, at ±y.
    pub(crate) fn axle(&mut self, x: f32, y: f32, steered: bool) {
        for (y, mirrored) in [(y, false), (-y, true)] {
            self.wheels.push(Wheel { position: Vec3::new(x, y, self.wheel_radius), steered, mirrored });
        }
    }

    /// One wheel in the middle.
    pub(crate) fn single(&mut self, x: f32, steered: bool) {
        self.wheels.push(Wheel { position: Vec3::new(x, 0.0, self.wheel_radius), steered, mirrored: false });
    }

    /// Centres the vehicle on its footprint and writes its measures into the spec. The width is that of the body without
    /// mirrors.
    pub(crate) fn finish(mut self, width_m: f32) -> Built {
        let (mut low, mut high) = self.body.bounds();
        let (wheel_low, wheel_high) = self.wheel_mesh.bounds();
        for wheel in &self.wheels {
            low = low.min(wheel.position + wheel_low);
            high = high.max(wheel.position + wheel_high);
        }
        let shift = Vec3::new(-0.5 * (low.x + high.x), 0.0, 0.0);
        for wheel in &mut self.wheels {
            wheel.position += shift;
        }
        let xs = || self.wheels.iter().map(|w| w.position.x);
        let mut spec = self.spec;
        spec.length_m = high.x - low.x;
        spec.height_m = high.z;
        spec.width_m = width_m;
        spec.front_axle_m = xs().fold(f32::NEG_INFINITY, f32::max);
        spec.rear_axle_m = xs().fold(f32::INFINITY, f32::min);
        spec.wheel_radius_m = self.wheel_radius;
        let fit = self.fit.map(|f| RiderFit { seat: f.seat + shift, grip: f.grip + shift, foot: f.foot + shift, ..f });
        let model = VehicleModel {
            spec,
            body: self.body.at(shift).into_mesh(),
            wheels: self.wheels,
            wheel_mesh: self.wheel_mesh,
            headlights: self.headlights.iter().map(|&p| p + shift).collect(),
        };
        Built { model, fit }
    }
}
