//! Integration tests of `endless_traffic`, in one binary: a module a subject.

mod actuated;
mod behaviour;
mod benches;
mod borders;
mod bus_stops;
mod deliveries;
mod filtering;
mod focus;
#[path = "../../../endless_road/tests/it/grid/mod.rs"]
mod grid;
mod grid_traffic;
mod groups;
mod imu;
mod incidents;
mod jaywalking;
mod merge;
mod parking;
mod profile;
mod slope;
mod towns;
mod vehicle_events;
mod watch;
