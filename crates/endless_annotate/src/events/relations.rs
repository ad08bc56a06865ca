//! Relations between road users, and between them and the road.

use super::road_user::RoadUser;
use super::{LaneFacts, RoadFacts};
use crate::rounding::thousandths;
use endless_world::{InstanceId, SignalAspect, SignalId, WorldState};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A vehicle follows another that is no farther ahead, metres.
const FOLLOWS_M: f32 = 50.0;
/// A vehicle waits at a light if it stands no farther before its stop line, metres.
const WAITS_M: f32 = 60.0;
/// A vehicle yields to people on a crossing if it stands no farther before it, metres.
const YIELDS_M: f32 = 8.0;

/// Something that holds of a road user at an instant.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Relation {
    /// A person rides a two-wheeler.
    Rides {
        /// The rider.
        id: InstanceId,
        /// The two-wheeler.
        vehicle: InstanceId,
    },
    /// A vehicle drives or stands behind another on its way.
    Follows {
        /// The vehicle.
        id: InstanceId,
        /// The one ahead.
        leader: InstanceId,
        /// From the front of one to the rear of the other along the lanes, metres.
        gap_m: f64,
    },
    /// A vehicle stands before a traffic light that is not green, first or in a queue.
    WaitsAt {
        /// The vehicle.
        id: InstanceId,
        /// The signal group.
        signal: SignalId,
    },
    /// A person is on a crossing.
    Crosses {
        /// The person.
        id: InstanceId,
        /// Its index in the road network.
        crossing: u16,
    },
    /// A vehicle stands before a crossing on which somebody is.
    YieldsTo {
        /// The vehicle.
        id: InstanceId,
        /// The person.
        person: InstanceId,
        /// The crossing's index.
        crossing: u16,
    },
}

/// All relations of an instant, in the order of ids.
pub fn relations(state: &WorldState, road: &RoadFacts) -> Vec<Relation> {
    let users = RoadUser::all(state, road);
    let lanes = LaneQueues::new(&users);
    let mut crossing_people: BTreeMap<u16, Vec<InstanceId>> = BTreeMap::new();
    for user in &users {
        if let Some(crossing) = user.behaviour.crossing {
            crossing_people.entry(crossing).or_default().push(user.id);
        }
    }
    let mut found = Vec::new();
    for user in &users {
        let id = user.id;
        found.extend(user.rider_id.map(|rider| Relation::Rides { id: rider, vehicle: id }));
        found.extend(user.behaviour.crossing.map(|crossing| Relation::Crosses { id, crossing }));
        found.extend(lanes.leader(user, road).map(|(leader, gap_m)| Relation::Follows { id, leader, gap_m }));
        let Some((lane, s_m)) = lane_of(user, road).filter(|_| user.stands()) else { continue };
        found.extend(light_ahead(user, lane, s_m, state).map(|signal| Relation::WaitsAt { id, signal }));
        for crossing in lane.crossings.iter().filter(|crossing| {
            let before = crossing.range_m.0 - s_m - user.half_length_m();
            (-1.0..YIELDS_M).contains(&before)
        }) {
            let people = crossing_people.get(&crossing.crossing).into_iter().flatten();
            found.extend(people.map(|&person| Relation::YieldsTo { id, person, crossing: crossing.crossing }));
        }
    }
    found
}

fn lane_of<'r>(user: &RoadUser, road: &'r RoadFacts) -> Option<(&'r LaneFacts, f32)> {
    let place = user.behaviour.lane?;
    Some((road.lane(place.lane)?, place.s_m))
}

/// The light at the end of its lane, if that is near and not green.
fn light_ahead(user: &RoadUser, lane: &LaneFacts, s_m: f32, state: &WorldState) -> Option<SignalId> {
    let signal = lane.signal?;
    let closed = state.signals.get(usize::from(signal.0)).is_some_and(|s| s.aspect != SignalAspect::Green);
    let left = lane.length_m - s_m - user.half_length_m();
    (closed && left < WAITS_M).then_some(signal)
}

/// Vehicles by the lane they are on, from its beginning to its end.
struct LaneQueues<'u>(BTreeMap<u32, Vec<(f32, &'u RoadUser)>>);

impl<'u> LaneQueues<'u> {
    fn new(users: &'u [RoadUser]) -> Self {
        let mut lanes: BTreeMap<u32, Vec<(f32, &RoadUser)>> = BTreeMap::new();
        for user in users {
            if let Some(place) = user.behaviour.lane {
                lanes.entry(place.lane).or_default().push((place.s_m, user));
            }
        }
        for queue in lanes.values_mut() {
            queue.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.id.cmp(&b.1.id)));
        }
        Self(lanes)
    }

    /// The next vehicle ahead, on the same lane or, where that leads on to only one, on the next.
    fn leader(&self, user: &RoadUser, road: &RoadFacts) -> Option<(InstanceId, f64)> {
        let place = user.behaviour.lane?;
        let (mut lane, mut ahead) = (place.lane, -place.s_m);
        let gap = |at: f32, other: &RoadUser| at - user.half_length_m() - other.half_length_m();
        let own = self.0.get(&lane)?;
        let after = own.iter().position(|(_, other)| other.id == user.id)? + 1;
        let mut next = own.get(after);
        while next.is_none() {
            let facts = road.lane(lane)?;
            let [only] = facts.successors[..] else { return None };
            ahead += facts.length_m;
            if ahead > FOLLOWS_M + user.half_length_m() {
                return None;
            }
            lane = only;
            next = self.0.get(&lane).and_then(|queue| queue.first());
        }
        let &(s_m, leader) = next.filter(|(_, leader)| leader.id != user.id)?;
        let gap = gap(ahead + s_m, leader);
        (gap < FOLLOWS_M).then(|| (leader.id, thousandths(gap)))
    }
}
