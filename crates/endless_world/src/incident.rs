//! Traffic incidents that a recipe asks for, and what is told of those that were staged.

use crate::{InstanceId, UnknownName};
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// What goes wrong on a street.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum IncidentKind {
    /// One drives into another.
    Collision,
    /// Two almost touch: one brakes for nothing, and who follows takes notice late.
    NearMiss,
    /// A driver takes no notice of a red light.
    RedLightRun,
    /// A vehicle drives on the lane of those who come the other way.
    WrongWay,
    /// A vehicle breaks down and stands in its lane, hazard lights on.
    Stalled,
    /// Somebody on foot crosses the road away from crossings.
    Jaywalk,
    /// Somebody on a two-wheeler falls.
    FallenRider,
    /// A vehicle stops at the edge of a driving lane, hazard lights on.
    IllegalParking,
    /// A queue reaches back to the junction behind it.
    QueueSpillback,
}

impl IncidentKind {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("event", given, Self::ALL)
    }
}

/// An incident that was staged in a scene, as it was simulated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Incident {
    /// Its kind.
    pub kind: IncidentKind,
    /// Who takes part, the one who causes it first.
    pub actors: Vec<InstanceId>,
    /// The first frame in which it happens.
    pub begin_frame: u32,
    /// The last one.
    pub end_frame: u32,
    /// Where the one who causes it is in the first frame, world frame, metres.
    pub position: [f32; 3],
    /// The least time to collision of one of them with anybody from a second before it to a second after it, seconds; none
    /// if it was never below ten.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub time_to_collision_s: Option<f64>,
    /// The least post-encroachment time of one of them and anybody in the same span, seconds; none if it was never below
    /// five.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub post_encroachment_s: Option<f64>,
}

/// What came of the incidents that a scene asks for.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StagedIncidents {
    /// Those that happen, in the order in which they were asked for.
    pub incidents: Vec<Incident>,
    /// Those that could not be had where cameras look.
    pub missed: Vec<IncidentKind>,
}
