//! `recipes/paper` are the paper's minisets: its Table 2.

use crate::city::city;
use endless_pipeline::{Plan, read_recipe, resolve_recipe};
use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
};

fn recipes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../recipes/paper")
}

/// Videos, frames, most vehicles and most pedestrians of each.
const TABLE_2: [(u32, u64, u32, u32); 6] = [
    (18, 27_632, 30, 20),
    (104, 157_269, 30, 20),
    (30, 44_957, 30, 20),
    (40, 64_050, 100, 60),
    (30, 46_840, 100, 60),
    (22, 38_003, 150, 100),
];
const TOWNS: [&str; 8] = ["Town01", "Town02", "Town03", "Town04", "Town05", "Town06", "Town07", "Town10HD"];

#[test]
fn recipes_are_the_minisets_of_the_paper() {
    let (mut videos, mut frames, mut papers_frames) = (0, 0, 0);
    let mut seeds = BTreeSet::new();
    for (number, (of_table, frames_of_table, vehicles, pedestrians)) in (1..).zip(TABLE_2) {
        let draft = read_recipe(&recipes().join(format!("miniset_{number}.toml"))).expect("a recipe");
        let recipe = resolve_recipe(draft, city()).expect("valid");
        assert_eq!((recipe.videos, recipe.vehicles, recipe.pedestrians), (of_table, vehicles, pedestrians));
        assert_eq!((recipe.size.to_string().as_str(), recipe.fps, recipe.cameras_per_scene), ("1280x720", 30.0, 2));
        assert_eq!(
            (recipe.maps.as_slice(), recipe.weathers.len(), recipe.times.len()),
            (&TOWNS.map(String::from)[..], 5, 3)
        );
        let plan = Plan::new(&recipe, city()).expect("a plan");
        let planned: u64 = plan.scenes.iter().map(|scene| scene.cameras.len() as u64 * u64::from(scene.frames)).sum();
        // Videos are whole and equally long: no other length is nearer.
        let a_frame_more = 2 * u64::from(recipe.videos);
        assert!(2 * planned.abs_diff(frames_of_table) <= a_frame_more, "{number}: {planned} for {frames_of_table}");
        videos += recipe.videos;
        frames += planned;
        papers_frames += frames_of_table;
        seeds.insert(recipe.seed);
    }
    assert_eq!((videos, papers_frames, seeds.len()), (244, 378_751, 6));
    assert_eq!(frames, 378_792);
}
