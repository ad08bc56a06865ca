//! Who is nearer to the middle of a lane along which others come the other way than to any of their own direction.

use super::detected::{DetectedIncident, runs};
use super::history::StateHistory;
use endless_road::Lane;
use endless_world::{IncidentKind, InstanceId};

/// For so long at least, seconds.
const LEAST_S: f64 = 1.0;
/// Lanes further away do not count, metres.
const NEAR_M: f64 = 4.0;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;
/// Cosine of the angle within which somebody drives along a lane.
const ALONG: f64 = 0.7;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let mut found = Vec::new();
    for id in history.vehicles() {
        let frames = (0..history.states.len()).filter(|&frame| is_wrong(history, frame, id));
        let long = |(begin, end): &(usize, usize)| (end - begin) as f64 >= LEAST_S * history.fps;
        found.extend(runs(frames, 1).into_iter().filter(long).map(|(begin, end)| DetectedIncident {
            kind: IncidentKind::WrongWay,
            actors: vec![id],
            begin_frame: begin as u32,
            end_frame: end as u32,
        }));
    }
    found
}

fn is_wrong(history: &StateHistory<'_>, frame: usize, id: InstanceId) -> bool {
    let Some(actor) = history.actor(frame, id) else { return false };
    let (body, z) = (history.body(actor), f64::from(actor.pose.position.z));
    let beside = |lane: &Lane| {
        let (s, t) = lane.centerline.project(body.center);
        let level = (lane.centerline.position(s).z - z).abs() < STOREY_M;
        let inside = s > 0.0 && s < lane.centerline.length();
        let along = body.axis.dot(lane.centerline.direction(s));
        (level && inside && t.abs() < NEAR_M).then_some((t.abs(), along))
    };
    let (mut own, mut opposite, mut inside) = (f64::INFINITY, f64::INFINITY, f64::INFINITY);
    for lane in &history.network.lanes {
        let Some((apart_m, along)) = beside(lane) else { continue };
        if lane.junction.is_some() {
            inside = inside.min(apart_m);
        } else if along > ALONG {
            own = own.min(apart_m);
        } else if along < -ALONG {
            opposite = opposite.min(apart_m);
        }
    }
    // In junctions lanes of all directions cross.
    opposite < own.min(inside)
}
