//! Files of what LiDARs and radars measure.
//!
//! Points of LiDARs are written as KITTI's `.bin` with SemanticKITTI's `.label` beside it, as PLY, or as PCD; the latter two
//! hold all that is known of a point. Detections of radars are CSV. Every writer has a reader, which takes damaged files for
//! what they are.

mod kitti;
mod pcd;
mod ply;
mod point_record;
mod radar_csv;
mod semantic_kitti;

pub use kitti::{bin_from_points, kitti_pose_line, points_from_bin};
pub use pcd::{pcd_from_points, points_from_pcd};
pub use ply::{ply_from_points, points_from_ply};
pub use radar_csv::{csv_from_detections, detections_from_csv};
pub use semantic_kitti::{PointLabel, label_from_points, point_labels};
