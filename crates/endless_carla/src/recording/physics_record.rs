//! What a vehicle is made of, as recordings store it: all but the time of shifting, which the format has no place for.

use super::bytes::{RecordingError, Stored, read_list, write_list};
use crate::wire::{GearPhysicsControl, VehiclePhysicsControl, WheelPhysicsControl};

/// What a vehicle is made of.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RecordedPhysics {
    /// Whose.
    pub actor: u32,
    /// Of what.
    pub physics: VehiclePhysicsControl,
}

fn write_counted<T: Stored>(list: &[T], out: &mut Vec<u8>) {
    (list.len() as u32).write(out);
    write_list(list, out);
}

fn read_counted<T: Stored>(bytes: &mut &[u8]) -> Result<Vec<T>, RecordingError> {
    let count = u32::read(bytes)?;
    read_list(count as usize, bytes)
}

impl Stored for RecordedPhysics {
    fn write(&self, out: &mut Vec<u8>) {
        let p = &self.physics;
        self.actor.write(out);
        [
            p.max_rpm,
            p.moi,
            p.damping_rate_full_throttle,
            p.damping_rate_zero_throttle_clutch_engaged,
            p.damping_rate_zero_throttle_clutch_disengaged,
        ]
        .write(out);
        p.use_gear_autobox.write(out);
        [p.clutch_strength, p.final_ratio, p.mass, p.drag_coefficient].write(out);
        p.center_of_mass.write(out);
        write_counted(&p.torque_curve, out);
        write_counted(&p.forward_gears, out);
        write_counted(&p.steering_curve, out);
        write_counted(&p.wheels, out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        let actor = u32::read(bytes)?;
        let [max_rpm, moi, full_throttle, clutch_engaged, clutch_disengaged] = Stored::read(bytes)?;
        let use_gear_autobox = bool::read(bytes)?;
        let [clutch_strength, final_ratio, mass, drag_coefficient] = Stored::read(bytes)?;
        let physics = VehiclePhysicsControl {
            max_rpm,
            moi,
            damping_rate_full_throttle: full_throttle,
            damping_rate_zero_throttle_clutch_engaged: clutch_engaged,
            damping_rate_zero_throttle_clutch_disengaged: clutch_disengaged,
            use_gear_autobox,
            clutch_strength,
            final_ratio,
            mass,
            drag_coefficient,
            center_of_mass: Stored::read(bytes)?,
            torque_curve: read_counted(bytes)?,
            forward_gears: read_counted(bytes)?,
            steering_curve: read_counted(bytes)?,
            wheels: read_counted(bytes)?,
            ..VehiclePhysicsControl::default()
        };
        Ok(Self { actor, physics })
    }
}

impl Stored for GearPhysicsControl {
    fn write(&self, out: &mut Vec<u8>) {
        [self.ratio, self.down_ratio, self.up_ratio].write(out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        <[f32; 3]>::read(bytes).map(|[ratio, down_ratio, up_ratio]| Self { ratio, down_ratio, up_ratio })
    }
}

impl Stored for WheelPhysicsControl {
    fn write(&self, out: &mut Vec<u8>) {
        [self.tire_friction, self.damping_rate, self.max_steer_angle, self.radius].write(out);
        [self.max_brake_torque, self.max_handbrake_torque].write(out);
        [self.lat_stiff_max_load, self.lat_stiff_value, self.long_stiff_value].write(out);
        self.position.write(out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        let [tire_friction, damping_rate, max_steer_angle, radius] = Stored::read(bytes)?;
        let [max_brake_torque, max_handbrake_torque] = Stored::read(bytes)?;
        let [lat_stiff_max_load, lat_stiff_value, long_stiff_value] = Stored::read(bytes)?;
        Ok(Self {
            tire_friction,
            damping_rate,
            max_steer_angle,
            radius,
            max_brake_torque,
            max_handbrake_torque,
            lat_stiff_max_load,
            lat_stiff_value,
            long_stiff_value,
            position: Stored::read(bytes)?,
        })
    }
}
