//! One scene on a server, from its population to its last frame.

use super::address::Address;
use super::camera::{SessionCamera, sensors};
use super::cast::{Cast, Casting};
use super::driver::Driver;
use super::error::ClientError;
use super::instances::InstanceTable;
use super::lights::TrafficLights;
use super::map::CarlaMap;
use super::patience::Wait;
use super::server::Server;
use super::task::CarlaRenderTask;
use super::traffic_manager::TrafficManager;
use super::weather;
use super::world::{Snapshot, World};
use crate::wire::{EpisodeSettings, Vector3D};
use endless_asset::Catalogue;
use endless_dataset::SpawnCounts;
use endless_pipeline::{SimulationSession, SimulationStep, SimulatorError};
use endless_traffic::{DrivingCondition, Fleet, Focus, Simulation, TrafficSettings, View};
use endless_world::{CameraSite, ObjectClass, PinholeCamera, Pose, SceneSettings, SceneWeather, WorldState};
use std::collections::BTreeMap;
use std::time::Duration;

/// How often a frame is tried when pictures of it are lost.
const TRIES: u32 = 12;
/// Frames before the first one that is recorded: cameras get used to the light. Nobody moves meanwhile, and time runs fast.
const WARM_UP_FRAMES: u32 = 4;
const WARM_UP_STEP_S: f64 = 0.5;
/// For how long a TrafficManager drives before, seconds.
const DRIVE_UP_S: f64 = 5.0;

/// One scene.
pub(super) struct CarlaSession<'m> {
    server: &'m Server,
    settings: &'m SceneSettings,
    driver: Driver,
    cast: Cast,
    table: InstanceTable,
    lights: TrafficLights,
    cameras: Vec<SessionCamera>,
    parked: u32,
    next: u32,
}

impl<'m> CarlaSession<'m> {
    /// Populates a map, and comes to its first frame.
    pub(super) fn open(
        server: &'m Server,
        map: &'m CarlaMap,
        settings: &'m SceneSettings,
    ) -> Result<Self, ClientError> {
        server.with_world(|world| {
            let mut cast = Cast::default();
            let opened = Self::populate(server, map, settings, world, &mut cast);
            if opened.is_err() {
                // The connection may be what failed.
                let _ = server.settings.stop.pause(|| cast.leave(world));
            }
            opened
        })
    }

    fn populate(
        server: &'m Server,
        map: &'m CarlaMap,
        settings: &'m SceneSettings,
        world: &mut World,
        cast: &mut Cast,
    ) -> Result<Self, ClientError> {
        world.apply_settings(&clock(1.0 / settings.fps))?;
        world.set_weather(&weather::parameters(&SceneWeather::of_scene(settings)))?;
        let manager = server.settings.traffic_manager.as_ref();
        let simulation = simulation(map, settings, manager.is_some())?;
        let mut driver = Driver::new(simulation);
        let moved = driver.simulation.everybody(0, |_| DrivingCondition::default());
        let (blueprints, catalogue) = (&server.blueprints, &server.catalogue);
        let mut casting = Casting { world, fleet: &map.fleet, blueprints, catalogue, seed: settings.seed };
        cast.spawn_moved(&mut casting, &moved)?;
        if manager.is_some() {
            let [vehicles, _] = map.traffic.asked(&focus(map, settings), settings);
            cast.spawn_driven(&mut casting, vehicles)?;
        }
        let world = casting.world;
        let table = InstanceTable::new(cast.bodies.clone(), map.stills.clone())?;
        driver.place(cast, world)?;
        let snapshot = world.tick_until_seen(TRIES)?;
        let mut lights = traffic_lights(map, world, &snapshot)?;
        lights.show(world, &driver.simulation.state().signals)?;
        if let Some(address) = manager {
            drive_up(server, settings, address, &mut driver, cast, &mut lights, world)?;
        } else {
            world.apply_settings(&clock(WARM_UP_STEP_S))?;
        }
        let cameras = cameras(settings, cast, world)?;
        if driver.is_still_between_frames() {
            for _ in 0..WARM_UP_FRAMES {
                world.tick_until_seen(TRIES)?;
            }
            world.apply_settings(&clock(1.0 / settings.fps))?;
        }
        // Made last: a session that fails takes hold of the world once more, which is held here.
        Ok(Self {
            server,
            settings,
            driver,
            cast: std::mem::take(cast),
            table,
            lights,
            cameras,
            parked: map.stills.len() as u32,
            next: 0,
        })
    }

