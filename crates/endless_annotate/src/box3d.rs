//! Oriented boxes around objects, in the world, before a camera, and in its picture.

use crate::rounding::{hundred_thousandths, hundredths, thousandths};
use endless_world::{PinholeCamera, Pose};
use glam::{EulerRot, Mat3, Quat, Vec3};
use serde::{Deserialize, Serialize};

/// A box that stands as an object does: its axes are the object's (x forward, y left, z up).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Box3d {
    /// Its middle, world frame, metres.
    pub centre: Vec3,
    /// Length, width, height, metres.
    pub size: Vec3,
    /// Turns the object's axes into the world's.
    pub world_from_object: Quat,
}

impl Box3d {
    /// The box of an object at a pose, between two corners of its own frame.
    pub fn new(pose: &Pose, low: Vec3, high: Vec3) -> Self {
        let world_from_object = Quat::from_euler(EulerRot::ZYX, pose.yaw_rad, -pose.pitch_rad, pose.roll_rad);
        let centre = pose.world_from_object().transform_point3(0.5 * (low + high));
        Self { centre, size: high - low, world_from_object }
    }

    /// The box around both, which stands as this one does; exact where the other does, too.
    #[must_use]
    pub fn united(&self, other: &Self) -> Self {
        let axes = Mat3::from_quat(self.world_from_object);
        let (mut low, mut high) = (-0.5 * self.size, 0.5 * self.size);
        for corner in other.corners() {
            let own = axes.transpose() * (corner - self.centre);
            (low, high) = (low.min(own), high.max(own));
        }
        Self { centre: self.centre + axes * (0.5 * (low + high)), size: high - low, ..*self }
    }

    /// The corners, world frame: from the front left one below, first the four below against the clock as seen from
    /// above, then the four above them.
    pub fn corners(&self) -> [Vec3; 8] {
        const SIGNS: [[f32; 2]; 4] = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];
        let axes = Mat3::from_quat(self.world_from_object);
        let half = 0.5 * self.size;
        std::array::from_fn(|i| {
            let [x, y] = SIGNS[i % 4];
            let z = if i < 4 { -1.0 } else { 1.0 };
            self.centre + axes * (half * Vec3::new(x, y, z))
        })
    }

    /// As it is written.
    pub(crate) fn record(&self, camera: &PinholeCamera) -> Box3dRecord {
        let camera_from_world = Quat::from_mat3(&camera.world_from_camera).conjugate();
        let corner = |at: Vec3| {
            let (image, depth) = camera.project(at)?;
            (depth > NEAR_M).then(|| image.to_array().map(hundredths))
        };
        Box3dRecord {
            center: self.centre.to_array().map(thousandths),
            size: self.size.to_array().map(thousandths),
            rotation: wxyz(self.world_from_object),
            center_in_camera: camera.camera_from_world(self.centre).to_array().map(thousandths),
            rotation_in_camera: wxyz(camera_from_world * self.world_from_object),
            corners: self.corners().map(corner),
        }
    }
}

/// Corners nearer than this have no place in the picture, metres.
const NEAR_M: f32 = 0.1;

/// A box as `objects.jsonl` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Box3dRecord {
    /// Its middle in the world (x east, y north, z up), metres.
    pub center: [f64; 3],
    /// Length, width, height, metres.
    pub size: [f64; 3],
    /// Unit quaternion `[w, x, y, z]`: turns the object's axes (x forward, y left, z up) into the world's.
    pub rotation: [f64; 4],
    /// Its middle in the camera's frame (x right, y down, z along the optical axis), metres.
    pub center_in_camera: [f64; 3],
    /// Unit quaternion: turns the object's axes into the camera's.
    pub rotation_in_camera: [f64; 4],
    /// The eight corners in the picture, pixels: from the front left one below, the four below against the clock as seen
    /// from above, then those above them. `null` for one beside or behind the camera.
    pub corners: [Option<[f64; 2]>; 8],
}

