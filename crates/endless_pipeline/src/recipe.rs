//! Resolves the options of a user to a recipe.

use crate::{MapSource, RecipeError, TrackFileSummary, rig, text_position::line_and_column, user_camera};
use endless_dataset::{Layer, OptionError, Preset, Recipe, RecipeDraft};
use endless_world::{ActorDensity, Stream, TrafficDensity};
use serde_json::json;
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

/// File names have six digits.
const MAX_FRAMES: f64 = 999_999.0;

/// Reads a TOML recipe.
///
/// # Errors
/// When it cannot be read or is not a recipe.
pub fn read_recipe(path: &Path) -> Result<RecipeDraft, RecipeError> {
    let unreadable = |cause| RecipeError::Unreadable { what: "recipe", path: path.to_owned(), cause };
    let text = fs::read_to_string(path).map_err(unreadable)?;
    recipe_from_text(&text, path)
}

/// Reads the text of the TOML recipe at a path.
///
/// # Errors
/// When it is not a recipe.
pub fn recipe_from_text(text: &str, path: &Path) -> Result<RecipeDraft, RecipeError> {
    let mut draft: RecipeDraft = toml::from_str(text).map_err(|e: toml::de::Error| {
        let (line, column) = line_and_column(text, e.span().map_or(0, |s| s.start));
        RecipeError::Malformed {
            path: path.to_owned(),
            line,
            column,
            message: e.message().lines().collect::<Vec<_>>().join(", "),
        }
    })?;
    if let Some(folder) = path.parent() {
        for file in [&mut draft.assets, &mut draft.traffic].into_iter().flatten() {
            *file = folder.join(&*file);
        }
    }
    Ok(draft)
}

/// Completes a draft with the defaults and validates it. Models come from the catalogue, which has read their folder.
///
/// # Errors
/// The first thing that cannot be.
pub fn resolve_recipe(draft: RecipeDraft, source: &dyn MapSource) -> Result<Recipe, RecipeError> {
    let tracks = source.track_file();
    let mut draft = with_preset(played(draft, tracks.as_ref())?)?;
    let density = density(&mut draft)?;
    let mut draft = draft.or(RecipeDraft::defaults());
    draft.check()?;
    let maps = maps(draft.maps.take(), draft.seed.unwrap_or_default(), source)?;
    if tracks.is_some() && maps.len() != 1 {
        return Err(RecipeError::TracksOnMaps);
    }
    let mut map_files = BTreeMap::new();
    for map in &maps {
        if let Some(hash) = source.content_hash(map)? {
            map_files.insert(map.clone(), hash);
        }
    }
    if let Some(line) = draft.counting_lines.iter().flatten().find(|line| !maps.contains(&line.map)) {
        return Err(RecipeError::UnknownMap { given: line.map.clone(), known: maps });
    }
    let cameras = user_camera::resolve(&draft.cameras.take().unwrap_or_default(), &maps, source)?;
    draft.mp4 = Some(mp4(draft.mp4, draft.layers.as_deref().unwrap_or_default())?);
    // The content of the models counts, not where they lie.
    draft.assets = None;
    draft.traffic = None;
    // Most options are the recipe's fields of their names; those that depend on something else are put in here.
    let mut fields = serde_json::to_value(&draft).expect("numbers and words");
    fields["maps"] = json!(maps);
    fields["map_files"] = json!(map_files);
    fields["asset_files"] = json!(source.asset_files());
    fields["cameras"] = json!(cameras);
    fields["density"] = json!(density);
    fields["traffic_file"] = json!(tracks.map(|tracks| tracks.content_hash));
    let mut recipe: Recipe = serde_json::from_value(fields).expect("every field has a default or was put in");
    let frames = (recipe.fps * recipe.duration).round();
    if !(1.0..=MAX_FRAMES).contains(&frames) {
        return Err(OptionError::OutOfRange {
            field: "duration",
            given: recipe.duration.to_string(),
            rule: format!("at {} fps this is {frames} frames, a video has 1 to {MAX_FRAMES}", recipe.fps),
        }
        .into());
    }
    if recipe.cameras_per_scene == 0 && recipe.sensor.is_empty() {
        return Err(OptionError::OutOfRange {
            field: "cameras_per_scene",
            given: "0".to_owned(),
            rule: "a scene without sensors of a rig has 1 to 8 cameras".to_owned(),
        }
        .into());
    }
    recipe.sensor = rig::resolve(&recipe)?;
    source.accepts(&recipe)?;
    Ok(recipe)
}