    /// The next frame; where that changes nothing it is tried again when pictures are lost.
    fn advance(&mut self, world: &mut World) -> Result<(WorldState, CarlaRenderTask), ClientError> {
        if self.next > 0 {
            step_once(&mut self.driver, &self.cast, &mut self.lights, world)?;
        }
        let mut tries = 0;
        loop {
            tries += 1;
            match self.frame(world) {
                Err(error @ (ClientError::Unfit(_) | ClientError::Late { .. }))
                    if tries < TRIES && self.driver.is_still_between_frames() =>
                {
                    tracing::warn!("frame {} is asked for again: {error}", self.next);
                }
                other => return other,
            }
        }
    }

    /// The frame at which all is placed.
    fn frame(&mut self, world: &mut World) -> Result<(WorldState, CarlaRenderTask), ClientError> {
        let snapshot = world.tick()?;
        let mut state = self.driver.state(&self.cast, world, &snapshot, self.next, self.settings.fps)?;
        for actor in &mut state.actors {
            actor.rider_id = self.table.actor(actor.id.0.into()).and_then(|seen| seen.rider);
        }
        let poses: BTreeMap<u16, Pose> = state.actors.iter().map(|actor| (actor.id.0, actor.pose)).collect();
        self.table.begin_frame(&poses);
        let mut seen = Vec::with_capacity(self.cameras.len());
        for camera in &mut self.cameras {
            let pictures = camera.pictures(world, &snapshot)?;
            let objects = self.table.look(&pictures.instance, &pictures.depth, &camera.camera, &poses)?;
            seen.push((pictures, objects));
        }
        Ok((state, CarlaRenderTask::new(seen, &self.table)))
    }

    fn leave(&mut self, world: &mut World) -> Result<(), ClientError> {
        if let Some(manager) = &mut self.driver.manager {
            manager.leave()?;
        }
        self.cameras.clear();
        self.cast.leave(world)?;
        self.lights.release(world)
    }
}

/// Hands the vehicles to a TrafficManager, until they are on their way. One that was made before the map was loaded moves
/// nobody: then another is waited for.
fn drive_up(
    server: &Server,
    settings: &SceneSettings,
    address: &Address,
    driver: &mut Driver,
    cast: &Cast,
    lights: &mut TrafficLights,
    world: &mut World,
) -> Result<(), ClientError> {
    let wait =
        Wait::new("drive vehicles, though a TrafficManager was named", server.settings.reconnect_limit, world.stop());
    loop {
        let driven = TrafficManager::drive(address, cast.vehicles(), settings.seed, world.stop());
        let mut moves = cast.vehicles().is_empty();
        match driven {
            Ok(manager) => {
                driver.manager = Some(manager);
                for _ in 0..(DRIVE_UP_S * settings.fps).ceil() as u32 {
                    step_once(driver, cast, lights, world)?;
                    let snapshot = world.tick()?;
                    moves |= cast.vehicles().iter().any(|vehicle| is_moving(&snapshot, vehicle.id));
                }
            }
            Err(error @ ClientError::Interrupted) => return Err(error),
            Err(error) => tracing::warn!("{error}"),
        }
        if moves {
            return Ok(());
        }
        tracing::warn!(
            "the TrafficManager at {address} moves nobody: waiting for one that was made after the map was loaded"
        );
        if let Some(mut manager) = driver.manager.take() {
            // It may be of another world.
            let _ = manager.leave();
        }
        wait.sleep(Duration::from_millis(500))?;
    }
}

fn is_moving(snapshot: &Snapshot, id: u32) -> bool {
    const MOVES_MPS: f32 = 0.5;
    snapshot.actors.get(&id).is_some_and(|record| {
        let Vector3D { x, y, .. } = record.velocity;
        x.hypot(y) > MOVES_MPS
    })
}

/// Moves all to where they are a frame later.
fn step_once(
    driver: &mut Driver,
    cast: &Cast,
    lights: &mut TrafficLights,
    world: &mut World,
) -> Result<(), ClientError> {
    driver.simulation.tick();
    lights.show(world, &driver.simulation.state().signals)?;
    driver.place(cast, world)?;
    driver.manager.as_mut().map_or(Ok(()), TrafficManager::step)
}

