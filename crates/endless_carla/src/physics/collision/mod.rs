//! Bodies that meet each other and what stands around.

mod grid;
mod oriented_box;
mod response;

pub use oriented_box::OrientedBox;

use super::vehicle_body::direction;
use super::{Ground, VehicleBody, WalkerBody, substeps};
use crate::wire::{VehicleControl, WalkerControl};
use glam::{DVec2, DVec3};
use response::{Solid, Touch};

/// Kerbs and bumps under this height are driven over, metres.
const CLEARANCE_M: f64 = 0.2;
/// What walkers step over, metres.
const STEPPED_OVER_M: f64 = 0.3;
/// Farther than a body goes in a step, obstacles are looked for within this, metres.
const MARGIN_M: f64 = 1.0;
/// Slower than this is touching, not meeting, m/s.
const MEETS_MPS: f64 = 0.02;

/// What moves, and how it is driven.
#[derive(Debug)]
pub enum Mover<'a> {
    /// A vehicle.
    Vehicle(&'a mut VehicleBody, &'a VehicleControl),
    /// A walker.
    Walker(&'a mut WalkerBody, &'a WalkerControl),
}

/// One of those that are moved together.
#[derive(Debug)]
pub struct Body<'a> {
    /// Its actor.
    pub id: u32,
    /// What it is.
    pub mover: Mover<'a>,
}

/// Something that nothing moves: a wall, a prop.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Obstacle {
    /// Whatever tells it from others.
    pub id: u64,
    /// Where it is.
    pub outline: OrientedBox,
}

/// What stands around.
pub trait Obstacles {
    /// Adds what may be within the corners of a rectangle; more than that does not harm. The same in the same order for
    /// the same rectangle.
    fn near(&self, low: DVec2, high: DVec2, found: &mut Vec<Obstacle>);
}

impl<F: Fn(DVec2, DVec2, &mut Vec<Obstacle>)> Obstacles for F {
    fn near(&self, low: DVec2, high: DVec2, found: &mut Vec<Obstacle>) {
        self(low, high, found);
    }
}

/// Who meets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Party {
    /// A body, by its actor.
    Body(u32),
    /// An obstacle, by its number.
    Obstacle(u64),
}

/// Two that met during a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Always a body.
    pub a: Party,
    /// A body that comes later in the list, or an obstacle.
    pub b: Party,
    /// Where they met first, in the world, metres.
    pub point: DVec3,
    /// From `a` to `b`, horizontal.
    pub normal: DVec3,
    /// What `b` got from `a` in all of the step, N s; `a` got the opposite.
    pub impulse: DVec3,
}

