//! The simulation as a whole.

mod incidents;
mod world_state;

use crate::actor_ids::ActorIds;
use crate::actuated::ActuatedSignals;
use crate::arrivals::{ArrivalView, Arrivals, has_left};
use crate::bus_stop::BusHalts;
use crate::courtesy::{self, Courtesy};
use crate::crossing::{CrossingState, note_vehicles};
use crate::double_parking::Deliveries;
use crate::filtering::{self, RiderView};
use crate::gathering::{Gathering, LEADS_M, views_ahead};
use crate::incident::{StagedIncident, impact, road_walker, wrong_way};
use crate::jaywalk::{Roadway, people_on_lanes};
use crate::junction_controller::JunctionController;
use crate::midblock::MidblockWays;
use crate::occupancy::Occupancy;
use crate::parked_beside::ParkedBeside;
use crate::parking::KerbParking;
use crate::parking_places::parking_places;
use crate::playback::{Playback, PlayedTracks, Presence};
use crate::population::Population;
use crate::rerouting;
use crate::roads::{Roads, TrafficMap};
use crate::settings::{DrivingCondition, Fleet, TrafficSettings};
use crate::sitting::{self, BenchPlaces};
use crate::steering::DriverView;
use crate::stop_places::StopPlaces;
use crate::vehicle::Vehicle;
use crate::walk_strip::BODY_M;
use crate::walker::{Walker, WalkerView};
use crate::{bus_riders, bus_service, destination_exchange};
use crate::{kerb_halting, kinematics, lane_change, lights, signals, spawn, walker};
use endless_road::{RoadNetwork, WalkGraph};
use endless_world::{
    Actor, Behaviour, InstanceIdAllocator, Motion, Outfit, ParkedVehicle, SignalControl, SignalState, TooManyInstances,
    VehicleMotion, VehicleSpec,
};
use glam::Vec3;
use std::sync::Arc;

/// Longest step, seconds.
const STEP_S: f64 = 1.0 / 30.0;
/// Simulated before frame 0 where nobody is simulated: trailers and feet come to where the tracks lead them, seconds.
const PLAYBACK_WARM_UP_S: f64 = 5.0;

/// Everything that moves in one scene.
#[derive(Debug, Clone)]
pub struct Simulation {
    roads: Roads,
    graph: WalkGraph,
    condition: DrivingCondition,
    /// What people wear, from when they left home.
    outfit: Outfit,
    population: Population,
    parked: Vec<Actor>,
    vehicles: Vec<Vehicle>,
    walkers: Vec<Walker>,
    ids: ActorIds,
    arrivals: Arrivals,
    occupancy: Occupancy,
    controller: JunctionController,
    crossings: Vec<CrossingState>,
    courtesies: Vec<Courtesy>,
    /// Where buses stop.
    bus_halts: Arc<BusHalts>,
    deliveries: Arc<Deliveries>,
    parking: KerbParking,
    roadway: Roadway,
    signals: Vec<SignalState>,
    /// What controls them, where their plans are not fixed.
    actuated: Option<ActuatedSignals>,
    /// Those who move as recorded tracks say.
    playback: Option<Playback>,
    /// Until the first frame.
    gathering: Option<Gathering>,
    /// Incidents to come and those that happen.
    staged: Vec<StagedIncident>,
    fps: f64,
    frame: u32,
    steps: u64,
    time_s: f64,
}

impl Simulation {
    /// Spawns in rest pose on a network and simulates the warm-up; frame 0 is the first to record. Vehicles keep clear of
    /// those that stand parked.
    ///
    /// # Errors
    /// When there are more vehicles, riders and people than [`InstanceId`](endless_world::InstanceId) can number.
    ///
    /// # Panics
    /// If the frame rate is not positive, or a parked vehicle's model is not in the fleet.
    pub fn new(
        network: &RoadNetwork,
        fleet: &Fleet<'_>,
        parked: &[ParkedVehicle],
        settings: &TrafficSettings,
    ) -> Result<Self, TooManyInstances> {
        Self::on_map(&TrafficMap::new(network.clone(), fleet.vehicles), fleet, parked, settings)
    }

    /// The same on a map that was made of this fleet's models.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Panics
    /// As [`Self::new`].
    pub fn on_map(
        map: &TrafficMap,
        fleet: &Fleet<'_>,
        parked: &[ParkedVehicle],
        settings: &TrafficSettings,
    ) -> Result<Self, TooManyInstances> {
        Self::playing(map, fleet, parked, settings, None)
    }

