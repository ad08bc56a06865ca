//! What the equations of motion need of a vehicle: from its shape and CARLA's description of it.

use super::curve::Curve;
use super::sane::{within, within_f32};
use super::tyre::{USUAL_LONG_STIFFNESS, friction_coefficient};
use super::{GRAVITY_MPS2, VehicleShape};
use crate::wire::{VehiclePhysicsControl, WheelPhysicsControl};
use endless_world::math::f64::{atan, atan2};

/// Density of air, kg/m³.
const AIR: f64 = 1.2;
/// Friction of rolling, as a share of the load, of well gripping tyres.
const ROLLING: f64 = 0.012;

/// A gear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Gear {
    /// Turns of the engine for one of the wheels.
    pub(super) ratio: f64,
    /// rpm below which it shifts down.
    pub(super) down_rpm: f64,
    /// rpm above which it shifts up.
    pub(super) up_rpm: f64,
}

/// An axle of the bicycle model.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axle {
    /// Ahead of the centre of mass, metres.
    pub(super) ahead_m: f64,
    /// Coefficient.
    pub(super) friction: f64,
    /// CARLA's `tire_friction`, mean of its wheels.
    pub(super) tire_friction: f64,
    /// CARLA's `lat_stiff_value`.
    pub(super) stiffness: f64,
    /// CARLA's `long_stiff_value`.
    pub(super) long_stiffness: f64,
    /// How many wheels it has.
    pub(super) wheels: f64,
    /// Load as a share of that at rest, above which it becomes no stiffer.
    pub(super) max_load: f64,
    /// Newtons at the ground.
    pub(super) brake_n: f64,
    /// Newtons at the ground.
    pub(super) hand_brake_n: f64,
    /// Share of the driving force.
    pub(super) driven: f64,
    /// Share of the weight at rest.
    pub(super) weight: f64,
}

/// All of it, in SI units; nothing in it is not finite.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Parameters {
    pub(super) mass_kg: f64,
    /// About the vertical through the centre of mass, kg m².
    pub(super) yaw_inertia: f64,
    /// Ahead of the origin.
    pub(super) centre_m: f64,
    /// Above the ground.
    pub(super) centre_height_m: f64,
    /// Front and rear.
    pub(super) axles: [Axle; 2],
    pub(super) wheelbase_m: f64,
    /// Between the middles of left and right wheels.
    pub(super) track_m: f64,
    pub(super) wheel_radius_m: f64,
    /// Of the front wheels for a whole turn of the steering wheel, before [`Self::lock_rad`].
    pub(super) max_steer_rad: f64,
    /// No wheel turns further. CARLA's 70 degrees are what its steering is scaled by, and more than any car has: small
    /// angles are as CARLA's, and the turning circle is that of the road.
    pub(super) lock_rad: f64,
    /// Share of the steering angle over km/h.
    pub(super) steering: Curve,
    /// Newtons per (m/s)².
    pub(super) air_drag: f64,
    /// Share of the load.
    pub(super) rolling: f64,
    /// N m over rpm.
    pub(super) torque: Curve,
    pub(super) max_rpm: f64,
    pub(super) idle_rpm: f64,
    pub(super) damping_full_throttle: f64,
    pub(super) damping_no_throttle: f64,
    pub(super) gears: Vec<Gear>,
    pub(super) gear_switch_s: f64,
    pub(super) shifts_itself: bool,
    /// A two-wheeler.
    pub(super) leans: bool,
    /// Factor on nodding and leaning: heavier vehicles do more of it.
    pub(super) softness: f64,
}

/// Radius of the circle that the outer front wheel draws at full lock, by the wheelbase.
const TURNING_CIRCLE: f64 = 1.9;
/// Steering lock of two-wheelers, radians.
const TWO_WHEELER_LOCK: f64 = 0.7;

fn mean(wheels: &[&WheelPhysicsControl], of: impl Fn(&WheelPhysicsControl) -> f64) -> f64 {
    wheels.iter().map(|wheel| of(wheel)).sum::<f64>() / wheels.len().max(1) as f64
}

