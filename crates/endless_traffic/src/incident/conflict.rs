//! Surrogate safety measures of two bodies: time to collision (Hayward 1972), the deceleration needed to avoid the crash
//! (Almqvist et al. 1991), and post-encroachment time (Allen et al. 1978).

use endless_road::swept::OrientedRectangle;
use glam::DVec2;

/// Two that would touch sooner if both went on as they do come near a collision, seconds (Hydén 1987).
pub(crate) const NEAR_MISS_S: f64 = 1.5;
/// Who must brake harder to avoid a crash takes evasive action, m/s² (Archer 2005).
pub(crate) const EVASIVE_MPS2: f64 = 3.4;

/// A body at an instant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MovingBody {
    pub(crate) body: OrientedRectangle,
    /// m/s.
    pub(crate) velocity: DVec2,
}

impl MovingBody {
    fn reach(&self, direction: DVec2) -> f64 {
        let OrientedRectangle { axis, half, .. } = self.body;
        half.x * axis.dot(direction).abs() + half.y * axis.perp_dot(direction).abs()
    }

    /// When two first touch if both go on as they do: seconds, 0 if they overlap now, `None` for never.
    pub(crate) fn time_to_collision_s(&self, other: &Self) -> Option<f64> {
        let apart = other.body.center - self.body.center;
        let closing = other.velocity - self.velocity;
        let (mut first, mut last) = (0.0f64, f64::INFINITY);
        for axis in [self.body.axis, self.body.axis.perp(), other.body.axis, other.body.axis.perp()] {
            let (apart, closing) = (apart.dot(axis), closing.dot(axis));
            let reach = self.reach(axis) + other.reach(axis);
            if closing.abs() < 1e-9 {
                if apart.abs() > reach {
                    return None;
                }
                continue;
            }
            let (a, b) = ((-reach - apart) / closing, (reach - apart) / closing);
            (first, last) = (first.max(a.min(b)), last.min(a.max(b)));
        }
        (first <= last).then_some(first)
    }

    /// The deceleration that would just avoid the crash, given the time to collision, m/s².
    pub(crate) fn needed_mps2(&self, other: &Self, time_to_collision_s: f64) -> f64 {
        (other.velocity - self.velocity).length() / (2.0 * time_to_collision_s.max(1e-3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_behind_the_other() {
        let body = |x: f64, speed: f64| MovingBody {
            body: OrientedRectangle::of(DVec2::new(2.0, 0.9), DVec2::new(x, 0.0), 0.0),
            velocity: DVec2::new(speed, 0.0),
        };
        let (follower, leader) = (body(0.0, 10.0), body(14.0, 2.0));
        let time = follower.time_to_collision_s(&leader).expect("they come nearer");
        assert!((time - 10.0 / 8.0).abs() < 1e-9);
        // From 8 m/s to a stand on 10 m.
        assert!((follower.needed_mps2(&leader, time) - 8.0 * 8.0 / 20.0).abs() < 1e-9);
        assert_eq!(follower.time_to_collision_s(&body(14.0, 11.0)), None);
        assert_eq!(follower.time_to_collision_s(&body(3.0, 0.0)), Some(0.0));
    }
}
