//! The models of those who move in a scene, made once a scene.

use super::{Body, Shape, StaticScene, ambient_occlusion::openness, model::model, static_scene::VehicleParts};
use crate::accel::Use;
use endless_asset::{Catalogue, PersonModel};
use endless_world::{Actor, Gait, PersonRef, VehicleModelId, VehicleRef, WalkerMotion};
use glam::Vec3A;
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Arc, Mutex, PoisonError},
};

/// Models of all actors of a scene.
pub struct Cast {
    vehicles: BTreeMap<VehicleModelId, VehicleCast>,
    people: BTreeMap<PersonRef, PersonCast>,
    riders: BTreeMap<VehicleRef, (Arc<Shape>, Arc<Body>)>,
    tints: BTreeMap<VehicleRef, Vec3A>,
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
    /// x of the rearmost point of the piece that steers.
    pub(crate) towing_rear: f32,
}

/// A person of the cast.
pub(crate) struct PersonCast {
    pub(crate) model: Arc<PersonModel>,
    pub(crate) shape: Arc<Shape>,
    rest: Arc<Body>,
    /// Bodies that were posed before: the memory of those that nobody holds any more is used again.
    posed: Mutex<Vec<Arc<Body>>>,
}

impl Cast {
    /// Models of these actors.
    pub fn new(catalogue: &Catalogue, actors: &[Actor]) -> Self {
        Self::made(catalogue, actors, &|_| None)
    }

    /// The same in a town of the same catalogue: vehicles that stand parked there are not made again.
    pub fn in_town(still: &StaticScene, catalogue: &Catalogue, actors: &[Actor]) -> Self {
        Self::made(catalogue, actors, &|model| still.parked.get(&model).cloned())
    }

    fn made(
        catalogue: &Catalogue,
        actors: &[Actor],
        parked: &(dyn Fn(VehicleModelId) -> Option<VehicleParts> + Sync),
    ) -> Self {
        // Everything is made by all threads, once.
        let driving: BTreeSet<VehicleRef> = actors.iter().filter_map(|a| a.asset.vehicle()).collect();
        let models: BTreeSet<VehicleModelId> = driving.iter().map(|v| v.model).collect();
        let dressed: BTreeSet<PersonRef> = actors.iter().filter_map(|a| a.asset.person()).collect();
        let ridden = actors.iter().filter(|a| a.rider_id.is_some());
        let ridden: BTreeSet<VehicleRef> = ridden.filter_map(|a| a.asset.vehicle()).collect();
        let (vehicles, (people, riders)) = rayon::join(
            || models.into_par_iter().filter_map(|m| Some((m, VehicleCast::of(catalogue, m, parked(m))?))).collect(),
            || {
                rayon::join(
                    || dressed.into_par_iter().filter_map(|key| Some((key, PersonCast::of(catalogue, key)?))).collect(),
                    || ridden.into_par_iter().filter_map(|key| Some((key, rider(catalogue, key)?))).collect(),
                )
            },
        );
        let tint = |vehicle| Some((vehicle, Vec3A::from_array(catalogue.vehicle_tint(vehicle)?)));
        Self { vehicles, people, riders, tints: driving.into_iter().filter_map(tint).collect() }
    }

    pub(crate) fn vehicle(&self, model: VehicleModelId) -> Option<&VehicleCast> {
        self.vehicles.get(&model)
    }

    pub(crate) fn person(&self, person: PersonRef) -> Option<&PersonCast> {
        self.people.get(&person)
    }

    pub(crate) fn rider(&self, vehicle: VehicleRef) -> Option<&(Arc<Shape>, Arc<Body>)> {
        self.riders.get(&vehicle)
    }

    pub(crate) fn tint(&self, vehicle: VehicleRef) -> Vec3A {
        self.tints.get(&vehicle).copied().unwrap_or(Vec3A::ONE)
    }
}

impl VehicleCast {
    fn of(catalogue: &Catalogue, model: VehicleModelId, made: Option<VehicleParts>) -> Option<Self> {
        let entry = catalogue.vehicle(model)?;
        let mut parts = made.unwrap_or_else(|| VehicleParts::new(entry));
        let extent = Vec3A::new(entry.spec.length_m / 2.0, entry.spec.width_m / 2.0, entry.spec.height_m);
        let low = Vec3A::new(-extent.x, -extent.y, 0.0);
        for part in [&mut parts.body, &mut parts.wheel] {
            shade_by_itself(part, low, extent);
        }
        if let Some(trailer) = &mut parts.trailer {
            shade_by_itself(&mut trailer.body, trailer.low, trailer.high);
        }
        let lenses = entry.headlights();
        let headlight =
            (!lenses.is_empty()).then(|| lenses.iter().map(|&p| Vec3A::from(p)).sum::<Vec3A>() / lenses.len() as f32);
        let towing_rear = entry.spec.trailer.map_or(-extent.x, |t| t.towing_rear_m);
        Some(Self { parts, extent, headlight, half_length: extent.x, towing_rear })
    }
}

impl PersonCast {
    fn of(catalogue: &Catalogue, person: PersonRef) -> Option<Self> {
        let person = Arc::new(catalogue.dressed_person(person));
        let mut parts = model(Arc::clone(&person.rest), Use::Deforming);
        shade_in_motion(&mut parts, &person);
        let (shape, rest) = parts?;
        Some(Self { model: person, shape, rest, posed: Mutex::default() })
    }

    /// The body as it stands in a motion.
    pub(crate) fn posed(&self, motion: &WalkerMotion) -> Arc<Body> {
        let mut body = self.spare().unwrap_or_else(|| self.rest.as_ref().clone());
        body.pose(&self.model, motion);
        let body = Arc::new(body);
        self.posed.lock().unwrap_or_else(PoisonError::into_inner).push(Arc::clone(&body));
        body
    }

    /// A body that was posed for an instant that is gone.
    fn spare(&self) -> Option<Body> {
        let mut posed = self.posed.lock().unwrap_or_else(PoisonError::into_inner);
        let free = posed.iter().position(|body| Arc::strong_count(body) == 1)?;
        Arc::into_inner(posed.swap_remove(free))
    }
}

/// Who rides a vehicle.
fn rider(catalogue: &Catalogue, vehicle: VehicleRef) -> Option<(Arc<Shape>, Arc<Body>)> {
    let mut rider = catalogue.rider(vehicle).and_then(|mesh| model(mesh.into(), Use::Rigid));
    let high = Vec3A::new(0.5, 0.4, 1.8);
    shade_by_itself(&mut rider, Vec3A::new(-0.5, -0.4, 0.0), high);
    rider
}

/// Fills in the openness of a person in mid-stride: legs and arms that touch at rest would be dark for ever.
fn shade_in_motion(parts: &mut Option<(Arc<Shape>, Arc<Body>)>, person: &Arc<PersonModel>) {
    let Some((shape, rest)) = parts else { return };
    let stride = WalkerMotion { speed_mps: 1.3, gait: Gait::Walk, ..WalkerMotion::default() };
    let mut body = rest.as_ref().clone();
    body.pose(person, &stride);
    let open = openness(&body, Vec3A::new(-0.25, -0.3, 0.0), Vec3A::new(0.25, 0.3, person.height_m));
    Arc::make_mut(shape).openness = open;
}

/// Fills in a model's openness.
fn shade_by_itself(part: &mut Option<(Arc<Shape>, Arc<Body>)>, low: Vec3A, high: Vec3A) {
    let Some((shape, body)) = part else { return };
    let open = openness(body, low, high);
    Arc::make_mut(shape).openness = open;
}
