//! The command line.

use crate::{
    bench::ScalingSeries,
    build_info::VERSION,
    recipe_args::RecipeArgs,
    simulate_options::{OutputFile, TopViewFormat, VehicleCount},
};
use bytesize::ByteSize;

use clap::builder::{PathBufValueParser, PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand};
use endless_carla::client::Address;
use endless_carla::server::QualityLevel;
use endless_export::{Format, SplitBy, SplitShares};
use endless_interchange::TrajectoryFormat;
use endless_pipeline::Shard;
use endless_world::{Clothing, DrivingSide, Region, SignalControl, TimeOfDay, Weather};
use std::path::PathBuf;

/// Endless annotated urban datasets seen by surveillance cameras.
#[derive(Debug, Parser)]
#[command(version = VERSION.as_str(), about, max_term_width = 100, arg_required_else_help = false)]
pub(crate) struct Cli {
    /// Print how long each stage takes, once per video; given twice (`-vv`), once per frame.
    #[arg(short, long, global = true, action = clap::ArgAction::Count)]
    pub(crate) verbose: u8,
    /// Threads that work [default: all cores]. Does not change the result.
    #[arg(long, global = true, value_name = "N")]
    pub(crate) threads: Option<std::num::NonZeroUsize>,
    #[command(subcommand)]
    pub(crate) command: Command,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Make a dataset, or resume one that was interrupted.
    Generate(Box<GenerateArgs>),
    /// Tell how long each video of a recipe would take on this machine and how large it would be, from a few frames.
    Plan(Box<PlanArgs>),
    /// Write what makes a dataset on a cluster: an array of jobs for Slurm, or a Job for Kubernetes.
    Cluster(ClusterArgs),
    /// Check a dataset: read every file and list all errors.
    Check(CheckArgs),
    /// Write a dataset in a format of others: COCO, YOLO, MOTChallenge, KITTI and more.
    Export(ExportArgs),
    /// Count a dataset: conditions, boxes, tracks, speeds, people, looks; as text, JSON or a web page with charts.
    Stats(StatsArgs),
    /// Lay two datasets side by side; one may be a real one in COCO form.
    Compare(CompareArgs),
    /// Look at a dataset in the browser, also while it is being made.
    View(ViewArgs),
    /// Time the whole pipeline on a fixed recipe.
    Bench(BenchArgs),
    /// Print the JSON schema of recipes.
    Schema,
    /// List, preview, import and export maps.
    Maps(MapsArgs),
    /// List, preview and export vehicles, people, buildings, plants and street furniture.
    Assets(AssetsArgs),
    /// Simulate the traffic of a map without pictures: trajectories, a view from above, an audit.
    Simulate(SimulateArgs),
    /// Be a CARLA server: scripts that are written for CARLA 0.9.16 run on the built-in city.
    Serve(ServeArgs),
}

