//! Relations between road users at an instant, and events: what happens from one instant to the next.
//!
//! Both follow from world states and a few [`RoadFacts`] alone, so that any simulator that knows these can tell them.

mod conflict;
mod detector;
mod footprint;
mod relations;
mod road;
mod road_user;
#[cfg(test)]
mod tests;

pub use conflict::{ENCROACHMENT_S, NEAR_MISS_S};
pub use detector::{Event, EventDetector, HARD_BRAKING_MPS2};
pub use footprint::Footprint;
pub use relations::{Relation, relations};
pub use road::{LaneCrossing, LaneFacts, RoadFacts};
