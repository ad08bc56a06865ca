//! The rig of a scene: who carries its sensors, and where these are.

use super::carrier_fit::{CarrierBody, looks_out};
use crate::SimulatorError;
use endless_render::FrameScene;
use endless_traffic::{DrivingCondition, Simulation};
use endless_world::{
    Actor, Carrier, InstanceId, ObjectClass, PinholeCamera, SceneSensor, SceneSettings, SensorMount, SensorPose,
    WorldState, carried,
};
use std::collections::BTreeMap;

/// Places of a sensor's way that are looked at before it is filmed.
const LOOKED_AT: u32 = 64;

/// The sensors of a video, and what a first run of its traffic tells of them.
pub(super) struct SceneRig {
    sensors: Vec<SceneSensor>,
    fps: f64,
    /// Of each sensor, its carrier.
    carriers: Vec<Option<InstanceId>>,
    /// Of each camera that moves, how it stands along its way.
    ways: Vec<Vec<PinholeCamera>>,
    /// The carriers at frame 1: what turns at frame 0 is told by it.
    second: BTreeMap<InstanceId, Actor>,
}

/// Who moves, and how far: the traffic of a video, run once before it is filmed.
struct Scouted {
    /// Way of each who is there in all frames, metres.
    ways_m: BTreeMap<InstanceId, f64>,
    /// Everybody at some frames, among them the first, the second and the last.
    states: Vec<WorldState>,
}

impl SceneRig {
    /// Of a scene whose traffic has not begun. `condition` tells the weather of a frame, `draw` shows who is there in a state.
    ///
    /// # Errors
    /// [`SimulatorError::NoCarrier`], [`SimulatorError::NoCarrierFits`].
    pub(super) fn new(
        simulation: &Simulation,
        settings: &SceneSettings,
        condition: impl Fn(u32) -> DrivingCondition,
        draw: impl Fn(&WorldState) -> FrameScene,
    ) -> Result<Self, SimulatorError> {
        let sensors = settings.sensors.clone();
        let mut rig = Self {
            fps: settings.fps,
            carriers: vec![None; sensors.len()],
            ways: vec![Vec::new(); sensors.len()],
            second: BTreeMap::new(),
            sensors,
        };
        if rig.sensors.iter().all(|sensor| sensor.mount.is_still()) {
            return Ok(rig);
        }
        let is_carried = rig.sensors.iter().any(|sensor| sensor.mount.carrier().is_some());
        let scouted = scout(simulation, settings, is_carried, condition);
        let mut chosen: BTreeMap<Carrier, InstanceId> = BTreeMap::new();
        for (place, sensor) in rig.sensors.iter().enumerate() {
            let Some(by) = sensor.mount.carrier() else { continue };
            let id = match chosen.get(&by) {
                Some(id) => *id,
                None => scouted.carrier(by, settings, &draw)?,
            };
            chosen.insert(by, id);
            rig.carriers[place] = Some(id);
        }
        let at_second = scouted.states.iter().find(|state| state.frame == 1);
        let carriers = |actor: &&Actor| rig.carriers.contains(&Some(actor.id));
        rig.second = at_second
            .map(|state| state.actors.iter().filter(carriers).map(|actor| (actor.id, *actor)).collect())
            .unwrap_or_default();
        for place in 0..rig.sensors.len() {
            rig.ways[place] = scouted.states.iter().filter_map(|state| rig.camera(place, state)).collect();
        }
        Ok(rig)
    }

    /// Who carries a sensor.
    pub(super) fn carrier(&self, sensor: usize) -> Option<InstanceId> {
        self.carriers[sensor]
    }

    /// All who carry one.
    pub(super) fn carriers(&self, state: &WorldState) -> BTreeMap<InstanceId, Actor> {
        let carries = |actor: &&Actor| self.carriers.contains(&Some(actor.id));
        state.actors.iter().filter(carries).map(|actor| (actor.id, *actor)).collect()
    }

    /// The cameras that move, by their places in the rig, along their ways.
    pub(super) fn moving_cameras(&self) -> impl Iterator<Item = (usize, &[PinholeCamera])> {
        self.ways.iter().enumerate().filter(|(_, way)| !way.is_empty()).map(|(place, way)| (place, &way[..]))
    }

    /// Where a sensor is; `before` has the carriers of the frame before.
    pub(super) fn pose(&self, sensor: usize, state: &WorldState, before: &BTreeMap<InstanceId, Actor>) -> SensorPose {
        let SensorMount::Carried { at, .. } = &self.sensors[sensor].mount else {
            return self.sensors[sensor].mount.pose_at(state.time_s).expect("nobody carries it");
        };
        let id = self.carriers[sensor].expect("it is carried");
        let found = state.actors.binary_search_by_key(&id, |actor| actor.id);
        let actor = &state.actors[found.expect("carriers are there in all frames")];
        let near = before.get(&id).map(|before| (before, -1.0 / self.fps));
        let near =
            near.or_else(|| self.second.get(&id).filter(|_| state.frame == 0).map(|after| (after, 1.0 / self.fps)));
        carried(actor, at.position, [at.yaw_rad, at.pitch_rad, at.roll_rad], near)
    }

