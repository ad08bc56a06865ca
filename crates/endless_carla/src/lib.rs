//! CARLA's wire: the protocol of CARLA 0.9.16, as data and as a server.
//!
//! Lengths are metres, angles degrees and axes left-handed (x forward, y right, z up) on the wire, and nowhere else: all
//! conversions to this workspace's frames are in this crate.

mod blueprint;
mod frames;
mod instance;

pub mod client;

pub mod map;
pub mod physics;
pub mod recording;
pub mod rpc;
pub mod server;
pub mod stream;
pub mod wire;

pub use blueprint::{
    AttributeError, Attributes, Blueprint, BlueprintKind, BlueprintLibrary, PropBlueprint, PropBody, SensorKind,
    VehicleBlueprint, WalkerBlueprint,
};
