//! A map's static scene as one video varies it.

use super::map::BuiltinMap;
use endless_render::StaticScene;
use endless_world::SceneSettings;

/// The scene of a video that randomises lamps; `None` where it is that of the map. Geometry is shared, so that this costs
/// little beside a bake.
pub(super) fn scene_variant(map: &BuiltinMap, settings: &SceneSettings) -> Option<StaticScene> {
    let randomised = settings.randomised.as_ref()?;
    let light = randomised.light?;
    let factors = |lamp| light.lamp(randomised.seed, randomised.strength, lamp);
    Some(map.town_scene.static_scene().with_lamp_factors(factors))
}
