//! A town as the renderer draws it.

use crate::{SharedModels, TownThing, town_thing::Remains, vehicle::VehicleGeometry};
use endless_asset::Catalogue;
use endless_render::{Geometry, Instance, RigidVelocity, StaticScene};
use endless_scene::Mesh;
use endless_town::{PlacedObject, Placement, Town};
use endless_world::{
    ClassTag, InstanceId, InstanceIdAllocator, ParkedVehicle, TooManyInstances, VehicleModelId, VehicleMotion,
};
use glam::Vec3;
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

/// A town ready to be traced. Load it once a map.
#[derive(Debug)]
pub struct TownScene {
    still: StaticScene,
    /// What each of its instances is part of.
    things: Vec<TownThing>,
    pub(crate) models: Arc<SharedModels>,
}

impl TownScene {
    /// Builds the town's meshes, props and parked vehicles (number i gets instance id i + 1).
    ///
    /// # Errors
    /// When more vehicles stand parked than [`endless_world::InstanceId`] can number.
    pub fn load(town: &Town, catalogue: &Catalogue) -> Result<Self, TooManyInstances> {
        Self::load_sharing(town, catalogue, Arc::default())
    }

    /// The same with models that other towns of this catalogue share.
    ///
    /// # Errors
    /// As [`Self::load`].
    pub fn load_sharing(
        town: &Town,
        catalogue: &Catalogue,
        models: Arc<SharedModels>,
    ) -> Result<Self, TooManyInstances> {
        // Large meshes and small ones side by side, so that no thread waits for another.
        let (placed, parked): (Vec<(TownThing, Instance)>, BTreeMap<VehicleModelId, VehicleGeometry>) = rayon::join(
            || placed(&town.meshes, &town.placements, &models, catalogue),
            || models.parked(town.parked.iter().map(|p| p.vehicle.model).collect(), catalogue),
        );
        let ids = InstanceIdAllocator::default().allocate_many(town.parked.len())?;
        let vehicle = |(number, (&id, vehicle)): (u32, (&InstanceId, &ParkedVehicle))| {
            let instances = parked_instances(vehicle, id, &parked, catalogue);
            instances.into_iter().map(move |instance| (TownThing::Parked(number), instance))
        };
        let vehicles = (0..).zip(ids.iter().zip(&town.parked)).flat_map(vehicle);
        let (things, instances) =
            placed.into_iter().chain(vehicles).filter(|(_, instance)| !instance.geometry().is_empty()).unzip();
        Ok(Self { still: StaticScene::new(instances, &town.lamps), things, models })
    }

    /// The same town without some of its things, or without those of their parts that are of some classes. All else keeps its
    /// number.
    #[must_use]
    pub fn without(&self, hides: impl Fn(TownThing, ClassTag) -> bool) -> Self {
        let mut remains = Remains::default();
        let left = |(thing, instance): (&TownThing, &Instance)| {
            Some((*thing, remains.of(instance, |class| hides(*thing, class))?))
        };
        let (things, instances) = self.things.iter().zip(self.still.instances()).filter_map(left).unzip();
        Self { still: self.still.made_of(instances), things, models: Arc::clone(&self.models) }
    }

    /// What stands still, for the renderer.
    pub fn static_scene(&self) -> &StaticScene {
        &self.still
    }
}

/// Instances of a town's own meshes and of props.
fn placed(
    meshes: &[Arc<Mesh>],
    placements: &[Placement],
    models: &SharedModels,
    catalogue: &Catalogue,
) -> Vec<(TownThing, Instance)> {
    let kinds = placements.iter().map(|placement| placement.object);
    let used: BTreeSet<PlacedObject> = kinds.filter(|what| matches!(what, PlacedObject::Prop(..))).collect();
    let (own, props): (Vec<Geometry>, BTreeMap<PlacedObject, Geometry>) = rayon::join(
        || meshes.par_iter().map(|mesh| Geometry::new(Arc::clone(mesh))).collect(),
        || models.props(used, catalogue),
    );
    let place = |(number, placement): (u32, &Placement)| {
        let geometry = match placement.object {
            PlacedObject::TownMesh(i) => own.get(i as usize),
            PlacedObject::Prop(..) => props.get(&placement.object),
        };
        let instance = Instance::new(geometry?, placement.world_from_object).with_signal(placement.signal);
        Some((TownThing::Placed(number), instance))
    };
    (0..).zip(placements).filter_map(place).collect()
}

fn parked_instances(
    parked: &ParkedVehicle,
    id: InstanceId,
    models: &BTreeMap<VehicleModelId, VehicleGeometry>,
    catalogue: &Catalogue,
) -> Vec<Instance> {
    let model = parked.vehicle.model;
    let (Some(entry), Some(geometry)) = (catalogue.vehicle(model), models.get(&model)) else {
        return vec![];
    };
    let tint = Vec3::from_array(entry.tint(parked.vehicle.variant));
    let placed = geometry.place(parked.pose.world_from_object(), &VehicleMotion::default(), RigidVelocity::ZERO);
    let dressed = |instance: Instance| instance.with_id(id, entry.spec.class.tag()).with_tint(tint);
    placed.towing.into_iter().chain(placed.trailer).map(dressed).collect()
}