/// Time that waits for ticks.
pub(super) fn clock(step_s: f64) -> EpisodeSettings {
    // CARLA makes at most 16 steps of physics a frame.
    let substeps = (step_s / 0.01).ceil().clamp(10.0, 16.0);
    EpisodeSettings {
        synchronous_mode: true,
        fixed_delta_seconds: Some(step_s),
        max_substep_delta_time: (step_s / substeps).max(0.01),
        max_substeps: substeps as i32,
        ..EpisodeSettings::default()
    }
}

/// What the cameras see of the streets: nobody knows what stands before them on the server's map.
fn focus(map: &CarlaMap, settings: &SceneSettings) -> Focus {
    let view = |site: &CameraSite| View::Camera(PinholeCamera::new(site, settings.size));
    let views: Vec<View> = settings.usual_sites().map(view).collect();
    Focus::new(map.traffic.network(), &views, settings.focus, &|_, _| true)
}

/// Our traffic on the server's map, at frame 0.
fn simulation(map: &CarlaMap, settings: &SceneSettings, people_alone: bool) -> Result<Simulation, ClientError> {
    let condition = DrivingCondition::from(&*SceneWeather::of_scene(settings));
    let focus = focus(map, settings);
    let [vehicles, pedestrians] = map.traffic.asked(&focus, settings);
    let traffic = TrafficSettings {
        vehicles: if people_alone { 0 } else { vehicles },
        pedestrians,
        seed: settings.seed,
        fps: settings.fps,
        condition,
        focus,
        errands: Vec::new(),
        bus_stops: Vec::new(),
        bench_seats: Vec::new(),
        parking_bays: Vec::new(),
        deliveries: 0.0,
        // Vehicles of the server would not see them.
        jaywalking: if people_alone { 0.0 } else { settings.jaywalking },
        groups: settings.groups,
        first: Vec::new(),
        profile: settings.profile,
    };
    let fleet = Fleet { vehicles: &map.fleet.specs, pedestrian: &Catalogue::pedestrian_spec };
    let parked = map.stills.parked(&map.fleet.specs);
    Simulation::on_map(&map.traffic, &fleet, &parked, &traffic)
        .map_err(|error| ClientError::Unusable(format!("there can be no such traffic: {error}")))
}

/// The lights of the map that stand at our signals.
fn traffic_lights(map: &CarlaMap, world: &mut World, snapshot: &Snapshot) -> Result<TrafficLights, ClientError> {
    let ids: Vec<u32> = snapshot.actors.keys().copied().collect();
    let actors = world.actors(&ids)?;
    let is_light = |actor: &crate::wire::Actor| actor.description.id == "traffic.traffic_light";
    let placed = actors.into_iter().filter(is_light).filter_map(|actor| {
        let transform = snapshot.actors.get(&actor.id)?.transform.clone();
        Some((actor, transform))
    });
    let lights = TrafficLights::new(&placed.collect::<Vec<_>>(), &map.planned.road_map.network);
    tracing::debug!("{} traffic lights show our signals", lights.len());
    Ok(lights)
}

fn cameras(settings: &SceneSettings, cast: &mut Cast, world: &mut World) -> Result<Vec<SessionCamera>, ClientError> {
    let definitions = world.definitions()?;
    let mut cameras = Vec::with_capacity(settings.cameras.len());
    for camera in &settings.cameras {
        let wanted = sensors(&definitions, &camera.site, settings.size)?;
        let tokens = cast.spawn_sensors(world, &wanted)?;
        let streams = tokens.iter().map(|token| world.subscribe(token)).collect::<Result<Vec<_>, _>>()?;
        cameras.push(SessionCamera::new(&camera.site, settings.size, streams));
    }
    Ok(cameras)
}

impl<'m> SimulationSession<'m> for CarlaSession<'m> {
    fn spawned(&self) -> SpawnCounts {
        SpawnCounts {
            vehicles: self.cast.count(|class| class != ObjectClass::Pedestrian),
            pedestrians: self.cast.count(|class| class == ObjectClass::Pedestrian),
            parked: self.parked,
        }
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        let server = self.server;
        let (state, task) = server.with_world(|world| self.advance(world)).map_err(|e| server.told(e))?;
        self.next += 1;
        Ok(SimulationStep { state, task: Box::new(task) })
    }
}

impl Drop for CarlaSession<'_> {
    fn drop(&mut self) {
        // Also after a failure and when the user stops; where the connection is lost there is nothing to clean up with.
        let left = self.server.while_stopping(|world| self.leave(world));
        if let Err(error) = left {
            tracing::debug!("the scene was not cleaned up: {error}");
        }
    }
}
