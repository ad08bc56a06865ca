//! New cameras for every video.

use super::scene_camera::scene_camera;
use crate::{MapCatalog, PlanError, SiteRequest};
use endless_dataset::Recipe;
use endless_world::{SceneSettings, Stream};

/// Draws the cameras of all scenes.
pub(super) fn draw(scenes: &mut [SceneSettings], recipe: &Recipe, catalog: &dyn MapCatalog) -> Result<(), PlanError> {
    let wanted = recipe.cameras_per_scene;
    if wanted == 0 || scenes.is_empty() {
        return Ok(());
    }
    // Those of a map after one another: it may be one town for all of them.
    let mut by_map: Vec<&mut SceneSettings> = scenes.iter_mut().collect();
    by_map.sort_by_key(|scene| recipe.maps.iter().position(|map| *map == scene.map));
    let request = |scene: &&mut SceneSettings| SiteRequest {
        map: scene.map.clone(),
        seed: Stream::named(recipe.seed, "drawn sites", &[u64::from(scene.video)]).next_u64(),
        town_seed: scene.town_seed,
        cameras: wanted,
        overlapping: recipe.overlapping,
        views: recipe.views.clone(),
    };
    let requests: Vec<SiteRequest> = by_map.iter().map(request).collect();
    for (scene, sites) in by_map.into_iter().zip(catalog.draw_sites(&requests)?) {
        let sites = sites.ok_or_else(|| PlanError::NoViews { map: scene.map.clone(), wanted })?;
        let camera = |numbered| scene_camera(recipe, scene, numbered);
        scene.cameras = sites.into_iter().zip(0..).map(camera).collect();
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use crate::{Plan, resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;
    use std::collections::BTreeSet;

    fn plan(videos: i64, town_seed: &str, preset: impl Fn(RecipeDraft) -> RecipeDraft) -> Plan {
        let draft = RecipeDraft {
            videos: Some(videos),
            sites: Some("drawn".into()),
            town_seed: Some(town_seed.into()),
            region: Some("drawn".into()),
            ..RecipeDraft::default()
        };
        let recipe = resolve_recipe(preset(draft), &ThreeTowns).expect("valid");
        Plan::new(&recipe, &ThreeTowns).expect("plannable")
    }

    #[test]
    fn every_video_has_cameras_of_its_own_and_a_longer_plan_begins_with_a_shorter_one() {
        for town_seed in ["fixed", "drawn"] {
            let (short, long) = (plan(20, town_seed, |draft| draft), plan(60, town_seed, |draft| draft));
            assert_eq!(short.scenes, long.scenes[..20]);
            let places = long.scenes.iter().flat_map(|s| s.cameras.iter().map(|c| c.site.position.map(f32::to_bits)));
            assert_eq!(places.collect::<BTreeSet<_>>().len(), 120);
            assert!(long.scenes.iter().all(|scene| scene.town_seed.is_some() == (town_seed == "drawn")));
            let regions: BTreeSet<&str> = long.scenes.iter().map(|scene| scene.profile.region.name()).collect();
            assert_eq!(regions.len(), 4);
        }
    }

    #[test]
    fn each_video_is_filmed_in_a_town_of_its_own() {
        let plan = plan(9, "drawn", |draft| RecipeDraft { balance: Some(true), ..draft });
        for (i, one) in plan.scenes.iter().enumerate() {
            assert!(plan.scenes.iter().enumerate().all(|(k, other)| one.shares_town(other) == (i == k)));
        }
        // Every video costs a load of a map: three shards have three each.
        assert!(plan.shards(3).iter().all(|part| part.len() == 3));
    }
}
