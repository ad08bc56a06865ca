//! One scene of the built-in city.

use super::{
    actors,
    bodies::Skeletons,
    instant::{InstantSource, NeighbourInstants, SceneInstant},
    map::BuiltinMap,
    road_facts::road_facts,
    scene_frame::scene_frame,
    shapes::{MovingShapes, ParkedShapes},
};
use crate::{RenderStats, RenderTask, SceneTruth, SimulationSession, SimulationStep, SimulatorError};
use endless_annotate::{ActorRecord, Box3d, CameraView, ObjectShapes, RoadFacts, SceneFrame, SceneObjects};
use endless_asset::Catalogue;
use endless_city::ActorModels;
use endless_dataset::SpawnCounts;
use endless_render::{CameraBake, NeighbourFrames};
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, Condition, InstanceId, SceneSettings, SensorFrame, SensorLayers, WorldState};
use glam::Vec3;
use std::{
    collections::BTreeMap,
    sync::{Arc, OnceLock},
    time::{Duration, Instant},
};

/// Ticks the traffic; what shows it is shared with the render tasks.
pub(super) struct BuiltinSession<'m> {
    instants: InstantSource,
    scene: Arc<BuiltinScene<'m>>,
}

/// What stays the same in all frames of a session.
struct BuiltinScene<'m> {
    map: &'m BuiltinMap,
    catalogue: &'m Catalogue,
    settings: &'m SceneSettings,
    wanted: SensorLayers,
    spawned: SpawnCounts,
    parked: Vec<Actor>,
    /// Everything that moves, as it stands in frame 0: traffic takes nobody in or out.
    moving: Vec<Actor>,
    skin_tones: BTreeMap<InstanceId, u8>,
    skeletons: Skeletons,
    parked_shapes: ParkedShapes<'m>,
    models: OnceLock<ActorModels>,
    cameras: OnceLock<BakedCameras>,
}

struct BakedCameras {
    baked: Vec<CameraBake>,
    bake_rays: u64,
    /// Wall time of `baked`.
    bake: Duration,
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
    ) -> Result<Self, SimulatorError> {
        let SceneSettings { weather, time_of_day, vehicles, pedestrians, seed, fps, .. } = *settings;
        let condition = Condition::of(weather, time_of_day);
        // Traffic over the whole map, denser where the cameras look.
        let focus = settings.cameras.iter().map(|c| Vec3::from_array(c.site.position)).collect();
        let traffic = TrafficSettings { vehicles, pedestrians, seed, fps, condition, focus };
        let specs = catalogue.vehicle_specs();
        let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
        let simulation = Simulation::on_map(&map.traffic, &fleet, &map.town.parked, &traffic).map_err(|source| {
            SimulatorError::Scene { video: settings.video, map: settings.map.clone(), source: source.into() }
        })?;
        let population = simulation.population();
        let parked = simulation.parked().to_vec();
        let spawned = SpawnCounts {
            vehicles: population.vehicles_spawned,
            pedestrians: population.pedestrians_spawned,
            parked: parked.len() as u32,
        };
        let moving = simulation.state().actors;
        let scene = BuiltinScene {
            map,
            catalogue,
            settings,
            wanted,
            spawned,
            skin_tones: skin_tones(catalogue, &moving),
            skeletons: Skeletons::of(catalogue, &moving),
            parked_shapes: ParkedShapes::new(map.town_scene.static_scene(), &parked),
            parked,
            moving,
            models: OnceLock::new(),
            cameras: OnceLock::new(),
        };
        Ok(Self { instants: InstantSource::new(simulation), scene: Arc::new(scene) })
    }
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
    /// The cameras, baked when they are first needed.
    fn cameras(&self) -> &BakedCameras {
        self.cameras.get_or_init(|| {
            let Self { map, settings, wanted, .. } = *self;
            let start = Instant::now();
            let still = map.town_scene.static_scene();
            let baked: Vec<CameraBake> =
                settings.cameras.iter().map(|camera| map.bakes.bake(still, settings, camera, wanted)).collect();
            let bake = start.elapsed();
            BakedCameras { bake_rays: rays(&baked), baked, bake }
        })
    }

    /// The models of what moves, made when they are first needed.
    fn models(&self) -> &ActorModels {
        self.models.get_or_init(|| ActorModels::in_town(&self.map.town_scene, self.catalogue, &self.moving))
    }
}

fn rays(baked: &[CameraBake]) -> u64 {
    baked.iter().map(|b| b.stats().rays()).sum()
}

impl<'m> SimulationSession<'m> for BuiltinSession<'m> {
    fn spawned(&self) -> SpawnCounts {
        self.scene.spawned
    }

    fn actors(&self) -> Option<Vec<ActorRecord>> {
        let BuiltinScene { catalogue, parked, moving, .. } = &*self.scene;
        Some(actors::describe(catalogue, parked.iter().chain(moving)))
    }

    fn prepare(&mut self) -> Result<(), SimulatorError> {
        self.scene.cameras();
        self.scene.models();
        Ok(())
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        let BuiltinScene { wanted, settings, .. } = *self.scene;
        let (instant, neighbours) = self.instants.next(wanted, settings.frames);
        let state = instant.state.clone();
        Ok(SimulationStep {
            state,
            task: Box::new(BuiltinRenderTask { scene: Arc::clone(&self.scene), instant, neighbours }),
        })
    }

    fn road_facts(&self) -> RoadFacts {
        let BuiltinScene { map, catalogue, moving, .. } = &*self.scene;
        road_facts(&map.town.network, catalogue, moving)
    }

    fn stats(&self) -> RenderStats {
        self.scene.cameras.get().map_or_else(RenderStats::default, |cameras| {
            let BakedCameras { bake_rays, bake, .. } = *cameras;
            RenderStats { bake_rays, frame_rays: rays(&cameras.baked) - bake_rays, bake }
        })
    }
}

struct BuiltinRenderTask<'m> {
    scene: Arc<BuiltinScene<'m>>,
    instant: Arc<SceneInstant>,
    neighbours: NeighbourInstants,
}

impl<'m> RenderTask<'m> for BuiltinRenderTask<'m> {
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        let BuiltinScene { parked, skin_tones, skeletons, .. } = &*self.scene;
        let (scene, instant) = (Arc::clone(&self.scene), Arc::clone(&self.instant));
        SceneTruth {
            objects: SceneObjects::new(state, parked).with_skin_tones(skin_tones),
            bodies: skeletons.bodies(state),
            shapes: Some(Box::new(SceneShapes { scene, instant, moving: OnceLock::new() })),
        }
    }

    fn scene_frame(&self, state: &WorldState) -> Option<SceneFrame> {
        let BuiltinScene { settings, map, parked, .. } = &*self.scene;
        Some(scene_frame(settings, &map.town.network, parked, state))
    }

    fn render(self: Box<Self>, _state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        let Self { scene, instant, neighbours } = &*self;
        let (cameras, still) = (scene.cameras(), scene.map.town_scene.static_scene());
        let scene_of = |instant: &Arc<SceneInstant>| instant.scene(scene.models());
        // The latest first: a task that began a little earlier is making those before it.
        let after = neighbours.after.as_ref().map(scene_of);
        let before = neighbours.before.as_ref().map(scene_of);
        let beside = NeighbourFrames { before: before.as_deref(), after: after.as_deref() };
        let frame = scene_of(instant);
        Ok(cameras.baked.iter().map(|camera| camera.render_between(still, &frame, beside)).collect())
    }
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
