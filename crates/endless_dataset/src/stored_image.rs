//! Images as they are stored.

use endless_world::{Image, ImageSize};
use std::borrow::Cow;

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

    /// All bytes, row by row, as PNG has them: the high byte of 16 bits first. If they must be made, there is `room`.
    pub(crate) fn bytes(&self, mut room: Vec<u8>) -> Cow<'_, [u8]> {
        match self {
            Self::Rgb8(image) => Cow::Borrowed(image.data.as_flattened()),
            Self::Rgb16(image) => {
                let values = image.data.as_flattened();
                room.resize(2 * values.len(), 0);
                for (bytes, value) in room.as_chunks_mut::<2>().0.iter_mut().zip(values) {
                    *bytes = value.to_be_bytes();
                }
                Cow::Owned(room)
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
