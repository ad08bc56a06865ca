//! How those who are simulated notice those who play tracks.

use super::{Body, Here, Playback, Played};
use crate::crossing::{CrossingPedestrian, CrossingState};
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::LaneCover;
use endless_road::LaneId;
use glam::DVec2;

/// Where somebody will be in these times gives them the right of way there, seconds.
const CLAIMS_S: [f64; 5] = [0.0, 1.0, 2.0, 3.0, 4.0];
/// People on foot watch out this far beside a vehicle's lane, metres.
const BESIDE_M: f64 = 2.5;

/// What those who are simulated need to know of those who play tracks.
#[derive(Debug, Clone, Default)]
pub(crate) struct Presence {
    /// Parts of lanes under vehicles, with their speeds.
    covers: Vec<(LaneCover, f64)>,
    /// Lanes of junctions that vehicles are on, or soon will be.
    pub(crate) claimed: Vec<LaneId>,
    /// Positions and velocities of people on foot.
    pub(crate) people: Vec<(DVec2, DVec2)>,
    /// Those of them who are on crossings.
    crossing: Vec<(usize, CrossingPedestrian)>,
}

impl Presence {
    /// At the instant of a playback, for traffic on these roads.
    pub(crate) fn of(playback: &Playback, roads: &Roads, time_s: f64) -> Self {
        let mut presence = Self::default();
        for played in &playback.actors {
            let Some(here) = &played.here else { continue };
            match &played.body {
                Body::Vehicle(body) => presence.vehicle(playback, played, here, body.half_length, roads, time_s),
                Body::Person(_) => presence.person(here),
            }
        }
        presence.claimed.sort_unstable();
        presence.claimed.dedup();
        presence
    }

    fn vehicle(
        &mut self,
        playback: &Playback,
        played: &Played,
        here: &Here,
        half_length: f64,
        roads: &Roads,
        time_s: f64,
    ) {
        let height = Some(f64::from(here.pose.position.z));
        if let Some(on) = here.lane {
            // Its ends may be on the lanes before and after.
            let cover = LaneCover { lane: on.lane, rear: on.s - half_length, front: on.s + half_length };
            self.covers.push((cover, here.place.speed.max(0.0)));
            for side in [-1.0, 1.0] {
                let end = here.place.centre + super::heading(here.place.yaw) * (side * half_length);
                let Some(at) = playback.ground.lane(&roads.network, end, here.place.yaw, height) else { continue };
                if at.lane != on.lane {
                    let middle = at.s - side * half_length;
                    let cover = LaneCover { lane: at.lane, rear: middle - half_length, front: middle + half_length };
                    self.covers.push((cover, here.place.speed.max(0.0)));
                }
            }
        }
        for ahead_s in CLAIMS_S {
            let Some(place) = played.path.at(playback.begin_s + time_s + ahead_s) else { continue };
            let on = playback.ground.lane(&roads.network, place.centre, place.yaw, height);
            self.claimed.extend(on.map(|on| on.lane).filter(|&lane| roads.table(lane).junction.is_some()));
        }
    }

    fn person(&mut self, here: &Here) {
        let (at, velocity) = (here.place.centre, here.place.velocity);
        self.people.push((at, velocity));
        if let Some(on) = here.crossing.filter(|on| on.beyond_m <= 0.0) {
            let towards = velocity.dot(on.along);
            let direction = if towards < 0.0 { -1.0 } else { 1.0 };
            let person = CrossingPedestrian { along_m: on.along_m, direction, speed: velocity.length() };
            self.crossing.push((on.crossing.index(), person));
        }
    }

    /// Puts the vehicles on their lanes, numbered from `first` on.
    pub(crate) fn occupy(&self, occupancy: &mut Occupancy, first: usize) {
        for (number, (cover, speed)) in self.covers.iter().enumerate() {
            occupancy.put(first + number, *cover, *speed);
        }
        occupancy.claim(&self.claimed);
    }

    /// Parts of lanes under vehicles, with their speeds, m/s.
    pub(crate) fn covers(&self) -> impl Iterator<Item = (LaneId, [f64; 2], f64)> {
        self.covers.iter().map(|(cover, speed)| (cover.lane, [cover.rear, cover.front], *speed))
    }

    /// Notes the vehicles that are on crossings or come there.
    pub(crate) fn note_vehicles(&self, roads: &Roads, crossings: &mut [CrossingState]) {
        for (cover, speed) in &self.covers {
            for cut in &roads.table(cover.lane).cuts {
                let reach = crate::crossing::comfortable_stop_m(*speed);
                if cut.range.0 < cover.front + reach && cut.range.1 > cover.rear {
                    let state = &mut crossings[cut.crossing.index()];
                    state.danger = true;
                    state.occupied |= cut.range.0 < cover.front;
                    state.taken.push((cut.along_m, BESIDE_M));
                }
            }
        }
    }

    /// Notes the people who are on crossings.
    pub(crate) fn note_people(&self, crossings: &mut [CrossingState]) {
        for (crossing, person) in &self.crossing {
            crossings[*crossing].people.push(*person);
        }
    }
}