impl Parameters {
    /// `tire_friction`: that of all wheels in place of what the description has.
    pub(super) fn new(shape: &VehicleShape, control: &VehiclePhysicsControl, tire_friction: Option<f64>) -> Self {
        let length_m = within(shape.length_m, 0.5, 60.0, 4.5);
        let width_m = within(shape.width_m, 0.2, 6.0, 1.8);
        let height_m = within(shape.height_m, 0.3, 10.0, 1.5);
        let front_m = within(shape.front_axle_m, 0.1, 0.5 * length_m, 0.3 * length_m);
        let rear_m = within(shape.rear_axle_m, -0.5 * length_m, -0.1, -0.3 * length_m);
        let wheelbase_m = front_m - rear_m;
        let leans = shape.two_wheeled();
        let track_m = if leans { 0.0 } else { 0.86 * width_m };

        let mass_kg = within_f32(control.mass, 1.0, 1e6, 1500.0);
        // Always between the axles: no vehicle stands on one.
        let middle_m = 0.5 * (front_m + rear_m);
        let offset_m = within_f32(control.center_of_mass.x, -0.3 * wheelbase_m, 0.3 * wheelbase_m, 0.0);
        let centre_m = middle_m + offset_m;
        let lower = within_f32(control.center_of_mass.z, -0.25 * height_m, 0.4 * height_m, 0.0);
        let centre_height_m = (0.38 * height_m + lower).max(0.1);
        let (to_front_m, to_rear_m) = (front_m - centre_m, centre_m - rear_m);
        let yaw_inertia = mass_kg * (length_m * length_m + width_m * width_m) / 12.0;

        let wheel_radius_m = wheel_radius(control, shape);
        let axle = |front: bool| {
            let mine =
                |index: usize| if control.wheels.len() < 4 { (index == 0) == front } else { (index < 2) == front };
            let wheels: Vec<_> = control.wheels.iter().enumerate().filter(|(i, _)| mine(*i)).map(|(_, w)| w).collect();
            let told = mean(&wheels, |wheel| within_f32(wheel.tire_friction, 0.0, 100.0, 2.0));
            let tire_friction = within(tire_friction.unwrap_or(told), 0.0, 100.0, 2.0);
            let newtons = |of: fn(&WheelPhysicsControl) -> f32| {
                let torque = wheels.iter().map(|wheel| within_f32(of(wheel), 0.0, 1e7, 0.0)).sum::<f64>();
                torque / wheel_radius_m
            };
            // Rear tyres hold a little more, as they do by their pressure: no vehicle turns round by itself.
            let rear = if front { 1.0 } else { 1.08 };
            Axle {
                ahead_m: if front { to_front_m } else { -to_rear_m },
                friction: rear * friction_coefficient(tire_friction),
                tire_friction,
                stiffness: rear * rear * mean(&wheels, |wheel| within_f32(wheel.lat_stiff_value, 0.0, 1000.0, 17.0)),
                long_stiffness: mean(&wheels, |wheel| {
                    within_f32(wheel.long_stiff_value, 0.0, 1e6, USUAL_LONG_STIFFNESS)
                }),
                wheels: wheels.len().max(1) as f64,
                max_load: mean(&wheels, |wheel| within_f32(wheel.lat_stiff_max_load, 0.1, 100.0, 2.0)),
                brake_n: newtons(|wheel| wheel.max_brake_torque),
                hand_brake_n: newtons(|wheel| wheel.max_handbrake_torque),
                driven: if shape.class == endless_world::ObjectClass::Car { 0.5 } else { f64::from(u8::from(!front)) },
                weight: if front { to_rear_m / wheelbase_m } else { to_front_m / wheelbase_m },
            }
        };
        let axles = [axle(true), axle(false)];

        let max_rpm = within_f32(control.max_rpm, 1.0, 1e6, 6000.0);
        let final_ratio = within_f32(control.final_ratio, 0.01, 1000.0, 4.0);
        let mut gears: Vec<_> = control
            .forward_gears
            .iter()
            .take(64)
            .map(|gear| Gear {
                ratio: final_ratio * within_f32(gear.ratio, 0.01, 1000.0, 1.0),
                down_rpm: max_rpm * within_f32(gear.down_ratio, 0.0, 1.0, 0.5),
                up_rpm: max_rpm * within_f32(gear.up_ratio, 0.0, 1.0, 0.65),
            })
            .collect();
        if gears.is_empty() {
            gears.push(Gear { ratio: final_ratio, down_rpm: 0.0, up_rpm: max_rpm });
        }

        let outer_m = TURNING_CIRCLE * wheelbase_m;
        let inner_m = (outer_m * outer_m - wheelbase_m * wheelbase_m).max(0.0).sqrt() - 0.5 * track_m;
        let steered = control.wheels.iter().map(|wheel| within_f32(wheel.max_steer_angle, 0.0, 89.0, 0.0));
        let damping = |rate: f32| within_f32(rate, 0.0, 1000.0, 0.0);
        Self {
            mass_kg,
            yaw_inertia,
            centre_m,
            centre_height_m,
            axles,
            wheelbase_m,
            track_m,
            wheel_radius_m,
            max_steer_rad: steered.fold(0.0, f64::max).to_radians(),
            lock_rad: if leans { TWO_WHEELER_LOCK } else { atan(wheelbase_m / inner_m.max(0.1)) },
            steering: Curve::new(&control.steering_curve, 1.0),
            air_drag: 0.5 * AIR * within_f32(control.drag_coefficient, 0.0, 1000.0, 0.3) * 0.85 * width_m * height_m,
            rolling: ROLLING * axles[0].tire_friction.min(1.0),
            torque: Curve::new(&control.torque_curve, 0.0),
            max_rpm,
            idle_rpm: if gears.len() > 1 { (0.13 * max_rpm).min(850.0) } else { 0.0 },
            damping_full_throttle: damping(control.damping_rate_full_throttle),
            damping_no_throttle: damping(control.damping_rate_zero_throttle_clutch_engaged),
            gears,
            gear_switch_s: within_f32(control.gear_switch_time, 0.0, 5.0, 0.0),
            shifts_itself: control.use_gear_autobox,
            leans,
            softness: within(mass_kg / 6000.0, 0.8, 1.6, 1.0),
        }
    }

