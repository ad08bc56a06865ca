//! One sensor of a scene's rig.

use super::{EventCameraSettings, GnssSettings, ImuSettings, LidarSettings, RadarSettings, SensorMount, SensorPose};
use crate::{CameraLook, CameraSite, ImageSize, LensModel, Mount, PinholeCamera, SceneCamera};
use serde::{Deserialize, Serialize};

/// A sensor of a scene besides its fixed pair or network of cameras.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneSensor {
    /// Its folder; unique in the rig.
    pub name: String,
    /// It measures at every so many frames of the video, from frame 0 on.
    pub every: u32,
    /// What decides where it is.
    pub mount: SensorMount,
    /// What it is.
    #[serde(flatten)]
    pub model: SensorModel,
}

/// What a sensor is, and its settings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case")]
pub enum SensorModel {
    /// A camera.
    Camera(RigCamera),
    /// A camera that tells changes of brightness.
    EventCamera(RigEventCamera),
    /// A LiDAR.
    Lidar(LidarSettings),
    /// A radar.
    Radar(RadarSettings),
    /// Accelerometer, gyroscope and compass.
    Imu(ImuSettings),
    /// A receiver of satellite navigation.
    Gnss(GnssSettings),
    /// It notices whom its carrier touches.
    Collision,
    /// It notices painted lines that its carrier comes over.
    LaneInvasion,
}

/// An event camera of a rig.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RigEventCamera {
    /// Its lens and its pixels.
    pub camera: RigCamera,
    /// What makes an event.
    pub settings: EventCameraSettings,
}

impl SensorModel {
    /// Its lens and its pixels, if it has a lens.
    pub fn camera(&self) -> Option<&RigCamera> {
        match self {
            Self::Camera(camera) | Self::EventCamera(RigEventCamera { camera, .. }) => Some(camera),
            _ => None,
        }
    }
}

/// A camera of a rig.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RigCamera {
    /// Image size.
    pub size: ImageSize,
    /// Horizontal field of view, radians; of a lens that zooms the mount's way-points have others.
    pub horizontal_fov_rad: f64,
    /// Its lens; one like a pinhole unless it is told.
    #[serde(default, skip_serializing_if = "LensModel::is_pinhole")]
    pub lens: LensModel,
    /// Effects of its lens, sensor and recorder on the picture.
    pub look: CameraLook,
}

impl RigCamera {
    /// As it is when the sensor is there.
    pub fn at(&self, mount: &SensorMount, pose: &SensorPose, time_s: f64) -> PinholeCamera {
        let fov_rad = mount.fov_at(time_s).unwrap_or(self.horizontal_fov_rad) as f32;
        let camera = PinholeCamera::at(pose, self.size, fov_rad).with_lens(self.lens, fov_rad);
        camera.with_distortion(self.look.distortion)
    }
}

impl SceneSensor {
    /// Whether it measures at a frame of the video.
    pub fn measures_at(&self, frame: u32) -> bool {
        frame.is_multiple_of(self.every)
    }

    /// The camera that it is, if it is one that stands still.
    pub fn fixed_camera(&self) -> Option<SceneCamera> {
        let (Some(camera), SensorMount::Still { at }) = (self.model.camera(), &self.mount) else { return None };
        let site = CameraSite {
            name: self.name.clone(),
            position: at.position.map(|metres| metres as f32),
            yaw_rad: at.yaw_rad as f32,
            down_tilt_rad: -at.pitch_rad as f32,
            horizontal_fov_rad: camera.horizontal_fov_rad as f32,
            lens: camera.lens,
            mount: Mount::Pole,
            roll_rad: at.roll_rad as f32,
        };
        Some(SceneCamera { site, look: camera.look })
    }
}
