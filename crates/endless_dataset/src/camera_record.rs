//! `camera.json`.

use crate::pose_line::world_from_camera;
use endless_annotate::GroundPlane;
use endless_world::{
    CameraSite, DepthMeasure, Distortion, FAR_PLANE_M, ImageSize, Intrinsics, Lens, LensModel, PinholeCamera,
};
use serde::{Deserialize, Serialize};

/// One camera of a video: everything needed to project world points into its images and back.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct CameraRecord {
    /// Conventions of the numbers.
    pub conventions: String,
    /// Image size, pixels.
    pub size: ImageSize,
    /// Frames a second.
    pub fps: f64,
    /// Focal lengths and principal point, pixels.
    pub intrinsics: Intrinsics,
    /// The same as a matrix, row-major: `image ~ K · camera`, or `image = K · [p, 1]` with the `p` of the lens.
    pub intrinsics_matrix: [[f64; 3]; 3],
    /// Row-major 4×4: `world = world_from_camera · camera`; of cameras that move, `poses.jsonl` tells it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub world_from_camera: Option<[[f64; 4]; 4]>,
    /// The lens.
    pub lens: LensRecord,
    /// Depth of the sky, metres.
    pub far_plane_m: f64,
    /// Position and direction of a camera that does not move.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub site: Option<CameraSite>,
    /// The ground, of maps on which it is known.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub ground_plane: Option<GroundPlane>,
}

/// The lens model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LensRecord {
    /// `pinhole`, `opencv` where a perspective lens distorts, `opencv_fisheye`, `equirectangular`, or `orthographic`.
    pub model: String,
    /// Horizontal field of view, radians; 0 of parallel rays.
    pub horizontal_fov_rad: f64,
    /// OpenCV's D: k1, k2, p1, p2, k3 of perspective lenses, k1 to k4 of a fisheye, nothing of others.
    pub distortion: Vec<f64>,
    /// Largest angle from the optical axis that a fisheye shows, radians.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_angle_rad: Option<f64>,
    /// Width of the picture of parallel rays, metres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width_m: Option<f64>,
    /// How depth is measured: along the optical axis, unless it is told.
    #[serde(default, skip_serializing_if = "is_planar")]
    pub depth: DepthMeasure,
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde calls it")]
fn is_planar(depth: &DepthMeasure) -> bool {
    *depth == DepthMeasure::Planar
}

impl LensRecord {
    fn new(model: LensModel, horizontal_fov_rad: f32, distortion: Distortion) -> Self {
        let lens = model.lens(horizontal_fov_rad);
        let none = Self {
            model: model.name().into(),
            horizontal_fov_rad: f64::from(horizontal_fov_rad),
            distortion: Vec::new(),
            max_angle_rad: None,
            width_m: None,
            depth: lens.depth_measure(),
        };
        match (model, lens) {
            (LensModel::Orthographic { width_m }, _) => {
                Self { horizontal_fov_rad: 0.0, width_m: Some(f64::from(width_m)), ..none }
            }
            (_, Lens::Fisheye(fisheye)) => Self {
                model: "opencv_fisheye".into(),
                distortion: fisheye.k().map(f64::from).to_vec(),
                max_angle_rad: Some(f64::from(fisheye.max_angle_rad())),
                ..none
            },
            (_, Lens::Perspective(_)) => Self {
                model: if distortion == Distortion::NONE { "pinhole" } else { "opencv" }.into(),
                distortion: vec![f64::from(distortion.k1), f64::from(distortion.k2), 0.0, 0.0, 0.0],
                ..none
            },
            (_, Lens::Equirectangular | Lens::Orthographic) => none,
        }
    }
}

const CONVENTIONS: &str = "metres and radians; world: right-handed, x east, y north, z up; camera (OpenCV): x right, \
                           y down, z along the optical axis; image: x right, y down, the centre of pixel (i, j) is \
                           at (i + 0.5, j + 0.5); matrices are row-major and act on columns; target_from_source: \
                           world = world_from_camera * camera";

impl CameraRecord {
    /// The record of a site filming through a lens at this size and rate.
    pub fn new(site: &CameraSite, distortion: Distortion, size: ImageSize, fps: f64) -> Self {
        let world_from_camera = Some(world_from_camera(&PinholeCamera::new(site, size)));
        Self {
            world_from_camera,
            site: Some(site.clone()),
            ..Self::moving(site.lens, site.horizontal_fov_rad, distortion, size, fps)
        }
    }

