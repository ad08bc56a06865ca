//! What all formats tell of one road user at one instant.

use endless_road::opendrive::{LaneName, lane_names};
use endless_road::{LaneId, RoadNetwork};
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, InstanceId, Motion, ObjectClass, VehicleSpec, WorldState};
use glam::DVec2;

/// A person's length and breadth, metres.
const PERSON_M: f64 = 0.5;
/// Height of a person, metres.
const TALL_M: f64 = 1.75;

/// One road user at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrajectoryRow<'a> {
    /// Seconds since frame 0.
    pub time_s: f64,
    /// The same at all instants.
    pub id: InstanceId,
    /// Its class.
    pub class: ObjectClass,
    /// Name of the vehicle's design; of people, the class.
    pub model: &'a str,
    /// The centre, on the ground, metres in the world frame: x east, y north, z up.
    pub position: [f64; 3],
    /// Heading, radians counter-clockwise from east.
    pub yaw_rad: f64,
    /// Forward speed, m/s.
    pub speed_mps: f64,
    /// Change of the speed, m/s²; of people, `None`.
    pub acceleration_mps2: Option<f64>,
    /// Slope of the ground along the heading, nose up is positive, radians.
    pub pitch_rad: f64,
    /// Length, width and height, metres; trailer included, of people the same for all.
    pub size_m: [f64; 3],
    /// Of a vehicle: the lane that its centre is on.
    pub lane: Option<TrajectoryLane>,
    /// Of somebody on foot: the crossing underfoot, by its index in the road network.
    pub crossing: Option<u16>,
}

/// A place on a lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrajectoryLane {
    /// Index in the road network.
    pub lane: u32,
    /// The lane in the OpenDRIVE file of the map (`endless maps export`).
    pub name: LaneName,
    /// From the lane's beginning along its middle, metres.
    pub s_m: f64,
    /// To the left of its middle, metres.
    pub left_m: f64,
}

/// What is known of a map's lanes and models: makes rows of world states.
#[derive(Debug)]
pub struct TrajectoryScene<'a> {
    network: &'a RoadNetwork,
    specs: &'a [VehicleSpec],
    lane_names: Vec<LaneName>,
}

impl<'a> TrajectoryScene<'a> {
    /// Of vehicles of these models on this network; `left_hand` as its map has it.
    pub fn new(network: &'a RoadNetwork, specs: &'a [VehicleSpec], left_hand: bool) -> Self {
        Self { network, specs, lane_names: lane_names(network, left_hand) }
    }

    /// The rows of an instant, by ascending id.
    ///
    /// # Panics
    /// If a vehicle's model is not among those of the scene.
    pub fn rows(&self, state: &WorldState) -> Vec<TrajectoryRow<'a>> {
        state.actors.iter().map(|actor| self.row(actor, state.time_s)).collect()
    }

    fn row(&self, actor: &Actor, time_s: f64) -> TrajectoryRow<'a> {
        let spec = actor.asset.vehicle().map(|vehicle| &self.specs[vehicle.model.index()]);
        let person = [PERSON_M, PERSON_M, TALL_M];
        let size_m = spec.map_or(person, |spec| [spec.length_m, spec.width_m, spec.height_m].map(f64::from));
        let (speed_mps, acceleration_mps2) = match actor.motion {
            Motion::Vehicle(motion) => (motion.speed_mps, Some(f64::from(actor.behaviour.acceleration_mps2))),
            Motion::Walker(motion) => (motion.speed_mps, None),
        };
        TrajectoryRow {
            time_s,
            id: actor.id,
            class: actor.class,
            model: spec.map_or(actor.class.into(), |spec| spec.name),
            position: actor.pose.position.as_dvec3().to_array(),
            yaw_rad: f64::from(actor.pose.yaw_rad),
            speed_mps: f64::from(speed_mps),
            acceleration_mps2,
            pitch_rad: f64::from(actor.pose.pitch_rad),
            size_m,
            lane: self.lane(actor),
            crossing: actor.behaviour.crossing,
        }
    }

    fn lane(&self, actor: &Actor) -> Option<TrajectoryLane> {
        let place = actor.behaviour.lane?;
        let s_m = f64::from(place.s_m);
        let on = self.network.lane(LaneId(place.lane)).centerline.at(s_m);
        let (sin, cos) = sin_cos(on.heading_rad);
        let beside = actor.pose.position.as_dvec3().truncate() - on.position.truncate();
        let left_m = beside.dot(DVec2::new(-sin, cos));
        Some(TrajectoryLane { lane: place.lane, name: self.lane_names[place.lane as usize], s_m, left_m })
    }
}