#[derive(Debug, Args)]
pub(crate) struct ServeArgs {
    /// The first map; clients may load others.
    #[arg(long, default_value = "Town10HD")]
    pub(crate) map: String,
    /// Port of requests; that of streams is the next one. 0 for any two that are free.
    #[arg(long, default_value_t = 2000)]
    pub(crate) port: u16,
    /// Address on which to listen: this machine alone, unless another is given.
    #[arg(long, default_value = "127.0.0.1")]
    pub(crate) bind: std::net::IpAddr,
    /// Of all that is drawn.
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// How good the pictures of moving cameras are: Low leaves steps at edges, and is faster.
    #[arg(long, value_name = "LEVEL", default_value = "Epic", ignore_case = true)]
    #[arg(value_parser = words(QualityLevel::ALL, QualityLevel::name))]
    pub(crate) quality_level: QualityLevel,
    /// Folder of recordings, the only one that clients can write to and read from; by default `endless/recordings` where the
    /// platform keeps data.
    #[arg(long, value_name = "DIR")]
    pub(crate) recordings: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct GenerateArgs {
    /// Folder of the dataset; it is created if it does not exist. Or object storage: s3://BUCKET/PREFIX, gs://BUCKET/PREFIX,
    /// az://CONTAINER/PREFIX (docs/storage.md).
    pub(crate) out: PathBuf,
    #[command(flatten)]
    pub(crate) recipe: RecipeArgs,
    /// Read the recipe from a TOML file; flags override it.
    #[arg(long, value_name = "FILE")]
    pub(crate) config: Option<PathBuf>,
    /// Most memory for what bakes of the same camera share, as in 500MB or 4GiB. Does not change the result.
    #[arg(long, value_name = "SIZE", default_value = "1GiB", value_parser = byte_size)]
    pub(crate) memory: ByteSize,
    /// Keep that in this folder, too, for other runs and for processes that run at the same time. Does not change the
    /// result.
    #[arg(long, value_name = "DIR")]
    pub(crate) cache: Option<PathBuf>,
    /// With a CARLA server: the TrafficManager that drives the vehicles, as HOST or HOST:PORT [default: none, the built-in
    /// traffic drives on the server's map].
    #[arg(long, value_name = "HOST:PORT", value_parser = traffic_manager)]
    pub(crate) traffic_manager: Option<Address>,
    /// With a CARLA server: how long a frame may take, seconds; then it is asked for again.
    #[arg(long, value_name = "S", default_value_t = 30.0, value_parser = seconds)]
    pub(crate) frame_timeout: f64,
    /// With object storage: the folder in which videos are recorded before they are uploaded [default: the user's cache].
    #[arg(long, value_name = "DIR")]
    pub(crate) work_dir: Option<PathBuf>,
    /// With a CARLA server or object storage: how long one that has gone is waited for, seconds; then the run ends, and the same
    /// command goes on.
    #[arg(long, value_name = "S", default_value_t = 120.0, value_parser = seconds)]
    pub(crate) reconnect_timeout: f64,
    /// Write the settings of all scenes, print the work order, and stop.
    #[arg(long)]
    pub(crate) plan_only: bool,
    /// Make one of so many parts of the videos, as in 3/8: other processes and machines make the others in the same folder
    /// at the same time (docs/cluster.md).
    #[arg(long, value_name = "I/N")]
    pub(crate) shard: Option<Shard>,
    /// Resume a dataset that another build of endless began, although that build may make other bytes; `dataset.json`
    /// lists the builds of every video.
    #[arg(long)]
    pub(crate) allow_other_build: bool,
}

#[derive(Debug, Args)]
pub(crate) struct PlanArgs {
    #[command(flatten)]
    pub(crate) recipe: RecipeArgs,
    /// Read the recipe from a TOML file; flags override it.
    #[arg(long, value_name = "FILE")]
    pub(crate) config: Option<PathBuf>,
    /// Also tell which of so many shards makes each video, and how long the slowest takes.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=i64::from(Shard::MAX)))]
    pub(crate) shards: u32,
    /// Write all numbers as JSON.
    #[arg(long, value_name = "FILE.json")]
    pub(crate) json: Option<PathBuf>,
    /// Take what was measured from this file, or measure and keep it there.
    #[arg(long, value_name = "FILE.json")]
    pub(crate) rates: Option<PathBuf>,
    /// Videos to try, each in other conditions than those before it.
    #[arg(long, value_name = "N", default_value_t = 3, value_parser = clap::value_parser!(u32).range(1..=1000))]
    pub(crate) samples: u32,
    /// Frames to record of each [default: 8, and 4 more a thread].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub(crate) frames: Option<u32>,
}

#[derive(Debug, Args)]
pub(crate) struct ClusterArgs {
    #[command(subcommand)]
    pub(crate) engine: ClusterEngine,
}

#[derive(Debug, Subcommand)]
pub(crate) enum ClusterEngine {
    /// Print a script that submits itself to Slurm: an array of shards that are queued again when a node is lost, and a check
    /// at the end.
    Slurm(SlurmArgs),
    /// Print a manifest of an Indexed Job for Kubernetes: a shard a pod, each tried again by itself.
    Kubernetes(KubernetesArgs),
}

/// What any cluster needs to know.
#[derive(Debug, Args)]
pub(crate) struct ShardsArgs {
    /// The recipe: a TOML file.
    pub(crate) recipe: PathBuf,
    /// Folder of the dataset, or address of an object store.
    #[arg(long, value_name = "OUT")]
    pub(crate) out: String,
    /// Number of shards.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(Shard::MAX)))]
    pub(crate) shards: u32,
    /// Name of the job.
    #[arg(long, value_name = "NAME", default_value = "endless", value_parser = job_name)]
    pub(crate) name: String,
    /// Cores of each shard.
    #[arg(long, value_name = "N", default_value_t = 8, value_parser = clap::value_parser!(u32).range(1..=4096))]
    pub(crate) cpus: u32,
}

#[derive(Debug, Args)]
pub(crate) struct SlurmArgs {
    #[command(flatten)]
    pub(crate) shards: ShardsArgs,
    /// Longest time of a shard, as Slurm writes it; one that is not done two minutes before is queued again and goes on.
    #[arg(long, value_name = "TIME", default_value = "24:00:00", value_parser = slurm_word)]
    pub(crate) time: String,
    /// Partition [default: the cluster's].
    #[arg(long, value_name = "NAME", value_parser = slurm_word)]
    pub(crate) partition: Option<String>,
    /// Account [default: the user's].
    #[arg(long, value_name = "NAME", value_parser = slurm_word)]
    pub(crate) account: Option<String>,
    /// Memory of each shard, as Slurm writes it [default: the cluster's].
    #[arg(long, value_name = "SIZE", value_parser = slurm_word)]
    pub(crate) mem: Option<String>,
    /// Most shards at the same time [default: as many as there is room for].
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) at_once: Option<u32>,
    /// The program on the nodes.
    #[arg(long, value_name = "PATH", default_value = "endless")]
    pub(crate) program: String,
}

