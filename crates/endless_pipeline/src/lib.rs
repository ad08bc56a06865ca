//! From recipe to dataset: the plan of its scenes, their simulation, recording and resume. The one crate that depends on
//! all others.
//!
//! A [`RecipeDraft`](endless_dataset::RecipeDraft) holds the options that a user gave. With the maps of a [`MapSource`]
//! it resolves to a recipe ([`resolve_recipe`]), and [`Plan`] makes the settings of every scene from it. [`generate`]
//! records the scenes with a [`Simulator`]: for each scene it opens a [`SimulationSession`], which yields world states with
//! their render tasks, and writes images, labels and videos. [`BuiltinSimulator`] is the built-in city.
//!
//! ```
//! use endless_dataset::RecipeDraft;
//! use endless_pipeline::{MapCatalog, MapSource, Plan, SimulatorError, resolve_recipe};
//! use endless_world::{CameraSite, LensModel, Mount};
//!
//! /// One map with four cameras.
//! struct Square;
//!
//! impl MapSource for Square {
//!     fn maps(&self) -> Vec<String> {
//!         vec!["Square".to_owned()]
//!     }
//! }
//!
//! impl MapCatalog for Square {
//!     fn cameras(&self, _map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
//!         let site = |corner: u8| CameraSite {
//!             name: format!("corner_{corner}"),
//!             position: [20.0 * f32::from(corner), 0.0, 8.0],
//!             yaw_rad: 1.6,
//!             down_tilt_rad: 0.4,
//!             horizontal_fov_rad: 1.2,
//!             lens: LensModel::Pinhole,
//!             mount: Mount::Pole,
//!             roll_rad: 0.0,
//!         };
//!         Ok((0..4).map(site).collect())
//!     }
//! }
//!
//! let draft = RecipeDraft { videos: Some(5), cameras_per_scene: Some(3), ..RecipeDraft::default() };
//! let recipe = resolve_recipe(draft, &Square)?;
//! let plan = Plan::new(&recipe, &Square)?;
//! assert_eq!(plan.scenes.len(), 5);
//! assert!(plan.scenes.iter().all(|scene| scene.map == "Square" && scene.cameras.len() == 3));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod builtin;
mod disk_estimate;
mod error;
mod generate;
mod list_file;
mod measurements;
mod plan;
mod progress;
mod rates;
mod recipe;
mod record;
mod rig;
mod shard;
mod simulator;
mod simulator_error;
mod store;
mod streaming;
#[cfg(test)]
mod test_catalog;
mod text_position;
mod user_camera;

pub use builtin::{BakeCache, BuiltinMap, BuiltinSimulator, SceneBoxes};
pub use disk_estimate::DiskEstimate;
pub use error::{GenerateError, PlanError, RecipeError, human_bytes};
pub use generate::{GenerateOptions, Generated, generate, generate_into};
pub use plan::Plan;
pub use progress::{Progress, ProgressEvent, SilentProgress};
pub use rates::{Forecast, RateOptions, RateSample, Rates, VideoForecast, measure_rates};
pub use recipe::{read_recipe, recipe_from_text, resolve_recipe};
pub use record::{SensorTimes, StageTimes};
pub use rig::read_rig;
pub use shard::Shard;
pub use simulator::{
    Capabilities, MapCatalog, MapSource, MapUse, RenderStats, RenderTask, SceneBodies, SceneTruth, SensorReading,
    SimulationSession, SimulationStep, Simulator, SiteRequest, TrackFileSummary,
};
pub use simulator_error::SimulatorError;
pub use store::{DatasetStore, FolderStore, StoreError, StoredFiles};
pub use streaming::{
    Measurement, StreamEnd, StreamOptions, StreamOrder, StreamedCamera, StreamedFrame, StreamedSensor, StreamedVideo,
    stream,
};
pub use user_camera::{cameras_from_text, read_cameras};
