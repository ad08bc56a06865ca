//! A picture of a map from above, with the views of its cameras.

use super::label;
use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{CameraBake, Gathering, RenderSettings};
use endless_town::{Town, top_view};
use endless_world::{Image, ImageSize, SignalAspect, SignalState, TimeOfDay, TooManyInstances, Weather, WorldState};

/// Size of a camera's picture.
const SMALL: ImageSize = ImageSize { width: 320, height: 180 };
/// Pictures side by side below the view from above.
const COLUMNS: usize = 3;

/// Draws the view from above with lanes, signals and cameras, and below it each camera's picture with its name.
pub(crate) fn preview(town: &Town, catalogue: &Catalogue) -> Result<Image<[u8; 3]>, TooManyInstances> {
    let width = SMALL.width as usize * COLUMNS;
    let above = top_view(town, catalogue, width as u32);
    let rows = town.cameras.len().div_ceil(COLUMNS);
    let height = width + rows * SMALL.height as usize;
    let mut pixels = vec![[0u8; 3]; width * height];
    pixels[..width * width].copy_from_slice(&above);
    let town_scene = TownScene::load(town, catalogue)?;
    let still = town_scene.static_scene();
    let settings = RenderSettings {
        gathering: Gathering::Interpolated { rays: 4 },
        ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 0, SMALL)
    };
    let signals = vec![SignalState { aspect: SignalAspect::Red }; usize::from(town.network.signal_groups)];
    let state = WorldState { frame: 0, time_s: 0.0, actors: Vec::new(), signals };
    let models = ActorModels::new(catalogue, &state.actors);
    let frame = models.frame_scene(&state);
    for (i, site) in town.cameras.iter().enumerate() {
        let seen = CameraBake::bake(still, &settings, site).render(still, &frame).rgb;
        let corner = (width + (i / COLUMNS) * SMALL.height as usize) * width + (i % COLUMNS) * SMALL.width as usize;
        for (y, row) in seen.data.chunks(SMALL.width as usize).enumerate() {
            pixels[corner + y * width..corner + y * width + row.len()].copy_from_slice(row);
        }
        label::write(&mut pixels, width, [corner % width + 3, corner / width + 3], &site.name);
    }
    let size = ImageSize { width: width as u32, height: height as u32 };
    Ok(Image { size, data: pixels })
}
