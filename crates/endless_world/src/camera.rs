//! Cameras: sites of fixed ones, intrinsics, projection.

use crate::{Distortion, SensorPose, math};
use glam::{DVec3, Mat3, Vec2, Vec3};
use serde::{Deserialize, Serialize};
use std::{fmt, str::FromStr};

/// Image size in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct ImageSize {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl ImageSize {
    /// Number of pixels.
    pub const fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl fmt::Display for ImageSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for ImageSize {
    type Err = String;
    fn from_str(given: &str) -> Result<Self, String> {
        let parse = || {
            let (w, h) = given.split_once(['x', 'X'])?;
            Some(Self { width: w.trim().parse().ok()?, height: h.trim().parse().ok()? })
        };
        parse().ok_or_else(|| format!("'{given}' is not a size: write WIDTHxHEIGHT, for example 1280x720"))
    }
}

/// What the camera is mounted on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mount {
    /// A pole of its own or a lamp post.
    Pole,
    /// The mast arm or pole of a traffic light.
    TrafficLight,
    /// A building's wall.
    Wall,
}

/// Position and direction of a surveillance camera.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CameraSite {
    /// Unique within the map, e.g. `junction_north`.
    pub name: String,
    /// Lens position in the world, metres.
    pub position: [f32; 3],
    /// Direction of the optical axis, counter-clockwise from east, radians.
    pub yaw_rad: f32,
    /// Angle of the optical axis below the horizon, radians.
    pub down_tilt_rad: f32,
    /// Horizontal field of view, radians.
    pub horizontal_fov_rad: f32,
    /// Its mount.
    pub mount: Mount,
    /// Turn about the optical axis, clockwise as the camera looks, radians: 0 unless it was put up askew.
    #[serde(default, skip_serializing_if = "is_level")]
    pub roll_rad: f32,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_level(roll_rad: &f32) -> bool {
    *roll_rad == 0.0
}

/// Pinhole intrinsics, pixels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Intrinsics {
    /// Focal length along x.
    pub fx: f32,
    /// Focal length along y: pixels are square.
    pub fy: f32,
    /// Principal point, x.
    pub cx: f32,
    /// Principal point, y.
    pub cy: f32,
}

impl Intrinsics {
    /// CARLA's rule: `f = W / (2 tan(fov / 2))`, principal point in the middle.
    pub fn from_fov(size: ImageSize, horizontal_fov_rad: f32) -> Self {
        let f = size.width as f32 / (2.0 * math::tan(horizontal_fov_rad / 2.0));
        Self { fx: f, fy: f, cx: size.width as f32 / 2.0, cy: size.height as f32 / 2.0 }
    }
}

/// A camera ready to make rays and project points.
#[derive(Debug, Clone, PartialEq)]
pub struct PinholeCamera {
    /// Image size.
    pub size: ImageSize,
    /// Intrinsics.
    pub intrinsics: Intrinsics,
    /// Lens position in the world.
    pub position: Vec3,
    /// Columns are the camera's right, down and forward axes in the world.
    pub world_from_camera: Mat3,
    /// Radial distortion of the lens; none in a true pinhole.
    pub distortion: Distortion,
}

impl PinholeCamera {
    /// The camera of a site at an image size.
    pub fn new(site: &CameraSite, size: ImageSize) -> Self {
        let (sin_yaw, cos_yaw) = math::sin_cos(site.yaw_rad);
        let (sin_tilt, cos_tilt) = math::sin_cos(site.down_tilt_rad);
        let forward = Vec3::new(cos_yaw * cos_tilt, sin_yaw * cos_tilt, -sin_tilt);
        let right = Vec3::new(sin_yaw, -cos_yaw, 0.0);
        let down = forward.cross(right);
        let (right, down) = rolled(right, down, site.roll_rad);
        Self {
            size,
            intrinsics: Intrinsics::from_fov(size, site.horizontal_fov_rad),
            position: Vec3::from_array(site.position),
            world_from_camera: Mat3::from_cols(right, down, forward),
            distortion: Distortion::NONE,
        }
    }

    /// The camera of a sensor: its body frame's x axis is the optical axis, its z axis points up in the picture.
    pub fn at(pose: &SensorPose, size: ImageSize, horizontal_fov_rad: f32) -> Self {
        let axis = |axis: DVec3| (pose.world_from_sensor * axis).as_vec3();
        Self {
            size,
            intrinsics: Intrinsics::from_fov(size, horizontal_fov_rad),
            position: pose.position.as_vec3(),
            world_from_camera: Mat3::from_cols(axis(DVec3::NEG_Y), axis(DVec3::NEG_Z), axis(DVec3::X)),
            distortion: Distortion::NONE,
        }
    }

