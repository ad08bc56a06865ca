//! Recipe → plan → scenes → record → resume: the one place where all crates meet.

mod builtin;
mod camera_list;
mod disk_estimate;
mod error;
mod generate;
mod plan;
mod progress;
mod recipe;
mod record;
mod simulator;
mod simulator_error;
mod text_position;

pub use builtin::{BuiltinMap, BuiltinSimulator};
pub use camera_list::{OwnCamera, read_cameras};
pub use disk_estimate::Estimate;
pub use error::{GenerateError, PlanError, RecipeError, human_bytes};
pub use generate::{GenerateOptions, Generated, generate};
pub use plan::Plan;
pub use progress::{Event, Progress, Silent};
pub use recipe::{OptionDefault, OptionKind, RecipeDraft, RecipeOption, Vocabulary, recipe_schema};
pub use record::StageTimes;
pub use simulator::{
    Capabilities, MapCatalog, MapSource, RenderStats, RenderTask, SceneTruth, SimulationSession, SimulationStep,
    Simulator,
};
pub use simulator_error::SimulatorError;
