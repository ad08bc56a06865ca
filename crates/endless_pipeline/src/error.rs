//! Errors between a recipe and its dataset. Every message is one line that says what to do.

use crate::{DiskEstimate, Shard, SimulatorError, StoreError};
use endless_annotate::AnnotateError;
use endless_dataset::{BuildIdentity, DatasetError, OptionError};
use endless_interchange::TrackFileError;
use std::path::PathBuf;

/// A recipe that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum RecipeError {
    /// A value that an option cannot have.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// A map that there is not.
    #[error("unknown map '{given}': use one of {}", known.join(", "))]
    UnknownMap {
        /// What was given.
        given: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// A camera of the user's own that cannot be like this.
    #[error("camera {camera}: {problem}")]
    UserCamera {
        /// Its name and map.
        camera: String,
        /// What is wrong.
        problem: String,
    },
    /// A sensor of a rig that cannot be like this.
    #[error("sensor {sensor}: {problem}")]
    Sensor {
        /// Its name.
        sensor: String,
        /// What is wrong.
        problem: String,
    },
    /// A map that cannot be read.
    #[error(transparent)]
    Map(#[from] SimulatorError),
    /// A video of a layer that is not recorded.
    #[error("mp4 names the layer {layer}, which is not recorded: add it to layers or leave it out of mp4")]
    VideoWithoutLayer {
        /// The layer.
        layer: endless_dataset::Layer,
    },
    /// A file of tracks that cannot be played.
    #[error(transparent)]
    Tracks(#[from] TrackFileError),
    /// Tracks on more maps than one.
    #[error("the tracks of --traffic are those of one map: name it with --maps")]
    TracksOnMaps,
    /// An option of tracks without any.
    #[error("--{field} is about a file of tracks: name it with --traffic, or leave it out")]
    NoTracks {
        /// The option.
        field: &'static str,
    },
    /// A simulator that there is not.
    #[error("unknown simulator '{given}': leave out --simulator, or use one of {}", known.join(", "))]
    UnknownSimulator {
        /// What was given.
        given: String,
        /// The simulators there are.
        known: Vec<&'static str>,
    },
    /// An address of a simulator that cannot be.
    #[error("--simulator: {problem}")]
    Simulator {
        /// What is wrong.
        problem: String,
    },
    /// A file that cannot be read.
    #[error("cannot read the {what}: {cause}: {}", path.display())]
    Unreadable {
        /// What it has: a recipe, a rig, cameras.
        what: &'static str,
        /// The file.
        path: PathBuf,
        /// Why not.
        cause: std::io::Error,
    },
    /// A recipe file that is not a recipe.
    #[error("{}:{line}:{column}: {message}", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
        /// Column, from 1.
        column: usize,
        /// What is wrong there.
        message: String,
    },
}

/// A plan that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum PlanError {
    /// The simulator cannot give the cameras.
    #[error(transparent)]
    Simulator(#[from] SimulatorError),
    /// Too few cameras for a scene.
    #[error(
        "map {map} has {cameras} camera sites, a scene is filmed by {wanted}: ask for fewer with --cameras-per-scene, \
         or name maps that have more"
    )]
    FewCameras {
        /// The map.
        map: String,
        /// How many it has.
        cameras: usize,
        /// How many a scene needs.
        wanted: usize,
    },
    /// A map without good views.
    #[error(
        "no street of map {map} gives {wanted} cameras a view: ask for fewer with --cameras-per-scene, or use --sites fixed"
    )]
    NoViews {
        /// The map.
        map: String,
        /// How many cameras a scene needs.
        wanted: u32,
    },
    /// A sensor of a rig that has no place on a map.
    #[error("sensor {sensor} on map {map}: {problem}")]
    Rig {
        /// Its name.
        sensor: String,
        /// The map.
        map: String,
        /// What is wrong.
        problem: String,
    },
    /// More sets of cameras than can be counted.
    #[error("map {map} has {cameras} cameras, and too many sets of them to choose from: list fewer")]
    ManyCameras {
        /// The map.
        map: String,
        /// How many it has.
        cameras: usize,
    },
}

