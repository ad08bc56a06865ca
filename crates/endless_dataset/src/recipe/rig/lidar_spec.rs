//! The settings of a LiDAR, and the formats of its files.

use super::json_fields::{fields, value};
use endless_world::LidarSettings;
use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

/// A format of point clouds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PointCloudFormat {
    /// KITTI's points (`points/`, `.bin`), with SemanticKITTI's labels (`labels/`, `.label`).
    Kitti,
    /// PLY, binary (`ply/`).
    Ply,
    /// PCD 0.7, binary (`pcd/`).
    Pcd,
}

/// A LiDAR.
#[derive(Debug, Clone, PartialEq)]
pub struct LidarSpec {
    /// Formats of its sweeps, in their canonical order.
    pub formats: Vec<PointCloudFormat>,
    /// The device.
    pub settings: LidarSettings,
}

impl LidarSpec {
    pub(super) fn parse(mut given: Map<String, Value>) -> Result<Self, String> {
        let formats = given.remove("formats").map_or(Ok(vec![PointCloudFormat::Kitti]), value);
        let mut formats = formats.map_err(|wrong| format!("formats: {wrong}"))?;
        formats.sort_unstable();
        formats.dedup();
        Ok(Self { formats, settings: value(given)? })
    }

    pub(super) fn fields(&self) -> Map<String, Value> {
        let mut written = fields(&self.settings);
        written.insert("formats".to_owned(), json!(self.formats));
        written
    }
}
