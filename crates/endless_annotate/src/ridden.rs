//! Two-wheelers together with who rides them: what some detectors call one object.

use crate::{AmodalBox, Box3dRecord, PixelBox};
use serde::{Deserialize, Serialize};

/// A two-wheeler and its rider as one, as `objects.jsonl` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WithRider {
    /// Tight box of the visible pixels of both.
    pub bbox: PixelBox,
    /// Number of these pixels.
    pub pixels: u32,
    /// Box of what both would show if nothing hid them, also beyond the picture's edges.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amodal_bbox: Option<AmodalBox>,
    /// The box around both, which stands as the two-wheeler does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub box3d: Option<Box3dRecord>,
}
