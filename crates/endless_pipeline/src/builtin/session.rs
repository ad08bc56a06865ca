//! One scene of the built-in city.

use super::{bodies::Skeletons, map::BuiltinMap};
use crate::{RenderStats, RenderTask, SceneTruth, SimulationSession, SimulationStep, SimulatorError};
use endless_annotate::SceneObjects;
use endless_asset::Catalogue;
use endless_city::ActorModels;
use endless_dataset::SpawnCounts;
use endless_render::CameraBake;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, Condition, InstanceId, SceneSettings, SensorFrame, WorldState};
use glam::Vec3;
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
    catalogue: &'m Catalogue,
    settings: &'m SceneSettings,
    spawned: SpawnCounts,
    parked: Vec<Actor>,
    /// Everything that moves, as it stands in frame 0: traffic takes nobody in or out.
    moving: Vec<Actor>,
    skin_tones: BTreeMap<InstanceId, u8>,
    skeletons: Skeletons,
    cameras: OnceLock<BakedCameras>,
}

struct BakedCameras {
    models: ActorModels,
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
            spawned,
            parked,
            skin_tones: skin_tones(catalogue, &moving),
            skeletons: Skeletons::of(catalogue, &moving),
            moving,
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
    /// The cameras, baked when they are first needed.
    fn cameras(&self) -> &BakedCameras {
        self.cameras.get_or_init(|| {
            let Self { map, catalogue, settings, .. } = *self;
            let start = Instant::now();
            let still = map.town_scene.static_scene();
            let baked: Vec<CameraBake> =
                settings.cameras.iter().map(|camera| map.bakes.bake(still, settings, camera)).collect();
            let bake = start.elapsed();
            let models = ActorModels::in_town(&map.town_scene, catalogue, &self.moving);
            BakedCameras { models, bake_rays: rays(&baked), baked, bake }
        })
    }
}

fn rays(baked: &[CameraBake]) -> u64 {
    baked.iter().map(|b| b.stats().rays()).sum()
}

impl<'m> SimulationSession<'m> for BuiltinSession<'m> {
    fn spawned(&self) -> SpawnCounts {
        self.scene.spawned
    }

    fn prepare(&mut self) -> Result<(), SimulatorError> {
        self.scene.cameras();
        Ok(())
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        if self.begun {
            self.simulation.tick();
        }
        self.begun = true;
        let task = Box::new(BuiltinRenderTask(Arc::clone(&self.scene)));
        Ok(SimulationStep { state: self.simulation.state(), task })
    }

    fn stats(&self) -> RenderStats {
        self.scene.cameras.get().map_or_else(RenderStats::default, |cameras| {
            let BakedCameras { bake_rays, bake, .. } = *cameras;
            RenderStats { bake_rays, frame_rays: rays(&cameras.baked) - bake_rays, bake }
        })
    }
}

struct BuiltinRenderTask<'m>(Arc<BuiltinScene<'m>>);

impl RenderTask for BuiltinRenderTask<'_> {
    fn truth(&self, state: &WorldState) -> SceneTruth {
        let BuiltinScene { parked, skin_tones, skeletons, .. } = &*self.0;
        SceneTruth {
            objects: SceneObjects::new(state, parked).with_skin_tones(skin_tones),
            bodies: skeletons.bodies(state),
        }
    }

    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        let (cameras, still) = (self.0.cameras(), self.0.map.town_scene.static_scene());
        let frame = cameras.models.frame_scene(state);
        Ok(cameras.baked.iter().map(|camera| camera.render(still, &frame)).collect())
    }
}
