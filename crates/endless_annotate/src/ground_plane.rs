//! The ground that a camera looks at as a plane, and the homography between it and the picture.

use crate::lens_projection::LensProjection;
use endless_world::{Lens, PinholeCamera};
use glam::{DMat3, DVec3};
use serde::{Deserialize, Serialize};

/// The level plane at the height of the ground in the middle of a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct GroundPlane {
    /// Its height in the world, metres.
    pub z_m: f64,
    /// Row-major: `[u w, v w, w] = homography · [x, y, 1]`, from metres in the world to pixels without distortion; `w` is the
    /// planar depth in metres, above 0 before the camera.
    pub homography: [[f64; 3]; 3],
    /// The other way, up to scale.
    pub inverse: [[f64; 3]; 3],
}

impl GroundPlane {
    /// The plane at this height as a camera sees it; `None` for a camera in the plane, and for lenses that are not
    /// perspective: no matrix tells what they make of a plane.
    pub fn new(camera: &PinholeCamera, z_m: f64) -> Option<Self> {
        if !matches!(camera.lens, Lens::Perspective(_)) {
            return None;
        }
        let lens = LensProjection::new(camera);
        let r = lens.camera_from_world;
        let origin = r * (DVec3::Z * z_m - lens.position);
        let homography = lens.matrix() * DMat3::from_cols(r.x_axis, r.y_axis, origin);
        (homography.determinant().abs() > 1e-6).then(|| Self {
            z_m,
            homography: rows(homography),
            inverse: rows(homography.inverse()),
        })
    }
}

fn rows(matrix: DMat3) -> [[f64; 3]; 3] {
    matrix.transpose().to_cols_array_2d()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{CameraSite, ImageSize, LensModel, Mount};
    use glam::{DVec2, DVec3};

    #[test]
    fn it_maps_the_ground_to_pixels_and_back() {
        let site = CameraSite {
            name: "test".into(),
            position: [120.0, -300.0, 12.0],
            yaw_rad: 2.0,
            down_tilt_rad: 0.4,
            horizontal_fov_rad: 1.3,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let camera = PinholeCamera::new(&site, ImageSize { width: 1280, height: 720 });
        let plane = GroundPlane::new(&camera, 4.5).expect("the camera is above");
        let lens = LensProjection::new(&camera);
        let apply = |m: &[[f64; 3]; 3], p: DVec2| DVec3::from(m.map(|row| DVec3::from(row).dot(p.extend(1.0))));
        for (x, y) in [(110.0, -280.0), (118.0, -290.0), (90.0, -260.0)] {
            let ground = DVec2::new(x, y);
            let there = lens.to_camera(ground.extend(4.5));
            let image = apply(&plane.homography, ground);
            assert!((image.z - there.z).abs() < 1e-9, "the third coordinate is the depth");
            let pixel = image.truncate() / image.z;
            assert!(pixel.distance(lens.image(there)) < 1e-9);
            let back = apply(&plane.inverse, pixel);
            assert!((back.truncate() / back.z).distance(ground) < 1e-6);
        }
        assert_eq!(GroundPlane::new(&camera, 12.0), None);
    }
}
