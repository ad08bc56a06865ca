//! How people choose where to walk among others and how fast: the two rules of Moussaïd, Helbing and Theraulaz (2011, "How
//! simple rules determine pedestrian behavior and crowd disasters", PNAS 108). Somebody walks in the direction in which they
//! get nearest to where they want, given how everybody moves, and no faster than so that they reach whoever is ahead there in a
//! given time. Contacts, which the paper's bodies push away, are excluded by [`crate::body_contact`].

use crate::people_grid::Passer;
use crate::walk_strip::{APART_M, Footway, unit_vector};
use glam::DVec2;

/// How far ahead people look for a way, metres.
const HORIZON_M: f64 = 5.0;
/// Time that people leave between themselves and whoever is ahead, seconds: with it, speed falls with density as Weidmann (1993)
/// measured.
const TIME_GAP_S: f64 = 0.36;
/// Room that people keep to others who come nearer, metres, and where it is crowded.
const SHY_M: f64 = 0.15;
/// People within this distance make a crowd, metres.
pub(crate) const CROWD_M: f64 = 2.0;
/// Who comes the other way is made room for from this distance on, metres.
const COMES_M: f64 = 3.0;
/// Cosine of the angle to the opposite direction within which somebody comes the other way.
const OPPOSES: f64 = 0.5;
/// People squeeze past whoever comes the other way as if there were so much more room, metres.
const SQUEEZE_M: f64 = 0.15;
/// Of whoever does not get on as they like, others take the mean of what they do and what they like for what they will do.
const ANTICIPATION: f64 = 0.5;
/// How much it costs to step to the left, square metres.
const LEFT_COST: f64 = 0.4;
/// Directions that are looked at beside the wanted one, radians to the left.
const TURNS: [f64; 14] = [-0.15, 0.15, -0.3, 0.3, -0.5, 0.5, -0.7, 0.7, -0.9, 0.9, -1.15, 1.15, -1.4, 1.4];
/// Who gets on with less than this share of the speed they want is held up.
const HELD_SHARE: f64 = 0.3;
/// Who is so near presses on others, metres beyond their bodies.
const PRESSES_M: f64 = 0.1;
/// People make way with this share of the speed of those who press on them, and no faster, m/s.
const YIELDING: f64 = 0.5;
const YIELDS_MPS: f64 = 0.6;
/// A way's edges are looked for at these distances, metres.
const STATIONS_M: [f64; 5] = [0.2, 0.5, 1.0, 2.0, 3.5];

impl Passer {
    /// The velocity that they will have, as far as others can tell.
    fn expected(&self) -> DVec2 {
        self.velocity.lerp(self.intent, ANTICIPATION)
    }
}

/// The velocity that somebody takes at a place if they want to go with another one.
pub(crate) fn avoid(at: DVec2, wanted: DVec2, near: &[Passer], apart_m: f64, way: &Footway<'_>) -> DVec2 {
    let pace = wanted.length();
    if near.is_empty() || pace < 1e-6 {
        return wanted;
    }
    let straight = wanted / pace;
    let apart = apart_m + SHY_M / (1.0 + 0.25 * crowd(at, near) as f64);
    let cost = |turn: f64, direction: DVec2, free: f64| {
        let left = if turn > 0.0 { LEFT_COST } else { 0.0 };
        // Square of the distance from where they get to the horizon straight ahead.
        HORIZON_M * HORIZON_M + free * free - 2.0 * HORIZON_M * free * direction.dot(straight) + left
    };
    let free = free_path(at, straight, pace, near, apart);
    let mut best = (cost(0.0, straight, free), straight);
    if free < HORIZON_M {
        for turn in TURNS {
            let direction = unit_vector(turn).rotate(straight);
            let free = way.free_path(at, direction, &STATIONS_M).min(free_path(at, direction, pace, near, apart));
            let cost = cost(turn, direction, free);
            if cost < best.0 {
                best = (cost, direction);
            }
        }
    }
    best.1 * pace.min(gap_ahead(at, best.1, near, apart_m) / TIME_GAP_S)
}

/// The velocity that somebody takes in single file: they stay behind whoever is ahead.
pub(crate) fn follow(at: DVec2, wanted: DVec2, near: &[Passer]) -> DVec2 {
    let pace = wanted.length();
    if pace < 1e-6 {
        return wanted;
    }
    wanted / pace * pace.min(gap_ahead(at, wanted / pace, near, APART_M) / TIME_GAP_S)
}

/// How many people are so near that it is crowded.
pub(crate) fn crowd(at: DVec2, near: &[Passer]) -> usize {
    near.iter().take_while(|passer| passer.at.distance_squared(at) < CROWD_M * CROWD_M).count()
}

/// Whether somebody comes the other way, near enough to make room for.
pub(crate) fn somebody_comes(at: DVec2, ahead: DVec2, near: &[Passer]) -> bool {
    let comes = |passer: &Passer| {
        let away = passer.at - at;
        opposes(passer, ahead) && away.dot(ahead) > 0.0 && away.length_squared() < COMES_M * COMES_M
    };
    near.iter().any(comes)
}

fn opposes(passer: &Passer, ahead: DVec2) -> bool {
    passer.intent.dot(ahead) < -OPPOSES * passer.intent.length()
}

/// How far somebody gets in a direction before they touch anybody, if all go on as they do, metres.
fn free_path(at: DVec2, direction: DVec2, pace: f64, near: &[Passer], apart: f64) -> f64 {
    let velocity = direction * pace;
    let until = HORIZON_M / pace;
    let time = near.iter().filter_map(|passer| touch_in(passer.at - at, passer.expected() - velocity, apart));
    time.fold(until, f64::min) * pace
}

/// Seconds until somebody at a relative place with a relative velocity comes nearer than so far apart.
fn touch_in(relative: DVec2, velocity: DVec2, apart: f64) -> Option<f64> {
    let closing = -relative.dot(velocity);
    if closing <= 0.0 {
        return None;
    }
    // Who is nearer already is in the way as soon as they come nearer still.
    let apart = apart.min(0.98 * relative.length());
    let a = velocity.length_squared();
    let discriminant = closing * closing - a * (relative.length_squared() - apart * apart);
    (discriminant > 0.0 && a > 1e-9).then(|| ((closing - discriminant.sqrt()) / a).max(0.0))
}

/// The velocity with which somebody makes way for those who press on them: in a jam nobody would get on who is not let through.
pub(crate) fn give_way(at: DVec2, near: &[Passer]) -> DVec2 {
    let pressed = |passer: &Passer| {
        let away = at - passer.at;
        let distance = away.length();
        let push = passer.intent.dot(away) / distance.max(1e-6);
        let held = passer.velocity.length() < HELD_SHARE * passer.intent.length();
        (held && push > 0.0 && distance < APART_M + PRESSES_M).then(|| away / distance * push)
    };
    (near.iter().filter_map(pressed).sum::<DVec2>() * YIELDING).clamp_length_max(YIELDS_MPS)
}

/// Room to the nearest body ahead in a direction, as all stand now, metres.
fn gap_ahead(at: DVec2, direction: DVec2, near: &[Passer], apart: f64) -> f64 {
    let gap = |passer: &Passer| {
        let away = passer.at - at;
        let (along, beside) = (away.dot(direction), direction.perp_dot(away));
        let squeeze = if opposes(passer, direction) { SQUEEZE_M } else { 0.0 };
        let room = || (along - (apart * apart - beside * beside).sqrt()).max(0.0) + squeeze;
        (along > 0.0 && beside.abs() < apart).then(room)
    };
    near.iter().filter_map(gap).fold(f64::INFINITY, f64::min)
}
