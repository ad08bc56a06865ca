//! Which vehicles are on which lane.

use crate::across::Across;
use crate::emergency::ComingCall;
use crate::filtering::{self, pace_past};
use crate::overlap::MergeOverlap;
use crate::roads::Roads;
use crate::vehicle::{LaneCover, Vehicle, firm_stop_m};
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
    pub(crate) across: Across,
    /// Whether it stands or crawls in a queue, so that riders may pass it.
    pub(crate) queues: bool,
    /// Whether it passes those in a queue.
    pub(crate) filters: bool,
    /// Whether it reaches over here from the lane beside, which is its own.
    pub(crate) reaches_over: bool,
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

impl Leader {
    /// How far ahead its rear would stand if it braked firmly, metres.
    pub(crate) fn could_stand_m(&self) -> f64 {
        self.gap + firm_stop_m(self.speed)
    }
}

/// Those ahead.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Leaders {
    /// Whom to stay behind.
    pub(crate) ahead: Option<Leader>,
    /// Of all ahead the one who could stand first on the way, as another than the nearest may: somebody in a queue, with one
    /// before it who moves over in time, or one on the lane that is being left.
    pub(crate) stands_first: Option<Leader>,
    /// Who is half a length ahead or less, with room between the sides of both: one of the two lets the other go first.
    pub(crate) beside: Option<Leader>,
    /// The speed at which to pass those in a queue, m/s.
    pub(crate) pace_mps: Option<f64>,
    /// How far ahead the nearest of those is, metres.
    pub(crate) passed_m: Option<f64>,
}

impl Leaders {
    /// The nearest of them.
    pub(crate) fn nearest(self) -> Option<Leader> {
        self.ahead.into_iter().chain(self.beside).min_by(|a, b| a.gap.total_cmp(&b.gap))
    }

    /// How far ahead the first of them could stand, metres.
    pub(crate) fn could_stand_m(self) -> f64 {
        let all = [self.ahead, self.beside, self.stands_first].into_iter().flatten();
        all.map(|leader| leader.could_stand_m()).fold(f64::INFINITY, f64::min)
    }
}

