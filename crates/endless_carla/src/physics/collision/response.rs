//! What bodies do to each other where they meet: impulses along the normal with a little restitution, friction across, by
//! sequential impulses (Catto 2005), and a push that takes them apart without giving them speed.

use super::oriented_box::{OrientedBox, Overlap};
use glam::DVec2;

/// Share of the speed that comes back.
const RESTITUTION: f64 = 0.1;
/// Slower than this nothing bounces, m/s.
const BOUNCES_ABOVE_MPS: f64 = 1.0;
/// Of bodywork on bodywork and on walls.
const FRICTION: f64 = 0.4;
/// How deep bodies may stay in each other, metres: what touches keeps touching.
const SLOP_M: f64 = 0.01;
/// Share of what is too deep that is taken back in a step.
const TAKEN_BACK: f64 = 0.3;
/// Most that is taken back in a step, metres.
const MOST_TAKEN_BACK_M: f64 = 0.2;
const ITERATIONS: usize = 8;

/// A body as its contacts see it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Solid {
    pub(super) outline: OrientedBox,
    /// Centre of mass.
    pub(super) centre: DVec2,
    /// Of the centre of mass, m/s.
    pub(super) velocity: DVec2,
    /// rad/s.
    pub(super) yaw_rate: f64,
    /// 0 for what nothing moves, 1/kg.
    pub(super) per_mass: f64,
    /// 0 for what nothing turns, 1/(kg m²).
    pub(super) per_inertia: f64,
    /// What it was moved by, metres.
    pub(super) shift: DVec2,
}

impl Solid {
    fn velocity_at(&self, point: DVec2) -> DVec2 {
        self.velocity + (point - self.centre).perp() * self.yaw_rate
    }

    fn mobility(&self, point: DVec2, direction: DVec2) -> f64 {
        let lever = (point - self.centre).perp_dot(direction);
        self.per_mass + lever * lever * self.per_inertia
    }

    fn push(&mut self, point: DVec2, impulse: DVec2) {
        self.velocity += impulse * self.per_mass;
        self.yaw_rate += (point - self.centre).perp_dot(impulse) * self.per_inertia;
    }
}

/// Two solids in each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Touch {
    pub(super) a: usize,
    pub(super) b: usize,
    pub(super) overlap: Overlap,
    /// Speed along the normal that it shall have afterwards, m/s.
    target_mps: f64,
    /// How fast they came at each other, m/s.
    pub(super) approach_mps: f64,
    /// N s, along the normal and across.
    given: DVec2,
}

impl Touch {
    pub(super) fn new(solids: &[Solid], a: usize, b: usize) -> Option<Self> {
        let (first, second) = (solids.get(a)?, solids.get(b)?);
        if first.per_mass + second.per_mass == 0.0 {
            return None;
        }
        let overlap = first.outline.overlap(&second.outline, second.velocity - first.velocity)?;
        let velocity = second.velocity_at(overlap.point) - first.velocity_at(overlap.point);
        let approach_mps = -velocity.dot(overlap.normal);
        let target_mps = if approach_mps > BOUNCES_ABOVE_MPS { RESTITUTION * approach_mps } else { 0.0 };
        Some(Self { a, b, overlap, target_mps, approach_mps, given: DVec2::ZERO })
    }

    /// What the second got from the first, N s.
    pub(super) fn impulse(&self) -> DVec2 {
        self.overlap.normal * self.given.x + self.overlap.normal.perp() * self.given.y
    }

    fn solve(&mut self, solids: &mut [Solid]) {
        let Ok([a, b]) = solids.get_disjoint_mut([self.a, self.b]) else { return };
        let Overlap { normal, point, .. } = self.overlap;
        let speed = |a: &Solid, b: &Solid, axis: DVec2| (b.velocity_at(point) - a.velocity_at(point)).dot(axis);
        let mobility = |a: &Solid, b: &Solid, axis: DVec2| a.mobility(point, axis) + b.mobility(point, axis);

        let wanted = self.given.x + (self.target_mps - speed(a, b, normal)) / mobility(a, b, normal);
        let now = wanted.max(0.0);
        let change = normal * (now - self.given.x);
        self.given.x = now;
        a.push(point, -change);
        b.push(point, change);

        let across = normal.perp();
        let most = FRICTION * self.given.x;
        let now = (self.given.y - speed(a, b, across) / mobility(a, b, across)).clamp(-most, most);
        let change = across * (now - self.given.y);
        self.given.y = now;
        a.push(point, -change);
        b.push(point, change);
    }

    fn take_apart(&self, solids: &mut [Solid]) {
        let Ok([a, b]) = solids.get_disjoint_mut([self.a, self.b]) else { return };
        let back = (TAKEN_BACK * (self.overlap.depth_m - SLOP_M)).clamp(0.0, MOST_TAKEN_BACK_M);
        let step = self.overlap.normal * (back / (a.per_mass + b.per_mass));
        a.shift -= step * a.per_mass;
        b.shift += step * b.per_mass;
    }
}

/// Lets all touches act.
pub(super) fn resolve(solids: &mut [Solid], touches: &mut [Touch]) {
    for _ in 0..ITERATIONS {
        touches.iter_mut().for_each(|touch| touch.solve(solids));
    }
    touches.iter().for_each(|touch| touch.take_apart(solids));
}
