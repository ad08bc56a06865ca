//! What is handed over of a frame.

use endless_annotate::{ActorRecord, CollisionEvent, FrameObjects, LaneInvasionEvent, SceneFrame};
use endless_dataset::{CameraRecord, Layer, PoseLine, SensorRecord, SpawnCounts, StoredImage};
use endless_world::{GnssRecord, ImuRecord, Incident, LidarSweep, PixelEvent, RadarScan, SceneSettings};
use std::sync::Arc;

/// What stays the same in all frames of a video.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamedVideo {
    /// Its settings.
    pub settings: SceneSettings,
    /// The name that its folder would have.
    pub name: String,
    /// Numbers of actors that were placed.
    pub spawned: SpawnCounts,
    /// What happens of the events that the settings ask for.
    pub incidents: Vec<Incident>,
    /// What stays the same of every object, by ascending id; none if the simulator does not know.
    pub actors: Option<Vec<ActorRecord>>,
    /// The cameras of the scene, `camera_a` first.
    pub cameras: Vec<CameraRecord>,
    /// The sensors of the rig.
    pub sensors: Vec<SensorRecord>,
    /// The cameras among the sensors of the rig, by their places in it.
    pub sensor_cameras: Vec<Option<CameraRecord>>,
}

/// One instant of a scene, as all its cameras and sensors see it.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamedFrame {
    /// Its place among the frames of all videos, in the stream's order, from 0.
    pub index: u64,
    /// Its video.
    pub video: Arc<StreamedVideo>,
    /// Its number in the video, from 0.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// The line of `frames.jsonl`; none if the simulator does not tell of frames.
    pub scene: Option<SceneFrame>,
    /// One a camera of the scene.
    pub cameras: Vec<StreamedCamera>,
    /// Of the rig's sensors those that measured at this frame.
    pub sensors: Vec<StreamedSensor>,
}

/// What a camera sees.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamedCamera {
    /// The name that its folder would have: `camera_a`, or a sensor's name.
    pub name: String,
    /// The recipe's layers, as they would be stored.
    pub layers: Vec<(Layer, StoredImage<'static>)>,
    /// The line of `objects.jsonl`.
    pub objects: FrameObjects,
}

/// What a sensor of the rig measured.
#[derive(Debug, Clone, PartialEq)]
pub struct StreamedSensor {
    /// Its place in the rig.
    pub sensor: usize,
    /// Its name.
    pub name: String,
    /// Where it is.
    pub pose: PoseLine,
    /// What it measured.
    pub measurement: Measurement,
}

/// A measurement of a sensor.
#[derive(Debug, Clone, PartialEq)]
pub enum Measurement {
    /// A camera's.
    Camera(StreamedCamera),
    /// A LiDAR's.
    Lidar(LidarSweep),
    /// A radar's.
    Radar(RadarScan),
    /// An event camera's: the events since the frame before.
    Events(Vec<PixelEvent>),
    /// An IMU's. That of frame 0 comes with the next, because it needs two poses.
    Imu(Vec<ImuRecord>),
    /// A GNSS receiver's.
    Gnss(GnssRecord),
    /// What its carrier touched.
    Collisions(Vec<CollisionEvent>),
    /// The line that its carrier crossed.
    LaneInvasion(Option<LaneInvasionEvent>),
}
