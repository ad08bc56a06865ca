//! `poses.jsonl`: where a sensor of a rig is at each of its frames.

use endless_world::{ImageSize, Intrinsics, Lens, PinholeCamera, SensorPose};
use glam::{DQuat, DVec3, Mat3, Vec3};
use serde::{Deserialize, Serialize};

/// One line of `poses.jsonl`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PoseLine {
    /// Frame of the scene.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// Of the sensor's origin in the world, metres.
    pub position: [f64; 3],
    /// w, x, y, z of the unit quaternion that turns the sensor's body frame (x forward, y left, z up) into the world.
    pub quaternion: [f64; 4],
    /// World frame, m/s.
    pub velocity_mps: [f64; 3],
    /// World frame, radians a second.
    pub angular_velocity_radps: [f64; 3],
    /// Of cameras, row-major 4×4: `world = world_from_camera · camera`, with x right, y down and z along the optical axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub world_from_camera: Option<[[f64; 4]; 4]>,
    /// Of cameras, pixels: those of lenses that zoom differ from frame to frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub intrinsics: Option<Intrinsics>,
}

impl PoseLine {
    /// Of a sensor at a frame.
    pub fn new(frame: u32, time_s: f64, pose: &SensorPose) -> Self {
        let q = pose.world_from_sensor;
        Self {
            frame,
            time_s,
            position: pose.position.to_array(),
            quaternion: [q.w, q.x, q.y, q.z],
            velocity_mps: pose.velocity_mps.to_array(),
            angular_velocity_radps: pose.angular_velocity_radps.to_array(),
            world_from_camera: None,
            intrinsics: None,
        }
    }

    /// Of a camera.
    #[must_use]
    pub fn with_camera(self, camera: &PinholeCamera) -> Self {
        let world_from_camera = Some(world_from_camera(camera));
        Self { world_from_camera, intrinsics: Some(camera.intrinsics), ..self }
    }

    /// Where it is.
    pub fn pose(&self) -> SensorPose {
        let [w, x, y, z] = self.quaternion;
        SensorPose {
            position: self.position.into(),
            world_from_sensor: DQuat::from_xyzw(x, y, z, w),
            velocity_mps: DVec3::from_array(self.velocity_mps),
            angular_velocity_radps: DVec3::from_array(self.angular_velocity_radps),
        }
    }

    /// The camera as it was told, behind a pinhole: the lens is told elsewhere. `None` of other sensors.
    pub fn camera(&self, size: ImageSize) -> Option<PinholeCamera> {
        let (rows, intrinsics) = (self.world_from_camera?, self.intrinsics?);
        let column = |i: usize| Vec3::new(rows[0][i] as f32, rows[1][i] as f32, rows[2][i] as f32);
        Some(PinholeCamera {
            size,
            intrinsics,
            position: column(3),
            world_from_camera: Mat3::from_cols(column(0), column(1), column(2)),
            lens: Lens::PINHOLE,
        })
    }
}

/// Row-major 4×4.
pub(crate) fn world_from_camera(camera: &PinholeCamera) -> [[f64; 4]; 4] {
    let (r, p) = (camera.world_from_camera, camera.position);
    let row = |i: usize| [r.col(0)[i], r.col(1)[i], r.col(2)[i], p[i]].map(f64::from);
    [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_is_read_as_it_was() {
        let rotation = DQuat::from_rotation_z(2.1) * DQuat::from_rotation_y(0.3);
        let pose = SensorPose {
            velocity_mps: DVec3::new(7.0, -1.0, 0.1),
            ..SensorPose::still(DVec3::new(-31.4, 8.25, 1.7), rotation)
        };
        let size = ImageSize { width: 640, height: 360 };
        let camera = PinholeCamera::at(&pose, size, 1.2);
        let line = PoseLine::new(7, 0.7, &pose).with_camera(&camera);
        let text = serde_json::to_string(&line).expect("plain");
        let read: PoseLine = serde_json::from_str(&text).expect("a line");
        assert_eq!((read.camera(size), read.pose()), (Some(camera), pose));
    }
}
