//! What can be wrong with a network.

use crate::{CrossingId, JunctionId, LaneId, WalkEdgeId};
use endless_world::SignalId;

/// Why a network was refused; names what is wrong and where.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum NetworkError {
    /// A lane's id is not its place in the list.
    #[error("lane at place {place} calls itself {id:?}")]
    LaneId {
        /// Its place.
        place: usize,
        /// Its id.
        id: LaneId,
    },
    /// A lane names a lane that does not exist.
    #[error("lane {lane:?} names lane {named:?}, which does not exist")]
    UnknownLane {
        /// Where.
        lane: LaneId,
        /// The id that it names.
        named: LaneId,
    },
    /// Width or speed limit is not positive and finite.
    #[error("lane {lane:?} has {what} {value}, which must be positive")]
    NotPositive {
        /// Where.
        lane: LaneId,
        /// What.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A successor does not begin where the lane ends.
    #[error("lane {lane:?} ends {gap_m:.3} m from the beginning of its successor {successor:?} (at most {most_m} m)")]
    Gap {
        /// Where.
        lane: LaneId,
        /// The successor.
        successor: LaneId,
        /// Distance found, metres.
        gap_m: f64,
        /// Distance allowed, metres.
        most_m: f64,
    },
    /// A successor begins in another direction than the lane ends.
    #[error("lane {lane:?} meets its successor {successor:?} at {angle_deg:.1}° (at most {most_deg}°)")]
    Kink {
        /// Where.
        lane: LaneId,
        /// The successor.
        successor: LaneId,
        /// Angle found, degrees.
        angle_deg: f64,
        /// Angle allowed, degrees.
        most_deg: f64,
    },
    /// Lane and junction do not agree on who belongs to whom.
    #[error("lane {lane:?} and junction {junction:?} disagree on whether the lane lies in the junction")]
    Membership {
        /// The lane.
        lane: LaneId,
        /// The junction.
        junction: JunctionId,
    },
    /// A signal id at or beyond `signal_groups`.
    #[error("{user} uses signal {signal:?}, but there are {groups} groups")]
    UnknownSignal {
        /// Its user.
        user: String,
        /// The id.
        signal: SignalId,
        /// Number of groups.
        groups: u16,
    },
    /// A program without phases, or with a phase that takes no time.
    #[error("the program of junction {junction:?} has no phases, or one without a positive duration")]
    Program {
        /// Where.
        junction: JunctionId,
    },
    /// A crossing that crosses no lane.
    #[error("crossing {crossing:?} cuts no lane")]
    CutsNothing {
        /// Which.
        crossing: CrossingId,
    },
    /// A walk edge names a node or a crossing that does not exist, or joins a node to itself.
    #[error("walk edge {edge:?} names a node or crossing that does not exist, or joins a node to itself")]
    WalkEdge {
        /// Which.
        edge: WalkEdgeId,
    },
}

/// Words of others, or of a file, as a part of a message of one line.
pub(crate) fn one_line(text: &str) -> String {
    const MOST: usize = 160;
    let plain: String = text.chars().map(|c| if c.is_control() { ' ' } else { c }).take(MOST + 1).collect();
    match plain.char_indices().nth(MOST) {
        Some((at, _)) => format!("{}...", &plain[..at]),
        None => plain,
    }
}
