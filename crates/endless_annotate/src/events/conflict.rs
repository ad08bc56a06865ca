//! Conflicts of two road users: how soon they would touch, and how soon one came where the other had been.

use super::Footprint;
use super::road_user::RoadUser;
use endless_world::InstanceId;
use std::collections::{BTreeMap, VecDeque};

/// Two that would touch sooner if both went on as they do come near a collision, seconds.
pub const NEAR_MISS_S: f32 = 1.5;
/// One that comes sooner to where another has just been encroaches upon it, seconds.
pub const ENCROACHMENT_S: f64 = 1.5;

/// Farther apart they have nothing to do with one another, metres.
const NEAR_M: f32 = 45.0;
/// Ways that differ by a smaller angle follow one another: its cosine.
const SAME_WAY: f32 = 0.94;
/// Slower than this nobody comes near anybody, m/s.
const MOVES_MPS: f32 = 0.8;

/// Pairs of road users near one another of whom one drives and one moves, each once.
pub(super) fn pairs(users: &[RoadUser]) -> Vec<(&RoadUser, &RoadUser)> {
    let mut by_east: Vec<(&RoadUser, Footprint)> = users.iter().filter_map(|u| Some((u, u.footprint?))).collect();
    by_east.sort_by(|a, b| a.1.centre.x.total_cmp(&b.1.centre.x).then(a.0.id.cmp(&b.0.id)));
    let mut found = Vec::new();
    for (i, (a, own)) in by_east.iter().enumerate() {
        let near = by_east[i + 1..].iter().take_while(|(_, other)| other.centre.x - own.centre.x < NEAR_M);
        for (b, _) in near.filter(|(b, other)| {
            (a.drives || b.drives)
                && (a.speed_mps > MOVES_MPS || b.speed_mps > MOVES_MPS)
                && (other.centre - own.centre).length_squared() < NEAR_M * NEAR_M
        }) {
            found.push(if a.id < b.id { (*a, *b) } else { (*b, *a) });
        }
    }
    found.sort_by_key(|(a, b)| (a.id, b.id));
    found
}

/// Where everybody has been in the last moments.
#[derive(Debug, Clone, Default)]
pub(super) struct Trails(BTreeMap<InstanceId, VecDeque<(f64, Footprint)>>);

impl Trails {
    /// Notes where everybody is.
    pub(super) fn note(&mut self, users: &[RoadUser], time_s: f64) {
        for user in users {
            let Some(footprint) = user.footprint else { continue };
            let trail = self.0.entry(user.id).or_default();
            trail.push_back((time_s, footprint));
            while trail.front().is_some_and(|(then, _)| time_s - then > ENCROACHMENT_S) {
                trail.pop_front();
            }
        }
    }

    /// How long ago somebody left the ground on which another stands now, if not along the same way: the post-encroachment
    /// time, seconds.
    pub(super) fn post_encroachment_s(&self, first: &RoadUser, second: &RoadUser, time_s: f64) -> Option<f64> {
        let (there, here) = (first.footprint?, second.footprint?);
        if there.overlaps(&here) {
            return None;
        }
        let trail = self.0.get(&first.id)?;
        let (then, footprint) = trail.iter().rev().find(|(_, before)| before.overlaps(&here))?;
        let crosses = footprint.along.dot(here.along) < SAME_WAY;
        crosses.then_some(time_s - then)
    }
}