    /// The same camera behind a lens that distorts.
    pub fn with_distortion(self, distortion: Distortion) -> Self {
        Self { distortion, ..self }
    }

    /// Unit direction in the world of the ray through an image point (pixel (i, j) has its centre at i + 0.5, j + 0.5).
    #[inline]
    pub fn ray_through(&self, x: f32, y: f32) -> Vec3 {
        let k = &self.intrinsics;
        let straight = self.distortion.undistort(Vec2::new((x - k.cx) / k.fx, (y - k.cy) / k.fy));
        (self.world_from_camera * straight.extend(1.0)).normalize()
    }

    /// A world point in the camera frame (x right, y down, z forward).
    #[inline]
    pub fn camera_from_world(&self, point_in_world: Vec3) -> Vec3 {
        self.world_from_camera.transpose() * (point_in_world - self.position)
    }

    /// Image point and planar depth (metres along the optical axis); `None` behind the camera.
    pub fn project(&self, point_in_world: Vec3) -> Option<(Vec2, f32)> {
        let p = self.camera_from_world(point_in_world);
        let k = &self.intrinsics;
        (p.z > 1e-4).then(|| {
            let bent = self.distortion.distort(Vec2::new(p.x, p.y) / p.z);
            (Vec2::new(k.fx * bent.x + k.cx, k.fy * bent.y + k.cy), p.z)
        })
    }
}

/// Axes turned towards each other.
fn rolled(right: Vec3, down: Vec3, roll_rad: f32) -> (Vec3, Vec3) {
    if roll_rad == 0.0 {
        return (right, down);
    }
    let (sin, cos) = math::sin_cos(roll_rad);
    (right * cos + down * sin, down * cos - right * sin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;

    #[test]
    fn projection_inverts_the_ray() {
        for k1 in [0.0, -0.05, -0.25] {
            projection_inverts_the_ray_of(Distortion::barrel(k1));
        }
    }

    #[test]
    fn a_sensor_looks_along_its_body() {
        // Turned to the left by a yaw, then nose down, then rolled to its right.
        let (yaw, tilt, roll) = (0.7, 0.2, 0.1);
        let turn = DQuat::from_rotation_z(yaw) * DQuat::from_rotation_y(tilt) * DQuat::from_rotation_x(roll);
        let position = DVec3::new(12.0, -3.0, 1.5);
        let size = ImageSize { width: 640, height: 360 };
        let camera = PinholeCamera::at(&SensorPose::still(position, turn), size, 1.2);
        let site = CameraSite {
            name: "t".into(),
            position: position.as_vec3().to_array(),
            yaw_rad: yaw as f32,
            down_tilt_rad: tilt as f32,
            horizontal_fov_rad: 1.2,
            mount: Mount::Pole,
            roll_rad: roll as f32,
        };
        let fixed = PinholeCamera::new(&site, size);
        assert_eq!((camera.position, camera.intrinsics), (fixed.position, fixed.intrinsics));
        assert!(camera.world_from_camera.abs_diff_eq(fixed.world_from_camera, 1e-6));
    }

    fn projection_inverts_the_ray_of(distortion: Distortion) {
        let site = CameraSite {
            name: "t".into(),
            position: [3.0, -4.0, 7.0],
            yaw_rad: 2.1,
            down_tilt_rad: 0.5,
            horizontal_fov_rad: 1.2,
            mount: Mount::Pole,
            roll_rad: 0.07,
        };
        let camera = PinholeCamera::new(&site, ImageSize { width: 641, height: 363 }).with_distortion(distortion);
        assert!((camera.world_from_camera.determinant() - 1.0).abs() < 1e-5);
        for (x, y) in [(0.5, 0.5), (320.0, 180.0), (640.5, 100.25)] {
            let point = camera.position + camera.ray_through(x, y) * 30.0;
            let (image, depth) = camera.project(point).expect("in front");
            assert!((image - Vec2::new(x, y)).length() < 1e-2);
            assert!(depth > 0.0 && depth <= 30.0);
        }
        // Looking down: the ray through the image's lower half points below the optical axis.
        assert!(camera.ray_through(320.0, 360.0).z < camera.ray_through(320.0, 10.0).z);
    }
}
