//! The settings of a camera.

use crate::Layer;
use endless_world::{CameraLookChoice, ImageSize, LensModel};
use serde::{Deserialize, Serialize};

/// A camera; what is not given is as the recipe has it for all.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct CameraSpec {
    /// Image size, `WIDTHxHEIGHT`.
    pub size: Option<String>,
    /// Horizontal field of view, degrees: 70 where not given, or the site's; 180 of a fisheye, 360 of an equirectangular lens.
    pub fov: Option<f64>,
    /// Lens: `"pinhole"` where not given, `"fisheye"`, `"equirectangular"` or `"orthographic"`, or a table with its numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lens: Option<LensModel>,
    /// Layers that it stores.
    pub layers: Option<Vec<Layer>>,
    /// Layers of which it makes a video.
    pub mp4: Option<Vec<Layer>>,
    /// Effects of its lens, sensor and recorder on the RGB layer.
    pub look: Option<CameraLookChoice>,
}

impl CameraSpec {
    /// The image size, if it is given and can be read.
    pub fn image_size(&self) -> Option<ImageSize> {
        self.size.as_ref()?.parse().ok()
    }
}
