//! Cameras of one town grow. All of them hang at one site, so that neither what they see nor the traffic near them differs
//! from row to row.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use crate::memory;
use anyhow::Result;
use endless_dataset::RecipeDraft;
use endless_world::SceneSettings;

/// Cameras of a scene.
const COUNTS: [usize; 4] = [1, 2, 4, 8];

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let one = setup.scene(RecipeDraft { cameras_per_scene: Some(1), ..setup.draft() })?;
    let (map, _) = setup.timer.load(&one.map)?;
    let heads = ["cameras", "bake s/camera", "ms/camera frame", "peak memory MB", "bake ratio", "frame ratio"];
    let mut table = Table::begin("cameras of one town, all with the same view", &heads)?;
    let mut first = None;
    for count in COUNTS {
        memory::forget_peak();
        let cameras = std::iter::repeat_n(&one.cameras, count).flatten().cloned().collect();
        let settings = SceneSettings { cameras, ..one.clone() };
        let cost = setup.timer.cost(&map, &settings)?;
        let alone = *first.get_or_insert([cost.bake_s, cost.frame_ms]);
        table.row([
            count.to_string(),
            format!("{:.2}", cost.bake_s),
            format!("{:.2}", cost.frame_ms),
            memory::peak_megabytes().map_or_else(String::new, |peak| format!("{peak:.0}")),
            ratio(cost.bake_s, alone[0]),
            ratio(cost.frame_ms, alone[1]),
        ])?;
    }
    table.end("")?;
    Ok(())
}
