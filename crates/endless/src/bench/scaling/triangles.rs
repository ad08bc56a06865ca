//! Triangles grow: towns from the smallest to the largest.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use anyhow::Result;
use endless_dataset::RecipeDraft;
use endless_pipeline::RenderStats;

/// Cameras that are baked in each town: what a bake costs depends more on the view than on the town.
const CAMERAS: i64 = 4;

/// One town, measured.
struct TownCost {
    name: String,
    triangles: usize,
    build_s: f64,
    bake_s: f64,
    mrays_a_second: f64,
}

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let mut towns = setup.maps().into_iter().map(|name| town(setup, name)).collect::<Result<Vec<_>>>()?;
    towns.sort_by_key(|town| town.triangles);
    let heads = ["town", "triangles", "build s", "bake s/camera", "Mrays/s", "bake ratio"];
    let mut table = Table::begin(&format!("triangles: {CAMERAS} cameras of each town"), &heads)?;
    for town in &towns {
        table.row([
            town.name.clone(),
            format!("{:.1} M", town.triangles as f64 / 1e6),
            format!("{:.2}", town.build_s),
            format!("{:.2}", town.bake_s),
            format!("{:.1}", town.mrays_a_second),
            ratio(town.bake_s, towns[0].bake_s),
        ])?;
    }
    table.end("the largest town shall take less than 1.50 times as long to bake as the smallest")?;
    Ok(())
}

fn town(setup: &ScalingSetup<'_>, name: String) -> Result<TownCost> {
    let (maps, cameras_per_scene) = (Some(vec![name.clone()]), Some(CAMERAS));
    let settings = setup.scene(RecipeDraft { maps, cameras_per_scene, ..setup.draft() })?;
    let (map, build_s) = setup.timer.load(&name)?;
    let (session, _) = setup.timer.prepare(&map, &settings)?;
    let RenderStats { bake, bake_rays, .. } = session.stats();
    let bake_s = bake.as_secs_f64();
    Ok(TownCost {
        name,
        triangles: map.placed_triangles(),
        build_s,
        bake_s: bake_s / CAMERAS as f64,
        mrays_a_second: bake_rays as f64 / 1e6 / bake_s,
    })
}
