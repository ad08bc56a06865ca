//! Traffic lights and signs of an episode.

use super::actor::{Body, ServerActor};
use super::call_error::CallError;
use super::episode::Episode;
use crate::blueprint::BlueprintLibrary;
use crate::map::LightState;
use crate::stream::{LightRecord, VehicleRecord};
use crate::wire::BoundingBox;
use endless_world::{SignalAspect, SignalState};
use std::sync::Arc;

/// Kilometres an hour far from all lanes.
const USUAL_LIMIT: f32 = 50.0;

impl Episode {
    /// Puts up the lights and signs of the map.
    pub(super) fn put_up_signals(&mut self, blueprints: &BlueprintLibrary) {
        let map = Arc::clone(&self.map);
        if let Some(blueprint) = blueprints.find("traffic.traffic_light") {
            for (place, light) in map.roads.traffic_lights().iter().enumerate() {
                let id = self.allocate_id();
                let mut actor = ServerActor::own(blueprint, id, light.pole.clone(), Body::Light(place));
                actor.told.bounding_box = BoundingBox { actor_id: id, ..light.trigger_volume.clone() };
                self.insert(actor);
                self.light_ids.push(id);
            }
        }
        for sign in map.roads.traffic_signs() {
            let Some(blueprint) = blueprints.find(&sign.kind.blueprint()) else { continue };
            let id = self.allocate_id();
            let body = Body::Sign(sign.sign_id.clone());
            let mut actor = ServerActor::own(blueprint, id, sign.pole.clone(), body);
            actor.told.bounding_box = BoundingBox { actor_id: id, ..sign.trigger_volume.clone() };
            self.insert(actor);
        }
    }

    /// The place in the map's list of an actor that is a traffic light.
    pub(super) fn light(&self, id: u32) -> Result<usize, CallError> {
        match self.actor(id)?.body {
            Body::Light(light) => Ok(light),
            _ => Err(CallError::refused(format!("actor {id} is not a traffic light"))),
        }
    }

    /// Puts a light into a state until its cycle changes it.
    pub(super) fn set_light_state(&mut self, id: u32, state: u8) -> Result<(), CallError> {
        let light = self.light(id)?;
        let state = LightState::from_number(state).ok_or_else(|| CallError::refused("a light shows 0 to 3"))?;
        self.lights.set_state(light, state);
        Ok(())
    }

    /// What the map's signals show, as the renderer draws them. Those that hold up nobody on wheels stay red.
    pub(super) fn signals(&self) -> Vec<SignalState> {
        let mut shown =
            vec![SignalState { aspect: SignalAspect::Red }; usize::from(self.map.town.network.signal_groups)];
        for (place, light) in self.map.roads.traffic_lights().iter().enumerate() {
            let aspect = match self.lights.state(place) {
                LightState::Green => SignalAspect::Green,
                LightState::Yellow => SignalAspect::Yellow,
                LightState::Red | LightState::Off => SignalAspect::Red,
            };
            if let Some(state) = shown.get_mut(usize::from(light.signal.0)) {
                *state = SignalState { aspect };
            }
        }
        shown
    }

    /// What snapshots tell of a light.
    pub(super) fn light_record(&self, light: usize) -> LightRecord {
        let times = self.lights.times(light);
        let of_map = self.map.roads.traffic_lights().get(light);
        LightRecord {
            sign_id: of_map.map_or_else(String::new, |light| light.sign_id.clone()),
            green_time: times.green_s,
            yellow_time: times.yellow_s,
            red_time: times.red_s,
            elapsed_time: self.lights.elapsed_s(light) as f32,
            pole_index: of_map.map_or(0, |light| light.pole_index),
            frozen: self.lights.is_frozen(light),
            state: self.lights.state(light).number(),
        }
    }

    /// What snapshots tell of the road that a vehicle is on.
    pub(super) fn on_road(&self, actor: &ServerActor) -> VehicleRecord {
        let place = &actor.transform.location;
        let roads = &self.map.roads;
        let light = roads.light_at(place);
        let state = light.map_or(LightState::Green, |light| self.lights.state(light));
        VehicleRecord {
            speed_limit: roads.speed_limit_kmh(place).unwrap_or(USUAL_LIMIT),
            traffic_light_state: state.number(),
            traffic_light: light.and_then(|light| self.light_ids.get(light).copied()),
            ..VehicleRecord::default()
        }
    }
}
