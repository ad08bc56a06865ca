//! An instant at which an incident may be set off, and who could be made to do what.

use super::order::Order;
use super::road_walk::RoadWalk;
use crate::actuated::ActuatedSignals;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::signals;
use crate::vehicle::Vehicle;
use crate::walker::Walker;
use endless_road::JunctionId;
use endless_world::{SignalAspect, SignalId};

/// An instant at which an incident may be set off.
pub(crate) struct Moment<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) occupancy: &'a Occupancy,
    pub(crate) vehicles: &'a [Vehicle],
    pub(crate) walkers: &'a [Walker],
    /// Whether each vehicle, and each person on foot, is seen or soon will be.
    pub(crate) watched: [&'a [bool]; 2],
    /// Scene time, seconds.
    pub(crate) time_s: f64,
    /// Signals that follow traffic: what they will show, nobody knows.
    pub(crate) actuated: Option<&'a ActuatedSignals>,
}

impl Moment<'_> {
    /// Vehicles that are seen or soon will be, with their numbers; those apart that halt at the kerb.
    pub(super) fn watched(&self) -> impl Iterator<Item = (usize, &Vehicle)> {
        self.vehicles
            .iter()
            .enumerate()
            .zip(self.watched[0])
            .filter(|((_, vehicle), watched)| **watched && vehicle.kerb_halt.is_none())
            .map(|(vehicle, _)| vehicle)
    }

    /// People on foot who are seen, with their numbers.
    pub(super) fn watched_walkers(&self) -> impl Iterator<Item = (usize, &Walker)> {
        self.walkers
            .iter()
            .enumerate()
            .zip(self.watched[1])
            .filter(|((_, walker), watched)| **watched && walker.bus.ride.is_none() && !walker.is_at_bench())
            .map(|(walker, _)| walker)
    }

    /// Whether a signal is red at both of these times, seconds from now; one that follows traffic counts as what it shows.
    pub(super) fn is_red(&self, signal: SignalId, after_s: [f64; 2]) -> bool {
        if let Some(actuated) = self.actuated {
            return after_s.into_iter().all(|after_s| actuated.is_red(signal, after_s));
        }
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
    /// Who goes over the road.
    pub(crate) walk: Option<(usize, RoadWalk)>,
    /// Where it happens, if at a junction.
    pub(crate) junction: Option<JunctionId>,
    /// How far ahead of the one who causes it, about, metres.
    pub(crate) ahead_m: f64,
}
