//! Automatic incident detection: finds incidents in poses, signals and the map alone. It knows nothing of what was staged,
//! and measures in other ways than the simulation does: labels are checked against it.

mod abreast;
mod collision;
mod detected;
mod fallen_rider;
mod history;
mod jaywalk;
mod near_miss;
mod queue_spillback;
mod red_light_run;
mod standing;
mod wrong_way;

pub use detected::DetectedIncident;

use endless_road::RoadNetwork;
use endless_world::{IncidentKind, VehicleSpec, WorldState};
use history::StateHistory;

/// Watches world states that follow one another from frame 0 on, and finds incidents in them.
#[derive(Debug)]
pub struct IncidentDetector<'a>(StateHistory<'a>);

impl<'a> IncidentDetector<'a> {
    /// Of vehicles of these models on a network; `fps`: frames a second.
    pub fn new(network: &'a RoadNetwork, specs: &'a [VehicleSpec], fps: f64) -> Self {
        Self(StateHistory { network, specs, fps, states: Vec::new() })
    }

    /// Looks at the next frame.
    pub fn look(&mut self, state: WorldState) {
        self.0.states.push(state);
    }

    /// The incidents of a kind, in the order of their causers' ids.
    pub fn detect(&self, kind: IncidentKind) -> Vec<DetectedIncident> {
        match kind {
            IncidentKind::Collision => collision::detect(&self.0),
            IncidentKind::NearMiss => near_miss::detect(&self.0),
            IncidentKind::WrongWay => wrong_way::detect(&self.0),
            IncidentKind::Jaywalk => jaywalk::detect(&self.0),
            IncidentKind::FallenRider => fallen_rider::detect(&self.0),
            IncidentKind::QueueSpillback => queue_spillback::detect(&self.0),
            IncidentKind::RedLightRun => red_light_run::detect(&self.0),
            IncidentKind::Stalled => standing::detect(&self.0, IncidentKind::Stalled),
            IncidentKind::IllegalParking => standing::detect(&self.0, IncidentKind::IllegalParking),
        }
    }
}
