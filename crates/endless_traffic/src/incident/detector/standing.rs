//! Who stands on a lane although nothing holds them: nobody is close ahead, and neither a junction nor a crossing. In the
//! lane's middle they have broken down, at its edge they are parked.

use super::abreast::EndLine;
use super::detected::{DetectedIncident, runs};
use super::history::StateHistory;
use endless_road::Lane;
use endless_road::swept::OrientedRectangle;
use endless_world::math::segment::share_along;
use endless_world::{IncidentKind, InstanceId, Motion, ObjectClass, VehicleLights};
use glam::DVec3;

/// Slower than this a vehicle stands, m/s.
const STANDS_MPS: f64 = 0.1;
/// It does so for at least so long, seconds.
const LEAST_S: f64 = 3.0;
/// Those ahead may drive on for so long, seconds.
const SETTLES_S: f64 = 1.5;
/// What holds somebody is within this ahead, metres: others, the line before a junction, a crossing.
const OTHERS_M: f64 = 8.0;
const LINE_M: f64 = 10.0;
const CROSSING_M: f64 = 8.0;
/// Further from the lane's middle than this it stands at the edge, metres.
const ASIDE_M: f64 = 0.35;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;

pub(super) fn detect(history: &StateHistory<'_>, kind: IncidentKind) -> Vec<DetectedIncident> {
    let network = history.network;
    let leads_in = |lane: &&Lane| lane.successors.iter().any(|next| network.lane(*next).junction.is_some());
    let lines: Vec<EndLine> = network.lanes.iter().filter(leads_in).map(|lane| EndLine::of(lane, None)).collect();
    let mut found = Vec::new();
    for id in history.vehicles() {
        let stands = |frame: &usize| -> bool {
            let two = [frame - 1, *frame].map(|frame| history.body_at(frame, id));
            let [Some(before), Some(now)] = two else { return false };
            before.center.distance(now.center) * history.fps < STANDS_MPS
        };
        let frames = (1..history.states.len()).filter(stands);
        for (begin, end) in runs(frames, 0) {
            let short = ((end - begin) as f64) < LEAST_S * history.fps;
            if short || at_bus_stop(history, begin, end, id) || held(history, &lines, begin, end, id) {
                continue;
            }
            let Some(aside_m) = aside_m(history, end, id) else { continue };
            let is = if aside_m > ASIDE_M { IncidentKind::IllegalParking } else { IncidentKind::Stalled };
            if is == kind {
                let (begin_frame, end_frame) = (begin as u32, end as u32);
                found.push(DetectedIncident { kind, actors: vec![id], begin_frame, end_frame });
            }
        }
    }
    found
}

/// Whether it is a bus without hazard lights, which stands to let people in.
fn at_bus_stop(history: &StateHistory<'_>, begin: usize, end: usize, id: InstanceId) -> bool {
    let actors = || (begin..=end).filter_map(|frame| history.actor(frame, id));
    let both = VehicleLights::LEFT_BLINKER | VehicleLights::RIGHT_BLINKER;
    let flashes = |motion: Motion| matches!(motion, Motion::Vehicle(motion) if motion.lights.contains(both));
    actors().all(|actor| actor.class == ObjectClass::Bus && !flashes(actor.motion))
}

/// Whether something holds somebody most of the time, or it is a two-wheeler, which stops where it likes.
fn held(history: &StateHistory<'_>, lines: &[EndLine], begin: usize, end: usize, id: InstanceId) -> bool {
    let settled = begin + (SETTLES_S * history.fps) as usize;
    let held = |frame: &usize| {
        let Some(actor) = history.actor(*frame, id) else { return true };
        let body = history.body(actor);
        let z = f64::from(actor.pose.position.z);
        let front = body.place(body.half.x, 0.0).extend(z);
        let at_line =
            lines.iter().any(|line| line.beyond_m(front).is_some_and(|beyond| (-LINE_M..2.0).contains(&beyond)));
        actor.class.two_wheeled()
            || at_line
            || at_crossing(history, &body, z)
            || others_ahead(history, *frame, id, &body, z)
    };
    2 * (settled..=end).filter(held).count() > end + 1 - settled
}

fn others_ahead(history: &StateHistory<'_>, frame: usize, id: InstanceId, body: &OrientedRectangle, z: f64) -> bool {
    // From its middle to so far before its front.
    let mut ahead = body.moved(0.5 * (body.half.x + OTHERS_M));
    ahead.half.x = 0.5 * (body.half.x + OTHERS_M);
    let others = history.states[frame].actors.iter().filter(|other| other.id != id);
    others
        .into_iter()
        .any(|other| (f64::from(other.pose.position.z) - z).abs() < STOREY_M && ahead.overlaps(&history.body(other)))
}

fn at_crossing(history: &StateHistory<'_>, body: &OrientedRectangle, z: f64) -> bool {
    let ways = (0..=CROSSING_M as u32).map(|ahead| body.place(body.half.x + f64::from(ahead), 0.0));
    let ways: Vec<glam::DVec2> = ways.collect();
    history.network.crossings.iter().any(|crossing| {
        let [a, b] = crossing.ends.map(DVec3::truncate);
        let near = |at: &glam::DVec2| {
            let u = share_along(*at, a, b);
            at.distance(a.lerp(b, u)) < 0.5 * crossing.width_m
        };
        (crossing.ends[0].z - z).abs() < STOREY_M && ways.iter().any(near)
    })
}

/// How far the middle of a vehicle is beside the middle of the lane along which it heads, metres.
fn aside_m(history: &StateHistory<'_>, frame: usize, id: InstanceId) -> Option<f64> {
    let actor = history.actor(frame, id)?;
    let (body, z) = (history.body(actor), f64::from(actor.pose.position.z));
    let beside = |lane: &Lane| {
        let (s, t) = lane.centerline.project(body.center);
        let on = lane.centerline.at(s);
        let fits = body.axis.dot(lane.centerline.direction(s)) > 0.9 && (on.position.z - z).abs() < STOREY_M;
        let inside = s > 0.0 && s < lane.centerline.length();
        (fits && inside && lane.junction.is_none()).then_some(t.abs())
    };
    history.network.lanes.iter().filter_map(beside).min_by(f64::total_cmp)
}
