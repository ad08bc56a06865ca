//! Where people cross the road: lines along it leave off there, no iron lies in it, nothing grows or parks before it.

use endless_road::Crossing;
use endless_world::math::segment::share_along;
use glam::{DVec2, DVec3};

/// Whether a place lies on a crossing, or nearer to its bars than `apart` metres.
pub(crate) fn holds(crossing: &Crossing, p: DVec3, apart: f64) -> bool {
    /// Roads above and below one another are further apart.
    const LEVEL_M: f64 = 1.5;
    let [a, b] = crossing.ends;
    let across = (b - a).truncate();
    let (way, length) = (across.normalize_or_zero(), across.length());
    let q = (p - a).truncate();
    (-apart..length + apart).contains(&q.dot(way))
        && q.perp_dot(way).abs() < crossing.width_m / 2.0 + apart
        && (p.z - (a.z + b.z) / 2.0).abs() < LEVEL_M
}

/// Whether a place, at any level, is nearer to a crossing than `apart` metres; round its ends, where people wait, too.
pub(crate) fn is_near(crossing: &Crossing, p: DVec2, apart: f64) -> bool {
    let [a, b] = crossing.ends.map(DVec3::truncate);
    let t = share_along(p, a, b);
    a.lerp(b, t).distance(p) < apart + crossing.width_m / 2.0
}

/// Whether a crossing may reach into a box.
pub(crate) fn reaches(crossing: &Crossing, low: DVec2, high: DVec2) -> bool {
    let [a, b] = crossing.ends.map(DVec3::truncate);
    let reach = DVec2::splat(crossing.width_m);
    (a.min(b) - reach).cmplt(high).all() && (a.max(b) + reach).cmpgt(low).all()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crossing_holds_what_lies_on_it() {
        let ends = [DVec3::new(0.0, 0.0, 1.0), DVec3::new(10.0, 0.0, 1.0)];
        let crossing = Crossing { ends, width_m: 3.0, signal: None, cuts: vec![] };
        let holds = |x: f64, y: f64, z: f64| holds(&crossing, DVec3::new(x, y, z), 0.3);
        assert!(holds(5.0, 1.7, 1.0) && holds(5.0, -1.7, 1.2) && holds(10.2, 0.0, 1.0));
        assert!(!holds(5.0, 1.9, 1.0) && !holds(10.4, 0.0, 1.0) && !holds(5.0, 0.0, 6.0));
        assert!(!reaches(&crossing, DVec2::new(20.0, -9.0), DVec2::new(30.0, 9.0)));
        assert!(reaches(&crossing, DVec2::new(9.0, 2.0), DVec2::new(30.0, 9.0)));
    }
}
