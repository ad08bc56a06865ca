//! Where a camera is and how it projects, at each of its frames.

use crate::{ExportError, Sequence, SourceDataset};
use endless_dataset::{DatasetError, PoseLine, read_lines};
use endless_world::Intrinsics;
use glam::{DMat3, DQuat, DVec3};
use std::collections::BTreeMap;

/// A perspective camera at an instant. World: x east, y north, z up; camera: x right, y down, z along the optical axis; metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Camera {
    pub(crate) position: DVec3,
    pub(crate) world_from_camera: DMat3,
    /// Takes points in the camera's frame to homogeneous pixels.
    pub(crate) intrinsics: DMat3,
}

/// The cameras of a sequence.
#[derive(Debug)]
pub(crate) enum CameraWay {
    Still(Camera),
    Moving(BTreeMap<u32, Camera>),
}

/// Models of lenses that have a matrix of intrinsics.
const PERSPECTIVE: [&str; 2] = ["pinhole", "opencv"];

/// Whether all lenses are perspective, so that a matrix tells of them.
pub(crate) fn perspective_only(format: &'static str, dataset: &SourceDataset) -> Result<(), ExportError> {
    let is_odd = |sequence: &&Sequence| !PERSPECTIVE.contains(&sequence.record.lens.model.as_str());
    match dataset.sequences.iter().find(is_odd) {
        None => Ok(()),
        Some(sequence) => Err(ExportError::Unfit {
            format,
            sequence: sequence.name(),
            reason: format!("its lens is {}, and the format has a matrix for it only", sequence.record.lens.model),
        }),
    }
}

/// Whether all cameras stand still, so that one calibration holds for a sequence.
pub(crate) fn still_only(format: &'static str, dataset: &SourceDataset) -> Result<(), ExportError> {
    match dataset.sequences.iter().find(|sequence| sequence.moves) {
        None => Ok(()),
        Some(sequence) => Err(ExportError::Unfit {
            format,
            sequence: sequence.name(),
            reason:
                "it moves, and a calibration holds for a whole sequence: kitti_object and nuscenes have one a frame"
                    .into(),
        }),
    }
}

fn camera(rows: &[[f64; 4]; 4], Intrinsics { fx, fy, cx, cy }: Intrinsics) -> Camera {
    let column = |i: usize| DVec3::new(rows[0][i], rows[1][i], rows[2][i]);
    let [fx, fy, cx, cy] = [fx, fy, cx, cy].map(f64::from);
    Camera {
        position: column(3),
        world_from_camera: DMat3::from_cols(column(0), column(1), column(2)),
        intrinsics: DMat3::from_cols(DVec3::new(fx, 0.0, 0.0), DVec3::new(0.0, fy, 0.0), DVec3::new(cx, cy, 1.0)),
    }
}

impl CameraWay {
    /// Reads where a camera is.
    pub(crate) fn read(sequence: &Sequence) -> Result<Self, ExportError> {
        let record = &sequence.record;
        if let Some(rows) = record.world_from_camera.as_ref().filter(|_| !sequence.moves) {
            return Ok(Self::Still(camera(rows, record.intrinsics)));
        }
        let path = sequence.files.poses();
        let mut way = BTreeMap::new();
        for line in read_lines::<PoseLine>(&path)? {
            let rows = line.world_from_camera.ok_or_else(|| DatasetError::malformed(&path, "tells of no camera"))?;
            way.insert(line.frame, camera(&rows, line.intrinsics.unwrap_or(record.intrinsics)));
        }
        Ok(Self::Moving(way))
    }

    /// The camera at a frame.
    pub(crate) fn at(&self, sequence: &Sequence, frame: u32) -> Result<Camera, ExportError> {
        match self {
            Self::Still(camera) => Ok(*camera),
            Self::Moving(way) => way.get(&frame).copied().ok_or_else(|| {
                DatasetError::malformed(sequence.files.poses(), format!("does not tell of frame {frame}")).into()
            }),
        }
    }
}

impl Camera {
    /// Takes the world's axes to those of a camera at the same place that stands level: its y axis points down, its z axis to
    /// where this one looks, along the ground.
    pub(crate) fn level_from_world(&self) -> DMat3 {
        let down = DVec3::NEG_Z;
        let [right, ahead] = [self.world_from_camera.x_axis, self.world_from_camera.z_axis];
        let along_ground = DVec3::new(ahead.x, ahead.y, 0.0);
        let z = if along_ground.length() > 1e-3 {
            along_ground.normalize()
        } else {
            // It looks straight down or up.
            DVec3::new(right.x, right.y, 0.0).cross(down).normalize_or(DVec3::X)
        };
        DMat3::from_cols(down.cross(z), down, z).transpose()
    }
}

/// The rotation of a quaternion `[w, x, y, z]`.
pub(crate) fn rotation([w, x, y, z]: [f64; 4]) -> DMat3 {
    DMat3::from_quat(DQuat::from_xyzw(x, y, z, w).normalize())
}

/// The quaternion `[w, x, y, z]` of a rotation.
pub(crate) fn quaternion(rotation: DMat3) -> [f64; 4] {
    let q = DQuat::from_mat3(&rotation);
    [q.w, q.x, q.y, q.z]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_camera_looks_along_the_ground() {
        // North, 30 degrees down.
        let ahead = DVec3::new(0.0, 0.75_f64.sqrt(), -0.5);
        let right = DVec3::X;
        let tilted = Camera {
            position: DVec3::new(1.0, 2.0, 6.0),
            world_from_camera: DMat3::from_cols(right, ahead.cross(right), ahead),
            intrinsics: DMat3::IDENTITY,
        };
        let level = tilted.level_from_world();
        assert!((level * DVec3::Y - DVec3::Z).length() < 1e-12, "north is ahead");
        assert!((level * DVec3::X - DVec3::X).length() < 1e-12, "east is to the right");
        assert!((level * DVec3::Z - DVec3::NEG_Y).length() < 1e-12, "up is up");
        assert!((level.determinant() - 1.0).abs() < 1e-12);
        let down = Camera { world_from_camera: DMat3::from_cols(DVec3::X, DVec3::NEG_Y, DVec3::NEG_Z), ..tilted };
        assert!((down.level_from_world() * DVec3::X - DVec3::X).length() < 1e-12);
    }

    #[test]
    fn quaternions_go_there_and_back() {
        let q = [0.5, -0.5, 0.5, 0.5];
        // One that is turned the other way round is the same.
        let again = quaternion(rotation(q));
        assert!(again.iter().zip(q).map(|(a, b)| a * b).sum::<f64>().abs() > 1.0 - 1e-12, "{again:?}");
    }
}
