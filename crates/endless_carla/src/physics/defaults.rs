//! What vehicles are made of unless a client says otherwise, in CARLA's terms.
//!
//! Masses and measures are those of the vehicle; engines, gears and brakes are chosen so that its class drives as it does
//! on the road (see the tests of [`super::VehicleBody`] for the figures).

use super::VehicleShape;
use crate::wire::{GearPhysicsControl, Location, Vector2D, VehiclePhysicsControl, WheelPhysicsControl};
use endless_world::ObjectClass;

/// Engine and gears.
struct Engine {
    /// N m over the share of [`Self::max_rpm`].
    torque: Vec<(f64, f64)>,
    max_rpm: f64,
    gears: &'static [f32],
    final_ratio: f64,
    gear_switch_time_s: f64,
}

fn engine(shape: &VehicleShape, mass_kg: f64) -> Engine {
    // The highest torque that is given at all speeds, of a combustion engine.
    let combustion = |highest: f64| vec![(0.0, 0.75 * highest), (0.3, highest), (0.7, highest), (1.0, 0.6 * highest)];
    match shape.class {
        // A strong rider: 45 N m of pull at the wheel, nothing left to give at 36 km/h.
        ObjectClass::Bicycle | ObjectClass::Rider => Engine {
            torque: vec![(0.0, 45.0), (0.5, 30.0), (1.0, 0.0)],
            max_rpm: 10.0 / (shape.wheel_radius_m.max(0.1) * std::f64::consts::TAU) * 60.0,
            gears: &[1.0],
            final_ratio: 1.0,
            gear_switch_time_s: 0.0,
        },
        ObjectClass::Motorcycle => Engine {
            torque: combustion(0.24 * mass_kg),
            max_rpm: 9000.0,
            gears: &[2.7, 1.9, 1.45, 1.2, 1.05],
            final_ratio: 5.0,
            gear_switch_time_s: 0.15,
        },
        ObjectClass::Truck | ObjectClass::Bus => Engine {
            torque: combustion(0.1 * mass_kg),
            max_rpm: 2600.0,
            gears: &[6.4, 3.6, 2.2, 1.45, 1.0],
            final_ratio: 4.0,
            gear_switch_time_s: 0.4,
        },
        _ if shape.electric => Engine {
            torque: vec![(0.0, 0.22 * mass_kg), (0.38, 0.22 * mass_kg), (0.65, 0.13 * mass_kg), (1.0, 0.07 * mass_kg)],
            max_rpm: 15_000.0,
            gears: &[1.0],
            final_ratio: 9.0,
            gear_switch_time_s: 0.0,
        },
        _ => Engine {
            torque: combustion(0.17 * mass_kg),
            max_rpm: 6000.0,
            gears: &[3.6, 2.1, 1.45, 1.1, 0.9, 0.75],
            final_ratio: 3.9,
            gear_switch_time_s: 0.2,
        },
    }
}

/// CARLA's description of a vehicle of this shape.
pub(super) fn physics_control(shape: &VehicleShape) -> VehiclePhysicsControl {
    let mass_kg = shape.usual_mass_kg();
    let engine = engine(shape, mass_kg);
    let heavy = matches!(shape.class, ObjectClass::Truck | ObjectClass::Bus);
    let radius_m = shape.wheel_radius_m;
    // Brakes that would do for 1.1 g if the tyres held; those of bicycles 0.6 g.
    let braking = if matches!(shape.class, ObjectClass::Bicycle | ObjectClass::Rider) { 6.0 } else { 11.0 };
    let brake_nm = (0.25 * mass_kg * braking * radius_m) as f32;
    let wheel = |front: bool| WheelPhysicsControl {
        tire_friction: if heavy { 2.0 } else { 3.5 },
        damping_rate: 0.25,
        max_steer_angle: if front { 70.0 } else { 0.0 },
        radius: (100.0 * radius_m) as f32,
        max_brake_torque: brake_nm,
        max_handbrake_torque: if front { 0.0 } else { 2.0 * brake_nm },
        lat_stiff_max_load: 3.0,
        lat_stiff_value: 20.0,
        long_stiff_value: 3000.0,
        position: Location::default(),
    };
    let last = engine.gears.len().saturating_sub(1);
    let gear = |(index, &ratio): (usize, &f32)| GearPhysicsControl {
        ratio,
        down_ratio: 0.35,
        up_ratio: if index < last { 0.8 } else { 1.0 },
    };
    let at = |&(share, torque_nm): &(f64, f64)| Vector2D { x: (share * engine.max_rpm) as f32, y: torque_nm as f32 };
    // As PhysX has it for a car of this mass; nobody's legs brake a bicycle.
    let damping = if matches!(shape.class, ObjectClass::Bicycle | ObjectClass::Rider) { 0.0 } else { mass_kg / 1500.0 };
    let usual = VehiclePhysicsControl::default();
    VehiclePhysicsControl {
        damping_rate_full_throttle: usual.damping_rate_full_throttle * damping as f32,
        damping_rate_zero_throttle_clutch_engaged: usual.damping_rate_zero_throttle_clutch_engaged * damping as f32,
        damping_rate_zero_throttle_clutch_disengaged: usual.damping_rate_zero_throttle_clutch_disengaged
            * damping as f32,
        torque_curve: engine.torque.iter().map(at).collect(),
        max_rpm: engine.max_rpm as f32,
        gear_switch_time: engine.gear_switch_time_s as f32,
        final_ratio: engine.final_ratio as f32,
        forward_gears: engine.gears.iter().enumerate().map(gear).collect(),
        mass: mass_kg as f32,
        drag_coefficient: match shape.class {
            ObjectClass::Truck | ObjectClass::Bus => 0.6,
            ObjectClass::Motorcycle => 0.6,
            ObjectClass::Bicycle | ObjectClass::Rider => 0.9,
            ObjectClass::Van => 0.38,
            ObjectClass::Car | ObjectClass::Pedestrian => {
                if shape.electric {
                    0.25
                } else {
                    0.33
                }
            }
        },
        steering_curve: [(0.0, 1.0), (20.0, 0.9), (60.0, 0.8), (120.0, 0.7)].map(|(x, y)| Vector2D { x, y }).to_vec(),
        wheels: vec![wheel(true), wheel(true), wheel(false), wheel(false)],
        ..usual
    }
}
