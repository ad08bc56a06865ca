//! Incidents: rehearsed in copies of the simulation, then staged.

use super::Simulation;
use crate::incident::{Candidate, IncidentRequest, Label, Moment, Rehearsal, StagedIncident, candidates};
use crate::occupancy::Occupancy;
use crate::playback::PlayedTracks;
use crate::roads::TrafficMap;
use crate::settings::{DrivingCondition, Fleet, TrafficSettings};
use crate::vehicle::Vehicle;
use crate::walker::Walker;
use endless_world::{Incident, IncidentKind, InstanceId, ParkedVehicle, StagedIncidents, Stream, TooManyInstances};

/// So often traffic is drawn, until all incidents can be had.
const DRAWS: u64 = 12;
/// The shares of a recording within which orders are given.
const GIVEN: [f64; 2] = [0.05, 0.65];
/// Candidates are looked for so often, seconds.
const EVERY_S: f64 = 0.3;
/// So many candidates are tried of an instant, and so many in all, for each incident.
const TRIED_AT_ONCE: usize = 4;
const TRIED: usize = 120;
/// Vehicles soon come to where it is seen if one of these places ahead is, metres.
const SOON_M: [f64; 4] = [0.0, 20.0, 40.0, 60.0];
/// Traffic is looked at for so long after one is over, seconds.
const SETTLES_S: f64 = 20.0;
/// An incident begins within this after its orders, seconds.
const BEGINS_WITHIN_S: f64 = 12.0;

impl Simulation {
    /// As [`Self::playing`], with incidents. Where one cannot be had, other traffic is drawn of the same settings, a dozen times
    /// at most; the first is taken if none has all.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Panics
    /// As [`Self::new`].
    pub fn with_incidents(
        map: &TrafficMap,
        fleet: &Fleet<'_>,
        parked: &[ParkedVehicle],
        settings: &TrafficSettings,
        played: Option<&PlayedTracks<'_>>,
        request: &IncidentRequest<'_>,
    ) -> Result<(Self, StagedIncidents), TooManyInstances> {
        let make = |seed: u64| -> Result<(Self, StagedIncidents), TooManyInstances> {
            let settings = TrafficSettings { seed, ..settings.clone() };
            let mut simulation = Self::playing(map, fleet, parked, &settings, played)?;
            let staged = simulation.stage(request);
            Ok((simulation, staged))
        };
        let first = make(settings.seed)?;
        if first.1.missed.is_empty() {
            return Ok(first);
        }
        for draw in 1..DRAWS {
            let other = make(Stream::named(settings.seed, "traffic.incident.again", &[draw]).next_u64())?;
            if other.1.missed.is_empty() {
                return Ok(other);
            }
        }
        Ok(first)
    }

    /// Stages incidents in the frames to come: each is drawn among those that happen in sight of the request's views in a
    /// rehearsal. Call it before the first tick, with the weather that there will be.
    pub fn stage(&mut self, request: &IncidentRequest<'_>) -> StagedIncidents {
        let mut result = StagedIncidents::default();
        for (number, &kind) in request.kinds.iter().enumerate() {
            let stream = Stream::named(request.seed, "traffic.incident", &[number as u64]);
            match self.stage_one(kind, request, stream) {
                Some(incidents) => result.incidents = incidents,
                None => result.missed.push(kind),
            }
        }
        result
    }

    /// Finds a candidate with which everything happens as it should, and stages it. Gives all that is staged then.
    fn stage_one(
        &mut self,
        kind: IncidentKind,
        request: &IncidentRequest<'_>,
        mut stream: Stream,
    ) -> Option<Vec<Incident>> {
        let [earliest, latest] = GIVEN.map(|share| (share * f64::from(request.frames)).ceil() as u32);
        let first = earliest + stream.below((latest - earliest + 1) as usize) as u32;
        let every = (EVERY_S * self.fps).round().max(1.0) as u32;
        let mut tried = 0;
        for (from, to) in [(first, latest + 1), (earliest, first)] {
            let mut now = self.clone();
            let mut next = from;
            while now.frame < to {
                if now.frame >= next {
                    next += every;
                    let mut found = now.candidates(kind, request);
                    stream.shuffle(&mut found);
                    for candidate in found.into_iter().take(TRIED_AT_ONCE) {
                        if tried == TRIED {
                            return None;
                        }
                        tried += 1;
                        let incident = now.with_orders(kind, candidate);
                        if let Some(incidents) = now.rehearse(incident.clone(), request) {
                            self.staged.push(incident);
                            return Some(incidents);
                        }
                    }
                }
                now.go_on(request.condition);
            }
        }
        None
    }

    fn go_on(&mut self, condition: &dyn Fn(u32) -> DrivingCondition) {
        self.set_condition(condition(self.frame + 1));
        self.tick();
    }