#[derive(Debug, Args)]
pub(crate) struct KubernetesArgs {
    #[command(flatten)]
    pub(crate) shards: ShardsArgs,
    /// Image that has the program.
    #[arg(long, value_name = "IMAGE")]
    pub(crate) image: String,
    /// Claim of a volume that all pods can write, mounted at /data: OUT is a folder there.
    #[arg(long, value_name = "NAME", value_parser = job_name)]
    pub(crate) claim: Option<String>,
    /// Secret whose entries are environment variables of the pods, such as those of an object store.
    #[arg(long, value_name = "NAME", value_parser = job_name)]
    pub(crate) secret: Option<String>,
    /// Memory of each pod.
    #[arg(long, value_name = "SIZE", default_value = "8Gi", value_parser = slurm_word)]
    pub(crate) memory: String,
    /// How often each shard is tried again.
    #[arg(long, value_name = "N", default_value_t = 10)]
    pub(crate) retries: u32,
}

#[derive(Debug, Args)]
pub(crate) struct SimulateArgs {
    /// Name of the map, or a map file: OpenDRIVE (.xodr) or OpenStreetMap (.osm, .osm.pbf).
    pub(crate) map: String,
    /// Seconds to simulate, after 25 in which traffic gets going.
    #[arg(long, value_name = "S", default_value_t = 60.0, value_parser = seconds)]
    pub(crate) seconds: f64,
    /// Moving vehicles; `max` for as many as the map holds.
    #[arg(long, value_name = "N|max", default_value = "30")]
    pub(crate) vehicles: VehicleCount,
    /// People on foot.
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(0..=5000))]
    pub(crate) pedestrians: u32,
    /// Share of people who cross roads away from crossings.
    #[arg(long, value_name = "X", default_value_t = 0.0, value_parser = share)]
    pub(crate) jaywalking: f64,
    /// Share of people who walk in groups of two to four.
    #[arg(long, value_name = "X", default_value_t = 0.0, value_parser = share)]
    pub(crate) groups: f64,
    /// Of all that is drawn.
    #[arg(long, default_value_t = 0)]
    pub(crate) seed: u64,
    /// Instants a second in the files.
    #[arg(long, value_name = "X", default_value_t = 10.0, value_parser = rate)]
    pub(crate) fps: f64,
    /// Weather: on wet roads drivers go slower and keep more distance.
    #[arg(long, value_name = "WORD", default_value = "clear_sky", value_parser = words(Weather::ALL, Weather::name))]
    pub(crate) weather: Weather,
    /// Time of day.
    #[arg(long, value_name = "WORD", default_value = "afternoon", value_parser = words(TimeOfDay::ALL, TimeOfDay::name))]
    pub(crate) time: TimeOfDay,
    /// Whose mix of vehicles drives.
    #[arg(long, value_name = "WORD", default_value = "european", value_parser = words(Region::ALL, Region::name))]
    pub(crate) region: Region,
    /// Share of motorcycles and bicycles among moving vehicles, instead of the region's.
    #[arg(long, value_name = "0..1", value_parser = share)]
    pub(crate) two_wheelers: Option<f64>,
    /// Share of bicycles among moving two-wheelers, instead of the region's.
    #[arg(long, value_name = "0..1", value_parser = share)]
    pub(crate) bicycles: Option<f64>,
    /// Share of trucks and buses among moving vehicles that are no two-wheelers, instead of the region's.
    #[arg(long, value_name = "0..1", value_parser = share)]
    pub(crate) heavy_vehicles: Option<f64>,
    /// What people on foot are dressed for, where it does not rain.
    #[arg(long, value_name = "WORD", default_value = "region", value_parser = words(Clothing::ALL, Clothing::name))]
    pub(crate) clothing: Clothing,
    /// How drivers drive: 0 all cautious, 0.5 as counted on real streets, 1 all bold.
    #[arg(long, value_name = "0..1", default_value_t = 0.5, value_parser = share)]
    pub(crate) aggressiveness: f64,
    /// How signals are controlled: fixed by their plans, or actuated by who comes.
    #[arg(long, value_name = "WORD", default_value = "fixed", value_parser = words(SignalControl::ALL, SignalControl::name))]
    pub(crate) signals: SignalControl,
    #[command(flatten)]
    pub(crate) wanted: SimulateOutputs,
}

