//! Events: what happens between one instant and the next.

use super::RoadFacts;
use super::conflict::{self, ENCROACHMENT_S, NEAR_MISS_S, Trails};
use super::road_user::RoadUser;
use crate::rounding::thousandths;
use endless_world::{InstanceId, SignalAspect, SignalId, WorldState};
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};

/// Who slows down more brakes hard, m/s².
pub const HARD_BRAKING_MPS2: f32 = 4.0;
/// Who stops had moved faster before, m/s: nobody stops twice who creeps.
const MOVED_MPS: f32 = 1.0;

/// Something that happens in a frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Event {
    /// A vehicle has come to a stop.
    Stop {
        /// The vehicle.
        id: InstanceId,
    },
    /// A vehicle begins to brake hard.
    HardBraking {
        /// The vehicle.
        id: InstanceId,
        /// m/s².
        acceleration_mps2: f64,
    },
    /// A vehicle passes a stop line at red.
    RedLightRun {
        /// The vehicle.
        id: InstanceId,
        /// The signal group.
        signal: SignalId,
    },
    /// A vehicle begins to change lanes.
    LaneChange {
        /// The vehicle.
        id: InstanceId,
        /// The lane that it leaves, by index in the road network.
        from: u32,
        /// The lane to which it goes.
        to: u32,
    },
    /// Two would touch soon if both went on as they do; told when the time falls below its bound.
    NearMiss {
        /// Both, by ascending id.
        ids: [InstanceId; 2],
        /// Time to collision, seconds.
        time_to_collision_s: f64,
    },
    /// One comes to where another, who crossed its way, has just been.
    Encroachment {
        /// Who was there first, and who came after.
        ids: [InstanceId; 2],
        /// Post-encroachment time, seconds.
        post_encroachment_s: f64,
    },
    /// Two touch.
    Collision {
        /// Both, by ascending id.
        ids: [InstanceId; 2],
    },
}

/// What of somebody must be remembered until the next frame.
#[derive(Debug, Clone, Copy)]
struct Remembered {
    lane: Option<u32>,
    changes_lane: bool,
    moved: bool,
    brakes_hard: bool,
}

/// What two have to do with one another while it lasts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Conflict {
    Near,
    Touching,
}

/// Finds events in world states that follow one another.
#[derive(Debug, Clone)]
pub struct EventDetector {
    road: RoadFacts,
    remembered: BTreeMap<InstanceId, Remembered>,
    trails: Trails,
    lasting: BTreeSet<(Conflict, [InstanceId; 2])>,
    /// When each encroachment was told.
    encroached: BTreeMap<[InstanceId; 2], f64>,
    begun: bool,
}

impl EventDetector {
    /// With nothing seen yet.
    pub fn new(road: RoadFacts) -> Self {
        Self {
            road,
            remembered: BTreeMap::new(),
            trails: Trails::default(),
            lasting: BTreeSet::new(),
            encroached: BTreeMap::new(),
            begun: false,
        }
    }

    /// What it knows of roads.
    pub fn road(&self) -> &RoadFacts {
        &self.road
    }

    /// What has happened since the state before; nothing in the first.
    pub fn observe(&mut self, state: &WorldState) -> Vec<Event> {
        let users = RoadUser::all(state, &self.road);
        let mut events = Vec::new();
        for user in users.iter().filter(|user| user.drives) {
            self.of_one(user, state, &mut events);
        }
        self.of_pairs(&users, state.time_s, &mut events);
        self.trails.note(&users, state.time_s);
        self.begun = true;
        events
    }

    /// What a driver does.
    fn of_one(&mut self, user: &RoadUser, state: &WorldState, events: &mut Vec<Event>) {
        let id = user.id;
        let behaviour = user.behaviour;
        let lane = behaviour.lane.map(|place| place.lane);
        let before = self.remembered.get(&id).copied();
        let now = Remembered {
            lane,
            changes_lane: behaviour.lane_left.is_some(),
            // Who creeps has moved until they stop.
            moved: user.speed_mps > MOVED_MPS || before.is_some_and(|before| before.moved && !user.stands()),
            brakes_hard: behaviour.acceleration_mps2 < -HARD_BRAKING_MPS2,
        };
        self.remembered.insert(id, now);
        let Some(before) = before else { return };
        if before.moved && user.stands() {
            events.push(Event::Stop { id });
        }
        if now.brakes_hard && !before.brakes_hard {
            events.push(Event::HardBraking { id, acceleration_mps2: thousandths(behaviour.acceleration_mps2) });
        }
        if let (Some(from), Some(to), false) = (behaviour.lane_left, lane, before.changes_lane) {
            events.push(Event::LaneChange { id, from, to });
        }
        let Some(passed) = before.lane.filter(|passed| Some(*passed) != lane) else { return };
        let Some(facts) = self.road.lane(passed) else { return };
        let goes_on = lane.is_some_and(|lane| facts.successors.contains(&lane));
        if let Some(signal) = facts.signal.filter(|_| goes_on)
            && state.signals.get(usize::from(signal.0)).is_some_and(|s| s.aspect == SignalAspect::Red)
        {
            events.push(Event::RedLightRun { id, signal });
        }
    }

    /// What two do to one another.
    fn of_pairs(&mut self, users: &[RoadUser], time_s: f64, events: &mut Vec<Event>) {
        let mut lasting = BTreeSet::new();
        let (known, begun) = (std::mem::take(&mut self.lasting), self.begun);
        let mut begins = |kind: Conflict, ids: [InstanceId; 2]| {
            lasting.insert((kind, ids));
            begun && !known.contains(&(kind, ids))
        };
        for (a, b) in conflict::pairs(users) {
            let ids = [a.id, b.id];
            let (Some(own), Some(other)) = (a.footprint, b.footprint) else { continue };
            match own.time_to_collision(&other) {
                Some(0.0) if begins(Conflict::Touching, ids) => events.push(Event::Collision { ids }),
                Some(time) if time > 0.0 && time < NEAR_MISS_S && begins(Conflict::Near, ids) => {
                    events.push(Event::NearMiss { ids, time_to_collision_s: thousandths(time) });
                }
                _ => {}
            }
            for (before, after) in [(a, b), (b, a)] {
                let ids = [before.id, after.id];
                let Some(time) = self.trails.post_encroachment_s(before, after, time_s) else { continue };
                let told = self.encroached.get(&ids).is_some_and(|then| time_s - then < 2.0 * ENCROACHMENT_S);
                if !told {
                    self.encroached.insert(ids, time_s);
                    events.push(Event::Encroachment { ids, post_encroachment_s: thousandths(time as f32) });
                }
            }
        }
        self.lasting = lasting;
    }
}
