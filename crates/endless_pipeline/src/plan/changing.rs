//! What the condition of a video becomes.

use endless_dataset::Recipe;
use endless_world::{ConditionChange, Stream, TimeOfDay, Weather};

/// Another of the recipe's weathers, or another at all where the recipe has but one; the next time of the day.
pub(super) fn to(recipe: &Recipe, video: u32, weather: Weather, time_of_day: TimeOfDay) -> Option<ConditionChange> {
    let changing = recipe.changing;
    let change = ConditionChange {
        weather: if changing.weather() { another_weather(recipe, video, weather) } else { weather },
        time_of_day: if changing.time() { time_of_day.next() } else { time_of_day },
    };
    (changing.weather() || changing.time()).then_some(change)
}

fn another_weather(recipe: &Recipe, video: u32, weather: Weather) -> Weather {
    let others_of = |known: &[Weather]| known.iter().copied().filter(|other| *other != weather).collect::<Vec<_>>();
    let mut others = others_of(&recipe.weathers);
    if others.is_empty() {
        others = others_of(Weather::ALL);
    }
    Stream::named(recipe.seed, "changing weather", &[video.into()]).shuffle(&mut others);
    others[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Plan, resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;
    use endless_world::Changing;
    use std::collections::BTreeSet;

    fn scenes(changing: Changing, weathers: &[Weather]) -> Vec<endless_world::SceneSettings> {
        let draft = RecipeDraft { videos: Some(60), ..Default::default() };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        let recipe = Recipe { changing, weathers: weathers.to_vec(), ..recipe };
        Plan::new(&recipe, &ThreeTowns).expect("plannable").scenes
    }

    #[test]
    fn weather_and_time_change_as_asked() {
        let plain = scenes(Changing::Nothing, Weather::ALL);
        assert!(plain.iter().all(|scene| scene.changing_to.is_none()));
        for changing in [Changing::Weather, Changing::Time, Changing::Both] {
            for (scene, plain) in scenes(changing, Weather::ALL).iter().zip(&plain) {
                let to = scene.changing_to.expect("it changes");
                assert_eq!(to.weather != scene.weather, changing.weather());
                let next = if changing.time() { scene.time_of_day.next() } else { scene.time_of_day };
                assert_eq!(to.time_of_day, next);
                let unchanged = endless_world::SceneSettings { changing_to: None, ..scene.clone() };
                assert_eq!(&unchanged, plain, "each begins as it would without a change");
            }
        }
    }

    #[test]
    fn weathers_change_into_one_another_or_from_the_only_one_into_any() {
        let becoming = |weathers: &[Weather]| -> BTreeSet<Weather> {
            scenes(Changing::Weather, weathers).iter().filter_map(|s| Some(s.changing_to?.weather)).collect()
        };
        assert_eq!(becoming(&[Weather::Rainy, Weather::Foggy]), [Weather::Rainy, Weather::Foggy].into());
        assert_eq!(becoming(&[Weather::Rainy]).len(), Weather::ALL.len() - 1);
        assert_eq!(becoming(&[Weather::Rainy, Weather::Rainy]).len(), Weather::ALL.len() - 1);
    }
}
