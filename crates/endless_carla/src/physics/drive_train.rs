//! Engine, clutch and gears.
//!
//! The engine has no inertia: its speed is that of the wheels through the gear, and while that is less than what it idles
//! at, the clutch slips. Terms are those of PhysX, which CARLA has them from: torque over speed, and damping between a
//! rate at full throttle and one without. The latter brakes a tenth of what PhysX makes of it, where cars stop as if
//! braked when the driver lifts the foot (carla-simulator/carla#3256).

use super::input::Input;
use super::parameters::Parameters;

/// Share of the damping rates that the wheels feel.
const DAMPING: f64 = 0.1;
/// Share of the highest speed to which a full throttle lifts the engine while the clutch slips.
const LAUNCH: f64 = 0.3;
/// Between two shifts, seconds.
const BETWEEN_SHIFTS_S: f64 = 0.5;
/// rpm of one rad/s.
const RPM: f64 = 60.0 / std::f64::consts::TAU;

/// What changes in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct DriveTrain {
    /// -1 backwards, 0 neutral, from 1 on forwards.
    pub(super) gear: i32,
    /// Turns of the engine a minute.
    pub(super) rpm: f64,
    /// Until the gear is in.
    switching_s: f64,
    /// Since the last shift.
    settled_s: f64,
}

impl Default for DriveTrain {
    fn default() -> Self {
        Self { gear: 1, rpm: 0.0, switching_s: 0.0, settled_s: BETWEEN_SHIFTS_S }
    }
}

/// What wheels get from it, newtons at the ground.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Drive {
    /// Forwards is positive.
    pub(super) force_n: f64,
    /// Against the motion, whichever way that is.
    pub(super) drag_n: f64,
}

impl DriveTrain {
    /// Goes on by `dt_s` at a speed (forwards is positive).
    pub(super) fn step(&mut self, p: &Parameters, input: &Input, speed_mps: f64, dt_s: f64) -> Drive {
        self.choose(p, input, speed_mps);
        self.switching_s = (self.switching_s - dt_s).max(0.0);
        self.settled_s = (self.settled_s + dt_s).min(BETWEEN_SHIFTS_S);

        let idle = p.idle_rpm.max(LAUNCH * input.throttle * p.max_rpm * f64::from(u8::from(p.gears.len() > 1)));
        let Some(ratio) = self.ratio(p) else {
            self.rpm = idle;
            return Drive::default();
        };
        let direction = f64::from(self.gear.signum());
        let driven_rpm = direction * wheel_rpm(p, speed_mps) * ratio;
        self.rpm = driven_rpm.max(idle).min(1.5 * p.max_rpm);
        if self.switching_s > 0.0 {
            return Drive::default();
        }
        // Nothing is burnt above the highest speed; a soft limit keeps the speed there from trembling.
        let allowed = ((p.max_rpm - driven_rpm) / (0.03 * p.max_rpm)).clamp(0.0, 1.0);
        let rate = p.damping_no_throttle + (p.damping_full_throttle - p.damping_no_throttle) * input.throttle;
        let damping = DAMPING * rate.max(0.0) * driven_rpm.max(0.0) / RPM;
        let torque = input.throttle * allowed * p.torque.at(self.rpm).max(0.0) - damping;
        let force_n = torque * ratio / p.wheel_radius_m;
        if torque > 0.0 {
            Drive { force_n: direction * force_n, drag_n: 0.0 }
        } else {
            Drive { force_n: 0.0, drag_n: -force_n }
        }
    }

    fn ratio(&self, p: &Parameters) -> Option<f64> {
        match self.gear {
            0 => None,
            gear if gear < 0 => p.gears.first().map(|gear| gear.ratio),
            gear => p.gears.get(gear as usize - 1).map(|gear| gear.ratio),
        }
    }

    fn choose(&mut self, p: &Parameters, input: &Input, speed_mps: f64) {
        let highest = p.gears.len() as i32;
        let wanted = match input.gear {
            Some(gear) => gear.clamp(-1, highest),
            None if input.reverse => -1,
            None if self.gear < 1 => 1,
            None if p.shifts_itself => self.automatic(p, speed_mps),
            None => self.gear.min(highest),
        };
        // From neutral, or from backwards to forwards, it takes no time: cars that stand do not wait.
        if wanted != self.gear {
            let shifts = wanted >= 1 && self.gear >= 1;
            (self.switching_s, self.settled_s) = if shifts { (p.gear_switch_s, 0.0) } else { (0.0, BETWEEN_SHIFTS_S) };
            self.gear = wanted;
        }
    }

    /// The gear for a speed: the next above or below, none twice in half a second, and none that would shift back at once.
    fn automatic(&self, p: &Parameters, speed_mps: f64) -> i32 {
        let index = self.gear.max(1) as usize - 1;
        let (Some(gear), true) = (p.gears.get(index), self.settled_s >= BETWEEN_SHIFTS_S) else {
            return self.gear.min(p.gears.len() as i32);
        };
        let rpm = |ratio: f64| wheel_rpm(p, speed_mps.max(0.0)) * ratio;
        let higher = rpm(gear.ratio) > gear.up_rpm && index + 1 < p.gears.len();
        let below = index.checked_sub(1).and_then(|index| p.gears.get(index));
        let lower = below.is_some_and(|below| rpm(gear.ratio) < gear.down_rpm && rpm(below.ratio) < 0.9 * below.up_rpm);
        self.gear + i32::from(higher) - i32::from(lower && !higher)
    }
}

fn wheel_rpm(p: &Parameters, speed_mps: f64) -> f64 {
    RPM * speed_mps / p.wheel_radius_m
}
