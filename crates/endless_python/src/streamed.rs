//! A streamed frame on its way to Python: made ready without the interpreter's lock, then handed over.

use crate::{
    arrays::{insert_planes, shaped},
    objects::columns,
};
use endless_annotate::{ActorRecord, FrameObjects};
use endless_dataset::{CameraRecord, DatasetError, Plane, SensorRecord, SpawnCounts};
use endless_pipeline::{Measurement, StreamedCamera, StreamedFrame, StreamedSensor, StreamedVideo};
use endless_world::{ImageSize, Incident, LidarSweep, PixelEvent, RadarScan, SceneSettings};
use pyo3::{
    prelude::*,
    types::{PyBytes, PyDict, PyList},
};
use serde::Serialize;
use std::sync::Arc;

/// A frame with its images decoded.
pub(crate) struct ReadyFrame {
    index: u64,
    video: Arc<StreamedVideo>,
    frame: u32,
    time_s: f64,
    scene: Option<Vec<u8>>,
    cameras: Vec<ReadyCamera>,
    sensors: Vec<(String, Vec<u8>, ReadyMeasurement)>,
}

struct ReadyCamera {
    name: String,
    layers: Vec<(ImageSize, Vec<Plane>)>,
    objects: FrameObjects,
    line: Vec<u8>,
}

enum ReadyMeasurement {
    Camera(ReadyCamera),
    Columns(Vec<(&'static str, Column)>),
    Records(Vec<u8>),
}

enum Column {
    F32(Vec<f32>, usize),
    I32(Vec<i32>),
    I64(Vec<i64>),
    Bool(Vec<bool>),
}

impl ReadyFrame {
    /// Decodes what a frame has.
    pub(crate) fn new(frame: StreamedFrame) -> Result<Self, DatasetError> {
        let StreamedFrame { index, video, frame, time_s, scene, cameras, sensors } = frame;
        let cameras = cameras.into_iter().map(ReadyCamera::new).collect::<Result<_, _>>()?;
        let sensor = |StreamedSensor { name, pose, measurement, .. }: StreamedSensor| {
            Ok((name, json_of(&pose), ReadyMeasurement::new(measurement)?))
        };
        let sensors = sensors.into_iter().map(sensor).collect::<Result<_, DatasetError>>()?;
        Ok(Self { index, video, frame, time_s, scene: scene.as_ref().map(json_of), cameras, sensors })
    }

    /// Whether it is of another video than the frame before.
    pub(crate) fn begins(&self, last: &mut Option<u32>) -> bool {
        last.replace(self.video.settings.video) != Some(self.video.settings.video)
    }

    /// The frame as a dictionary; with all of its video if that begins.
    pub(crate) fn into_dict(self, py: Python<'_>, begins: bool) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("index", self.index)?;
        dict.set_item("frame", self.frame)?;
        dict.set_item("time_s", self.time_s)?;
        dict.set_item("scene", self.scene.map(|scene| PyBytes::new(py, &scene)))?;
        let cameras = self.cameras.into_iter().map(|camera| camera.into_dict(py)).collect::<PyResult<Vec<_>>>()?;
        dict.set_item("cameras", cameras)?;
        let sensors = PyList::empty(py);
        for (name, pose, measurement) in self.sensors {
            sensors.append((name, PyBytes::new(py, &pose), measurement.into_python(py)?))?;
        }
        dict.set_item("sensors", sensors)?;
        let video = begins.then(|| PyBytes::new(py, &video_json(&self.video)));
        dict.set_item("video", video)?;
        Ok(dict)
    }
}

/// What stays the same of a video. Not by way of a `Value`, which makes other digits of single precision than files have.
#[derive(Serialize)]
struct VideoJson<'a> {
    name: &'a str,
    settings: &'a SceneSettings,
    spawned: SpawnCounts,
    incidents: &'a [Incident],
    actors: Option<&'a [ActorRecord]>,
    cameras: &'a [CameraRecord],
    sensors: &'a [SensorRecord],
    sensor_cameras: &'a [Option<CameraRecord>],
}

fn video_json(video: &StreamedVideo) -> Vec<u8> {
    json_of(&VideoJson {
        name: &video.name,
        settings: &video.settings,
        spawned: video.spawned,
        incidents: &video.incidents,
        actors: video.actors.as_deref(),
        cameras: &video.cameras,
        sensors: &video.sensors,
        sensor_cameras: &video.sensor_cameras,
    })
}

fn json_of(value: &impl Serialize) -> Vec<u8> {
    serde_json::to_vec(value).expect("plain numbers and words")
}

impl ReadyCamera {
    fn new(camera: StreamedCamera) -> Result<Self, DatasetError> {
        let StreamedCamera { name, layers, objects } = camera;
        let decoded = layers.into_iter().map(|(layer, image)| {
            let size = image.size();
            let planes = layer.planes(image).map_err(|reason| DatasetError::malformed(layer.name(), reason))?;
            Ok((size, planes))
        });
        let layers = decoded.collect::<Result<_, DatasetError>>()?;
        Ok(Self { name, layers, line: json_of(&objects), objects })
    }

    fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        let arrays = PyDict::new(py);
        for (size, planes) in self.layers {
            insert_planes(&arrays, planes, size)?;
        }
        dict.set_item("name", self.name)?;
        dict.set_item("arrays", arrays)?;
        dict.set_item("objects", columns(py, &self.objects)?)?;
        dict.set_item("line", PyBytes::new(py, &self.line))?;
        Ok(dict)
    }
}

impl ReadyMeasurement {
    fn new(measurement: Measurement) -> Result<Self, DatasetError> {
        Ok(match measurement {
            Measurement::Camera(camera) => Self::Camera(ReadyCamera::new(camera)?),
            Measurement::Lidar(sweep) => Self::Columns(of_sweep(&sweep)),
            Measurement::Radar(scan) => Self::Columns(of_scan(&scan)),
            Measurement::Events(events) => Self::Columns(of_events(&events)),
            Measurement::Imu(records) => Self::Records(json_of(&records)),
            Measurement::Gnss(record) => Self::Records(json_of(&[record])),
            Measurement::Collisions(events) => Self::Records(json_of(&events)),
            Measurement::LaneInvasion(event) => Self::Records(json_of(&Vec::from_iter(event))),
        })
    }

    fn into_python(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        match self {
            Self::Camera(camera) => Ok(camera.into_dict(py)?.into_any()),
            Self::Records(json) => Ok(PyBytes::new(py, &json).into_any()),
            Self::Columns(columns) => {
                let dict = PyDict::new(py);
                for (name, column) in columns {
                    dict.set_item(name, column.into_array(py)?)?;
                }
                Ok(dict.into_any())
            }
        }
    }
}

impl Column {
    fn into_array(self, py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        match self {
            Self::F32(values, 1) => {
                let count = values.len();
                shaped(py, values, vec![count])
            }
            Self::F32(values, channels) => {
                let count = values.len() / channels;
                shaped(py, values, vec![count, channels])
            }
            Self::I32(values) => {
                let count = values.len();
                shaped(py, values, vec![count])
            }
            Self::I64(values) => {
                let count = values.len();
                shaped(py, values, vec![count])
            }
            Self::Bool(values) => {
                let count = values.len();
                shaped(py, values, vec![count])
            }
        }
    }
}

fn of_sweep(sweep: &LidarSweep) -> Vec<(&'static str, Column)> {
    let points = &sweep.points;
    let places = points.iter().flat_map(|point| point.position.to_array()).collect();
    vec![
        ("points_m", Column::F32(places, 3)),
        ("intensity", Column::F32(points.iter().map(|point| point.intensity).collect(), 1)),
        ("time_s", Column::F32(points.iter().map(|point| point.time_s).collect(), 1)),
        ("channel", Column::I32(points.iter().map(|point| point.channel.into()).collect())),
        ("classes", Column::I32(points.iter().map(|point| point.tag.value().into()).collect())),
        ("ids", Column::I32(points.iter().map(|point| point.id.0.into()).collect())),
        ("moving", Column::Bool(points.iter().map(|point| point.moving).collect())),
    ]
}

fn of_scan(scan: &RadarScan) -> Vec<(&'static str, Column)> {
    let detections = &scan.detections;
    vec![
        ("depth_m", Column::F32(detections.iter().map(|of| of.depth_m).collect(), 1)),
        ("azimuth_rad", Column::F32(detections.iter().map(|of| of.azimuth_rad).collect(), 1)),
        ("altitude_rad", Column::F32(detections.iter().map(|of| of.altitude_rad).collect(), 1)),
        ("velocity_mps", Column::F32(detections.iter().map(|of| of.velocity_mps).collect(), 1)),
        ("power_db", Column::F32(detections.iter().map(|of| of.power_db).collect(), 1)),
        ("classes", Column::I32(detections.iter().map(|of| of.tag.value().into()).collect())),
        ("ids", Column::I32(detections.iter().map(|of| of.id.0.into()).collect())),
    ]
}

fn of_events(events: &[PixelEvent]) -> Vec<(&'static str, Column)> {
    vec![
        ("t_us", Column::I64(events.iter().map(|event| event.t_us).collect())),
        ("x", Column::I32(events.iter().map(|event| event.x.into()).collect())),
        ("y", Column::I32(events.iter().map(|event| event.y.into()).collect())),
        ("polarity", Column::Bool(events.iter().map(|event| event.polarity).collect())),
    ]
}
