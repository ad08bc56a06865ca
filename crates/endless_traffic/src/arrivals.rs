//! Open borders: for every vehicle that has left the map another comes, where a road begins.

use crate::crossing::CrossingState;
use crate::driver::Driver;
use crate::emergency;
use crate::filtering;
use crate::kinematics;
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::settings::{DrivingCondition, TrafficSettings};
use crate::steering::{SIGHT_M, speed_ahead};
use crate::vehicle::Vehicle;
use crate::vehicle_mix;
use endless_road::LaneId;
use endless_road::swept::OrientedRectangle;
use endless_world::{Region, Stream, VehicleModelId, VehicleRef, VehicleSpec, choose_vehicle};

/// Who waits so long for room to come takes another road, seconds.
const PATIENCE_S: f64 = 6.0;
/// Braking with which a newcomer may have to begin, m/s².
const BRAKING: f64 = 1.0;
/// Room kept to all other bodies, metres.
const CLEAR_M: f64 = 1.0;
/// Others further away are not asked whether they stand there, metres.
const NEAR_M: f64 = 40.0;
/// Nobody is to be on a lane that runs into the entry within this before and beyond it, metres.
const BESIDE_M: f64 = 25.0;

/// What newcomers see.
pub(crate) struct ArrivalView<'a> {
    pub(crate) roads: &'a Roads,
    pub(crate) occupancy: &'a Occupancy,
    pub(crate) vehicles: &'a [Vehicle],
    pub(crate) crossings: &'a [CrossingState],
    /// The weather that they drive in.
    pub(crate) condition: &'a DrivingCondition,
}

/// Those who are to come.
#[derive(Debug, Clone)]
pub(crate) struct Arrivals {
    seed: u64,
    /// Vehicles that there are to be.
    wanted: usize,
    drawn: u64,
    /// Each at the beginning of its entry, and for how long it has waited, seconds.
    waiting: Vec<(Vehicle, f64)>,
    /// Bodies of parked vehicles.
    parked: Vec<OrientedRectangle>,
    /// How often each model comes.
    frequencies: Vec<f64>,
    /// Of the drivers, 0 to 1, and where they drive.
    aggressiveness: f64,
    region: Region,
}

impl Arrivals {
    /// For a number of vehicles that shall stay the same.
    pub(crate) fn new(
        specs: &[VehicleSpec],
        settings: &TrafficSettings,
        wanted: usize,
        parked: Vec<OrientedRectangle>,
    ) -> Self {
        let TrafficSettings { seed, profile, .. } = settings;
        let frequencies = vehicle_mix::frequencies(specs, profile);
        let (aggressiveness, region) = (profile.aggressiveness, profile.region);
        Self { seed: *seed, wanted, drawn: 0, waiting: Vec::new(), parked, frequencies, aggressiveness, region }
    }

    /// The bodies of parked vehicles.
    pub(crate) fn parked(&self) -> &[OrientedRectangle] {
        &self.parked
    }

    /// To a road that was so wet, and is now.
    pub(crate) fn adapt(&mut self, from: &DrivingCondition, to: &DrivingCondition) {
        for (vehicle, _) in &mut self.waiting {
            vehicle.driver.adapt(from, to);
        }
    }

    /// Those who come in this step. They are not among the vehicles yet.
    pub(crate) fn step(&mut self, view: &ArrivalView<'_>, step_s: f64) -> Vec<Vehicle> {
        let entries = &view.roads.borders.entries;
        if entries.is_empty() {
            return Vec::new();
        }
        while view.vehicles.len() + self.waiting.len() < self.wanted {
            let Some(vehicle) = self.draw(view) else { break };
            self.waiting.push((vehicle, 0.0));
        }
        let mut come: Vec<Vehicle> = Vec::new();
        let mut asked: Vec<LaneId> = Vec::new();
        for (mut vehicle, waited_s) in std::mem::take(&mut self.waiting) {
            // One after the other.
            let entry = vehicle.route[0];
            let first = !asked.contains(&entry);
            asked.push(entry);
            if first && self.enters(view, &mut vehicle, &come) {
                come.push(vehicle);
            } else if waited_s < PATIENCE_S {
                self.waiting.push((vehicle, waited_s + step_s));
            }
        }
        come
    }

