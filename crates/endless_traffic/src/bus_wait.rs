//! People who wait for a bus: they stand at the kerb beside the stop's sign and face the road, for as long as their patience lasts.

use crate::bus_errand::{THERE_M, Wait};
use crate::people_grid::Passer;
use crate::roads::Roads;
use crate::stop_places::StopPlace;
use crate::walk_strip::DirectedEdge;
use crate::walker::Walker;
use glam::DVec2;

/// The share of people who wait at a stop that they come along.
const WAITS: f64 = 0.35;
/// A place is so far ahead of who makes up their mind, metres.
const AHEAD_M: f64 = 0.3;
/// For how long they wait, seconds.
const PATIENCE_S: [f64; 2] = [45.0, 130.0];
/// A place is taken if somebody is within this of it, metres.
const TAKEN_M: f64 = 0.55;
/// Nobody looks for a place for longer, seconds.
const LOOKS_S: f64 = 20.0;

impl Walker {
    /// Where to stand and wait for a bus, and the way to look there; while they do.
    pub(crate) fn waits_for_bus(
        &mut self,
        roads: &Roads,
        strip: &DirectedEdge,
        near: &[Passer],
        step_s: f64,
    ) -> Option<(DVec2, DVec2)> {
        if roads.stop_places.is_empty() {
            return None;
        }
        let places = roads.stop_places.on(self.way[0].0);
        if self.bus.wait.is_none() {
            self.decide(places, strip, near);
        }
        let mut wait = self.bus.wait.take().filter(|wait| wait.place.edge == self.way[0].0)?;
        if wait.place.at.distance(self.position) < THERE_M {
            wait.left_s -= step_s;
        } else {
            wait.looked_s += step_s;
            // Who finds the place taken looks for another one.
            if is_taken(&wait.place, near) {
                let stop = wait.place.stop;
                wait.place = *places.iter().find(|other| other.stop == stop && !is_taken(other, near))?;
            }
        }
        (wait.left_s > 0.0 && wait.looked_s < LOOKS_S).then(|| {
            self.bus.wait = Some(wait);
            (wait.place.at, wait.place.road)
        })
    }

    /// Whoever comes along a stop may wait there.
    fn decide(&mut self, places: &[StopPlace], strip: &DirectedEdge, near: &[Passer]) {
        if places.is_empty() || self.rest.is_some() || self.jogs || self.company.is_some() || self.on_roadway() {
            return;
        }
        let here = strip.local(self.position).0;
        let ahead = |place: &&StopPlace| strip.local(place.at).0 > here + AHEAD_M;
        let Some(first) = places.iter().find(ahead) else { return };
        if self.bus.has_decided(first.stop, self.passed) {
            return;
        }
        self.bus.decided = Some((first.stop, self.passed));
        let waits = self.stream.chance(WAITS);
        let left_s = self.stream.range_f64(PATIENCE_S[0], PATIENCE_S[1]);
        let mut free = places.iter().filter(ahead).filter(|place| place.stop == first.stop && !is_taken(place, near));
        self.bus.wait = free.next().filter(|_| waits).map(|place| Wait { place: *place, left_s, looked_s: 0.0 });
    }
}

fn is_taken(place: &StopPlace, near: &[Passer]) -> bool {
    near.iter().any(|other| other.at.distance(place.at) < TAKEN_M && other.velocity.length() < 0.2)
}