/// What a simulation is for; at least one.
#[derive(Debug, Args)]
#[group(required = true, multiple = true)]
pub(crate) struct SimulateOutputs {
    /// Write where everybody was: CSV, Parquet, or SUMO's FCD, by the file's ending.
    #[arg(long, value_name = "FILE.csv|.parquet|.fcd.xml", value_parser = PathBufValueParser::new().try_map(trajectories))]
    pub(crate) out: Option<OutputFile<TrajectoryFormat>>,
    /// Draw the map from above with all road users: a video, or a picture of the last instant.
    #[arg(long, value_name = "FILE.mp4|.png", value_parser = PathBufValueParser::new().try_map(top_view))]
    pub(crate) top_view: Option<OutputFile<TopViewFormat>>,
    /// Print what no street ever shows, with limits: contacts, jumps, stands, jerks, red lights run. Exit code 1 if a limit is
    /// not kept.
    #[arg(long)]
    pub(crate) audit: bool,
}

#[derive(Debug, Args)]
pub(crate) struct MapsArgs {
    #[command(subcommand)]
    pub(crate) command: Option<MapsCommand>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum MapsCommand {
    /// List the maps with their size, lanes, cameras and features (same as `endless maps`).
    List {
        /// Only these maps.
        maps: Vec<String>,
        /// Also list the cameras of each map.
        #[arg(long)]
        cameras: bool,
    },
    /// Draw a map from above, with the view of each of its cameras.
    Preview {
        /// Name of the map.
        map: String,
        /// The picture to write.
        #[arg(long, value_name = "FILE.png")]
        out: PathBuf,
    },
    /// Import an OpenDRIVE (.xodr) or OpenStreetMap (.osm, .osm.pbf) file as a map with a name.
    Import {
        /// The file.
        file: PathBuf,
        /// Name of the map [default: the file's name].
        #[arg(long)]
        name: Option<String>,
        /// The side of the road on which traffic drives [default: as the file or its country has it].
        #[arg(long, value_name = "left|right", value_parser = driving_side())]
        driving_side: Option<DrivingSide>,
        /// Replace an imported map of the same name.
        #[arg(long)]
        replace: bool,
    },
    /// Write a map to files of other formats.
    Export {
        /// Name of the map.
        map: String,
        #[command(flatten)]
        files: ExportFiles,
    },
}

#[derive(Debug, Args)]
pub(crate) struct AssetsArgs {
    #[command(subcommand)]
    pub(crate) command: Option<AssetsCommand>,
    /// Folder of glTF models with an assets.toml, to be part of the catalogue.
    #[arg(long, value_name = "DIR", global = true)]
    pub(crate) assets: Option<PathBuf>,
    /// Skip models that cannot be read, with a warning.
    #[arg(long, global = true)]
    pub(crate) skip_broken: bool,
}

#[derive(Debug, Subcommand)]
pub(crate) enum AssetsCommand {
    /// List the assets with their class, sizes and triangle counts (same as `endless assets`).
    List {
        /// Only assets of this class, or with this text in their name.
        filter: Option<String>,
    },
    /// Draw an asset from all sides.
    Preview {
        /// Name of the asset.
        name: String,
        /// Number of the variant: selects size, equipment and colours.
        #[arg(long, value_name = "N", default_value_t = 0)]
        variant: u64,
        /// The picture to write.
        #[arg(long, value_name = "FILE.png")]
        out: PathBuf,
    },
    /// Write an asset as binary glTF 2.0, which Blender opens.
    Export {
        /// Name of the asset.
        name: String,
        /// Number of the variant: selects size, equipment and colours.
        #[arg(long, value_name = "N", default_value_t = 0)]
        variant: u64,
        /// The file to write.
        #[arg(long, value_name = "FILE.glb")]
        out: PathBuf,
    },
}

/// Files to write; at least one.
#[derive(Debug, Args)]
#[group(required = true, multiple = true)]
pub(crate) struct ExportFiles {
    /// Write the roads as OpenDRIVE 1.6.
    #[arg(long, value_name = "FILE.xodr")]
    pub(crate) opendrive: Option<PathBuf>,
    /// Write the whole town as binary glTF 2.0, which Blender opens.
    #[arg(long, value_name = "FILE.glb")]
    pub(crate) gltf: Option<PathBuf>,
    /// Write lanes, crossings, sidewalks, signals, buildings and cameras as GeoJSON.
    #[arg(long, value_name = "FILE.geojson")]
    pub(crate) geojson: Option<PathBuf>,
}

#[derive(Debug, Args)]
pub(crate) struct CheckArgs {
    /// Folder of the dataset, or its address in object storage: then a video at a time comes to a temporary folder.
    pub(crate) out: PathBuf,
    /// Also tell which of so many shards make the videos that are missing.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=i64::from(Shard::MAX)))]
    pub(crate) shards: Option<u32>,
}

#[derive(Debug, Args)]
pub(crate) struct ExportArgs {
    /// Folder of the dataset. Videos that are not complete are left out.
    #[arg(required_unless_present = "list")]
    pub(crate) out: Option<PathBuf>,
    /// The format; `--list` tells of each.
    #[arg(long, value_name = "FORMAT", required_unless_present = "list", hide_possible_values = true)]
    #[arg(value_parser = words(Format::ALL, Format::name))]
    pub(crate) format: Option<Format>,
    /// Folder to write. The same command goes on with an export that was interrupted.
    #[arg(long, value_name = "DIR", required_unless_present = "list")]
    pub(crate) to: Option<PathBuf>,
    /// List the formats with the layers that each needs.
    #[arg(long)]
    pub(crate) list: bool,
    /// Parts and the share of each [default: train=0.8,val=0.2, and all for training where there is one video].
    #[arg(long, value_name = "NAME=SHARE,...")]
    pub(crate) split: Option<SplitShares>,
    /// What stays together in a part. A scene is never divided.
    #[arg(long, value_name = "WORD", default_value = "video", value_parser = words(SplitBy::ALL, SplitBy::name))]
    pub(crate) by: SplitBy,
    /// Classes of the export: `coco` for COCO's names and ids, or a TOML file that maps classes [default: the dataset's].
    #[arg(long, value_name = "coco|FILE.toml")]
    pub(crate) classes: Option<PathBuf>,
    /// Leave out objects of which less can be seen.
    #[arg(long, value_name = "0..1", default_value_t = 0.0, value_parser = share)]
    pub(crate) min_visibility: f64,
    /// Of the frames of each camera take every so many.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..))]
    pub(crate) stride: u32,
    /// Copy images.
    #[arg(long)]
    pub(crate) copy: bool,
    /// Link to the dataset's images, as is done by default.
    #[arg(long, conflicts_with = "copy")]
    pub(crate) link: bool,
}

#[derive(Debug, Args)]
pub(crate) struct StatsArgs {
    /// Folder of the dataset; several are counted as one.
    #[arg(required = true)]
    pub(crate) out: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) outputs: StatsOutputs,
}

