//! The file formats of images: one entry each.

use crate::{
    DatasetError,
    png_encoder::{self, LastPng},
    raster::{decode_jpg, decode_png, encode_jpg},
    stored_image::StoredImage,
};
use endless_world::{CameraLookChoice, UnknownName};
use std::{fs, path::Path};
use strum::VariantArray as _;

/// File format of the RGB layer. The others are always PNG, because they must be exact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum RgbFormat {
    /// Lossless.
    Png,
    /// A quarter of the size, lossy.
    Jpg,
}

impl RgbFormat {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The word used on the command line and in files.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("RGB format", given, Self::ALL)
    }
}

/// All that is to be known of a file format.
#[derive(Debug, Clone, Copy)]
pub struct RgbFormatEntry {
    /// Whether it is lossless.
    pub exact: bool,
    /// The bytes of a file, or why the image cannot be stored so. They do not depend on the camera's last image, but what is
    /// as it was there takes no time.
    pub encode: fn(&StoredImage<'_>, &LastPng) -> Result<Vec<u8>, String>,
    /// The image of a file, or what is wrong with its bytes.
    pub decode: fn(&[u8]) -> Result<StoredImage<'static>, String>,
    /// Bytes a pixel of the RGB layer, a tenth above the dearest scene measured.
    pub rgb_bytes_a_pixel: fn(CameraLookChoice) -> f64,
}

impl RgbFormat {
    /// The format's entry.
    pub const fn entry(self) -> &'static RgbFormatEntry {
        match self {
            Self::Png => &PNG,
            Self::Jpg => &JPG,
        }
    }
}

// Noise does not compress: a little of it adds a bit or three a value, much of it all there is.

const PNG: RgbFormatEntry = RgbFormatEntry {
    exact: true,
    encode: |image, last| Ok(png_encoder::encode(image, last)),
    decode: decode_png,
    rgb_bytes_a_pixel: |look| match look {
        CameraLookChoice::Natural => 2.1,
        CameraLookChoice::Clean => 1.2,
        _ => 3.01,
    },
};

const JPG: RgbFormatEntry = RgbFormatEntry {
    exact: false,
    encode: |image, _| encode_jpg(image.rgb8()?),
    decode: |bytes| Ok(decode_jpg(bytes)?.into()),
    rgb_bytes_a_pixel: |look| match look {
        CameraLookChoice::Clean => 0.35,
        _ => 0.9,
    },
};

/// Reads an image file of the dataset.
///
/// # Errors
/// When it cannot be read or decoded.
pub fn read_rgb(path: &Path, format: RgbFormat) -> Result<StoredImage<'static>, DatasetError> {
    let bytes = fs::read(path).map_err(|e| DatasetError::io("cannot read", path, e))?;
    (format.entry().decode)(&bytes)
        .map_err(|reason| DatasetError::malformed(path, format!("does not decode ({reason})")))
}
