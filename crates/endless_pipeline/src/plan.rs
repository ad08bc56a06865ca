//! The scenes of a recipe: the paper's section 4.3.2.

mod balanced;
mod changing;
mod combination;
mod cost;
mod drawn_sites;
mod drawn_sun;
mod moved_camera;
mod overlapping;
mod partition;
mod scene_camera;
mod subsets;

use crate::{
    MapCatalog, PlanError, Shard, SimulatorError,
    rig::{RigPlaces, scene_sensors},
};
use balanced::Balanced;
use combination::{Combination, Combinations, MapSites, SparseShuffle};
use endless_dataset::{DatasetError, DatasetLayout, Manifest, Recipe, read_json};
use endless_world::math::f64::{exp, ln};
use endless_world::{
    CameraSite, Clothing, IncidentKind, Outfit, PerVideo, Region, RegionChoice, SceneRandomisation, SceneSettings,
    Stream, TrackPlayback, TrafficProfile,
};
use partition::Costs;
use scene_camera::{recorder_clock, scene_camera};

/// The settings of every video, by number.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// One a video.
    pub scenes: Vec<SceneSettings>,
    /// Maps in the order in which they are worked on.
    maps: Vec<String>,
}

impl Plan {
    /// The plan of a recipe: a seeded shuffle of the product of map, weather, time of day and sets of distinct cameras.
    ///
    /// When more videos are asked for than there are combinations, another shuffle of all of them follows, and so on:
    /// every combination appears ⌊n/k⌋ or ⌈n/k⌉ times. A video's number is its place in this list, so that a longer
    /// list begins with the shorter one.
    ///
    /// A balanced plan is another such list: after every video, each map has come as often as any other or once more, and
    /// so have each weather and each time of day.
    ///
    /// Overlapping cameras are sets in which each sees at least a quarter of the places that another sees, or that other a
    /// quarter of its own, and all hang together so; where a map has none, the sets that share most, and all where no two
    /// cameras share anything.
    ///
    /// # Errors
    /// When a map has fewer cameras than a scene needs.
    pub fn new(recipe: &Recipe, catalog: &dyn MapCatalog) -> Result<Self, PlanError> {
        let sites_of = |map: &String| {
            let drawn = recipe.sites == PerVideo::Drawn;
            let sites = if drawn { Vec::new() } else { Self::cameras(recipe, catalog, map)? };
            let asks = recipe.overlapping && recipe.cameras_per_scene > 1 && !drawn;
            let places = asks.then(|| catalog.places_seen(map, &sites)).transpose()?;
            let rig = RigPlaces::new(recipe, map, &sites, catalog)?;
            Ok(MapSites { map: map.clone(), sites, places, rig })
        };
        let maps: Vec<MapSites> = recipe.maps.iter().map(sites_of).collect::<Result<_, PlanError>>()?;
        let combinations = Combinations::new(recipe, &maps)?;
        let list = if recipe.balance { balanced(&combinations, recipe) } else { shuffled(&combinations, recipe) };
        let scenes = (0..recipe.videos).zip(list).map(|(video, combination)| settings(combination, video, recipe));
        let mut scenes: Vec<SceneSettings> = scenes.collect();
        if recipe.sites == PerVideo::Drawn {
            drawn_sites::draw(&mut scenes, recipe, catalog)?;
        } else {
            for map in &recipe.maps {
                let mut of_map: Vec<&mut SceneSettings> = scenes.iter_mut().filter(|scene| scene.map == *map).collect();
                moved_camera::move_cameras(&mut of_map, map, catalog)?;
            }
        }
        Ok(Self { scenes, maps: recipe.maps.clone() })
    }

