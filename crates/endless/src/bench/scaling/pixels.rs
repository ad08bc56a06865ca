//! Pixels grow: a quarter, a half and all of a picture's width and height.

use super::setup::ScalingSetup;
use super::table::{Table, ratio};
use anyhow::Result;
use endless_dataset::RecipeDraft;
use endless_world::{ImageSize, SceneSettings};

/// The largest picture if no size was asked for.
const SIZE: ImageSize = ImageSize { width: 1920, height: 1080 };
/// Parts of its width and height.
const PARTS: [u32; 3] = [4, 2, 1];

pub(super) fn run(setup: &ScalingSetup<'_>) -> Result<()> {
    let whole = setup.scene(RecipeDraft {
        size: Some(setup.asked_size().map_or_else(|| SIZE.to_string(), ToOwned::to_owned)),
        ..setup.draft()
    })?;
    let (map, _) = setup.timer.load(&whole.map)?;
    let heads = ["size", "bake s/camera", "ms/camera frame", "bake per pixel", "frame per pixel"];
    let mut table = Table::begin("pixels: the cost of one against that of the smallest picture", &heads)?;
    let mut smallest = None;
    for part in PARTS {
        let ImageSize { width, height } = whole.size;
        let size = ImageSize { width: (width / part).max(1), height: (height / part).max(1) };
        let settings = SceneSettings { size, ..whole.clone() };
        let cost = setup.timer.cost(&map, &settings)?;
        let pixels = size.pixels() as f64;
        let per_pixel = [cost.bake_s / pixels, cost.frame_ms / pixels];
        let first = *smallest.get_or_insert(per_pixel);
        table.row([
            size.to_string(),
            format!("{:.2}", cost.bake_s),
            format!("{:.2}", cost.frame_ms),
            ratio(per_pixel[0], first[0]),
            ratio(per_pixel[1], first[1]),
        ])?;
    }
    table.end("")?;
    Ok(())
}
