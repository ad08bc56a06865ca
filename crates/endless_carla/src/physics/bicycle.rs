//! Motion in the plane: the dynamic bicycle model (Rajamani, "Vehicle Dynamics and Control", 2012, section 2.3) with
//! saturating tyres.
//!
//! A tyre never gives more than what would stop it from sliding within the step. Fast, that bound is far away and the
//! model is the dynamic one; slowly, where slip angles make no sense, it is what holds, and the wheels roll where they
//! point: the kinematic model, and standing still when they cannot roll. The bounds of both axles are met together by
//! sequential impulses (Catto, "Iterative Dynamics with Temporal Coherence", 2005), which never add energy.

use super::parameters::{Axle, Parameters};
use super::tyre::{lateral_share, left_across};
use endless_world::math::f64::{atan2, sin_cos};
use glam::DVec2;

const ITERATIONS: usize = 4;
/// Slower than this is standing, m/s and rad/s.
const STANDS: f64 = 1e-4;
/// What braked but turning front wheels keep across, and rear ones along, as a share of their grip.
const KEPT: f64 = 0.35;
/// How much of what the rear wheels could hold across the front ones may ask of them while the brakes are on.
const BALANCED: f64 = 0.9;

/// Motion of the centre of mass in the plane, in the world.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Planar {
    /// m/s.
    pub(super) velocity: DVec2,
    /// To the left is positive, rad/s.
    pub(super) yaw_rate: f64,
}

/// What acts on an axle, newtons.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct AxleForces {
    /// On the ground.
    pub(super) load_n: f64,
    /// Along the wheels.
    pub(super) drive_n: f64,
    /// Against their rolling.
    pub(super) resist_n: f64,
    /// The driver brakes.
    pub(super) braked: bool,
    /// They do not turn at all while they slide.
    pub(super) locked: bool,
}

/// What an axle's tyres did, for telemetry.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct AxleState {
    /// Newtons.
    pub(super) load_n: f64,
    /// Force along the wheels, newtons.
    pub(super) along_n: f64,
    /// Force to the left of the wheels, newtons.
    pub(super) across_n: f64,
    /// Between where they point and where they go, radians.
    pub(super) slip_rad: f64,
}

/// A contact of an axle with the ground, for a step.
struct Contact {
    ahead_m: f64,
    along: DVec2,
    across: DVec2,
    /// N s.
    most_along: f64,
    most_across: f64,
    given_along: f64,
    given_across: f64,
}

impl Contact {
    fn velocity(&self, planar: &Planar, left: DVec2) -> DVec2 {
        planar.velocity + left * (planar.yaw_rate * self.ahead_m)
    }
}

/// Lets tyres act for `dt_s` on a body with its nose in direction `forward` and its front wheels turned to the left.
pub(super) fn step(
    planar: &mut Planar,
    p: &Parameters,
    forward: DVec2,
    steer_rad: f64,
    forces: [AxleForces; 2],
    dt_s: f64,
) -> [AxleState; 2] {
    let left = forward.perp();
    let (sin, cos) = sin_cos(steer_rad);
    let alongs = [forward * cos + left * sin, forward];
    let mut slips = [0.0; 2];
    let mut contacts = [0, 1].map(|index| {
        let (axle, own, along): (&Axle, &AxleForces, DVec2) = (&p.axles[index], &forces[index], alongs[index]);
        let mut contact = Contact {
            ahead_m: axle.ahead_m,
            along,
            across: along.perp(),
            most_along: 0.0,
            most_across: 0.0,
            given_along: 0.0,
            given_across: 0.0,
        };
        let grip_n = axle.friction * own.load_n;
        let drive_n = own.drive_n.clamp(-grip_n, grip_n);
        push(planar, p, left, &contact, contact.along, drive_n * dt_s);
        contact.given_along = drive_n * dt_s;

        let slide = contact.velocity(planar, left);
        let (v_along, v_across) = (slide.dot(along).abs(), slide.dot(contact.across).abs());
        let slip_rad = if v_across > 0.0 { atan2(v_across, v_along) } else { 0.0 };
        let resist_n = own.resist_n.min(grip_n);
        let (most_along, most_across) = if own.locked && slide.length() > 0.3 {
            // Rubber on asphalt: against the way that it slides.
            (grip_n * v_along / slide.length(), grip_n * v_across / slide.length())
        } else {
            let rest_n = (axle.weight * p.weight_n()).max(1.0);
            let stiffness = axle.stiffness * (axle.max_load * rest_n / own.load_n.max(1.0)).min(1.0);
            let share_n = own.load_n * lateral_share(slip_rad, axle.friction, stiffness);
            // Electronic brake force distribution: rear brakes yield where their wheels must hold the tail.
            let rear = index == 1;
            let braked_n = if rear { resist_n.min(left_across(grip_n, share_n).max(KEPT * grip_n)) } else { resist_n };
            let left_n = left_across(grip_n, drive_n.abs().max(braked_n)).max(KEPT * grip_n);
            (braked_n, share_n.min(left_n))
        };
        (contact.most_along, contact.most_across) = (most_along * dt_s, most_across * dt_s);
        slips[index] = slip_rad * if slide.dot(contact.across) > 0.0 { 1.0 } else { -1.0 };
        contact
    });

    // Electronic stability control: brakes of single wheels take from the front what would turn the vehicle round, as
    // where braking has lifted the load off the rear. Who pulls the hand brake wants that.
    let [front, rear] = &p.axles;
    if forces[1].braked && !forces[1].locked {
        let could_n = left_across(rear.friction * forces[1].load_n, forces[1].drive_n);
        let asked_n = BALANCED * could_n * -rear.ahead_m / front.ahead_m;
        contacts[0].most_across = contacts[0].most_across.min(asked_n * dt_s);
    }

    let mut resisted = [0.0; 2];
    for _ in 0..ITERATIONS {
        for (contact, resisted) in contacts.iter_mut().zip(&mut resisted) {
            let (along, across) = (contact.along, contact.across);
            stop(planar, p, left, contact, along, contact.most_along, resisted);
            let mut given = contact.given_across;
            stop(planar, p, left, contact, across, contact.most_across, &mut given);
            contact.given_across = given;
        }
    }
    if forces.iter().all(|own| own.drive_n == 0.0)
        && planar.velocity.length() < STANDS
        && planar.yaw_rate.abs() < STANDS
    {
        *planar = Planar::default();
    }
    [0, 1].map(|index| AxleState {
        load_n: forces[index].load_n,
        along_n: (contacts[index].given_along + resisted[index]) / dt_s,
        across_n: contacts[index].given_across / dt_s,
        slip_rad: slips[index],
    })
}

/// Gives an impulse, N s, at a contact.
fn push(planar: &mut Planar, p: &Parameters, left: DVec2, contact: &Contact, direction: DVec2, impulse: f64) {
    planar.velocity += direction * (impulse / p.mass_kg);
    planar.yaw_rate += contact.ahead_m * left.dot(direction) * impulse / p.yaw_inertia;
}

/// Stops the sliding in a direction, with at most so much impulse both ways.
fn stop(
    planar: &mut Planar,
    p: &Parameters,
    left: DVec2,
    contact: &Contact,
    direction: DVec2,
    most: f64,
    given: &mut f64,
) {
    let lever = contact.ahead_m * left.dot(direction);
    let mobility = 1.0 / p.mass_kg + lever * lever / p.yaw_inertia;
    let wanted = *given - contact.velocity(planar, left).dot(direction) / mobility;
    let now = wanted.clamp(-most, most);
    push(planar, p, left, contact, direction, now - *given);
    *given = now;
}