    /// All cameras with which a recipe may film a map: its own, or those of the map.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    pub fn cameras(
        recipe: &Recipe,
        catalog: &(impl MapCatalog + ?Sized),
        map: &str,
    ) -> Result<Vec<CameraSite>, SimulatorError> {
        recipe.cameras.get(map).map_or_else(|| catalog.cameras(map), |own| Ok(own.clone()))
    }

    /// All cameras that stand still in any video that shares the town of a scene: those with which a recipe may film its map,
    /// or those that were drawn for it, and those of the rig.
    ///
    /// # Errors
    /// When there is no such map or it cannot be made.
    pub fn all_cameras(
        &self,
        recipe: &Recipe,
        catalog: &(impl MapCatalog + ?Sized),
        scene: &SceneSettings,
    ) -> Result<Vec<CameraSite>, SimulatorError> {
        let map = &scene.map;
        let mut cameras = match recipe.sites {
            PerVideo::Fixed => Self::cameras(recipe, catalog, map)?,
            PerVideo::Drawn => scene.cameras.iter().map(|camera| camera.site.clone()).collect(),
        };
        // The rig's are the same in all videos.
        let video = self.scenes.iter().find(|other| other.map == *map);
        let sensors = video.into_iter().flat_map(|scene| &scene.sensors);
        cameras.extend(sensors.filter_map(|sensor| Some(sensor.fixed_camera()?.site)));
        Ok(cameras)
    }

    /// Numbers of the videos in the order of work: by map, so that each is loaded once, and by cameras, so that what bakes
    /// of the same camera share is needed soon again.
    pub fn work_order(&self) -> Vec<u32> {
        let mut order: Vec<&SceneSettings> = self.scenes.iter().collect();
        let cameras = |s: &SceneSettings| s.cameras.iter().map(|c| c.site.name.clone()).collect::<Vec<_>>();
        order.sort_by_cached_key(|s| (self.maps.iter().position(|m| *m == s.map), cameras(s)));
        order.into_iter().map(|s| s.video).collect()
    }

    /// The work order in so many contiguous parts, one a [`Shard`]. The largest cost of a part is as small as can be, and as few
    /// maps are divided as that allows. Parts are empty where there are more than videos, and where they would save no time.
    ///
    /// It is decided by the plan alone, so processes that know nothing of one another agree.
    pub fn shards(&self, of: u32) -> Vec<Vec<u32>> {
        let order = self.work_order();
        let scene = |video: &u32| &self.scenes[*video as usize];
        let costs = |videos: &[u32]| videos.iter().map(|video| cost::cost(&self.scenes[*video as usize])).collect();
        let groups: Vec<Vec<u64>> = order.chunk_by(|a, b| scene(a).shares_town(scene(b))).map(costs).collect();
        let parts = Costs::new(&groups, cost::MAP_PIXELS).cut(of.clamp(1, Shard::MAX) as usize);
        parts.into_iter().map(|part| order[part].to_vec()).collect()
    }

    /// The videos of one part, or of all, in the order of work.
    pub fn part(&self, shard: Option<Shard>) -> Vec<u32> {
        match shard {
            Some(shard) => self.shards(shard.of()).swap_remove(shard.number() as usize - 1),
            None => self.work_order(),
        }
    }

    /// The plan of a dataset that is there.
    ///
    /// # Errors
    /// When its `dataset.json` or a scene of it cannot be read.
    pub fn read(layout: &DatasetLayout) -> Result<Self, DatasetError> {
        let recipe = Manifest::read(&layout.manifest())?.recipe;
        let scenes = (0..recipe.videos).map(|video| read_json(&layout.scene(video))).collect::<Result<_, _>>()?;
        Ok(Self { scenes, maps: recipe.maps })
    }
}

/// All combinations in a random order, then in another, and so on.
fn shuffled<'a>(
    combinations: &'a Combinations<'a>,
    recipe: &'a Recipe,
) -> Box<dyn Iterator<Item = Combination<'a>> + 'a> {
    let random = |round| Stream::named(recipe.seed, "plan", &[round]);
    let numbers = (0..).flat_map(move |round| combination::shuffled(combinations.count(), random(round)));
    Box::new(numbers.map(|number| combinations.get(number)))
}

