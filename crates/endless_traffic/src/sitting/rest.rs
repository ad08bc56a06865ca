//! A rest on a bench, from the way there to the way back.

use super::errand::{AGAIN_S, Phase, Rest, eased};
use super::places::BenchPlace;
use crate::body_contact::nearest_within;
use crate::people_grid::Passer;
use crate::roads::Roads;
use crate::walk_strip::{APART_M, height};
use crate::walker::Walker;
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::walking::Footsteps;
use endless_world::{BenchSeat, Gait};
use glam::DVec2;

/// Who is so near to where they leave the sidewalk has come there, metres; and to a point of the way from there.
const LEAVES_M: f64 = 0.35;
const THERE_M: f64 = 0.06;
/// How fast people come to a seat, m/s, get going, m/s², and turn, rad/s.
const PACE_MPS: f64 = 0.8;
const ACCELERATION: f64 = 1.5;
const TURN_RATE: f64 = 2.2;
/// They stand before the seat for so long until they sit down, seconds, with their back to it to this angle, radians.
const SETTLES_S: f64 = 0.9;
const TURNED_RAD: f64 = 0.02;
/// How long it takes to sit down or get up, seconds: about as Kralj, Jaeger and Munih (1990, "Analysis of standing up and sitting
/// down in humans", Journal of Biomechanics 23) measured.
const DOWN_S: f64 = 2.0;
/// Nobody looks for their seat for longer, nor tries to get to it or away from it, seconds.
const LOOKS_S: f64 = 25.0;
const TRIES_S: f64 = 12.0;
/// Who is this far behind a seat and no further away from it could not get away any more once somebody sits there, metres.
const SHUTS_IN_M: [f64; 2] = [0.1, 1.0];
/// Somebody may touch who sits down where there is less than this between the middles of bodies, metres.
const ROOM_M: f64 = APART_M + 0.01;

impl Walker {
    /// Whether they have left the sidewalk for a bench.
    pub(crate) fn is_at_bench(&self) -> bool {
        self.rest.as_deref().is_some_and(Rest::is_at_bench)
    }

    /// Of who sits: share of the way up from the seat.
    pub(crate) fn risen(&self) -> Option<f64> {
        self.rest.as_deref().and_then(Rest::risen)
    }

    /// Where they leave the sidewalk for their seat, while they are on the way there.
    pub(crate) fn comes_to_bench(&mut self, step_s: f64) -> Option<DVec2> {
        let (here, elsewhere) = (self.way[0].0, self.on_roadway() || self.bus.waits());
        let rest = self.rest.as_deref_mut()?;
        rest.since_s += step_s;
        if elsewhere || rest.place.edge != here || rest.since_s > LOOKS_S {
            self.rest = None;
            return None;
        }
        if rest.place.from.distance(self.position) < LEAVES_M {
            (rest.phase, rest.since_s) = (Phase::Leaves, 0.0);
        }
        Some(rest.place.from)
    }

    /// Where they stand before they sit down: their feet will be there.
    fn before_seat(&self, place: &BenchPlace) -> DVec2 {
        place.at.truncate() + place.facing * f64::from(BenchSeat::FEET_AHEAD * self.spec.height_m)
    }

    /// Puts somebody on a seat where they have sat for a while.
    pub(crate) fn sit(&mut self, place: BenchPlace, left_s: f64) {
        self.rest = Some(Box::new(Rest { place, phase: Phase::Sits, since_s: 0.0, left_s }));
        self.position = place.at.truncate();
        self.height = place.at.z;
        (self.yaw, self.gait) = (place.yaw, Gait::Sit);
        self.steps = Footsteps::new(&self.spec, self.before_seat(&place), place.yaw);
    }

    /// Moves on somebody who has left the sidewalk for a bench, among those who are near.
    pub(crate) fn step_at_bench(&mut self, roads: &Roads, near: &[Passer], step_s: f64) {
        let Some(mut rest) = self.rest.take().map(|rest| *rest) else { return };
        rest.since_s += step_s;
        let place = rest.place;
        let before = self.before_seat(&place);
        let next = match rest.phase {
            Phase::Comes | Phase::Leaves => {
                let there = self.walk_to(roads, before, near, step_s);
                match (there, rest.since_s > TRIES_S) {
                    (true, _) => rest.to(Phase::Turns),
                    (_, true) => rest.to(Phase::Returns),
                    _ => Some(rest),
                }
            }
            Phase::Turns => {
                self.walk_to(roads, before, near, step_s);
                let off = wrap_angle(place.yaw - self.yaw);
                self.yaw = wrap_angle(self.yaw + (off * 4.0).clamp(-TURN_RATE, TURN_RATE) * step_s);
                let settled = rest.since_s > SETTLES_S && off.abs() < TURNED_RAD && self.velocity.length() < 0.05;
                let sits_down = settled && !near.iter().any(|other| place.is_behind(other.at, SHUTS_IN_M));
                match (sits_down, rest.since_s > TRIES_S) {
                    (true, _) => rest.to(Phase::SitsDown(0.0)),
                    (_, true) => rest.to(Phase::Returns),
                    _ => Some(rest),
                }
            }
            Phase::SitsDown(share) => {
                self.yaw = place.yaw;
                match self.lower(&place, share, step_s, near, |share| 1.0 - eased(share)) {
                    share if share >= 1.0 => rest.to(Phase::Sits),
                    // Somebody who has come behind the seat stays in the way, and may be shut in: they get up and go.
                    share if rest.since_s > TRIES_S => rest.to(Phase::GetsUp(1.0 - share)),
                    share => Some(Rest { phase: Phase::SitsDown(share), ..rest }),
                }
            }
            Phase::Sits => {
                (self.velocity, self.intent) = (DVec2::ZERO, DVec2::ZERO);
                rest.left_s -= step_s;
                if rest.left_s <= 0.0 { rest.to(Phase::GetsUp(0.0)) } else { Some(rest) }
            }
            Phase::GetsUp(share) => match self.lower(&place, share, step_s, near, eased) {
                share if share >= 1.0 => rest.to(Phase::Returns),
                share => Some(Rest { phase: Phase::GetsUp(share), ..rest }),
            },
            Phase::Returns => {
                let there = self.walk_to(roads, place.from, near, step_s);
                if there || rest.since_s > TRIES_S { None } else { Some(rest) }
            }
        };
        let risen = next.and_then(|rest| rest.risen());
        self.gait = if risen.is_some() { Gait::Sit } else { self.steps.gait(self.velocity.length(), false) };
        if risen.is_none() {
            self.steps.advance(self.position, self.yaw, self.velocity, step_s);
            self.walked += self.velocity.length() * step_s;
        }
        let on_foot = height(roads, self.from, self.way[0], self.position);
        let change = risen.map_or(on_foot, |_| place.at.z) - self.height;
        self.height += change * (4.0 * step_s).min(1.0);
        self.rest = next.map(Box::new);
        if self.rest.is_none() {
            self.rests_again_s = AGAIN_S;
        }
    }

