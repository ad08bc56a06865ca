//! From what the user wrote to the resolved recipe.

use crate::{MapSource, OwnCamera, RecipeError, camera_list, text_position::line_and_column};
use endless_dataset::{Layer, MAX_CAMERAS, Recipe, RgbFormat};
use endless_world::{ImageSize, LookChoice, TimeOfDay, UnknownName, Weather};
use serde::Deserialize;
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    str::FromStr,
};

/// What the user wrote: any part of a recipe. The same on the command line and in a TOML file.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RecipeDraft {
    /// How many videos.
    pub videos: Option<i64>,
    /// Vehicles in each.
    pub vehicles: Option<i64>,
    /// Pedestrians in each.
    pub pedestrians: Option<i64>,
    /// Maps to choose from.
    pub maps: Option<Vec<String>>,
    /// Cameras that film in place of a map's own.
    pub cameras: Option<Vec<OwnCamera>>,
    /// Cameras that film each scene.
    pub cameras_per_scene: Option<i64>,
    /// Weathers to choose from.
    pub weathers: Option<Vec<String>>,
    /// Times of day to choose from.
    pub times: Option<Vec<String>>,
    /// `WIDTHxHEIGHT`.
    pub size: Option<String>,
    /// Frames a second.
    pub fps: Option<f64>,
    /// Seconds of each video.
    pub duration: Option<f64>,
    /// Seed of everything random.
    pub seed: Option<u64>,
    /// Layers that are stored.
    pub layers: Option<Vec<String>>,
    /// What lens, sensor and recorder do to the RGB layer.
    pub camera_look: Option<String>,
    /// How the RGB layer is stored.
    pub rgb_format: Option<String>,
    /// Objects with fewer visible pixels are not annotated.
    pub min_pixels: Option<i64>,
    /// Layers of which a video file is made.
    pub mp4: Option<Vec<String>>,
    /// What simulates.
    pub simulator: Option<String>,
    /// Folder of models, see `docs/assets.md`; in a file, as seen from the file's folder.
    pub assets: Option<PathBuf>,
    /// Leave out models that cannot be read.
    pub skip_broken: Option<bool>,
}

/// The longest side of an image.
const MAX_SIDE: u32 = 8192;
/// File names have six digits.
const MAX_FRAMES: f64 = 999_999.0;
const MAX_VIDEOS: u32 = 100_000;
/// Ids have 16 bits.
const MAX_ACTORS: u32 = 10_000;

impl RecipeDraft {
    /// Reads a TOML recipe.
    ///
    /// # Errors
    /// When it cannot be read or is not a recipe.
    pub fn read(path: &Path) -> Result<Self, RecipeError> {
        let text =
            fs::read_to_string(path).map_err(|cause| RecipeError::Unreadable { path: path.to_owned(), cause })?;
        let mut draft: Self = toml::from_str(&text).map_err(|e: toml::de::Error| {
            let (line, column) = line_and_column(&text, e.span().map_or(0, |s| s.start));
            RecipeError::Malformed {
                path: path.to_owned(),
                line,
                column,
                message: e.message().lines().collect::<Vec<_>>().join(", "),
            }
        })?;
        if let (Some(assets), Some(folder)) = (&mut draft.assets, path.parent()) {
            *assets = folder.join(&*assets);
        }
        Ok(draft)
    }

    /// Fills what is not given here from another draft: what is written here wins.
    pub fn or(self, other: Self) -> Self {
        Self {
            videos: self.videos.or(other.videos),
            vehicles: self.vehicles.or(other.vehicles),
            pedestrians: self.pedestrians.or(other.pedestrians),
            maps: self.maps.or(other.maps),
            cameras: self.cameras.or(other.cameras),
            cameras_per_scene: self.cameras_per_scene.or(other.cameras_per_scene),
            weathers: self.weathers.or(other.weathers),
            times: self.times.or(other.times),
            size: self.size.or(other.size),
            fps: self.fps.or(other.fps),
            duration: self.duration.or(other.duration),
            seed: self.seed.or(other.seed),
            layers: self.layers.or(other.layers),
            camera_look: self.camera_look.or(other.camera_look),
            rgb_format: self.rgb_format.or(other.rgb_format),
            min_pixels: self.min_pixels.or(other.min_pixels),
            mp4: self.mp4.or(other.mp4),
            simulator: self.simulator.or(other.simulator),
            assets: self.assets.or(other.assets),
            skip_broken: self.skip_broken.or(other.skip_broken),
        }
    }

