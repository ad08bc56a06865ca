//! Watches traffic and reports what no street ever shows: bodies that touch, jumps, people beside their sidewalk, red
//! lights run.
//!
//! A [`TrafficAudit`] looks at one world state after the other and at nothing else: whoever simulated them is not asked.
//! Its [`AuditReport`] has a line for each [`AuditCheck`], with what was measured, the limit, and where it was worst.
//!
//! ```text
//! WorldState ─► sight (this frame, the one before) ─┬─► contact   bodies that touch
//!                                                   ├─► motion    jumps, jerks, slips, who vanishes
//!                                                   ├─► standing  who is stuck
//!                                                   ├─► bench     who sits on no seat
//!                                                   ├─► parking   who is parked beside the bays
//!                                                   ├─► surface   lanes, sidewalks, crossings
//!                                                   └─► rules     lights, stop signs, limits
//! ```

mod bench;
pub(crate) mod body;
mod bus_door;
mod cell_grid;
mod check;
mod contact;
mod finding;
mod motion;
mod parking;
mod report;
mod rules;
mod sight;
mod standing;
mod surface;

pub use check::AuditCheck;
pub use report::{AuditLine, AuditReport};

use crate::driver::pace_of;
use bench::Benches;
use contact::Contacts;
use endless_road::RoadNetwork;
use endless_world::{Actor, BenchSeat, InstanceId, ParkingBay, VehicleSpec, WorldState};
use motion::Motions;
use parking::ParkedBodies;
use rules::Rules;
use sight::{Glance, Past, Sight};
use standing::Standing;
use surface::Surfaces;

/// Looks at traffic, frame by frame.
///
/// Frames must follow one another at the given rate; at 30 a second or more, what it measures of accelerations is what the
/// simulation did in its steps. Those who play recorded tracks are measured like others, although they see nobody.
#[derive(Debug)]
pub struct TrafficAudit<'a> {
    network: &'a RoadNetwork,
    specs: &'a [VehicleSpec],
    fps: f64,
    frames: u64,
    before: Vec<Past>,
    contacts: Contacts,
    motions: Motions,
    standing: Standing,
    benches: Benches,
    parking: ParkedBodies,
    surfaces: Surfaces,
    rules: Rules,
}

impl<'a> TrafficAudit<'a> {
    /// Of vehicles of these models on this network, among those that stand parked; `fps` is the rate of the frames that it
    /// will be shown.
    ///
    /// # Panics
    /// If the rate is not positive, or a parked vehicle's model is not among those.
    pub fn new(network: &'a RoadNetwork, specs: &'a [VehicleSpec], parked: &[Actor], fps: f64) -> Self {
        assert!(fps > 0.0, "frames per second must be positive");
        Self {
            network,
            specs,
            fps,
            frames: 0,
            before: Vec::new(),
            contacts: Contacts::new(specs, parked),
            motions: Motions::new(network),
            standing: Standing::default(),
            benches: Benches::default(),
            parking: ParkedBodies::default(),
            surfaces: Surfaces::new(network),
            rules: Rules::new(network),
        }
    }

    /// Of traffic whose drivers have this aggressiveness, 0 to 1: the bold ones drive faster.
    #[must_use]
    pub fn with_aggressiveness(self, aggressiveness: f64) -> Self {
        Self { rules: self.rules.with_pace(pace_of(aggressiveness)), ..self }
    }

    /// On a map with these seats: people leave sidewalks for them, and sit for long.
    #[must_use]
    pub fn with_bench_seats(self, seats: &[BenchSeat]) -> Self {
        Self { benches: Benches::new(seats), ..self }
    }

    /// On a map with these bays at kerbs: vehicles leave their lanes for them, and stand there for long.
    #[must_use]
    pub fn with_parking_bays(self, bays: &[ParkingBay]) -> Self {
        Self { parking: ParkedBodies::new(bays), ..self }
    }

    /// Looks at the next frame. Its actors are in the order of their ids.
    ///
    /// # Panics
    /// If a vehicle's model is not among those that it was told of.
    pub fn look(&mut self, state: &WorldState) {
        let mut sight = Sight {
            network: self.network,
            specs: self.specs,
            state,
            frame_s: 1.0 / self.fps,
            first: self.frames == 0,
            vanished: Vec::new(),
            glances: Vec::with_capacity(state.actors.len()),
        };
        for actor in &state.actors {
            let before = self.before.binary_search_by_key(&actor.id, |past| past.actor.id).ok();
            let before = before.map(|place| self.before[place]);
            sight.glances.push(Glance::new(actor, before, self.specs));
        }
        let there = |id: InstanceId| state.actors.binary_search_by_key(&id, |actor| actor.id).is_ok();
        sight.vanished.extend(self.before.iter().map(|past| past.actor).filter(|actor| !there(actor.id)));
        self.contacts.look(&sight);
        self.motions.look(&sight);
        self.benches.look(&sight);
        self.standing.look(&sight, &self.benches);
        self.parking.look(&sight);
        self.surfaces.look(&sight, &self.benches, &self.parking);
        self.rules.look(&sight);
        self.before.clear();
        self.before.extend(sight.glances.iter().map(|glance| Past { actor: *glance.actor, ahead: glance.ahead }));
        self.frames += 1;
    }

    /// What was found so far.
    pub fn report(&self) -> AuditReport {
        let lines = self.contacts.lines().into_iter();
        let lines = lines
            .chain(self.standing.lines())
            .chain(self.surfaces.lines())
            .chain(self.benches.lines())
            .chain(self.parking.lines())
            .chain(self.motions.lines());
        AuditReport {
            lines: lines.chain(self.rules.lines()).collect(),
            seconds: self.frames.saturating_sub(1) as f64 / self.fps,
            driven_m: self.motions.driven_m(),
            walked_m: self.motions.walked_m(),
        }
    }
}

#[cfg(test)]
mod tests;
