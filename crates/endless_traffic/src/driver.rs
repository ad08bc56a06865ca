//! How a driver accelerates: the Intelligent Driver Model (Treiber, Hennecke, Helbing 2000, "Congested traffic states
//! in empirical observations and microscopic simulations").

use crate::settings::DrivingCondition;
use crate::weather_pace::{pace_in, sight_speed_mps};
use endless_world::{ObjectClass, Stream, VehicleSpec};

/// Hardest braking, m/s².
pub(crate) const HARDEST_BRAKING: f64 = 7.5;

/// Largest factor on speed limits that a driver has.
pub(crate) const MOST_LIMIT_FACTOR: f64 = 1.12;
/// Time headways of drivers, seconds. Treiber and Kesting (2013, "Traffic Flow Dynamics", table 11.2) have 1.0 s in town and
/// 1.5 s on highways; with these a queue discharges at 1,800 to 1,900 vehicles an hour and lane, as the Highway Capacity Manual
/// (2016, chapter 19) has it.
const HEADWAY_S: [f64; 2] = [0.75, 1.4];
/// Gaps between bumpers in a standing queue, metres: with cars of 4.5 m, 120 to 150 vehicles stand on a kilometre (the same,
/// table 8.1 and 11.2).
pub(crate) const STANDING_GAP_M: [f64; 2] = [1.9, 3.1];
/// Speeds on a free street as shares of its limit: on urban streets the mean is about the limit, and the 85th percentile 10 %
/// above it (Fitzpatrick et al. 2003, NCHRP Report 504).
const LIMIT_FACTOR: [f64; 2] = [0.88, MOST_LIMIT_FACTOR];

/// Factor on the speeds at which drivers of this aggressiveness, 0 to 1, take a free street.
pub(crate) fn pace_of(aggressiveness: f64) -> f64 {
    1.0 + 0.15 * (2.0 * aggressiveness - 1.0)
}

/// One driver's habits.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Driver {
    /// Comfortable acceleration, m/s².
    pub(crate) accelerate: f64,
    /// Comfortable braking, m/s².
    pub(crate) brake: f64,
    /// Time headway, seconds.
    pub(crate) headway_s: f64,
    /// Gap kept when standing, metres.
    pub(crate) standing_gap_m: f64,
    /// Factor on speed limits.
    pub(crate) limit_factor: f64,
    /// Speed on an empty road, m/s.
    pub(crate) cruise_mps: f64,
    /// Speed at which they see far enough, m/s.
    pub(crate) sight_mps: f64,
    /// Factor on the speed through bends.
    pub(crate) bend_factor: f64,
    /// Place in the lane, metres left of its middle.
    pub(crate) lateral_m: f64,
    /// Politeness of lane changes (MOBIL's p).
    pub(crate) politeness: f64,
    /// Factor on the time that is kept to those with priority.
    pub(crate) gap_factor: f64,
}

impl Driver {
    /// Of a scene's drivers, `aggressiveness` from 0 to 1: at 0.5 they are as published distributions have them.
    pub(crate) fn new(
        spec: &VehicleSpec,
        condition: &DrivingCondition,
        aggressiveness: f64,
        stream: &mut Stream,
    ) -> Self {
        let heavy = matches!(spec.class, ObjectClass::Truck | ObjectClass::Bus);
        let pace = pace_in(condition);
        let lateral_m = match spec.class {
            ObjectClass::Bicycle => stream.range_f64(-0.95, -0.6),
            ObjectClass::Motorcycle => stream.range_f64(-0.4, 0.4),
            ObjectClass::Truck | ObjectClass::Bus => stream.range_f64(-0.05, 0.05),
            _ => stream.range_f64(-0.15, 0.15),
        };
        let bold = 2.0 * aggressiveness - 1.0;
        Self {
            accelerate: f64::from(spec.acceleration_mps2).clamp(0.5, 2.8)
                * stream.range_f64(0.85, 1.1)
                * (1.0 + 0.2 * bold),
            brake: stream.range_f64(1.6, 2.3) * (1.0 + 0.2 * bold),
            headway_s: stream.range_f64(HEADWAY_S[0], HEADWAY_S[1]) * (1.0 - 0.4 * bold) / pace
                + if heavy { 0.3 } else { 0.0 },
            standing_gap_m: stream.range_f64(STANDING_GAP_M[0], STANDING_GAP_M[1]) * (1.0 - 0.3 * bold),
            limit_factor: stream.range_f64(LIMIT_FACTOR[0], LIMIT_FACTOR[1]) * pace_of(aggressiveness) * pace,
            cruise_mps: f64::from(spec.cruise_mps) * stream.range_f64(0.9, 1.1) * pace,
            sight_mps: sight_speed_mps(condition),
            bend_factor: stream.range_f64(0.88, 1.1) * (1.0 + 0.06 * bold) * pace * if heavy { 0.82 } else { 1.0 },
            lateral_m,
            politeness: stream.range_f64(0.1, 0.5) * (1.0 - 0.9 * bold),
            gap_factor: 1.0 - 0.35 * bold,
        }
    }

