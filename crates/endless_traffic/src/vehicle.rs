//! One moving vehicle.

use crate::across::Across;
use crate::driver::Driver;
use crate::filtering::Filtering;
use crate::incident::Order;
use crate::kerb_halt::KerbHalt;
use crate::roads::Roads;
use crate::trailer::TrailerState;
use crate::turn_aim::Aim;
use endless_road::swept::{LONG_M, OrientedRectangle, SWINGS_OUT_M};
use endless_road::{JunctionId, LaneId, TrafficControl};
use endless_world::{ObjectClass, Pose, Side, Stream, VehicleLights, VehicleRef, VehicleSpec};
use glam::{DVec3, Vec3};
use std::collections::VecDeque;

/// How far ahead a route is planned, metres.
pub(crate) const HORIZON_M: f64 = 200.0;
/// Slower than this somebody stands or crawls in a queue, m/s.
const QUEUES_MPS: f64 = 2.0;

/// Leave to cross a junction. Vehicles pass a place where their ways overlap in the order of `order`.
#[derive(Debug, Clone)]
pub(crate) struct RightOfWay {
    pub(crate) junction: JunctionId,
    pub(crate) order: u64,
    pub(crate) lanes: Vec<LaneId>,
    pub(crate) exit: LaneId,
    pub(crate) entered: bool,
    /// How long its holder has stood since, seconds.
    pub(crate) stood_s: f64,
}

/// A lane change under way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneChange {
    /// The lane being left, and its `s` minus the new lane's.
    pub(crate) from: LaneId,
    pub(crate) from_minus_here: f64,
    /// Offset from the new lane at the beginning, metres.
    pub(crate) offset_m: f64,
    /// Where it began, on the new lane.
    pub(crate) begin_s: f64,
    /// Metres along the road.
    pub(crate) length_m: f64,
    /// Those on the lane being left whose rear is beyond this are no hindrance, metres along that lane.
    pub(crate) clear_from_m: f64,
}

impl LaneChange {
    /// How much of the way across is done after this share of its length: position, slope and curvature are continuous.
    pub(crate) fn rise(u: f64) -> f64 {
        u * u * u * (10.0 - 15.0 * u + 6.0 * u * u)
    }
}

/// A lane that a long vehicle has left, while what comes last of it is still there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneTail {
    /// The lane left, and its `s` minus that of the lane it is on.
    pub(crate) from: LaneId,
    pub(crate) from_minus_here: f64,
    /// The lane it is on, and how far on it the last of it has come over.
    pub(crate) here: LaneId,
    pub(crate) until_s: f64,
}

impl LaneTail {
    /// Of a vehicle that has just changed lanes: what is long comes over a length later, what is short at once.
    pub(crate) fn of(vehicle: &Vehicle, change: LaneChange) -> Option<Self> {
        let LaneChange { from, from_minus_here, .. } = change;
        let until_s = vehicle.s + 2.0 * vehicle.half_length;
        let trails = vehicle.trailer.is_some() || 2.0 * vehicle.half_length >= LONG_M;
        trails.then(|| Self { from, from_minus_here, here: vehicle.lane(), until_s })
    }

    /// Whether it is still there.
    pub(crate) fn is_there(&self, vehicle: &Vehicle) -> bool {
        vehicle.lane() == self.here && vehicle.s < self.until_s
    }
}

/// A part of a lane that a body covers, not clipped to the lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LaneCover {
    pub(crate) lane: LaneId,
    pub(crate) rear: f64,
    pub(crate) front: f64,
}

#[derive(Debug, Clone)]
pub(crate) struct Vehicle {
    pub(crate) asset: VehicleRef,
    pub(crate) class: ObjectClass,
    pub(crate) ridden: bool,
    pub(crate) half_length: f64,
    pub(crate) half_width: f64,
    pub(crate) wheelbase: f64,
    /// Distance of the rear axle behind the origin, metres.
    pub(crate) rear_axle: f64,
    pub(crate) driver: Driver,
    pub(crate) stream: Stream,
    /// Whether it is an emergency vehicle whose beacons flash.
    pub(crate) on_call: bool,
    /// Whether it comes to what is looked at.
    pub(crate) drawn: bool,

