//! The built-in catalogue.

use crate::vehicle::{self, RiderFit};
use crate::{Mesh, PersonModel, Prop, VehicleModel};

/// Everything that can be placed in a scene. Building it is deterministic and takes well under a second.
#[derive(Debug, Clone)]
pub struct Catalogue {
    vehicles: Vec<VehicleModel>,
    /// How a rider sits, one a vehicle.
    fits: Vec<Option<RiderFit>>,
}

impl Catalogue {
    /// The built-in catalogue.
    pub fn builtin() -> Self {
        let (vehicles, fits) = vehicle::all().into_iter().map(|b| (b.model, b.fit)).unzip();
        Self { vehicles, fits }
    }

    /// Vehicle models; [`endless_world::AssetRef::model`] indexes them.
    pub fn vehicles(&self) -> &[VehicleModel] {
        &self.vehicles
    }

    /// Linear paint colour of a variant of a vehicle, distributed as on real roads.
    pub fn vehicle_tint(&self, model: u16, variant: u64) -> [f32; 3] {
        vehicle::tint(&self.vehicles[usize::from(model)].spec, variant)
    }

    /// The person of a variant.
    pub fn person(&self, _variant: u64) -> PersonModel {
        PersonModel { rest: Mesh::default(), height_m: 1.7, walk_mps: 1.4 }
    }

    /// The rider of a two-wheeler, seated, in the vehicle's object frame; `None` for other models.
    pub fn rider(&self, _model: u16, _variant: u64) -> Option<Mesh> {
        None
    }

    /// A plant or a piece of furniture. Few distinct variants exist of each ([`Self::prop_variants`]), so that towns
    /// can instance them.
    pub fn prop(&self, _prop: Prop, _variant: u32) -> Mesh {
        Mesh::default()
    }

    /// How many variants of a prop there are, at least 1.
    pub fn prop_variants(&self, _prop: Prop) -> u32 {
        1
    }
}
