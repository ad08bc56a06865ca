//! How long the videos of a plan take on this machine and how large they become, from a few frames of a few of them.

mod choice;
mod forecast;
mod measure;
mod sample;

pub use forecast::{Forecast, VideoForecast};
pub use measure::{RateOptions, measure_rates};
pub use sample::{RateSample, Rates};
