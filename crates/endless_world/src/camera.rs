//! Cameras: sites of fixed ones, projection.

use crate::{DepthMeasure, Distortion, ImageSize, Intrinsics, Lens, LensModel, SensorPose, math};
use glam::{DVec3, Mat3, Vec2, Vec3};
use serde::{Deserialize, Serialize};

/// What the camera is mounted on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, strum::IntoStaticStr)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case")]
pub enum Mount {
    /// A pole of its own or a lamp post.
    Pole,
    /// The mast arm or pole of a traffic light.
    TrafficLight,
    /// A building's wall.
    Wall,
    /// The edge of a roof.
    Roof,
    /// A gantry over the carriageway.
    Gantry,
    /// A bridge over the road.
    Bridge,
    /// A mast of its own, higher than lamp posts.
    Mast,
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
    /// Horizontal field of view, radians; of no meaning for orthographic lenses.
    pub horizontal_fov_rad: f32,
    /// Its lens; one like a pinhole unless it is told.
    #[serde(default, skip_serializing_if = "LensModel::is_pinhole")]
    pub lens: LensModel,
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

/// A camera ready to make rays and project points.
#[derive(Debug, Clone, PartialEq)]
pub struct PinholeCamera {
    /// Image size.
    pub size: ImageSize,
    /// Intrinsics.
    pub intrinsics: Intrinsics,
    /// Lens position in the world; of an orthographic lens the middle of the plane from which its rays start.
    pub position: Vec3,
    /// Columns are the camera's right, down and forward axes in the world.
    pub world_from_camera: Mat3,
    /// How directions become places of the picture.
    pub lens: Lens,
}

/// The ray of a place of a picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CameraRay {
    /// Where it starts in the world, metres.
    pub origin: Vec3,
    /// A unit vector of the world.
    pub direction: Vec3,
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
            intrinsics: site.lens.intrinsics(size, site.horizontal_fov_rad),
            position: Vec3::from_array(site.position),
            world_from_camera: Mat3::from_cols(right, down, forward),
            lens: site.lens.lens(site.horizontal_fov_rad),
        }
    }

    /// The camera of a sensor, a pinhole: its body frame's x axis is the optical axis, its z axis points up in the picture.
    pub fn at(pose: &SensorPose, size: ImageSize, horizontal_fov_rad: f32) -> Self {
        let axis = |axis: DVec3| (pose.world_from_sensor * axis).as_vec3();
        Self {
            size,
            intrinsics: Intrinsics::from_fov(size, horizontal_fov_rad),
            position: pose.position.as_vec3(),
            world_from_camera: Mat3::from_cols(axis(DVec3::NEG_Y), axis(DVec3::NEG_Z), axis(DVec3::X)),
            lens: Lens::PINHOLE,
        }
    }

    /// The same camera behind another lens.
    #[must_use]
    pub fn with_lens(self, model: LensModel, horizontal_fov_rad: f32) -> Self {
        let intrinsics = model.intrinsics(self.size, horizontal_fov_rad);
        Self { intrinsics, lens: model.lens(horizontal_fov_rad), ..self }
    }

    /// The same camera behind a lens that distorts, if it is perspective: other lenses stay as they are.
    #[must_use]
    pub fn with_distortion(self, distortion: Distortion) -> Self {
        match self.lens {
            Lens::Perspective(_) => Self { lens: Lens::Perspective(distortion), ..self },
            _ => self,
        }
    }

    /// The place of an image point before focal length and principal point: see [`Lens`].
    #[inline]
    fn normalized(&self, x: f32, y: f32) -> Vec2 {
        let k = &self.intrinsics;
        Vec2::new((x - k.cx) / k.fx, (y - k.cy) / k.fy)
    }

    /// Unit direction in the world of the ray through an image point (pixel (i, j) has its centre at i + 0.5, j + 0.5);
    /// of the nearest one, where the lens shows nothing.
    #[inline]
    pub fn ray_through(&self, x: f32, y: f32) -> Vec3 {
        (self.world_from_camera * self.lens.direction(self.normalized(x, y))).normalize()
    }

    /// The ray through an image point; `None` where the lens shows nothing.
    #[inline]
    pub fn ray(&self, x: f32, y: f32) -> Option<CameraRay> {
        self.shows(x, y).then(|| CameraRay { origin: self.ray_origin(x, y), direction: self.ray_through(x, y) })
    }

    /// Where the ray through an image point starts.
    #[inline]
    pub fn ray_origin(&self, x: f32, y: f32) -> Vec3 {
        if self.lens.is_central() {
            return self.position;
        }
        self.position + self.world_from_camera * self.normalized(x, y).extend(0.0)
    }

    /// Whether the lens shows anything at an image point: beyond the image circle of a fisheye, and beyond the poles of an
    /// equirectangular picture, it does not.
    #[inline]
    pub fn shows(&self, x: f32, y: f32) -> bool {
        self.lens.shows(self.normalized(x, y))
    }

    /// From where the camera sees a point of the world: the lens, or of parallel rays the start of that which leads there.
    #[inline]
    pub fn eye_for(&self, point_in_world: Vec3) -> Vec3 {
        if self.lens.is_central() {
            return self.position;
        }
        let forward = self.world_from_camera.z_axis;
        point_in_world - forward * (point_in_world - self.position).dot(forward)
    }

    /// Depth of what a ray in this direction meets at a distance, as the lens measures it, metres.
    #[inline]
    pub fn depth_along(&self, direction: Vec3, distance: f32) -> f32 {
        match self.lens.depth_measure() {
            DepthMeasure::Planar => distance * direction.dot(self.world_from_camera.z_axis),
            DepthMeasure::Distance => distance,
        }
    }

    /// Angle of a pixel in the middle of the picture, radians; of parallel rays that of the ground, taken to be at height
    /// 0, from where the camera hangs.
    pub fn pixel_angle_rad(&self) -> f32 {
        if self.lens.is_central() {
            1.0 / self.intrinsics.fx
        } else {
            1.0 / (self.intrinsics.fx * self.position.z.max(1.0))
        }
    }

    /// A way between two image points: the short one where the picture's left and right edges meet.
    pub fn way_in_image(&self, from: Vec2, to: Vec2) -> Vec2 {
        let way = to - from;
        let round = self.intrinsics.fx * std::f32::consts::TAU;
        if self.lens == Lens::Equirectangular && way.x.abs() > 0.5 * round {
            return Vec2::new(way.x - round.copysign(way.x), way.y);
        }
        way
    }

    /// A world point in the camera frame (x right, y down, z forward).
    #[inline]
    pub fn camera_from_world(&self, point_in_world: Vec3) -> Vec3 {
        self.world_from_camera.transpose() * (point_in_world - self.position)
    }

    /// Image point, also beyond the picture, and depth as the lens measures it: metres along the optical axis, or from the
    /// lens. `None` for what the lens does not show: behind a perspective one, beyond the largest angle of a fisheye.
    pub fn project(&self, point_in_world: Vec3) -> Option<(Vec2, f32)> {
        let (p, depth) = self.lens.project(self.camera_from_world(point_in_world))?;
        let k = &self.intrinsics;
        Some((Vec2::new(k.fx * p.x + k.cx, k.fy * p.y + k.cy), depth))
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
            lens: LensModel::Pinhole,
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
            lens: LensModel::Pinhole,
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
