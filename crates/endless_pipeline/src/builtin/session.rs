//! One scene of the built-in city.

use super::{
    actors,
    bodies::Skeletons,
    instant::{InstantSource, NeighbourInstants, SceneInstant},
    key_bakes::{FrameBakes, KeyBakes, SceneBakes},
    lookout,
    map::BuiltinMap,
    moving_cameras::{MovingCameras, MovingView},
    repainted::repainted,
    rig::SceneRig,
    road_facts::{body_sizes, road_facts},
    scene_boxes::SceneBoxes,
    scene_frame::scene_frame,
    shapes::{MovingShapes, ParkedShapes},
};
use crate::record::sensor_seed;
use crate::{
    RenderStats, RenderTask, SceneBodies, SceneTruth, SensorReading, SimulationSession, SimulationStep, SimulatorError,
};
use endless_annotate::{
    ActorRecord, Box3d, CameraView, ObjectShapes, RoadFacts, SceneFrame, SceneObjects, annotate, visible_objects,
};
use endless_asset::Catalogue;
use endless_city::ActorModels;
use endless_dataset::SpawnCounts;
use endless_render::{FrameScene, NeighbourFrame, NeighbourFrames, RayCaster, render_labels};
use endless_sensor::{Atmosphere, Lidar, Radar, SweepInterval};
use endless_traffic::{
    DrivingCondition, Fleet, IncidentRequest, PlayedTracks, Simulation, TrafficSettings, USUAL_DELIVERIES,
};
use endless_world::{
    Actor, InstanceId, ObjectClass, PinholeCamera, RigEventCamera, SceneCamera, SceneSettings, SensorFrame,
    SensorLayers, SensorModel, SensorPose, StagedIncidents, Track, WorldState,
};
use std::{
    collections::BTreeMap,
    sync::{Arc, OnceLock},
};

/// Ticks the traffic; what shows it is shared with the render tasks.
pub(super) struct BuiltinSession<'m> {
    instants: InstantSource,
    bakes: KeyBakes<'m>,
    scene: Arc<BuiltinScene<'m>>,
    /// Who carries sensors, at the frame before.
    carriers: Arc<BTreeMap<InstanceId, Actor>>,
}

/// What stays the same in all frames of a session.
struct BuiltinScene<'m> {
    map: &'m BuiltinMap,
    catalogue: &'m Catalogue,
    settings: &'m SceneSettings,
    bakes: Arc<SceneBakes<'m>>,
    rig: SceneRig,
    moving_cameras: MovingCameras,
    spawned: SpawnCounts,
    staged: StagedIncidents,
    parked: Vec<Actor>,
    /// Everything that moves in some frame. Where it stands does not count.
    moving: Vec<Actor>,
    /// Names of the tracks that are played, by the ids of those who play them.
    tracks: BTreeMap<InstanceId, String>,
    skin_tones: BTreeMap<InstanceId, u8>,
    skeletons: Skeletons,
    parked_shapes: ParkedShapes<'m>,
    models: OnceLock<ActorModels>,
}