/// Values in balance; each map goes through its sets of cameras in a random order, then in another, and so on.
fn balanced<'a>(
    combinations: &'a Combinations<'a>,
    recipe: &'a Recipe,
) -> Box<dyn Iterator<Item = Combination<'a>> + 'a> {
    let sets_of = |map: usize| {
        let random = move |round| Stream::named(recipe.seed, "balanced cameras", &[map as u64, round]);
        (0..).flat_map(move |round| SparseShuffle::new(combinations.camera_sets(map), random(round)))
    };
    let mut sets: Vec<_> = (0..recipe.maps.len()).map(sets_of).collect();
    let places = Balanced::new([recipe.maps.len(), recipe.weathers.len(), recipe.times.len()], recipe.seed);
    Box::new(places.map(move |places| {
        let set = sets[places.map].next().expect("rounds follow each other without end");
        combinations.of(places, set)
    }))
}

/// The kind of event that is a video's turn.
fn events(recipe: &Recipe, video: u32) -> Vec<IncidentKind> {
    let kinds = &recipe.events;
    kinds.iter().copied().skip(video as usize % kinds.len().max(1)).take(1).collect()
}

/// Shares of heavy vehicles: from that of a street of shops to that of a road to the docks.
const HEAVY_VEHICLES: [f64; 2] = [0.03, 0.35];
/// Shares of bicycles among two-wheelers: from those of a city of motorcycles to that of a city of cyclists.
const BICYCLES: [f64; 2] = [0.1, 0.9];

/// A share in traffic: what is asked for, or one of the video's own where its region is drawn, small ones as often as large
/// ones.
fn drawn_share(recipe: &Recipe, video: u32, asked: Option<f64>, name: &str, shares: [f64; 2]) -> Option<f64> {
    let drawn = recipe.region == RegionChoice::Drawn;
    let [least, most] = shares.map(ln);
    let draw = || exp(Stream::named(recipe.seed, name, &[u64::from(video)]).range_f64(least, most));
    asked.or_else(|| drawn.then(draw))
}

/// Clothes for what is asked for; where the region is drawn, some videos are of the cold season that it has.
fn clothing(recipe: &Recipe, video: u32, region: Region) -> Clothing {
    const COLD: f64 = 0.4;
    let drawn = recipe.region == RegionChoice::Drawn && recipe.clothing == Clothing::Region;
    let has_winter = recipe.clothing.outfit(region) == Outfit::Fair;
    let cold = drawn && has_winter && Stream::named(recipe.seed, "clothing", &[u64::from(video)]).chance(COLD);
    if cold { Clothing::Cold } else { recipe.clothing }
}

