//! Looks at a copy of the simulation in which incidents are tried out: whether somebody touches somebody, whether it
//! happens in sight, and how near everybody came to one another.

use super::StagedIncident;
use super::conflict::MovingBody;
use crate::audit::body::Body;
use crate::focus::Focus;
use crate::roads::RoadTables;
use endless_road::swept::OrientedRectangle;
use endless_road::{Lane, RoadNetwork};
use endless_world::{Actor, Incident, InstanceId, Motion, VehicleSpec, WorldState};
use glam::{DVec2, DVec3, Vec3};
use std::collections::BTreeMap;

/// Whom incidents may concern is within this of those who have a role, metres.
const NEAR_M: f64 = 60.0;
/// People are discs of this radius, metres.
const PERSON_M: f64 = 0.25;
/// Height of a person, metres.
const TALL_M: f64 = 1.8;
/// An incident that lasts to the end is to be seen for so long, seconds.
const LASTS_S: f64 = 3.0;
/// In no more than this share of it others hold who stands.
const MOST_HELD: f64 = 0.3;
/// Another is over in less, seconds.
const ENDS_S: f64 = 12.0;
/// It is to be in sight when it begins, and for this share of the seconds that follow.
const IN_SIGHT: f64 = 0.5;
const IN_SIGHT_S: f64 = 5.0;
/// Conflicts are measured from so long before it to so long after it, seconds.
const AROUND_S: f64 = 1.0;
/// Longer times to collision and post-encroachment times are no conflicts, seconds.
const MOST_TTC_S: f64 = 10.0;
const MOST_PET_S: f64 = 5.0;
/// Ways that differ by a smaller angle follow one another: its cosine.
const SAME_WAY: f64 = 0.94;

/// Somebody near those who have a role.
struct Glimpse {
    id: InstanceId,
    moving: MovingBody,
    pieces: Vec<Body>,
    on_foot: bool,
    at_m: DVec3,
}

impl Glimpse {
    /// Whether somebody on foot touches a body.
    fn stands_in(&self, body: &Body) -> bool {
        let z = self.at_m.z;
        body.touches_disc(self.moving.body.center, PERSON_M, z, z + TALL_M)
    }
}

/// One frame of a rehearsal.
struct Take {
    near: Vec<Glimpse>,
    /// Whether the one who causes each incident is where it is seen.
    seen: Vec<bool>,
}

/// What was seen of a rehearsal from its first frame on.
pub(crate) struct Rehearsal<'a> {
    network: &'a RoadNetwork,
    specs: &'a [VehicleSpec],
    sight: &'a Focus,
    parked: Vec<Body>,
    fps: f64,
    first_frame: u32,
    takes: Vec<Take>,
}

impl<'a> Rehearsal<'a> {
    pub(crate) fn new(roads: &'a RoadTables, sight: &'a Focus, parked: &[Actor], fps: f64, first_frame: u32) -> Self {
        let RoadTables { network, specs, .. } = roads;
        let parked = parked.iter().flat_map(|actor| pieces(actor, specs)).collect();
        Self { network, specs, sight, parked, fps, first_frame, takes: Vec::new() }
    }

    /// Looks at the next frame; `false` if somebody touches somebody who should not.
    pub(crate) fn look(&mut self, state: &WorldState, staged: &[StagedIncident]) -> bool {
        let find = |id: InstanceId| state.actors.iter().find(|actor| actor.id == id);
        let cast: Vec<DVec2> = staged
            .iter()
            .flat_map(StagedIncident::actors)
            .filter_map(find)
            .map(|actor| actor.pose.position.as_dvec3().truncate())
            .collect();
        let near = |actor: &&Actor| {
            let at = actor.pose.position.as_dvec3().truncate();
            cast.iter().any(|other| other.distance_squared(at) < NEAR_M * NEAR_M)
        };
        let near: Vec<Glimpse> = state.actors.iter().filter(near).map(|actor| glimpse(actor, self.specs)).collect();
        let touched = self.somebody_touches(&near, staged);
        let sees = |actor: &Actor| {
            let at = actor.pose.position;
            let clear = match actor.behaviour.lane {
                Some(place) => self.sight.on_lane(place.lane as usize, f64::from(place.s_m)) != 0,
                None => self.sees_road_at(at.as_dvec3()),
            };
            clear && self.sight.shows(at + Vec3::Z, actor.asset.vehicle().is_none())
        };
        let everywhere = self.sight.views().is_empty();
        let seen = staged
            .iter()
            .map(|incident| everywhere || incident.actors().first().is_some_and(|&id| find(id).is_some_and(sees)))
            .collect();
        self.takes.push(Take { near, seen });
        !touched
    }