impl<'m> BuiltinSession<'m> {
    /// Populates a map.
    ///
    /// # Errors
    /// [`SimulatorError::Scene`] when there can be no such traffic.
    pub(super) fn open(
        map: &'m BuiltinMap,
        catalogue: &'m Catalogue,
        settings: &'m SceneSettings,
        wanted: SensorLayers,
        tracks: &[Track],
    ) -> Result<Self, SimulatorError> {
        let SceneSettings { seed, fps, jaywalking, groups, profile, .. } = *settings;
        let bakes = Arc::new(SceneBakes::new(map, catalogue, settings, wanted));
        let condition = DrivingCondition::from(&*bakes.weather(0));
        // Traffic over the whole map, denser where the cameras look.
        let focus = lookout::focus(map, settings);
        let [vehicles, pedestrians] = map.traffic.asked(&focus, settings);
        let (errands, first) = (lookout::errands(&map.town), carrier_classes(settings));
        // Where events are asked for, nobody else stands at the kerb; nor where a vehicle that carries sensors could.
        let parks = settings.events.is_empty() && first.is_empty();
        let traffic = TrafficSettings {
            vehicles,
            pedestrians,
            seed,
            fps,
            condition,
            focus,
            errands,
            bus_stops: map.town.bus_stops(),
            bench_seats: map.town.bench_seats(),
            // Where events are asked for, nobody else parks on the lane.
            parking_bays: if parks { map.town.parking_bays.clone() } else { Vec::new() },
            deliveries: if settings.events.is_empty() { USUAL_DELIVERIES } else { 0.0 },
            jaywalking,
            groups,
            first,
            profile,
        };
        let specs = catalogue.vehicle_specs();
        let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
        let duration_s = f64::from(settings.frames) / fps;
        let played = settings.playback.map(|playback| PlayedTracks { tracks, playback, duration_s });
        let condition = |frame| DrivingCondition::from(&*bakes.weather(frame));
        let (fleet, parked, played) = (&fleet, &map.town.parked, played.as_ref());
        let made = if settings.events.is_empty() {
            let simulation = Simulation::playing(&map.traffic, fleet, parked, &traffic, played);
            simulation.map(|simulation| (simulation, StagedIncidents::default()))
        } else {
            let sight = lookout::sight(map, settings);
            let (kinds, frames) = (&settings.events[..], settings.frames);
            let request = IncidentRequest { kinds, frames, seed, sight: &sight, condition: &condition };
            Simulation::with_incidents(&map.traffic, fleet, parked, &traffic, played, &request)
        };
        let (simulation, staged) = made.map_err(|source| SimulatorError::Scene {
            video: settings.video,
            map: settings.map.clone(),
            source: source.into(),
        })?;
        let draw =
            |state: &WorldState| ActorModels::in_town(&map.town_scene, catalogue, &state.actors).frame_scene(state);
        let rig = SceneRig::new(&simulation, settings, condition, draw)?;
        let moving_cameras = MovingCameras::new(settings, bakes.timeline(), wanted, rig.moving_cameras());
        let population = simulation.population();
        let parked = simulation.parked().to_vec();
        let spawned = SpawnCounts {
            vehicles: population.vehicles_spawned,
            pedestrians: population.pedestrians_spawned,
            parked: parked.len() as u32,
        };
        let moving = simulation.everybody(settings.frames, condition);
        let tracks = simulation.track_names().map(|(id, name)| (id, name.to_owned())).collect();
        let scene = BuiltinScene {
            map,
            catalogue,
            settings,
            bakes: Arc::clone(&bakes),
            rig,
            moving_cameras,
            spawned,
            staged,
            skin_tones: skin_tones(catalogue, &moving),
            skeletons: Skeletons::of(catalogue, &moving),
            parked_shapes: ParkedShapes::new(map.town_scene.static_scene(), &parked),
            parked,
            moving,
            tracks,
            models: OnceLock::new(),
        };
        let instants = InstantSource::new(simulation, wanted, settings.cameras.len(), settings.frames);
        Ok(Self { instants, bakes: KeyBakes::new(bakes), scene: Arc::new(scene), carriers: Arc::default() })
    }

    /// The next frame, which nobody draws.
    pub(super) fn advance(&mut self) -> Arc<SceneInstant> {
        let condition = |frame| DrivingCondition::from(&*self.scene.bakes.weather(frame));
        self.instants.next(condition).0
    }

