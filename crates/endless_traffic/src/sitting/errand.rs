//! What somebody has to do with a bench: the seat that they have chosen, and how far they have come with it.

use super::places::BenchPlace;
use glam::DVec2;

/// Knees of who sits are so far ahead of them, metres.
const KNEES_M: f64 = 0.4;
/// After a rest nobody sits down again for so long, seconds.
pub(super) const AGAIN_S: f64 = 180.0;

/// Somebody's rest.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rest {
    pub(crate) place: BenchPlace,
    pub(super) phase: Phase,
    /// How long they have been in this phase, seconds.
    pub(super) since_s: f64,
    /// For how long they will sit, seconds.
    pub(crate) left_s: f64,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Phase {
    /// Along the sidewalk.
    Comes,
    /// From the sidewalk to before the seat.
    Leaves,
    Turns,
    /// Share of the way, 0 to 1.
    SitsDown(f64),
    Sits,
    GetsUp(f64),
    /// To the sidewalk.
    Returns,
}

impl Rest {
    /// Of somebody who has chosen a seat.
    pub(crate) fn chosen(place: BenchPlace, left_s: f64) -> Self {
        Self { place, phase: Phase::Comes, since_s: 0.0, left_s }
    }

    /// Whether they have left the sidewalk.
    pub(crate) fn is_at_bench(&self) -> bool {
        self.phase != Phase::Comes
    }

    /// Share of the way up from the seat, while they are on it or between it and a stand.
    pub(super) fn risen(&self) -> Option<f64> {
        match self.phase {
            Phase::SitsDown(share) => Some(1.0 - eased(share)),
            Phase::GetsUp(share) => Some(eased(share)),
            Phase::Sits => Some(0.0),
            _ => None,
        }
    }

    /// Where the knees of who sits are in others' way.
    pub(crate) fn knees(&self) -> Option<DVec2> {
        (self.phase == Phase::Sits).then(|| self.place.at.truncate() + self.place.facing * KNEES_M)
    }

    pub(super) fn to(self, phase: Phase) -> Option<Self> {
        Some(Self { phase, since_s: 0.0, ..self })
    }
}

/// Smoothly from 0 to 1.
pub(super) fn eased(share: f64) -> f64 {
    let u = share.clamp(0.0, 1.0);
    u * u * u * (10.0 + u * (6.0 * u - 15.0))
}