    /// A step of the way down or up, of which `share` lies behind; whoever is in the way is waited for. `risen` tells how much of the
    /// way up from the seat that is.
    fn lower(
        &mut self,
        place: &BenchPlace,
        share: f64,
        step_s: f64,
        near: &[Passer],
        risen: impl Fn(f64) -> f64,
    ) -> f64 {
        let later = (share + step_s / DOWN_S).min(1.0);
        let at = place.at.truncate().lerp(self.before_seat(place), risen(later));
        let nearer =
            |other: &Passer| other.at.distance(at) < ROOM_M && other.at.distance(at) < other.at.distance(self.position);
        if near.iter().any(nearer) {
            self.velocity = DVec2::ZERO;
            return share;
        }
        self.velocity = (at - self.position) / step_s;
        self.intent = self.velocity;
        self.position = at;
        later
    }

    /// A step towards a point beside the sidewalk; whether they have come there.
    fn walk_to(&mut self, roads: &Roads, point: DVec2, near: &[Passer], step_s: f64) -> bool {
        let left = point - self.position;
        let wanted = left.normalize_or_zero() * PACE_MPS.min(2.5 * left.length());
        self.intent = wanted;
        let change = (wanted - self.velocity).clamp_length_max(ACCELERATION * step_s);
        let bounds = self.bounds_of_bodies(roads, near, APART_M, step_s);
        self.velocity = nearest_within(&bounds, self.velocity + change);
        self.position += self.velocity * step_s;
        if self.velocity.length() > 0.25 {
            let off = wrap_angle(atan2(self.velocity.y, self.velocity.x) - self.yaw);
            self.yaw = wrap_angle(self.yaw + (off * 5.0).clamp(-TURN_RATE, TURN_RATE) * step_s);
        }
        self.position.distance(point) < THERE_M
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::sitting::BenchPlaces;
    use crate::walk_strip::BODY_M;
    use endless_road::{RoadNetwork, WalkEdge, WalkEdgeId, WalkKind, WalkNetwork, WalkNodeId};
    use endless_world::Stream;
    use endless_world::walking::PedestrianSpec;
    use glam::DVec3;

    const STEP_S: f64 = 1.0 / 30.0;

    #[test]
    fn who_cannot_sit_down_for_somebody_behind_the_seat_gets_up_again() {
        let ends = [WalkNodeId(0), WalkNodeId(1)];
        let edge = WalkEdge { nodes: ends, width_m: 3.0, kind: WalkKind::Sidewalk };
        let walk = WalkNetwork { nodes: vec![DVec3::ZERO, DVec3::new(40.0, 0.0, 0.0)], edges: vec![edge] };
        let network = RoadNetwork { walk, ..RoadNetwork::default() }.finish().expect("a sidewalk");
        let seat = BenchSeat { position: DVec3::new(10.0, -0.9, 0.1).as_vec3(), yaw_rad: std::f32::consts::FRAC_PI_2 };
        let place = BenchPlaces::new(&network, &[seat], BODY_M).all()[0];
        let roads = Roads::new(&TrafficMap::new(network, &[]), &Focus::default(), &[]);
        let (spec, stream) = (PedestrianSpec::default(), Stream::named(1, "test.rest", &[]));
        let mut walker = Walker::new(&roads, &spec, (WalkEdgeId(0), ends), place.from, stream);
        walker.position = walker.before_seat(&place);
        let rest = Rest { place, phase: Phase::SitsDown(0.0), since_s: 0.0, left_s: 60.0 };
        walker.rest = Some(Box::new(rest));
        let at = place.at.truncate() - place.facing * 0.3;
        let behind = Passer { at, velocity: DVec2::ZERO, intent: DVec2::ZERO, passed: 0 };
        let (mut lowest, mut jump_m) = (1.0f64, 0.0f64);
        for _ in 0..(2.5 * TRIES_S / STEP_S) as u32 {
            let before = walker.position;
            walker.step_at_bench(&roads, &[behind], STEP_S);
            jump_m = jump_m.max(walker.position.distance(before));
            lowest = lowest.min(walker.risen().unwrap_or(1.0));
            assert!(walker.position.distance(at) > 2.0 * BODY_M - 1e-9, "they touch");
        }
        assert!(lowest > 0.0 && lowest < 0.9, "{lowest} of the way up at the lowest");
        assert!(walker.rest.is_none() && jump_m < 0.05, "{:?} {jump_m}", walker.rest);
    }
}
