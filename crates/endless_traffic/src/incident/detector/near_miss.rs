//! Two of whom one follows the other, who would touch within a moment and can no more be saved by gentle braking.

use super::detected::{DetectedIncident, runs};
use super::history::StateHistory;
use crate::incident::conflict::{EVASIVE_MPS2, MovingBody, NEAR_MISS_S};
use endless_world::{Actor, IncidentKind, InstanceId};
use glam::DVec2;
use std::collections::BTreeMap;

/// Farther apart they have nothing to do with one another, metres.
const NEAR_M: f64 = 40.0;
/// Ways that differ by a smaller angle follow one another: its cosine.
const SAME_WAY: f64 = 0.95;
/// It is one conflict if it is not over for longer, seconds.
const PAUSE_S: f64 = 0.5;
/// Who is further above or below is on another level, metres.
const STOREY_M: f32 = 3.0;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let mut frames: BTreeMap<[InstanceId; 2], Vec<usize>> = BTreeMap::new();
    for frame in 1..history.states.len() {
        let actors = &history.states[frame].actors;
        let moving: Vec<(&Actor, MovingBody)> =
            actors.iter().filter_map(|actor| Some((actor, moving_body(history, frame, actor)?))).collect();
        for (i, (a, own)) in moving.iter().enumerate() {
            for (b, other) in &moving[i + 1..] {
                let apart = other.body.center - own.body.center;
                let level = (a.pose.position.z - b.pose.position.z).abs() < STOREY_M;
                if !level || apart.length() > NEAR_M || own.body.axis.dot(other.body.axis) < SAME_WAY {
                    continue;
                }
                let Some(time_s) = own.time_to_collision_s(other).filter(|time| *time > 0.0) else { continue };
                if time_s < NEAR_MISS_S && own.needed_mps2(other, time_s) > EVASIVE_MPS2 {
                    let ahead_first = if apart.dot(own.body.axis) < 0.0 { [a.id, b.id] } else { [b.id, a.id] };
                    frames.entry(ahead_first).or_default().push(frame);
                }
            }
        }
    }
    let pause = (PAUSE_S * history.fps) as usize;
    let found = frames.into_iter().flat_map(|(ids, frames)| {
        runs(frames, pause).into_iter().map(move |(begin, end)| DetectedIncident {
            kind: IncidentKind::NearMiss,
            actors: ids.to_vec(),
            begin_frame: begin as u32,
            end_frame: end as u32,
        })
    });
    found.collect()
}

/// Of a vehicle: it goes the way that it heads, as fast as its state tells.
fn moving_body(history: &StateHistory<'_>, frame: usize, actor: &Actor) -> Option<MovingBody> {
    actor.asset.vehicle()?;
    history.actor(frame - 1, actor.id)?;
    let velocity: DVec2 = actor.velocity_mps.as_dvec3().truncate();
    Some(MovingBody { body: history.body(actor), velocity })
}
