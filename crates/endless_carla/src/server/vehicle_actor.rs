//! Vehicles.

use super::call_error::CallError;
use crate::blueprint::{Attributes, VehicleBlueprint};
use crate::frames;
use crate::physics::{AckermannController, VehicleBody, VehicleShape};
use crate::wire::{
    AckermannControllerSettings, Transform, Vector3D, VehicleAckermannControl, VehicleControl, VehiclePhysicsControl,
    VehicleTelemetryData,
};
use endless_asset::Catalogue;
use endless_world::{ObjectClass, VehicleLights, VehicleMotion, VehicleRef};

/// A vehicle.
pub(super) struct VehicleActor {
    pub(super) asset: VehicleRef,
    pub(super) class: ObjectClass,
    /// Somebody sits on it.
    pub(super) is_ridden: bool,
    pub(super) body: VehicleBody,
    pub(super) control: VehicleControl,
    /// CARLA's `sticky_control`: a control holds until the next; otherwise for a frame only.
    is_sticky: bool,
    /// No frame has passed since the last control.
    is_control_new: bool,
    ackermann: Option<VehicleAckermannControl>,
    controller: AckermannController,
    lights: VehicleLights,
    /// As clients have turned its wheels, for those that no physics turns: to the right, and forwards, degrees.
    wheels_set: [WheelSet; 4],
}

/// A wheel as clients have turned it.
#[derive(Debug, Clone, Copy, Default)]
struct WheelSet {
    steer_deg: Option<f32>,
    pitch_deg: f32,
}

impl VehicleActor {
    pub(super) fn new(
        blueprint: &VehicleBlueprint,
        attributes: &Attributes<'_>,
        catalogue: &Catalogue,
        number: u32,
        transform: &Transform,
    ) -> Result<Self, CallError> {
        let color = if attributes.has("color") { Some(attributes.color("color")?) } else { None };
        let model = catalogue.vehicle(blueprint.model).ok_or_else(|| CallError::refused("there is no such vehicle"))?;
        let spec = &model.spec;
        let asset = blueprint.reference(catalogue, color, number);
        let shape = VehicleShape {
            mass_kg: Some(blueprint.mass_kg.into()),
            electric: blueprint.special_type == "electric",
            ..VehicleShape::from(spec)
        };
        Ok(Self {
            asset,
            class: spec.class,
            is_ridden: spec.ridden,
            body: VehicleBody::new(shape, frames::place(transform)),
            control: VehicleControl::default(),
            is_sticky: attributes.flag("sticky_control")?,
            is_control_new: false,
            ackermann: None,
            controller: AckermannController::default(),
            lights: VehicleLights::empty(),
            wheels_set: <[WheelSet; 4]>::default(),
        })
    }

    /// What is seen of it.
    pub(super) fn motion(&self) -> VehicleMotion {
        let mut lights = self.lights;
        // Brakes and gears switch these by themselves.
        lights.set(VehicleLights::BRAKE, lights.contains(VehicleLights::BRAKE) || self.control.brake > 0.05);
        lights.set(VehicleLights::REVERSE, lights.contains(VehicleLights::REVERSE) || self.control.reverse);
        let [left, right] =
            [0, u8::from(!self.class.two_wheeled())].map(|wheel| -self.wheel_steer_deg(wheel).to_radians());
        VehicleMotion {
            speed_mps: self.body.speed_mps() as f32,
            rolled_m: self.body.rolled_m() as f32,
            steer_rad: 0.5 * (left + right),
            hitch_rad: 0.0,
            lights,
        }
    }

    /// Before a step: its pedals, where a speed and an angle are wanted of it.
    pub(super) fn drive(&mut self, step_s: f64) {
        if !self.is_sticky && !std::mem::take(&mut self.is_control_new) {
            self.control = VehicleControl::default();
        }
        if let Some(wanted) = &self.ackermann {
            self.control = self.controller.run(wanted, &self.body, step_s);
        }
    }

    pub(super) fn apply_control(&mut self, control: &VehicleControl) {
        self.ackermann = None;
        self.is_control_new = true;
        self.control = control.clone();
    }

    pub(super) fn apply_ackermann(&mut self, control: &VehicleAckermannControl) {
        if self.ackermann.is_none() {
            self.controller.reset();
        }
        self.ackermann = Some(control.clone());
    }

    pub(super) fn ackermann_settings(&self) -> AckermannControllerSettings {
        self.controller.settings().clone()
    }

    pub(super) fn set_ackermann_settings(&mut self, settings: &AckermannControllerSettings) {
        self.controller.set_settings(settings);
    }

    pub(super) fn physics_control(&self) -> VehiclePhysicsControl {
        self.body.physics_control()
    }

    pub(super) fn set_physics_control(&mut self, control: &VehiclePhysicsControl) {
        self.body.set_physics_control(control);
    }

    pub(super) fn telemetry(&self) -> VehicleTelemetryData {
        self.body.telemetry()
    }

    /// Keeps a velocity in its own frame, or lets go of it.
    pub(super) fn hold_velocity(&mut self, velocity: Option<&Vector3D>) {
        self.body.set_constant_velocity(velocity.map(|velocity| frames::from_carla(velocity).as_dvec3()));
    }

    pub(super) fn lights(&self) -> u32 {
        self.lights.bits()
    }

    pub(super) fn set_lights(&mut self, flags: u32) {
        self.lights = VehicleLights::from_bits_retain(flags);
    }

    /// Of a wheel (front left, front right, rear left, rear right), degrees to the right.
    pub(super) fn wheel_steer_deg(&self, wheel: u8) -> f32 {
        let wheel = usize::from(wheel) & 3;
        let angles = self.body.wheel_angles_rad();
        let set = self.wheels_set[wheel].steer_deg.filter(|_| !self.body.simulated());
        set.unwrap_or_else(|| -angles[wheel].to_degrees() as f32)
    }

    /// Turns a wheel of a vehicle that no physics moves, degrees to the right.
    pub(super) fn set_wheel_steer(&mut self, wheel: u8, degrees: f32) {
        self.wheels_set[usize::from(wheel) & 3].steer_deg = Some(degrees).filter(|degrees| degrees.is_finite());
    }

    /// How far a wheel was rolled by [`Self::set_wheel_pitch`], degrees.
    pub(super) fn wheel_pitch_deg(&self, wheel: u8) -> f32 {
        self.wheels_set[usize::from(wheel) & 3].pitch_deg
    }

    /// Rolls a wheel: it is told again, and not drawn, for wheels are drawn by the way that they have gone.
    pub(super) fn set_wheel_pitch(&mut self, wheel: u8, degrees: f32) {
        self.wheels_set[usize::from(wheel) & 3].pitch_deg = if degrees.is_finite() { degrees } else { 0.0 };
    }
}
