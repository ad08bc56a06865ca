//! CARLA's layers of a map: all things of a kind, which clients take away and bring back together.

use endless_town::PlacedObject;
use endless_world::ClassTag;

/// A layer that our towns have something of, by CARLA's bit. Roads, decals and particles cannot be taken away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u16)]
pub(super) enum MapLayer {
    Buildings = 1,
    Foliage = 4,
    ParkedVehicles = 16,
    Props = 64,
    StreetLights = 128,
    Walls = 256,
}

impl MapLayer {
    /// CARLA's bits of all layers.
    pub(super) const ALL: u16 = u16::MAX;

    /// The layer of those parts of a thing that are of a class; none of traffic lights, signs and ground, which stay.
    pub(super) fn of(object: PlacedObject, class: ClassTag) -> Option<Self> {
        use ClassTag::{
            Bridge, Fences, Ground, GuardRail, RailTrack, RoadLines, Roads, Sidewalks, Terrain, Vegetation, Walls,
            Water,
        };
        let prop = match object {
            PlacedObject::TownMesh(_) => None,
            PlacedObject::Prop(prop, _) => Some(prop),
        };
        match (prop, class) {
            (_, Bridge | Ground | RailTrack | RoadLines | Roads | Sidewalks | Terrain | Water) => None,
            (None, _) => Some(Self::Buildings),
            (Some(prop), _) if prop.is_signal() || prop.is_traffic_sign() => None,
            (Some(prop), _) if prop.is_street_lamp() => Some(Self::StreetLights),
            (_, Vegetation) => Some(Self::Foliage),
            (_, Walls | Fences | GuardRail) => Some(Self::Walls),
            _ => Some(Self::Props),
        }
    }

    /// Whether it is among layers that are named by their bits.
    pub(super) fn is_in(self, layers: u16) -> bool {
        layers & self as u16 != 0
    }
}
