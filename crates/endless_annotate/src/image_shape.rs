//! Parts of lines and areas, as a dataset tells them.

use crate::rounding::{hundredths_f64, millionths};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// A connected part of a line in a picture: as many points of the world as of the image.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImageLine {
    /// Metres.
    pub world: Vec<[f64; 3]>,
    /// Pixels, through the lens; straight lines between them are as near to the curve as 0.25 pixels.
    pub image: Vec<[f64; 2]>,
}

/// An area in a picture.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImageArea {
    /// Its whole outline, not closed, metres.
    pub world: Vec<[f64; 3]>,
    /// The outline of the part in the picture, not closed, pixels through the lens.
    pub image: Vec<[f64; 2]>,
}

pub(crate) fn world_point(p: DVec3) -> [f64; 3] {
    p.to_array().map(millionths)
}

pub(crate) fn image_point(p: DVec2) -> [f64; 2] {
    p.to_array().map(hundredths_f64)
}