    /// What the cameras see of a frame.
    pub(super) fn boxes(&self, instant: &SceneInstant, min_pixels: u32) -> SceneBoxes {
        let BuiltinScene { settings, bakes, parked, .. } = &*self.scene;
        let (state, frame) = (&instant.state, instant.scene(self.scene.models()));
        let objects = SceneObjects::new(state, parked);
        let seen = |camera: &SceneCamera| {
            let camera = PinholeCamera::new(&camera.site, settings.size);
            let image = render_labels(bakes.still(), &frame, &camera, SensorLayers::default()).instance;
            let visible = visible_objects(&image);
            annotate(state.frame, state.time_s, &visible, &objects, settings.size, min_pixels)
                .expect("the scene holds what it shows")
        };
        SceneBoxes { cameras: settings.cameras.iter().map(seen).collect(), state: state.clone() }
    }
}

/// Classes of the vehicles that must be there to carry sensors.
fn carrier_classes(settings: &SceneSettings) -> Vec<ObjectClass> {
    let mut wanted: BTreeMap<ObjectClass, u32> = BTreeMap::new();
    for by in settings.sensors.iter().filter_map(|sensor| sensor.mount.carrier()) {
        let Some(class) = by.class.filter(|class| *class != ObjectClass::Pedestrian) else { continue };
        let count = wanted.entry(class).or_default();
        *count = (*count).max(by.number + 1);
    }
    wanted.into_iter().flat_map(|(class, count)| std::iter::repeat_n(class, count as usize)).collect()
}

/// Of people on foot and of riders.
fn skin_tones(catalogue: &Catalogue, moving: &[Actor]) -> BTreeMap<InstanceId, u8> {
    let who = |actor: &Actor| {
        let id = if actor.asset.person().is_some() { Some(actor.id) } else { actor.rider_id };
        Some((id?, catalogue.skin_tone(actor.asset)?))
    };
    moving.iter().filter_map(who).collect()
}

impl BuiltinScene<'_> {
    /// The models of what moves, made when they are first needed.
    fn models(&self) -> &ActorModels {
        self.models.get_or_init(|| ActorModels::in_town(&self.map.town_scene, self.catalogue, &self.moving))
    }
}

impl<'m> SimulationSession<'m> for BuiltinSession<'m> {
    fn spawned(&self) -> SpawnCounts {
        self.scene.spawned
    }

    fn incidents(&self) -> StagedIncidents {
        self.scene.staged.clone()
    }

    fn actors(&self) -> Option<Vec<ActorRecord>> {
        let BuiltinScene { catalogue, settings, parked, moving, tracks, .. } = &*self.scene;
        let mut records = actors::describe(catalogue, parked.iter().chain(moving));
        for record in &mut records {
            record.track = tracks.get(&record.vehicle_id.unwrap_or(record.id)).cloned();
        }
        Some(repainted(records, settings))
    }

    fn prepare(&mut self) -> Result<(), SimulatorError> {
        self.bakes.prepare();
        self.scene.moving_cameras.prepare(self.scene.bakes.still());
        self.scene.models();
        Ok(())
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        let condition = |frame| DrivingCondition::from(&*self.scene.bakes.weather(frame));
        let (instant, neighbours) = self.instants.next(condition);
        let state = instant.state.clone();
        let bakes = self.bakes.at(state.frame);
        let before = Arc::clone(&self.carriers);
        self.carriers = Arc::new(self.scene.rig.carriers(&state));
        let scene = Arc::clone(&self.scene);
        let task = Box::new(BuiltinRenderTask { scene, bakes, instant, neighbours, carriers_before: before });
        Ok(SimulationStep { state, task })
    }

    fn carrier(&self, sensor: usize) -> Option<InstanceId> {
        self.scene.rig.carrier(sensor)
    }

    fn bodies(&self) -> SceneBodies {
        let BuiltinScene { catalogue, moving, parked, .. } = &*self.scene;
        SceneBodies { sizes: body_sizes(catalogue, parked.iter().chain(moving)), still: parked.clone() }
    }

    fn road_facts(&self) -> RoadFacts {
        let BuiltinScene { map, catalogue, moving, .. } = &*self.scene;
        road_facts(&map.town.network, catalogue, moving)
    }

    fn stats(&self) -> RenderStats {
        self.bakes.stats()
    }
}

