//! A map's static scene as one video varies it.

use super::map::BuiltinMap;
use endless_asset::Catalogue;
use endless_city::{ClutterPiece, clutter};
use endless_render::StaticScene;
use endless_world::{CameraSite, RandomisedPart, SceneSettings};

/// The scene of a video with lamps or clutter of its own; `None` where it is that of the map. Geometry is shared, so that
/// this costs little beside a bake.
pub(super) fn scene_variant(map: &BuiltinMap, catalogue: &Catalogue, settings: &SceneSettings) -> Option<StaticScene> {
    let randomised = settings.randomised.as_ref()?;
    let usual = map.town_scene.static_scene();
    let cluttered = randomised.varies(RandomisedPart::Clutter).then(|| {
        let sites: Vec<CameraSite> = settings.cameras.iter().map(|camera| camera.site.clone()).collect();
        let (strength, seed) = (randomised.strength, randomised.seed);
        let pieces = clutter(&map.town, &map.town_scene, catalogue, &sites, strength, seed);
        usual.with_instances(pieces.iter().map(ClutterPiece::instance))
    });
    let relit = randomised.light.map(|light| {
        let factors = |lamp| light.lamp(randomised.seed, randomised.strength, lamp);
        cluttered.as_ref().unwrap_or(usual).with_lamp_factors(factors)
    });
    relit.or(cluttered)
}
