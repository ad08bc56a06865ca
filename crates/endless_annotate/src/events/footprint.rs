//! Rectangles on the ground that move evenly, and when two of them meet.

use endless_world::{Actor, math};
use glam::{Vec2, Vec3Swizzles as _};

/// The ground under a road user at an instant, and where it is going.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Footprint {
    /// Its middle, world frame, metres.
    pub centre: Vec2,
    /// Unit vector along it.
    pub along: Vec2,
    /// Half length and half width, metres.
    pub half: Vec2,
    /// Metres a second.
    pub velocity: Vec2,
}

impl Footprint {
    /// Of an actor of this half length and half width, metres.
    pub fn of(actor: &Actor, half: Vec2) -> Self {
        let along = Vec2::new(math::cos(actor.pose.yaw_rad), math::sin(actor.pose.yaw_rad));
        Self { centre: actor.pose.position.xy(), along, half, velocity: actor.velocity_mps.xy() }
    }

    /// Front left, front right, rear right, rear left.
    pub fn corners(&self) -> [Vec2; 4] {
        let (ahead, left) = (self.along * self.half.x, self.along.perp() * self.half.y);
        [ahead + left, ahead - left, -ahead - left, left - ahead].map(|corner| self.centre + corner)
    }

    /// Where another that covers some of the same ground would push it: the direction (a unit vector) in which the overlap
    /// is least, and how deep that is, metres. `None` if they do not overlap.
    pub fn contact(&self, other: &Self) -> Option<(Vec2, f32)> {
        let axes = [self.along, self.along.perp(), other.along, other.along.perp()];
        let overlap = |axis: Vec2| {
            let apart = (other.centre - self.centre).dot(axis);
            let away = if apart > 0.0 { -axis } else { axis };
            (away, self.reach(axis) + other.reach(axis) - apart.abs())
        };
        let least = axes.map(overlap).into_iter().min_by(|a, b| a.1.total_cmp(&b.1));
        least.filter(|(_, depth_m)| *depth_m >= 0.0)
    }

    /// Half of its extent in a direction.
    fn reach(&self, direction: Vec2) -> f32 {
        self.half.x * self.along.dot(direction).abs() + self.half.y * self.along.perp_dot(direction).abs()
    }

    /// When it first touches another if both go on as they do: seconds, 0 if they overlap now, `None` for never.
    ///
    /// Of convex bodies that do not turn, those times are an interval along each axis that may part them (the separating
    /// axes of both rectangles); they touch where all intervals overlap.
    pub fn time_to_collision(&self, other: &Self) -> Option<f32> {
        let axes = [self.along, self.along.perp(), other.along, other.along.perp()];
        let (mut first, mut last) = (0.0f32, f32::INFINITY);
        for axis in axes {
            let apart = (other.centre - self.centre).dot(axis);
            let closing = (other.velocity - self.velocity).dot(axis);
            let reach = self.reach(axis) + other.reach(axis);
            if closing.abs() < 1e-6 {
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

    /// Whether they cover some of the same ground.
    pub fn overlaps(&self, other: &Self) -> bool {
        let still = |footprint: &Self| Self { velocity: Vec2::ZERO, ..*footprint };
        still(self).time_to_collision(&still(other)).is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn footprint() -> impl Strategy<Value = Footprint> {
        let vector = |most: f32| (-most..most, -most..most).prop_map(|(x, y)| Vec2::new(x, y));
        let half = (0.3f32..6.0, 0.2f32..1.3).prop_map(|(x, y)| Vec2::new(x, y));
        (vector(25.0), -3.0f32..3.0, half, vector(15.0)).prop_map(|(centre, yaw, half, velocity)| Footprint {
            centre,
            along: Vec2::new(endless_world::math::cos(yaw), endless_world::math::sin(yaw)),
            half,
            velocity,
        })
    }

    fn later(footprint: &Footprint, seconds: f32) -> Footprint {
        Footprint { centre: footprint.centre + footprint.velocity * seconds, ..*footprint }
    }

    proptest! {
        #[test]
        fn who_is_pushed_out_is_free(a in footprint(), b in footprint()) {
            let contact = a.contact(&b);
            prop_assert_eq!(contact.is_some(), a.overlaps(&b));
            let Some((away, depth_m)) = contact else { return Ok(()) };
            let pushed = |by: f32| Footprint { centre: a.centre + away * by, ..a };
            prop_assert!(!pushed(depth_m + 1e-3).overlaps(&b));
            prop_assert!(depth_m < 2e-3 || pushed(depth_m - 1e-3).overlaps(&b));
        }

        #[test]
        fn they_touch_then_and_not_before(a in footprint(), b in footprint()) {
            let grown = |by: f32| Footprint { half: a.half + by, ..a };
            match a.time_to_collision(&b) {
                Some(time) => {
                    prop_assert!(later(&grown(0.01), time).overlaps(&later(&b, time)));
                    for share in [0.0, 0.25, 0.5, 0.75, 0.98] {
                        let before = time * share;
                        prop_assert!(before + 1e-3 > time || !later(&grown(-0.01), before).overlaps(&later(&b, before)));
                    }
                }
                None => {
                    for step in 0..40 {
                        let time = 0.1 * step as f32;
                        prop_assert!(!later(&grown(-0.01), time).overlaps(&later(&b, time)));
                    }
                }
            }
        }
    }

    #[test]
    fn who_follows_at_the_same_speed_never_touches() {
        let first =
            Footprint { centre: Vec2::ZERO, along: Vec2::X, half: Vec2::new(2.0, 0.9), velocity: Vec2::new(10.0, 0.0) };
        let behind = Footprint { centre: Vec2::new(-9.0, 0.0), ..first };
        assert_eq!(behind.time_to_collision(&first), None);
        let faster = Footprint { velocity: Vec2::new(15.0, 0.0), ..behind };
        assert_eq!(faster.time_to_collision(&first), Some(1.0));
        assert_eq!(faster.time_to_collision(&faster), Some(0.0));
    }
}