    /// The same, with those who move as recorded tracks say: they come in addition to those that the settings ask for.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Panics
    /// As [`Self::new`].
    pub fn playing(
        map: &TrafficMap,
        fleet: &Fleet<'_>,
        parked: &[ParkedVehicle],
        settings: &TrafficSettings,
        played: Option<&PlayedTracks<'_>>,
    ) -> Result<Self, TooManyInstances> {
        let fps = settings.fps;
        assert!(fps > 0.0, "frames per second must be positive");
        let mut roads = Roads::new(map, &settings.focus, &settings.errands);
        let standing = spawn::standing(fleet.vehicles, parked);
        let bus_halts = Arc::new(BusHalts::new(&roads, &settings.bus_stops, &standing));
        // Those who play tracks know nothing of who parks.
        let bays = if played.is_some() { &[][..] } else { &settings.parking_bays };
        let places = parking_places(&roads, bays, &standing, &bus_halts);
        let warm_up_s = spawn::warm_up_s(&roads, fleet.vehicles.len());
        let parking = KerbParking::new(places, settings.profile.parked, settings.seed, -warm_up_s);
        if settings.jaywalking > 0.0 {
            let in_the_way: Vec<_> = standing.iter().copied().chain(parking.swept()).collect();
            roads.midblock = Arc::new(MidblockWays::new(&roads.network, &roads.borders, &in_the_way));
        }
        roads.stop_places = Arc::new(StopPlaces::new(&roads.network, &settings.bus_stops, BODY_M));
        roads.benches = Arc::new(BenchPlaces::new(&roads.network, &settings.bench_seats, BODY_M));
        roads.parked_beside = Arc::new(ParkedBeside::new(&roads.network, fleet.vehicles, parked, BODY_M));
        let network = &roads.network;
        let graph = WalkGraph::new(&network.walk);
        let mut vehicles = spawn::vehicles(&roads, fleet.vehicles, &standing, settings);
        parking.stand_some(&roads, &mut vehicles);
        let walkers = spawn::walkers(&roads, &graph, fleet.pedestrian, settings);
        let people = walkers.iter().map(|walker| (fleet.pedestrian)(walker.variant));
        let gathering = Gathering::new(&roads, &standing, people, settings.seed);
        let profile = &settings.profile;
        let rains = settings.condition.rain > 0.0;
        let outfit = if rains { Outfit::Rain } else { profile.clothing.outfit(profile.region) };
        let mut population = Population {
            vehicles_asked: settings.vehicles,
            vehicles_spawned: vehicles.len() as u32,
            vehicle_capacity: spawn::capacity(&roads, fleet.vehicles.len()) as u32,
            pedestrians_asked: settings.pedestrians,
            pedestrians_spawned: walkers.len() as u32,
        };
        let mut ids = InstanceIdAllocator::default();
        let parked = parked_actors(parked, fleet.vehicles, &mut ids)?;
        let mut own_ids = ActorIds::new(&vehicles, walkers.len(), &mut ids)?;
        let cast = |played| Playback::new(network, played, fleet.vehicles, fleet.pedestrian, outfit, &mut ids);
        let playback = played.map(cast).transpose()?;
        if let Some([vehicles, people]) = playback.as_ref().map(Playback::counts) {
            population.vehicles_spawned += vehicles;
            population.pedestrians_spawned += people;
        }
        own_ids.go_on_after(ids);
        let deliveries = Arc::new(Deliveries::new(settings.deliveries, &standing));
        let arrivals = Arrivals::new(fleet.vehicles, settings, vehicles.len(), standing);
        let is_actuated = settings.profile.signals == SignalControl::Actuated;
        let actuated = is_actuated.then(|| ActuatedSignals::new(&roads));
        let crossings = vec![CrossingState::default(); network.crossings.len()];
        let courtesies = courtesy::courtesies(network);
        let alone = playback.is_some() && vehicles.is_empty() && walkers.is_empty();
        let warm_up_s = if alone { PLAYBACK_WARM_UP_S } else { warm_up_s };
        let warm_up_frames = (warm_up_s * fps).ceil() as u32;
        let mut simulation = Self {
            roads,
            graph,
            condition: settings.condition,
            outfit,
            population,
            parked,
            vehicles,
            walkers,
            ids: own_ids,
            arrivals,
            occupancy: Occupancy::default(),
            controller: JunctionController::default(),
            crossings,
            courtesies,
            bus_halts,
            deliveries,
            parking,
            roadway: Roadway::default(),
            signals: Vec::new(),
            actuated,
            playback,
            gathering,
            staged: Vec::new(),
            fps,
            frame: 0,
            steps: 0,
            time_s: -f64::from(warm_up_frames) / fps,
        };
        for _ in 0..warm_up_frames {
            simulation.tick();
        }
        simulation.gathering = None;
        simulation.frame = 0;
        simulation.time_s = 0.0;
        Ok(simulation)
    }

