//! CARLA's description of a vehicle: told and changed.

use super::VehicleBody;
use super::parameters::Parameters;
use super::sane::within;
use super::vehicle_body::direction;
use crate::wire::{GearPhysicsControl, Vector2D, Vector3D, VehiclePhysicsControl, WheelPhysicsControl};

/// More gears, wheels and points of curves than any vehicle has.
const MOST: usize = 256;

impl VehicleBody {
    /// What it is made of. Wheels have their places in CARLA's world (centimetres, y to the south); a friction that holds
    /// only where it is, as set by [`Self::set_friction_here`], is told in place of its own.
    pub fn physics_control(&self) -> VehiclePhysicsControl {
        let mut told = self.described.clone();
        let front_m = self.p.centre_m + self.p.axles[0].ahead_m;
        let rear_m = self.p.centre_m + self.p.axles[1].ahead_m;
        let half_m = 0.5 * self.p.track_m;
        let forward = direction(self.yaw_rad);
        let places = [(front_m, half_m), (front_m, -half_m), (rear_m, half_m), (rear_m, -half_m)];
        for (wheel, (ahead, aside)) in told.wheels.iter_mut().zip(places) {
            let at = self.position.truncate() + forward * ahead + forward.perp() * aside;
            let z = self.position.z + self.p.wheel_radius_m;
            wheel.position = Vector3D { x: (100.0 * at.x) as f32, y: (-100.0 * at.y) as f32, z: (100.0 * z) as f32 };
        }
        if let Some(friction) = self.friction_here {
            told.wheels.iter_mut().for_each(|wheel| wheel.tire_friction = friction as f32);
        }
        told
    }

    /// Makes it of other things. What is not finite stays as it was; a list that is empty where one is needed does too.
    pub fn set_physics_control(&mut self, control: &VehiclePhysicsControl) {
        self.described = merged(&self.described, control);
        self.p = Parameters::new(&self.shape, &self.described, self.friction_here);
        self.drive_train.gear = self.drive_train.gear.clamp(-1, self.p.gears.len() as i32);
    }

    /// CARLA's `tire_friction` of the ground where it is (`static.trigger.friction`), or `None` for that of its own tyres.
    pub fn set_friction_here(&mut self, friction: Option<f64>) {
        let friction = friction.map(|friction| within(friction, 0.0, 100.0, 0.0));
        if self.friction_here != friction {
            self.friction_here = friction;
            self.p = Parameters::new(&self.shape, &self.described, friction);
        }
    }
}

fn merged(old: &VehiclePhysicsControl, new: &VehiclePhysicsControl) -> VehiclePhysicsControl {
    let number = |new: f32, old: f32| if new.is_finite() { new } else { old };
    let place = |new: &Vector3D, old: &Vector3D| Vector3D {
        x: number(new.x, old.x),
        y: number(new.y, old.y),
        z: number(new.z, old.z),
    };
    let curve = |new: &[Vector2D], old: &[Vector2D]| -> Vec<Vector2D> {
        let finite = new.iter().filter(|point| point.x.is_finite() && point.y.is_finite());
        let points: Vec<_> = finite.take(MOST).cloned().collect();
        if points.is_empty() { old.to_vec() } else { points }
    };
    let gear = |new: &GearPhysicsControl| {
        let usual = GearPhysicsControl::default();
        GearPhysicsControl {
            ratio: number(new.ratio, usual.ratio),
            down_ratio: number(new.down_ratio, usual.down_ratio),
            up_ratio: number(new.up_ratio, usual.up_ratio),
        }
    };
    let wheel = |(index, new): (usize, &WheelPhysicsControl)| {
        let old = old.wheels.get(index).cloned().unwrap_or_default();
        WheelPhysicsControl {
            tire_friction: number(new.tire_friction, old.tire_friction),
            damping_rate: number(new.damping_rate, old.damping_rate),
            max_steer_angle: number(new.max_steer_angle, old.max_steer_angle),
            radius: number(new.radius, old.radius),
            max_brake_torque: number(new.max_brake_torque, old.max_brake_torque),
            max_handbrake_torque: number(new.max_handbrake_torque, old.max_handbrake_torque),
            lat_stiff_max_load: number(new.lat_stiff_max_load, old.lat_stiff_max_load),
            lat_stiff_value: number(new.lat_stiff_value, old.lat_stiff_value),
            long_stiff_value: number(new.long_stiff_value, old.long_stiff_value),
            position: place(&new.position, &old.position),
        }
    };
    let gears: Vec<_> = new.forward_gears.iter().take(MOST).map(gear).collect();
    let wheels: Vec<_> = new.wheels.iter().take(MOST).enumerate().map(wheel).collect();
    VehiclePhysicsControl {
        torque_curve: curve(&new.torque_curve, &old.torque_curve),
        max_rpm: number(new.max_rpm, old.max_rpm),
        moi: number(new.moi, old.moi),
        damping_rate_full_throttle: number(new.damping_rate_full_throttle, old.damping_rate_full_throttle),
        damping_rate_zero_throttle_clutch_engaged: number(
            new.damping_rate_zero_throttle_clutch_engaged,
            old.damping_rate_zero_throttle_clutch_engaged,
        ),
        damping_rate_zero_throttle_clutch_disengaged: number(
            new.damping_rate_zero_throttle_clutch_disengaged,
            old.damping_rate_zero_throttle_clutch_disengaged,
        ),
        use_gear_autobox: new.use_gear_autobox,
        gear_switch_time: number(new.gear_switch_time, old.gear_switch_time),
        clutch_strength: number(new.clutch_strength, old.clutch_strength),
        final_ratio: number(new.final_ratio, old.final_ratio),
        forward_gears: if gears.is_empty() { old.forward_gears.clone() } else { gears },
        mass: number(new.mass, old.mass),
        drag_coefficient: number(new.drag_coefficient, old.drag_coefficient),
        center_of_mass: place(&new.center_of_mass, &old.center_of_mass),
        steering_curve: curve(&new.steering_curve, &old.steering_curve),
        wheels: if wheels.is_empty() { old.wheels.clone() } else { wheels },
        use_sweep_wheel_collision: new.use_sweep_wheel_collision,
    }
}