/// A draft with what follows from the file of tracks that is played, if one is: when it begins, and that nobody is
/// simulated of the kinds that it has.
fn played(mut draft: RecipeDraft, tracks: Option<&TrackFileSummary>) -> Result<RecipeDraft, RecipeError> {
    let Some(tracks) = tracks else {
        let without = |field, given: bool| if given { Err(RecipeError::NoTracks { field }) } else { Ok(()) };
        without("traffic-offset", draft.traffic_offset.is_some())?;
        without("traffic-begin", draft.traffic_begin.is_some())?;
        return Ok(draft);
    };
    let begin = *draft.traffic_begin.get_or_insert(tracks.begin_s);
    let duration = draft.duration.unwrap_or(0.0).max(0.0);
    if begin > tracks.end_s || begin + duration < tracks.begin_s {
        return Err(OptionError::OutOfRange {
            field: "traffic_begin",
            given: begin.to_string(),
            rule: format!("the file goes from {} s to {} s, write a time between these", tracks.begin_s, tracks.end_s),
        }
        .into());
    }
    if tracks.vehicles {
        draft.vehicles.get_or_insert(0);
    }
    if tracks.people {
        draft.pedestrians.get_or_insert(0);
    }
    Ok(draft)
}

/// A draft with the values of its preset, if it names one, for what it does not give.
fn with_preset(mut draft: RecipeDraft) -> Result<RecipeDraft, RecipeError> {
    let Some(word) = draft.preset.take() else { return Ok(draft) };
    let preset: Preset = word.trim().parse().map_err(OptionError::from)?;
    let mut usual = recipe_from_text(preset.recipe(), Path::new(<&str>::from(preset)))?;
    if draft.density.is_some() {
        (usual.vehicles, usual.pedestrians) = (None, None);
    }
    Ok(draft.or(usual))
}

/// What follows from how busy the streets are: numbers that are not given, which are 0 in the recipe then.
fn density(draft: &mut RecipeDraft) -> Result<ActorDensity, RecipeError> {
    let Some(word) = draft.density.take() else { return Ok(ActorDensity::default()) };
    let density: TrafficDensity = word.trim().parse().map_err(OptionError::from)?;
    let unless_given = |number: &mut Option<i64>| {
        let follows = number.is_none().then_some(density);
        number.get_or_insert(0);
        follows
    };
    Ok(ActorDensity { vehicles: unless_given(&mut draft.vehicles), pedestrians: unless_given(&mut draft.pedestrians) })
}

/// Numbers of random maps are below this.
const RANDOM_MAPS: usize = 1_000_000;
/// Most random maps of a recipe.
const MOST_RANDOM_MAPS: usize = 100_000;

/// As many random maps as `random:N` asks for, by the recipe's seed: the first of a longer list are those of a shorter one.
/// `None` of any other word.
fn random_maps(word: &str, seed: u64, source: &dyn MapSource) -> Option<Result<Vec<String>, RecipeError>> {
    let count = word.strip_prefix("random:")?;
    let wrong = || OptionError::OutOfRange {
        field: "maps",
        given: word.to_owned(),
        rule: format!("random:N grows 1 to {MOST_RANDOM_MAPS} maps, with a simulator that has random maps"),
    };
    let count = count.parse::<usize>().ok().filter(|count| (1..=MOST_RANDOM_MAPS).contains(count));
    let mut names = Vec::new();
    let mut random = Stream::named(seed, "random maps", &[]);
    let mut taken = BTreeSet::new();
    while names.len() < count.unwrap_or(0) {
        let number = random.below(RANDOM_MAPS) as u32;
        if taken.insert(number) {
            let Some(name) = source.random_map(number) else { break };
            names.push(name);
        }
    }
    Some(if names.is_empty() { Err(wrong().into()) } else { Ok(names) })
}

