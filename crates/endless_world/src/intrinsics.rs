//! Sizes of pictures, and focal lengths.

use crate::math;
use serde::{Deserialize, Serialize};
use std::{fmt, str::FromStr};

/// Image size in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct ImageSize {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl ImageSize {
    /// Number of pixels.
    pub const fn pixels(self) -> usize {
        self.width as usize * self.height as usize
    }
}

impl fmt::Display for ImageSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

impl FromStr for ImageSize {
    type Err = String;
    fn from_str(given: &str) -> Result<Self, String> {
        let parse = || {
            let (w, h) = given.split_once(['x', 'X'])?;
            Some(Self { width: w.trim().parse().ok()?, height: h.trim().parse().ok()? })
        };
        parse().ok_or_else(|| format!("'{given}' is not a size: write WIDTHxHEIGHT, for example 1280x720"))
    }
}

/// Intrinsics, pixels: focal lengths are pixels of a tangent, of a radian or of a metre, as the [`Lens`](crate::Lens) says.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Intrinsics {
    /// Focal length along x.
    pub fx: f32,
    /// Focal length along y: pixels are square.
    pub fy: f32,
    /// Principal point, x.
    pub cx: f32,
    /// Principal point, y.
    pub cy: f32,
}

impl Intrinsics {
    /// CARLA's rule: `f = W / (2 tan(fov / 2))`, principal point in the middle.
    pub fn from_fov(size: ImageSize, horizontal_fov_rad: f32) -> Self {
        let f = size.width as f32 / (2.0 * math::tan(horizontal_fov_rad / 2.0));
        Self { fx: f, fy: f, cx: size.width as f32 / 2.0, cy: size.height as f32 / 2.0 }
    }
}
