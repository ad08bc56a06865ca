//! A frame of a town with actors standing in it.

use super::crowd;
use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{CameraBake, Gathering, RenderSettings};
use endless_town::Town;
use endless_world::{CameraSite, ImageSize, TimeOfDay, Weather};

/// What one of a town's cameras sees of it in some condition.
pub(crate) fn draw(
    town: &Town,
    town_scene: &TownScene,
    catalogue: &Catalogue,
    site: &CameraSite,
    (weather, time_of_day): (Weather, TimeOfDay),
    size: ImageSize,
) -> Vec<[u8; 3]> {
    let still = town_scene.static_scene();
    let settings = RenderSettings {
        gathering: Gathering::Interpolated { rays: 2 },
        ..RenderSettings::new(weather, time_of_day, 7, size)
    };
    let bake = CameraBake::bake(still, &settings, site);
    let lights = time_of_day == TimeOfDay::Night || matches!(weather, Weather::Rainy | Weather::Foggy);
    let state = crowd(town, site.position, catalogue, lights);
    let models = ActorModels::new(catalogue, &state.actors);
    bake.render(still, &models.frame_scene(&state)).rgb.data
}