/// CARLA's layered maps (`Town01_Opt`) are the same towns.
fn maps(given: Option<Vec<String>>, seed: u64, source: &dyn MapSource) -> Result<Vec<String>, RecipeError> {
    let Some(given) = given else { return Ok(source.maps()) };
    let known: Vec<String> = source.maps().into_iter().chain(source.imported()).collect();
    if given.is_empty() {
        return Err(OptionError::EmptyList { field: "maps", known }.into());
    }
    let mut chosen = Vec::new();
    let mut random = Vec::new();
    for word in &given {
        let exact = word.trim();
        if let Some(names) = random_maps(exact, seed, source) {
            random.extend(names?);
            continue;
        }
        if is_random(exact, source) && !known.iter().any(|k| k == exact) {
            random.push(exact.to_owned());
            continue;
        }
        let plain = exact.strip_suffix("_Opt").unwrap_or(exact);
        let name = if known.iter().any(|k| k == exact) { exact } else { plain };
        if !known.iter().any(|k| k == name) {
            return Err(RecipeError::UnknownMap { given: word.clone(), known });
        }
        chosen.push(name);
    }
    let mut maps: Vec<String> = known.iter().filter(|k| chosen.contains(&k.as_str())).cloned().collect();
    for name in random {
        if !maps.contains(&name) {
            maps.push(name);
        }
    }
    Ok(maps)
}

/// Whether it is the name of a random map.
fn is_random(name: &str, source: &dyn MapSource) -> bool {
    let digits = name.trim_start_matches(|c: char| !c.is_ascii_digit());
    digits.parse().ok().and_then(|number| source.random_map(number)).is_some_and(|random| random == name)
}

