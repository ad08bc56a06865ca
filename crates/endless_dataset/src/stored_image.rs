//! Images as they are stored.

use endless_world::{Image, ImageSize};
use std::{borrow::Cow, ops::Range};

/// An image as it is stored: RGB, whatever it means.
#[derive(Debug, Clone, PartialEq)]
pub enum StoredImage<'f> {
    /// 8 bits a channel.
    Rgb8(Cow<'f, Image<[u8; 3]>>),
    /// 16 bits a channel.
    Rgb16(Cow<'f, Image<[u16; 3]>>),
}

impl StoredImage<'_> {
    /// Its size.
    pub fn size(&self) -> ImageSize {
        match self {
            Self::Rgb8(image) => image.size,
            Self::Rgb16(image) => image.size,
        }
    }

    /// Its pixels.
    ///
    /// # Errors
    /// When it has 16 bits a channel.
    pub fn rgb8(&self) -> Result<&Image<[u8; 3]>, String> {
        match self {
            Self::Rgb8(image) => Ok(image),
            Self::Rgb16(_) => Err("has 16 bits a channel instead of 8".into()),
        }
    }

    /// Its pixels.
    ///
    /// # Errors
    /// When it has 8 bits a channel.
    pub fn rgb16(&self) -> Result<&Image<[u16; 3]>, String> {
        match self {
            Self::Rgb16(image) => Ok(image),
            Self::Rgb8(_) => Err("has 8 bits a channel instead of 16".into()),
        }
    }

    /// The same, of its own pixels.
    pub fn into_owned(self) -> StoredImage<'static> {
        match self {
            Self::Rgb8(image) => StoredImage::Rgb8(Cow::Owned(image.into_owned())),
            Self::Rgb16(image) => StoredImage::Rgb16(Cow::Owned(image.into_owned())),
        }
    }

    /// Some rows as PNG has them, byte by byte: the high one of 16 bits first.
    pub(crate) fn rows(&self, rows: Range<usize>) -> Cow<'_, [u8]> {
        match self {
            Self::Rgb8(image) => Cow::Borrowed(image_rows(image, rows)),
            Self::Rgb16(image) => Cow::Owned(image_rows(image, rows).iter().flat_map(|v| v.to_be_bytes()).collect()),
        }
    }

    /// Whether [`Self::rows`] are these bytes.
    pub(crate) fn rows_are(&self, rows: Range<usize>, bytes: &[u8]) -> bool {
        /// Values that are compared without asking in between.
        const PIECE: usize = 1024;
        match self {
            Self::Rgb8(image) => image_rows(image, rows) == bytes,
            Self::Rgb16(image) => {
                let values = image_rows(image, rows);
                let unlike = |(value, bytes): (&u16, &[u8; 2])| value ^ u16::from_be_bytes(*bytes);
                let mut pieces = values.chunks(PIECE).zip(bytes.as_chunks().0.chunks(PIECE));
                2 * values.len() == bytes.len()
                    && pieces.all(|(values, bytes)| {
                        values.iter().zip(bytes).map(unlike).fold(0, |all, bits| all | bits) == 0
                    })
            }
        }
    }

    /// Bytes of a channel.
    pub(crate) fn channel_bytes(&self) -> usize {
        match self {
            Self::Rgb8(_) => 1,
            Self::Rgb16(_) => 2,
        }
    }
}

/// The channels of some rows.
fn image_rows<T>(image: &Image<[T; 3]>, rows: Range<usize>) -> &[T] {
    let width = image.size.width as usize;
    image.data[rows.start * width..rows.end * width].as_flattened()
}

impl From<Image<[u8; 3]>> for StoredImage<'_> {
    fn from(image: Image<[u8; 3]>) -> Self {
        Self::Rgb8(Cow::Owned(image))
    }
}

impl From<Image<[u16; 3]>> for StoredImage<'_> {
    fn from(image: Image<[u16; 3]>) -> Self {
        Self::Rgb16(Cow::Owned(image))
    }
}

impl<'f> From<&'f Image<[u8; 3]>> for StoredImage<'f> {
    fn from(image: &'f Image<[u8; 3]>) -> Self {
        Self::Rgb8(Cow::Borrowed(image))
    }
}

impl<'f> From<&'f Image<[u16; 3]>> for StoredImage<'f> {
    fn from(image: &'f Image<[u16; 3]>) -> Self {
        Self::Rgb16(Cow::Borrowed(image))
    }
}
