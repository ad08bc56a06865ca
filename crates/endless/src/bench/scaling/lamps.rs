//! Light grows: the sun alone, all lamps of a town at night, and the same in fog that shows their halos.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use anyhow::Result;
use endless_dataset::RecipeDraft;
use endless_world::{TimeOfDay, Weather};

const CONDITIONS: [(Weather, TimeOfDay); 3] = [
    (Weather::ClearSky, TimeOfDay::Afternoon),
    (Weather::ClearSky, TimeOfDay::Night),
    (Weather::Foggy, TimeOfDay::Night),
];

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let (map, _) = setup.timer.load(&setup.map())?;
    let heads = ["weather", "time", "bake s/camera", "ms/camera frame", "bake ratio", "frame ratio"];
    let mut table = Table::begin("lamps: by day, at night, at night in fog", &heads)?;
    let mut first = None;
    for (weather, time) in CONDITIONS {
        let settings = setup.scene(RecipeDraft {
            weathers: Some(vec![weather.to_string()]),
            times: Some(vec![time.to_string()]),
            ..setup.draft()
        })?;
        let cost = setup.timer.cost(&map, &settings)?;
        let day = *first.get_or_insert([cost.bake_s, cost.frame_ms]);
        table.row([
            weather.to_string(),
            time.to_string(),
            format!("{:.2}", cost.bake_s),
            format!("{:.2}", cost.frame_ms),
            ratio(cost.bake_s, day[0]),
            ratio(cost.frame_ms, day[1]),
        ])?;
    }
    table.end("")?;
    Ok(())
}