/// All lanes' occupants, rebuilt every step.
#[derive(Debug, Clone, Default)]
pub(crate) struct Occupancy {
    lanes: Vec<Vec<Occupant>>,
    scratch: Vec<LaneCover>,
    /// Lanes of junctions that belong to vehicles which no controller knows.
    claimed: Vec<LaneId>,
    /// Where those on call are about to come.
    pub(crate) coming: Vec<ComingCall>,
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
        for (i, vehicle) in vehicles.iter().enumerate().filter(|(_, vehicle)| !vehicle.is_parked()) {
            vehicle.covers(roads, &mut scratch);
            let (across, queues) = (vehicle.across(), filtering::queues(vehicle));
            let filters = vehicle.filtering.is_some();
            for LaneCover { lane, rear, front } in scratch.iter().copied() {
                let speed = vehicle.speed;
                let occupant =
                    Occupant { vehicle: i, rear, front, speed, across, queues, filters, reaches_over: false };
                self.lanes[lane.index()].push(occupant);
                if let Some(beside) = filtering::lane_beside(roads, vehicle, lane) {
                    let along = if lane == vehicle.lane() { beside.s - vehicle.s } else { 0.0 };
                    let (rear, front, across) = (rear + along, front + along, beside.seen(across));
                    self.lanes[beside.lane.index()].push(Occupant {
                        rear,
                        front,
                        across,
                        reaches_over: true,
                        ..occupant
                    });
                }
            }
        }
        self.scratch = scratch;
        self.coming.clear();
        self.coming.extend(vehicles.iter().flat_map(|vehicle| ComingCall::ahead_of(roads, vehicle)));
    }

    pub(crate) fn put(&mut self, vehicle: usize, cover: LaneCover, speed: f64) {
        let LaneCover { lane, rear, front } = cover;
        let across = Across::WHOLE;
        let [queues, filters, reaches_over] = [false; 3];
        let occupant = Occupant { vehicle, rear, front, speed, across, queues, filters, reaches_over };
        self.lanes[lane.index()].push(occupant);
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
        self.leaders(roads, me, i, reach).nearest()
    }

    /// Those ahead of the vehicle with number `i`, by what it makes of them.
    pub(crate) fn leaders(&self, roads: &Roads, me: &Vehicle, i: usize, reach: f64) -> Leaders {
        let mut found = Leaders::default();
        for (lane, base) in me.ahead(roads).take_while(|(_, base)| *base <= reach) {
            for beside in &roads.table(lane).alongside {
                for o in self.on(beside.lane).iter().filter(|o| beside.other_range.0 - o.front < MERGE_M) {
                    if let Some(leader) = merging(me, i, base, beside, o)
                        && found.ahead.is_none_or(|b| leader.gap < b.gap)
                    {
                        found.ahead = Some(leader);
                    }
                }
            }
        }
        let filters = me.filtering.is_some();
        // Beyond a junction is another queue.
        let mut same_queue = true;
        let mut consider = |o: &Occupant, base: f64, is_here: bool, across: &Across, same_queue: bool| {
            // On the same lane, what is further on is ahead; side by side, the lower number leads.
            let is_further_on = (base + o.middle(), i) > (0.0, o.vehicle);
            if o.vehicle == i || is_here && !is_further_on {
                return;
            }
            let gap = base + o.rear - me.half_length;
            let leader = Leader { vehicle: o.vehicle, gap, speed: o.speed };
            let passes = same_queue && o.queues && filtering::passes(me, across, &o.across, gap);
            if passes || o.reaches_over && filtering::goes_past(me, across, &o.across, o.speed) {
                let pace = pace_past(o.speed, gap);
                found.pace_mps = Some(found.pace_mps.map_or(pace, |least: f64| least.min(pace)));
                found.passed_m = Some(found.passed_m.map_or(gap, |nearest: f64| nearest.min(gap)));
                return;
            }
            if (filters || o.filters) && filtering::is_beside(across, &o.across, gap) {
                // Who reaches on to my next lane may be behind me all the same, and lets me go first.
                if is_further_on {
                    found.beside = found.beside.filter(|b| b.gap <= gap).or(Some(leader));
                }
                return;
            }
            found.ahead = found.ahead.filter(|b| b.gap <= gap).or(Some(leader));
            let later = |first: &Leader| first.could_stand_m() <= leader.could_stand_m();
            found.stands_first = found.stands_first.filter(later).or(Some(leader));
        };
        let across = me.across();
        for (k, (lane, base)) in me.ahead(roads).enumerate() {
            if base > reach {
                break;
            }
            let is_here = k == 0;
            same_queue &= roads.table(lane).junction.is_none();
            for o in self.on(lane) {
                consider(o, base, is_here, &across, same_queue);
            }
            for sibling in &roads.table(lane).siblings {
                for o in self.on(sibling.lane).iter().filter(|o| o.rear < sibling.until) {
                    consider(o, base, is_here, &Across::WHOLE, false);
                }
            }
            if let Some(beside) = filtering::lane_beside(roads, me, lane) {
                let base = if is_here { -beside.s } else { base };
                for o in self.on(beside.lane) {
                    consider(o, base, is_here, &beside.seen(across), same_queue);
                }
            }
        }
        if let Some(shift) = me.shift {
            let base = -(me.s + shift.from_minus_here);
            for o in self.on(shift.from).iter().filter(|o| o.rear < shift.clear_from_m) {
                consider(o, base, true, &Across::WHOLE, false);
            }
        }
        found
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Lane, Polyline, RoadNetwork};
    use endless_world::{Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    #[test]
    fn who_stands_is_seen_beyond_somebody_near_who_drives_on() {
        let spec = VehicleSpec::default();
        let line = Polyline::new([DVec3::ZERO, 300.0 * DVec3::X]);
        let network = RoadNetwork { lanes: vec![Lane::new(LaneId(0), line, 3.5, 25.0)], ..RoadNetwork::default() };
        let map = TrafficMap::new(network.finish().expect("a lane"), std::slice::from_ref(&spec));
        let roads = Roads::new(&map, &Focus::default(), &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let mut stream = Stream::named(1, "test.occupancy", &[]);
        let mut vehicle = |s: f64, speed: f64| {
            let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
            let vehicle = Vehicle::new(&spec, asset, driver, LaneId(0), s, stream.fork(s as u64));
            Vehicle { speed, ..vehicle }
        };
        let mut vehicles = vec![vehicle(10.0, 23.0), vehicle(35.0, 24.0), vehicle(70.0, 0.0)];
        let found = |vehicles: &[Vehicle]| {
            let mut occupancy = Occupancy::default();
            occupancy.rebuild(&roads, vehicles);
            let leaders = occupancy.leaders(&roads, &vehicles[0], 0, 180.0);
            [leaders.ahead, leaders.stands_first].map(|leader| leader.map(|l| l.vehicle))
        };
        assert_eq!(found(&vehicles), [Some(1), Some(2)]);
        // Where both stand it is the nearest alone.
        vehicles[1].speed = 0.0;
        assert_eq!(found(&vehicles), [Some(1), Some(1)]);
    }
}
