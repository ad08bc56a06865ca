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

mod collision;
mod conflict;
mod detector;
mod fallen_rider;
mod following;
mod illegal_parking;
pub(crate) mod impact;
mod jaywalk;
mod moment;
mod near_miss;
mod order;
mod queue_spillback;
mod red_light_run;
mod rehearsal;
mod road_walk;
pub(crate) mod road_walker;
mod sliding_body;
mod stalled;
mod standing;
pub(crate) mod wrong_way;

pub use detector::{DetectedIncident, IncidentDetector};
pub(crate) use moment::{Candidate, Moment};
pub(crate) use order::{Drift, Order};
pub(crate) use rehearsal::Rehearsal;
pub(crate) use road_walk::RoadWalk;

use crate::focus::Focus;
use crate::settings::DrivingCondition;
use endless_road::JunctionId;
use endless_world::{IncidentKind, InstanceId};

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

/// Everybody who could.
pub(crate) fn candidates(kind: IncidentKind, moment: &Moment<'_>) -> Vec<Candidate> {
    match kind {
        IncidentKind::Collision => collision::candidates(moment),
        IncidentKind::NearMiss => near_miss::candidates(moment),
        IncidentKind::RedLightRun => red_light_run::candidates(moment),
        IncidentKind::WrongWay => wrong_way::candidates(moment),
        IncidentKind::Stalled => stalled::candidates(moment),
        IncidentKind::Jaywalk => jaywalk::candidates(moment),
        IncidentKind::FallenRider => fallen_rider::candidates(moment),
        IncidentKind::IllegalParking => illegal_parking::candidates(moment),
        IncidentKind::QueueSpillback => queue_spillback::candidates(moment),
    }
}

/// An incident with the frame at which its orders are given.
#[derive(Debug, Clone)]
pub(crate) struct StagedIncident {
    pub(crate) kind: IncidentKind,
    pub(crate) frame: u32,
    pub(crate) roles: Vec<(InstanceId, Order)>,
    pub(crate) walk: Option<(InstanceId, RoadWalk)>,
    pub(crate) junction: Option<JunctionId>,
    pub(crate) label: Label,
}

/// The frames in which an incident happens.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Label {
    pub(crate) begin_frame: Option<u32>,
    pub(crate) end_frame: Option<u32>,
    /// Frames from the first to the last in which it happens.
    pub(crate) frames: u32,
    /// Frames in which others make it happen: it is not what it seems.
    pub(crate) held: u32,
}

impl StagedIncident {
    /// Everybody who takes part, the one who causes it first.
    pub(crate) fn actors(&self) -> Vec<InstanceId> {
        self.walk.iter().map(|(id, _)| *id).chain(self.roles.iter().map(|(id, _)| *id)).collect()
    }

    /// Whether it is not over when the recording ends.
    pub(crate) fn lasts(&self) -> bool {
        use IncidentKind::{FallenRider, IllegalParking, QueueSpillback, Stalled};
        matches!(self.kind, Stalled | FallenRider | IllegalParking | QueueSpillback)
    }

    /// Shorter ones are none worth telling of, seconds.
    pub(crate) fn least_s(&self) -> f64 {
        match self.kind {
            IncidentKind::WrongWay | IncidentKind::Jaywalk => 1.5,
            IncidentKind::Collision => 0.4,
            IncidentKind::RedLightRun => 1.0,
            _ => 0.0,
        }
    }

    /// Whether these two collide because of it.
    pub(crate) fn collides(&self, pair: [InstanceId; 2]) -> bool {
        let takes_part = |id: &InstanceId| self.roles.iter().any(|(role, _)| role == id);
        self.kind == IncidentKind::Collision && pair.iter().all(takes_part)
    }

    /// Takes notice of an instant. `actors`: who has a role, as long as they are on the map; `walker`: who goes over the road.
    pub(crate) fn note(&mut self, frame: u32, moment: &Moment<'_>, actors: &[Option<usize>], walker: Option<usize>) {
        let Some(actors) = actors.iter().copied().collect::<Option<Vec<usize>>>() else { return };
        let begun = self.label.begin_frame.is_some();
        let happens = match self.kind {
            IncidentKind::Collision => collision::happens(moment, &actors),
            IncidentKind::NearMiss => near_miss::happens(moment, &actors),
            IncidentKind::RedLightRun => red_light_run::happens(moment, &actors, self.junction, begun),
            IncidentKind::WrongWay => wrong_way::happens(moment, &actors),
            IncidentKind::Jaywalk => walker.is_some_and(|walker| jaywalk::happens(&moment.walkers[walker])),
            IncidentKind::FallenRider => fallen_rider::happens(moment, &actors),
            IncidentKind::QueueSpillback => queue_spillback::happens(moment, &actors),
            IncidentKind::Stalled => standing::happens(moment, &actors),
            IncidentKind::IllegalParking => {
                standing::happens(moment, &actors) && illegal_parking::is_aside(moment, &actors)
            }
        };
        use IncidentKind::{IllegalParking, QueueSpillback, Stalled};
        let stands = matches!(self.kind, Stalled | IllegalParking | QueueSpillback);
        if happens {
            self.label.held += u32::from(stands && standing::is_held(moment, &actors));
            self.label.frames += 1;
            self.label.begin_frame.get_or_insert(frame);
            self.label.end_frame = Some(frame);
        }
    }
}
