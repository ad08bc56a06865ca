//! Who leans further than any rider does, and lies.

use super::{DetectedIncident, IncidentDetector, runs};
use endless_world::{Actor, IncidentKind};

/// No rider leans so far, radians.
const LIES: f32 = 0.7;

pub(super) fn detect(detector: &IncidentDetector<'_>) -> Vec<DetectedIncident> {
    let mut found = Vec::new();
    for id in detector.vehicles() {
        let lies = |actor: &Actor| actor.class.two_wheeled() && actor.pose.roll_rad.abs() > LIES;
        let frames = (0..detector.states.len()).filter(|&frame| detector.actor(frame, id).is_some_and(lies));
        found.extend(runs(frames, 0).into_iter().map(|(begin, end)| DetectedIncident {
            kind: IncidentKind::FallenRider,
            actors: vec![id],
            begin_frame: begin as u32,
            end_frame: end as u32,
        }));
    }
    found
}