    /// Completes with the defaults and validates. Models come from the catalogue, which has read their folder.
    ///
    /// # Errors
    /// The first thing that cannot be.
    pub fn resolve(self, source: &dyn MapSource) -> Result<Recipe, RecipeError> {
        let simulator = self.simulator.unwrap_or_else(|| "builtin".into());
        if simulator != "builtin" {
            return Err(RecipeError::Simulator { given: simulator });
        }
        let layers: Vec<Layer> = choose("layers", self.layers, Layer::ALL, Layer::name)?;
        let rgb_format = self.rgb_format.map_or(Ok(RgbFormat::Png), |given| given.parse())?;
        let camera_look = self.camera_look.map_or(Ok(LookChoice::Natural), |given| given.parse())?;
        let maps = maps(self.maps, source)?;
        let mut map_files = BTreeMap::new();
        for map in &maps {
            if let Some(hash) = source.content_hash(map)? {
                map_files.insert(map.clone(), hash);
            }
        }
        let cameras = camera_list::resolve(&self.cameras.unwrap_or_default(), &maps, source)?;
        let cameras_per_scene = count("cameras-per-scene", self.cameras_per_scene, 2, 1..=MAX_CAMERAS)?;
        let recipe = Recipe {
            videos: count("videos", self.videos, 2, 1..=MAX_VIDEOS)?,
            vehicles: count("vehicles", self.vehicles, 30, 0..=MAX_ACTORS)?,
            pedestrians: count("pedestrians", self.pedestrians, 20, 0..=MAX_ACTORS)?,
            maps,
            map_files,
            asset_files: source.asset_files(),
            cameras,
            cameras_per_scene,
            weathers: choose("weathers", self.weathers, Weather::ALL, Weather::name)?,
            times: choose("times", self.times, TimeOfDay::ALL, TimeOfDay::name)?,
            size: size(self.size)?,
            fps: number("fps", self.fps, 30.0, 0.01, 1000.0)?,
            duration: number("duration", self.duration, 5.0, 0.001, 1e7)?,
            seed: self.seed.unwrap_or(0),
            mp4: mp4(self.mp4, &layers)?,
            layers,
            camera_look,
            rgb_format,
            min_pixels: count("min-pixels", self.min_pixels, 50, 0..=u32::MAX)?,
            simulator,
        };
        let frames = (recipe.fps * recipe.duration).round();
        if !(1.0..=MAX_FRAMES).contains(&frames) {
            return Err(RecipeError::OutOfRange {
                field: "duration",
                given: recipe.duration.to_string(),
                rule: format!("at {} fps this is {frames} frames, a video has 1 to {MAX_FRAMES}", recipe.fps),
            });
        }
        Ok(recipe)
    }
}

fn count(
    field: &'static str,
    given: Option<i64>,
    default: u32,
    range: std::ops::RangeInclusive<u32>,
) -> Result<u32, RecipeError> {
    let Some(given) = given else { return Ok(default) };
    u32::try_from(given).ok().filter(|n| range.contains(n)).ok_or_else(|| RecipeError::OutOfRange {
        field,
        given: given.to_string(),
        rule: format!("write a whole number from {} to {}", range.start(), range.end()),
    })
}

fn number(field: &'static str, given: Option<f64>, default: f64, least: f64, most: f64) -> Result<f64, RecipeError> {
    let value = given.unwrap_or(default);
    // NaN is in no range.
    if (least..=most).contains(&value) {
        return Ok(value);
    }
    Err(RecipeError::OutOfRange {
        field,
        given: value.to_string(),
        rule: format!("write a number from {least} to {most}"),
    })
}

fn size(given: Option<String>) -> Result<ImageSize, RecipeError> {
    let Some(given) = given else { return Ok(ImageSize { width: 1280, height: 720 }) };
    let rule = format!("write WIDTHxHEIGHT, each from 1 to {MAX_SIDE}, for example 1280x720");
    let side = 1..=MAX_SIDE;
    let parsed = ImageSize::from_str(&given).ok().filter(|s| side.contains(&s.width) && side.contains(&s.height));
    parsed.ok_or(RecipeError::OutOfRange { field: "size", given, rule })
}

/// Words from a list, in the list's order, without repetition.
fn choose<T: Copy + PartialEq + FromStr<Err = UnknownName>>(
    field: &'static str,
    given: Option<Vec<String>>,
    all: &[T],
    name: impl Fn(T) -> &'static str,
) -> Result<Vec<T>, RecipeError> {
    let Some(given) = given else { return Ok(all.to_vec()) };
    if given.is_empty() {
        return Err(RecipeError::EmptyList { field, known: all.iter().map(|t| name(*t).to_owned()).collect() });
    }
    let chosen: Vec<T> = given.iter().map(|word| word.trim().parse()).collect::<Result<_, _>>()?;
    Ok(all.iter().copied().filter(|t| chosen.contains(t)).collect())
}

