//! KITTI's point clouds: x, y, z and intensity of each point, 32-bit little-endian floats, without a header (Geiger et al.:
//! Vision meets Robotics: The KITTI Dataset, 2013).

use endless_world::{LidarPoint, SensorPose};
use glam::DMat3;

const POINT_BYTES: usize = 16;

/// The bytes of a `.bin`.
pub fn bin_from_points(points: &[LidarPoint]) -> Vec<u8> {
    let numbers = |p: &LidarPoint| [p.position.x, p.position.y, p.position.z, p.intensity];
    points.iter().flat_map(numbers).flat_map(f32::to_le_bytes).collect()
}

/// `[x, y, z, intensity]` of each point of a `.bin`.
///
/// # Errors
/// What is wrong: a broken point, or one that is nowhere.
pub fn points_from_bin(bytes: &[u8]) -> Result<Vec<[f32; 4]>, String> {
    let (points, rest) = bytes.as_chunks::<POINT_BYTES>();
    if !rest.is_empty() {
        return Err(format!("has {} bytes, which is no multiple of {POINT_BYTES}", bytes.len()));
    }
    let read = |point: &[u8; POINT_BYTES]| {
        let (numbers, _) = point.as_chunks::<4>();
        std::array::from_fn(|i| f32::from_le_bytes(numbers[i]))
    };
    let points: Vec<[f32; 4]> = points.iter().map(read).collect();
    match points.iter().position(|point| !point.iter().all(|number| number.is_finite())) {
        Some(wrong) => Err(format!("point {wrong} is not finite")),
        None => Ok(points),
    }
}

/// A line of KITTI's `poses.txt`, without its end: the upper three rows of the matrix that takes points of the sensor's frame
/// into the world.
pub fn kitti_pose_line(pose: &SensorPose) -> String {
    let turn = DMat3::from_quat(pose.world_from_sensor);
    let rows = (0..3).flat_map(|row| [turn.row(row).x, turn.row(row).y, turn.row(row).z, pose.position[row]]);
    rows.map(|number| format!("{number:.9e}")).collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DQuat, DVec3};

    #[test]
    fn a_pose_is_a_matrix_row_by_row() {
        let turn = DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2);
        let line = kitti_pose_line(&SensorPose::still(DVec3::new(5.0, -6.0, 1.73), turn));
        let numbers: Vec<f64> = line.split(' ').map(|number| number.parse().expect("a number")).collect();
        let expected = [0.0, -1.0, 0.0, 5.0, 1.0, 0.0, 0.0, -6.0, 0.0, 0.0, 1.0, 1.73];
        assert!(numbers.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9) && numbers.len() == 12, "{line}");
    }
}
