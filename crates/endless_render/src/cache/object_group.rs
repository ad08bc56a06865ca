//! Moving objects that stand near one another: an area of the picture asks for all of them together before it asks for
//! each, so that the many that do nothing to it cost little.

use super::contact_shadow::contact_bounds;
use super::tile::{Bounds3, TileBounds, TileRayBounds};
use crate::scene::MovingVolume;
use std::collections::BTreeMap;

/// Edge of the squares of ground in which groups stand, metres.
const SQUARE_M: f32 = 24.0;

/// Some objects, and bounds of what any of them can do.
pub(super) struct ObjectGroup {
    /// Their indices, ascending.
    pub(super) members: Vec<usize>,
    around: Bounds3,
    /// What they may darken at their feet.
    contacts: Bounds3,
    /// Where their shadows by lamps can lie.
    lamp_shadows: Bounds3,
}

impl ObjectGroup {
    const EMPTY: Self =
        Self { members: Vec::new(), around: Bounds3::EMPTY, contacts: Bounds3::EMPTY, lamp_shadows: Bounds3::EMPTY };

    /// All objects by the square that they stand on; `lamp_shadows` bounds those of each.
    pub(super) fn all(objects: &[MovingVolume], lamp_shadows: &[Bounds3]) -> Vec<Self> {
        let mut groups: BTreeMap<[i32; 2], Self> = BTreeMap::new();
        for (i, (object, shadows)) in objects.iter().zip(lamp_shadows).enumerate() {
            let square = (object.centre / SQUARE_M).floor().as_ivec2().to_array();
            let group = groups.entry(square).or_insert(Self::EMPTY);
            group.members.push(i);
            group.around.join(&Bounds3 { low: object.low, high: object.high });
            group.contacts.join(&contact_bounds(object));
            group.lamp_shadows.join(shadows);
        }
        groups.into_values().collect()
    }

    /// Whether any of them may do anything to an area of the picture but be seen: no wrong no.
    pub(super) fn may_change(&self, area: &TileBounds, rays: &TileRayBounds) -> bool {
        let Bounds3 { low, high } = self.around;
        let sun = || rays.sun.as_ref().is_some_and(|sun| sun.may_meet(low, high, f32::MAX));
        let mirror = || rays.mirror.as_ref().is_some_and(|mirror| mirror.may_meet(low, high, f32::MAX));
        let met = |bounds: &Bounds3| area.points.meets(bounds.low, bounds.high);
        met(&self.contacts) || met(&self.lamp_shadows) || sun() || mirror()
    }
}
