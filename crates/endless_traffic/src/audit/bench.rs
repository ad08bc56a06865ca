//! Benches: who sits is on a seat, and beside the sidewalk on purpose while they come and go.

use super::check::AuditCheck;
use super::finding::Incidents;
use super::report::AuditLine;
use super::sight::{Glance, Sight, entry};
use endless_world::math::f64::{sin_cos, wrap_angle};
use endless_world::{BenchSeat, Gait, Motion};
use glam::DVec2;

/// Who sits is so near to their seat, metres, and looks where it does, radians.
const ON_SEAT_M: f64 = 0.05;
const FACES_RAD: f64 = 0.1;
/// Between the sidewalk and a seat people are no further than this from the middle before it, metres.
const BEFORE_SEAT_M: f64 = 2.6;
const AHEAD_M: f64 = 0.4;

/// Watches those who sit.
#[derive(Debug, Default)]
pub(super) struct Benches {
    seats: Vec<(DVec2, f64)>,
    /// Who has been seen on their feet, by id: all but those in wheelchairs are, sooner or later.
    stood: Vec<bool>,
    beside_seat: Incidents,
    sat_before: Vec<bool>,
}

/// Whether somebody sits, and does not sit down or get up.
fn sits(glance: &Glance<'_>) -> bool {
    matches!(glance.actor.motion, Motion::Walker(motion) if motion.gait == Gait::Sit && motion.risen <= 0.0)
}

impl Benches {
    pub(super) fn new(seats: &[BenchSeat]) -> Self {
        let seat = |seat: &BenchSeat| (seat.position.as_dvec3().truncate(), f64::from(seat.yaw_rad));
        Self { seats: seats.iter().map(seat).collect(), ..Self::default() }
    }

    /// Whether somebody sits on a seat.
    pub(super) fn is_on_seat(&self, glance: &Glance<'_>) -> bool {
        let yaw = f64::from(glance.actor.pose.yaw_rad);
        let is_there = |(at, facing): &(DVec2, f64)| {
            at.distance(glance.at) < ON_SEAT_M && wrap_angle(yaw - facing).abs() < FACES_RAD
        };
        sits(glance) && self.seats.iter().any(is_there)
    }

    /// Whether a place is between a seat and the sidewalk.
    pub(super) fn is_before_seat(&self, place: DVec2) -> bool {
        let is_before = |&(at, facing): &(DVec2, f64)| {
            let (sin, cos) = sin_cos(facing);
            place.distance(at + DVec2::new(cos, sin) * AHEAD_M) < BEFORE_SEAT_M
        };
        self.seats.iter().any(is_before)
    }

    pub(super) fn look(&mut self, sight: &Sight<'_>) {
        for glance in sight.glances.iter().filter(|glance| glance.driven.is_none()) {
            let on_foot = !matches!(glance.actor.motion, Motion::Walker(motion) if motion.gait == Gait::Sit);
            *entry(&mut self.stood, glance.place()) |= on_foot;
            let sat = std::mem::replace(entry(&mut self.sat_before, glance.place()), sits(glance));
            if sits(glance) && !sat && self.stood[glance.place()] && !self.is_on_seat(glance) {
                self.beside_seat.add(|| glance.told(sight));
            }
        }
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![self.beside_seat.line(AuditCheck::BesideSeat)]
    }
}
