//! Pictures of CARLA's cameras as a client reads them.

use super::error::ClientError;
use super::subscription::StreamMessage;
use endless_dataset::metres_from_rgb;
use endless_world::{Image, ImageSize};

/// Width, height and field of view.
const HEADER: usize = 12;

/// A picture of a size: blue, green, red and opacity of every pixel, by rows.
pub(super) struct Picture {
    size: ImageSize,
    payload: Vec<u8>,
}

impl Picture {
    /// Of a camera's message.
    ///
    /// # Errors
    /// When it is not of this size.
    pub(super) fn new(message: StreamMessage, size: ImageSize) -> Result<Self, ClientError> {
        let payload = message.payload;
        let number = |at: usize| Some(u32::from_le_bytes(*payload.get(at..)?.first_chunk()?));
        let told = [number(0), number(4)];
        if told != [Some(size.width), Some(size.height)] || payload.len() != HEADER + 4 * size.pixels() {
            return Err(ClientError::Protocol(format!("a camera of {size} sent {} bytes", payload.len())));
        }
        Ok(Self { size, payload })
    }

    /// Blue, green and red of every pixel.
    pub(super) fn pixels(&self) -> impl Iterator<Item = [u8; 3]> {
        self.payload[HEADER..].chunks_exact(4).map(|pixel| [pixel[0], pixel[1], pixel[2]])
    }

    pub(super) fn size(&self) -> ImageSize {
        self.size
    }

    /// As colours.
    pub(super) fn rgb(&self) -> Image<[u8; 3]> {
        Image { size: self.size, data: self.pixels().map(|[b, g, r]| [r, g, b]).collect() }
    }

    /// As depths along the optical axis, metres.
    pub(super) fn depth(&self) -> Image<f32> {
        let metres = |[b, g, r]: [u8; 3]| metres_from_rgb([r, g, b]);
        Image { size: self.size, data: self.pixels().map(metres).collect() }
    }
}

/// What a pixel of an instance picture tells: the number of its class, and the last 16 bits of its object's id.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct InstanceKey {
    pub(super) label: u8,
    pub(super) id: u16,
}

impl InstanceKey {
    pub(super) fn of([b, g, r]: [u8; 3]) -> Self {
        Self { label: r, id: u16::from_le_bytes([g, b]) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stream::SensorHeader;
    use crate::wire::Transform;

    #[test]
    fn pictures_are_read_as_the_server_writes_them() {
        let size = ImageSize { width: 2, height: 1 };
        let mut payload = [2u32.to_le_bytes(), 1u32.to_le_bytes(), 90f32.to_le_bytes()].concat();
        payload.extend([1, 2, 14, 255, 255, 255, 255, 255]);
        let header = SensorHeader { type_id: 1, frame: 1, timestamp: 0.0, transform: Transform::default() };
        let message = |payload: &[u8]| StreamMessage { header: header.clone(), payload: payload.to_vec() };
        let picture = Picture::new(message(&payload), size).unwrap();
        assert_eq!(picture.rgb().data, [[14, 2, 1], [255; 3]]);
        let metres = (14.0 + 2.0 * 256.0 + 65536.0) / 16_777_215.0 * 1000.0;
        assert!((f64::from(picture.depth().data[0]) - metres).abs() < 1e-6 && picture.depth().data[1] == 1000.0);
        assert_eq!(picture.pixels().map(InstanceKey::of).next(), Some(InstanceKey { label: 14, id: 258 }));
        assert!(Picture::new(message(&payload[..19]), size).is_err());
        assert!(Picture::new(message(&payload), ImageSize { width: 1, height: 2 }).is_err());
    }
}
