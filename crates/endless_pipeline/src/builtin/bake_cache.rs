//! Bakes cameras with what earlier videos and runs kept of them.

use super::bake_key::{BakeKey, bake_key, scene_key, variant_key};
use super::hits_folder::HitsFolder;
use super::kept_hits::KeptHits;
use crate::SimulatorError;
use endless_render::{CameraBake, IndirectHits, RenderSettings, StaticScene};
use endless_world::{CameraLook, CameraSite, FixedCamera, ImageSize, SceneSettings, SceneWeather, SensorLayers};
use std::path::Path;
use std::sync::{Arc, OnceLock};

/// Settings of what is kept of bakes: where their indirect rays end, which is a fifth of the work.
#[derive(Debug, Default)]
pub struct BakeCache {
    /// The most memory that this takes.
    pub(super) memory_bytes: usize,
    folder: Option<BuildFolder>,
}

/// A folder, and which build of the program uses it.
#[derive(Debug)]
struct BuildFolder {
    folder: HitsFolder,
    build: String,
}

impl BakeCache {
    /// In memory, up to so many bytes.
    pub fn in_memory(memory_bytes: usize) -> Self {
        Self { memory_bytes, folder: None }
    }

    /// Also in a folder that other runs and processes share; another build of the program keeps others there.
    ///
    /// # Errors
    /// When nothing can be written there.
    pub fn in_folder(self, path: &Path, build: impl Into<String>) -> Result<Self, SimulatorError> {
        let folder = Some(BuildFolder { folder: HitsFolder::open(path)?, build: build.into() });
        Ok(Self { folder, ..self })
    }
}

/// A bake that is asked for.
#[derive(Clone, Copy)]
pub(super) struct BakeRequest<'a> {
    pub(super) video: &'a SceneSettings,
    pub(super) camera: &'a FixedCamera,
    pub(super) weather: SceneWeather,
    pub(super) wanted: SensorLayers,
    /// Where the video keeps what its other bakes of this camera need, if there are any.
    pub(super) own_hits: Option<&'a OnceLock<Arc<IndirectHits>>>,
}

/// What is kept of the cameras of one map.
pub(super) struct MapBakes {
    cache: Arc<BakeCache>,
    scene: BakeKey,
    kept: KeptHits,
}

impl MapBakes {
    /// Of a map that these videos film, in this order.
    pub(super) fn new(cache: &Arc<BakeCache>, still: &StaticScene, videos: &[&SceneSettings]) -> Self {
        // In memory, there is only one scene.
        let scene = cache.folder.as_ref().map_or([0; 32], |folder| scene_key(&folder.build, still));
        let keys = |video: &&SceneSettings| {
            let key = |fixed: &FixedCamera| {
                let settings = render_settings(video, fixed.camera.look, fixed.size);
                bake_key(&variant_key(&scene, video), &fixed.camera.site, &settings)
            };
            (video.video, video.fixed_cameras().iter().map(key).collect())
        };
        let coming = videos.iter().map(keys).collect();
        Self { cache: Arc::clone(cache), scene, kept: KeptHits::new(cache.memory_bytes, coming) }
    }

    /// Bakes a camera of a video.
    pub(super) fn bake(&self, still: &StaticScene, request: &BakeRequest<'_>) -> CameraBake {
        let BakeRequest { video, camera, weather, wanted, own_hits } = *request;
        let settings =
            RenderSettings { layers: wanted, weather, ..render_settings(video, camera.camera.look, camera.size) };
        let site: &CameraSite = &camera.camera.site;
        if let Some(hits) = own_hits.and_then(OnceLock::get) {
            return CameraBake::bake_reusing(still, &settings, site, hits);
        }
        let key = bake_key(&variant_key(&self.scene, video), site, &settings);
        let folder = self.cache.folder.as_ref().map(|folder| &folder.folder);
        let known = self.kept.get(&key).or_else(|| folder?.read(&key));
        let (bake, hits) = if let Some(hits) = known {
            (CameraBake::bake_reusing(still, &settings, site, &hits), hits)
        } else if folder.is_none() && own_hits.is_none() && !self.kept.is_needed_after(video.video, &key) {
            return CameraBake::bake(still, &settings, site);
        } else {
            let (bake, hits) = CameraBake::bake_keeping(still, &settings, site);
            if let Some(folder) = folder {
                folder.write(&key, &hits);
            }
            (bake, Arc::new(hits))
        };
        if let Some(own) = own_hits {
            own.get_or_init(|| Arc::clone(&hits));
        }
        self.kept.keep(video.video, key, hits);
        bake
    }
}

/// How a camera of a video is rendered.
pub(super) fn render_settings(video: &SceneSettings, look: CameraLook, size: ImageSize) -> RenderSettings {
    RenderSettings {
        look,
        fps: video.fps,
        randomised: video.randomised.clone(),
        ..RenderSettings::new(video.weather, video.time_of_day, video.seed, size)
    }
}
