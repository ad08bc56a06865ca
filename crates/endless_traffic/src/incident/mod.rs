//! Traffic incidents on request: what goes wrong on a street is made to happen where cameras look.
//!
//! A scene's future follows from its state alone, so an incident can be rehearsed in a copy of the simulation: candidates
//! (who, what, from which frame on) are tried one after the other, and the first is staged that happens in sight, meets its
//! definition and has nobody touch anybody. Each kind has a file that tells who could be made to do what (`candidates`) and
//! whether it happens at an instant (`happens`). Orders act through few hooks of drivers; all others see no more than what
//! happens before them.
//!
//! ```text
//! candidates ─► rehearsal (a copy, to the last frame) ─► staged: orders at their frame, label
//!                                                           │
//! world states ─► detector (poses, signals, map alone) ─────┴─► do both agree?
//! ```

mod conflict;
mod detector;
mod illegal_parking;
mod near_miss;
mod order;
mod red_light_run;
mod rehearsal;
mod stalled;
mod standing;

pub use detector::{DetectedIncident, IncidentDetector};
pub(crate) use order::Order;
pub(crate) use rehearsal::Rehearsal;

use crate::focus::Focus;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::settings::DrivingCondition;
use crate::signals;
use crate::vehicle::Vehicle;
use endless_road::JunctionId;
use endless_world::{IncidentKind, InstanceId, SignalAspect, SignalId};

/// The incidents that a scene is to have.
pub struct IncidentRequest<'a> {
    /// One of each, in this order.
    pub kinds: &'a [IncidentKind],
    /// Frames that will be recorded.
    pub frames: u32,
    /// What is drawn follows from it.
    pub seed: u64,
    /// They happen where it is seen; anywhere, if nothing is.
    pub sight: &'a Focus,
    /// Weather and light of each frame.
    pub condition: &'a dyn Fn(u32) -> DrivingCondition,
}

/// An instant at which an incident may be set off.
pub(crate) struct Moment<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) occupancy: &'a Occupancy,
    pub(crate) vehicles: &'a [Vehicle],
    /// Scene time, seconds.
    pub(crate) time_s: f64,
}

impl Moment<'_> {
    /// Whether a signal is red at both of these times, seconds from now.
    fn is_red(&self, signal: SignalId, after_s: [f64; 2]) -> bool {
        let mut aspects = Vec::new();
        after_s.into_iter().all(|after_s| {
            signals::aspects_at(&self.roads.network, self.time_s + after_s, &mut aspects);
            aspects[usize::from(signal.0)].aspect == SignalAspect::Red
        })
    }
}

/// Who could be made to do what; the one who causes the incident comes first.
#[derive(Debug, Clone)]
pub(crate) struct Candidate {
    pub(crate) roles: Vec<(usize, Order)>,
    /// Where it happens, if at a junction.
    pub(crate) junction: Option<JunctionId>,
    /// How far ahead of the one who causes it, about, metres.
    pub(crate) ahead_m: f64,
}

/// Everybody who could.
pub(crate) fn candidates(kind: IncidentKind, moment: &Moment<'_>) -> Vec<Candidate> {
    match kind {
        IncidentKind::NearMiss => near_miss::candidates(moment),
        IncidentKind::RedLightRun => red_light_run::candidates(moment),
        IncidentKind::Stalled => stalled::candidates(moment),
        IncidentKind::IllegalParking => illegal_parking::candidates(moment),
    }
}

/// An incident with the frame at which its orders are given.
#[derive(Debug, Clone)]
pub(crate) struct StagedIncident {
    pub(crate) kind: IncidentKind,
    pub(crate) frame: u32,
    pub(crate) roles: Vec<(InstanceId, Order)>,
    pub(crate) junction: Option<JunctionId>,
    pub(crate) label: Label,
}

/// The frames in which an incident happens.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Label {
    pub(crate) begin_frame: Option<u32>,
    pub(crate) end_frame: Option<u32>,
    /// Frames in which others make it happen: it is not what it seems.
    pub(crate) held: u32,
}

impl StagedIncident {
    /// Whether it is not over when the recording ends.
    pub(crate) fn lasts(&self) -> bool {
        matches!(self.kind, IncidentKind::Stalled | IncidentKind::IllegalParking)
    }

    /// Takes notice of an instant. `actors`: who has a role, as long as they are on the map.
    pub(crate) fn note(&mut self, frame: u32, moment: &Moment<'_>, actors: &[Option<usize>]) {
        let Some(actors) = actors.iter().copied().collect::<Option<Vec<usize>>>() else { return };
        let begun = self.label.begin_frame.is_some();
        let happens = match self.kind {
            IncidentKind::NearMiss => near_miss::happens(moment, &actors),
            IncidentKind::RedLightRun => red_light_run::happens(moment, &actors, self.junction, begun),
            IncidentKind::Stalled | IncidentKind::IllegalParking => standing::happens(moment, &actors),
        };
        let stands = matches!(self.kind, IncidentKind::Stalled | IncidentKind::IllegalParking);
        if happens {
            self.label.held += u32::from(stands && standing::is_held(moment, &actors));
            self.label.begin_frame.get_or_insert(frame);
            self.label.end_frame = Some(frame);
        }
    }
}
