//! What a vehicle reports of itself.

use super::VehicleBody;
use crate::wire::{VehicleTelemetryData, WheelTelemetryData};

impl VehicleBody {
    /// CARLA's telemetry of the last step. The bicycle model knows axles: each wheel has half of its own.
    pub fn telemetry(&self) -> VehicleTelemetryData {
        let p = &self.p;
        let speed_mps = self.speed_mps();
        let planar_mps = self.planar.velocity.length();
        let wheel = |index: usize| {
            let axle = usize::from(index >= 2);
            let (state, is) = (&self.axles[axle], &p.axles[axle]);
            let load_n = 0.5 * state.load_n;
            let (along_n, across_n) = (0.5 * state.along_n, 0.5 * state.across_n);
            let of_load = |force_n: f64| if load_n > 0.0 { force_n / load_n } else { 0.0 };
            let stiffness = self.described.wheels.get(index).map_or(1000.0, |wheel| f64::from(wheel.long_stiff_value));
            WheelTelemetryData {
                tire_friction: is.tire_friction as f32,
                lat_slip: state.slip_rad as f32,
                // PhysX: force along is stiffness by unit of gravity, times gravity, times slip.
                long_slip: (along_n / (stiffness.abs().max(1.0) * super::GRAVITY_MPS2)).clamp(-1.0, 1.0) as f32,
                omega: (speed_mps / p.wheel_radius_m) as f32,
                tire_load: load_n as f32,
                normalized_tire_load: (load_n / (0.5 * is.weight * p.weight_n()).max(1e-9)) as f32,
                torque: (along_n * p.wheel_radius_m) as f32,
                long_force: along_n as f32,
                lat_force: -across_n as f32,
                normalized_long_force: of_load(along_n) as f32,
                normalized_lat_force: of_load(-across_n) as f32,
            }
        };
        VehicleTelemetryData {
            speed: speed_mps as f32,
            steer: self.input.steer as f32,
            throttle: self.input.throttle as f32,
            brake: self.input.brake as f32,
            engine_rpm: self.engine_rpm() as f32,
            gear: self.gear(),
            drag: (p.air_drag * planar_mps * planar_mps) as f32,
            wheels: (0..self.described.wheels.len()).map(wheel).collect(),
        }
    }
}
