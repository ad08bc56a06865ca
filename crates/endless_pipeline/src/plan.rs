//! Which scenes a recipe means: the paper's section 4.3.2.

use crate::{MapCatalog, PlanError};
use endless_dataset::Recipe;
use endless_world::{CameraLook, CameraSite, Clock, SceneSettings, Stream, TimeOfDay, Weather};

/// The settings of every video, by number.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// One a video.
    pub scenes: Vec<SceneSettings>,
    /// Maps in the order in which they are worked on.
    maps: Vec<String>,
}

/// One element of the product.
struct Combination<'a> {
    map: &'a str,
    weather: Weather,
    time_of_day: TimeOfDay,
    cameras: [&'a CameraSite; 2],
}

impl Plan {
    /// The plan of a recipe: a seeded shuffle of the product of map, weather, time of day and distinct camera pairs.
    ///
    /// When more videos are asked for than there are combinations, another shuffle of all of them follows, and so on:
    /// every combination appears ⌊n/k⌋ or ⌈n/k⌉ times. A video's number is its place in this list, so that a longer
    /// list begins with the shorter one.
    ///
    /// # Errors
    /// When a map has no two cameras.
    pub fn new(recipe: &Recipe, catalog: &dyn MapCatalog) -> Result<Self, PlanError> {
        let sites: Vec<(String, Vec<CameraSite>)> = recipe
            .maps
            .iter()
            .map(|map| {
                let own = recipe.cameras.get(map).cloned();
                let cameras = own.map_or_else(|| catalog.cameras(map), Ok)?;
                if cameras.len() < 2 {
                    return Err(PlanError::NoPair { map: map.clone(), cameras: cameras.len() });
                }
                Ok((map.clone(), cameras))
            })
            .collect::<Result<_, _>>()?;
        let combinations = product(recipe, &sites);
        let mut scenes: Vec<SceneSettings> = Vec::with_capacity(recipe.videos as usize);
        for round in 0.. {
            let mut order: Vec<usize> = (0..combinations.len()).collect();
            Stream::named(recipe.seed, "plan", &[round]).shuffle(&mut order);
            for index in order {
                if scenes.len() == recipe.videos as usize {
                    return Ok(Self { scenes, maps: recipe.maps.clone() });
                }
                scenes.push(combinations[index].settings(scenes.len() as u32, recipe));
            }
        }
        unreachable!("every round adds scenes")
    }

    /// Numbers of the videos in the order of work: by map, so that each is loaded once.
    pub fn work_order(&self) -> Vec<u32> {
        let mut order: Vec<&SceneSettings> = self.scenes.iter().collect();
        order.sort_by_key(|s| self.maps.iter().position(|m| *m == s.map));
        order.into_iter().map(|s| s.video).collect()
    }
}

fn product<'a>(recipe: &Recipe, sites: &'a [(String, Vec<CameraSite>)]) -> Vec<Combination<'a>> {
    let mut all = Vec::new();
    for (map, cameras) in sites {
        for &weather in &recipe.weathers {
            for &time_of_day in &recipe.times {
                for (i, first) in cameras.iter().enumerate() {
                    for second in &cameras[i + 1..] {
                        all.push(Combination { map, weather, time_of_day, cameras: [first, second] });
                    }
                }
            }
        }
    }
    all
}

