//! Automatic incident detection: finds incidents in poses, signals and the map alone. It knows nothing of what was staged,
//! and measures in other ways than the simulation does: labels are checked against it.

mod abreast;
mod collision;
mod fallen_rider;
mod jaywalk;
mod near_miss;
mod queue_spillback;
mod red_light_run;
mod standing;
mod wrong_way;

use endless_road::RoadNetwork;
use endless_road::swept::OrientedRectangle;
use endless_world::{Actor, IncidentKind, InstanceId, VehicleSpec, WorldState};
use glam::DVec2;

/// An incident that was found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DetectedIncident {
    /// Its kind.
    pub kind: IncidentKind,
    /// Who takes part, the one who causes it first.
    pub actors: Vec<InstanceId>,
    /// The first frame in which it happens.
    pub begin_frame: u32,
    /// The last one.
    pub end_frame: u32,
}

/// Watches world states that follow one another from frame 0 on, and finds incidents in them.
#[derive(Debug)]
pub struct IncidentDetector<'a> {
    network: &'a RoadNetwork,
    specs: &'a [VehicleSpec],
    fps: f64,
    states: Vec<WorldState>,
}

impl<'a> IncidentDetector<'a> {
    /// Of vehicles of these models on a network; `fps`: frames a second.
    pub fn new(network: &'a RoadNetwork, specs: &'a [VehicleSpec], fps: f64) -> Self {
        Self { network, specs, fps, states: Vec::new() }
    }

    /// Looks at the next frame.
    pub fn look(&mut self, state: WorldState) {
        self.states.push(state);
    }

    /// The incidents of a kind, in the order of their causers' ids.
    pub fn detect(&self, kind: IncidentKind) -> Vec<DetectedIncident> {
        match kind {
            IncidentKind::Collision => collision::detect(self),
            IncidentKind::NearMiss => near_miss::detect(self),
            IncidentKind::WrongWay => wrong_way::detect(self),
            IncidentKind::Jaywalk => jaywalk::detect(self),
            IncidentKind::FallenRider => fallen_rider::detect(self),
            IncidentKind::QueueSpillback => queue_spillback::detect(self),
            IncidentKind::RedLightRun => red_light_run::detect(self),
            IncidentKind::Stalled => standing::detect(self, IncidentKind::Stalled),
            IncidentKind::IllegalParking => standing::detect(self, IncidentKind::IllegalParking),
        }
    }

    /// Everybody in a vehicle, by ascending id.
    fn vehicles(&self) -> Vec<InstanceId> {
        let driven = |actor: &&Actor| actor.asset.vehicle().is_some();
        let ids = self.states.iter().flat_map(|state| state.actors.iter().filter(driven).map(|actor| actor.id));
        let mut ids: Vec<InstanceId> = ids.collect();
        ids.sort_unstable();
        ids.dedup();
        ids
    }

    /// Somebody in a frame.
    fn actor(&self, frame: usize, id: InstanceId) -> Option<&Actor> {
        let actors = &self.states.get(frame)?.actors;
        actors.binary_search_by_key(&id, |actor| actor.id).ok().map(|place| &actors[place])
    }

    /// The ground under somebody: people are squares of half a metre.
    fn body(&self, actor: &Actor) -> OrientedRectangle {
        let (at, yaw) = (actor.pose.position.as_dvec3().truncate(), f64::from(actor.pose.yaw_rad));
        match actor.asset.vehicle() {
            Some(vehicle) => OrientedRectangle::new(&self.specs[vehicle.model.index()], at, yaw, 0.0),
            None => OrientedRectangle::of(DVec2::splat(0.25), at, yaw),
        }
    }

    /// The ground under a vehicle in a frame.
    fn body_at(&self, frame: usize, id: InstanceId) -> Option<OrientedRectangle> {
        self.actor(frame, id).map(|actor| self.body(actor))
    }
}

/// Runs of frames that are told of, with gaps of at most so many frames between.
fn runs(frames: impl IntoIterator<Item = usize>, gap: usize) -> Vec<(usize, usize)> {
    let mut found: Vec<(usize, usize)> = Vec::new();
    for frame in frames {
        match found.last_mut() {
            Some((_, last)) if frame - *last <= gap + 1 => *last = frame,
            _ => found.push((frame, frame)),
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::runs;

    #[test]
    fn frames_near_one_another_are_one_run() {
        assert_eq!(runs([2, 3, 4, 7, 8, 20], 2), [(2, 8), (20, 20)]);
        assert_eq!(runs([2, 3, 4, 7, 8, 20], 0), [(2, 4), (7, 8), (20, 20)]);
    }
}
