//! Whose front comes over a stop line at some speed when the light has been red for a second, until the rear has left the
//! junction.

use super::abreast::EndLine;
use super::detected::DetectedIncident;
use super::history::StateHistory;
use endless_road::{Lane, TrafficControl};
use endless_world::{IncidentKind, InstanceId, SignalAspect, SignalId};
use glam::{DVec2, DVec3};

/// Red for so long, seconds: who passes sooner could not stop any more. Who has waited at the line, and stood less than this
/// long ago, may clear the junction for as long.
const RED_S: f64 = 1.0;
const CLEARS_S: f64 = 4.0;
/// Slower than this a vehicle stands, m/s.
const STANDS_MPS: f64 = 0.5;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let network = history.network;
    let inside = |lane: &Lane| lane.junction.is_some();
    let leads_in = |lane: &&Lane| lane.successors.iter().any(|next| inside(network.lane(*next)));
    let leads_out = |lane: &&Lane| inside(lane) && lane.successors.iter().any(|next| !inside(network.lane(*next)));
    let stop_line = |lane: &Lane| match lane.end_control {
        TrafficControl::Signal(signal) => Some(EndLine::of(lane, Some(signal))),
        _ => None,
    };
    let entries: Vec<EndLine> = network.lanes.iter().filter(leads_in).filter_map(stop_line).collect();
    let exits: Vec<EndLine> = network.lanes.iter().filter(leads_out).map(|lane| EndLine::of(lane, None)).collect();
    let mut found = Vec::new();
    for id in history.vehicles() {
        let mut begun: Option<usize> = None;
        for frame in 1..history.states.len() {
            let ends = [frame - 1, frame].map(|frame| ends(history, frame, id));
            let [Some([front_before, rear_before, _]), Some([front, rear, ahead])] = ends else { continue };
            let ahead = ahead.truncate();
            if let Some(begin) = begun {
                if exits.iter().any(|line| line.passed(rear_before, rear, ahead)) {
                    let (begin_frame, end_frame) = (begin as u32, frame as u32 - 1);
                    found.push(DetectedIncident {
                        kind: IncidentKind::RedLightRun,
                        actors: vec![id],
                        begin_frame,
                        end_frame,
                    });
                    begun = None;
                }
                continue;
            }
            let mut passed = entries.iter().filter(|line| line.passed(front_before, front, ahead)).peekable();
            if passed.peek().is_none() {
                continue;
            }
            let most_s = if has_waited(history, frame, id) { CLEARS_S } else { RED_S };
            let red = |line: &EndLine| line.signal.is_some_and(|signal| red_for_s(history, frame, signal) >= most_s);
            if passed.any(red) {
                begun = Some(frame);
            }
        }
    }
    found
}

/// Whether somebody stood not long ago.
fn has_waited(history: &StateHistory<'_>, frame: usize, id: InstanceId) -> bool {
    let frames = (CLEARS_S * history.fps) as usize;
    let stands = |frame: usize| {
        history.actor(frame, id).is_some_and(|actor| f64::from(actor.velocity_mps.length()) < STANDS_MPS)
    };
    (frame.saturating_sub(frames)..frame).any(stands)
}

/// Front, rear, and the unit vector ahead.
fn ends(history: &StateHistory<'_>, frame: usize, id: InstanceId) -> Option<[DVec3; 3]> {
    let actor = history.actor(frame, id)?;
    let (body, z) = (history.body(actor), f64::from(actor.pose.position.z));
    let at = |ahead: f64| -> DVec2 { body.place(ahead, 0.0) };
    Some([at(body.half.x).extend(z), at(-body.half.x).extend(z), body.axis.extend(0.0)])
}

/// For how long a signal has been red, seconds; it is not asked for more than five.
fn red_for_s(history: &StateHistory<'_>, frame: usize, signal: SignalId) -> f64 {
    let red = |frame: &usize| history.states[*frame].signals[usize::from(signal.0)].aspect == SignalAspect::Red;
    let most = (5.0 * history.fps) as usize;
    let frames = (0..=frame).rev().take(most).take_while(red).count();
    // What was red since the first frame has been red for longer.
    if frames == frame + 1 { 5.0 } else { frames as f64 / history.fps }
}
