//! A vehicle that stands for no reason, and a queue behind it that ends at the exit of a junction.

use super::abreast::EndLine;
use super::detected::{DetectedIncident, runs};
use super::history::StateHistory;
use super::standing;
use endless_road::Lane;
use endless_road::swept::OrientedRectangle;
use endless_world::{IncidentKind, InstanceId};

/// Slower than this a vehicle stands in the queue, m/s.
const STANDS_MPS: f64 = 0.5;
/// Gap between bumpers in a queue, at most, metres.
const GAP_M: f64 = 7.0;
/// One of the queue is no further beyond the end of the junction than this, metres.
const FULL_M: f64 = 8.0;
/// And no further before it.
const INSIDE_M: f64 = 12.0;
/// It is one queue if it moves up for no longer, seconds.
const PAUSE_S: f64 = 2.0;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let network = history.network;
    let inside = |lane: &Lane| lane.junction.is_some();
    let leads_out = |lane: &&Lane| inside(lane) && lane.successors.iter().any(|next| !inside(network.lane(*next)));
    let exits: Vec<EndLine> = network.lanes.iter().filter(leads_out).map(|lane| EndLine::of(lane, None)).collect();
    let mut found = Vec::new();
    for head in standing::detect(history, IncidentKind::Stalled) {
        let frames = head.begin_frame as usize..=head.end_frame as usize;
        let id = head.actors[0];
        let spills = frames.filter(|&frame| spills_back(history, &exits, frame, id));
        let pause = (PAUSE_S * history.fps) as usize;
        found.extend(runs(spills, pause).into_iter().map(|(begin, end)| DetectedIncident {
            kind: IncidentKind::QueueSpillback,
            actors: vec![id],
            begin_frame: begin as u32,
            end_frame: end as u32,
        }));
    }
    found
}

fn spills_back(history: &StateHistory<'_>, exits: &[EndLine], frame: usize, head: InstanceId) -> bool {
    let Some(actor) = history.actor(frame, head) else { return false };
    let z = f64::from(actor.pose.position.z);
    let mut last = history.body(actor);
    let mut queue = vec![head];
    // The queue may go on to the road before the junction.
    while let Some((id, body)) = next_behind(history, frame, &queue, &last, z) {
        queue.push(id);
        last = body;
        let rear = last.place(-last.half.x, 0.0).extend(z);
        let near = |line: &EndLine| line.beyond_m(rear).is_some_and(|beyond| (-INSIDE_M..FULL_M).contains(&beyond));
        if exits.iter().any(near) {
            return true;
        }
    }
    false
}

/// Who stands behind a body with no more than a queue's gap between.
fn next_behind(
    history: &StateHistory<'_>,
    frame: usize,
    queue: &[InstanceId],
    last: &OrientedRectangle,
    z: f64,
) -> Option<(InstanceId, OrientedRectangle)> {
    let mut gap = last.moved(-(last.half.x + 0.5 * GAP_M));
    gap.half.x = 0.5 * GAP_M;
    let others = history.states[frame].actors.iter().filter(|other| !queue.contains(&other.id));
    others.into_iter().find_map(|other| {
        let body = history.body(other);
        let level = (f64::from(other.pose.position.z) - z).abs() < STOREY_M;
        let before = history.body_at(frame.checked_sub(1)?, other.id)?;
        let stands = before.center.distance(body.center) * history.fps < STANDS_MPS;
        let behind = other.asset.vehicle().is_some() && body.axis.dot(last.axis) > 0.7;
        (level && stands && behind && gap.overlaps(&body)).then_some((other.id, body))
    })
}
