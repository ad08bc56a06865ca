//! Threads grow: a whole recording, images and video included, with as many of them as the machine has.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use crate::bench::film::film;
use anyhow::Result;
use endless_dataset::RecipeDraft;

const COUNTS: [usize; 5] = [1, 2, 4, 8, 16];
/// Seconds of video for each thread: when the last frames are made, some threads have nothing to do.
const SECONDS_A_THREAD: f64 = 1.0;

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let duration = setup.asked_duration().unwrap_or(SECONDS_A_THREAD * setup.threads as f64);
    let draft = RecipeDraft { duration: Some(duration), ..setup.draft() };
    let heads = [
        "threads",
        "load s",
        "bake s/camera",
        "camera frames/s",
        "load efficiency",
        "bake efficiency",
        "frame efficiency",
    ];
    let mut table = Table::begin("threads: a whole recording", &heads)?;
    let mut first = None;
    for threads in COUNTS.into_iter().filter(|&count| count <= setup.threads) {
        let made = film(setup.simulator, draft.clone(), threads)?;
        let cameras = made.plan.scenes.iter().map(|scene| scene.cameras.len()).sum::<usize>() as f64;
        let [load_s, bake_s, record_s] =
            [made.times.load_map, made.times.renderer.bake, made.times.record].map(|time| time.as_secs_f64());
        // What one thread did in a second against what each of many does.
        let one = *first.get_or_insert([load_s, bake_s, record_s]);
        let efficiency = |stage: usize, seconds: f64| ratio(one[stage], seconds * threads as f64);
        table.row([
            threads.to_string(),
            format!("{load_s:.2}"),
            format!("{:.2}", bake_s / cameras),
            format!("{:.1}", made.camera_frames as f64 / record_s),
            efficiency(0, load_s),
            efficiency(1, bake_s),
            efficiency(2, record_s),
        ])?;
    }
    table.end("")?;
    Ok(())
}