struct BuiltinRenderTask<'m> {
    scene: Arc<BuiltinScene<'m>>,
    bakes: FrameBakes<'m>,
    instant: Arc<SceneInstant>,
    neighbours: NeighbourInstants,
    /// Who carries sensors, at the frame before.
    carriers_before: Arc<BTreeMap<InstanceId, Actor>>,
}

impl<'m> RenderTask<'m> for BuiltinRenderTask<'m> {
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        let BuiltinScene { map, parked, skin_tones, skeletons, .. } = &*self.scene;
        let ids = |lane: u32| map.lane_names.get(lane as usize).map(|name| (name.road, name.lane));
        let (scene, instant) = (Arc::clone(&self.scene), Arc::clone(&self.instant));
        SceneTruth {
            objects: SceneObjects::new(state, parked).with_skin_tones(skin_tones).with_roads(ids),
            bodies: skeletons.bodies(state),
            shapes: Some(Box::new(SceneShapes { scene, instant, moving: OnceLock::new() })),
        }
    }

    fn scene_frame(&self, state: &WorldState) -> Option<SceneFrame> {
        let BuiltinScene { bakes, map, parked, settings, .. } = &*self.scene;
        let (network, control) = (&map.town.network, settings.profile.signals);
        Some(scene_frame(&bakes.weather(state.frame), network, parked, state, control))
    }

    fn sensor_pose(&self, state: &WorldState, sensor: usize) -> Result<SensorPose, SimulatorError> {
        Ok(self.scene.rig.pose(sensor, state, &self.carriers_before))
    }

    fn sense(&self, state: &WorldState, sensor: usize) -> Result<SensorReading, SimulatorError> {
        let Self { scene, bakes, instant, .. } = self;
        let of = &scene.settings.sensors[sensor];
        let (still, frame) = (scene.bakes.still(), instant.scene(scene.models()));
        let camera = match &of.model {
            SensorModel::Camera(camera) | SensorModel::EventCamera(RigEventCamera { camera, .. }) => camera,
            SensorModel::Lidar(settings) => {
                let (carrier, interval) = (scene.rig.carrier(sensor), self.interval(state, sensor)?);
                let caster = RayCaster::new(still, &frame).ignoring(carrier.as_slice());
                let lidar = Lidar::new(settings, sensor_seed(scene.settings, sensor));
                let atmosphere = Atmosphere::from(&scene.bakes.weather(state.frame));
                return Ok(SensorReading::Lidar(lidar.sweep(&caster, &atmosphere, &interval)));
            }
            SensorModel::Radar(settings) => {
                let (carrier, interval) = (scene.rig.carrier(sensor), self.interval(state, sensor)?);
                let caster = RayCaster::new(still, &frame).ignoring(carrier.as_slice());
                let radar = Radar::new(settings, sensor_seed(scene.settings, sensor));
                return Ok(SensorReading::Radar(radar.scan(&caster, &interval)));
            }
            _ => return Err(SimulatorError::NoRigs),
        };
        let scene_of = |instant: &Arc<SceneInstant>| instant.scene(scene.models());
        let [before, after] = [&self.neighbours.before, &self.neighbours.after];
        let (scene_before, scene_after) = (before.as_ref().map(scene_of), after.as_ref().map(scene_of));
        if of.fixed_camera().is_some() {
            let beside = NeighbourFrames {
                before: scene_before.as_deref().map(NeighbourFrame::from),
                after: scene_after.as_deref().map(NeighbourFrame::from),
            };
            let before = scene.settings.sensors[..sensor].iter().filter(|other| other.fixed_camera().is_some()).count();
            let number = scene.settings.cameras.len() + before;
            return Ok(SensorReading::Camera(Box::new(bakes.render(number, still, &frame, beside))));
        }
        let stands = |state: &WorldState| {
            let pose = scene.rig.pose(sensor, state, &self.carriers_before);
            camera.at(&of.mount, &pose, state.time_s)
        };
        let at = |instant: &Option<Arc<SceneInstant>>| instant.as_ref().map(|instant| stands(&instant.state));
        let (camera_before, camera_after) = (at(before), at(after));
        let neighbours = NeighbourFrames {
            before: seen_from(scene_before.as_deref(), camera_before.as_ref()),
            after: seen_from(scene_after.as_deref(), camera_after.as_ref()),
        };
        let view = MovingView { still, frame: &frame, number: state.frame, camera: &stands(state), neighbours };
        let image = scene.moving_cameras.render(sensor, &view);
        Ok(SensorReading::Camera(Box::new(image.expect("a camera that does not stand still moves"))))
    }

    fn render(self: Box<Self>, _state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        let Self { scene, bakes, instant, neighbours, .. } = &*self;
        let scene_of = |instant: &Arc<SceneInstant>| instant.scene(scene.models());
        // The latest first: a task that began a little earlier is making those before it.
        let after = neighbours.after.as_ref().map(scene_of);
        let before = neighbours.before.as_ref().map(scene_of);
        let beside = |camera| NeighbourFrames {
            before: neighbour(&before, &neighbours.before, camera),
            after: neighbour(&after, &neighbours.after, camera),
        };
        let (still, now) = (scene.bakes.still(), scene_of(instant));
        let cameras = 0..scene.settings.cameras.len();
        Ok(cameras.map(|camera| bakes.render(camera, still, &now, beside(camera))).collect())
    }
}