#[derive(Debug, Args)]
pub(crate) struct CompareArgs {
    /// Folder of the first dataset.
    pub(crate) a: PathBuf,
    /// Folder of the second dataset; not needed with --coco.
    pub(crate) b: Option<PathBuf>,
    /// A dataset in COCO form: its file of detection labels. With two folders both are compared with it.
    #[arg(long, value_name = "FILE.json")]
    pub(crate) coco: Option<PathBuf>,
    /// Which of its categories are which classes: a TOML file of lines as `"delivery van" = "van"` or `train = "none"`
    /// [default: those of our names, COCO's person and other usual names].
    #[arg(long, value_name = "FILE.toml", requires = "coco")]
    pub(crate) coco_classes: Option<PathBuf>,
    #[command(flatten)]
    pub(crate) outputs: StatsOutputs,
}

/// Files to write; without any, text is printed.
#[derive(Debug, Args)]
pub(crate) struct StatsOutputs {
    /// Write all numbers as JSON.
    #[arg(long, value_name = "FILE.json")]
    pub(crate) json: Option<PathBuf>,
    /// Write one web page with charts, which needs nothing else.
    #[arg(long, value_name = "FILE.html")]
    pub(crate) html: Option<PathBuf>,
    /// Replace files that exist.
    #[arg(long)]
    pub(crate) force: bool,
    /// Look at one frame of so many, to be done sooner.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) stride: u32,
}

