//! Traffic: vehicles, two-wheelers, pedestrians and signals on a road network.
//!
//! A [`Simulation`] is made of a [`RoadNetwork`](endless_road::RoadNetwork), a [`Fleet`] of vehicle models and people,
//! the parked vehicles, and [`TrafficSettings`]. What depends on the network and the models alone can be made once for
//! many of them ([`TrafficMap`]). It advances frame by frame;
//! [`Simulation::state`] is the world state that is rendered and labelled. All randomness comes from streams keyed by the
//! seed, and a frame is a fixed number of equal steps, so the same settings give the same states, bit for bit. A
//! [`TrafficAudit`] looks at the states and reports what no street ever shows.
//!
//! ```
//! use endless_road::{Lane, LaneId, Polyline, RoadNetwork};
//! use endless_traffic::{Fleet, Simulation, TrafficSettings};
//! use endless_world::{VehicleSpec, math::f64::sin_cos, walking::PedestrianSpec};
//! use glam::DVec3;
//!
//! // One lane all around a circle of 60 m, in two halves that follow one another.
//! let half = |begin: u32| {
//!     let on_circle = |i: u32| {
//!         let (sin, cos) = sin_cos(f64::from(i).to_radians());
//!         DVec3::new(60.0 * cos, 60.0 * sin, 0.0)
//!     };
//!     Polyline::new((begin..=begin + 180).map(on_circle))
//! };
//! let lane = |id: u32, begin: u32, next: u32| Lane {
//!     successors: vec![LaneId(next)],
//!     ..Lane::new(LaneId(id), half(begin), 3.5, 13.9)
//! };
//! let network = RoadNetwork { lanes: vec![lane(0, 0, 1), lane(1, 180, 0)], ..RoadNetwork::default() }.finish()?;
//!
//! let cars = [VehicleSpec::default()];
//! let fleet = Fleet { vehicles: &cars, pedestrian: &|_| PedestrianSpec::default() };
//! let settings = TrafficSettings { vehicles: 5, pedestrians: 0, ..TrafficSettings::default() };
//! let mut traffic = Simulation::new(&network, &fleet, &[], &settings)?;
//! assert_eq!(traffic.population().vehicles_spawned, 5);
//! let before = traffic.state();
//! traffic.tick();
//! for (car, earlier) in traffic.state().actors.iter().zip(&before.actors) {
//!     let driven_m = car.pose.position.distance(earlier.pose.position);
//!     assert!(driven_m > 0.1 && driven_m < 1.5, "{driven_m} m in a tenth of a second");
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod across;
mod actor_ids;
mod actuated;
mod arrivals;
mod attraction;
mod audit;
mod bay_way;
mod behaviour;
mod body_contact;
mod bus_errand;
mod bus_riders;
mod bus_service;
mod bus_stop;
mod bus_wait;
mod companionship;
mod company;
mod company_draw;
mod courtesy;
mod crossing;
mod demand;
mod density;
mod destination_exchange;
mod double_parking;
mod driver;
mod emergency;
mod entry_request;
mod exit_pressure;
mod filtering;
mod focus;
mod gap_acceptance;
mod gathering;
mod gridlock;
mod incident;
mod jaywalk;
mod jogging;
mod junction_controller;
mod kerb_halt;
mod kerb_halting;
mod kerb_room;
mod kerb_sweep;
mod kinematics;
mod lane_change;
mod lane_choice;
mod lights;
mod midblock;
mod occupancy;
mod outing;
mod overlap;
mod parked_beside;
mod parking;
mod parking_manoeuvre;
mod parking_place;
mod parking_places;
mod pedestrian_avoidance;
mod people_grid;
mod playback;
mod population;
mod pulling_out;
mod queue_exit;
mod queue_stand;
mod queue_tail;
mod queues;
mod rerouting;
mod roads;
mod roundabout;
mod settings;
mod signals;
mod simulation;
mod sitting;
mod spawn;
mod steering;
mod stop_places;
mod trailer;
mod turn_aim;
mod turn_lane;
mod vehicle;
mod vehicle_mix;
mod walk_strip;
mod walker;
mod weather_pace;

pub use audit::{AuditCheck, AuditLine, AuditReport, TrafficAudit};
pub use double_parking::USUAL_DELIVERIES;
pub use focus::{Focus, View};
pub use incident::{DetectedIncident, IncidentDetector, IncidentRequest};
pub use playback::{PlayedTracks, TrackFit};
pub use population::Population;
pub use roads::TrafficMap;
pub use settings::{DrivingCondition, Fleet, TrafficSettings};
pub use signals::{SignalCountdown, signal_countdowns};
pub use simulation::Simulation;
