//! The bakes of a scene's cameras: one each, or one at every key frame of a video in which weather or time changes.
//!
//! ```text
//! key frames    0         1         2         3       baked when a frame first needs them
//!               ├────┬────┼────┬────┼────┬────┤
//! frames        0    1    2    3    4    5    6       between two of them, a frame is a mixture of both pictures
//! ```
//! Only the two around the frames that are being made are kept.

use super::{bake_cache::BakeRequest, helped_once::HelpedOnce, map::BuiltinMap, scene_variant::scene_variant};
use crate::RenderStats;
use endless_asset::Catalogue;
use endless_render::{CameraBake, FrameScene, IndirectHits, NeighbourFrames, StaticScene};
use endless_world::{FixedCamera, SceneSettings, SceneWeather, SensorFrame, SensorLayers, WeatherTimeline};
use std::{
    sync::{
        Arc, OnceLock,
        atomic::{AtomicU64, Ordering},
    },
    time::{Duration, Instant},
};

/// What all bakes of a scene share.
pub(super) struct SceneBakes<'m> {
    map: &'m BuiltinMap,
    catalogue: &'m Catalogue,
    settings: &'m SceneSettings,
    wanted: SensorLayers,
    cameras: Vec<FixedCamera>,
    /// The map's scene as this video varies it, made when it is first needed; `None` if it does not.
    variant: OnceLock<Option<StaticScene>>,
    timeline: WeatherTimeline,
    /// By camera, where more than one bake needs them.
    own_hits: Vec<OnceLock<Arc<IndirectHits>>>,
    work: BakeWork,
}

/// Rays and time of bakes so far.
#[derive(Default)]
struct BakeWork {
    bake_rays: AtomicU64,
    bake_ns: AtomicU64,
    /// Of bakes that are gone.
    frame_rays: AtomicU64,
}

impl<'m> SceneBakes<'m> {
    /// None yet.
    pub(super) fn new(
        map: &'m BuiltinMap,
        catalogue: &'m Catalogue,
        settings: &'m SceneSettings,
        wanted: SensorLayers,
    ) -> Self {
        let timeline = WeatherTimeline::of(settings);
        let cameras = settings.fixed_cameras();
        let kept = if timeline.intervals() == 0 { 0 } else { cameras.len() };
        let own_hits = (0..kept).map(|_| OnceLock::new()).collect();
        let variant = OnceLock::new();
        Self { map, catalogue, settings, wanted, cameras, variant, timeline, own_hits, work: BakeWork::default() }
    }

    /// What stands still in this video.
    pub(super) fn still(&self) -> &StaticScene {
        let variant = self.variant.get_or_init(|| scene_variant(self.map, self.catalogue, self.settings));
        variant.as_ref().unwrap_or_else(|| self.map.town_scene.static_scene())
    }

    /// How weather and time change.
    pub(super) fn timeline(&self) -> &WeatherTimeline {
        &self.timeline
    }

    /// The weather of a frame.
    pub(super) fn weather(&self, frame: u32) -> SceneWeather {
        self.timeline.at_frame(frame)
    }

    fn bake(&self, key: u32) -> Vec<CameraBake> {
        let start = Instant::now();
        let weather = self.timeline.at_key(key);
        let bake = |(number, camera)| {
            let Self { settings: video, wanted, .. } = *self;
            let request = BakeRequest { video, camera, weather, wanted, own_hits: self.own_hits.get(number) };
            self.map.bakes.bake(self.still(), &request)
        };
        let baked: Vec<CameraBake> = self.cameras.iter().enumerate().map(bake).collect();
        self.work.bake_rays.fetch_add(rays(&baked), Ordering::Relaxed);
        self.work.bake_ns.fetch_add(start.elapsed().as_nanos() as u64, Ordering::Relaxed);
        baked
    }
}

fn rays(baked: &[CameraBake]) -> u64 {
    baked.iter().map(|b| b.stats().rays()).sum()
}

