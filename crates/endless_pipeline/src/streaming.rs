//! Frames handed over in order while they are made, instead of written.
//!
//! ```text
//! generate   plan ─► videos ─► workers ─► files
//! stream     plan ─► videos ─► workers ─► one call after the other, in the order of frames
//! ```
//! Both run the same simulation, rendering and labels: what is handed over equals what would be read from the files, to
//! the byte. Memory is bounded: while the receiver is busy, the workers make a few frames more and then wait.

mod frame;
mod handover;
mod options;
mod video;

pub use frame::{Measurement, StreamedCamera, StreamedFrame, StreamedSensor, StreamedVideo};
pub use options::{StreamEnd, StreamOptions, StreamOrder};

use crate::{
    GenerateError, MapUse, Plan, Progress, ProgressEvent, Simulator,
    record::{StageClock, worker_pool},
};
use endless_dataset::Recipe;
use endless_world::SceneSettings;
use std::ops::ControlFlow;
use video::{VideoStream, stream_video};

/// Makes the frames of a recipe and hands them over, one at a time and in order, on threads of its own. It waits for
/// `take` to come back, and ends when that breaks.
///
/// # Errors
/// When a plan cannot be made of the recipe, or the simulator fails.
pub fn stream<S: Simulator>(
    simulator: &S,
    recipe: &Recipe,
    options: &StreamOptions,
    progress: &dyn Progress,
    take: &mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
) -> Result<StreamEnd, GenerateError> {
    let pool = worker_pool(simulator, options.threads)?;
    pool.install(|| stream_in(&pool, simulator, recipe, options, progress, take))
}

/// [`stream`] on the threads of a pool.
fn stream_in<S: Simulator>(
    pool: &rayon::ThreadPool,
    simulator: &S,
    recipe: &Recipe,
    options: &StreamOptions,
    progress: &dyn Progress,
    take: &mut (dyn FnMut(StreamedFrame) -> ControlFlow<()> + Send),
) -> Result<StreamEnd, GenerateError> {
    let plan = Plan::new(recipe, simulator)?;
    let mut order = plan.part(options.shard);
    if options.order == StreamOrder::ByNumber {
        order.sort_unstable();
    }
    let (skipped, first) = skip(&plan, &order, options.first_frame);
    let scenes: Vec<&SceneSettings> = order[skipped..].iter().map(|video| &plan.scenes[*video as usize]).collect();
    let mut index = options.first_frame;
    let (mut first, mut place) = (first, 0);
    for same_map in scenes.chunk_by(|a, b| a.shares_town(b)) {
        let name = &same_map[0].map;
        let cameras = plan.all_cameras(recipe, simulator, same_map[0])?;
        progress.event(&ProgressEvent::LoadMap { map: name });
        let map = simulator.load_map(&MapUse { name, cameras: &cameras, videos: same_map })?;
        for &settings in same_map {
            place += 1;
            let clock = StageClock::default();
            let video = VideoStream { pool, recipe, settings, progress, clock: &clock, place, of: scenes.len() as u32 };
            let from = std::mem::take(&mut first);
            if stream_video(simulator, &map, &video, from, index, take)? == StreamEnd::Stopped {
                return Ok(StreamEnd::Stopped);
            }
            index += u64::from(settings.frames - from);
        }
    }
    Ok(StreamEnd::Complete)
}

/// How many videos end before a frame, and the number of that frame in the next one.
fn skip(plan: &Plan, order: &[u32], first_frame: u64) -> (usize, u32) {
    let mut left = first_frame;
    for (skipped, video) in order.iter().enumerate() {
        let frames = u64::from(plan.scenes[*video as usize].frames);
        if left < frames {
            return (skipped, left as u32);
        }
        left -= frames;
    }
    (order.len(), 0)
}