    /// Numbers of actors, requested and spawned.
    pub fn population(&self) -> Population {
        self.population
    }

    /// The parked vehicles; number i carries instance id i + 1.
    pub fn parked(&self) -> &[Actor] {
        &self.parked
    }

    /// Weather and light from now on.
    pub fn set_condition(&mut self, condition: DrivingCondition) {
        if !condition.drives_like(&self.condition) {
            for vehicle in &mut self.vehicles {
                vehicle.driver.adapt(&self.condition, &condition);
            }
            self.arrivals.adapt(&self.condition, &condition);
        }
        self.condition = condition;
    }

    /// Advances by one frame: a fixed number of equal steps of at most 1/30 s.
    pub fn tick(&mut self) {
        self.give_orders();
        let frame_s = 1.0 / self.fps;
        let steps = (frame_s / STEP_S - 1e-9).ceil().max(1.0) as u32;
        let begin = self.time_s;
        for k in 0..steps {
            self.time_s = begin + frame_s * f64::from(k) / f64::from(steps);
            self.step(frame_s / f64::from(steps));
        }
        self.frame += 1;
        self.time_s = if begin < 0.0 { begin + frame_s } else { f64::from(self.frame) / self.fps };
        self.show_signals(None);
        self.note_incidents();
    }

    fn step(&mut self, step_s: f64) {
        self.steps += 1;
        let a_second = (1.0 / step_s).round().max(1.0) as u64;
        if self.steps.is_multiple_of(a_second) {
            let seen: Vec<u32> = self.vehicles.iter().map(|v| views_ahead(&self.roads, v, LEADS_M)).collect();
            self.roads.attraction.notice(seen.into_iter());
            let driving = self.vehicles.iter().filter(|vehicle| !vehicle.is_parked());
            self.roads.attraction.queues.notice(driving.map(|v| (v.lane(), v.speed)));
            destination_exchange::step(&self.roads, &self.graph, &mut self.walkers);
            if let Some(gathering) = &mut self.gathering {
                gathering.step(&self.roads, &self.graph, &mut self.vehicles, &mut self.walkers, -self.time_s);
            }
        }
        self.show_signals(Some(step_s));
        note_vehicles(&self.roads, &self.vehicles, &mut self.crossings);
        let others = self.presence();
        others.note_vehicles(&self.roads, &mut self.crossings);
        let jaywalks = self.walkers.iter().map(|walker| walker.jaywalk.as_deref());
        self.roadway.note_vehicles(&self.roads, &self.vehicles, jaywalks);
        self.roadway.note_played(others.covers());
        let scene = WalkerView {
            roads: &self.roads,
            graph: &self.graph,
            signals: &self.signals,
            roadway: &self.roadway,
            others: &others.people,
        };
        if self.gathering.is_none() && !self.bus_halts.is_empty() {
            bus_riders::step(&self.roads, &mut self.vehicles, &mut self.walkers, step_s);
        }
        sitting::choose(&self.roads, &mut self.walkers, &self.condition, step_s);
        walker::step(&scene, &mut self.walkers, &mut self.crossings, step_s);
        road_walker::step(&mut self.walkers, &self.roads, step_s);
        others.note_people(&mut self.crossings);
        self.courtesies.iter_mut().for_each(|courtesy| courtesy.step(&mut self.crossings, step_s));
        self.occupancy.rebuild(&self.roads, &self.vehicles);
        others.occupy(&mut self.occupancy, self.vehicles.len());
        let jaywalks = self.walkers.iter().filter_map(|w| Some((w.jaywalk.as_deref()?, w.position)));
        self.occupancy.put_people(people_on_lanes(jaywalks));
        wrong_way::occupy(&self.roads, &self.vehicles, &mut self.occupancy);
        road_walker::occupy(&self.walkers, &mut self.occupancy);
        for i in 0..self.vehicles.len() {
            let thinks = (self.steps + 7 * i as u64).is_multiple_of(a_second);
            if thinks && !self.bus_halts.is_empty() {
                bus_service::look_out(&self.roads, &self.bus_halts, &mut self.vehicles[i]);
            }
            if thinks {
                self.deliveries.look_out(&self.roads, &self.occupancy, &self.bus_halts, &mut self.vehicles, i);
                self.parking.look_out(&self.roads, &mut self.vehicles, i, self.time_s);
            }
            if thinks {
                rerouting::step(&self.roads, &mut self.vehicles[i]);
            }
            lane_change::step(&self.roads, &mut self.occupancy, &mut self.vehicles, i, thinks, step_s);
        }
        kerb_halting::step(&self.roads, &self.occupancy, &mut self.vehicles, step_s);
        let riders = RiderView {
            roads: &self.roads,
            occupancy: &self.occupancy,
            signals: &self.signals,
            parked: self.arrivals.parked(),
        };
        filtering::step(&riders, &mut self.vehicles, self.steps);
        self.controller.step(&self.roads, &self.occupancy, &self.signals, &mut self.vehicles, step_s);
        let come = self.arrivals.step(
            &ArrivalView {
                roads: &self.roads,
                occupancy: &self.occupancy,
                vehicles: &self.vehicles,
                crossings: &self.crossings,
                condition: &self.condition,
            },
            step_s,
        );
        let view = DriverView {
            roads: &self.roads,
            occupancy: &self.occupancy,
            controller: &self.controller,
            crossings: &self.crossings,
            signals: &self.signals,
            vehicles: &self.vehicles,
        };
        let accelerations: Vec<f64> = (0..self.vehicles.len()).map(|i| view.acceleration(i, step_s)).collect();
        for (vehicle, acceleration) in self.vehicles.iter_mut().zip(accelerations) {
            vehicle.acceleration = acceleration;
            kinematics::advance(vehicle, &self.roads, step_s);
            vehicle.plan(&self.roads);
            lights::update(vehicle, &self.roads, self.condition.headlights_on, self.time_s + step_s, step_s);
        }
        impact::collide(&self.roads, &mut self.vehicles);
        self.cross_borders(come);
        if let Some(playback) = &mut self.playback {
            playback.advance(&self.roads.network, self.time_s + step_s, step_s, self.condition.headlights_on);
        }
    }

