//! The file formats of images.

use crate::words::words;

words! {
    /// How the RGB layer is stored. The others are always PNG: they must be exact.
    RgbFormat, "RGB format",
    /// Lossless.
    Png = "png",
    /// A quarter of the size, lossy.
    Jpg = "jpg",
}