/// CARLA's layered maps (`Town01_Opt`) are the same towns.
fn maps(given: Option<Vec<String>>, source: &dyn MapSource) -> Result<Vec<String>, RecipeError> {
    let Some(given) = given else { return Ok(source.maps()) };
    let known: Vec<String> = source.maps().into_iter().chain(source.imported()).collect();
    if given.is_empty() {
        return Err(RecipeError::EmptyList { field: "maps", known });
    }
    let mut chosen = Vec::new();
    for word in &given {
        let exact = word.trim();
        let plain = exact.strip_suffix("_Opt").unwrap_or(exact);
        let name = if known.iter().any(|k| k == exact) { exact } else { plain };
        if !known.iter().any(|k| k == name) {
            return Err(RecipeError::UnknownMap { given: word.clone(), known });
        }
        chosen.push(name);
    }
    Ok(known.iter().filter(|k| chosen.contains(&k.as_str())).cloned().collect())
}

fn mp4(given: Option<Vec<String>>, layers: &[Layer]) -> Result<Vec<Layer>, RecipeError> {
    match given {
        None => Ok(layers.iter().copied().filter(|l| *l == Layer::Rgb).collect()),
        Some(given) if given.is_empty() || given == ["none"] => Ok(Vec::new()),
        given => {
            let chosen = choose("mp4", given, Layer::ALL, Layer::name)?;
            match chosen.iter().find(|l| !layers.contains(l)) {
                Some(layer) => Err(RecipeError::VideoWithoutLayer { layer: *layer }),
                None => Ok(chosen),
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::tests::ThreeTowns;

    #[test]
    fn defaults_are_the_contract_s() {
        let recipe = RecipeDraft::default().resolve(&ThreeTowns).expect("defaults are valid");
        assert_eq!((recipe.videos, recipe.cameras_per_scene, recipe.vehicles, recipe.pedestrians), (2, 2, 30, 20));
        assert_eq!((recipe.size.to_string().as_str(), recipe.fps, recipe.duration), ("1280x720", 30.0, 5.0));
        assert_eq!((recipe.frames(), recipe.seed, recipe.min_pixels), (150, 0, 50));
        assert_eq!(recipe.layers, Layer::ALL);
        assert_eq!((recipe.rgb_format, recipe.mp4.as_slice()), (RgbFormat::Png, &[Layer::Rgb][..]));
        assert_eq!(recipe.maps.len(), 3);
    }

    #[test]
    fn the_order_of_words_does_not_matter() {
        let words = |list: &[&str]| Some(list.iter().map(|w| (*w).to_owned()).collect());
        let draft = RecipeDraft {
            maps: words(&["Town03", "Town01_Opt", "Town01"]),
            layers: words(&["instance", "rgb", "rgb"]),
            ..Default::default()
        };
        let recipe = draft.resolve(&ThreeTowns).expect("valid");
        assert_eq!(recipe.maps, ["Town01", "Town03"]);
        assert_eq!(recipe.layers, [Layer::Rgb, Layer::Instance]);
    }

    #[test]
    fn flags_win_over_the_file() {
        let folder = tempfile::tempdir().expect("temp");
        let path = folder.path().join("recipe.toml");
        fs::write(&path, "videos = 7\nfps = 10\nsize = \"64x48\"\nweathers = [\"rainy\"]\n").expect("writable");
        let file = RecipeDraft::read(&path).expect("a recipe");
        let flags = RecipeDraft { videos: Some(3), ..Default::default() };
        let recipe = flags.or(file).resolve(&ThreeTowns).expect("valid");
        assert_eq!((recipe.videos, recipe.fps, recipe.weathers.as_slice()), (3, 10.0, &[Weather::Rainy][..]));
        fs::write(&path, "videos = 7\nvideoes = 8\n").expect("writable");
        let error = RecipeDraft::read(&path).expect_err("a misspelt key").to_string();
        assert!(error.contains("recipe.toml:2:1: unknown field `videoes`"), "{error}");
        assert_eq!(error.lines().count(), 1);
    }

    #[test]
    fn a_frame_count_is_rounded() {
        let draft = RecipeDraft { fps: Some(29.97), duration: Some(2.0), ..Default::default() };
        assert_eq!(draft.resolve(&ThreeTowns).expect("valid").frames(), 60);
        let none = RecipeDraft { fps: Some(1.0), duration: Some(0.1), ..Default::default() };
        assert!(none.resolve(&ThreeTowns).is_err());
    }
}
