//! What car glass shows of the inside: seats and who sits on them, the roof's lining, daylight through the windows across,
//! in buses the floor, poles and lamps under the roof. Not modelled but traced through a cabin made up from the body's
//! size (after van Dongen's interior mapping, 2008).

mod hit;
mod interior;
mod layout;
mod occupants;
mod trace;

use crate::scene::SurfaceInteraction;
use glam::Vec3A;
use layout::{Cabin, occupant_key};
pub use occupants::occupants;

/// Brightness of what lamps under the roof shine on, of their own.
const LAMPS: f32 = 0.55;

/// What a pane shows.
pub(super) struct CabinView {
    /// Albedo that the pane seems to have.
    pub(super) albedo: Vec3A,
    /// How bright the lamps under the roof make it when they are on, of a lamp's own brightness.
    pub(super) lit: Vec3A,
}

/// What is behind a glass that lets a share of the light `through`; `None` where there is no cabin.
pub(super) fn behind(point: &SurfaceInteraction<'_>, through: f32) -> Option<CabinView> {
    let instance = point.instance;
    let (low, high) = instance.geometry.posed.blas.bounds();
    let turn = instance.world_from_object.matrix3.transpose();
    let outwards = turn * point.geometric_normal;
    let cabin = Cabin::of(point.tag(), low, high, point.object_position, outwards)?;
    let direction = (turn * point.direction).normalize();
    let key = occupant_key(instance.id);
    let met = cabin.trace(point.object_position, direction, key, instance.object != u16::MAX);
    // What is outside across is not lit by the cabin's lamps; the lamps themselves are.
    let lit = if met.lamp { Vec3A::ONE } else { met.color * LAMPS };
    Some(CabinView { albedo: met.color * through, lit: if met.outside { Vec3A::ZERO } else { lit * through } })
}
