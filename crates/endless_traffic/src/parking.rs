//! Parking at the kerb: drivers pull into free bays beside their lane, stand there for minutes, and pull out again.

use crate::bay_way::BayWay;
use crate::emergency::is_emergency;
use crate::kerb_halt::{KerbHalt, Phase};
use crate::kinematics;
use crate::parking_manoeuvre::bay_way;
use crate::parking_place::ParkingPlace;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::LaneId;
use endless_road::swept::OrientedRectangle;
use endless_world::math::f64::{exp, ln};
use endless_world::{ObjectClass, Stream};
use std::collections::VecDeque;
use std::sync::Arc;

/// How often somebody comes to park, of each bay: where one may stand for an hour each changes hands once an hour, and four of five
/// are taken (defaults of the Highway Capacity Manual 2000, exhibit 10-20: 16 manoeuvres an hour, in and out, along 10 bays).
const COMES_PER_H: f64 = 0.8;
/// Free bays have those of the taken ones, too, but no more than this, an hour.
const MOST_PER_H: f64 = 8.0;
/// How long they stand, seconds: those who stand for longer are the town's own parked vehicles.
const STANDS_S: [f64; 2] = [60.0, 480.0];
/// Of the vehicles so many are parked at a time at most, and at the beginning.
const MOST_SHARE: f64 = 0.12;
const FIRST_SHARE: f64 = 0.06;
/// How long those stand who are parked at the beginning, seconds.
const FIRST_STAND_S: [f64; 2] = [27.0, 85.0];
/// A place in sight is so many times as likely for them.
const IN_SIGHT: f64 = 30.0;
/// Places tried for one of them.
const TRIES: u32 = 12;
/// Longer vehicles do not park at kerbs, metres.
const LONGEST_M: f64 = 5.6;
/// Places are looked for this far ahead, metres, and before they pull in drivers have so much more than it takes to brake.
const LOOKS_M: f64 = 100.0;
const SPARE_M: f64 = 20.0;
/// Braking before a place, m/s².
const BRAKING_MPS2: f64 = 1.4;
/// Two who park keep so far apart, from middle to middle, metres: none is in the other's way.
const APART_M: f64 = 28.0;
/// Others who halt on the lane are no nearer, metres.
const FROM_HALTS_M: f64 = 60.0;

/// Where and how often drivers park.
#[derive(Debug, Clone, Default)]
pub(crate) struct KerbParking {
    places: Arc<Vec<ParkingPlace>>,
    /// When the next driver parks at each, seconds.
    next_s: Vec<f64>,
    /// From one to the next, seconds.
    mean_s: f64,
    seed: u64,
    drawn: u64,
}

impl KerbParking {
    /// At these of so many bays, from a time on; `share`: of the vehicles that park on a map as it is, 0 to 1.
    pub(crate) fn new((places, bays): (Vec<ParkingPlace>, usize), share: f64, seed: u64, from_s: f64) -> Self {
        let per_h = (COMES_PER_H * share * bays as f64 / places.len().max(1) as f64).min(MOST_PER_H);
        if per_h <= 0.0 || places.is_empty() {
            return Self::default();
        }
        let number = places.len();
        let mut parking = Self { places: Arc::new(places), next_s: Vec::new(), mean_s: 3600.0 / per_h, seed, drawn: 0 };
        parking.next_s = (0..number).map(|_| from_s + parking.interval_s()).collect();
        parking
    }

