//! Integration tests of `endless_traffic`, in one binary: a module a subject.

mod behaviour;
mod borders;
mod focus;
#[path = "../../../endless_road/tests/it/grid/mod.rs"]
mod grid;
mod grid_traffic;
mod imu;
mod incidents;
mod merge;
mod slope;
mod towns;
mod vehicle_events;
mod watch;
