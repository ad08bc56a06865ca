//! `actors.json` speaks of every object that the cameras see, and of each once.

use super::{report::Finding, tracks::Tracks};
use crate::{SceneRecord, VideoLayout, read_actors};
use endless_annotate::ActorRecord;
use endless_world::{InstanceId, ObjectClass};
use std::collections::BTreeMap;

/// Compares a video's actors with what its cameras saw.
pub(super) fn check_actors(video: &VideoLayout, record: &SceneRecord, tracks: &[&Tracks]) -> Vec<Finding> {
    let Some(count) = record.actors else { return Vec::new() };
    let path = video.actors();
    let actors = match read_actors(&path) {
        Ok(actors) => actors,
        Err(error) => return vec![error.into()],
    };
    let mut problems = Vec::new();
    if actors.len() != count as usize {
        problems.push(format!("has {} entries, scene.json says {count}", actors.len()));
    }
    if !actors.is_sorted_by(|a, b| a.id < b.id) {
        problems.push("is not sorted by id".to_owned());
    }
    let by_id: BTreeMap<InstanceId, &ActorRecord> = actors.iter().map(|actor| (actor.id, actor)).collect();
    for (id, class) in tracks.iter().flat_map(|t| t.seen()) {
        match by_id.get(&id) {
            None => problems.push(format!("lacks object {id}, a {class}")),
            Some(actor) if actor.class != class => {
                problems.push(format!("says that object {id} is a {}, not a {class}", actor.class));
            }
            Some(_) => {}
        }
    }
    problems.extend(actors.iter().filter_map(|actor| inconsistency(actor, &by_id)));
    problems.sort();
    problems.dedup();
    problems.into_iter().map(|problem| Finding::new(&path, problem)).collect()
}

/// Riders and two-wheelers name each other; people are described as people, vehicles as vehicles.
fn inconsistency(actor: &ActorRecord, by_id: &BTreeMap<InstanceId, &ActorRecord>) -> Option<String> {
    let id = actor.id;
    let ridden = actor.vehicle_id.is_none_or(|v| by_id.get(&v).is_some_and(|other| other.rider_id == Some(id)));
    let rides = actor.rider_id.is_none_or(|r| by_id.get(&r).is_some_and(|other| other.vehicle_id == Some(id)));
    let human = matches!(actor.class, ObjectClass::Pedestrian | ObjectClass::Rider);
    if !ridden || !rides || (actor.vehicle_id.is_some() && actor.class != ObjectClass::Rider) {
        Some(format!("object {id}: rider and vehicle do not name each other"))
    } else if if human { actor.vehicle.is_some() } else { actor.person.is_some() } {
        Some(format!("object {id}, a {}, is described as something else", actor.class))
    } else if actor.occupants.is_some_and(|of| actor.parked && (of.driver || of.passengers > 0)) {
        Some(format!("object {id} is parked and somebody sits in it"))
    } else if human && actor.occupants.is_some() {
        Some(format!("object {id}, a {}, has a cabin", actor.class))
    } else {
        None
    }
}
