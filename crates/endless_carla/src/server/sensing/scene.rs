//! Actors as the renderer draws them.

use crate::blueprint::PropBody;
use crate::frames;
use crate::instance::instance_id;
use crate::server::actor::{Body, PropActor, ServerActor};
use crate::server::episode::Episode;
use crate::wire::Transform;
use endless_asset::Catalogue;
use endless_city::{ActorModels, PlacedProp};
use endless_render::FrameScene;
use endless_world::{Actor, Behaviour, ClassTag, Motion, ObjectClass, WorldState};
use std::sync::Arc;

/// The models of an episode's actors, made again when others come.
#[derive(Default)]
pub(super) struct ActorScene {
    made: Option<(u64, ActorModels)>,
    /// The last instant that was asked for: rays between two frames meet the same.
    posed: Option<(WorldState, Vec<PlacedProp>, Arc<FrameScene>)>,
}

impl ActorScene {
    /// What moves at this instant.
    pub(super) fn at(&mut self, episode: &Episode, catalogue: &Catalogue) -> Arc<FrameScene> {
        let actors: Vec<Actor> = episode.actors.values().filter_map(|actor| drawn(actor, episode.elapsed_s)).collect();
        let props: Vec<PlacedProp> = episode.actors.values().filter_map(prop).collect();
        let is_known = self.made.as_ref().is_some_and(|(population, _)| *population == episode.population);
        if !is_known {
            let town = &episode.map.scene;
            let models = ActorModels::in_town(town, catalogue, &actors).with_props(town, catalogue, &props);
            self.made = Some((episode.population, models));
            self.posed = None;
        }
        let state =
            WorldState { frame: episode.frame as u32, time_s: episode.elapsed_s, actors, signals: episode.signals() };
        if let Some((_, _, scene)) = self.posed.as_ref().filter(|(posed, among, _)| *posed == state && *among == props)
        {
            return Arc::clone(scene);
        }
        let scene = Arc::new(match &self.made {
            Some((_, models)) => models.frame_scene_among(&state, &props),
            None => ActorModels::new(catalogue, &[]).frame_scene(&state),
        });
        self.posed = Some((state, props, Arc::clone(&scene)));
        scene
    }
}

/// Vehicles and people; their number in pictures is that of the actor.
fn drawn(actor: &ServerActor, time_s: f64) -> Option<Actor> {
    let id = instance_id(actor.told.id);
    let (class, asset, motion, rider) = match &actor.body {
        Body::Vehicle(vehicle) => {
            (vehicle.class, vehicle.asset.into(), Motion::Vehicle(vehicle.motion()), vehicle.is_ridden.then_some(id))
        }
        Body::Walker(walker) => {
            (ObjectClass::Pedestrian, walker.asset.into(), Motion::Walker(walker.motion(time_s)), None)
        }
        _ => return None,
    };
    Some(Actor {
        id,
        rider_id: rider,
        class,
        asset,
        pose: frames::pose(&on_ground(actor)),
        velocity_mps: frames::from_carla(&actor.velocity),
        motion,
        behaviour: Behaviour::default(),
        parked: false,
    })
}

/// A prop that has a body.
fn prop(actor: &ServerActor) -> Option<PlacedProp> {
    let Body::Prop(PropActor { body: Some(PropBody { prop, variant }), .. }) = actor.body else { return None };
    let class = actor.told.semantic_tags.0.first().copied().and_then(ClassTag::from_value);
    Some(PlacedProp {
        id: instance_id(actor.told.id),
        class: class.unwrap_or(ClassTag::Static),
        prop,
        variant,
        world_from_object: frames::pose(&actor.transform).world_from_object(),
    })
}

/// CARLA's people have their place in their middle, ours under their feet.
fn on_ground(actor: &ServerActor) -> Transform {
    match &actor.body {
        Body::Walker(walker) => walker.on_ground(&actor.transform),
        _ => actor.transform.clone(),
    }
}
