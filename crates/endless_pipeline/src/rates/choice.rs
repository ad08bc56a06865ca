//! Which videos are tried.

use endless_world::SceneSettings;

/// So many videos of a plan, each as unlike those before it as can be: in its time of day first, then its weather, then its
/// map.
pub(super) fn unlike(scenes: &[SceneSettings], count: usize) -> Vec<&SceneSettings> {
    let mut chosen: Vec<&SceneSettings> = Vec::new();
    while chosen.len() < count.min(scenes.len()) {
        let seen = |scene: &SceneSettings| {
            let times = |of: &dyn Fn(&SceneSettings) -> bool| chosen.iter().filter(|other| of(other)).count();
            (
                times(&|other| other.video == scene.video),
                times(&|other| other.time_of_day == scene.time_of_day && other.weather == scene.weather),
                times(&|other| other.time_of_day == scene.time_of_day),
                times(&|other| other.weather == scene.weather),
                times(&|other| other.map == scene.map),
            )
        };
        let Some(next) = scenes.iter().min_by_key(|scene| seen(scene)) else { break };
        chosen.push(next);
    }
    chosen
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Plan, resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;
    use std::collections::BTreeSet;

    #[test]
    fn conditions_and_maps_differ_as_long_as_there_are_others() {
        let draft = RecipeDraft { videos: Some(40), ..RecipeDraft::default() };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        let plan = Plan::new(&recipe, &ThreeTowns).expect("plannable");
        let three = unlike(&plan.scenes, 3);
        let distinct =
            |of: &dyn Fn(&SceneSettings) -> String| three.iter().map(|s| of(s)).collect::<BTreeSet<_>>().len();
        assert_eq!(distinct(&|s| s.time_of_day.to_string()), 3);
        assert_eq!(distinct(&|s| s.weather.to_string()), 3);
        assert_eq!(distinct(&|s| s.map.clone()), 3);
        assert_eq!(unlike(&plan.scenes, 100).len(), 40, "no video twice");
    }
}
