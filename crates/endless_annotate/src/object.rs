//! The attributes of each visible object of a frame.

use crate::rounding::{ten_thousandths, thousandths};
use crate::{Activity, AmodalRecord, Keypoints, PixelBox, Spatial, WithRider};
use endless_world::{Actor, FOOT_KEYPOINT_COUNT, InstanceId, ObjectClass, WorldState};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// One annotated object of one frame, as written in `objects.jsonl`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ObjectRecord {
    /// The track: the same object has the same id in all cameras and all frames.
    pub id: InstanceId,
    /// Its class.
    pub class: ObjectClass,
    /// Tight box of its visible pixels.
    pub bbox: PixelBox,
    /// Number of its visible pixels.
    pub pixels: u32,
    /// Whether the box touches the image's edge, so that more of the object may lie outside.
    pub truncated: bool,
    /// Parked for the whole video.
    pub parked: bool,
    /// For a rider: the two-wheeler ridden.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vehicle_id: Option<InstanceId>,
    /// For a two-wheeler: who rides it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rider_id: Option<InstanceId>,
    /// People and riders: skin tone on the Monk scale, 1 to 10.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub skin_tone: Option<u8>,
    /// People and riders: COCO's keypoints.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub keypoints: Option<Keypoints>,
    /// Number of keypoints in the picture.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub num_keypoints: Option<u32>,
    /// People and riders: COCO-WholeBody's keypoints of the feet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub foot_kpts: Option<Keypoints<FOOT_KEYPOINT_COUNT>>,
    /// People and riders: the same keypoints in the world, metres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub keypoints_3d: Option<Vec<[f64; 3]>>,
    /// Those of the feet.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub foot_kpts_3d: Option<Vec<[f64; 3]>>,
    /// Point on the ground under its centre, in the world (x east, y north, z up), metres.
    pub position: [f64; 3],
    /// Heading, counter-clockwise from east, radians.
    pub yaw_rad: f64,
    /// Speed over ground, m/s.
    pub speed_mps: f64,
    /// Velocity in the world, m/s.
    #[serde(default)]
    pub velocity_mps: [f64; 3],
    /// What it is doing.
    #[serde(flatten)]
    pub activity: Activity,
    /// Where it is, by its shape.
    #[serde(default, flatten, skip_serializing_if = "Option::is_none")]
    pub spatial: Option<Spatial>,
    /// What of it is hidden.
    #[serde(default, flatten, skip_serializing_if = "Option::is_none")]
    pub amodal: Option<AmodalRecord>,
    /// Of a two-wheeler: together with its rider.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub with_rider: Option<WithRider>,
}

/// All objects of one instant, parked ones included, by id.
#[derive(Debug, Clone)]
pub struct SceneObjects(Vec<SceneObject>);

/// An object of the scene, seen or not.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SceneObject {
    pub(crate) id: InstanceId,
    pub(crate) class: ObjectClass,
    parked: bool,
    vehicle_id: Option<InstanceId>,
    rider_id: Option<InstanceId>,
    skin_tone: Option<u8>,
    position: [f64; 3],
    yaw_rad: f64,
    speed_mps: f64,
    velocity_mps: [f64; 3],
    activity: Activity,
}

impl SceneObjects {
    /// The objects of this instant. `parked` are those that the state leaves out.
    pub fn new(state: &WorldState, parked: &[Actor]) -> Self {
        let mut objects = Vec::with_capacity(state.actors.len() + parked.len());
        for actor in state.actors.iter().chain(parked) {
            objects.push(SceneObject::of(actor));
            objects.extend(SceneObject::rider_of(actor));
        }
        objects.sort_by_key(|o| o.id);
        Self(objects)
    }

    /// With the skin tones of those who have one.
    #[must_use]
    pub fn with_skin_tones(mut self, tones: &BTreeMap<InstanceId, u8>) -> Self {
        for object in &mut self.0 {
            object.skin_tone = tones.get(&object.id).copied();
        }
        self
    }

    /// With the OpenDRIVE ids of lanes, of road and lane, given their indices.
    #[must_use]
    pub fn with_roads(mut self, ids: impl Fn(u32) -> Option<(u32, i32)>) -> Self {
        for Activity { lane, road, road_lane, .. } in self.0.iter_mut().map(|object| &mut object.activity) {
            (*road, *road_lane) = lane.and_then(&ids).unzip();
        }
        self
    }

    pub(crate) fn find(&self, id: InstanceId) -> Option<&SceneObject> {
        self.0.binary_search_by_key(&id, |o| o.id).ok().map(|i| &self.0[i])
    }
}

impl SceneObject {
    fn of(actor: &Actor) -> Self {
        Self {
            id: actor.id,
            class: actor.class,
            parked: actor.parked,
            vehicle_id: None,
            rider_id: actor.rider_id,
            skin_tone: None,
            position: actor.pose.position.to_array().map(thousandths),
            yaw_rad: ten_thousandths(actor.pose.yaw_rad),
            speed_mps: thousandths(actor.velocity_mps.length()),
            velocity_mps: actor.velocity_mps.to_array().map(thousandths),
            activity: Activity::of(actor),
        }
    }

    fn rider_of(actor: &Actor) -> Option<Self> {
        let id = actor.rider_id?;
        Some(Self {
            id,
            class: ObjectClass::Rider,
            vehicle_id: Some(actor.id),
            rider_id: None,
            activity: Activity::of_rider(actor),
            ..Self::of(actor)
        })
    }

    pub(crate) fn record(&self, bbox: PixelBox, pixels: u32, truncated: bool) -> ObjectRecord {
        ObjectRecord {
            id: self.id,
            class: self.class,
            bbox,
            pixels,
            truncated,
            parked: self.parked,
            vehicle_id: self.vehicle_id,
            rider_id: self.rider_id,
            skin_tone: self.skin_tone,
            keypoints: None,
            num_keypoints: None,
            foot_kpts: None,
            keypoints_3d: None,
            foot_kpts_3d: None,
            position: self.position,
            yaw_rad: self.yaw_rad,
            speed_mps: self.speed_mps,
            velocity_mps: self.velocity_mps,
            activity: self.activity.clone(),
            spatial: None,
            amodal: None,
            with_rider: None,
        }
    }
}
