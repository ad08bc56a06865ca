//! Where a sensor is that goes its own way.

use super::{Placement, SensorMount, SensorPose, WayPoint, rotation_vector};
use crate::math::f64::{atan2, sin_cos};

use std::f64::consts::TAU;

/// Half the time between two places from which a velocity is told, seconds.
const STEP_S: f64 = 1e-4;

impl SensorMount {
    /// Where the sensor is so many seconds after frame 0; `None` if somebody carries it.
    pub fn pose_at(&self, time_s: f64) -> Option<SensorPose> {
        let at = self.place_at(time_s)?;
        let still = SensorPose::still(at.origin(), at.rotation());
        if self.is_still() {
            return Some(still);
        }
        let [before, after] = [time_s - STEP_S, time_s + STEP_S].map(|time_s| self.place_at(time_s));
        let (before, after) = (before?, after?);
        Some(SensorPose {
            velocity_mps: (after.origin() - before.origin()) / (2.0 * STEP_S),
            angular_velocity_radps: rotation_vector(after.rotation() * before.rotation().conjugate()) / (2.0 * STEP_S),
            ..still
        })
    }

    /// Horizontal field of view then, radians, of a lens that zooms.
    pub fn fov_at(&self, time_s: f64) -> Option<f64> {
        let Self::Way { points } = self else { return None };
        let zooms: Vec<(f64, f64)> =
            points.iter().filter_map(|point| Some((point.time_s, point.horizontal_fov_rad?))).collect();
        (!zooms.is_empty()).then(|| spline(&zooms, time_s))
    }

    fn place_at(&self, time_s: f64) -> Option<Placement> {
        match self {
            Self::Still { at } => Some(*at),
            Self::Carried { .. } => None,
            Self::Orbit { centre, radius_m, height_m, period_s, begin_rad } => {
                let (sin, cos) = sin_cos(begin_rad + TAU * time_s / period_s);
                let position = [centre[0] + radius_m * cos, centre[1] + radius_m * sin, centre[2] + height_m];
                let yaw_rad = atan2(-sin, -cos);
                let pitch_rad = -atan2(*height_m, *radius_m);
                Some(Placement { position, yaw_rad, pitch_rad, roll_rad: 0.0 })
            }
            Self::Way { points } => Some(on_way(points, time_s)),
        }
    }
}

fn on_way(points: &[WayPoint], time_s: f64) -> Placement {
    let value = |of: &dyn Fn(&Placement) -> f64| {
        let values: Vec<(f64, f64)> = points.iter().map(|point| (point.time_s, of(&point.at))).collect();
        spline(&values, time_s)
    };
    Placement {
        position: [0, 1, 2].map(|axis| value(&|at| at.position[axis])),
        yaw_rad: value(&|at| at.yaw_rad),
        pitch_rad: value(&|at| at.pitch_rad),
        roll_rad: value(&|at| at.roll_rad),
    }
}

/// Between values at ascending times: cubic Hermite segments with the slopes of Fritsch and Butland (1984), which never
/// overshoot; before the first and after the last, that one.
fn spline(values: &[(f64, f64)], time: f64) -> f64 {
    let after = values.partition_point(|(t, _)| *t <= time);
    if after == 0 || after == values.len() {
        return values[after.saturating_sub(1)].1;
    }
    let ((t0, v0), (t1, v1)) = (values[after - 1], values[after]);
    let length = t1 - t0;
    let u = (time - t0) / length;
    let [m0, m1] = [after - 1, after].map(|i| slope(values, i) * length);
    let (u2, u3) = (u * u, u * u * u);
    v0 * (2.0 * u3 - 3.0 * u2 + 1.0) + m0 * (u3 - 2.0 * u2 + u) + v1 * (3.0 * u2 - 2.0 * u3) + m1 * (u3 - u2)
}

/// Slope at a value: 0 at both ends and wherever the sign of the change turns.
fn slope(values: &[(f64, f64)], i: usize) -> f64 {
    if i == 0 || i + 1 == values.len() {
        return 0.0;
    }
    let secant = |a: (f64, f64), b: (f64, f64)| ((b.1 - a.1) / (b.0 - a.0), b.0 - a.0);
    let ((d0, h0), (d1, h1)) = (secant(values[i - 1], values[i]), secant(values[i], values[i + 1]));
    if d0 * d1 <= 0.0 {
        return 0.0;
    }
    let share = (h0 + 2.0 * h1) / (3.0 * (h0 + h1));
    d0 * d1 / (share * d1 + (1.0 - share) * d0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use proptest::prelude::*;

    #[test]
    fn an_orbit_looks_at_its_middle() {
        let centre = [10.0, -20.0, 1.0];
        let mount = SensorMount::Orbit { centre, radius_m: 40.0, height_m: 60.0, period_s: 90.0, begin_rad: 0.3 };
        for step in 0..90 {
            let pose = mount.pose_at(f64::from(step) * 1.3).expect("it flies by itself");
            let seen = pose.sensor_from_world_point(centre.into());
            assert!((seen - DVec3::X * (40.0f64 * 40.0 + 60.0 * 60.0).sqrt()).length() < 1e-9, "{seen}");
            assert!((pose.velocity_mps.length() - 40.0 * TAU / 90.0).abs() < 1e-6);
            assert!((pose.angular_velocity_radps - DVec3::Z * (TAU / 90.0)).length() < 1e-6);
        }
    }

    fn way(yaws: &[f64]) -> SensorMount {
        let point = |(i, yaw_rad): (usize, &f64)| WayPoint {
            time_s: 2.0 * i as f64,
            at: Placement { position: [3.0 * i as f64, 0.0, 10.0], yaw_rad: *yaw_rad, pitch_rad: -0.5, roll_rad: 0.0 },
            horizontal_fov_rad: (i != 1).then_some(1.0 / (1.0 + i as f64)),
        };
        SensorMount::Way { points: yaws.iter().enumerate().map(point).collect() }
    }

    #[test]
    fn a_way_passes_its_points_and_ends_at_the_last() {
        let mount = way(&[0.0, 1.0, 1.0, -0.5]);
        for (time_s, x, yaw_rad) in
            [(-1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (2.0, 3.0, 1.0), (4.0, 6.0, 1.0), (99.0, 9.0, -0.5)]
        {
            let at = mount.place_at(time_s).expect("a way");
            assert!((at.position[0] - x).abs() < 1e-12 && (at.yaw_rad - yaw_rad).abs() < 1e-12, "{time_s}: {at:?}");
        }
        assert_eq!(mount.fov_at(0.0), Some(1.0));
        assert_eq!(mount.fov_at(9.0), Some(0.25));
        // It stands before it goes.
        assert_eq!(mount.pose_at(-1.0).expect("a way").velocity_mps, DVec3::ZERO);
    }

    proptest! {
        #[test]
        fn a_way_never_leaves_the_range_of_its_points(
            yaws in prop::collection::vec(-3.0f64..3.0, 1..7), time_s in -1.0f64..15.0,
        ) {
            let low = yaws.iter().copied().fold(f64::INFINITY, f64::min);
            let high = yaws.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let yaw = way(&yaws).place_at(time_s).expect("a way").yaw_rad;
            prop_assert!((low - 1e-9..=high + 1e-9).contains(&yaw));
        }
    }
}
