//! Where an OpenDRIVE road lies: reference line, profiles, lane borders, and how densely to sample them.

mod curve;
mod profile;
mod road;
mod section;

pub(crate) use curve::{PlanViewCurve, PlanViewPose};
pub(crate) use road::RoadShape;
pub(crate) use section::{LaneShape, SectionShape};