/// A dataset that cannot be made or resumed.
#[derive(Debug, thiserror::Error)]
pub enum GenerateError {
    /// The plan cannot be made.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// A file cannot be read or written.
    #[error(transparent)]
    Dataset(#[from] DatasetError),
    /// Where the dataset is kept.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The simulator failed.
    #[error(transparent)]
    Simulator(#[from] SimulatorError),
    /// The system gives no threads.
    #[error("cannot start the threads: {0}: ask for fewer with --threads")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    /// Image and scene disagree.
    #[error("the simulator contradicts itself: {0}")]
    Annotate(#[from] AnnotateError),
    /// The output is a file.
    #[error("the output is a file: give a folder, which need not exist: {}", path.display())]
    OutputIsFile {
        /// The output.
        path: PathBuf,
    },
    /// The output holds something else.
    #[error("the output holds other files ('{found}'): give a new or an empty folder: {}", path.display())]
    OutputInUse {
        /// One of them.
        found: String,
        /// The output.
        path: PathBuf,
    },
    /// Somebody else writes there.
    #[error("another process is writing this dataset: wait for it, or give another folder: {}", path.display())]
    Locked {
        /// The output.
        path: PathBuf,
    },
    /// Somebody else makes the same shard.
    #[error("another process is making shard {shard} of this dataset: wait for it, or make another: {}", path.display())]
    ShardLocked {
        /// The shard.
        shard: Shard,
        /// The output.
        path: PathBuf,
    },
    /// Somebody else makes a shard of another number of shards.
    #[error(
        "another process is making one of {of} shards of this dataset, and these would share videos: wait for it, or make \
         one of {of}, too: {}",
        path.display()
    )]
    OtherShards {
        /// How many shards there are of theirs.
        of: u32,
        /// The output.
        path: PathBuf,
    },
    /// The output holds the dataset of another recipe.
    #[error(
        "the output holds a dataset of another recipe ({field} is {theirs} there, {mine} here): use the same recipe \
         or give another folder: {}",
        path.display()
    )]
    OtherRecipe {
        /// The first field that differs.
        field: String,
        /// Its value in the output.
        theirs: String,
        /// Its value now.
        mine: String,
        /// The output.
        path: PathBuf,
    },
    /// The output holds what another build made.
    #[error(
        "the output was made by another build of endless, {theirs}, and this one, {mine}, may make other bytes: use that \
         build, give another folder, or mix them with --allow-other-build: {}",
        path.display()
    )]
    OtherBuild {
        /// The build that was at work there.
        theirs: Box<BuildIdentity>,
        /// The one that runs.
        mine: Box<BuildIdentity>,
        /// The output.
        path: PathBuf,
    },
    /// A dataset of an older format.
    #[error(
        "the dataset has format {found}, which this program reads and does not go on with: use the program that began it, \
         or give another folder: {}",
        path.display()
    )]
    OlderFormat {
        /// Its format.
        found: u32,
        /// The output.
        path: PathBuf,
    },
    /// Images that nothing tells the build of.
    #[error(
        "builds.json is missing, and nothing says which build of endless made this video: delete it, give another \
         folder, or resume it with --allow-other-build: {}",
        path.display()
    )]
    UnknownBuild {
        /// The video's folder.
        path: PathBuf,
    },
    /// A scene in the output is not what the recipe plans.
    #[error("this scene is not the one that the recipe plans: give another folder, or delete it: {}", path.display())]
    OtherScene {
        /// The scene's file.
        path: PathBuf,
    },
    /// A video that nothing proves to be this recipe's.
    #[error(
        "dataset.json is missing, and nothing says that this video is of this recipe: delete it, or give another \
         folder: {}",
        path.display()
    )]
    UnprovenVideo {
        /// The video's folder.
        path: PathBuf,
    },
    /// The disk is too small.
    #[error(
        "the disk has {} free, the dataset needs about {}: make room, ask for less, or use --rgb-format jpg: {}",
        human_bytes(estimate.free), human_bytes(estimate.bytes), path.display()
    )]
    DiskTooSmall {
        /// How much is needed and there.
        estimate: DiskEstimate,
        /// The output.
        path: PathBuf,
    },
}

/// A number of bytes for people to read, such as `3.2 GB`.
pub fn human_bytes(bytes: u64) -> String {
    const UNITS: [&str; 5] = ["bytes", "kB", "MB", "GB", "TB"];
    let mut value = bytes as f64;
    let mut unit = 0;
    while value >= 1000.0 && unit + 1 < UNITS.len() {
        value /= 1000.0;
        unit += 1;
    }
    if unit == 0 { format!("{bytes} bytes") } else { format!("{value:.1} {}", UNITS[unit]) }
}
