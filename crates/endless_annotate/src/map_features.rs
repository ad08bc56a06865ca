//! What a map has on and beside its roads, in the world: what `map.json` tells of it for each camera.

use endless_world::{PinholeCamera, SignalId};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Lanes, paint, areas, signals and signs of a whole map.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MapFeatures {
    /// Lanes for driving, connectors in junctions included.
    pub lanes: Vec<LaneFeature>,
    /// Painted lines along roads.
    pub marks: Vec<MarkFeature>,
    /// Lines to stop or to give way at.
    pub stop_lines: Vec<StopLineFeature>,
    /// Crossings for people.
    pub crosswalks: Vec<CrosswalkFeature>,
    /// Pieces of sidewalks.
    pub sidewalks: Vec<SidewalkFeature>,
    /// Heads of traffic lights.
    pub signals: Vec<SignalFeature>,
    /// Traffic signs.
    pub signs: Vec<SignFeature>,
}

/// What governs the end of a lane.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LaneControl {
    /// Nothing.
    Free,
    /// A traffic light.
    Signal,
    /// A stop sign.
    Stop,
    /// A give-way sign.
    Yield,
}

/// The words of a lane.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LaneAttributes {
    /// Unique in the map, the same for all cameras.
    pub id: u32,
    /// The OpenDRIVE id of its road.
    pub road: u32,
    /// Its OpenDRIVE id on the road.
    pub road_lane: i32,
    /// What it is for, in OpenDRIVE's words: `driving`.
    #[serde(rename = "type")]
    pub kind: String,
    /// The junction it lies in.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub junction: Option<u16>,
    /// `straight`, `left`, `right` or `u_turn`, seen by who drives.
    pub turn: String,
    /// Metres.
    pub width_m: f64,
    /// Metres a second.
    pub speed_limit_mps: f64,
    /// What governs its end.
    pub control: LaneControl,
    /// The signal group at its end.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub signal: Option<SignalId>,
    /// Lanes that end where it begins.
    pub predecessors: Vec<u32>,
    /// Lanes that begin where it ends.
    pub successors: Vec<u32>,
    /// The lane to its left with the same direction of travel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_lane: Option<u32>,
    /// The lane to its right with the same direction of travel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub right_lane: Option<u32>,
}

/// A lane for driving; its lines run in the direction of travel.
#[derive(Debug, Clone, PartialEq)]
pub struct LaneFeature {
    /// Its words.
    pub attributes: LaneAttributes,
    /// Centre line.
    pub center: Vec<DVec3>,
    /// Left boundary.
    pub left: Vec<DVec3>,
    /// Right boundary.
    pub right: Vec<DVec3>,
}

/// Colour of paint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PaintColor {
    /// White.
    White,
    /// Yellow.
    Yellow,
}

/// The words of a painted line.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MarkAttributes {
    /// Unique in the map.
    pub id: u32,
    /// Whether it has gaps.
    pub broken: bool,
    /// Colour.
    pub color: PaintColor,
    /// Metres.
    pub width_m: f64,
}

/// A painted line along a road.
#[derive(Debug, Clone, PartialEq)]
pub struct MarkFeature {
    /// Its words.
    pub attributes: MarkAttributes,
    /// The middle of the paint: a line for each unbroken piece.
    pub pieces: Vec<Vec<DVec3>>,
}

/// The words of a line to stop at.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct StopLineAttributes {
    /// Unique in the map.
    pub id: u32,
    /// Whether it is broken: the line of a give-way sign.
    pub broken: bool,
    /// Metres along the road.
    pub width_m: f64,
    /// The lanes that end there.
    pub lanes: Vec<u32>,
}

/// A line across lanes, where vehicles stop or give way.
#[derive(Debug, Clone, PartialEq)]
pub struct StopLineFeature {
    /// Its words.
    pub attributes: StopLineAttributes,
    /// The middle of the paint.
    pub pieces: Vec<Vec<DVec3>>,
}

/// The words of a crossing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CrosswalkAttributes {
    /// Unique in the map.
    pub id: u32,
    /// The signal group of those who walk; without one, drivers give way.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub signal: Option<SignalId>,
    /// The lanes that it crosses.
    pub lanes: Vec<u32>,
}

