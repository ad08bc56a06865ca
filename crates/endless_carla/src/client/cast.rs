//! Who is on a map: spawned in batches, as the paper's Algorithm 1 does, and taken away in the end.

use super::body::ActorBody;
use super::error::ClientError;
use super::fleet::{Fleet, in_the_sky};
use super::world::World;
use crate::blueprint::BlueprintLibrary;
use crate::wire::{self, Command, SpawnActor, Transform};
use endless_asset::Catalogue;
use endless_world::{InstanceId, ObjectClass, Stream};
use std::collections::BTreeMap;

/// The actors of a session.
#[derive(Default)]
pub(super) struct Cast {
    /// All that must be taken away, in the order in which they came.
    spawned: Vec<u32>,
    pub(super) bodies: BTreeMap<u32, ActorBody>,
    /// As the server tells of them.
    pub(super) told: BTreeMap<u32, wire::Actor>,
    /// Ids of our traffic's actors as the server's.
    pub(super) of_traffic: BTreeMap<InstanceId, u32>,
}

/// What is needed to know bodies.
pub(super) struct Casting<'a> {
    pub(super) world: &'a mut World,
    pub(super) fleet: &'a Fleet,
    pub(super) blueprints: &'a BlueprintLibrary,
    pub(super) catalogue: &'a Catalogue,
    pub(super) seed: u64,
}

impl Cast {
    /// Spawns all that our own traffic moves, where they meet nobody: they are put into their places with every frame.
    pub(super) fn spawn_moved(
        &mut self,
        casting: &mut Casting<'_>,
        actors: &[endless_world::Actor],
    ) -> Result<(), ClientError> {
        let spawn = |(number, actor): (usize, &endless_world::Actor)| {
            let seed = casting.seed ^ u64::from(actor.id.0);
            let description = match actor.asset.vehicle() {
                Some(vehicle) => casting.fleet.vehicle(vehicle.model.index(), seed),
                None => casting.fleet.walker(seed),
            };
            let still = Command::SetSimulatePhysics { actor: 0, enabled: false };
            Command::SpawnActor(Box::new(SpawnActor {
                description,
                transform: in_the_sky(number),
                do_after: vec![still],
                ..SpawnActor::default()
            }))
        };
        let commands: Vec<Command> = actors.iter().enumerate().map(spawn).collect();
        let ids = self.run(casting, &commands)?;
        for (actor, id) in actors.iter().zip(ids) {
            if let Some(id) = id {
                self.of_traffic.insert(actor.id, id);
            }
        }
        Ok(())
    }

    /// Spawns vehicles at the map's own places, in the order of a draw: a TrafficManager will drive them.
    pub(super) fn spawn_driven(&mut self, casting: &mut Casting<'_>, count: u32) -> Result<(), ClientError> {
        let mut places = casting.world.map_info()?.recommended_spawn_points;
        let mut stream = Stream::named(casting.seed, "carla spawn points", &[]);
        for left in (1..places.len()).rev() {
            places.swap(left, (stream.next_u64() % (left as u64 + 1)) as usize);
        }
        let seed = casting.seed;
        let spawn = |(number, transform): (u64, &Transform)| {
            let model = Stream::named(seed, "carla model", &[number]).next_u64() as usize % casting.fleet.specs.len();
            Command::SpawnActor(Box::new(SpawnActor {
                description: casting.fleet.vehicle(model, seed ^ number),
                transform: transform.clone(),
                do_after: vec![Command::SetAutopilot { actor: 0, enabled: true }],
                ..SpawnActor::default()
            }))
        };
        // Some places may not be free: others take their part.
        let mut places = (0..).zip(&places);
        let mut missing = count as usize;
        while missing > 0 {
            let commands: Vec<Command> = places.by_ref().take(missing).map(spawn).collect();
            if commands.is_empty() {
                break;
            }
            missing -= self.run(casting, &commands)?.into_iter().flatten().count();
        }
        Ok(())
    }

    /// Runs commands that spawn: the new actor of each, if it was made.
    fn run(&mut self, casting: &mut Casting<'_>, commands: &[Command]) -> Result<Vec<Option<u32>>, ClientError> {
        let results = casting.world.spawn(commands)?;
        let ids: Vec<Option<u32>> = results
            .into_iter()
            .map(|result| result.inspect_err(|text| tracing::debug!("an actor was not spawned: {text}")).ok())
            .collect();
        let new: Vec<u32> = ids.iter().flatten().copied().collect();
        self.spawned.extend(&new);
        for actor in casting.world.actors(&new)? {
            if let Some(body) = ActorBody::new(&actor, casting.blueprints, casting.catalogue) {
                self.bodies.insert(actor.id, body);
            }
            self.told.insert(actor.id, actor);
        }
        Ok(ids)
    }

    /// Spawns sensors at a place; the token of each.
    pub(super) fn spawn_sensors(
        &mut self,
        world: &mut World,
        sensors: &[(wire::ActorDescription, Transform)],
    ) -> Result<Vec<wire::Bytes>, ClientError> {
        let spawn = |(description, transform): &(wire::ActorDescription, Transform)| {
            Command::SpawnActor(Box::new(SpawnActor {
                description: description.clone(),
                transform: transform.clone(),
                ..SpawnActor::default()
            }))
        };
        let results = world.spawn(&sensors.iter().map(spawn).collect::<Vec<_>>())?;
        self.spawned.extend(results.iter().filter_map(|result| result.as_ref().ok()));
        let refused = |text| ClientError::Unusable(format!("it spawns no camera: {text}"));
        let ids = results.into_iter().map(|result| result.map_err(refused)).collect::<Result<Vec<u32>, _>>()?;
        let actors = world.actors(&ids)?;
        let token = |id: &u32| actors.iter().find(|actor| actor.id == *id).map(|actor| actor.stream_token.clone());
        let lost = || ClientError::Unfit("a camera was gone as soon as it was spawned".to_owned());
        ids.iter().map(|id| token(id).ok_or_else(lost)).collect()
    }

    /// How many of a class.
    pub(super) fn count(&self, is: impl Fn(ObjectClass) -> bool) -> u32 {
        self.bodies.values().filter(|body| is(body.class)).count() as u32
    }

    /// Vehicles as the server tells of them.
    pub(super) fn vehicles(&self) -> Vec<wire::Actor> {
        let is_vehicle = |(id, _): &(&u32, &wire::Actor)| {
            self.bodies.get(id).is_some_and(|body| body.class != ObjectClass::Pedestrian)
        };
        self.told.iter().filter(is_vehicle).map(|(_, actor)| actor.clone()).collect()
    }

    /// Takes all away, the last first: sensors before what they look at.
    pub(super) fn leave(&mut self, world: &mut World) -> Result<(), ClientError> {
        let spawned = std::mem::take(&mut self.spawned);
        let commands: Vec<Command> =
            spawned.iter().rev().map(|actor| Command::DestroyActor { actor: *actor }).collect();
        if commands.is_empty() { Ok(()) } else { world.batch(&commands).map(drop) }
    }
}
