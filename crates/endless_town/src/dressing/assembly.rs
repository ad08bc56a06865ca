//! Puts props down, each only where nothing else stands.

use crate::geometry::{OccupiedSpace, Rect};
use crate::placement::{PlacedObject, Placement};
use endless_asset::{Catalogue, Prop};
use endless_scene::StreetLamp;
use endless_world::{ParkedVehicle, SignalId, Stream};
use glam::{Affine3A, DVec2, Quat, Vec3};

/// Everything that stands in a town, while it is being put down.
pub(crate) struct TownAssembly<'a> {
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) occupied: OccupiedSpace,
    pub(crate) placements: Vec<Placement>,
    pub(crate) lamps: Vec<StreetLamp>,
    pub(crate) parked: Vec<ParkedVehicle>,
    stream: Stream,
}

/// Height of the sidewalk above the road, metres.
const KERB_HEIGHT_M: f64 = 0.15;

/// The trade that chooses the models of which a town has many; all traffic lights are of one look.
const MUNICIPAL: u64 = 33_000_000;

/// Where a prop goes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PropPose {
    pub(crate) at: DVec2,
    /// Height of the ground.
    pub(crate) z: f64,
    /// Direction of the prop's +x.
    pub(crate) yaw: f64,
    pub(crate) scale: Vec3,
}

impl PropPose {
    /// On the sidewalk, at the prop's own size.
    pub(crate) fn new(at: DVec2, yaw: f64) -> Self {
        Self { at, z: KERB_HEIGHT_M, yaw, scale: Vec3::ONE }
    }
}

impl<'a> TownAssembly<'a> {
    pub(crate) fn new(catalogue: &'a Catalogue, occupied: OccupiedSpace, seed: u64) -> Self {
        let stream = Stream::named(seed, "town/dressing", &[]);
        Self { catalogue, occupied, placements: Vec::new(), lamps: Vec::new(), parked: Vec::new(), stream }
    }

    /// The stream of one trade; what others draw does not change it.
    pub(crate) fn stream(&self, trade: u64) -> Stream {
        self.stream.fork(trade)
    }

    /// Puts a prop down if its footprint (half extents along its own axes) is free.
    pub(crate) fn put(&mut self, prop: Prop, spot: PropPose, half: DVec2, signal: Option<SignalId>) -> bool {
        if !self.occupied.try_take(Rect::new(spot.at, half, spot.yaw)) {
            return false;
        }
        self.place(prop, spot, signal);
        true
    }

    /// The same with a variant of the caller's choice.
    pub(crate) fn put_variant(&mut self, (prop, variant): (Prop, u32), spot: PropPose, half: DVec2) -> bool {
        let free = self.occupied.try_take(Rect::new(spot.at, half, spot.yaw));
        if free {
            self.place_variant((prop, variant), spot, None);
        }
        free
    }

    /// Puts a prop down where the caller knows that there is room.
    pub(crate) fn place(&mut self, prop: Prop, spot: PropPose, signal: Option<SignalId>) {
        let mut stream = match prop {
            prop if prop.is_signal() => self.stream.fork(MUNICIPAL),
            prop if prop.is_municipal() => self.stream.fork(MUNICIPAL + 1 + prop as u64),
            _ => self.stream.fork(self.placements.len() as u64),
        };
        let variant = stream.below(self.catalogue.prop_variants(prop).max(1) as usize) as u32;
        self.place_variant((prop, variant), spot, signal);
    }

    fn place_variant(&mut self, (prop, variant): (Prop, u32), spot: PropPose, signal: Option<SignalId>) {
        let world_from_object = Affine3A::from_scale_rotation_translation(
            spot.scale,
            Quat::from_rotation_z(spot.yaw as f32),
            spot.at.extend(spot.z).as_vec3(),
        );
        self.placements.push(Placement { object: PlacedObject::Prop(prop, variant), world_from_object, signal });
    }
}
