//! What stays the same of the objects of a scene, as the catalogue knows it.

use endless_annotate::ActorRecord;
use endless_asset::Catalogue;
use endless_world::{Actor, ObjectClass, VehicleRef};

/// Describes these actors and those who ride them, by ascending id.
pub(super) fn describe<'a>(catalogue: &Catalogue, actors: impl Iterator<Item = &'a Actor>) -> Vec<ActorRecord> {
    let mut records: Vec<ActorRecord> =
        actors.flat_map(|actor| [Some(own(catalogue, actor)), rider(catalogue, actor)]).flatten().collect();
    records.sort_by_key(|record| record.id);
    records
}

fn own(catalogue: &Catalogue, actor: &Actor) -> ActorRecord {
    let vehicle = |vehicle: VehicleRef| catalogue.vehicle_attributes(vehicle);
    ActorRecord {
        reid: catalogue.reid(actor.asset),
        rider_id: actor.rider_id,
        vehicle: actor.asset.vehicle().and_then(vehicle),
        person: actor.asset.person().map(Catalogue::person_attributes),
        ..ActorRecord::new(actor.id, actor.class, actor.parked)
    }
}

fn rider(catalogue: &Catalogue, actor: &Actor) -> Option<ActorRecord> {
    let VehicleRef { model, variant } = actor.asset.vehicle()?;
    let model = catalogue.vehicle(model)?;
    Some(ActorRecord {
        reid: model.rider_reid(variant),
        vehicle_id: Some(actor.id),
        person: model.rider_attributes(variant),
        ..ActorRecord::new(actor.rider_id?, ObjectClass::Rider, actor.parked)
    })
}