/// All cameras at one key frame.
struct KeyBake<'m> {
    scene: Arc<SceneBakes<'m>>,
    key: u32,
    baked: HelpedOnce<KeyCameras>,
}

struct KeyCameras {
    cameras: Vec<CameraBake>,
    bake_rays: u64,
}

impl KeyBake<'_> {
    fn cameras(&self) -> &[CameraBake] {
        let made = self.baked.get_or_make(|| {
            let cameras = self.scene.bake(self.key);
            KeyCameras { bake_rays: rays(&cameras), cameras }
        });
        &made.cameras
    }

    /// Of frames so far.
    fn frame_rays(&self) -> u64 {
        self.baked.get().map_or(0, |made| rays(&made.cameras) - made.bake_rays)
    }
}

impl Drop for KeyBake<'_> {
    fn drop(&mut self) {
        self.scene.work.frame_rays.fetch_add(self.frame_rays(), Ordering::Relaxed);
    }
}

/// The bakes around a frame.
#[derive(Clone)]
pub(super) struct FrameBakes<'m> {
    before: Arc<KeyBake<'m>>,
    /// And how far the frame is on the way there, above 0.
    after: Option<(Arc<KeyBake<'m>>, f32)>,
}

impl FrameBakes<'_> {
    /// What a camera sees at an instant, by its number, and what is `beside` that for it.
    pub(super) fn render(
        &self,
        number: usize,
        still: &StaticScene,
        frame: &FrameScene,
        beside: NeighbourFrames<'_>,
    ) -> SensorFrame {
        let camera = &self.before.cameras()[number];
        match &self.after {
            None => camera.render_between(still, frame, beside),
            Some((after, share)) => camera.render_changing((&after.cameras()[number], *share), still, frame, beside),
        }
    }
}

/// The bakes that frames need, in the order of the frames.
pub(super) struct KeyBakes<'m> {
    scene: Arc<SceneBakes<'m>>,
    now: FrameBakes<'m>,
}

impl<'m> KeyBakes<'m> {
    /// At frame 0.
    pub(super) fn new(scene: Arc<SceneBakes<'m>>) -> Self {
        let before = key_bake(&scene, 0);
        Self { scene, now: FrameBakes { before, after: None } }
    }

    /// Bakes what the present frame needs.
    pub(super) fn prepare(&self) {
        self.now.before.cameras();
    }

    /// Those of a frame, which is not before those asked for earlier.
    pub(super) fn at(&mut self, frame: u32) -> FrameBakes<'m> {
        let (key, share) = self.scene.timeline.place(frame);
        let now = &mut self.now;
        if now.before.key != key {
            let next = now.after.take().map(|(bake, _)| bake).filter(|bake| bake.key == key);
            now.before = next.unwrap_or_else(|| key_bake(&self.scene, key));
        }
        now.after = (share > 0.0).then(|| {
            let known = now.after.take().map(|(bake, _)| bake);
            (known.unwrap_or_else(|| key_bake(&self.scene, key + 1)), share)
        });
        now.clone()
    }

    /// Statistics so far.
    pub(super) fn stats(&self) -> RenderStats {
        let BakeWork { bake_rays, bake_ns, frame_rays } = &self.scene.work;
        let after = self.now.after.as_ref().map_or(0, |(bake, _)| bake.frame_rays());
        RenderStats {
            bake_rays: bake_rays.load(Ordering::Relaxed),
            frame_rays: frame_rays.load(Ordering::Relaxed) + self.now.before.frame_rays() + after,
            bake: Duration::from_nanos(bake_ns.load(Ordering::Relaxed)),
        }
    }
}

fn key_bake<'m>(scene: &Arc<SceneBakes<'m>>, key: u32) -> Arc<KeyBake<'m>> {
    Arc::new(KeyBake { scene: Arc::clone(scene), key, baked: HelpedOnce::default() })
}
