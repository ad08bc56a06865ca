//! The built-in city: towns, traffic and the ray tracer joined.

mod bodies;

use crate::{Cameras, MapCatalog, PeopleBodies, RenderStats, Scene, Simulator, SimulatorError, Traffic};
use bodies::CastBodies;
use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_dataset::Spawned;
use endless_interchange::{MapError, MapLibrary};
use endless_render::{CameraBake, RenderSettings, StaticScene};
use endless_town::Town;
use endless_traffic::{Conditions, Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, CameraSite, InstanceId, SceneCamera, SceneSettings, SensorFrame, WorldState};
use glam::Vec3;
use std::collections::BTreeMap;

/// Simulates and renders without anything outside this program.
#[derive(Debug)]
pub struct BuiltinSimulator {
    library: MapLibrary,
}

/// A town and its geometry.
pub struct BuiltinMap {
    town: Town,
    town_scene: TownScene,
}

impl BuiltinSimulator {
    /// Over the maps and the catalogue of a library.
    pub fn new(library: MapLibrary) -> Self {
        Self { library }
    }

    /// Of people on foot and of riders.
    fn skin_tones(&self, moving: &[Actor]) -> BTreeMap<InstanceId, u8> {
        let who = |actor: &Actor| {
            let id = if actor.asset.person().is_some() { Some(actor.id) } else { actor.rider_id };
            Some((id?, self.library.catalogue().skin_tone(actor.asset)?))
        };
        moving.iter().filter_map(who).collect()
    }
}

impl From<MapError> for SimulatorError {
    fn from(error: MapError) -> Self {
        Self(error.to_string())
    }
}

impl MapCatalog for BuiltinSimulator {
    fn maps(&self) -> Vec<String> {
        self.library.builtin_names()
    }

    fn imported(&self) -> Vec<String> {
        self.library.imported_names()
    }

    fn content_hash(&self, map: &str) -> Result<Option<String>, SimulatorError> {
        Ok(self.library.content_hash(map)?)
    }

    fn asset_files(&self) -> BTreeMap<String, String> {
        self.library.asset_files()
    }

    fn summary(&self, map: &str) -> Result<String, SimulatorError> {
        Ok(self.library.summary(map)?.summary)
    }

    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
        Ok(self.library.summary(map)?.cameras)
    }
}

impl Simulator for BuiltinSimulator {
    type Map = BuiltinMap;

    fn load_map(&self, name: &str) -> Result<BuiltinMap, SimulatorError> {
        let town = self.library.town(name)?;
        let town_scene =
            TownScene::load(&town, self.library.catalogue()).map_err(|error| SimulatorError(error.to_string()))?;
        Ok(BuiltinMap { town, town_scene })
    }

    fn load_scene<'m>(&'m self, map: &'m BuiltinMap, settings: &SceneSettings) -> Result<Scene<'m>, SimulatorError> {
        let SceneSettings { weather, time_of_day, vehicles, pedestrians, seed, fps, .. } = *settings;
        let conditions = Conditions::new(weather, time_of_day);
        // Traffic over the whole map, denser where the cameras look.
        let focus = settings.cameras.iter().map(|c| Vec3::from_array(c.site.position)).collect();
        let traffic = TrafficSettings { vehicles, pedestrians, seed, fps, conditions, focus };
        let specs = self.library.catalogue().vehicle_specs();
        let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
        let simulation = Simulation::new(&map.town.network, &fleet, &map.town.parked, &traffic)
            .map_err(|error| SimulatorError(error.to_string()))?;
        let population = simulation.population();
        let parked = simulation.parked().to_vec();
        let spawned = Spawned {
            vehicles: population.vehicles_spawned,
            pedestrians: population.pedestrians_spawned,
            parked: parked.len() as u32,
        };
        let moving = simulation.state().actors;
        let skin_tones = self.skin_tones(&moving);
        let bodies = Some(Box::new(CastBodies::of(self.library.catalogue(), &moving)) as Box<dyn PeopleBodies>);
        let traffic = Box::new(City { simulation, begun: false });
        Ok(Scene { spawned, parked, moving, skin_tones, bodies, traffic })
    }

    fn bake<'m>(
        &'m self,
        map: &'m BuiltinMap,
        settings: &SceneSettings,
        moving: &[Actor],
    ) -> Result<Box<dyn Cameras + 'm>, SimulatorError> {
        let bake = |camera: &SceneCamera| {
            let render = RenderSettings {
                look: camera.look,
                fps: settings.fps,
                ..RenderSettings::new(settings.weather, settings.time_of_day, settings.seed, settings.size)
            };
            CameraBake::bake(map.town_scene.static_scene(), &render, &camera.site)
        };
        let baked = settings.cameras.iter().map(bake).collect::<Vec<_>>();
        let bake_rays = rays(&baked);
        Ok(Box::new(FixedCameras {
            still: map.town_scene.static_scene(),
            models: ActorModels::in_town(&map.town_scene, self.library.catalogue(), moving),
            baked,
            bake_rays,
        }))
    }
}

struct City {
    simulation: Simulation,
    begun: bool,
}

impl Traffic for City {
    fn tick(&mut self) -> WorldState {
        if self.begun {
            self.simulation.tick();
        }
        self.begun = true;
        self.simulation.state()
    }
}

struct FixedCameras<'m> {
    still: &'m StaticScene,
    models: ActorModels,
    baked: Vec<CameraBake>,
    bake_rays: u64,
}

fn rays(baked: &[CameraBake]) -> u64 {
    baked.iter().map(|b| b.stats().rays()).sum()
}

impl Cameras for FixedCameras<'_> {
    fn render(&self, state: &WorldState) -> Vec<SensorFrame> {
        let frame = self.models.frame_scene(state);
        self.baked.iter().map(|camera| camera.render(self.still, &frame)).collect()
    }

    fn stats(&self) -> RenderStats {
        RenderStats { bake_rays: self.bake_rays, frame_rays: rays(&self.baked) - self.bake_rays }
    }
}
