//! Bodies in the world: rigid pieces of vehicles, with the heights between which they are.

use endless_road::swept::OrientedRectangle;
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, Motion, VehicleSpec};
use glam::DVec2;

/// A rigid piece of a vehicle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Body {
    pub(crate) footprint: OrientedRectangle,
    pub(crate) bottom_m: f64,
    pub(crate) top_m: f64,
}

impl Body {
    /// The pieces of a vehicle: one, or with a trailer two.
    pub(crate) fn pieces(actor: &Actor, spec: &VehicleSpec) -> impl Iterator<Item = Self> {
        let (position, yaw) = (actor.pose.position.as_dvec3(), f64::from(actor.pose.yaw_rad));
        let whole = OrientedRectangle::new(spec, position.truncate(), yaw, 0.0);
        let (first, second) = match (spec.trailer, actor.motion) {
            (Some(t), Motion::Vehicle(motion)) => {
                let [hitch, front, rear] = [t.hitch_m, t.front_m, t.towing_rear_m].map(f64::from);
                let piece = |from: DVec2, yaw: f64, begin: f64, end: f64| {
                    let (sin, cos) = sin_cos(yaw);
                    let axis = DVec2::new(cos, sin);
                    let half = DVec2::new(0.5 * (end - begin), whole.half.y);
                    OrientedRectangle { center: from + axis * 0.5 * (begin + end), axis, half }
                };
                let joint = whole.place(hitch, 0.0);
                let half = whole.half.x;
                let drawn = piece(joint, yaw + f64::from(motion.hitch_rad), -half - hitch, front - hitch);
                (piece(whole.center, yaw, rear, half), Some(drawn))
            }
            _ => (whole, None),
        };
        let (bottom_m, top_m) = (position.z, position.z + f64::from(spec.height_m));
        std::iter::once(first).chain(second).map(move |footprint| Self { footprint, bottom_m, top_m })
    }

    /// Corners of the box around it, from south-west to north-east.
    pub(crate) fn bounds(&self) -> [DVec2; 2] {
        let OrientedRectangle { center, axis, half } = self.footprint;
        let reach = axis.abs() * half.x + axis.perp().abs() * half.y;
        [center - reach, center + reach]
    }

    /// Whether both are at one height, not one above the other as on a bridge.
    fn level_with(&self, bottom_m: f64, top_m: f64) -> bool {
        self.bottom_m <= top_m && bottom_m <= self.top_m
    }

    pub(crate) fn touches(&self, other: &Self) -> bool {
        self.level_with(other.bottom_m, other.top_m) && self.footprint.overlaps(&other.footprint)
    }

    /// Whether a disc on the ground, so high, touches it.
    pub(crate) fn touches_disc(&self, at: DVec2, radius_m: f64, bottom_m: f64, top_m: f64) -> bool {
        self.footprint.distance(at) < radius_m && self.level_with(bottom_m, top_m)
    }
}