impl Combination<'_> {
    fn settings(&self, video: u32, recipe: &Recipe) -> SceneSettings {
        let clock = Clock::new(self.time_of_day, &mut Stream::named(recipe.seed, "clock", &[u64::from(video)]));
        SceneSettings {
            video,
            map: self.map.to_owned(),
            weather: self.weather,
            time_of_day: self.time_of_day,
            cameras: self.cameras.map(CameraSite::clone),
            looks: [0, 1].map(|camera| {
                let mut random = Stream::named(recipe.seed, "camera look", &[u64::from(video), camera]);
                CameraLook::new(recipe.camera_look, self.time_of_day, clock, &mut random)
            }),
            vehicles: recipe.vehicles,
            pedestrians: recipe.pedestrians,
            size: recipe.size,
            fps: recipe.fps,
            frames: recipe.frames(),
            seed: Stream::named(recipe.seed, "scene", &[u64::from(video)]).next_u64(),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::{RecipeDraft, SimulatorError};
    use endless_world::Mount;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    /// Three towns of three, four and five cameras.
    pub(crate) struct ThreeTowns;

    impl MapCatalog for ThreeTowns {
        fn maps(&self) -> Vec<String> {
            (1..=3).map(|n| format!("Town0{n}")).collect()
        }

        fn summary(&self, _map: &str) -> Result<String, SimulatorError> {
            Ok(String::new())
        }

        fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
            let count = 2 + map.bytes().last().map_or(0, |b| b - b'0');
            let site = |i| CameraSite {
                name: format!("site_{i}"),
                position: [f32::from(i), 0.0, 6.0],
                yaw_rad: 0.0,
                down_tilt_rad: 0.4,
                horizontal_fov_rad: 1.2,
                mount: Mount::Pole,
            };
            Ok((0..count).map(site).collect())
        }
    }

    fn recipe(videos: u32, seed: u64, maps: usize, weathers: usize, times: usize) -> Recipe {
        let take = |names: Vec<&str>, n: usize| Some(names.into_iter().take(n).map(str::to_owned).collect());
        let draft = RecipeDraft {
            videos: Some(i64::from(videos)),
            seed: Some(seed),
            maps: take(vec!["Town01", "Town02", "Town03"], maps),
            weathers: take(Weather::ALL.iter().map(|w| w.name()).collect(), weathers),
            times: take(TimeOfDay::ALL.iter().map(|t| t.name()).collect(), times),
            ..Default::default()
        };
        draft.resolve(&ThreeTowns).expect("valid")
    }

    fn key(s: &SceneSettings) -> String {
        format!("{} {} {} {} {}", s.map, s.weather, s.time_of_day, s.cameras[0].name, s.cameras[1].name)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn every_combination_appears_in_proportion(
            n in 1u32..400, seed: u64, maps in 1usize..4, weathers in 1usize..4, times in 1usize..3,
        ) {
            let plan = Plan::new(&recipe(n, seed, maps, weathers, times), &ThreeTowns).expect("plannable");
            // Pairs of three, four and five cameras.
            let k = ([3, 6, 10][..maps].iter().sum::<usize>() * weathers * times) as u32;
            let mut counts = BTreeMap::new();
            for scene in &plan.scenes {
                prop_assert_ne!(&scene.cameras[0], &scene.cameras[1]);
                *counts.entry(key(scene)).or_insert(0u32) += 1;
            }
            prop_assert_eq!(plan.scenes.len() as u32, n);
            prop_assert!(counts.values().all(|c| *c == n / k || *c == n.div_ceil(k)));
            prop_assert_eq!(counts.len() as u32, n.min(k));
        }

        #[test]
        fn a_longer_list_begins_with_the_shorter(short in 1u32..200, more in 0u32..200, seed: u64) {
            let plan = |n| Plan::new(&recipe(n, seed, 2, 2, 2), &ThreeTowns).expect("plannable").scenes;
            prop_assert_eq!(&plan(short)[..], &plan(short + more)[..short as usize]);
        }

        #[test]
        fn the_work_order_names_every_video_once_and_every_map_once(n in 1u32..300, seed: u64) {
            let plan = Plan::new(&recipe(n, seed, 3, 3, 2), &ThreeTowns).expect("plannable");
            let mut order = plan.work_order();
            let mut maps: Vec<&str> = order.iter().map(|v| plan.scenes[*v as usize].map.as_str()).collect();
            maps.dedup();
            prop_assert!(maps.len() <= 3);
            order.sort_unstable();
            prop_assert_eq!(order, (0..n).collect::<Vec<_>>());
        }
    }

    #[test]
    fn the_seed_decides() {
        let scenes = |seed| Plan::new(&recipe(50, seed, 3, 3, 3), &ThreeTowns).expect("plannable").scenes;
        assert_eq!(scenes(1), scenes(1));
        assert_ne!(scenes(1), scenes(2));
        let seeds: std::collections::BTreeSet<u64> = scenes(1).iter().map(|s| s.seed).collect();
        assert_eq!(seeds.len(), 50, "every scene has its own seed");
    }
}