    /// Whether the lane is seen on which somebody is on foot.
    fn sees_road_at(&self, at: DVec3) -> bool {
        let near = |lane: &Lane| {
            let (s, t) = lane.centerline.project(at.truncate());
            let on = t.abs() < lane.width_m && (lane.centerline.position(s).z - at.z).abs() < TALL_M;
            on && self.sight.on_lane(lane.id.index(), s) != 0
        };
        self.network.lanes.iter().any(near)
    }

    /// Whether the one who causes an incident is in sight in the frame that was looked at last.
    pub(crate) fn sees_now(&self, number: usize) -> bool {
        self.takes.last().is_some_and(|take| take.seen[number])
    }

    fn somebody_touches(&self, near: &[Glimpse], staged: &[StagedIncident]) -> bool {
        let should = |pair: [InstanceId; 2]| staged.iter().any(|incident| incident.collides(pair));
        near.iter().enumerate().any(|(i, one)| {
            let parked = one.pieces.iter().any(|body| self.parked.iter().any(|other| body.touches(other)));
            let parked = parked || one.on_foot && self.parked.iter().any(|body| one.stands_in(body));
            parked || near[i + 1..].iter().any(|other| touch(one, other) && !should([one.id, other.id]))
        })
    }

    /// What is told of an incident; `None` if it did not happen as it should, in a recording of so many frames.
    pub(crate) fn incident(&self, number: usize, staged: &StagedIncident, frames: u32) -> Option<Incident> {
        let (begin, end) = staged.label.begin_frame.zip(staged.label.end_frame)?;
        let last = frames.saturating_sub(1);
        let in_time = if staged.lasts() {
            let frames = end + 1 - begin;
            end == last && f64::from(frames) > LASTS_S * self.fps && frames - staged.label.frames <= frames / 20
        } else {
            let lasts_s = f64::from(end + 1 - begin) / self.fps;
            end < last && (staged.least_s()..ENDS_S).contains(&lasts_s)
        };
        let take = |frame: u32| self.takes.get(frame.checked_sub(self.first_frame)? as usize);
        let span = begin..=end.min(begin + (IN_SIGHT_S * self.fps) as u32);
        let seen = |frame: u32| take(frame).is_some_and(|take| take.seen[number]);
        let share = span.clone().filter(|&frame| seen(frame)).count() as f64 / span.count() as f64;
        let held = f64::from(staged.label.held) > MOST_HELD * f64::from(end + 1 - begin);
        if held || !in_time || !seen(begin) || share < IN_SIGHT {
            return None;
        }
        let actors = staged.actors();
        let cause = take(begin)?.near.iter().find(|glimpse| glimpse.id == actors[0])?;
        let position = cause.at_m.as_vec3().to_array();
        let around = (AROUND_S * self.fps).round() as u32;
        let span = begin.saturating_sub(around).max(self.first_frame)..=(end + around).min(last);
        let [collision_s, encroachment_s] = self.conflicts(&actors, span);
        Some(Incident {
            kind: staged.kind,
            actors,
            begin_frame: begin,
            end_frame: end,
            position,
            time_to_collision_s: collision_s,
            post_encroachment_s: encroachment_s,
        })
    }