    /// Angle of the front wheels, radians to the left, that `steer` (-1 to 1, right is positive) asks for at a speed.
    pub(super) fn steering_angle(&self, steer: f64, speed_mps: f64) -> f64 {
        let share = within(self.steering.at(3.6 * speed_mps.abs()), 0.0, 1.0, 1.0);
        within(-steer * self.max_steer_rad * share, -self.lock_rad, self.lock_rad, 0.0)
    }

    /// Angles of the left and the right front wheel, of which [`Self::steering_angle`] is what the bicycle model has.
    pub(super) fn wheel_angles(&self, steer_rad: f64) -> [f64; 2] {
        let (sin, cos) = endless_world::math::f64::sin_cos(steer_rad);
        let half_m = 0.5 * self.track_m;
        [-half_m, half_m].map(|aside| atan2(self.wheelbase_m * sin, self.wheelbase_m * cos + aside * sin))
    }

    /// Weight, newtons.
    pub(super) fn weight_n(&self) -> f64 {
        self.mass_kg * GRAVITY_MPS2
    }
}

fn wheel_radius(control: &VehiclePhysicsControl, shape: &VehicleShape) -> f64 {
    let otherwise = within(shape.wheel_radius_m, 0.05, 2.0, 0.33);
    control.wheels.first().map_or(otherwise, |wheel| 0.01 * within_f32(wheel.radius, 5.0, 200.0, 100.0 * otherwise))
}
