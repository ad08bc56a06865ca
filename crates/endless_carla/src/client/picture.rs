//! Pictures of CARLA's cameras as a client reads them.

use super::error::ClientError;
use super::payload::Payload;
use super::subscription::StreamMessage;
use endless_dataset::metres_from_rgb;
use endless_world::{Image, ImageSize};
use std::ops::Range;

/// Width, height and field of view.
const HEADER: usize = 12;

/// A picture of a size: blue, green, red and opacity of every pixel, by rows.
pub(super) struct Picture {
    size: ImageSize,
    payload: Payload,
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
        self.bgra().iter().map(bgr)
    }

    /// Of an instance picture: where there are pixels of the same key one after the other, and that key.
    pub(super) fn runs(&self) -> impl Iterator<Item = (InstanceKey, Range<usize>)> {
        let pixels = self.bgra();
        let mut begin = 0;
        std::iter::from_fn(move || {
            let rest = pixels.get(begin..)?;
            let run = begin..begin + alike(rest);
            begin = run.end;
            Some((InstanceKey::of(bgr(rest.first()?)), run))
        })
    }

    /// Of a depth picture, the depth of a pixel along the optical axis, metres.
    pub(super) fn depth_at(&self, pixel: usize) -> f32 {
        metres(bgr(&self.bgra()[pixel]))
    }

    fn bgra(&self) -> &[[u8; 4]] {
        self.payload[HEADER..].as_chunks().0
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
        Image { size: self.size, data: self.pixels().map(metres).collect() }
    }
}

/// How many of the first pixels are alike, but for opacity.
fn alike(pixels: &[[u8; 4]]) -> usize {
    /// Looked at together.
    const SOME: usize = 16;
    let Some(first) = pixels.first().copied().map(u32::from_le_bytes) else { return 0 };
    let apart = |pixel: &[u8; 4]| (u32::from_le_bytes(*pixel) ^ first) << 8;
    let all = |some: &&[[u8; 4]; SOME]| some.iter().fold(0, |sum, pixel| sum | apart(pixel)) == 0;
    let count = SOME * pixels.as_chunks().0.iter().take_while(all).count();
    count + pixels[count..].iter().take_while(|pixel| apart(pixel) == 0).count()
}

fn bgr(&[b, g, r, _]: &[u8; 4]) -> [u8; 3] {
    [b, g, r]
}

fn metres([b, g, r]: [u8; 3]) -> f32 {
    metres_from_rgb([r, g, b])
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
    use proptest::prelude::*;
    use std::sync::Arc;

    #[test]
    fn pictures_are_read_as_the_server_writes_them() {
        let size = ImageSize { width: 2, height: 1 };
        let mut payload = [2u32.to_le_bytes(), 1u32.to_le_bytes(), 90f32.to_le_bytes()].concat();
        payload.extend([1, 2, 14, 255, 255, 255, 255, 255]);
        let header = SensorHeader { type_id: 1, frame: 1, timestamp: 0.0, transform: Transform::default() };
        let message = |payload: &[u8]| StreamMessage {
            header: header.clone(),
            payload: Payload::new(payload.to_vec(), &Arc::default()),
        };
        let picture = Picture::new(message(&payload), size).unwrap();
        assert_eq!(picture.rgb().data, [[14, 2, 1], [255; 3]]);
        let metres = (14.0 + 2.0 * 256.0 + 65536.0) / 16_777_215.0 * 1000.0;
        assert!((f64::from(picture.depth().data[0]) - metres).abs() < 1e-6 && picture.depth().data[1] == 1000.0);
        assert_eq!(picture.depth_at(1), 1000.0);
        let first = InstanceKey { label: 14, id: 258 };
        let second = InstanceKey { label: 255, id: u16::MAX };
        assert_eq!(picture.runs().collect::<Vec<_>>(), [(first, 0..1), (second, 1..2)]);
        // Opacity does not part what is the same.
        let same = [&payload[..HEADER], &[1, 2, 14, 255, 1, 2, 14, 0]].concat();
        assert_eq!(Picture::new(message(&same), size).unwrap().runs().collect::<Vec<_>>(), [(first, 0..2)]);
        assert!(Picture::new(message(&payload[..19]), size).is_err());
        assert!(Picture::new(message(&payload), ImageSize { width: 1, height: 2 }).is_err());
    }

    proptest! {
        #[test]
        fn runs_are_as_long_as_they_can_be(lengths in prop::collection::vec(1usize..70, 1..9)) {
            let width = lengths.iter().sum::<usize>() as u32;
            let mut payload = [width.to_le_bytes(), 1u32.to_le_bytes(), 90f32.to_le_bytes()].concat();
            for (number, length) in lengths.iter().enumerate() {
                payload.extend([number as u8 % 2, 0, 14, 255].repeat(*length));
            }
            let header = SensorHeader { type_id: 1, frame: 1, timestamp: 0.0, transform: Transform::default() };
            let message = StreamMessage { header, payload: Payload::new(payload, &Arc::default()) };
            let picture = Picture::new(message, ImageSize { width, height: 1 }).unwrap();
            let found: Vec<usize> = picture.runs().map(|(_, run)| run.len()).collect();
            prop_assert_eq!(found, lengths);
            prop_assert!(picture.runs().is_sorted_by(|(_, a), (_, b)| a.end == b.start));
        }
    }
}