/// The settings of a video that films a combination.
fn settings(combination: Combination<'_>, video: u32, recipe: &Recipe) -> SceneSettings {
    let Combination { map, weather, time_of_day, sites, rig } = combination;
    let seed = Stream::named(recipe.seed, "scene", &[u64::from(video)]).next_u64();
    let region = recipe.region.region(&mut Stream::named(recipe.seed, "region", &[u64::from(video)]));
    let strength = recipe.randomise_strength as f32;
    let randomised = SceneRandomisation::new(&recipe.randomise, strength, time_of_day, seed);
    let town_seed = (recipe.town_seed == PerVideo::Drawn)
        .then(|| Stream::named(recipe.seed, "town seed", &[u64::from(video)]).next_u64());
    let scene = SceneSettings {
        video,
        map: map.to_owned(),
        town_seed,
        drawn_sites: recipe.sites == PerVideo::Drawn,
        weather,
        time_of_day,
        sun_elevation_deg: drawn_sun::elevation_deg(recipe, video, time_of_day),
        changing_to: changing::to(recipe, video, weather, time_of_day),
        cameras: Vec::new(),
        sensors: Vec::new(),
        vehicles: recipe.vehicles,
        pedestrians: recipe.pedestrians,
        density: recipe.density,
        focus: recipe.focus,
        profile: TrafficProfile {
            region,
            two_wheelers: recipe.two_wheelers,
            bicycles: drawn_share(recipe, video, recipe.bicycles, "bicycles", BICYCLES),
            heavy_vehicles: drawn_share(recipe, video, recipe.heavy_vehicles, "heavy vehicles", HEAVY_VEHICLES),
            clothing: clothing(recipe, video, region),
            aggressiveness: recipe.aggressiveness,
            parked: recipe.parked,
            signals: recipe.signals,
        },
        jaywalking: recipe.jaywalking,
        groups: recipe.groups,
        events: events(recipe, video),
        size: recipe.size,
        fps: recipe.fps,
        frames: recipe.frames(),
        seed,
        randomised,
        // Those who play tracks look the same in all videos.
        playback: recipe.traffic_file.as_ref().map(|_| TrackPlayback {
            begin_s: recipe.traffic_begin.unwrap_or(0.0),
            offset_m: recipe.traffic_offset,
            seed: recipe.seed,
        }),
    };
    // Their looks and their clock follow from the rest.
    let cameras = sites.into_iter().cloned().zip(0..).map(|numbered| scene_camera(recipe, &scene, numbered)).collect();
    let sensors = scene_sensors(recipe, rig, video, time_of_day, recorder_clock(recipe, &scene));
    SceneSettings { cameras, sensors, ..scene }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::RecipeDraft;
    use endless_world::{SceneCamera, TimeOfDay, Weather};
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    #[test]
    fn kinds_of_events_come_in_turn() {
        let draft = RecipeDraft {
            videos: Some(5),
            events: Some(vec!["stalled".into(), "near_miss".into()]),
            ..Default::default()
        };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        let kinds = (0..5).map(|video| events(&recipe, video));
        let [miss, stalled] = [IncidentKind::NearMiss, IncidentKind::Stalled];
        assert_eq!(kinds.collect::<Vec<_>>(), [[miss], [stalled], [miss], [stalled], [miss]]);
        assert!(events(&Recipe { events: Vec::new(), ..recipe }, 3).is_empty());
    }

    fn recipe(videos: u32, cameras: u32, seed: u64, [maps, weathers, times]: [usize; 3]) -> Recipe {
        let take = |names: Vec<&str>, n: usize| Some(names.into_iter().take(n).map(str::to_owned).collect());
        let draft = RecipeDraft {
            videos: Some(i64::from(videos)),
            cameras_per_scene: Some(i64::from(cameras)),
            seed: Some(seed),
            maps: take(vec!["Town01", "Town02", "Town03"], maps),
            weathers: take(Weather::ALL.iter().map(|w| w.name()).collect(), weathers),
            times: take(TimeOfDay::ALL.iter().map(|t| t.name()).collect(), times),
            ..Default::default()
        };
        resolve_recipe(draft, &ThreeTowns).expect("valid")
    }

    fn balanced(videos: u32, cameras: u32, seed: u64, lists: [usize; 3]) -> Vec<SceneSettings> {
        let recipe = Recipe { balance: true, ..recipe(videos, cameras, seed, lists) };
        Plan::new(&recipe, &ThreeTowns).expect("plannable").scenes
    }

    /// Whether counts of what comes differ by at most one after every video.
    fn even(keys: impl Iterator<Item = String>, values: usize) -> bool {
        let mut counts = BTreeMap::new();
        let mut all_even = true;
        for key in keys {
            *counts.entry(key).or_insert(0u32) += 1;
            let least = if counts.len() < values { 0 } else { *counts.values().min().expect("one") };
            all_even &= counts.values().all(|count| *count <= least + 1);
        }
        all_even && counts.len() <= values
    }

    fn key(s: &SceneSettings) -> String {
        let cameras: Vec<&str> = s.cameras.iter().map(|c| c.site.name.as_str()).collect();
        format!("{} {} {} {}", s.map, s.weather, s.time_of_day, cameras.join("+"))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn every_combination_appears_in_proportion(
            n in 1u32..400, cameras in 1u32..4, seed: u64, maps in 1usize..4, weathers in 1usize..4, times in 1usize..3,
        ) {
            let plan = Plan::new(&recipe(n, cameras, seed, [maps, weathers, times]), &ThreeTowns).expect("plannable");
            // Sets of one, two or three of three, four and five cameras.
            let sets = [[3, 4, 5], [3, 6, 10], [1, 4, 10]][cameras as usize - 1];
            let k = (sets[..maps].iter().sum::<usize>() * weathers * times) as u32;
            let mut counts = BTreeMap::new();
            for scene in &plan.scenes {
                prop_assert_eq!(scene.cameras.len() as u32, cameras);
                prop_assert!(scene.cameras.is_sorted_by(|a, b| a.site.name < b.site.name), "distinct, in the map's order");
                *counts.entry(key(scene)).or_insert(0u32) += 1;
            }
            prop_assert_eq!(plan.scenes.len() as u32, n);
            prop_assert!(counts.values().all(|c| *c == n / k || *c == n.div_ceil(k)));
            prop_assert_eq!(counts.len() as u32, n.min(k));
        }

        #[test]
        fn a_balanced_plan_has_every_value_equally_often(
            n in 7u32..=300, cameras in 1u32..4, seed: u64, maps in 1usize..4, weathers in 1usize..6, times in 1usize..4,
        ) {
            let scenes = balanced(n, cameras, seed, [maps, weathers, times]);
            prop_assert_eq!(scenes.len() as u32, n);
            prop_assert!(even(scenes.iter().map(|s| s.map.clone()), maps));
            prop_assert!(even(scenes.iter().map(|s| s.weather.to_string()), weathers));
            prop_assert!(even(scenes.iter().map(|s| s.time_of_day.to_string()), times));
            let conditions = |s: &SceneSettings| format!("{} {} {}", s.map, s.weather, s.time_of_day);
            prop_assert!(even(scenes.iter().map(conditions), maps * weathers * times));
            for (map, sets) in ["Town01", "Town02", "Town03"].iter().zip([[3, 3, 1], [4, 6, 4], [5, 10, 10]]) {
                let of_map = scenes.iter().filter(|s| s.map == *map);
                let names = |s: &SceneSettings| s.cameras.iter().map(|c| c.site.name.clone()).collect();
                prop_assert!(even(of_map.map(names), sets[cameras as usize - 1]));
            }
        }

        #[test]
        fn a_longer_balanced_list_begins_with_the_shorter(
            short in 1u32..200, more in 0u32..200, cameras in 1u32..4, seed: u64,
        ) {
            let plan = |n| balanced(n, cameras, seed, [3, 4, 2]);
            prop_assert_eq!(&plan(short)[..], &plan(short + more)[..short as usize]);
        }

        #[test]
        fn a_longer_list_begins_with_the_shorter(
            short in 1u32..200, more in 0u32..200, cameras in 1u32..4, seed: u64,
        ) {
            let plan = |n| Plan::new(&recipe(n, cameras, seed, [2, 2, 2]), &ThreeTowns).expect("plannable").scenes;
            prop_assert_eq!(&plan(short)[..], &plan(short + more)[..short as usize]);
        }

        #[test]
        fn the_work_order_names_every_video_once_and_every_map_once(n in 1u32..300, seed: u64) {
            let plan = Plan::new(&recipe(n, 2, seed, [3, 3, 2]), &ThreeTowns).expect("plannable");
            let mut order = plan.work_order();
            let mut maps: Vec<&str> = order.iter().map(|v| plan.scenes[*v as usize].map.as_str()).collect();
            maps.dedup();
            prop_assert!(maps.len() <= 3);
            order.sort_unstable();
            prop_assert_eq!(order, (0..n).collect::<Vec<_>>());
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        #[test]
        fn every_video_is_in_one_shard_in_the_order_of_work(n in 1u32..300, of in 1u32..40, seed: u64, balance: bool) {
            let recipe = Recipe { balance, ..recipe(n, 2, seed, [3, 3, 2]) };
            let plan = Plan::new(&recipe, &ThreeTowns).expect("plannable");
            let shards = plan.shards(of);
            prop_assert_eq!(shards.len(), of as usize);
            prop_assert_eq!(shards.concat(), plan.work_order());
            for shard in Shard::all(of) {
                prop_assert_eq!(&plan.part(Some(shard)), &shards[shard.number() as usize - 1]);
            }
            prop_assert_eq!(plan.part(None), plan.work_order());
        }
    }

    #[test]
    fn the_seed_decides() {
        let scenes = |seed| Plan::new(&recipe(50, 2, seed, [3, 3, 3]), &ThreeTowns).expect("plannable").scenes;
        assert_eq!(scenes(1), scenes(1));
        assert_ne!(scenes(1), scenes(2));
        let seeds: std::collections::BTreeSet<u64> = scenes(1).iter().map(|s| s.seed).collect();
        assert_eq!(seeds.len(), 50, "every scene has its own seed");
        let scenes = |seed| balanced(50, 2, seed, [3, 3, 3]);
        assert_eq!(scenes(1), scenes(1));
        assert_ne!(scenes(1), scenes(2));
    }

    /// All pairs laid out by loops and shuffled, round after round.
    fn pairs(recipe: &Recipe) -> Vec<String> {
        let mut all = Vec::new();
        for map in &recipe.maps {
            let sites = ThreeTowns.cameras(map).expect("a map");
            for weather in &recipe.weathers {
                for time in &recipe.times {
                    for (i, a) in sites.iter().enumerate() {
                        for b in &sites[i + 1..] {
                            all.push(format!("{map} {weather} {time} {}+{}", a.name, b.name));
                        }
                    }
                }
            }
        }
        let mut planned = Vec::new();
        for round in 0.. {
            if planned.len() >= recipe.videos as usize {
                break;
            }
            let mut order = all.clone();
            Stream::named(recipe.seed, "plan", &[round]).shuffle(&mut order);
            planned.extend(order);
        }
        planned.truncate(recipe.videos as usize);
        planned
    }

    #[test]
    fn pairs_are_planned_as_the_plain_product_says() {
        for (videos, seed) in [(1, 0), (40, 7), (700, u64::MAX)] {
            let recipe = recipe(videos, 2, seed, [3, 5, 3]);
            let plan = Plan::new(&recipe, &ThreeTowns).expect("plannable");
            assert_eq!(plan.scenes.iter().map(key).collect::<Vec<_>>(), pairs(&recipe));
        }
    }

    /// The towns, whose cameras stand in a row: each sees what the next one sees, too.
    struct InARow;

    impl MapCatalog for InARow {
        fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
            ThreeTowns.cameras(map)
        }

        fn places_seen(&self, _map: &str, sites: &[CameraSite]) -> Result<Vec<Vec<u32>>, SimulatorError> {
            Ok((0..sites.len() as u32).map(|i| (10 * i..10 * i + 15).collect()).collect())
        }
    }

    #[test]
    fn overlapping_cameras_stand_beside_each_other() {
        for (balance, cameras) in [(false, 2), (true, 2), (false, 3)] {
            let plain = Recipe { balance, ..recipe(200, cameras, 5, [3, 2, 2]) };
            let overlapping = Recipe { overlapping: true, ..plain.clone() };
            // Where nobody knows what cameras see, all are as good.
            let scenes = |recipe, catalog: &dyn MapCatalog| Plan::new(recipe, catalog).expect("plannable").scenes;
            assert_eq!(scenes(&overlapping, &ThreeTowns), scenes(&plain, &ThreeTowns));
            let places = |scene: &SceneSettings| {
                let number = |camera: &SceneCamera| camera.site.position[0] as u32;
                scene.cameras.iter().map(number).collect::<Vec<_>>()
            };
            let sets: Vec<Vec<u32>> = scenes(&overlapping, &InARow).iter().map(places).collect();
            assert!(sets.iter().all(|set| set.windows(2).all(|pair| pair[1] == pair[0] + 1)));
            assert!((0..3).all(|first| sets.iter().any(|set| set[0] == first)), "not always the same set");
        }
    }

    #[test]
    fn a_map_with_too_few_cameras_is_named() {
        let error = Plan::new(&recipe(1, 4, 0, [3, 1, 1]), &ThreeTowns).expect_err("Town01 has three").to_string();
        assert_eq!(
            error,
            "map Town01 has 3 camera sites, a scene is filmed by 4: ask for fewer with --cameras-per-scene, or name \
             maps that have more"
        );
    }
}