#[derive(Debug, Args)]
pub(crate) struct ViewArgs {
    /// Folder of the dataset.
    pub(crate) out: PathBuf,
    /// Port of the page; 0 for any that is free.
    #[arg(long, default_value_t = 0)]
    pub(crate) port: u16,
    /// Address on which to listen: this machine alone, unless another is given.
    #[arg(long, default_value = "127.0.0.1")]
    pub(crate) bind: std::net::IpAddr,
    /// Open the page in the browser.
    #[arg(long)]
    pub(crate) open: bool,
}

#[derive(Debug, Args)]
pub(crate) struct BenchArgs {
    /// Seconds of video to record [default: 2; with --scaling 0.5, and 1 a thread where threads grow].
    #[arg(long, value_name = "S")]
    pub(crate) duration: Option<f64>,
    /// Image size [default: 1280x720; with --scaling 640x360, and up to 1920x1080 where pixels grow].
    #[arg(long, value_name = "WxH")]
    pub(crate) size: Option<String>,
    /// Cameras that film each scene [default: 2; with --rig none].
    #[arg(long, value_name = "N")]
    pub(crate) cameras_per_scene: Option<i64>,
    /// Layers to store [default: rgb,depth,instance].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) layers: Option<Vec<String>>,
    /// Record the sensors of a rig, too, and tell what each costs; TOML or JSON, as for generate.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["conditions", "scaling"])]
    pub(crate) rig: Option<PathBuf>,
    /// Record each of the fifteen conditions, each in the next town, and compare them.
    #[arg(long)]
    pub(crate) conditions: bool,
    /// Let one thing after another grow, and compare what that costs [default: all of the list].
    #[arg(long, value_name = "LIST", value_delimiter = ',', num_args = 0..=1, conflicts_with = "conditions")]
    pub(crate) scaling: Option<Vec<ScalingSeries>>,
    /// Export a dataset to every format, and tell what each costs [default: one that is recorded for it].
    #[arg(long, value_name = "OUT", num_args = 0..=1, conflicts_with_all = ["conditions", "scaling", "rig"])]
    pub(crate) export: Option<Option<PathBuf>>,
    /// Towns to record; with --conditions each condition in all of them; with --scaling the first, and all where towns are
    /// compared [default: any; with --conditions one per condition].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) maps: Option<Vec<String>>,
    /// Weathers to record [default: clear_sky, with --conditions all].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) weathers: Option<Vec<String>>,
    /// Times of day to record [default: afternoon, with --conditions all].
    #[arg(long, value_name = "LIST", value_delimiter = ',')]
    pub(crate) times: Option<Vec<String>>,
}

