//! The lens that a camera is asked to have.

use super::{Fisheye, Lens};
use crate::{ImageSize, Intrinsics};
use serde::{Deserialize, Serialize};

/// The lens that a camera is asked to have, written as its name or as a table: `"fisheye"`, or
/// `{ model = "fisheye", k = [0.1, 0, 0, 0] }`. Its field of view is told beside it.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
#[serde(try_from = "WrittenLens", into = "WrittenLens")]
pub enum LensModel {
    /// A perspective lens, which a look may distort.
    #[default]
    Pinhole,
    /// OpenCV's `fisheye`.
    Fisheye {
        /// k1 to k4; all 0 are equidistant.
        k: [f32; 4],
    },
    /// Longitude and latitude.
    Equirectangular,
    /// Parallel rays.
    Orthographic {
        /// Of the picture, metres.
        width_m: f32,
    },
}

/// Width of an orthographic picture where none is given, metres.
const USUAL_WIDTH_M: f32 = 60.0;
/// Fields of view, degrees.
const LEAST_FOV_DEG: f64 = 1.0;

impl LensModel {
    /// The names.
    pub const NAMES: [&str; 4] = ["pinhole", "fisheye", "equirectangular", "orthographic"];

    /// Its name in recipes.
    pub fn name(&self) -> &'static str {
        let place = match self {
            Self::Pinhole => 0,
            Self::Fisheye { .. } => 1,
            Self::Equirectangular => 2,
            Self::Orthographic { .. } => 3,
        };
        Self::NAMES[place]
    }

    /// Whether it is a pinhole.
    pub fn is_pinhole(&self) -> bool {
        *self == Self::Pinhole
    }

    /// Largest horizontal field of view that it can have, degrees.
    pub fn most_fov_deg(&self) -> f64 {
        match self {
            Self::Pinhole | Self::Orthographic { .. } => 150.0,
            Self::Fisheye { .. } => 220.0,
            Self::Equirectangular => 360.0,
        }
    }

    /// The field of view of a lens of which none is given, degrees, where it is not that of a pinhole.
    pub fn usual_fov_deg(&self) -> Option<f64> {
        match self {
            Self::Pinhole | Self::Orthographic { .. } => None,
            Self::Fisheye { .. } => Some(180.0),
            Self::Equirectangular => Some(360.0),
        }
    }

    /// Fails with one line on what cannot be, with this field of view.
    ///
    /// # Errors
    /// When the field of view is too large, a coefficient is none, a fisheye folds back within it, or a width is not
    /// positive.
    pub fn check(&self, fov_deg: f64) -> Result<(), String> {
        let (name, most) = (self.name(), self.most_fov_deg());
        if !(LEAST_FOV_DEG..=most).contains(&fov_deg) {
            return Err(format!("fov is {fov_deg}: write a number from {LEAST_FOV_DEG} to {most} for a {name} lens"));
        }
        match self {
            Self::Fisheye { k } if !k.iter().all(|k| k.is_finite() && k.abs() <= 10.0) => {
                Err(format!("k is {k:?}: write four numbers from -10 to 10"))
            }
            Self::Fisheye { k } => {
                let asked = (fov_deg / 2.0).to_radians() as f32;
                let reached = Fisheye::new(*k, asked).max_angle_rad();
                if reached >= asked {
                    return Ok(());
                }
                let most = (2.0 * f64::from(reached).to_degrees()).floor();
                Err(format!("a fisheye with k {k:?} folds back: write a fov of at most {most}, or other k"))
            }
            Self::Orthographic { width_m } if !(0.1..=10_000.0).contains(width_m) => {
                Err(format!("width is {width_m}: write the picture's width in metres, from 0.1 to 10000"))
            }
            _ => Ok(()),
        }
    }

    /// The lens with this field of view across the picture. Orthographic ones have none.
    pub fn lens(&self, horizontal_fov_rad: f32) -> Lens {
        match self {
            Self::Pinhole => Lens::PINHOLE,
            Self::Fisheye { k } => Lens::Fisheye(Fisheye::new(*k, horizontal_fov_rad / 2.0)),
            Self::Equirectangular => Lens::Equirectangular,
            Self::Orthographic { .. } => Lens::Orthographic,
        }
    }

    /// Focal length and principal point at a size: the field of view, or width, is that of the picture.
    pub fn intrinsics(&self, size: ImageSize, horizontal_fov_rad: f32) -> Intrinsics {
        let width = size.width as f32;
        let f = match (self, self.lens(horizontal_fov_rad)) {
            (Self::Pinhole, _) => return Intrinsics::from_fov(size, horizontal_fov_rad),
            (_, Lens::Fisheye(fisheye)) => 0.5 * width / fisheye.max_radius(),
            (Self::Orthographic { width_m }, _) => width / width_m,
            _ => width / horizontal_fov_rad,
        };
        Intrinsics { fx: f, fy: f, cx: width / 2.0, cy: size.height as f32 / 2.0 }
    }
}

/// A lens as it is written.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(
    untagged,
    expecting = "a lens is \"pinhole\", \"fisheye\", \"equirectangular\", \"orthographic\", or a table such as \
                 { model = \"fisheye\", k = [0.1, 0, 0, 0] } or { model = \"orthographic\", width = 60 }"
)]
enum WrittenLens {
    Name(String),
    Table(LensTable),
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct LensTable {
    model: String,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    k: Option<[f32; 4]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    width: Option<f32>,
}

impl TryFrom<WrittenLens> for LensModel {
    type Error = String;

    fn try_from(written: WrittenLens) -> Result<Self, String> {
        let LensTable { model, k, width } = match written {
            WrittenLens::Name(model) => LensTable { model, k: None, width: None },
            WrittenLens::Table(table) => table,
        };
        let lens = match &*model {
            "pinhole" => Self::Pinhole,
            "fisheye" => Self::Fisheye { k: k.unwrap_or_default() },
            "equirectangular" => Self::Equirectangular,
            "orthographic" => Self::Orthographic { width_m: width.unwrap_or(USUAL_WIDTH_M) },
            _ => return Err(format!("'{model}' is no lens: write one of {}", Self::NAMES.join(", "))),
        };
        if k.is_some() && !matches!(lens, Self::Fisheye { .. }) {
            return Err(format!("a lens that is {model} has no k: leave it out, or write model = \"fisheye\""));
        }
        if width.is_some() && !matches!(lens, Self::Orthographic { .. }) {
            return Err(format!(
                "a lens that is {model} has no width: leave it out, or write model = \"orthographic\""
            ));
        }
        Ok(lens)
    }
}

impl From<LensModel> for WrittenLens {
    fn from(lens: LensModel) -> Self {
        let table = |k, width| Self::Table(LensTable { model: lens.name().to_owned(), k, width });
        match lens {
            LensModel::Fisheye { k } if k != [0.0; 4] => table(Some(k), None),
            LensModel::Orthographic { width_m } => table(None, Some(width_m)),
            _ => Self::Name(lens.name().to_owned()),
        }
    }
}
