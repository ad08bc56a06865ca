//! Moving objects grow: vehicles and as many people, most of them where the cameras look.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use anyhow::Result;
use endless_dataset::RecipeDraft;

/// Vehicles, and people.
const CROWDS: [i64; 4] = [0, 30, 100, 300];
/// The crowd with which the others are compared.
const USUAL: i64 = 30;

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let (map, _) = setup.timer.load(&setup.map())?;
    let heads = ["vehicles", "people", "models s", "bake s/camera", "ms/camera frame", "frame ratio"];
    let mut table = Table::begin("moving objects, most of them where the cameras look", &heads)?;
    let mut usual_ms = None;
    for count in CROWDS {
        let (vehicles, pedestrians) = (Some(count), Some(count));
        let settings = setup.scene(RecipeDraft { vehicles, pedestrians, ..setup.draft() })?;
        let cost = setup.timer.cost(&map, &settings)?;
        if count == USUAL {
            usual_ms = Some(cost.frame_ms);
        }
        table.row([
            cost.spawned.vehicles.to_string(),
            cost.spawned.pedestrians.to_string(),
            format!("{:.2}", cost.models_s),
            format!("{:.2}", cost.bake_s),
            format!("{:.2}", cost.frame_ms),
            usual_ms.map_or_else(String::new, |usual| ratio(cost.frame_ms, usual)),
        ])?;
    }
    table.end("")?;
    Ok(())
}
