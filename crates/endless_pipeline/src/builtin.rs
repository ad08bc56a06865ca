//! The built-in city: towns, traffic and the ray tracer joined.

mod bodies;
mod map;
mod session;
mod simulator;

pub use map::BuiltinMap;
pub use simulator::BuiltinSimulator;
