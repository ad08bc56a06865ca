//! Time by stage.

use crate::RenderStats;
use endless_dataset::Layer;
use std::{
    sync::atomic::{AtomicU64, Ordering},
    time::{Duration, Instant},
};

/// A stage of the work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    LoadMap,
    LoadScene,
    Bake,
    Traffic,
    Render,
    Boxes,
    Amodal,
    Lines,
    Images,
    Resume,
    Video,
    Record,
}

impl Stage {
    /// Done once a map or a video; the others once a frame.
    const fn is_of_a_whole_video(self) -> bool {
        matches!(self, Self::LoadMap | Self::LoadScene | Self::Bake | Self::Record)
    }
}

const LAYERS: usize = Layer::ALL.len();
const STAGES: usize = 12;

/// Adds up the time of each stage over all threads.
#[derive(Debug, Default)]
pub(crate) struct StageClock {
    nanos: [AtomicU64; STAGES],
    layer_nanos: [AtomicU64; LAYERS],
    bake_rays: AtomicU64,
    frame_rays: AtomicU64,
    camera_bake_nanos: AtomicU64,
}

/// Thread-seconds of each stage, and rays.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StageTimes {
    /// Loading maps.
    pub load_map: Duration,
    /// Populating scenes.
    pub load_scene: Duration,
    /// Baking cameras and making the models of what moves: wall time, it uses all threads itself.
    pub bake: Duration,
    /// Ticking the traffic.
    pub traffic: Duration,
    /// Rendering frames.
    pub render: Duration,
    /// Boxes, visible pixels and keypoints.
    pub boxes: Duration,
    /// Amodal boxes and masks, and what hides objects.
    pub amodal: Duration,
    /// Encoding and writing `objects.jsonl` and `frames.jsonl`.
    pub lines: Duration,
    /// Encoding and writing images.
    pub images: Duration,
    /// That of each layer, in the order of [`Layer::ALL`].
    pub layers: [Duration; LAYERS],
    /// Decoding images that were there already.
    pub resume: Duration,
    /// Encoding videos.
    pub video: Duration,
    /// Wall time of recording, bake left out.
    pub record: Duration,
    /// What the renderer counted.
    pub renderer: RenderStats,
}

impl StageClock {
    pub(crate) fn time<R>(&self, stage: Stage, work: impl FnOnce() -> R) -> R {
        let start = Instant::now();
        let result = work();
        let elapsed = start.elapsed();
        self.nanos[stage as usize].fetch_add(elapsed.as_nanos() as u64, Ordering::Relaxed);
        let seconds = elapsed.as_secs_f64();
        if stage.is_of_a_whole_video() {
            tracing::debug!(?stage, seconds);
        } else {
            tracing::trace!(?stage, seconds);
        }
        result
    }

    /// Times what encodes and writes an image of a layer, which is part of [`Stage::Images`].
    pub(crate) fn time_layer<R>(&self, layer: Layer, work: impl FnOnce() -> R) -> R {
        let start = Instant::now();
        let result = work();
        self.layer_nanos[layer as usize].fetch_add(start.elapsed().as_nanos() as u64, Ordering::Relaxed);
        result
    }

    pub(crate) fn add_stats(&self, stats: RenderStats) {
        self.bake_rays.fetch_add(stats.bake_rays, Ordering::Relaxed);
        self.frame_rays.fetch_add(stats.frame_rays, Ordering::Relaxed);
        self.camera_bake_nanos.fetch_add(stats.bake.as_nanos() as u64, Ordering::Relaxed);
    }

    pub(crate) fn times(&self) -> StageTimes {
        let of = |stage: Stage| Duration::from_nanos(self.nanos[stage as usize].load(Ordering::Relaxed));
        StageTimes {
            load_map: of(Stage::LoadMap),
            load_scene: of(Stage::LoadScene),
            bake: of(Stage::Bake),
            traffic: of(Stage::Traffic),
            render: of(Stage::Render),
            boxes: of(Stage::Boxes),
            amodal: of(Stage::Amodal),
            lines: of(Stage::Lines),
            images: of(Stage::Images),
            layers: self.layer_nanos.each_ref().map(|nanos| Duration::from_nanos(nanos.load(Ordering::Relaxed))),
            resume: of(Stage::Resume),
            video: of(Stage::Video),
            record: of(Stage::Record).saturating_sub(of(Stage::Bake)).saturating_sub(of(Stage::LoadScene)),
            renderer: RenderStats {
                bake_rays: self.bake_rays.load(Ordering::Relaxed),
                frame_rays: self.frame_rays.load(Ordering::Relaxed),
                bake: Duration::from_nanos(self.camera_bake_nanos.load(Ordering::Relaxed)),
            },
        }
    }
}