    /// Those who could cause an incident from now on, on a way that is seen.
    fn candidates(&self, kind: IncidentKind, request: &IncidentRequest<'_>) -> Vec<Candidate> {
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&self.roads, &self.vehicles);
        let sight = request.sight;
        let everywhere = sight.views().is_empty();
        let seen = |vehicle: &Vehicle, metres: f64| {
            let place = vehicle.ahead(&self.roads).take_while(|(_, base)| *base <= metres).last();
            place.is_some_and(|(lane, base)| sight.on_lane(lane.index(), metres - base) != 0)
        };
        let soon = |vehicle: &Vehicle| everywhere || SOON_M.iter().any(|&metres| seen(vehicle, metres));
        let shown =
            |walker: &Walker| everywhere || sight.shows(walker.position.extend(walker.height + 1.0).as_vec3(), true);
        let vehicles: Vec<bool> = self.vehicles.iter().map(soon).collect();
        let walkers: Vec<bool> = self.walkers.iter().map(shown).collect();
        let mut found = candidates(kind, &self.moment(&occupancy, [&vehicles, &walkers]));
        let soon_seen = |candidate: &Candidate| {
            let cause = candidate.roles.first();
            everywhere || cause.is_none_or(|(cause, _)| seen(&self.vehicles[*cause], candidate.ahead_m))
        };
        found.retain(soon_seen);
        found
    }

    fn moment<'a>(&'a self, occupancy: &'a Occupancy, watched: [&'a [bool]; 2]) -> Moment<'a> {
        let Self { roads, vehicles, walkers, time_s, actuated, .. } = self;
        Moment { roads, occupancy, vehicles, walkers, watched, time_s: *time_s, actuated: actuated.as_ref() }
    }

    fn with_orders(&self, kind: IncidentKind, candidate: Candidate) -> StagedIncident {
        let id = |(i, order): (usize, _)| (self.ids.vehicles[i].0, order);
        StagedIncident {
            kind,
            frame: self.frame,
            roles: candidate.roles.into_iter().map(id).collect(),
            walk: candidate.walk.map(|(i, walk)| (self.ids.walkers[i], walk)),
            junction: candidate.junction,
            label: Label::default(),
        }
    }

    /// What happens from now on with one incident more; `None` if it is not as it should be.
    fn rehearse(&self, incident: StagedIncident, request: &IncidentRequest<'_>) -> Option<Vec<Incident>> {
        let mut copy = self.clone();
        let begins_by = incident.frame + (BEGINS_WITHIN_S * self.fps) as u32;
        copy.staged.push(incident);
        let mut rehearsal = Rehearsal::new(&self.roads, request.sight, &self.parked, self.fps, self.frame);
        loop {
            if !rehearsal.look(&copy.state(), &copy.staged) {
                return None;
            }
            let label = copy.staged.last()?.label;
            if copy.frame + 1 >= request.frames || (label.begin_frame.is_none() && copy.frame > begins_by) {
                break;
            }
            if label.begin_frame == Some(copy.frame) && !rehearsal.sees_now(copy.staged.len() - 1) {
                return None;
            }
            let over = label.end_frame.is_some_and(|end| copy.frame > end + (SETTLES_S * self.fps) as u32);
            if over && !copy.staged.iter().any(StagedIncident::lasts) {
                break;
            }
            copy.go_on(request.condition);
        }
        let staged = copy.staged.iter().enumerate();
        staged.map(|(number, staged)| rehearsal.incident(number, staged, request.frames)).collect()
    }

    fn index_of(&self, id: InstanceId) -> Option<usize> {
        self.ids.vehicles.iter().position(|(other, _)| *other == id)
    }

    fn walker_of(&self, id: InstanceId) -> Option<usize> {
        self.ids.walkers.iter().position(|other| *other == id)
    }

    /// Gives the orders of this frame.
    pub(super) fn give_orders(&mut self) {
        for number in 0..self.staged.len() {
            if self.staged[number].frame != self.frame {
                continue;
            }
            for (id, order) in self.staged[number].roles.clone() {
                if let Some(i) = self.index_of(id) {
                    self.vehicles[i].order = Some(order);
                }
            }
            if let Some((id, walk)) = self.staged[number].walk.clone()
                && let Some(i) = self.walker_of(id)
            {
                self.walkers[i].road_walk = Some(walk);
            }
        }
    }

    /// Takes notice of what happens in this frame.
    pub(super) fn note_incidents(&mut self) {
        if self.staged.iter().all(|incident| incident.frame >= self.frame) {
            return;
        }
        let mut occupancy = Occupancy::default();
        occupancy.rebuild(&self.roads, &self.vehicles);
        let mut staged = std::mem::take(&mut self.staged);
        for incident in staged.iter_mut().filter(|incident| incident.frame < self.frame) {
            let actors: Vec<Option<usize>> = incident.roles.iter().map(|(id, _)| self.index_of(*id)).collect();
            let walker = incident.walk.as_ref().and_then(|(id, _)| self.walker_of(*id));
            incident.note(self.frame, &self.moment(&occupancy, [&[], &[]]), &actors, walker);
        }
        self.staged = staged;
    }
}
