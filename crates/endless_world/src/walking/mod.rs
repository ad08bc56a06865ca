//! How people walk: the law by which steps lengthen with speed, and feet that stay where they stand.
//!
//! Traffic moves feet along with bodies ([`Footsteps`]), and bodies are posed over the feet by the same law
//! ([`StepPhase`], [`stride_m`], [`foot_home`]), so that nobody's feet slide.

mod footsteps;
mod pedestrian;
mod step;

pub use footsteps::Footsteps;
pub use pedestrian::{Mobility, PedestrianSpec};
pub use step::{SIDES, StepPhase, average_speed_mps, duty_factor, foot_home, running_share, stride_m};