/// A crossing for people.
#[derive(Debug, Clone, PartialEq)]
pub struct CrosswalkFeature {
    /// Its words.
    pub attributes: CrosswalkAttributes,
    /// The outline of its bars.
    pub outline: Vec<DVec3>,
}

/// A piece of a sidewalk.
#[derive(Debug, Clone, PartialEq)]
pub struct SidewalkFeature {
    /// Of the strip that it is a piece of; unique in the map.
    pub id: u32,
    /// Its outline.
    pub outline: Vec<DVec3>,
}

/// Whom a head of a traffic light is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum SignalKind {
    /// Those who drive.
    Vehicle,
    /// Those who walk.
    Pedestrian,
    /// Those who cycle.
    Bicycle,
}

/// Colour of a lens.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LensColor {
    /// Red.
    Red,
    /// Yellow.
    Yellow,
    /// Green.
    Green,
}

/// A lens of a signal head.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignalLens {
    /// Its colour.
    pub color: LensColor,
    /// Its middle.
    pub center: DVec3,
    /// Metres.
    pub radius_m: f64,
}

/// The words of a signal head.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SignalAttributes {
    /// Unique in the map.
    pub id: u32,
    /// The group whose aspect it shows: see `signals` in `frames.jsonl`.
    pub group: SignalId,
    /// Whom it is for.
    pub kind: SignalKind,
    /// The lanes whose ends the group governs.
    pub lanes: Vec<u32>,
    /// The crossings that the group governs.
    pub crosswalks: Vec<u32>,
}

/// A head of a traffic light: the housing with its lenses.
#[derive(Debug, Clone, PartialEq)]
pub struct SignalFeature {
    /// Its words.
    pub attributes: SignalAttributes,
    /// Its housing.
    pub body: FeatureBody,
    /// Its lenses.
    pub lenses: Vec<SignalLens>,
}

/// The words of a traffic sign.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SignAttributes {
    /// Unique in the map.
    pub id: u32,
    /// Its code in its convention.
    pub code: String,
    /// Whose code that is: `vienna` (Convention on Road Signs, 1968) or `mutcd`.
    pub convention: String,
    /// The number that it shows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<u32>,
    /// The unit of that number: `km/h` or `mph`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unit: Option<String>,
    /// The words that it shows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
}

/// A traffic sign.
#[derive(Debug, Clone, PartialEq)]
pub struct SignFeature {
    /// Its words.
    pub attributes: SignAttributes,
    /// Its plate.
    pub body: FeatureBody,
}

/// A flat thing that is to be seen from the front.
#[derive(Debug, Clone, PartialEq)]
pub struct FeatureBody {
    /// The corners of its box.
    pub corners: [DVec3; 8],
    /// The middle of its front.
    pub center: DVec3,
    /// Where it looks; a unit vector.
    pub facing: DVec3,
}

/// Steps along the optical axis, metres, and how many.
const STEP_M: f64 = 0.5;
const STEPS: u32 = 320;
/// The ground is looked for at places of the map this near, metres.
const NEAR_M: f64 = 12.0;

impl MapFeatures {
    /// Height of the ground where a camera's optical axis meets it, by the lanes and sidewalks around; where it does not, of
    /// the one nearest to the camera. `None` for an empty map.
    pub fn ground_z(&self, camera: &PinholeCamera) -> Option<f64> {
        let eye = camera.position.as_dvec3();
        let axis = camera.world_from_camera.z_axis.as_dvec3();
        let reach = f64::from(STEPS) * STEP_M + NEAR_M;
        let lanes = self.lanes.iter().flat_map(|lane| &lane.center);
        let walks = self.sidewalks.iter().flat_map(|walk| &walk.outline);
        let near = |p: &&DVec3| p.truncate().distance(eye.truncate()) < reach;
        let places: Vec<DVec3> = lanes.chain(walks).filter(near).copied().collect();
        let nearest = |p: DVec3| {
            let distance = |q: &&DVec3| q.truncate().distance_squared(p.truncate());
            places.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).copied()
        };
        let hit = (1..=STEPS).map(|step| eye + axis * (STEP_M * f64::from(step))).find_map(|p| {
            let ground = nearest(p).filter(|q| q.truncate().distance(p.truncate()) < NEAR_M)?;
            (p.z <= ground.z).then_some(ground.z)
        });
        hit.or_else(|| nearest(eye).map(|ground| ground.z))
    }
}
