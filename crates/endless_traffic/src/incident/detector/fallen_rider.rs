//! Who leans further than any rider does, and lies.

use super::detected::{DetectedIncident, runs};
use super::history::StateHistory;
use endless_world::{Actor, IncidentKind};

/// No rider leans so far, radians.
const LIES: f32 = 0.7;

pub(super) fn detect(history: &StateHistory<'_>) -> Vec<DetectedIncident> {
    let mut found = Vec::new();
    for id in history.vehicles() {
        let lies = |actor: &Actor| actor.class.two_wheeled() && actor.pose.roll_rad.abs() > LIES;
        let frames = (0..history.states.len()).filter(|&frame| history.actor(frame, id).is_some_and(lies));
        found.extend(runs(frames, 0).into_iter().map(|(begin, end)| DetectedIncident {
            kind: IncidentKind::FallenRider,
            actors: vec![id],
            begin_frame: begin as u32,
            end_frame: end as u32,
        }));
    }
    found
}
