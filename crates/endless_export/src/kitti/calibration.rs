//! Calibration files.

use crate::camera::Camera;
use glam::{DMat3, DVec3};

/// A 3×4 matrix as KITTI writes it, row by row.
pub(super) fn row_major(rotation: DMat3, translation: DVec3) -> String {
    let row = |i: usize| {
        let r = rotation.row(i);
        [r.x, r.y, r.z, translation[i]]
    };
    let numbers = (0..3).flat_map(row);
    numbers.map(|number| format!("{number:.12e}")).collect::<Vec<_>>().join(" ")
}

/// A 3×3 matrix.
pub(super) fn square(rotation: DMat3) -> String {
    let numbers = (0..3).flat_map(|i| rotation.row(i).to_array());
    numbers.map(|number| format!("{number:.12e}")).collect::<Vec<_>>().join(" ")
}

/// From a sensor (x ahead, y left, z up) to a camera that stands as it does (x right, y down, z ahead).
pub(super) fn camera_from_sensor() -> DMat3 {
    DMat3::from_cols(DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y)
}

/// Takes points before the level camera to pixels.
pub(super) fn projection(camera: &Camera) -> DMat3 {
    camera.intrinsics * camera.world_from_camera.transpose() * camera.level_from_world().transpose()
}

/// The file of a frame, with the names of either devkit.
pub(super) fn calibration(camera: &Camera, rectification: &str, [velo, imu]: [&str; 2]) -> String {
    let mut text = String::new();
    for number in 0..4 {
        text += &format!("P{number}: {}\n", row_major(projection(camera), DVec3::ZERO));
    }
    text += &format!("{rectification}: {}\n", square(DMat3::IDENTITY));
    text += &format!("{velo}: {}\n", row_major(camera_from_sensor(), DVec3::ZERO));
    text + &format!("{imu}: {}\n", row_major(DMat3::IDENTITY, DVec3::ZERO))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_ahead_of_the_sensor_is_ahead_of_the_camera() {
        let from = camera_from_sensor();
        assert_eq!(from * DVec3::X, DVec3::Z);
        assert_eq!(from * DVec3::Y, DVec3::NEG_X);
        assert_eq!(from * DVec3::Z, DVec3::NEG_Y);
    }

    #[test]
    fn a_point_is_projected_as_by_the_tilted_camera() {
        let ahead = DVec3::new(0.6, 0.0, -0.8);
        let right = DVec3::NEG_Y;
        let camera = Camera {
            position: DVec3::new(3.0, 4.0, 8.0),
            world_from_camera: DMat3::from_cols(right, ahead.cross(right), ahead),
            intrinsics: DMat3::from_cols(DVec3::X * 500.0, DVec3::Y * 500.0, DVec3::new(320.0, 180.0, 1.0)),
        };
        let point = DVec3::new(9.0, 3.0, 1.0);
        let own = camera.intrinsics * camera.world_from_camera.transpose() * (point - camera.position);
        let level = camera.level_from_world() * (point - camera.position);
        assert!((projection(&camera) * level - own).length() < 1e-9);
    }
}
