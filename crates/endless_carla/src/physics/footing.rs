//! The ground under the wheels.

use super::parameters::Parameters;
use super::sane::within;
use glam::{DVec2, DVec3};

/// Height of the ground at x and y for one who is about at z, metres: of several, such as on and under a bridge, that one;
/// `None` where there is none.
pub type Ground<'a> = dyn Fn(f64, f64, f64) -> Option<f64> + 'a;

/// Steepest slope that counts as ground.
const STEEPEST: f64 = 1.0;
/// What two-wheelers stand on, metres to both sides.
const NARROWEST_M: f64 = 0.4;

/// A plane under a vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Footing {
    /// Under the origin, metres.
    pub(super) height_m: f64,
    /// Rise forwards and to the left, metres per metre.
    pub(super) slope: DVec2,
}

/// A height that can be used.
pub(super) fn height(ground: &Ground<'_>, at: DVec3) -> Option<f64> {
    ground(at.x, at.y, at.z).filter(|height| height.is_finite()).map(|height| within(height, -1e5, 1e5, 0.0))
}

impl Footing {
    /// Under the four wheels of a vehicle at `origin` with its nose in direction `forward`; `None` where none has ground.
    pub(super) fn under(ground: &Ground<'_>, p: &Parameters, origin: DVec3, forward: DVec2) -> Option<Self> {
        let left = forward.perp();
        let [front_m, rear_m] = p.axles.map(|axle| p.centre_m + axle.ahead_m);
        let half_m = 0.5 * p.track_m.max(NARROWEST_M);
        let wheels = [(front_m, half_m), (front_m, -half_m), (rear_m, half_m), (rear_m, -half_m)];
        let heights =
            wheels.map(|(ahead, aside)| height(ground, origin + (forward * ahead + left * aside).extend(0.0)));
        let found = heights.iter().flatten().count();
        if found == 0 {
            return None;
        }
        let mean = heights.iter().flatten().sum::<f64>() / found as f64;
        let [fl, fr, rl, rr] = heights.map(|height| height.unwrap_or(mean));
        let (front, rear) = (0.5 * (fl + fr), 0.5 * (rl + rr));
        let slope = DVec2::new((front - rear) / p.wheelbase_m, 0.5 * (fl - fr + rl - rr) / (2.0 * half_m));
        let height_m = rear + (front - rear) * (-rear_m / p.wheelbase_m);
        Some(Self { height_m, slope: slope.clamp(DVec2::splat(-STEEPEST), DVec2::splat(STEEPEST)) })
    }
}