impl BuiltinRenderTask<'_> {
    /// The interval in which a sensor sweeps: from its last measurement to this one.
    fn interval(&self, state: &WorldState, sensor: usize) -> Result<SweepInterval, SimulatorError> {
        let now = self.sensor_pose(state, sensor)?;
        let SceneSettings { sensors, fps, .. } = self.scene.settings;
        let sweep_s = f64::from(sensors[sensor].every) / fps;
        Ok(SweepInterval { before: now.earlier(sweep_s), now, sweep_s, frame: state.frame })
    }
}

/// An instant beside a frame, as a camera needs it that moves.
fn seen_from<'a>(scene: Option<&'a FrameScene>, camera: Option<&'a PinholeCamera>) -> Option<NeighbourFrame<'a>> {
    Some(NeighbourFrame { camera, ..scene?.into() })
}

/// An instant beside a frame, as a camera needs it.
fn neighbour<'a>(
    scene: &'a Option<Arc<FrameScene>>,
    instant: &'a Option<Arc<SceneInstant>>,
    camera: usize,
) -> Option<NeighbourFrame<'a>> {
    let (scene, instant) = (scene.as_deref()?, instant.as_ref()?);
    Some(NeighbourFrame { covered: instant.covered.get(camera), ..scene.into() })
}

/// The shapes of all objects of a scene at one instant.
struct SceneShapes<'m> {
    scene: Arc<BuiltinScene<'m>>,
    instant: Arc<SceneInstant>,
    moving: OnceLock<MovingShapes>,
}

impl SceneShapes<'_> {
    fn moving(&self) -> &MovingShapes {
        self.moving
            .get_or_init(|| MovingShapes::new(&self.instant.state.actors, self.instant.scene(self.scene.models())))
    }
}

impl ObjectShapes for SceneShapes<'_> {
    fn box3d(&self, id: InstanceId) -> Option<Box3d> {
        self.scene.parked_shapes.box3d(id).or_else(|| self.moving().box3d(id))
    }

    fn covered(&self, view: &CameraView<'_>, id: InstanceId) -> Option<Arc<[u32]>> {
        self.scene.parked_shapes.covered(view, id).or_else(|| self.moving().covered(view, id))
    }

    fn image_bounds(&self, view: &CameraView<'_>, id: InstanceId) -> Option<[f32; 4]> {
        self.scene.parked_shapes.image_bounds(view, id).or_else(|| self.moving().image_bounds(view, id))
    }
}