    /// What signals show now; those that follow traffic move on by a step, if there is one.
    fn show_signals(&mut self, step_s: Option<f64>) {
        signals::aspects_at(&self.roads.network, self.time_s, &mut self.signals);
        let Some(actuated) = &mut self.actuated else { return };
        match step_s {
            Some(step_s) => {
                actuated.step(&self.roads, &self.vehicles, &self.crossings, step_s, &mut self.signals);
            }
            None => actuated.show(&mut self.signals),
        }
    }

    /// Those who have come to the end of the map leave, and these come.
    fn cross_borders(&mut self, come: Vec<Vehicle>) {
        if self.roads.borders.exits.is_empty() {
            return;
        }
        for i in (0..self.vehicles.len()).rev() {
            if has_left(&self.roads, &self.vehicles[i]) {
                self.vehicles.remove(i);
                self.ids.leave(i);
            }
        }
        for vehicle in come {
            // Without an id left, nobody comes.
            if self.ids.come(&vehicle) {
                self.vehicles.push(vehicle);
            }
        }
    }

    /// Those who play tracks as others see them; nobody, where there is nobody to see them.
    fn presence(&self) -> Presence {
        let seen = self.playback.as_ref().filter(|_| !self.vehicles.is_empty() || !self.walkers.is_empty());
        seen.map_or_else(Presence::default, |playback| Presence::of(playback, &self.roads, self.time_s))
    }
}

fn parked_actors(
    parked: &[ParkedVehicle],
    specs: &[VehicleSpec],
    ids: &mut InstanceIdAllocator,
) -> Result<Vec<Actor>, TooManyInstances> {
    let actor = |parked: &ParkedVehicle| {
        Ok(Actor {
            id: ids.allocate()?,
            rider_id: None,
            class: specs[parked.vehicle.model.index()].class,
            asset: parked.vehicle.into(),
            pose: parked.pose,
            velocity_mps: Vec3::ZERO,
            motion: Motion::Vehicle(VehicleMotion::default()),
            behaviour: Behaviour::default(),
            parked: true,
        })
    };
    parked.iter().map(actor).collect()
}

#[cfg(test)]
mod tests;
