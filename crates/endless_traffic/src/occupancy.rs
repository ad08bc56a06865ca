//! Which vehicles are on which lane.

use crate::overlap::MergeOverlap;
use crate::roads::Roads;
use crate::vehicle::{LaneCover, Vehicle};
use endless_road::LaneId;

/// Who comes to where lanes run into one another is seen from this far before it, metres.
const MERGE_M: f64 = 30.0;

/// A vehicle on a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Occupant {
    pub(crate) vehicle: usize,
    pub(crate) rear: f64,
    pub(crate) front: f64,
    pub(crate) speed: f64,
}

impl Occupant {
    pub(crate) fn middle(&self) -> f64 {
        0.5 * (self.rear + self.front)
    }
}

/// Somebody on foot who crosses a lane away from crossings.
#[derive(Debug, Clone, Copy)]
pub(crate) struct PersonOnLane {
    pub(crate) lane: LaneId,
    /// Of their way over the lane, metres, and half its width.
    pub(crate) s: f64,
    pub(crate) half_width_m: f64,
    /// Metres that they have yet to go to the lane's middle.
    pub(crate) to_lane_m: f64,
}

/// The vehicle ahead.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Leader {
    pub(crate) vehicle: usize,
    /// Bumper to bumper, metres.
    pub(crate) gap: f64,
    pub(crate) speed: f64,
}

/// All lanes' occupants, rebuilt every step.
#[derive(Debug, Clone, Default)]
pub(crate) struct Occupancy {
    lanes: Vec<Vec<Occupant>>,
    scratch: Vec<LaneCover>,
    /// Lanes of junctions that belong to vehicles which no controller knows.
    claimed: Vec<LaneId>,
    /// By lane.
    people: Vec<PersonOnLane>,
}

impl Occupancy {
    pub(crate) fn rebuild(&mut self, roads: &Roads, vehicles: &[Vehicle]) {
        self.lanes.resize(roads.network.lanes.len(), Vec::new());
        for lane in &mut self.lanes {
            lane.clear();
        }
        let mut scratch = std::mem::take(&mut self.scratch);
        for (i, vehicle) in vehicles.iter().enumerate() {
            vehicle.covers(roads, &mut scratch);
            for cover in &scratch {
                self.put(i, *cover, vehicle.speed);
            }
        }
        self.scratch = scratch;
    }

    pub(crate) fn put(&mut self, vehicle: usize, cover: LaneCover, speed: f64) {
        self.lanes[cover.lane.index()].push(Occupant { vehicle, rear: cover.rear, front: cover.front, speed });
    }

    /// Gives lanes of junctions, in ascending order, to vehicles which no controller knows.
    pub(crate) fn claim(&mut self, lanes: &[LaneId]) {
        lanes.clone_into(&mut self.claimed);
    }

    /// Whether the way over these lanes of a junction is claimed, or crosses one that is.
    pub(crate) fn crosses_claimed(&self, roads: &Roads, lanes: &[LaneId]) -> bool {
        let claimed = |lane: LaneId| self.claimed.binary_search(&lane).is_ok();
        !self.claimed.is_empty()
            && lanes.iter().any(|&lane| {
                claimed(lane) || roads.table(lane).conflicts(true).iter().any(|conflict| claimed(conflict.other))
            })
    }

    /// People away from crossings, by lane in ascending order.
    pub(crate) fn put_people(&mut self, people: Vec<PersonOnLane>) {
        self.people = people;
    }

    pub(crate) fn people_on(&self, lane: LaneId) -> &[PersonOnLane] {
        let from = self.people.partition_point(|person| person.lane < lane);
        let number = self.people[from..].partition_point(|person| person.lane == lane);
        &self.people[from..from + number]
    }

    pub(crate) fn on(&self, lane: LaneId) -> &[Occupant] {
        &self.lanes[lane.index()]
    }

    /// Whether the body of a vehicle still covers one of these lanes.
    pub(crate) fn covers_any(&self, vehicle: usize, lanes: &[LaneId]) -> bool {
        lanes.iter().any(|&lane| self.on(lane).iter().any(|o| o.vehicle == vehicle))
    }

    /// The nearest vehicle ahead on the route, also one that turns off but whose tail is still in the way, and on the
    /// lane that is being left.
    pub(crate) fn leader(&self, roads: &Roads, vehicles: &[Vehicle], i: usize, reach: f64) -> Option<Leader> {
        self.leader_of(roads, &vehicles[i], i, reach)
    }

    /// The same of the vehicle with number `i`.
    pub(crate) fn leader_of(&self, roads: &Roads, me: &Vehicle, i: usize, reach: f64) -> Option<Leader> {
        let mut best: Option<Leader> = None;
        for (lane, base) in me.ahead(roads).take_while(|(_, base)| *base <= reach) {
            for beside in &roads.table(lane).alongside {
                for o in self.on(beside.lane).iter().filter(|o| beside.other_range.0 - o.front < MERGE_M) {
                    if let Some(leader) = merging(me, i, base, beside, o)
                        && best.is_none_or(|b| leader.gap < b.gap)
                    {
                        best = Some(leader);
                    }
                }
            }
        }
        let mut consider = |o: &Occupant, base: f64, position: Option<f64>| {
            // On the same lane, what is further on is ahead; side by side, the lower number leads.
            let ahead = position.is_none_or(|s| (o.middle(), i) > (s, o.vehicle));
            if o.vehicle != i && ahead {
                let gap = base + o.rear - me.half_length;
                if best.is_none_or(|b| gap < b.gap) {
                    best = Some(Leader { vehicle: o.vehicle, gap, speed: o.speed });
                }
            }
        };
        for (k, (lane, base)) in me.ahead(roads).enumerate() {
            if base > reach {
                break;
            }
            let position = (k == 0).then_some(me.s);
            for o in self.on(lane) {
                consider(o, base, position);
            }
            for sibling in &roads.table(lane).siblings {
                for o in self.on(sibling.lane).iter().filter(|o| o.rear < sibling.until) {
                    consider(o, base, position);
                }
            }
        }
        if let Some(shift) = me.shift {
            let s = me.s + shift.from_minus_here;
            for o in self.on(shift.from) {
                consider(o, -s, Some(s));
            }
        }
        best
    }
}

/// The vehicle ahead, or to be let in, on a lane that merges into mine `base` metres from my origin.
fn merging(me: &Vehicle, i: usize, base: f64, beside: &MergeOverlap, o: &Occupant) -> Option<Leader> {
    // Everything in `s` of my lane.
    let (mine, shift) = (-base, beside.here_minus_there());
    let theirs = o.middle() + shift;
    let gone = o.rear > beside.other_range.1 + 0.5 * (o.front - o.rear);
    if o.vehicle == i || gone || mine > beside.range.1 || (theirs, i) <= (mine, o.vehicle) {
        return None;
    }
    // Side by side before the lanes meet: the one behind lets the other go, without standing on its brakes.
    let room = beside.range.0 - mine;
    let gap = (o.rear + shift - mine - me.half_length).max(room);
    Some(Leader { vehicle: o.vehicle, gap, speed: o.speed })
}