    /// The record of a camera that moves.
    pub fn moving(lens: LensModel, horizontal_fov_rad: f32, distortion: Distortion, size: ImageSize, fps: f64) -> Self {
        let intrinsics = lens.intrinsics(size, horizontal_fov_rad);
        let Intrinsics { fx, fy, cx, cy } = intrinsics;
        Self {
            conventions: CONVENTIONS.into(),
            size,
            fps,
            intrinsics,
            intrinsics_matrix: [
                [f64::from(fx), 0.0, f64::from(cx)],
                [0.0, f64::from(fy), f64::from(cy)],
                [0.0, 0.0, 1.0],
            ],
            world_from_camera: None,
            lens: LensRecord::new(lens, horizontal_fov_rad, distortion),
            far_plane_m: f64::from(FAR_PLANE_M),
            site: None,
            ground_plane: None,
        }
    }

    /// With the plane of the ground at this height, metres.
    #[must_use]
    pub fn with_ground(self, z_m: Option<f64>) -> Self {
        let camera = self.site.as_ref().map(|site| PinholeCamera::new(site, self.size));
        let ground_plane = camera.zip(z_m).and_then(|(camera, z_m)| GroundPlane::new(&camera, z_m));
        Self { ground_plane, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::Mount;
    use glam::Vec3;

    #[test]
    fn the_lens_is_told_in_the_words_of_opencv() {
        let told = |lens: LensModel, fov_rad: f32, distortion: Distortion| {
            let size = ImageSize { width: 640, height: 360 };
            let record = CameraRecord::moving(lens, fov_rad, distortion, size, 30.0);
            let focal = record.intrinsics.fx;
            (serde_json::to_string(&record.lens).expect("plain"), focal)
        };
        let (barrel, none) = (Distortion::barrel(-0.5), Distortion::NONE);
        let pinhole = r#"{"model":"pinhole","horizontal_fov_rad":1.25,"distortion":[0.0,0.0,0.0,0.0,0.0]}"#;
        assert_eq!(told(LensModel::Pinhole, 1.25, none).0, pinhole);
        let bent = r#"{"model":"opencv","horizontal_fov_rad":1.25,"distortion":[-0.5,0.125,0.0,0.0,0.0]}"#;
        assert_eq!(told(LensModel::Pinhole, 1.25, barrel).0, bent);
        // A look bends perspective lenses only.
        let fisheye = r#"{"model":"opencv_fisheye","horizontal_fov_rad":3.0,"distortion":[0.25,0.0,0.0,0.0],"max_angle_rad":1.5,"depth":"distance"}"#;
        let (text, focal) = told(LensModel::Fisheye { k: [0.25, 0.0, 0.0, 0.0] }, 3.0, barrel);
        assert_eq!(text, fisheye);
        assert!((focal * 1.5 * (1.0 + 0.25 * 2.25) - 320.0).abs() < 1e-3);
        let round = r#"{"model":"equirectangular","horizontal_fov_rad":5.0,"distortion":[],"depth":"distance"}"#;
        assert_eq!(told(LensModel::Equirectangular, 5.0, none), (round.to_owned(), 128.0));
        let above = r#"{"model":"orthographic","horizontal_fov_rad":0.0,"distortion":[],"width_m":40.0}"#;
        assert_eq!(told(LensModel::Orthographic { width_m: 40.0 }, 1.0, none), (above.to_owned(), 16.0));
    }

    #[test]
    fn the_matrices_project_as_the_camera_does() {
        let site = CameraSite {
            name: "t".into(),
            position: [3.0, -4.0, 7.0],
            yaw_rad: 2.1,
            down_tilt_rad: 0.5,
            horizontal_fov_rad: 1.2,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let size = ImageSize { width: 641, height: 363 };
        let record = CameraRecord::new(&site, Distortion::NONE, size, 30.0);
        let camera = PinholeCamera::new(&site, size);
        let in_camera = [1.5, -0.7, 12.0, 1.0];
        let world = record
            .world_from_camera
            .expect("it stands still")
            .map(|row| row.iter().zip(in_camera).map(|(m, c)| m * c).sum::<f64>());
        let image = record.intrinsics_matrix.map(|row| row.iter().zip(in_camera).map(|(m, c)| m * c).sum::<f64>());
        let (point, depth) =
            camera.project(Vec3::new(world[0] as f32, world[1] as f32, world[2] as f32)).expect("in front");
        assert!((f64::from(depth) - 12.0).abs() < 1e-4);
        assert!((f64::from(point.x) - image[0] / image[2]).abs() < 1e-2);
        assert!((f64::from(point.y) - image[1] / image[2]).abs() < 1e-2);
    }
}