/// Unit quaternions are written with a positive `w`.
fn wxyz(q: Quat) -> [f64; 4] {
    let sign = if q.w < 0.0 { -1.0 } else { 1.0 };
    [q.w, q.x, q.y, q.z].map(|v| hundred_thousandths(sign * v))
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{CameraSite, ImageSize, LensModel, Mount};
    use proptest::prelude::*;

    #[test]
    fn corners_go_round_from_the_front_left() {
        let pose = Pose::level(Vec3::new(10.0, 0.0, 0.0), 0.0);
        let around = Box3d::new(&pose, Vec3::new(-2.0, -1.0, 0.0), Vec3::new(3.0, 1.0, 1.5));
        assert_eq!((around.centre, around.size), (Vec3::new(10.5, 0.0, 0.75), Vec3::new(5.0, 2.0, 1.5)));
        let corners = around.corners();
        assert_eq!(corners[0], Vec3::new(13.0, 1.0, 0.0));
        assert_eq!(corners[1], Vec3::new(8.0, 1.0, 0.0));
        assert_eq!(corners[3], Vec3::new(13.0, -1.0, 0.0));
        assert_eq!(corners[4], Vec3::new(13.0, 1.0, 1.5));
    }

    #[test]
    fn two_boxes_are_held_by_one() {
        let pose = Pose { yaw_rad: 0.7, roll_rad: 0.1, ..Pose::level(Vec3::new(10.0, 3.0, 0.0), 0.7) };
        let bicycle = Box3d::new(&pose, Vec3::new(-0.9, -0.3, 0.0), Vec3::new(0.9, 0.3, 1.0));
        let rider = Box3d::new(&pose, Vec3::new(-0.3, -0.35, 0.2), Vec3::new(0.6, 0.25, 1.8));
        let both = Box3d::new(&pose, Vec3::new(-0.9, -0.35, 0.0), Vec3::new(0.9, 0.3, 1.8));
        let united = bicycle.united(&rider);
        assert!(united.centre.distance(both.centre) < 1e-5 && united.size.distance(both.size) < 1e-5, "{united:?}");
        assert!(bicycle.united(&bicycle).size.distance(bicycle.size) < 1e-5);
    }

    proptest! {
        #[test]
        fn it_stands_as_its_object_does(yaw in -3.0f32..3.0, pitch in -0.3f32..0.3, roll in -0.3f32..0.3) {
            let pose = Pose { position: Vec3::new(3.0, -7.0, 1.0), yaw_rad: yaw, pitch_rad: pitch, roll_rad: roll };
            let (low, high) = (Vec3::new(-2.0, -1.0, 0.0), Vec3::new(3.0, 1.0, 1.5));
            let around = Box3d::new(&pose, low, high);
            let front_left = pose.world_from_object().transform_point3(Vec3::new(high.x, high.y, low.z));
            prop_assert!((around.corners()[0] - front_left).length() < 1e-4);
            // Its place before a camera and its corners there say the same.
            let site = CameraSite {
                name: "mast".into(),
                position: [-20.0, -7.0, 8.0],
                yaw_rad: 0.1,
                down_tilt_rad: 0.3,
                horizontal_fov_rad: 1.2,
                lens: LensModel::Pinhole,
                mount: Mount::Pole,
                roll_rad: 0.0,
            };
            let camera = PinholeCamera::new(&site, ImageSize { width: 640, height: 360 });
            let record = around.record(&camera);
            let number = |v: f64| v as f32;
            let [w, x, y, z] = record.rotation_in_camera.map(number);
            let turned = Mat3::from_quat(Quat::from_xyzw(x, y, z, w)) * (0.5 * Vec3::new(5.0, 2.0, -1.5));
            let corner = Vec3::from_array(record.center_in_camera.map(number)) + turned;
            let k = camera.intrinsics;
            let [u, v] = record.corners[0].expect("ahead").map(number);
            prop_assert!((k.fx * corner.x / corner.z + k.cx - u).abs() < 0.1);
            prop_assert!((k.fy * corner.y / corner.z + k.cy - v).abs() < 0.1);
        }
    }
}
