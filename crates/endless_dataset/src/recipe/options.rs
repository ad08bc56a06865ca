//! The options of a recipe, each declared once: flag, key, default, bounds, help, schema and the recipe's field come
//! from here.

use super::option::{
    OptionDefault::{Described, Value},
    OptionError, OptionKind, OptionValue, RecipeOption, Vocabulary,
};
use super::{preset::Preset, rig::SensorSpec, serde_size, user_camera::UserCamera};
use crate::{Layer, RgbFormat};
use endless_annotate::CountingLine;
use endless_world::{
    ActorDensity, CameraLookChoice, CameraSite, Changing, Clothing, ImageSize, IncidentKind, PerVideo, RandomisedPart,
    RegionChoice, SignalControl, TimeOfDay, TrafficDensity, ViewSubject, Weather,
};
use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, path::PathBuf};

/// The longest side of an image.
const LONGEST_SIDE: u32 = 8192;
const MAX_VIDEOS: u64 = 100_000;
/// Ids have 16 bits.
const MAX_ACTORS: u64 = 10_000;

/// Most cameras of a scene.
pub const MAX_CAMERAS: u32 = 8;

/// `key: type in a draft [=> type in the resolved recipe], kind, default;`
macro_rules! recipe_options {
    ($(
        $(#[doc = $help:literal])+
        $key:ident: $given:ty $(=> $(#[$attribute:meta])* $resolved:ty)?, $kind:expr, $default:expr;
    )+) => {
        /// What the user wrote: any part of a recipe. The same on the command line and in a TOML file.
        #[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
        #[serde(deny_unknown_fields)]
        pub struct RecipeDraft {
            $($(#[doc = $help])+ #[serde(skip_serializing_if = "Option::is_none")] pub $key: Option<$given>,)+
        }

        /// Everything that decides a dataset's bytes, complete and validated. Lists are in their canonical order, without
        /// repetition.
        #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
        pub struct Recipe {
            $($(
                #[doc = concat!("What [`RecipeDraft::", stringify!($key), "`] says.")]
                $(#[$attribute])*
                pub $key: $resolved,
            )?)+
            /// Hash of the content of each map among them that was imported from a file, by its name.
            #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
            pub map_files: BTreeMap<String, String>,
            /// Hash of the manifest and of each file of imported models, by its name.
            #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
            pub asset_files: BTreeMap<String, String>,
            /// Hash of the content of the file of tracks that is played.
            #[serde(default, skip_serializing_if = "Option::is_none")]
            pub traffic_file: Option<String>,
        }

        impl RecipeDraft {
            /// All options, in the order in which they are told.
            pub const OPTIONS: &[RecipeOption] = &[$(RecipeOption {
                key: stringify!($key),
                help: concat!($($help),+).trim_ascii_start(),
                kind: $kind,
                default: $default,
            }),+];

            /// Fills what is not given here from another draft: what is written here wins.
            pub fn or(self, other: Self) -> Self {
                Self { $($key: self.$key.or(other.$key)),+ }
            }

            /// Takes what follows a flag for the value of an option.
            ///
            /// # Errors
            /// What is wrong with it; that there is no such option.
            pub fn set(&mut self, key: &str, text: &str) -> Result<(), String> {
                match key {
                    $(stringify!($key) => self.$key = Some(OptionValue::from_flag(text)?),)+
                    _ => return Err(format!("there is no option {key}")),
                }
                Ok(())
            }

            /// Whether each option can be what it is given; puts lists in their canonical order.
            ///
            /// # Errors
            /// The first value that its option cannot have.
            pub fn check(&mut self) -> Result<(), OptionError> {
                let mut options = Self::OPTIONS.iter();
                $(if let (Some(option), Some(value)) = (options.next(), &mut self.$key) { value.check(option)?; })+
                Ok(())
            }
        }
    };
}

recipe_options! {
    /// A set of values for what is not given: surveillance, highway, junction, crowd or night (docs/variety.md).
    preset: String, OptionKind::Word(Vocabulary::of::<Preset>()), Described("none");
    /// Number of videos. A video is one scene filmed by all its cameras.
    videos: i64 => u32, OptionKind::Whole { least: 1, most: MAX_VIDEOS }, Value("2");
    /// Moving vehicles in each scene, in addition to parked ones.
    vehicles: i64 => u32, OptionKind::Whole { least: 0, most: MAX_ACTORS }, Value("30");
    /// Pedestrians in each scene.
    pedestrians: i64 => u32, OptionKind::Whole { least: 0, most: MAX_ACTORS }, Value("20");
    /// How busy the streets are: light, normal or rush. Instead of plain numbers of vehicles and pedestrians, which win where
    /// they are given: as many as the map and the streets before its cameras take.
    density: String => #[serde(default, skip_serializing_if = "ActorDensity::is_nothing")] ActorDensity,
        OptionKind::Word(Vocabulary::of::<TrafficDensity>()), Described("the numbers of vehicles and pedestrians");
    /// Share of vehicles and pedestrians who come to the streets that the cameras see: 0 spreads them evenly over the map.
    focus: f64 => #[serde(default = "usual_focus")] f64, OptionKind::Number { least: 0.0, most: 1.0 }, Value("0.8");
    /// Whose mix of vehicles drives: european, north_american, latin_american or south_east_asian (docs/traffic.md); drawn,
    /// another in each video.
    region: String => #[serde(default, skip_serializing_if = "RegionChoice::is_usual")] RegionChoice,
        OptionKind::Word(Vocabulary::of::<RegionChoice>()), Value("european");
    /// Share of motorcycles and bicycles among moving vehicles, instead of the region's.
    two_wheelers: f64 => #[serde(default, skip_serializing_if = "Option::is_none")] Option<f64>,
        OptionKind::Number { least: 0.0, most: 1.0 }, Described("the region's");
    /// Share of bicycles among moving two-wheelers; where the region is drawn, another in each video.
    bicycles: f64 => #[serde(default, skip_serializing_if = "Option::is_none")] Option<f64>,
        OptionKind::Number { least: 0.0, most: 1.0 }, Described("the region's");
    /// Share of trucks and buses among moving vehicles that are no two-wheelers; where the region is drawn, another in each video.
    heavy_vehicles: f64 => #[serde(default, skip_serializing_if = "Option::is_none")] Option<f64>,
        OptionKind::Number { least: 0.0, most: 1.0 }, Described("the region's");
    /// What people on foot are dressed for, where it does not rain: fair, hot, cold; region, its usual weather, and where the
    /// region is drawn, in some videos of Europe and North America the cold.
    clothing: String => #[serde(default, skip_serializing_if = "Clothing::is_usual")] Clothing,
        OptionKind::Word(Vocabulary::of::<Clothing>()), Value("region");
    /// How drivers drive: 0 all cautious, 0.5 as counted on real streets, 1 all bold: faster, nearer to one another.
    aggressiveness: f64 => #[serde(default = "half", skip_serializing_if = "is_half")] f64,
        OptionKind::Number { least: 0.0, most: 1.0 }, Value("0.5");
    /// Share of the maps' parked vehicles that are there.
    parked: f64 => #[serde(default = "whole", skip_serializing_if = "is_whole")] f64,
        OptionKind::Number { least: 0.0, most: 1.0 }, Value("1");
    /// How signals of junctions are controlled: fixed by their plans, or actuated by who comes (docs/traffic.md).
    signals: String => #[serde(default, skip_serializing_if = "SignalControl::is_fixed")] SignalControl,
        OptionKind::Word(Vocabulary::of::<SignalControl>()), Value("fixed");
    /// Share of pedestrians who cross roads away from crossings when a gap in traffic lets them.
    jaywalking: f64 => #[serde(default, skip_serializing_if = "is_zero")] f64,
        OptionKind::Number { least: 0.0, most: 1.0 }, Value("0");
    /// Share of pedestrians who walk in groups of two to four.
    groups: f64 => #[serde(default, skip_serializing_if = "is_zero")] f64,
        OptionKind::Number { least: 0.0, most: 1.0 }, Value("0");
    /// Events to stage before the cameras, one a video, the kinds in turn: scene.json tells who, when and how near they come
    /// (docs/traffic.md).
    events: Vec<String> => #[serde(default, skip_serializing_if = "Vec::is_empty")] Vec<IncidentKind>,
        OptionKind::WordsOrNone(Vocabulary::of::<IncidentKind>()), Described("none");
    /// Play the motion that a file tells instead of simulating it: SUMO's FCD (XML), or CSV (docs/clone.md). Vehicles and
    /// pedestrians are then 0 by default, of what the file has. In a recipe file, relative to the folder of that file.
    traffic: PathBuf, OptionKind::File, Described("none");
    /// Position in that file of the map's origin, X,Y in metres: SUMO's `netOffset`.
    traffic_offset: [f64; 2] => #[serde(default, skip_serializing_if = "is_origin")] [f64; 2],
        OptionKind::Place, Value("0,0");
    /// When each video begins on that file's clock, seconds.
    traffic_begin: f64 => #[serde(default, skip_serializing_if = "Option::is_none")] Option<f64>,
        OptionKind::Number { least: -1e9, most: 1e9 }, Described("the first instant at which anybody is there");
    /// Maps to choose from; `endless maps` lists them. Your own can be imported from OpenDRIVE and OpenStreetMap files
    /// (docs/maps.md). random:N grows N towns that nobody has drawn, by the seed; Random17 is the one of number 17.
    maps: Vec<String> => Vec<String>, OptionKind::Maps, Described("all that come with the program");
    /// Whether each video has a town of its own on the roads of its map: fixed, the same town in all; drawn, other buildings,
    /// colours, shops, trees, furniture and parked vehicles in each (docs/variety.md).
    town_seed: String => #[serde(default, skip_serializing_if = "PerVideo::is_fixed")] PerVideo,
        OptionKind::Word(Vocabulary::of::<PerVideo>()), Value("fixed");
    /// Where cameras are: fixed, at the map's sites; drawn, at new places in every video, on poles, traffic lights, walls, roofs,
    /// gantries, bridges and masts, with other lenses (docs/variety.md).
    sites: String => #[serde(default, skip_serializing_if = "PerVideo::is_fixed")] PerVideo,
        OptionKind::Word(Vocabulary::of::<PerVideo>()), Value("fixed");
    /// What drawn cameras look at: street, junction, highway or square (where people are); maps that lack one show the others.
    views: Vec<String> => #[serde(default = "all_views", skip_serializing_if = "are_all_views")] Vec<ViewSubject>,
        OptionKind::Words(Vocabulary::of::<ViewSubject>()), Described("all");
    /// Your own cameras instead of the map's: a list in TOML or JSON (docs/maps.md).
    cameras: Vec<UserCamera> => #[serde(default, skip_serializing_if = "BTreeMap::is_empty")] BTreeMap<String, Vec<CameraSite>>,
        OptionKind::Cameras, Described("the map's");
    /// Cameras that film each scene at the same instants: a pair, as in the paper, or a network of them.
    /// With a rig, there may be none.
    cameras_per_scene: i64 => #[serde(default = "pair")] u32,
        OptionKind::Whole { least: 0, most: MAX_CAMERAS as u64 }, Value("2");
    /// Film each scene with cameras that see the same street, where a map has such cameras.
    overlapping: bool => #[serde(default, skip_serializing_if = "is_not")] bool, OptionKind::Switch, Value("false");
    /// Sensors of any kind that film or measure each scene besides its cameras, fixed or carried by vehicles, people and
    /// drones: a list in TOML or JSON (docs/rigs.md).
    sensor: Vec<SensorSpec> => #[serde(default, skip_serializing_if = "Vec::is_empty")] Vec<SensorSpec>,
        OptionKind::Rig, Described("none");
    /// Weathers to choose from; one that is named twice is twice as frequent.
    weathers: Vec<String> => Vec<Weather>, OptionKind::Words(Vocabulary::of::<Weather>()), Described("all");
    /// Times of day to choose from.
    times: Vec<String> => Vec<TimeOfDay>, OptionKind::Words(Vocabulary::of::<TimeOfDay>()), Described("all");
    /// Let every map, every weather and every time of day appear equally often, however many videos there are: counts
    /// differ by at most one.
    balance: bool => #[serde(default, skip_serializing_if = "is_not")] bool, OptionKind::Switch, Value("false");
    /// Let weather, time of day or both change during each video: rain sets in, fog lifts, dusk falls
    /// (docs/changing.md).
    changing: String => #[serde(default, skip_serializing_if = "is_nothing")] Changing,
        OptionKind::Word(Vocabulary::of::<Changing>()), Value("nothing");
    /// How high the sun stands: fixed, as in a usual morning or afternoon, and dark nights; drawn, another in every video,
    /// from just risen to near noon, and half of the nights dusk or dawn (docs/variety.md). Not where the time changes.
    sun: String => #[serde(default, skip_serializing_if = "PerVideo::is_fixed")] PerVideo,
        OptionKind::Word(Vocabulary::of::<PerVideo>()), Value("fixed");
    /// Image size, width x height.
    size: String => #[serde(with = "serde_size")] ImageSize, OptionKind::Size { longest: LONGEST_SIDE }, Value("1280x720");
    /// Frames a second.
    fps: f64 => f64, OptionKind::Number { least: 0.01, most: 1000.0 }, Value("30");
    /// Length of each video in seconds; it has exactly `round(fps × duration)` frames.
    duration: f64 => f64, OptionKind::Number { least: 0.001, most: 1e7 }, Value("5");
    /// Seed of everything random.
    seed: u64 => u64, OptionKind::Whole { least: 0, most: u64::MAX }, Value("0");
    /// Layers to store (bounding boxes are always written).
    layers: Vec<String> => Vec<Layer>, OptionKind::Words(Vocabulary::of::<Layer>()), Value("rgb,depth,instance");
    /// Effects of lens, sensor and recorder on the RGB layer: natural (a little noise, and motion blur by shutter time),
    /// clean (none), cctv (a wide lens, noise, compression and a time stamp), or random (another camera each time).
    camera_look: String => #[serde(default = "clean", skip_serializing_if = "is_clean")] CameraLookChoice,
        OptionKind::Word(Vocabulary::of::<CameraLookChoice>()), Value("natural");
    /// What each video varies by chance, so that what is learnt does not depend on the looks of one renderer: colours,
    /// textures, light, clutter, camera (docs/randomise.md).
    randomise: Vec<String> => #[serde(default, skip_serializing_if = "Vec::is_empty")] Vec<RandomisedPart>,
        OptionKind::WordsOrNone(Vocabulary::of::<RandomisedPart>()), Described("none");
    /// How far it varies what it randomises: 0 not at all, 1 as far as can be.
    randomise_strength: f64 => #[serde(default = "half", skip_serializing_if = "is_half")] f64,
        OptionKind::Number { least: 0.0, most: 1.0 }, Value("0.5");
    /// How to store the RGB layer.
    rgb_format: String => RgbFormat, OptionKind::Word(Vocabulary::of::<RgbFormat>()), Value("png");
    /// Annotate only objects with at least this many visible pixels.
    min_pixels: i64 => u32, OptionKind::Whole { least: 0, most: 4_294_967_295 }, Value("50");
    /// Write the amodal mask of each object: the pixels that it would show if nothing hid it, as COCO's run lengths.
    amodal_masks: bool => #[serde(default, skip_serializing_if = "std::ops::Not::not")] bool,
        OptionKind::Switch, Described("no");
    /// Lines on the ground whose passers-by are counted: `MAP/NAME:X,Y,X,Y`, in metres, several after semicolons; in a file a
    /// list of `{map, name, from = [x, y], to = [x, y]}` (docs/scene.md).
    counting_lines: Vec<CountingLine> => #[serde(default, skip_serializing_if = "Vec::is_empty")] Vec<CountingLine>,
        OptionKind::Lines, Described("none");
    /// Layers to write as a video file, too; may be none.
    mp4: Vec<String> => Vec<Layer>, OptionKind::WordsOrNone(Vocabulary::of::<Layer>()), Described("rgb");
    /// Simulator to use: builtin, the built-in city; carla://HOST:PORT, a CARLA server.
    simulator: String => String, OptionKind::Text, Value("builtin");
    /// Folder of glTF models with an assets.toml: vehicles for the traffic, props and buildings for the towns
    /// (docs/assets.md). In a recipe file, relative to the folder of that file.
    assets: PathBuf, OptionKind::Folder, Described("none");
    /// Skip models that cannot be read, with a warning.
    skip_broken: bool, OptionKind::Switch, Described("stop at them");
}

/// As in the paper.
fn pair() -> u32 {
    2
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_not(switch: &bool) -> bool {
    !switch
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_nothing(changing: &Changing) -> bool {
    *changing == Changing::Nothing
}

fn is_origin(place: &[f64; 2]) -> bool {
    *place == [0.0; 2]
}

fn half() -> f64 {
    0.5
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_half(strength: &f64) -> bool {
    *strength == half()
}

fn whole() -> f64 {
    1.0
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_whole(share: &f64) -> bool {
    *share == whole()
}

fn usual_focus() -> f64 {
    0.8
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_zero(share: &f64) -> bool {
    *share == 0.0
}

fn all_views() -> Vec<ViewSubject> {
    ViewSubject::ALL.to_vec()
}

fn are_all_views(views: &[ViewSubject]) -> bool {
    views == ViewSubject::ALL
}

fn clean() -> CameraLookChoice {
    CameraLookChoice::Clean
}

fn is_clean(look: &CameraLookChoice) -> bool {
    *look == CameraLookChoice::Clean
}

impl RecipeDraft {
    /// The draft of what holds where nothing is given, as far as it does not depend on anything.
    pub fn defaults() -> Self {
        let mut draft = Self::default();
        for option in Self::OPTIONS {
            let text = match (option.default, option.kind) {
                (Value(text), _) => text.to_owned(),
                (Described(_), OptionKind::Words(vocabulary)) => (vocabulary.words)().join(","),
                (Described(_), _) => continue,
            };
            draft.set(option.key, &text).expect("a default is a value of its option");
        }
        draft
    }
}
