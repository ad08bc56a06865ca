//! The settings of an event camera: its lens and pixels, and what makes an event.

use super::json_fields::{fields, value};
use endless_world::{EventCameraSettings, ImageSize, LensModel};
use serde_json::{Map, Value};

/// An event camera; what is not given of its lens and pixels is as the recipe has it for all.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct EventCameraSpec {
    /// Image size, `WIDTHxHEIGHT`.
    pub size: Option<String>,
    /// Horizontal field of view, degrees.
    pub fov: Option<f64>,
    /// Lens: a pinhole where not given.
    pub lens: Option<LensModel>,
    /// What makes an event.
    pub settings: EventCameraSettings,
}

impl EventCameraSpec {
    pub(super) fn parse(mut given: Map<String, Value>) -> Result<Self, String> {
        let size = given.remove("size").map(value).transpose().map_err(|wrong| format!("size: {wrong}"))?;
        let fov = given.remove("fov").map(value).transpose().map_err(|wrong| format!("fov: {wrong}"))?;
        let lens = given.remove("lens").map(value).transpose().map_err(|wrong| format!("lens: {wrong}"))?;
        Ok(Self { size, fov, lens, settings: value(given)? })
    }

    pub(super) fn fields(&self) -> Map<String, Value> {
        let mut written = fields(&self.settings);
        written.extend(self.size.as_ref().map(|size| ("size".to_owned(), size.clone().into())));
        written.extend(self.fov.map(|fov| ("fov".to_owned(), fov.into())));
        if let Some(lens) = &self.lens {
            written.insert("lens".to_owned(), serde_json::to_value(lens).expect("plain data"));
        }
        written
    }

    /// The image size, if it is given and can be read.
    pub fn image_size(&self) -> Option<ImageSize> {
        self.size.as_ref()?.parse().ok()
    }
}
