//! Events that were staged: each is of a kind that was asked for, lies within the recording, and its actors are known.

use super::report::Finding;
use crate::{SceneRecord, VideoLayout, read_actors};
use endless_world::{Incident, InstanceId};
use std::collections::BTreeSet;

/// Checks what `scene.json` says of them.
pub(super) fn check_incidents(video: &VideoLayout, record: &SceneRecord) -> Vec<Finding> {
    let mut told: Vec<_> = record.incidents.iter().map(|incident| incident.kind).collect();
    told.extend(&record.missed_events);
    let mut asked = record.settings.events.clone();
    told.sort();
    asked.sort();
    let mut problems = Vec::new();
    if told != asked {
        problems.push("does not tell of each event that the settings ask for, or of others".to_owned());
    }
    let known: Option<BTreeSet<InstanceId>> = record
        .actors
        .and_then(|_| read_actors(&video.actors()).ok())
        .map(|actors| actors.iter().map(|actor| actor.id).collect());
    for incident in &record.incidents {
        problems.extend(problem(incident, record.recorded_frames, known.as_ref()));
    }
    problems.into_iter().map(|problem| Finding::new(video.scene(), problem)).collect()
}

fn problem(incident: &Incident, frames: u32, known: Option<&BTreeSet<InstanceId>>) -> Option<String> {
    let Incident { kind, actors, begin_frame, end_frame, .. } = incident;
    if begin_frame > end_frame || *end_frame >= frames {
        return Some(format!("tells of a {kind} from frame {begin_frame} to {end_frame} in {frames} frames"));
    }
    let unknown = actors.iter().find(|id| known.is_some_and(|known| !known.contains(id)));
    match unknown {
        Some(id) => Some(format!("tells of a {kind} of object {id}, which actors.json does not know")),
        None if actors.is_empty() => Some(format!("tells of a {kind} of nobody")),
        None => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::IncidentKind;

    #[test]
    fn frames_and_actors_must_be_those_of_the_video() {
        let incident = Incident {
            kind: IncidentKind::Stalled,
            actors: vec![InstanceId(7)],
            begin_frame: 10,
            end_frame: 49,
            position: [0.0; 3],
            time_to_collision_s: None,
            post_encroachment_s: None,
        };
        let known = BTreeSet::from([InstanceId(7)]);
        assert_eq!(problem(&incident, 50, Some(&known)), None);
        assert!(problem(&incident, 49, Some(&known)).is_some_and(|p| p.contains("frame 10 to 49")));
        let stranger = Incident { actors: vec![InstanceId(8)], ..incident.clone() };
        assert!(problem(&stranger, 50, Some(&known)).is_some_and(|p| p.contains("object 8")));
        assert!(problem(&Incident { actors: Vec::new(), ..incident }, 50, None).is_some());
    }
}
