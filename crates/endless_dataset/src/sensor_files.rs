//! The files of sensors other than cameras.

use crate::{
    CameraLayout, ModelSpec, PointCloudFormat, bin_from_points, csv_from_detections, decode_pixel_events,
    detections_from_csv, encode_pixel_events, label_from_points, pcd_from_points, ply_from_points, point_labels,
    points_from_bin, points_from_pcd, points_from_ply,
};
use endless_world::{LidarPoint, LidarSweep, PixelEvent, RadarScan};
use std::path::PathBuf;
use strum::IntoStaticStr;

/// A folder of a sensor with one file for each of its measurements, named as the frames are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, IntoStaticStr)]
#[strum(serialize_all = "snake_case")]
pub enum FrameFolder {
    /// A LiDAR's points, KITTI's `.bin`.
    Points,
    /// Their labels, SemanticKITTI's `.label`.
    Labels,
    /// A LiDAR's points with all that is known of them, PLY.
    Ply,
    /// The same, PCD.
    Pcd,
    /// A radar's detections, CSV.
    Scans,
    /// The events since the frame before, NumPy.
    Events,
}

impl FrameFolder {
    /// Its name.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// What its files end with.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Points => "bin",
            Self::Labels => "label",
            Self::Ply => "ply",
            Self::Pcd => "pcd",
            Self::Scans => "csv",
            Self::Events => "npy",
        }
    }

    /// The name of a frame's file.
    pub fn file(self, frame: u32) -> String {
        format!("{frame:06}.{}", self.extension())
    }

    /// The file of a LiDAR's sweep; `None` in folders of other sensors.
    pub fn of_sweep(self, sweep: &LidarSweep) -> Option<Vec<u8>> {
        let points: &[LidarPoint] = &sweep.points;
        Some(match self {
            Self::Points => bin_from_points(points),
            Self::Labels => label_from_points(points),
            Self::Ply => ply_from_points(points),
            Self::Pcd => pcd_from_points(points),
            Self::Scans | Self::Events => return None,
        })
    }

    /// The file of a radar's scan; `None` in folders of other sensors.
    pub fn of_scan(self, scan: &RadarScan) -> Option<Vec<u8>> {
        (self == Self::Scans).then(|| csv_from_detections(&scan.detections).into_bytes())
    }

    /// The file of an event camera's events.
    pub fn of_events(events: &[PixelEvent]) -> Vec<u8> {
        encode_pixel_events(events)
    }

    /// How many points, detections or events a file has.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn count(self, bytes: &[u8]) -> Result<usize, String> {
        match self {
            Self::Points => points_from_bin(bytes).map(|points| points.len()),
            Self::Labels => point_labels(bytes).map(|labels| labels.len()),
            Self::Ply => points_from_ply(bytes).map(|points| points.len()),
            Self::Pcd => points_from_pcd(bytes).map(|points| points.len()),
            Self::Scans => {
                let text = std::str::from_utf8(bytes).map_err(|error| format!("is no text: {error}"))?;
                detections_from_csv(text).map(|detections| detections.len())
            }
            Self::Events => decode_pixel_events(bytes).map(|events| events.len()),
        }
    }
}

impl ModelSpec {
    /// The folders of such a sensor with one file for each measurement; cameras have those of their layers.
    pub fn frame_folders(&self) -> Vec<FrameFolder> {
        match self {
            Self::Lidar(lidar) => lidar.formats.iter().flat_map(|format| format.folders()).copied().collect(),
            Self::Radar(_) => vec![FrameFolder::Scans],
            Self::EventCamera(_) => vec![FrameFolder::Events],
            Self::Camera(_) | Self::Imu(_) | Self::Gnss(_) | Self::Collision | Self::LaneInvasion => Vec::new(),
        }
    }

    /// The file of such a sensor with a line for each measurement, or for each event.
    pub fn lines_file(&self) -> Option<&'static str> {
        match self {
            Self::Imu(_) => Some("imu.jsonl"),
            Self::Gnss(_) => Some("gnss.jsonl"),
            Self::Collision => Some("collisions.jsonl"),
            Self::LaneInvasion => Some("lane_invasions.jsonl"),
            Self::Camera(_) | Self::EventCamera(_) | Self::Lidar(_) | Self::Radar(_) => None,
        }
    }

    /// Bytes of a measurement's files, roughly, where there are so many measurements a second.
    pub fn bytes_a_measurement(&self, rate_hz: f64) -> f64 {
        match self {
            Self::Lidar(lidar) => {
                let bytes = |format: &PointCloudFormat| if *format == PointCloudFormat::Kitti { 20.0 } else { 32.0 };
                let points = f64::from(lidar.settings.points_per_second) / rate_hz;
                points * lidar.formats.iter().map(bytes).sum::<f64>()
            }
            Self::Radar(radar) => 64.0 * f64::from(radar.points_per_second) / rate_hz,
            // One pixel in twenty.
            Self::EventCamera(camera) => camera.image_size().map_or(0.0, |size| 0.65 * size.pixels() as f64),
            Self::Camera(_) | Self::Imu(_) | Self::Gnss(_) | Self::Collision | Self::LaneInvasion => 300.0,
        }
    }
}

impl PointCloudFormat {
    const fn folders(self) -> &'static [FrameFolder] {
        match self {
            Self::Kitti => &[FrameFolder::Points, FrameFolder::Labels],
            Self::Ply => &[FrameFolder::Ply],
            Self::Pcd => &[FrameFolder::Pcd],
        }
    }
}

impl CameraLayout {
    /// A folder of a sensor with a file for each measurement.
    pub fn frame_folder(&self, folder: FrameFolder) -> PathBuf {
        self.folder().join(folder.name())
    }

    /// One of its files.
    pub fn frame_file(&self, folder: FrameFolder, frame: u32) -> PathBuf {
        self.frame_folder(folder).join(folder.file(frame))
    }
}
