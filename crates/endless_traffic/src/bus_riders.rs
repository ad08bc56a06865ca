//! People who get on and off buses: one after another, the nearest first, by the front door of a bus that stands at its stop. Who is
//! inside is not seen; they come out again at another stop.

use crate::body_contact::{bound, nearest_within};
use crate::bus_errand::{BusErrand, Ride, Through};
use crate::bus_stop::DOOR_M;
use crate::kerb_room::sign;
use crate::people_grid::Passer;
use crate::roads::Roads;
use crate::stop_places::StopPlace;
use crate::vehicle::Vehicle;
use crate::walk_strip::{APART_M, BODY_M, height};
use crate::walker::Walker;
use endless_world::VehicleRef;
use endless_world::math::f64::{atan2, sin_cos, wrap_angle};
use endless_world::math::segment::share_along;
use endless_world::walking::Footsteps;
use glam::DVec2;

/// Who gets on vanishes, and who gets off appears, so far inside of the bus, metres.
const INSIDE_M: f64 = 0.5;
/// Room between a bus and the places where people wait, metres: with less they would stand in its way, with more it is too far.
const KERB_M: [f64; 2] = [0.3, 2.6];
/// Who gets off goes so far beyond the kerb, metres.
const BEYOND_M: f64 = 0.35;
/// Kept between a bus and who goes along it to its door, metres.
const BESIDE_BUS_M: f64 = 0.02;
/// The way out is clear if nobody is within this of it, metres.
const CLEAR_M: f64 = 0.8;
/// Somebody inside gets off after this time at a stop on average, seconds.
const GETS_OFF_S: f64 = 5.0;
/// A bus waits for nobody any more when it has stood for so long, seconds.
const WAITS_S: f64 = 75.0;
/// Who is not through the door after this time gives up, seconds.
const GIVES_UP_S: f64 = 15.0;
/// How fast people get on and off, m/s, get going, m/s², and turn, rad/s.
const PACE_MPS: f64 = 0.9;
const ACCELERATION: f64 = 1.5;
const TURN_RATE: f64 = 3.5;
/// So near to a point of their way people have come to it, metres.
const THERE_M: f64 = 0.12;

/// An open door.
struct Door {
    bus: VehicleRef,
    stop: usize,
    inside: DVec2,
    /// Unit vector out of it.
    out: DVec2,
}

/// Opens the doors of buses that stand at stops: lets people off and on, and keeps the buses until they are.
pub(crate) fn step(roads: &Roads, vehicles: &mut [Vehicle], walkers: &mut [Walker], step_s: f64) {
    for i in 0..vehicles.len() {
        let Some(halt) = vehicles[i].kerb_halt else { continue };
        let Some((stop, stood_s)) = halt.at_stop() else { continue };
        let asset = vehicles[i].asset;
        if walkers.iter().any(|walker| walker.bus.ride.as_ref().and_then(Ride::at_door_of) == Some(asset)) {
            vehicles[i].kerb_halt = Some(halt.held());
            continue;
        }
        if stood_s > WAITS_S || !halt.stands() {
            continue;
        }
        let door = door(roads, &vehicles[i], stop);
        let is_there = |bus: VehicleRef| bus == asset || vehicles.iter().all(|vehicle| vehicle.asset != bus);
        let inside = |walker: &Walker| matches!(walker.bus.ride, Some(Ride::Inside(bus)) if is_there(bus));
        let riders: Vec<usize> = (0..walkers.len()).filter(|&k| inside(&walkers[k])).collect();
        let rider = riders.into_iter().find(|&k| walkers[k].stream.chance(step_s / GETS_OFF_S));
        let off = rider.is_some_and(|rider| get_off(roads, &door, walkers, rider));
        if !off {
            get_on(&door, walkers);
        }
    }
}

fn door(roads: &Roads, bus: &Vehicle, stop: usize) -> Door {
    let (sin, cos) = sin_cos(bus.yaw);
    let ahead = DVec2::new(cos, sin);
    let left = bus.kerb_halt.map_or(-1.0, |halt| sign(halt.side));
    let out = ahead.perp() * left;
    let half_width = 0.5 * f64::from(roads.specs[bus.asset.model.index()].width_m);
    let middle = bus.pose.position.as_dvec3().truncate();
    let inside = middle + ahead * (bus.half_length - DOOR_M) + out * (half_width - INSIDE_M);
    Door { bus: bus.asset, stop, inside, out }
}

/// Where somebody at the kerb, in line with this place of the stop, is opposite to the door.
fn opposite(door: &Door, place: DVec2) -> Option<DVec2> {
    let away_m = (place - door.inside).dot(door.out);
    let kerb_m = away_m - INSIDE_M;
    (kerb_m > KERB_M[0] && kerb_m < KERB_M[1]).then(|| door.inside + door.out * away_m)
}