/// Moves bodies by `dt_s` as their own `step` does, and lets them meet in between. What does not collide, and walkers
/// among each other, pass through. Contacts come in the order in which pairs met first, one for a pair.
pub fn step_bodies(bodies: &mut [Body<'_>], dt_s: f64, ground: &Ground<'_>, obstacles: &dyn Obstacles) -> Vec<Contact> {
    let (count, each_s) = substeps(dt_s);
    for body in &mut *bodies {
        match &mut body.mover {
            Mover::Vehicle(vehicle, control) => vehicle.begin(control),
            Mover::Walker(walker, control) => walker.begin(control),
        }
    }
    let around: Vec<_> = bodies.iter().map(|body| body.obstacles(f64::from(count) * each_s, obstacles)).collect();
    let mut contacts = Vec::new();
    for _ in 0..count {
        for body in &mut *bodies {
            match &mut body.mover {
                Mover::Vehicle(vehicle, _) => vehicle.substep(each_s, ground),
                Mover::Walker(walker, _) => walker.substep(each_s, ground),
            }
        }
        meet(bodies, &around, &mut contacts);
    }
    for body in &mut *bodies {
        match &mut body.mover {
            Mover::Vehicle(vehicle, _) => vehicle.end(f64::from(count) * each_s),
            Mover::Walker(walker, _) => walker.end(f64::from(count) * each_s),
        }
    }
    contacts
}

fn meet(bodies: &mut [Body<'_>], around: &[Vec<Obstacle>], contacts: &mut Vec<Contact>) {
    let mut solids: Vec<_> = bodies.iter().map(Body::solid).collect();
    let bounds: Vec<_> = solids.iter().map(|solid| solid.outline.bounds()).collect();
    let mut touches = Vec::new();
    for (a, b) in grid::pairs(&bounds) {
        if meets(bodies, a, b) {
            touches.extend(Touch::new(&solids, a, b));
        }
    }
    let mut parties: Vec<_> = bodies.iter().map(|body| Party::Body(body.id)).collect();
    for (index, around) in around.iter().enumerate() {
        for obstacle in around {
            let standing = solids.len();
            solids.push(standing_solid(obstacle));
            match Touch::new(&solids, index, standing) {
                Some(touch) => {
                    touches.push(touch);
                    parties.push(Party::Obstacle(obstacle.id));
                }
                None => solids.truncate(standing),
            }
        }
    }
    if touches.is_empty() {
        return;
    }
    let before = solids.clone();
    response::resolve(&mut solids, &mut touches);
    for ((body, solid), before) in bodies.iter_mut().zip(&solids).zip(&before) {
        if solid != before {
            body.take(solid, solid.velocity - before.velocity);
        }
    }
    touches.iter().for_each(|touch| tell(touch, &parties, contacts));
}

fn meets(bodies: &[Body<'_>], a: usize, b: usize) -> bool {
    let (Some(a), Some(b)) = (bodies.get(a), bodies.get(b)) else { return false };
    let walkers = matches!((&a.mover, &b.mover), (Mover::Walker(..), Mover::Walker(..)));
    a.collides() && b.collides() && !walkers
}

fn tell(touch: &Touch, parties: &[Party], contacts: &mut Vec<Contact>) {
    let (Some(&a), Some(&b)) = (parties.get(touch.a), parties.get(touch.b)) else { return };
    let impulse = touch.impulse().extend(0.0);
    if touch.approach_mps < MEETS_MPS || impulse == DVec3::ZERO {
        return;
    }
    match contacts.iter_mut().find(|contact| (contact.a, contact.b) == (a, b)) {
        Some(known) => known.impulse += impulse,
        None => contacts.push(Contact {
            a,
            b,
            point: touch.overlap.point.extend(touch.overlap.height_m),
            normal: touch.overlap.normal.extend(0.0),
            impulse,
        }),
    }
}

fn standing_solid(obstacle: &Obstacle) -> Solid {
    Solid {
        outline: obstacle.outline,
        centre: obstacle.outline.centre,
        velocity: DVec2::ZERO,
        yaw_rate: 0.0,
        per_mass: 0.0,
        per_inertia: 0.0,
        shift: DVec2::ZERO,
    }
}

impl Body<'_> {
    fn collides(&self) -> bool {
        match &self.mover {
            Mover::Vehicle(vehicle, _) => vehicle.collides(),
            Mover::Walker(walker, _) => walker.collides(),
        }
    }

    /// Who is carried along a way by a client meets nothing that stands: the way knows of it.
    fn is_carried(&self) -> bool {
        matches!(&self.mover, Mover::Walker(walker, _) if walker.is_carried())
    }

    fn solid(&self) -> Solid {
        match &self.mover {
            Mover::Vehicle(vehicle, _) => vehicle.solid(),
            Mover::Walker(walker, _) => walker.solid(),
        }
    }

    fn take(&mut self, solid: &Solid, change: DVec2) {
        match &mut self.mover {
            Mover::Vehicle(vehicle, _) => {
                vehicle.set_planar(solid.velocity, solid.yaw_rate);
                vehicle.position += solid.shift.extend(0.0);
            }
            Mover::Walker(walker, _) => {
                walker.add_impulse((change * walker.mass_kg()).extend(0.0));
                walker.shift(solid.shift);
            }
        }
    }

    /// What it may meet in the next `dt_s`.
    fn obstacles(&self, dt_s: f64, obstacles: &dyn Obstacles) -> Vec<Obstacle> {
        let solid = self.solid();
        let mut found = Vec::new();
        if self.collides() && !self.is_carried() && solid.per_mass > 0.0 {
            let (low, high) = solid.outline.bounds();
            let margin = DVec2::splat(MARGIN_M + solid.velocity.length() * dt_s);
            obstacles.near(low - margin, high + margin, &mut found);
            let finite = |outline: &OrientedBox| {
                let vectors = [outline.centre, outline.half, outline.along];
                vectors.iter().all(|v| v.is_finite()) && outline.low_m.is_finite() && outline.high_m.is_finite()
            };
            found.retain(|obstacle| finite(&obstacle.outline));
        }
        found
    }
}

impl VehicleBody {
    /// Its box in the world, from the clearance to the roof.
    pub fn outline(&self) -> OrientedBox {
        let shape = self.shape();
        let within = |x: f64| super::sane::within(x, 0.1, 60.0, 1.0);
        OrientedBox {
            centre: self.position.truncate(),
            half: 0.5 * DVec2::new(within(shape.length_m), within(shape.width_m)),
            along: direction(self.yaw_rad),
            low_m: self.position.z + CLEARANCE_M,
            high_m: self.position.z + within(shape.height_m).max(CLEARANCE_M + 0.1),
        }
    }

    fn solid(&self) -> Solid {
        let moved = f64::from(u8::from(self.simulated));
        Solid {
            outline: self.outline(),
            centre: self.centre(),
            velocity: self.planar.velocity,
            yaw_rate: self.planar.yaw_rate,
            per_mass: moved / self.p.mass_kg,
            per_inertia: moved / self.p.yaw_inertia,
            shift: DVec2::ZERO,
        }
    }
}

impl WalkerBody {
    /// Its box in the world, from above what it steps over to its head.
    pub fn outline(&self) -> OrientedBox {
        let place = self.place();
        OrientedBox {
            centre: place.position.truncate(),
            half: DVec2::splat(self.half_width_m()),
            along: direction(place.yaw_rad),
            low_m: place.position.z + STEPPED_OVER_M.min(0.5 * self.height_m()),
            high_m: place.position.z + self.height_m(),
        }
    }

    fn solid(&self) -> Solid {
        Solid {
            outline: self.outline(),
            centre: self.place().position.truncate(),
            velocity: self.velocity().truncate(),
            yaw_rate: 0.0,
            per_mass: f64::from(u8::from(self.simulated())) / self.mass_kg(),
            per_inertia: 0.0,
            shift: DVec2::ZERO,
        }
    }
}
