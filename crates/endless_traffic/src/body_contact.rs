//! Bodies that do not overlap: of all velocities that bring somebody into nobody, the one nearest to what they want (Maury and
//! Venel 2011, "A discrete contact model for crowd motion"). Here people move one after another, each among the others as they
//! are at that instant, so that the bound of a contact is the whole gap.

use crate::people_grid::Passer;
use crate::walk_strip::DirectedEdge;
use glam::DVec2;

/// Kept between bodies in any case, metres.
const SKIN_M: f64 = 0.02;
/// Who is further away than a body and this is not reached in a step, metres.
const REACH_M: f64 = 0.3;
/// A velocity is that much beyond a bound by rounding alone, m/s.
const ROUNDING: f64 = 1e-9;

/// A half plane of velocities: so far at most in a direction of unit length, m/s. At least 0: standing is always allowed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Bound {
    direction: DVec2,
    most: f64,
}

/// No further than this in a direction of unit length in a step, metres.
pub(crate) fn bound(direction: DVec2, room_m: f64, step_s: f64) -> Bound {
    Bound { direction, most: (room_m / step_s).max(0.0) }
}

/// The bounds that bodies near somebody put on their velocity for a step, if the middles of two bodies that touch are
/// `apart_m` from one another, metres.
pub(crate) fn bounds_of_bodies(at: DVec2, near: &[Passer], apart_m: f64, step_s: f64) -> Vec<Bound> {
    let apart = apart_m + SKIN_M;
    let bound = |passer: &Passer| {
        let away = passer.at - at;
        let distance = away.length();
        (distance < apart + REACH_M && distance > 0.0)
            .then(|| Bound { direction: away / distance, most: ((distance - apart) / step_s).max(0.0) })
    };
    near.iter().filter_map(bound).collect()
}

/// The bounds that the edges of a strip put on it, `beside` metres beyond its usable width.
pub(crate) fn bounds_of_strip(strip: &DirectedEdge, at: DVec2, beside: f64, step_s: f64) -> [Bound; 4] {
    let (along, left) = strip.local(at);
    let side = strip.half_width + beside;
    let rooms = [
        (strip.along, strip.length - along),
        // Its beginning is round.
        (-strip.along, along + (side * side - left * left).max(0.0).sqrt().min(strip.round_m)),
        (strip.along.perp(), side - left),
        (-strip.along.perp(), side + left),
    ];
    rooms.map(|(direction, room)| Bound { direction, most: (room / step_s).max(0.0) })
}

/// The velocity nearest to a wanted one that keeps to all bounds.
pub(crate) fn nearest_within(bounds: &[Bound], wanted: DVec2) -> DVec2 {
    let keeps = |velocity: DVec2| bounds.iter().all(|b| velocity.dot(b.direction) <= b.most + ROUNDING);
    if keeps(wanted) {
        return wanted;
    }
    // It lies on one bound, or where two cross.
    let on_one = bounds.iter().map(|b| wanted - b.direction * (wanted.dot(b.direction) - b.most));
    let crossing = |(i, a): (usize, &Bound)| {
        let a = *a;
        bounds[i + 1..].iter().filter_map(move |b| {
            let turn = a.direction.perp_dot(b.direction);
            let point = || (b.direction.perp() * -a.most + a.direction.perp() * b.most) / turn;
            (turn.abs() > 1e-6).then(point)
        })
    };
    let corners = bounds.iter().enumerate().flat_map(crossing);
    let mut best = (wanted.length_squared(), DVec2::ZERO);
    for candidate in on_one.chain(corners) {
        let off = candidate.distance_squared(wanted);
        if off < best.0 && keeps(candidate) {
            best = (off, candidate);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::walk_strip::{APART_M, unit_vector};
    use endless_world::Stream;

    #[test]
    fn no_velocity_of_a_fine_grid_is_nearer() {
        let mut stream = Stream::named(1, "test.body_contact", &[]);
        for _ in 0..200 {
            let bounds: Vec<Bound> = (0..5)
                .map(|_| Bound {
                    direction: unit_vector(stream.range_f64(-3.1, 3.1)),
                    most: stream.range_f64(-0.5, 0.8).max(0.0),
                })
                .collect();
            let wanted = unit_vector(stream.range_f64(-3.1, 3.1)) * 1.3;
            let found = nearest_within(&bounds, wanted);
            let keeps = |v: DVec2, slack: f64| bounds.iter().all(|b| v.dot(b.direction) <= b.most + slack);
            assert!(keeps(found, 1e-6), "{bounds:?} {found}");
            for i in -60..=60 {
                for j in -60..=60 {
                    let other = DVec2::new(f64::from(i), f64::from(j)) * 0.025;
                    if keeps(other, 0.0) {
                        assert!(other.distance(wanted) > found.distance(wanted) - 1e-9, "{bounds:?} {wanted} {other}");
                    }
                }
            }
        }
    }

    #[test]
    fn who_runs_into_somebody_slides_around_them() {
        let near = [Passer { at: DVec2::new(0.53, 0.1), velocity: DVec2::ZERO, intent: DVec2::ZERO, passed: 0 }];
        let step_s = 1.0 / 30.0;
        let velocity = nearest_within(&bounds_of_bodies(DVec2::ZERO, &near, APART_M, step_s), DVec2::new(1.3, 0.0));
        assert!(velocity.x > 0.01 && velocity.y < -0.05, "{velocity}");
        assert!((near[0].at - velocity * step_s).length() >= APART_M + SKIN_M - 1e-9);
    }
}