/// The nearest of those who wait at the stop goes to the door.
fn get_on(door: &Door, walkers: &mut [Walker]) {
    let waits = |walker: &Walker| {
        let place = walker.bus.stands_at(walker.position).filter(|place| place.stop == door.stop)?;
        opposite(door, place.at).map(|kerb| (kerb, walker.position.distance(kerb)))
    };
    let nearest = walkers.iter().enumerate().filter_map(|(k, walker)| Some((k, waits(walker)?)));
    let Some((k, (kerb, _))) = nearest.min_by(|a, b| a.1.1.total_cmp(&b.1.1)) else { return };
    let through = Through { bus: door.bus, points: [kerb, door.inside], inside: door.inside, next: 0, since_s: 0.0 };
    walkers[k].bus = BusErrand::riding(Ride::GettingOn(through));
}

/// Somebody comes out of the door, if the way is clear.
fn get_off(roads: &Roads, door: &Door, walkers: &mut [Walker], rider: usize) -> bool {
    let near = |place: &&StopPlace| opposite(door, place.at).map(|kerb| kerb.distance(place.at));
    let places = roads.stop_places.at(door.stop).filter_map(|place| Some((near(&place)?, place)));
    let Some((_, place)) = places.min_by(|a, b| a.0.total_cmp(&b.0)) else { return false };
    let Some(kerb) = opposite(door, place.at) else { return false };
    let beyond = kerb + door.out * BEYOND_M;
    let way = beyond - door.inside;
    let off_m = |at: DVec2| at.distance(door.inside + way * share_along(at, door.inside, beyond));
    let clear = |other: &Walker| other.bus.is_inside() || off_m(other.position) > CLEAR_M;
    if !walkers.iter().all(clear) {
        return false;
    }
    let walker = &mut walkers[rider];
    let mut nodes = roads.network.walk.edges[place.edge.index()].nodes;
    if walker.stream.chance(0.5) {
        nodes.reverse();
    }
    let through = Through { bus: door.bus, points: [kerb, beyond], inside: door.inside, next: 0, since_s: 0.0 };
    (walker.from, walker.way) = (nodes[0], [(place.edge, nodes[1])].into());
    walker.around_corner = false;
    walker.passed += 1;
    walker.bus = BusErrand::after_ride(Ride::GettingOff(through), place.stop, walker.passed);
    (walker.stuck, walker.crowded_s, walker.jaywalk, walker.company) = ((0.0, 0.0), 0.0, None, None);
    walker.position = door.inside;
    walker.velocity = DVec2::ZERO;
    walker.intent = DVec2::ZERO;
    walker.yaw = atan2(door.out.y, door.out.x);
    walker.steps = Footsteps::new(&walker.spec, walker.position, walker.yaw);
    walker.height = height(roads, walker.from, walker.way[0], walker.position);
    true
}

impl Walker {
    /// Moves on somebody who gets on or off a bus, among those who are near.
    pub(crate) fn go_through(
        &mut self,
        roads: &Roads,
        mut through: Through,
        gets_on: bool,
        near: &[Passer],
        step_s: f64,
    ) {
        through.since_s += step_s;
        let left = through.points[through.next] - self.position;
        let wanted = left.normalize_or_zero() * PACE_MPS.min(3.0 * left.length() + 0.2);
        self.intent = wanted;
        let change = (wanted - self.velocity).clamp_length_max(ACCELERATION * step_s);
        let mut bounds = self.bounds_of_bodies(roads, near, APART_M, step_s);
        if gets_on && through.next == 0 {
            // Past the others, but not into the bus beside its door.
            let out = (through.points[0] - through.inside).normalize_or_zero();
            let room_m = (self.position - through.inside).dot(out) - INSIDE_M - BODY_M - BESIDE_BUS_M;
            bounds.push(bound(-out, room_m, step_s));
        }
        self.velocity = nearest_within(&bounds, self.velocity + change);
        self.position += self.velocity * step_s;
        self.walked += self.velocity.length() * step_s;
        let off = wrap_angle(atan2(left.y, left.x) - self.yaw);
        self.yaw = wrap_angle(self.yaw + (off * 5.0).clamp(-TURN_RATE, TURN_RATE) * step_s);
        self.steps.advance(self.position, self.yaw, self.velocity, step_s);
        self.gait = self.steps.gait(self.velocity.length(), false);
        self.height = height(roads, self.from, self.way[0], self.position);
        if self.position.distance(through.points[through.next]) < THERE_M {
            through.next += 1;
        }
        let from_inside_m = self.position.distance(through.inside);
        let behind_door = from_inside_m < INSIDE_M - THERE_M;
        // Nobody gives up half in the door.
        let clear = behind_door || from_inside_m > INSIDE_M + BODY_M;
        self.bus.ride = if through.next >= through.points.len() {
            gets_on.then_some(Ride::Inside(through.bus))
        } else if clear && through.since_s > GIVES_UP_S {
            behind_door.then_some(Ride::Inside(through.bus))
        } else {
            Some(if gets_on { Ride::GettingOn(through) } else { Ride::GettingOff(through) })
        };
        if self.bus.is_inside() {
            (self.velocity, self.intent) = (DVec2::ZERO, DVec2::ZERO);
        }
    }
}