    /// Lanes behind that the body may still cover, the lane of the origin (at `here`), lanes to come.
    pub(crate) route: VecDeque<LaneId>,
    pub(crate) here: usize,
    /// Of the origin, on the lane at `here`.
    pub(crate) s: f64,
    pub(crate) speed: f64,
    pub(crate) acceleration: f64,
    pub(crate) shift: Option<LaneChange>,
    pub(crate) tail: Option<LaneTail>,
    /// Lane change to come: target, and seconds until it begins.
    pub(crate) intent: Option<(LaneId, f64)>,
    /// Where it is to go at the next junction.
    pub(crate) aim: Option<Aim>,
    pub(crate) rights_of_way: Vec<RightOfWay>,
    /// Seconds in a queue, and whether it would pull out of it into a lane beside.
    pub(crate) queued_s: f64,
    pub(crate) pulls_out: bool,
    /// Seconds standing before a junction.
    pub(crate) waited_s: f64,
    /// Seconds for which it has stood or crept, wherever, but at a halt of its own.
    pub(crate) stands_s: f64,
    /// What an incident makes it do.
    pub(crate) order: Option<Order>,
    /// A halt at the kerb to come or under way.
    pub(crate) kerb_halt: Option<KerbHalt>,
    /// Whether it passes queues at red lights, and how it does so now.
    pub(crate) rides_past_queues: bool,
    pub(crate) filtering: Option<Filtering>,

    pub(crate) pose: Pose,
    pub(crate) yaw: f64,
    /// The point that follows the lane.
    pub(crate) pivot: DVec3,
    pub(crate) roll: f64,
    pub(crate) steer: f64,
    pub(crate) velocity: Vec3,
    pub(crate) rolled: f64,
    pub(crate) trailer: Option<TrailerState>,
    pub(crate) lights: VehicleLights,
    pub(crate) brake_hold_s: f64,
    /// Where the indicators show, lit or not.
    pub(crate) indicating: Option<Side>,
}

/// How far somebody so fast comes who brakes firmly, metres.
pub(crate) fn firm_stop_m(speed_mps: f64) -> f64 {
    const FIRM_MPS2: f64 = 3.0;
    speed_mps * speed_mps / (2.0 * FIRM_MPS2)
}

impl Vehicle {
    pub(crate) fn new(
        spec: &VehicleSpec,
        asset: VehicleRef,
        driver: Driver,
        lane: LaneId,
        s: f64,
        stream: Stream,
    ) -> Self {
        Self {
            asset,
            class: spec.class,
            ridden: spec.ridden,
            half_length: 0.5 * f64::from(spec.length_m),
            half_width: 0.5 * f64::from(spec.width_m),
            wheelbase: f64::from(spec.front_axle_m - spec.rear_axle_m).max(0.6),
            rear_axle: f64::from(-spec.rear_axle_m),
            driver,
            stream,
            on_call: false,
            drawn: false,
            route: VecDeque::from([lane]),
            here: 0,
            s,
            speed: 0.0,
            acceleration: 0.0,
            shift: None,
            tail: None,
            intent: None,
            aim: None,
            rights_of_way: Vec::new(),
            queued_s: 0.0,
            pulls_out: false,
            waited_s: 0.0,
            stands_s: 0.0,
            order: None,
            kerb_halt: None,
            rides_past_queues: false,
            filtering: None,
            pose: Pose::default(),
            yaw: 0.0,
            pivot: DVec3::ZERO,
            roll: 0.0,
            steer: 0.0,
            velocity: Vec3::ZERO,
            rolled: 0.0,
            trailer: TrailerState::of(spec),
            lights: VehicleLights::default(),
            brake_hold_s: 0.0,
            indicating: None,
        }
    }

    pub(crate) fn lane(&self) -> LaneId {
        self.route[self.here]
    }

    /// Lanes from here on, each with the distance from the origin to its beginning (negative for the first).
    pub(crate) fn ahead<'a>(&'a self, roads: &'a Roads) -> impl Iterator<Item = (LaneId, f64)> + 'a {
        let mut base = -self.s;
        self.route.iter().skip(self.here).map(move |&lane| {
            let start = base;
            base += roads.table(lane).length;
            (lane, start)
        })
    }

    /// Distance from the origin to the beginning of a lane of the route (negative if it lies behind); `None` if the
    /// lane is not on it any more.
    pub(crate) fn distance_to(&self, roads: &Roads, lane: LaneId) -> Option<f64> {
        let mut base = -self.s;
        for i in (0..self.here).rev() {
            base -= roads.table(self.route[i]).length;
        }
        for &l in &self.route {
            if l == lane {
                return Some(base);
            }
            base += roads.table(l).length;
        }
        None
    }

