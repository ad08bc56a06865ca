//! Who is on foot on a lane outside of junctions and crossings.

use super::detected::{DetectedIncident, runs};
use super::history::StateHistory;
use endless_road::Lane;
use endless_world::math::segment::share_along;
use endless_world::{Actor, IncidentKind, InstanceId};
use glam::DVec3;

/// Two lanes with a gap between are one road, seconds.
const PAUSE_S: f64 = 1.0;
/// Crossings reach so far beyond their edge, metres.
const BESIDE_M: f64 = 2.0;
/// Who is further above or below is on another level, metres.
const STOREY_M: f64 = 2.0;
/// Who only brushes the kerb is not on the road, seconds.
const LEAST_S: f64 = 1.0;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let on_foot = |actor: &&Actor| actor.asset.vehicle().is_none();
    let ids = history.states.iter().flat_map(|state| state.actors.iter().filter(on_foot).map(|actor| actor.id));
    let mut ids: Vec<InstanceId> = ids.collect();
    ids.sort_unstable();
    ids.dedup();
    let mut found = Vec::new();
    for id in ids {
        let on_road = |&frame: &usize| history.actor(frame, id).is_some_and(|actor| is_on_road(history, actor));
        let frames = (0..history.states.len()).filter(on_road);
        let long = |(begin, end): &(usize, usize)| (end - begin) as f64 >= LEAST_S * history.fps;
        let pause = (PAUSE_S * history.fps) as usize;
        found.extend(runs(frames, pause).into_iter().filter(long).map(|(begin, end)| DetectedIncident {
            kind: IncidentKind::Jaywalk,
            actors: vec![id],
            begin_frame: begin as u32,
            end_frame: end as u32,
        }));
    }
    found
}

fn is_on_road(history: &StateHistory<'_>, actor: &Actor) -> bool {
    let at = actor.pose.position.as_dvec3();
    let on = |lane: &Lane| {
        let (s, t) = lane.centerline.project(at.truncate());
        let inside = s > 0.0 && s < lane.centerline.length() && t.abs() < 0.5 * lane.width_m;
        lane.junction.is_none() && inside && (lane.centerline.position(s).z - at.z).abs() < STOREY_M
    };
    let crosses = || {
        history.network.crossings.iter().any(|crossing| {
            let [a, b] = crossing.ends.map(DVec3::truncate);
            let u = share_along(at.truncate(), a, b);
            at.truncate().distance(a.lerp(b, u)) < 0.5 * crossing.width_m + BESIDE_M
        })
    };
    history.network.lanes.iter().any(on) && !crosses()
}