    /// Somebody, at the beginning of a road; `None` if no model can come.
    fn draw(&mut self, view: &ArrivalView<'_>) -> Option<Vehicle> {
        let ArrivalView { roads, vehicles, .. } = *view;
        let mut own = Stream::named(self.seed, "traffic.arrival", &[self.drawn]);
        self.drawn += 1;
        let open = |model: VehicleModelId| {
            let allowed = roads.allowed(model);
            roads.borders.entries.iter().copied().filter(|entry| allowed[entry.index()]).collect::<Vec<_>>()
        };
        let comes = |(place, frequency): (usize, &f64)| {
            if open(VehicleModelId::from_index(place)).is_empty() { 0.0 } else { *frequency }
        };
        let weights: Vec<f64> = self.frequencies.iter().enumerate().map(comes).collect();
        let model = choose_vehicle(&mut own, roads.specs.iter().zip(weights))?;
        let spec = &roads.specs[model.index()];
        let entries = open(model);
        let drawn = roads.attraction.draws(&mut own);
        let entry = entries[own.weighted(&roads.attraction.preference(&entries, drawn))];
        let others = || vehicles.iter().chain(self.waiting.iter().map(|(vehicle, _)| vehicle));
        let taken = |variant| others().any(|v| v.asset == VehicleRef { model, variant });
        let variant = vehicle_mix::looks(spec, self.region).draw(own.next_u64(), taken);
        let driver = Driver::new(spec, view.condition, self.aggressiveness, &mut own);
        let half = 0.5 * f64::from(spec.length_m);
        let mut vehicle = Vehicle::new(spec, VehicleRef { model, variant }, driver, entry, half, own);
        emergency::call(roads, &mut vehicle);
        vehicle.drawn = drawn;
        vehicle.rides_past_queues = filtering::rides_past_queues(&vehicle, self.region);
        vehicle.plan(roads);
        while vehicle.s > roads.table(vehicle.lane()).length && vehicle.here + 1 < vehicle.route.len() {
            vehicle.s -= roads.table(vehicle.lane()).length;
            vehicle.here += 1;
        }
        Some(vehicle)
    }

    /// Whether there is room for a newcomer, who then has a speed and a pose.
    fn enters(&self, view: &ArrivalView<'_>, vehicle: &mut Vehicle, come: &[Vehicle]) -> bool {
        let Some(speed) = entry_speed(view, vehicle) else { return false };
        vehicle.speed = speed;
        kinematics::settle(vehicle, view.roads);
        let specs = &view.roads.specs;
        let body = vehicle.footprint(specs, CLEAR_M);
        let touches = |other: &Vehicle| {
            let apart = other.pose.position - vehicle.pose.position;
            let near = apart.length() < NEAR_M as f32;
            near && body.overlaps(&other.footprint(specs, 0.0))
        };
        let parked = |other: &OrientedRectangle| other.center.distance(body.center) < NEAR_M && body.overlaps(other);
        !view.vehicles.iter().chain(come).any(touches) && !self.parked.iter().any(parked)
    }
}

/// The speed at which somebody comes, m/s; `None` if there is no room.
fn entry_speed(view: &ArrivalView<'_>, vehicle: &Vehicle) -> Option<f64> {
    let ArrivalView { roads, occupancy, crossings, .. } = *view;
    let half = vehicle.half_length;
    let mut speed = speed_ahead(roads, vehicle);
    let stops_in = |room_m: f64| (2.0 * vehicle.driver.brake * room_m.max(0.0)).sqrt();
    for (lane, base) in vehicle.ahead(roads) {
        let table = roads.table(lane);
        if table.junction.is_some() && base > 0.0 {
            speed = speed.min(stops_in(base - half - table.setback - 2.0));
            break;
        }
        for cut in &table.cuts {
            let [rear, front] = [cut.range.0, cut.range.1].map(|s| base + s);
            let state = &crossings[cut.crossing.index()];
            if rear < half && front > -half && (state.wanted || !state.people.is_empty()) {
                return None;
            }
            if rear >= half {
                speed = speed.min(stops_in(rear - half - 2.0));
            }
        }
        let beside = table.alongside.iter().filter(|beside| base + beside.range.0 < half + BESIDE_M);
        for beside in beside {
            let (from, to) = (beside.other_range.0 - BESIDE_M, beside.other_range.0 + BESIDE_M);
            if occupancy.on(beside.lane).iter().any(|o| o.front > from && o.rear < to) {
                return None;
            }
        }
    }
    let Some(leader) = occupancy.leader_of(roads, vehicle, usize::MAX, SIGHT_M) else { return Some(speed) };
    let gently = |speed: &f64| vehicle.driver.follow(*speed, leader.gap, leader.speed) > -BRAKING;
    [speed, speed.min(leader.speed)].into_iter().find(gently)
}

/// Whether a vehicle has come to where its road leaves the map.
pub(crate) fn has_left(roads: &Roads, vehicle: &Vehicle) -> bool {
    let lane = vehicle.lane();
    vehicle.here + 1 == vehicle.route.len()
        && roads.is_exit(lane)
        && vehicle.s + vehicle.half_length >= roads.table(lane).length
}