    /// A camera that moves, as it stands at an instant.
    fn camera(&self, sensor: usize, state: &WorldState) -> Option<PinholeCamera> {
        let of = &self.sensors[sensor];
        let camera = of.model.camera().filter(|_| !of.mount.is_still())?;
        Some(camera.at(&of.mount, &self.pose(sensor, state, &BTreeMap::new()), state.time_s))
    }
}

/// Runs the traffic of a video, if anybody carries a sensor.
fn scout(
    simulation: &Simulation,
    settings: &SceneSettings,
    is_carried: bool,
    condition: impl Fn(u32) -> DrivingCondition,
) -> Scouted {
    let last = settings.frames.saturating_sub(1);
    let step = last.div_ceil(LOOKED_AT).max(1);
    let mut states = vec![simulation.state()];
    if !is_carried {
        let at = |frame: u32| WorldState {
            frame,
            time_s: f64::from(frame) / settings.fps,
            actors: Vec::new(),
            signals: Vec::new(),
        };
        states.extend((1..=last).filter(|frame| frame.is_multiple_of(step) || *frame == last).map(at));
        return Scouted { ways_m: BTreeMap::new(), states };
    }
    let mut simulation = simulation.clone();
    let mut before = simulation.state();
    let mut ways_m: BTreeMap<InstanceId, f64> = before.actors.iter().map(|actor| (actor.id, 0.0)).collect();
    // Of a video of one frame, too, the second tells what turns.
    for frame in 1..=last.max(1) {
        simulation.set_condition(condition(frame));
        simulation.tick();
        let state = simulation.state();
        let place = |state: &WorldState, id: InstanceId| {
            let found = state.actors.binary_search_by_key(&id, |actor| actor.id).ok()?;
            Some(state.actors[found].pose.position)
        };
        // Who is away at any time carries nothing.
        ways_m.retain(|id, way_m| match place(&before, *id).zip(place(&state, *id)) {
            Some((from, to)) => {
                *way_m += f64::from(from.distance(to));
                true
            }
            None => false,
        });
        if frame == 1 || frame.is_multiple_of(step) || frame == last {
            states.push(state.clone());
        }
        before = state;
    }
    Scouted { ways_m, states }
}

impl Scouted {
    /// The carrier of all sensors that ask for it: of those who can carry them, the one that is so many places behind the one
    /// that gets farthest.
    fn carrier(
        &self,
        by: Carrier,
        settings: &SceneSettings,
        draw: impl Fn(&WorldState) -> FrameScene,
    ) -> Result<InstanceId, SimulatorError> {
        let carried: Vec<&SceneSensor> =
            settings.sensors.iter().filter(|sensor| sensor.mount.carrier() == Some(by)).collect();
        let found = self.candidates(by);
        let sensor = |sensor: &SceneSensor| sensor.name.clone();
        if found.len() <= by.number as usize {
            return Err(SimulatorError::NoCarrier {
                video: settings.video,
                map: settings.map.clone(),
                sensor: carried.first().map_or_else(String::new, |first| sensor(first)),
                wanted: wanted(by),
            });
        }
        // People carry sensors before their eyes.
        let asks = by.class != Some(ObjectClass::Pedestrian) && carried.iter().any(|sensor| looks_out(&sensor.model));
        let (mut fitting, mut blind) = (0, None);
        for actor in &found {
            let body = asks.then(|| CarrierBody::new(actor, draw(&self.alone(actor))));
            match body.and_then(|body| carried.iter().find(|sensor| !body.lets_see(sensor))) {
                Some(hidden) => blind = blind.or(Some(hidden)),
                None if fitting == by.number => return Ok(actor.id),
                None => fitting += 1,
            }
        }
        Err(SimulatorError::NoCarrierFits {
            video: settings.video,
            map: settings.map.clone(),
            sensor: blind.map_or_else(String::new, |blind| sensor(blind)),
            wanted: wanted(by),
            candidates: found.len(),
            fitting,
        })
    }

    /// Those of its class who are there in all frames, first the one that gets farthest.
    fn candidates(&self, by: Carrier) -> Vec<&Actor> {
        let fits = |actor: &&Actor| match by.class {
            Some(class) => actor.class == class,
            None => actor.class != ObjectClass::Pedestrian,
        };
        let there = self.states[0].actors.iter().filter(fits);
        let mut found: Vec<(f64, &Actor)> =
            there.filter_map(|actor| Some((*self.ways_m.get(&actor.id)?, actor))).collect();
        found.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.id.cmp(&b.1.id)));
        found.into_iter().map(|(_, actor)| actor).collect()
    }

    /// The first state, in which nobody else is there.
    fn alone(&self, actor: &Actor) -> WorldState {
        WorldState { actors: vec![*actor], signals: Vec::new(), ..self.states[0].clone() }
    }
}

/// In words.
fn wanted(by: Carrier) -> String {
    let class = by.class.map_or("vehicle", ObjectClass::name);
    if by.number == 0 { format!("a {class}") } else { format!("{class} number {} (from 0)", by.number) }
}
