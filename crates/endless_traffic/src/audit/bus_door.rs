//! Doors of buses that stand: who gets on or off is half outside of them for a moment, and between them and the sidewalk.

use super::sight::{Glance, Sight};
use crate::bus_stop::DOOR_M;
use endless_world::ObjectClass;
use glam::DVec2;

/// Half the width of a door with who is in it, metres.
const HALF_DOOR_M: f64 = 0.75;
/// People get this far inside before nobody sees them any more, metres.
const INSIDE_M: f64 = 0.8;
/// Slower than this a bus stands, m/s.
const STANDS_MPS: f64 = 0.05;
/// Sidewalks are no further from a bus that stands at its stop, metres.
const KERB_M: f64 = 2.8;

/// How far a place is outside of the side of a standing bus, metres, where that side has its front door.
fn outside_m(bus: &Glance<'_>, at: DVec2) -> Option<f64> {
    let (motion, spec) = bus.driven.filter(|(_, spec)| spec.class == ObjectClass::Bus)?;
    let away = at - bus.at;
    let (along, beside) = (away.dot(bus.ahead), away.perp_dot(bus.ahead).abs());
    let door = 0.5 * f64::from(spec.length_m) - DOOR_M;
    let stands = f64::from(motion.speed_mps) < STANDS_MPS;
    (stands && (along - door).abs() < HALF_DOOR_M).then(|| beside - 0.5 * f64::from(spec.width_m))
}

/// Whether a place is inside the outline of this bus, right behind its door.
pub(super) fn is_behind_door(bus: &Glance<'_>, at: DVec2) -> bool {
    outside_m(bus, at).is_some_and(|outside| (-INSIDE_M..0.0).contains(&outside))
}

/// Whether a body at a place goes through the door of this bus.
pub(super) fn goes_through(bus: &Glance<'_>, at: DVec2) -> bool {
    outside_m(bus, at).is_some_and(|outside| (-INSIDE_M..0.5).contains(&outside))
}

/// Whether a place is between the door of some bus and the sidewalk, or in the door.
pub(super) fn is_before_door(sight: &Sight<'_>, at: DVec2) -> bool {
    sight.glances.iter().any(|bus| outside_m(bus, at).is_some_and(|outside| (-INSIDE_M..KERB_M).contains(&outside)))
}
