//! One scene of the built-in city.

use super::{
    actors,
    bodies::Skeletons,
    map::BuiltinMap,
    repainted::repainted,
    road_facts::road_facts,
    scene_frame::scene_frame,
    scene_variant::scene_variant,
    shapes::{MovingShapes, ParkedShapes},
};
use crate::{RenderStats, RenderTask, SceneTruth, SimulationSession, SimulationStep, SimulatorError};
use endless_annotate::{ActorRecord, Box3d, CameraView, ObjectShapes, RoadFacts, SceneFrame, SceneObjects};
use endless_asset::Catalogue;
use endless_city::ActorModels;
use endless_dataset::SpawnCounts;
use endless_render::{CameraBake, FrameScene, StaticScene};
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, Condition, InstanceId, SceneSettings, SensorFrame, SensorLayers, WorldState};
use std::{
    collections::BTreeMap,
    sync::{Arc, OnceLock},
    time::{Duration, Instant},
};

/// Ticks the traffic; what shows it is shared with the render tasks.
pub(super) struct BuiltinSession<'m> {
    simulation: Simulation,
    begun: bool,
    scene: Arc<BuiltinScene<'m>>,
}

/// What stays the same in all frames of a session.
struct BuiltinScene<'m> {
    map: &'m BuiltinMap,
    /// The map's scene as this video varies it, made when it is first needed; `None` if it does not.
    variant: OnceLock<Option<StaticScene>>,
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
        let focus = settings.usual_positions().collect();
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
            variant: OnceLock::new(),
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
        Ok(Self { simulation, begun: false, scene: Arc::new(scene) })
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
    /// What stands still in this video.
    fn still(&self) -> &StaticScene {
        let variant = self.variant.get_or_init(|| scene_variant(self.map, self.catalogue, self.settings));
        variant.as_ref().unwrap_or_else(|| self.map.town_scene.static_scene())
    }

    /// The cameras, baked when they are first needed.
    fn cameras(&self) -> &BakedCameras {
        self.cameras.get_or_init(|| {
            let Self { map, settings, wanted, .. } = *self;
            let start = Instant::now();
            let still = self.still();
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

    /// What moves at the instant that a frame is of.
    fn frame_scene<'f>(&self, frame: &'f SharedFrame, state: &WorldState) -> &'f Arc<FrameScene> {
        frame.get_or_init(|| Arc::new(self.models().frame_scene(state)))
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
        let BuiltinScene { catalogue, settings, parked, moving, .. } = &*self.scene;
        Some(repainted(actors::describe(catalogue, parked.iter().chain(moving)), settings))
    }

    fn prepare(&mut self) -> Result<(), SimulatorError> {
        self.scene.cameras();
        self.scene.models();
        Ok(())
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        if self.begun {
            self.simulation.tick();
        }
        self.begun = true;
        let task = Box::new(BuiltinRenderTask { scene: Arc::clone(&self.scene), frame: Arc::default() });
        Ok(SimulationStep { state: self.simulation.state(), task })
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
    frame: SharedFrame,
}

/// What moves at one instant, made when it is first needed: by the renderer, or by labels of a picture that is there.
type SharedFrame = Arc<OnceLock<Arc<FrameScene>>>;

impl<'m> RenderTask<'m> for BuiltinRenderTask<'m> {
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        let BuiltinScene { parked, skin_tones, skeletons, .. } = &*self.scene;
        let (scene, frame) = (Arc::clone(&self.scene), Arc::clone(&self.frame));
        SceneTruth {
            objects: SceneObjects::new(state, parked).with_skin_tones(skin_tones),
            bodies: skeletons.bodies(state),
            shapes: Some(Box::new(SceneShapes { scene, frame, state: state.clone(), moving: OnceLock::new() })),
        }
    }

    fn scene_frame(&self, state: &WorldState) -> Option<SceneFrame> {
        let BuiltinScene { settings, map, parked, .. } = &*self.scene;
        Some(scene_frame(settings, &map.town.network, parked, state))
    }

    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        let (cameras, still) = (self.scene.cameras(), self.scene.still());
        let frame = self.scene.frame_scene(&self.frame, state);
        Ok(cameras.baked.iter().map(|camera| camera.render(still, frame)).collect())
    }
}

/// The shapes of all objects of a scene at one instant.
struct SceneShapes<'m> {
    scene: Arc<BuiltinScene<'m>>,
    frame: SharedFrame,
    state: WorldState,
    moving: OnceLock<MovingShapes>,
}

impl SceneShapes<'_> {
    fn moving(&self) -> &MovingShapes {
        self.moving.get_or_init(|| {
            let frame = self.scene.frame_scene(&self.frame, &self.state);
            MovingShapes::new(&self.state.actors, Arc::clone(frame))
        })
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
