//! The request of a vehicle to enter a junction, and which of two requests goes first.

use crate::crossing::comfortable_stop_m;
use crate::emergency::gives_up_turn;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::{JunctionId, LaneId, TrafficControl, Turn};
use endless_world::{SignalAspect, SignalState};

/// Seconds after which those who stand and have priority are taken to let others go first.
const PATIENCE_S: f64 = 2.5;
/// Seconds of waiting after which those in slow traffic let somebody in.
const COURTESY_S: f64 = 25.0;
/// Seconds after which others let somebody in, too, if they can still stop at ease.
const LONG_S: f64 = 60.0;
/// They stand for it this share of the time that the other has waited.
const COURTEOUS_SHARE: f64 = 0.25;
/// Slower than this somebody stands, m/s.
pub(super) const STANDS_MPS: f64 = 0.5;
/// Traffic is slow below this speed, m/s.
const SLOW_MPS: f64 = 4.0;

/// A vehicle before a junction that has no right of way yet.
#[derive(Debug, Clone)]
pub(crate) struct EntryRequest {
    pub(crate) vehicle: usize,
    pub(crate) junction: JunctionId,
    /// The last lane before it.
    pub(crate) before: LaneId,
    /// From the front bumper to the line, metres.
    pub(crate) distance: f64,
    /// Distance before the line at which it waits, metres.
    pub(crate) setback: f64,
    pub(crate) speed: f64,
    pub(crate) waited_s: f64,
    /// The longest wait that ends when it goes, its own or that of others behind the queue before it, seconds.
    pub(crate) pressure_s: f64,
    pub(crate) lanes: Vec<LaneId>,
    pub(crate) exit: LaneId,
    pub(crate) control: TrafficControl,
    /// Its signal stops it.
    pub(crate) held: bool,
}

impl EntryRequest {
    /// Whether no other vehicle stands between it and the line.
    pub(super) fn at_the_line(&self) -> bool {
        self.distance < 6.0 + self.setback
    }

    /// Whether it can still stop before the line.
    fn can_stop(&self) -> bool {
        self.speed < STANDS_MPS || self.distance > stopping_m(self.speed)
    }

    /// Whether it stops before the line without braking hard.
    fn stops_at_ease(&self) -> bool {
        self.distance > comfortable_stop_m(self.speed)
    }

    /// Whether it comes to the line or stands there, not in a queue before it.
    fn comes(&self) -> bool {
        self.at_the_line() || self.speed > SLOW_MPS
    }
}

/// Distance within which a driver at a yellow light would rather go on, metres.
pub(super) fn stopping_m(speed: f64) -> f64 {
    speed * speed / (2.0 * 3.0) + 0.3 * speed + 0.5
}

pub(super) fn approach_control(roads: &Roads, vehicle: &Vehicle, connector: LaneId) -> TrafficControl {
    let place = vehicle.route.iter().position(|&l| l == connector);
    place.filter(|&p| p > 0).map_or(TrafficControl::Free, |p| roads.network.lane(vehicle.route[p - 1]).end_control)
}

pub(super) fn aspect(control: TrafficControl, signals: &[SignalState]) -> Option<SignalAspect> {
    match control {
        TrafficControl::Signal(signal) => Some(signals[usize::from(signal.0)].aspect),
        _ => None,
    }
}

/// The next junction without right of way, if it is near enough to matter.
pub(super) fn request(roads: &Roads, signals: &[SignalState], vehicle: &Vehicle, i: usize) -> Option<EntryRequest> {
    let trigger = vehicle.speed * vehicle.speed / (2.0 * 1.8) + 1.2 * vehicle.speed + 8.0 + vehicle.half_length;
    let mut before = None;
    let mut lanes: Vec<LaneId> = Vec::new();
    let mut found: Option<(JunctionId, f64, LaneId)> = None;
    for (lane, base) in vehicle.ahead(roads) {
        let junction = roads.table(lane).junction;
        match found {
            None => {
                if base > trigger {
                    return None;
                }
                if let (Some(junction), Some(before)) = (junction, before)
                    && base > 0.0
                    && vehicle.right_of_way_at(junction).is_none()
                {
                    found = Some((junction, base, before));
                    lanes.push(lane);
                }
            }
            Some((inside, to_line, before)) => {
                if junction == Some(inside) {
                    lanes.push(lane);
                    continue;
                }
                let control = roads.network.lane(before).end_control;
                let light = aspect(control, signals);
                let distance = to_line - vehicle.half_length;
                if vehicle.kerb_halt.is_some_and(|halt| halt.is_before(distance)) {
                    return None;
                }
                // Who has waited at the line to turn left clears the junction when the light changes.
                let clears = light == Some(SignalAspect::Yellow)
                    && vehicle.waited_s > 1.5
                    && roads.network.lane(lanes[0]).turn == Turn::Left;
                return Some(EntryRequest {
                    vehicle: i,
                    junction: inside,
                    before,
                    distance,
                    setback: roads.table(before).setback,
                    speed: vehicle.speed,
                    waited_s: vehicle.waited_s,
                    pressure_s: vehicle.waited_s,
                    lanes,
                    exit: lane,
                    control,
                    held: light.is_some_and(|a| a != SignalAspect::Green)
                        && !clears
                        && !vehicle.takes_no_notice(control),
                });
            }
        }
        before = Some(lane);
    }
    None
}

