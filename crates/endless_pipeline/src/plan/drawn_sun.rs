//! How high the sun of a video stands, where each draws its own.

use endless_dataset::Recipe;
use endless_world::{PerVideo, Stream, TimeOfDay};

/// Of mornings, degrees above the horizon: from just risen to that of the late forenoon.
const MORNING_SUN_DEG: [f32; 2] = [1.0, 35.0];
/// Of afternoons: from that of a winter's day to that of a noon in summer.
const AFTERNOON_SUN_DEG: [f32; 2] = [15.0, 70.0];
/// Of dusk and dawn: civil twilight, which ends at -6.
const TWILIGHT_SUN_DEG: [f32; 2] = [-6.0, -0.5];
/// Share of nights that are dusk or dawn; the others are dark.
const TWILIGHTS: f64 = 0.5;

/// Its elevation; `None` as the condition has it. Where the time of day changes, the sun goes its own way.
pub(super) fn elevation_deg(recipe: &Recipe, video: u32, time_of_day: TimeOfDay) -> Option<f32> {
    if recipe.sun == PerVideo::Fixed || recipe.changing.time() {
        return None;
    }
    let mut random = Stream::named(recipe.seed, "sun", &[u64::from(video)]);
    let [low, high] = match time_of_day {
        TimeOfDay::Morning => MORNING_SUN_DEG,
        TimeOfDay::Afternoon => AFTERNOON_SUN_DEG,
        TimeOfDay::Night if random.chance(TWILIGHTS) => TWILIGHT_SUN_DEG,
        TimeOfDay::Night => return None,
    };
    Some(random.range_f32(low, high))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Plan, resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;
    use endless_world::{Changing, DrawnSun, SceneSettings};

    fn recipe(sun: PerVideo, changing: Changing) -> Recipe {
        let draft = RecipeDraft {
            videos: Some(300),
            sun: Some(sun.to_string()),
            camera_look: Some("cctv".into()),
            ..RecipeDraft::default()
        };
        Recipe { changing, ..resolve_recipe(draft, &ThreeTowns).expect("valid") }
    }

    fn scenes(sun: PerVideo, changing: Changing) -> Vec<SceneSettings> {
        Plan::new(&recipe(sun, changing), &ThreeTowns).expect("plannable").scenes
    }

    #[test]
    fn each_time_of_day_has_its_heights() {
        let recipe = recipe(PerVideo::Drawn, Changing::Nothing);
        for (time, [low, high], drawn) in [
            (TimeOfDay::Morning, [1.0, 35.0], 1.0),
            (TimeOfDay::Afternoon, [15.0, 70.0], 1.0),
            (TimeOfDay::Night, [-6.0, -0.5], 0.5),
        ] {
            let suns: Vec<f32> = (0..2000).filter_map(|video| elevation_deg(&recipe, video, time)).collect();
            assert!((suns.len() as f64 / 2000.0 - drawn).abs() < 0.04, "{time}: {} are drawn", suns.len());
            assert!(suns.iter().all(|sun| (low..=high).contains(sun)), "{time}");
            let middle = suns.iter().sum::<f32>() / suns.len() as f32;
            assert!((middle - 0.5 * (low + high)).abs() < 0.05 * (high - low), "{time}: {middle}");
        }
    }

    #[test]
    fn nothing_is_drawn_for_a_fixed_sun_and_for_one_that_moves() {
        let none = |sun, changing| scenes(sun, changing).iter().all(|scene| scene.sun_elevation_deg.is_none());
        assert!(none(PerVideo::Fixed, Changing::Nothing) && none(PerVideo::Fixed, Changing::Weather));
        assert!(none(PerVideo::Drawn, Changing::Time) && none(PerVideo::Drawn, Changing::Both));
        assert!(!none(PerVideo::Drawn, Changing::Nothing) && !none(PerVideo::Drawn, Changing::Weather));
    }

    #[test]
    fn the_seed_decides_and_all_else_stays() {
        let drawn = scenes(PerVideo::Drawn, Changing::Nothing);
        assert_eq!(drawn, scenes(PerVideo::Drawn, Changing::Nothing));
        for (drawn, fixed) in drawn.iter().zip(scenes(PerVideo::Fixed, Changing::Nothing)) {
            let cameras = fixed.cameras.clone();
            let unlike = drawn.cameras.iter().zip(&cameras).any(|(a, b)| a.look.clock != b.look.clock);
            assert_eq!(unlike, drawn.sun_elevation_deg.is_some(), "the clock fits the sun");
            let rest = SceneSettings { sun_elevation_deg: None, cameras, ..drawn.clone() };
            assert_eq!(rest, fixed);
        }
    }

    #[test]
    fn clocks_tell_the_hours_of_the_sun() {
        for scene in scenes(PerVideo::Drawn, Changing::Nothing) {
            let hour = scene.cameras[0].look.clock.expect("stamped").second as f32 / 3600.0;
            let hours = match (scene.time_of_day, DrawnSun::of(&scene)) {
                (TimeOfDay::Morning, _) => 5.5..10.6,
                (TimeOfDay::Afternoon, _) => 12.0..19.2,
                (TimeOfDay::Night, None) => 22.0..23.6,
                (TimeOfDay::Night, Some(sun)) if sun.rises => 4.6..7.0,
                (TimeOfDay::Night, Some(_)) => 19.1..21.5,
            };
            assert!(hours.contains(&hour), "{} at {hour}", scene.time_of_day);
        }
    }
}
