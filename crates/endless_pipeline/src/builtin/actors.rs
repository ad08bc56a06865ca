//! What stays the same of the objects of a scene, as the catalogue knows it.

use endless_annotate::ActorRecord;
use endless_asset::Catalogue;
use endless_render::occupants;
use endless_world::{Actor, ObjectClass, Occupants, VehicleRef};

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
        occupants: actor.asset.vehicle().and_then(|vehicle| cabin(catalogue, actor, vehicle)),
        person: actor.asset.person().map(Catalogue::person_attributes),
        ..ActorRecord::new(actor.id, actor.class, actor.parked)
    }
}

/// Who sits in a vehicle that has a cabin: nobody where it is parked.
fn cabin(catalogue: &Catalogue, actor: &Actor, vehicle: VehicleRef) -> Option<Occupants> {
    let model = catalogue.vehicle(vehicle.model)?;
    let hind = model.trailer().filter(|_| actor.class == ObjectClass::Bus).map(|trailer| &*trailer.body);
    let driving = occupants(model.body(), hind, actor.class.tag(), actor.id)?;
    Some(if actor.parked { Occupants::default() } else { driving })
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

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::InstanceId;
    use rayon::prelude::*;

    #[test]
    fn what_has_a_wheel_to_sit_at_shows_who_does() {
        Catalogue::builtin().vehicles().par_iter().for_each(|model| {
            let class = model.spec.class;
            let seen = |mesh| occupants(mesh, None, class.tag(), InstanceId(1));
            assert_eq!(seen(model.body()).is_some(), !model.spec.ridden, "{}", model.name());
            // Nobody travels in a trailer, but in the hind part of a bus.
            let hind = model.trailer().and_then(|trailer| seen(&trailer.body));
            assert_eq!(hind.is_some(), class == ObjectClass::Bus && model.trailer().is_some(), "{}", model.name());
        });
    }
}