pub(super) fn sign_allows(roads: &Roads, request: &EntryRequest) -> bool {
    let must_look = roads.network.lane(request.lanes[0]).turn == Turn::UTurn;
    match request.control {
        TrafficControl::Signal(_) => !request.held,
        TrafficControl::Stop => request.waited_s > 0.7,
        TrafficControl::Yield => request.distance < 14.0 + request.setback,
        TrafficControl::Free => !must_look || request.distance < 14.0 + request.setback,
    }
}

/// Whether `me` gives up its turn for `other`, who is on call, or in slow traffic has waited long to join it or to get across.
pub(super) fn yields_to(roads: &Roads, vehicles: &[Vehicle], me: &EntryRequest, other: &EntryRequest) -> bool {
    let meet =
        || me.lanes.iter().any(|&l| roads.table(l).conflicts(true).iter().any(|c| other.lanes.contains(&c.other)));
    let called = gives_up_turn(&vehicles[me.vehicle], &vehicles[other.vehicle], other.waited_s);
    if called && !other.held && other.comes() && me.before != other.before && me.can_stop() && meet() {
        return true;
    }
    other.waited_s > COURTESY_S
        && other.waited_s > me.waited_s
        && !other.held
        && (me.speed < SLOW_MPS || other.waited_s > LONG_S && me.stops_at_ease())
        && me.waited_s < COURTEOUS_SHARE * other.waited_s
        && (me.exit == other.exit || meet())
}

/// Whether `me` may go although `other`, which has no right of way yet, approaches too.
pub(super) fn goes_before(roads: &Roads, vehicles: &[Vehicle], me: &EntryRequest, other: &EntryRequest) -> bool {
    if other.held {
        return true;
    }
    let called = gives_up_turn(&vehicles[other.vehicle], &vehicles[me.vehicle], me.waited_s);
    if called && me.comes() && other.can_stop() {
        return true;
    }
    let driver = &vehicles[me.vehicle].driver;
    let length = 2.0 * vehicles[me.vehicle].half_length;
    // The longer the wait, the smaller the gap that is taken.
    let margin_s = (1.6 - 0.04 * me.waited_s).max(0.6) * driver.gap_factor;
    let mut base = me.distance;
    for &lane in &me.lanes {
        let long = vehicles[me.vehicle].long() || vehicles[other.vehicle].long();
        for conflict in roads.table(lane).conflicts(long).iter().filter(|c| c.gives_way) {
            let Some(k) = other.lanes.iter().position(|&l| l == conflict.other) else { continue };
            if other.speed < 0.5 {
                // Both stand: the one with priority goes, unless it has let its turn pass.
                let stuck = other.waited_s > PATIENCE_S && me.waited_s > PATIENCE_S;
                if other.at_the_line() && !stuck {
                    return false;
                }
                continue;
            }
            let before: f64 = other.lanes[..k].iter().map(|&l| roads.table(l).length).sum();
            let arrival = (other.distance + before + conflict.other_range.0) / other.speed.max(3.0);
            let gone = travel_s(base + conflict.range.1 + length, me.speed, driver.accelerate);
            if arrival < gone + margin_s {
                return false;
            }
        }
        base += roads.table(lane).length;
    }
    true
}

/// Seconds to cover a distance from a speed with an acceleration up to 9 m/s.
pub(super) fn travel_s(distance: f64, speed: f64, acceleration: f64) -> f64 {
    let distance = distance.max(0.0);
    let top = speed.max(9.0);
    let ramp = (top * top - speed * speed) / (2.0 * acceleration);
    if distance <= ramp {
        return ((speed * speed + 2.0 * acceleration * distance).sqrt() - speed) / acceleration;
    }
    (top - speed) / acceleration + (distance - ramp) / top
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
    fn who_has_waited_for_a_minute_is_let_in_by_those_who_can_stop_at_ease() {
        let spec = VehicleSpec::default();
        let line = Polyline::new([DVec3::ZERO, 100.0 * DVec3::X]);
        let network = RoadNetwork { lanes: vec![Lane::new(LaneId(0), line, 3.5, 13.9)], ..RoadNetwork::default() };
        let map = TrafficMap::new(network.finish().expect("a lane"), std::slice::from_ref(&spec));
        let roads = Roads::new(&map, &Focus::default(), &[]);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let vehicles = [0, 1].map(|k| {
            let mut stream = Stream::named(1, "test.entry_request", &[k]);
            let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
            Vehicle::new(&spec, asset, driver, LaneId(0), 20.0 + 40.0 * k as f64, stream)
        });
        // Two lanes that lead to the same one.
        let asks = |vehicle: usize, distance: f64, speed: f64, waited_s: f64| EntryRequest {
            vehicle,
            junction: JunctionId(0),
            before: LaneId(vehicle as u32),
            distance,
            setback: 0.0,
            speed,
            waited_s,
            pressure_s: waited_s,
            lanes: vec![LaneId(2 + vehicle as u32)],
            exit: LaneId(4),
            control: TrafficControl::Free,
            held: false,
        };
        let lets_in = |distance: f64, speed: f64, waited_s: f64| {
            yields_to(&roads, &vehicles, &asks(0, distance, speed, 0.0), &asks(1, 1.0, 0.0, waited_s))
        };
        assert!(lets_in(60.0, 10.0, LONG_S + 1.0));
        assert!(!lets_in(60.0, 10.0, LONG_S - 1.0), "it has not waited for long yet");
        assert!(!lets_in(10.0, 10.0, LONG_S + 1.0), "it would have to brake hard");
        assert!(lets_in(10.0, 2.0, COURTESY_S + 1.0), "in slow traffic sooner");
    }
}
