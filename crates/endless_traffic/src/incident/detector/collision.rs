//! Two vehicles that touch, until both stand.

use super::detected::DetectedIncident;
use super::history::StateHistory;
use endless_road::swept::OrientedRectangle;
use endless_world::{Actor, IncidentKind, InstanceId};
use glam::DVec2;
use std::collections::BTreeSet;

/// Bodies nearer than this touch, metres: nobody else comes so near.
const TOUCH_M: f64 = 0.06;
/// Slower than this they stand, m/s.
const STANDS_MPS: f64 = 0.1;
/// Who is further above or below is on another level, metres.
const STOREY_M: f32 = 2.0;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let mut found = Vec::new();
    let mut known: BTreeSet<[InstanceId; 2]> = BTreeSet::new();
    for frame in 1..history.states.len() {
        let drives = |actor: &&Actor| actor.asset.vehicle().is_some();
        let bodies: Vec<(&Actor, OrientedRectangle)> = history.states[frame]
            .actors
            .iter()
            .filter(drives)
            .map(|actor| {
                let body = history.body(actor);
                (actor, OrientedRectangle { half: body.half + DVec2::splat(0.5 * TOUCH_M), ..body })
            })
            .collect();
        for (i, (a, own)) in bodies.iter().enumerate() {
            for (b, other) in &bodies[i + 1..] {
                let level = (a.pose.position.z - b.pose.position.z).abs() < STOREY_M;
                if !level || !own.overlaps(other) || !known.insert([a.id, b.id]) {
                    continue;
                }
                // The one that comes from behind causes it.
                let behind = (other.center - own.center).dot(own.axis) > 0.0;
                let actors = if behind { vec![a.id, b.id] } else { vec![b.id, a.id] };
                let end = last_moving(history, frame, &actors);
                let (begin_frame, end_frame) = (frame as u32, end as u32);
                found.push(DetectedIncident { kind: IncidentKind::Collision, actors, begin_frame, end_frame });
            }
        }
    }
    found
}

/// The last frame from this one on before both stand.
fn last_moving(history: &StateHistory<'_>, begin: usize, actors: &[InstanceId]) -> usize {
    let moves = |frame: usize, id: InstanceId| {
        let [before, now] = [frame - 1, frame].map(|frame| history.body_at(frame, id));
        before.zip(now).is_some_and(|(before, now)| before.center.distance(now.center) * history.fps > STANDS_MPS)
    };
    let frames = begin..history.states.len();
    frames.take_while(|&frame| actors.iter().any(|&id| moves(frame, id))).last().unwrap_or(begin)
}
