//! The models of those who move in a scene, made once a scene.

use super::{Body, Shape, ambient_occlusion::openness, model::model, static_scene::VehicleParts};
use endless_asset::{Catalogue, PersonModel};
use endless_world::{Actor, AssetRef, Gait, Motion, WalkerMotion};
use glam::Vec3A;
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

/// Models of all actors of a scene.
pub struct Cast {
    vehicles: BTreeMap<u16, VehicleCast>,
    people: BTreeMap<(u16, u64), PersonCast>,
    riders: BTreeMap<(u16, u64), (Arc<Shape>, Arc<Body>)>,
    tints: BTreeMap<(u16, u64), Vec3A>,
}

/// A vehicle model of the cast.
pub(crate) struct VehicleCast {
    pub(crate) parts: VehicleParts,
    /// Half length, half width, height.
    pub(crate) extent: Vec3A,
    /// Mid-point between the headlights, in the object frame; `None` without headlights.
    pub(crate) headlight: Option<Vec3A>,
    /// Half length, for the tail lights.
    pub(crate) half_length: f32,
}

/// A person of the cast.
pub(crate) struct PersonCast {
    pub(crate) model: PersonModel,
    pub(crate) shape: Arc<Shape>,
    pub(crate) rest: Arc<Body>,
}

impl Cast {
    /// Models of these actors.
    pub fn new(catalogue: &Catalogue, actors: &[Actor]) -> Self {
        let mut cast = Self {
            vehicles: BTreeMap::new(),
            people: BTreeMap::new(),
            riders: BTreeMap::new(),
            tints: BTreeMap::new(),
        };
        // Meshes are made when they are first asked for: by all threads, once.
        let models: BTreeSet<u16> =
            actors.iter().filter(|a| matches!(a.motion, Motion::Vehicle(_))).map(|a| a.asset.model).collect();
        models.into_par_iter().filter_map(|m| catalogue.vehicles().get(usize::from(m))).for_each(|entry| {
            entry.body();
        });
        for actor in actors {
            match actor.motion {
                Motion::Vehicle(_) => cast.add_vehicle(catalogue, actor),
                Motion::Walker(_) => cast.add_person(catalogue, actor.asset),
            }
        }
        cast
    }

    fn add_vehicle(&mut self, catalogue: &Catalogue, actor: &Actor) {
        let AssetRef { model: index, variant } = actor.asset;
        let Some(entry) = catalogue.vehicles().get(usize::from(index)) else { return };
        self.vehicles.entry(index).or_insert_with(|| {
            let mut parts = VehicleParts::new(entry);
            let extent = Vec3A::new(entry.spec.length_m / 2.0, entry.spec.width_m / 2.0, entry.spec.height_m);
            let low = Vec3A::new(-extent.x, -extent.y, 0.0);
            for part in [&mut parts.body, &mut parts.wheel] {
                shade_by_itself(part, low, extent);
            }
            let lenses = entry.headlights();
            let headlight = (!lenses.is_empty())
                .then(|| lenses.iter().map(|&p| Vec3A::from(p)).sum::<Vec3A>() / lenses.len() as f32);
            VehicleCast { parts, extent, headlight, half_length: extent.x }
        });
        self.tints.entry((index, variant)).or_insert_with(|| Vec3A::from_array(catalogue.vehicle_tint(index, variant)));
        if actor.rider_id.is_some() && !self.riders.contains_key(&(index, variant)) {
            let mut rider = catalogue.rider(index, variant).as_ref().and_then(model);
            let high = Vec3A::new(0.5, 0.4, 1.8);
            shade_by_itself(&mut rider, Vec3A::new(-0.5, -0.4, 0.0), high);
            if let Some(rider) = rider {
                self.riders.insert((index, variant), rider);
            }
        }
    }

    fn add_person(&mut self, catalogue: &Catalogue, asset: AssetRef) {
        let key = (asset.model, asset.variant);
        if self.people.contains_key(&key) {
            return;
        }
        let person = catalogue.person_of(asset);
        let mut parts = model(&person.rest);
        shade_in_motion(&mut parts, &person);
        if let Some((shape, rest)) = parts {
            self.people.insert(key, PersonCast { model: person, shape, rest });
        }
    }

    pub(crate) fn vehicle(&self, model: u16) -> Option<&VehicleCast> {
        self.vehicles.get(&model)
    }

    pub(crate) fn person(&self, asset: AssetRef) -> Option<&PersonCast> {
        self.people.get(&(asset.model, asset.variant))
    }

    pub(crate) fn rider(&self, asset: AssetRef) -> Option<&(Arc<Shape>, Arc<Body>)> {
        self.riders.get(&(asset.model, asset.variant))
    }

    pub(crate) fn tint(&self, asset: AssetRef) -> Vec3A {
        self.tints.get(&(asset.model, asset.variant)).copied().unwrap_or(Vec3A::ONE)
    }
}

/// Fills in the openness of a person in mid-stride: legs and arms that touch at rest would be dark for ever.
fn shade_in_motion(parts: &mut Option<(Arc<Shape>, Arc<Body>)>, person: &PersonModel) {
    let Some((shape, rest)) = parts else { return };
    let stride = WalkerMotion { speed_mps: 1.3, gait: Gait::Walk, ..WalkerMotion::default() };
    let pose = person.pose(&stride);
    let mut blas = (*rest.blas).clone();
    blas.refit(&pose.positions);
    let body = Body { positions: pose.positions, normals: pose.normals, blas: Arc::new(blas) };
    let open = openness(shape, &body, Vec3A::new(-0.25, -0.3, 0.0), Vec3A::new(0.25, 0.3, person.height_m));
    if let Some(shape) = Arc::get_mut(shape) {
        shape.openness = open;
    }
}

/// Fills in a model's openness.
fn shade_by_itself(part: &mut Option<(Arc<Shape>, Arc<Body>)>, low: Vec3A, high: Vec3A) {
    let Some((shape, body)) = part else { return };
    let open = openness(shape, body, low, high);
    if let Some(shape) = Arc::get_mut(shape) {
        shape.openness = open;
    }
}