    /// Who parks sweeps this.
    pub(crate) fn swept(&self) -> impl Iterator<Item = OrientedRectangle> + '_ {
        let own =
            |place: &ParkingPlace| place.bays.iter().find(|bay| bay.center == place.at).map(|bay| place.swept(bay));
        self.places.iter().filter_map(own)
    }

    fn interval_s(&mut self) -> f64 {
        self.drawn += 1;
        let own = Stream::named(self.seed, "traffic.parking.interval", &[self.drawn]).range_f64(0.0, 1.0);
        -self.mean_s * ln((1.0 - own).max(1e-9))
    }

    fn on(&self, lane: LaneId) -> std::ops::Range<usize> {
        let from = self.places.partition_point(|place| place.lane < lane);
        from..from + self.places[from..].partition_point(|place| place.lane == lane)
    }

    /// A driver may find a place. To be called once a second.
    pub(crate) fn look_out(&mut self, roads: &Roads, vehicles: &mut [Vehicle], i: usize, time_s: f64) {
        let me = &vehicles[i];
        let busy = me.kerb_halt.is_some() || me.order.is_some() || me.shift.is_some() || me.intent.is_some();
        if self.places.is_empty() || busy || me.filtering.is_some() || me.speed < 2.0 || !parks(roads, me) {
            return;
        }
        if let Some((number, halt)) = self.place(roads, vehicles, i, time_s) {
            vehicles[i].kerb_halt = Some(halt);
            self.next_s[number] = time_s + self.interval_s();
        }
    }

    fn place(&self, roads: &Roads, vehicles: &[Vehicle], i: usize, time_s: f64) -> Option<(usize, KerbHalt)> {
        let me = &vehicles[i];
        let most = (MOST_SHARE * vehicles.len() as f64).ceil() as usize;
        // Who may pass a junction already does so.
        let passes_m = me.rights_of_way.iter().filter(|right| !right.entered);
        let passes_m = passes_m.filter_map(|right| me.distance_to(roads, right.exit)).fold(0.0, f64::max);
        for (lane, base) in me.ahead(roads).take_while(|(_, base)| *base < LOOKS_M) {
            for number in self.on(lane).filter(|&number| self.next_s[number] <= time_s) {
                let place = &self.places[number];
                let ahead_m = base + place.s;
                let least_m = (SPARE_M + brakes_m(me.speed)).max(passes_m);
                if !(least_m..LOOKS_M).contains(&ahead_m) || !self.is_free(vehicles, place, most) {
                    continue;
                }
                let Some(way) = bay_way(roads, me, place, number) else { continue };
                let halt = place.halt(way, me, ahead_m, stands_s(me));
                return Some((number, halt));
            }
        }
        None
    }

    /// Whether nobody who parks or halts is near a place, and not too many park.
    fn is_free(&self, vehicles: &[Vehicle], place: &ParkingPlace, most: usize) -> bool {
        let halts = || vehicles.iter().filter_map(|other| other.kerb_halt);
        let is_apart = |halt: KerbHalt| match halt.bay {
            Some(way) => self.places[way.place].at.distance(place.at) > APART_M,
            None => halt.lane != place.lane || (halt.front_s - place.s).abs() > FROM_HALTS_M,
        };
        halts().filter(|halt| halt.bay.is_some()).count() < most && halts().all(is_apart)
    }

    /// Lets some of the vehicles begin at the kerb, in sight if places are.
    pub(crate) fn stand_some(&self, roads: &Roads, vehicles: &mut [Vehicle]) {
        if self.places.is_empty() {
            return;
        }
        let mut own = Stream::named(self.seed, "traffic.parking.first", &[]);
        let can: Vec<usize> = (0..vehicles.len()).filter(|&i| parks(roads, &vehicles[i])).collect();
        let number = (FIRST_SHARE * vehicles.len() as f64).round() as usize;
        let weight = |place: &ParkingPlace| {
            let seen = roads.attraction.focus.on_lane(place.lane.index(), place.s) != 0;
            if seen { IN_SIGHT } else { 1.0 }
        };
        let weights: Vec<f64> = self.places.iter().map(weight).collect();
        let apart = can.len().div_ceil(number.max(1)).max(1);
        for i in can.into_iter().step_by(apart) {
            for _ in 0..TRIES {
                let number = own.weighted(&weights);
                let place = &self.places[number];
                let allowed = roads.allowed(vehicles[i].asset.model)[place.lane.index()];
                if !allowed || !self.is_free(vehicles, place, usize::MAX) {
                    continue;
                }
                let Some(way) = bay_way(roads, &vehicles[i], place, number) else { continue };
                stand(roads, &mut vehicles[i], place, way, own.range_f64(FIRST_STAND_S[0], FIRST_STAND_S[1]));
                break;
            }
        }
    }
}

/// Puts a vehicle into a bay.
fn stand(roads: &Roads, vehicle: &mut Vehicle, place: &ParkingPlace, way: BayWay, stands_s: f64) {
    let drift = BayWay::inwards(
        vehicle.rolled - way.in_m,
        way.in_m,
        place.stands_left_m(2.0 * vehicle.half_width) - vehicle.driver.lateral_m,
    );
    let halt = place.halt(way, vehicle, 0.0, stands_s);
    let phase = Phase::Standing { left_s: stands_s };
    vehicle.kerb_halt = Some(KerbHalt { phase, drift: Some(drift), stood_s: stands_s, ..halt });
    vehicle.route = VecDeque::from([place.lane]);
    (vehicle.here, vehicle.s) = (0, place.s);
    vehicle.plan(roads);
    kinematics::settle(vehicle, roads);
}

/// How far somebody so fast comes who brakes gently, metres.
fn brakes_m(speed_mps: f64) -> f64 {
    speed_mps * speed_mps / (2.0 * BRAKING_MPS2)
}

/// Whether it is a vehicle that parks at kerbs.
fn parks(roads: &Roads, vehicle: &Vehicle) -> bool {
    let spec = &roads.specs[vehicle.asset.model.index()];
    matches!(vehicle.class, ObjectClass::Car | ObjectClass::Van)
        && spec.parks
        && vehicle.trailer.is_none()
        && 2.0 * vehicle.half_length < LONGEST_M
        && !is_emergency(spec.name)
}

/// How long somebody stands, seconds: as many for one to two minutes as for two to four.
fn stands_s(vehicle: &Vehicle) -> f64 {
    let mut own = Stream::named(vehicle.asset.variant, "traffic.parking.stand", &[vehicle.rolled.to_bits()]);
    exp(own.range_f64(ln(STANDS_S[0]), ln(STANDS_S[1])))
}