    /// In weather that was like this, and is now.
    pub(crate) fn adapt(&mut self, from: &DrivingCondition, to: &DrivingCondition) {
        let change = pace_in(to) / pace_in(from);
        self.sight_mps = sight_speed_mps(to);
        self.headway_s /= change;
        self.limit_factor *= change;
        self.cruise_mps *= change;
        self.bend_factor *= change;
    }

    /// On an open road, with a speed to reach.
    pub(crate) fn free(&self, speed: f64, wanted: f64) -> f64 {
        if speed > wanted {
            return -((speed - wanted) * 2.0).min(self.brake * 1.5);
        }
        let ratio = speed / wanted.max(0.1);
        self.accelerate * (1.0 - ratio * ratio * ratio * ratio)
    }

    /// Behind something `gap` metres ahead that moves at `leader_speed`.
    pub(crate) fn follow(&self, speed: f64, gap: f64, leader_speed: f64) -> f64 {
        self.react(speed, gap, leader_speed, self.standing_gap_m, self.headway_s)
    }

    /// Towards a line not to be crossed.
    pub(crate) fn stop_at(&self, speed: f64, gap: f64) -> f64 {
        self.react(speed, gap, 0.0, 0.4, 0.6)
    }

    fn react(&self, speed: f64, gap: f64, leader_speed: f64, standing: f64, headway: f64) -> f64 {
        if gap <= 0.05 {
            return -HARDEST_BRAKING;
        }
        let closing = speed * (speed - leader_speed) / (2.0 * (self.accelerate * self.brake).sqrt());
        let wanted = standing + (speed * headway + closing).max(0.0);
        let ratio = wanted / gap;
        (self.accelerate * (1.0 - ratio * ratio)).max(-HARDEST_BRAKING)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn driver() -> Driver {
        Driver {
            accelerate: 1.5,
            brake: 2.0,
            headway_s: 1.2,
            standing_gap_m: 2.0,
            limit_factor: 1.0,
            cruise_mps: 14.0,
            sight_mps: f64::INFINITY,
            bend_factor: 1.0,
            lateral_m: 0.0,
            politeness: 0.3,
            gap_factor: 1.0,
        }
    }

    #[test]
    fn stops_before_a_line_and_never_rolls_back() {
        let d = driver();
        for start in [20.0, 40.0, 80.0] {
            let (mut x, mut v) = (0.0f64, if start < 30.0 { 6.0 } else { 13.0 });
            for _ in 0..3000 {
                let a = d.free(v, 14.0).min(d.stop_at(v, start - x));
                v = (v + a / 30.0).max(0.0);
                x += v / 30.0;
            }
            assert!(x < start && start - x < 1.5 && v < 0.05, "{start} {x} {v}");
        }
    }

    #[test]
    fn keeps_its_headway_behind_a_leader() {
        let d = driver();
        let (mut x, mut v, mut leader) = (0.0f64, 10.0f64, 30.0f64);
        for _ in 0..6000 {
            let a = d.free(v, 14.0).min(d.follow(v, leader - x, 8.0));
            v = (v + a / 30.0).max(0.0);
            x += v / 30.0;
            leader += 8.0 / 30.0;
        }
        assert!((v - 8.0).abs() < 0.1);
        let gap = leader - x;
        assert!(gap > 2.0 + 1.2 * 8.0 - 0.2 && gap < 20.0, "{gap}");
    }
}