/// Videos are made of layers that are stored.
fn mp4(given: Option<Vec<String>>, layers: &[String]) -> Result<Vec<String>, RecipeError> {
    let Some(given) = given else {
        return Ok(layers.iter().filter(|layer| *layer == Layer::Rgb.name()).cloned().collect());
    };
    match given.iter().find(|layer| !layers.contains(layer)) {
        Some(layer) => {
            let layer = layer.parse().map_err(OptionError::from)?;
            Err(RecipeError::VideoWithoutLayer { layer })
        }
        None => Ok(given),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_catalog::ThreeTowns;
    use endless_dataset::RgbFormat;
    use endless_world::{PerVideo, Weather};

    #[test]
    fn defaults_are_the_contract_s() {
        let recipe = resolve_recipe(RecipeDraft::default(), &ThreeTowns).expect("defaults are valid");
        assert_eq!((recipe.videos, recipe.cameras_per_scene, recipe.vehicles, recipe.pedestrians), (2, 2, 30, 20));
        assert_eq!((recipe.size.to_string().as_str(), recipe.fps, recipe.duration), ("1280x720", 30.0, 5.0));
        assert_eq!((recipe.frames(), recipe.seed, recipe.min_pixels), (150, 0, 50));
        assert_eq!(recipe.layers, Layer::DEFAULT);
        assert_eq!((recipe.rgb_format, recipe.mp4.as_slice()), (RgbFormat::Png, &[Layer::Rgb][..]));
        assert_eq!(recipe.maps.len(), 3);
    }

    #[test]
    fn random_maps_are_grown_by_the_seed_and_named_by_their_numbers() {
        let maps = |words: &[&str], seed| {
            let maps = Some(words.iter().map(ToString::to_string).collect());
            let draft = RecipeDraft { maps, seed: Some(seed), ..RecipeDraft::default() };
            resolve_recipe(draft, &ThreeTowns).map(|recipe| recipe.maps)
        };
        let three = maps(&["random:3"], 1).expect("grown");
        let five = maps(&["Town02", "random:5"], 1).expect("grown");
        assert_eq!((three.len(), five.len(), five[0].as_str()), (3, 6, "Town02"));
        assert_eq!(three, five[1..4]);
        assert_ne!(three, maps(&["random:3"], 2).expect("grown"));
        assert_eq!(maps(&["Random7", "Random7"], 1).expect("grown"), ["Random7"]);
        for wrong in ["random:0", "random:many", "random:", "Random07", "Atlantis"] {
            assert!(maps(&[wrong], 1).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_preset_fills_what_is_not_given() {
        for preset in Preset::ALL {
            let draft = RecipeDraft {
                preset: Some(preset.to_string()),
                maps: Some(vec!["Town01".into()]),
                ..RecipeDraft::default()
            };
            let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
            assert_eq!((recipe.sites, recipe.town_seed), (PerVideo::Drawn, PerVideo::Drawn), "{preset}");
            assert_eq!(recipe.maps, ["Town01"]);
            assert_eq!(recipe.sun.is_fixed(), *preset == Preset::Night, "{preset}");
        }
        let crowd = |density: Option<&str>| {
            let (preset, density) = (Some("crowd".to_owned()), density.map(str::to_owned));
            let draft = RecipeDraft {
                preset,
                density,
                sites: Some("fixed".into()),
                maps: Some(vec!["Town01".into()]),
                ..RecipeDraft::default()
            };
            resolve_recipe(draft, &ThreeTowns).expect("valid")
        };
        assert_eq!((crowd(None).pedestrians, crowd(None).sites), (400, PerVideo::Fixed));
        assert_eq!(crowd(Some("light")).density.pedestrians, Some(TrafficDensity::Light));
        let unknown = RecipeDraft { preset: Some("beach".into()), ..RecipeDraft::default() };
        let error = resolve_recipe(unknown, &ThreeTowns).expect_err("no such preset").to_string();
        assert!(error.contains("beach") && error.contains("surveillance"), "{error}");
    }

    #[test]
    fn the_order_of_words_does_not_matter() {
        let words = |list: &[&str]| Some(list.iter().map(|w| (*w).to_owned()).collect());
        let draft = RecipeDraft {
            maps: words(&["Town03", "Town01_Opt", "Town01"]),
            layers: words(&["instance", "rgb", "rgb"]),
            ..Default::default()
        };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        assert_eq!(recipe.maps, ["Town01", "Town03"]);
        assert_eq!(recipe.layers, [Layer::Rgb, Layer::Instance]);
    }

    #[test]
    fn flags_win_over_the_file() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("recipe.toml");
        fs::write(&path, "videos = 7\nfps = 10\nsize = \"64x48\"\nweathers = [\"rainy\"]\n").expect("writable");
        let file = read_recipe(&path).expect("a recipe");
        let flags = RecipeDraft { videos: Some(3), ..Default::default() };
        let recipe = resolve_recipe(flags.or(file), &ThreeTowns).expect("valid");
        assert_eq!((recipe.videos, recipe.fps, recipe.weathers.as_slice()), (3, 10.0, &[Weather::Rainy][..]));
        fs::write(&path, "videos = 7\nvideoes = 8\n").expect("writable");
        let error = read_recipe(&path).expect_err("a misspelt key").to_string();
        assert!(error.contains("recipe.toml:2:1: unknown field `videoes`"), "{error}");
        assert_eq!(error.lines().count(), 1);
    }

    #[test]
    fn plain_numbers_win_over_how_busy_the_streets_are() {
        let recipe = |density: &str, vehicles, pedestrians| {
            let draft = RecipeDraft { density: Some(density.to_owned()), vehicles, pedestrians, ..Default::default() };
            resolve_recipe(draft, &ThreeTowns)
        };
        let rush = Some(TrafficDensity::Rush);
        let all = recipe("rush", None, None).expect("valid");
        assert_eq!((all.vehicles, all.pedestrians), (0, 0));
        assert_eq!(all.density, ActorDensity { vehicles: rush, pedestrians: rush });
        let people = recipe("rush", Some(7), None).expect("valid");
        assert_eq!((people.vehicles, people.pedestrians), (7, 0));
        assert_eq!(people.density, ActorDensity { vehicles: None, pedestrians: rush });
        let none = recipe("rush", Some(0), Some(3)).expect("valid");
        assert_eq!((none.vehicles, none.pedestrians, none.density), (0, 3, ActorDensity::default()));
        let error = recipe("jam", None, None).expect_err("no such word").to_string();
        assert_eq!(error, "unknown traffic density 'jam': use one of light, normal, rush");
        // It is told of in a dataset, and a dataset that does not tell has plain numbers.
        let told = serde_json::to_value(&people).expect("numbers and words");
        assert_eq!(told["density"], json!({"pedestrians": "rush"}));
        let mut plain = serde_json::to_value(&none).expect("numbers and words");
        assert_eq!(plain.get("density"), None);
        plain.as_object_mut().expect("a table").remove("focus");
        let old: Recipe = serde_json::from_value(plain).expect("an old recipe");
        assert_eq!(old, none);
    }

    #[test]
    fn focus_is_a_share() {
        let recipe = |focus| resolve_recipe(RecipeDraft { focus: Some(focus), ..Default::default() }, &ThreeTowns);
        assert_eq!(recipe(0.0).expect("valid").focus, 0.0);
        let error = recipe(1.5).expect_err("more than all").to_string();
        assert_eq!(error, "focus cannot be 1.5: write a number from 0 to 1");
    }

    #[test]
    fn a_frame_count_is_rounded() {
        let draft = RecipeDraft { fps: Some(29.97), duration: Some(2.0), ..Default::default() };
        assert_eq!(resolve_recipe(draft, &ThreeTowns).expect("valid").frames(), 60);
        let none = RecipeDraft { fps: Some(1.0), duration: Some(0.1), ..Default::default() };
        assert!(resolve_recipe(none, &ThreeTowns).is_err());
    }

    /// The file that a dataset's card gives makes the same recipe.
    #[test]
    fn a_recipe_comes_again_from_its_card() {
        let comes_again = |draft: RecipeDraft| {
            let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
            let text = endless_dataset::recipe_toml(&recipe);
            let again = recipe_from_text(&text, Path::new("recipe.toml")).expect(&text);
            assert_eq!(resolve_recipe(again, &ThreeTowns).expect("valid"), recipe, "{text}");
            text
        };
        comes_again(RecipeDraft::default());
        for (density, vehicles) in [("rush", None), ("light", Some(7))] {
            comes_again(RecipeDraft { density: Some(density.to_owned()), vehicles, ..Default::default() });
        }
        comes_again(RecipeDraft { camera_look: Some("clean".to_owned()), mp4: Some(Vec::new()), ..Default::default() });
        let large = comes_again_but_for_its_seed(u64::MAX);
        assert!(large.starts_with("# No number of TOML: --seed 18446744073709551615\n"), "{large}");
        let cameras = "[[cameras]]\nmap = \"Town01\"\nname = \"gate\"\nposition = [1.1, -2.5, 6]\nyaw = 91.7\ndown = 20.3\n\n\
                       [[cameras]]\nmap = \"Town03\"\nname = \"dome\"\nposition = [9, 2.5, 7]\nyaw = -180.0\ndown = 90\n\
                       lens = \"fisheye\"\n\n[[counting_lines]]\nmap = \"Town01\"\nname = \"x\"\nfrom = [0, 1]\nto = [2, 3.5]\n";
        comes_again(recipe_from_text(cameras, Path::new("recipe.toml")).expect("a recipe"));
        let rig = include_str!("../../../rigs/every_sensor.toml");
        comes_again(RecipeDraft { videos: Some(3), ..recipe_from_text(rig, Path::new("rig.toml")).expect("a rig") });
    }

    fn comes_again_but_for_its_seed(seed: u64) -> String {
        let recipe =
            resolve_recipe(RecipeDraft { seed: Some(seed), ..Default::default() }, &ThreeTowns).expect("valid");
        let text = endless_dataset::recipe_toml(&recipe);
        let again = recipe_from_text(&text, Path::new("recipe.toml")).expect("a recipe");
        let again = resolve_recipe(RecipeDraft { seed: Some(seed), ..again }, &ThreeTowns).expect("valid");
        assert_eq!(again, recipe);
        text
    }
}