    /// Extends the route at random up to the horizon.
    pub(crate) fn plan(&mut self, roads: &Roads) {
        let mut reach: f64 =
            self.ahead(roads).map(|(lane, base)| base + roads.table(lane).length).last().unwrap_or(0.0);
        while reach < HORIZON_M || self.route.back().is_some_and(|&l| roads.table(l).junction.is_some()) {
            let Some(&last) = self.route.back() else { return };
            let allowed = roads.allowed(self.asset.model);
            let preference = |choices: &[LaneId]| roads.attraction.preference(choices, self.drawn);
            let next = roads.network.next_lane_preferring(last, allowed, preference, &mut self.stream);
            let Some(next) = next else { return };
            self.route.push_back(next);
            reach += roads.table(next).length;
        }
    }

    /// Whether it swings out in bends.
    pub(crate) fn long(&self) -> bool {
        2.0 * self.half_length >= SWINGS_OUT_M
    }

    /// The parts of lanes the body covers.
    pub(crate) fn covers(&self, roads: &Roads, into: &mut Vec<LaneCover>) {
        into.clear();
        let mut base = 0.0;
        // Lanes behind.
        for i in (0..self.here).rev() {
            base += roads.table(self.route[i]).length;
            let at = self.s + base;
            if at - self.half_length < roads.table(self.route[i]).length {
                into.push(LaneCover { lane: self.route[i], rear: at - self.half_length, front: at + self.half_length });
            }
        }
        for (lane, base) in self.ahead(roads) {
            if base > self.half_length {
                break;
            }
            into.push(LaneCover { lane, rear: -base - self.half_length, front: -base + self.half_length });
        }
        if let Some(shift) = self.shift {
            let at = self.s + shift.from_minus_here;
            into.push(LaneCover { lane: shift.from, rear: at - self.half_length, front: at + self.half_length });
        }
        if let Some(tail) = self.tail {
            let at = self.s + tail.from_minus_here;
            into.push(LaneCover { lane: tail.from, rear: at - self.half_length, front: at });
        }
    }

    /// What it takes of the width of its lane, on the way to its place there too.
    pub(crate) fn across(&self) -> Across {
        if self.shift.is_some() || self.tail.is_some() || self.order.is_some() || self.kerb_halt.is_some() {
            return Across::WHOLE;
        }
        let usual_m = self.driver.lateral_m;
        let Some(way) = self.filtering else {
            // Who has just changed lanes may stand aslant in a queue: both ends reach further aside than the middle.
            let queues = self.speed < QUEUES_MPS && self.rights_of_way.is_empty();
            let aslant_m = if queues { self.half_length * self.steer.abs() } else { 0.0 };
            return Across::between(usual_m - aslant_m, usual_m + aslant_m, self.half_width);
        };
        let ((now_m, slope), goal_m) = (way.aside(self.rolled), way.goal_m());
        // Who stands aslant has its rear where it comes from.
        let rear_m = now_m - slope * 2.0 * self.half_length;
        let [right_m, left_m] =
            [rear_m.min(now_m).min(goal_m), rear_m.max(now_m).max(goal_m)].map(|aside_m| usual_m + aside_m);
        Across::between(right_m, left_m, self.half_width)
    }

    /// Whether it stands parked, off its lane.
    pub(crate) fn is_parked(&self) -> bool {
        self.kerb_halt.is_some_and(|halt| halt.is_parked())
    }

    /// Its body seen from above, with a margin all round, metres.
    pub(crate) fn footprint(&self, specs: &[VehicleSpec], margin_m: f64) -> OrientedRectangle {
        let spec = &specs[self.asset.model.index()];
        OrientedRectangle::new(spec, self.pose.position.as_dvec3().truncate(), self.yaw, margin_m)
    }

    /// Where it could stand at the earliest if it braked firmly, metres from now.
    pub(crate) fn firm_stop_m(&self) -> f64 {
        firm_stop_m(self.speed)
    }

    /// Whether an order makes it go on as if this control were not there.
    pub(crate) fn takes_no_notice(&self, control: TrafficControl) -> bool {
        self.order.is_some_and(|order| order.runs(control))
    }

    pub(crate) fn right_of_way_at(&self, junction: JunctionId) -> Option<&RightOfWay> {
        self.rights_of_way.iter().find(|g| g.junction == junction)
    }
}