    /// The least time to collision and post-encroachment time of these actors in some frames.
    fn conflicts(&self, actors: &[InstanceId], span: std::ops::RangeInclusive<u32>) -> [Option<f64>; 2] {
        let mut least = [MOST_TTC_S, MOST_PET_S];
        let back = (MOST_PET_S * self.fps) as usize;
        // When each pair's ground was last the other's: looked up in the frames before.
        let mut trails: BTreeMap<InstanceId, Vec<(usize, MovingBody)>> = BTreeMap::new();
        let (first, last) = ((*span.start() - self.first_frame) as usize, (*span.end() - self.first_frame) as usize);
        for (k, take) in self.takes.iter().enumerate().take(last + 1) {
            if k >= first {
                for (i, one) in take.near.iter().enumerate() {
                    for other in &take.near[i + 1..] {
                        let one_acts = actors.contains(&one.id);
                        if !one_acts && !actors.contains(&other.id) || one.on_foot && other.on_foot {
                            continue;
                        }
                        let time_s = one.moving.time_to_collision_s(&other.moving);
                        // The rectangles around a body and its trailer may overlap in a bend.
                        if let Some(time) = time_s.filter(|time| *time > 0.0) {
                            least[0] = least[0].min(time);
                        }
                        for (before, after) in [(one, other), (other, one)] {
                            let trail = trails.get(&before.id).map_or(&[][..], Vec::as_slice);
                            if let Some(then) = left_at(trail, before, after) {
                                least[1] = least[1].min((k - then) as f64 / self.fps);
                            }
                        }
                    }
                }
            }
            for glimpse in &take.near {
                let trail = trails.entry(glimpse.id).or_default();
                trail.push((k, glimpse.moving));
                if trail.len() > back {
                    trail.remove(0);
                }
            }
        }
        let told = |value: f64, most: f64| (value < most).then_some((value * 1000.0).round() / 1000.0);
        [told(least[0], MOST_TTC_S), told(least[1], MOST_PET_S)]
    }
}

/// When somebody was last on the ground on which another is now, if their ways cross.
fn left_at(trail: &[(usize, MovingBody)], before: &Glimpse, after: &Glimpse) -> Option<usize> {
    if before.moving.body.overlaps(&after.moving.body) {
        return None;
    }
    let (then, earlier) = trail.iter().rev().find(|(_, earlier)| earlier.body.overlaps(&after.moving.body))?;
    (earlier.body.axis.dot(after.moving.body.axis) < SAME_WAY).then_some(*then)
}

fn pieces(actor: &Actor, specs: &[VehicleSpec]) -> Vec<Body> {
    let spec = actor.asset.vehicle().map(|vehicle| &specs[vehicle.model.index()]);
    spec.into_iter().flat_map(|spec| Body::pieces(actor, spec)).collect()
}

fn glimpse(actor: &Actor, specs: &[VehicleSpec]) -> Glimpse {
    let at = actor.pose.position.as_dvec3().truncate();
    let yaw = f64::from(actor.pose.yaw_rad);
    let body = match actor.asset.vehicle() {
        Some(vehicle) => OrientedRectangle::new(&specs[vehicle.model.index()], at, yaw, 0.0),
        None => OrientedRectangle::of(DVec2::splat(PERSON_M), at, yaw),
    };
    Glimpse {
        id: actor.id,
        moving: MovingBody { body, velocity: actor.velocity_mps.as_dvec3().truncate() },
        pieces: pieces(actor, specs),
        on_foot: matches!(actor.motion, Motion::Walker(_)),
        at_m: actor.pose.position.as_dvec3(),
    }
}

/// Whether two bodies touch; people among themselves do not count.
fn touch(one: &Glimpse, other: &Glimpse) -> bool {
    let disc = |vehicle: &Glimpse, person: &Glimpse| vehicle.pieces.iter().any(|body| person.stands_in(body));
    match (one.on_foot, other.on_foot) {
        (false, false) => one.pieces.iter().any(|body| other.pieces.iter().any(|against| body.touches(against))),
        (false, true) => disc(one, other),
        (true, false) => disc(other, one),
        (true, true) => false,
    }
}