/// A TrafficManager's address; 8000 is its usual port.
fn traffic_manager(text: &str) -> Result<Address, String> {
    Address::with_port(text, 8000)
}

/// A file of trajectories.
fn trajectories(path: PathBuf) -> Result<OutputFile<TrajectoryFormat>, &'static str> {
    let format = TrajectoryFormat::of(&path).ok_or("end its name in .csv, .parquet or .fcd.xml")?;
    Ok(OutputFile { path, format })
}

/// A picture or a video.
fn top_view(path: PathBuf) -> Result<OutputFile<TopViewFormat>, &'static str> {
    let format = TopViewFormat::of(&path).ok_or("end its name in .mp4 or .png")?;
    Ok(OutputFile { path, format })
}

/// A rate of instants.
fn rate(text: &str) -> Result<f64, String> {
    let rate = text.parse::<f64>().ok().filter(|rate| (0.1..=240.0).contains(rate));
    rate.ok_or_else(|| "give 0.1 to 240 a second".to_owned())
}

/// A name as Kubernetes has them, which Slurm takes too.
fn job_name(text: &str) -> Result<String, &'static str> {
    let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
    let good =
        (1..=50).contains(&text.len()) && text.chars().all(plain) && !text.starts_with('-') && !text.ends_with('-');
    good.then(|| text.to_owned()).ok_or("give lower-case letters, digits and dashes between them, 50 at most")
}

/// A word that stands in a line of options.
fn slurm_word(text: &str) -> Result<String, &'static str> {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_:.,+".contains(c);
    let good = !text.is_empty() && text.chars().all(plain);
    good.then(|| text.to_owned()).ok_or("give one word of letters, digits and -_:.,+")
}

fn share(text: &str) -> Result<f64, String> {
    let share = text.parse::<f64>().ok().filter(|share| (0.0..=1.0).contains(share));
    share.ok_or_else(|| "give 0 to 1".to_owned())
}

/// One of these words.
fn words<T: Copy + Send + Sync + 'static>(
    all: &'static [T],
    name: fn(T) -> &'static str,
) -> impl TypedValueParser<Value = T> {
    PossibleValuesParser::new(all.iter().map(|&word| name(word)))
        .map(move |given| all.iter().copied().find(|&word| name(word).eq_ignore_ascii_case(&given)).unwrap_or(all[0]))
}

/// A time that can be waited for.
fn seconds(text: &str) -> Result<f64, String> {
    let seconds = text.parse::<f64>().ok().filter(|seconds| (0.1..=86_400.0).contains(seconds));
    seconds.ok_or_else(|| "give 0.1 to 86400 seconds".to_owned())
}

fn byte_size(text: &str) -> Result<ByteSize, &'static str> {
    text.parse().ok().ok_or("write a number and a unit, as in 500MB or 4GiB")
}

fn driving_side() -> impl TypedValueParser<Value = DrivingSide> {
    let sides = [DrivingSide::Left, DrivingSide::Right];
    PossibleValuesParser::new(sides.map(DrivingSide::name))
        .map(move |name| if name == sides[0].name() { sides[0] } else { sides[1] })
}
