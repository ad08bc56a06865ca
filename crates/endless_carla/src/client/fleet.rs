//! The vehicles and people that a server's library has, as traffic knows them.

use super::body::{ActorBody, class};
use super::error::ClientError;
use super::world::World;
use crate::blueprint::BlueprintLibrary;
use crate::wire::{
    ActorAttribute, ActorAttributeValue, ActorDefinition, ActorDescription, Command, Location, SpawnActor, Transform,
};
use endless_asset::Catalogue;
use endless_world::{ObjectClass, Stream, VehicleSpec, fnv1a};

/// What may be spawned.
pub(super) struct Fleet {
    vehicles: Vec<ActorDefinition>,
    /// As traffic knows them, in the same order.
    pub(super) specs: Vec<VehicleSpec>,
    walkers: Vec<ActorDefinition>,
}

/// Where actors are put that shall meet nobody, metres above the map.
const SKY_M: f32 = 400.0;
/// Between them, metres.
const APART_M: f32 = 25.0;

/// A place in the sky with room for a lorry.
pub(super) fn in_the_sky(number: usize) -> Transform {
    let (row, column) = (number / 16, number % 16);
    let location = Location { x: column as f32 * APART_M, y: row as f32 * APART_M, z: SKY_M };
    Transform { location, ..Transform::default() }
}

impl Fleet {
    /// Asks a server what it has, and how large that is: one of each is put into the sky and taken away.
    pub(super) fn of(
        world: &mut World,
        library: &BlueprintLibrary,
        catalogue: &Catalogue,
    ) -> Result<Self, ClientError> {
        let all = world.definitions()?;
        let (walkers, others): (Vec<_>, Vec<_>) = all.into_iter().partition(|d| d.id.starts_with("walker."));
        let vehicles: Vec<_> = others.into_iter().filter(|d| d.id.starts_with("vehicle.")).collect();
        let put = |(number, definition): (usize, &ActorDefinition)| {
            Command::SpawnActor(Box::new(SpawnActor {
                description: described(definition, &[]),
                transform: in_the_sky(number),
                ..SpawnActor::default()
            }))
        };
        let put: Vec<Command> = vehicles.iter().enumerate().map(put).collect();
        // Also when the user wants to stop meanwhile: nobody stays in the sky.
        let (spawned, actors) = world.stop().clone().pause(|| {
            let spawned = world.batch(&put)?;
            let ids: Vec<u32> = spawned.iter().filter_map(|result| result.as_ref().ok().copied()).collect();
            let actors = world.actors(&ids)?;
            world.batch(&ids.iter().map(|actor| Command::DestroyActor { actor: *actor }).collect::<Vec<_>>())?;
            Ok::<_, ClientError>((spawned, actors))
        })?;
        let body = |result: &Result<u32, String>| {
            let id = result.as_ref().ok()?;
            ActorBody::new(actors.iter().find(|actor| actor.id == *id)?, library, catalogue)
        };
        let (mut kept, mut specs) = (Vec::new(), Vec::new());
        for (definition, result) in vehicles.into_iter().zip(&spawned) {
            let Some(body) = body(result) else { continue };
            specs.push(spec(&definition, &body));
            kept.push(definition);
        }
        if kept.is_empty() || walkers.is_empty() {
            return Err(ClientError::Unusable("it has no vehicles or no people to spawn".to_owned()));
        }
        Ok(Self { vehicles: kept, specs, walkers })
    }

    /// A vehicle by its place in the list, in a colour drawn by a seed.
    pub(super) fn vehicle(&self, place: usize, seed: u64) -> ActorDescription {
        let definition = &self.vehicles[place % self.vehicles.len()];
        let mut stream = Stream::named(seed, "carla vehicle", &[]);
        let drawn = |attribute: &ActorAttribute, stream: &mut Stream| {
            let count = attribute.recommended_values.len();
            (count > 0).then(|| attribute.recommended_values[(stream.next_u64() % count as u64) as usize].clone())
        };
        let mut changed = vec![("role_name", "autopilot".to_owned())];
        for name in ["color", "driver_id"] {
            let attribute = definition.attributes.iter().find(|attribute| attribute.id == name);
            changed.extend(attribute.and_then(|attribute| Some((name, drawn(attribute, &mut stream)?))));
        }
        described(definition, &changed)
    }

    /// A person drawn by a seed.
    pub(super) fn walker(&self, seed: u64) -> ActorDescription {
        let place = Stream::named(seed, "carla walker", &[]).next_u64() % self.walkers.len() as u64;
        described(&self.walkers[place as usize], &[("is_invincible", "false".to_owned())])
    }
}

/// A blueprint's description, with some attributes changed; those that it does not have are left out.
pub(super) fn described(definition: &ActorDefinition, changed: &[(&str, String)]) -> ActorDescription {
    let value = |attribute: &ActorAttribute| {
        let change = changed.iter().find(|(name, _)| *name == attribute.id);
        change.map_or_else(|| attribute.value.clone(), |(_, value)| value.clone())
    };
    let attributes = definition.attributes.iter().map(|attribute| ActorAttributeValue {
        id: attribute.id.clone(),
        kind: attribute.kind,
        value: value(attribute),
    });
    ActorDescription { uid: definition.uid, id: definition.id.clone(), attributes: attributes.collect() }
}

/// A vehicle as traffic knows it.
fn spec(definition: &ActorDefinition, body: &ActorBody) -> VehicleSpec {
    let class = class(&described(definition, &[])).unwrap_or(body.class);
    let (cruise_mps, acceleration_mps2, frequency) = match class {
        ObjectClass::Bicycle => (5.0, 1.0, 0.5),
        ObjectClass::Motorcycle => (34.0, 2.2, 0.5),
        ObjectClass::Truck | ObjectClass::Bus => (22.0, 1.0, 0.4),
        _ => (38.0, 1.8, 1.0),
    };
    VehicleSpec {
        name: "imported",
        draw: fnv1a(definition.id.bytes()),
        class,
        length_m: body.size.x,
        width_m: body.size.y,
        height_m: body.size.z,
        front_axle_m: 0.3 * body.size.x,
        rear_axle_m: -0.3 * body.size.x,
        cruise_mps,
        acceleration_mps2,
        frequency,
        ridden: body.is_ridden,
        ..VehicleSpec::default()
    }
}
