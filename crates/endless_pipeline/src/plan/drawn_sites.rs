//! New cameras for every video.

use super::scene_camera;
use crate::{MapCatalog, PlanError, SiteRequest};
use endless_dataset::Recipe;
use endless_world::{SceneSettings, Stream};

/// Draws the cameras of the scenes of a map.
pub(super) fn draw(
    scenes: &mut [&mut SceneSettings],
    map: &str,
    recipe: &Recipe,
    catalog: &dyn MapCatalog,
) -> Result<(), PlanError> {
    let wanted = recipe.cameras_per_scene;
    if wanted == 0 || scenes.is_empty() {
        return Ok(());
    }
    let request = |scene: &&mut SceneSettings| SiteRequest {
        seed: Stream::named(recipe.seed, "drawn sites", &[u64::from(scene.video)]).next_u64(),
        town_seed: scene.town_seed,
        cameras: wanted,
        overlapping: recipe.overlapping,
        views: recipe.views.clone(),
    };
    let requests: Vec<SiteRequest> = scenes.iter().map(request).collect();
    for (scene, sites) in scenes.iter_mut().zip(catalog.draw_sites(map, &requests)?) {
        let sites = sites.ok_or_else(|| PlanError::NoViews { map: map.to_owned(), wanted })?;
        let of_video = (scene.video, scene.time_of_day);
        let camera = |numbered| scene_camera(recipe, of_video, scene.randomised.as_ref(), numbered);
        scene.cameras = sites.into_iter().zip(0..).map(camera).collect();
    }
    Ok(())
}
