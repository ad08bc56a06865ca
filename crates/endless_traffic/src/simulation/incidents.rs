//! Incidents: rehearsed in copies of the simulation, then staged.

use super::Simulation;
use crate::incident::{Candidate, IncidentRequest, Label, Moment, Rehearsal, StagedIncident, candidates};
use crate::occupancy::Occupancy;
use crate::settings::DrivingCondition;
use endless_world::{Incident, IncidentKind, InstanceId, StagedIncidents, Stream};

/// The shares of a recording within which orders are given.
const GIVEN: [f64; 2] = [0.05, 0.65];
/// Candidates are looked for so often, seconds.
const EVERY_S: f64 = 0.3;
/// So many candidates are tried of an instant, and so many in all, for each incident.
const TRIED_AT_ONCE: usize = 4;
const TRIED: usize = 120;
/// An incident begins within this after its orders, seconds.
const BEGINS_WITHIN_S: f64 = 12.0;

impl Simulation {
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
        let mut found = candidates(kind, &self.moment(&occupancy));
        let sight = request.sight;
        let soon_seen = |candidate: &Candidate| {
            let ahead = self.vehicles[candidate.roles[0].0].ahead(&self.roads);
            let place = ahead.take_while(|(_, base)| *base <= candidate.ahead_m).last();
            place.is_some_and(|(lane, base)| sight.on_lane(lane.index(), candidate.ahead_m - base) != 0)
        };
        if !sight.views().is_empty() {
            found.retain(soon_seen);
        }
        found
    }

    fn moment<'a>(&'a self, occupancy: &'a Occupancy) -> Moment<'a> {
        Moment { roads: &self.roads, occupancy, vehicles: &self.vehicles, time_s: self.time_s }
    }

    fn with_orders(&self, kind: IncidentKind, candidate: Candidate) -> StagedIncident {
        let id = |(i, order): (usize, _)| (self.ids.vehicles[i].0, order);
        StagedIncident {
            kind,
            frame: self.frame,
            roles: candidate.roles.into_iter().map(id).collect(),
            junction: candidate.junction,
            label: Label::default(),
        }
    }

    /// What happens from now on with one incident more; `None` if it is not as it should be.
    fn rehearse(&self, incident: StagedIncident, request: &IncidentRequest<'_>) -> Option<Vec<Incident>> {
        let mut copy = self.clone();
        let begins_by = incident.frame + (BEGINS_WITHIN_S * self.fps) as u32;
        copy.staged.push(incident);
        let mut rehearsal = Rehearsal::new(&self.roads.specs, request.sight, &self.parked, self.fps, self.frame);
        loop {
            if !rehearsal.look(&copy.state(), &copy.staged) {
                return None;
            }
            let begun = copy.staged.last()?.label.begin_frame.is_some();
            if copy.frame + 1 >= request.frames || (!begun && copy.frame > begins_by) {
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
            incident.note(self.frame, &self.moment(&occupancy), &actors);
        }
        self.staged = staged;
    }
}
