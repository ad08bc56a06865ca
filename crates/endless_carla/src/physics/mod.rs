//! How what CARLA's controls drive moves, in this workspace's world: right-handed, x east, y north, z up, metres, radians
//! and SI units. Structs of the wire are taken as they are, with CARLA's axes and units; what is in them that no body
//! could do is bounded, and what is no number is left out.
//!
//! - [`VehicleBody`] and [`WalkerBody`] move by themselves: `step` them.
//! - [`step_bodies`] moves many, lets them meet each other and what stands around ([`Obstacles`]), and tells their
//!   [`Contact`]s.
//! - [`AckermannController`] finds the pedals for a speed and a steering angle.
//!
//! The same calls give the same bits on every machine.

mod ackermann;
mod bicycle;
mod collision;
mod curve;
mod defaults;
mod description;
mod drive_train;
mod footing;
mod gait;
mod input;
mod parameters;
mod place;
mod sane;
mod shape;
mod suspension;
mod telemetry;
mod tyre;
mod vehicle_body;
mod vehicle_step;
mod walker_body;

pub use ackermann::AckermannController;
pub use collision::{Body, Contact, Mover, Obstacle, Obstacles, OrientedBox, Party, step_bodies};
pub use footing::Ground;
pub use place::Place;
pub use shape::VehicleShape;
pub use vehicle_body::VehicleBody;
pub(crate) use vehicle_body::direction;
pub use walker_body::WalkerBody;

/// m/s².
const GRAVITY_MPS2: f64 = 9.81;
/// Nothing moves faster, m/s.
const FASTEST_MPS: f64 = 200.0;
/// Longest time that a step goes on, seconds.
pub const LONGEST_STEP_S: f64 = 5.0;
/// Longest time between two looks at forces and contacts, seconds: CARLA's `max_substep_delta_time`.
const SUBSTEP_S: f64 = 0.01;

/// How many short steps make a long one, and how long they are.
fn substeps(dt_s: f64) -> (u32, f64) {
    if dt_s.is_nan() || dt_s <= 0.0 {
        return (0, 0.0);
    }
    let dt_s = dt_s.min(LONGEST_STEP_S);
    // 0.05 that went through an f32 is five hundredths.
    let count = (dt_s / SUBSTEP_S - 1e-6).ceil().max(1.0);
    (count as u32, dt_s / count)
}

#[cfg(test)]
mod tests;
