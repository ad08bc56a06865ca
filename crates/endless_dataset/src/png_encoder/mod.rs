//! PNG (ISO/IEC 15948) of RGB images, of 8 or 16 bits a channel, of which most is as it was in the image before.
//!
//! Rows are compressed in bands that know nothing of each other: a band of the same pixels has the same bytes in every
//! file, and those of the last image are written again. What is written depends on the image alone.
//!
//! ```text
//! signature  IHDR  IDAT (zlib header)  IDAT (band)  IDAT (band) …  IDAT (end, Adler-32)  IEND
//! ```

mod deflate;
mod filter;
mod huffman;

use crate::stored_image::StoredImage;
use endless_world::ImageSize;
use std::{
    borrow::Cow,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

/// Rows of a band: 64 KiB of a 720p image, twice what a deflate window reaches.
const ROWS: usize = 16;

/// After so many images without a band of the one before, no more are remembered.
const NEVER_THE_SAME: u32 = 4;

/// The image of a camera's layer that was encoded last.
#[derive(Debug, Default)]
pub struct LastPng(Mutex<Memory>);

#[derive(Debug, Default)]
struct Memory {
    last: Option<EncodedImage>,
    /// How many images one after the other had no band of the one before.
    all_new: u32,
}

#[derive(Debug, Clone)]
struct EncodedImage {
    layout: RowLayout,
    bands: Vec<Arc<Band>>,
}

impl Memory {
    /// The sensor's noise is new in each.
    fn is_of_use(&self) -> bool {
        self.all_new < NEVER_THE_SAME
    }
}

impl LastPng {
    fn memory(&self) -> MutexGuard<'_, Memory> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The last image, if it lay like this; and whether the next is to be remembered.
    fn before(&self, layout: RowLayout) -> (Option<EncodedImage>, bool) {
        let memory = self.memory();
        (memory.last.clone().filter(|before| before.layout == layout), memory.is_of_use())
    }

    /// Remembers an image, of which so many bands were as in the one before, if there was one.
    fn remember(&self, image: EncodedImage, same: Option<usize>) {
        let mut memory = self.memory();
        memory.all_new = match same {
            Some(0) => memory.all_new + 1,
            Some(_) => 0,
            None => memory.all_new,
        };
        memory.last = memory.is_of_use().then_some(image);
    }
}

/// How the bytes of an image lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct RowLayout {
    size: ImageSize,
    /// Bytes of a channel, of which a pixel has three.
    channel_bytes: usize,
}

impl RowLayout {
    fn row_bytes(self) -> usize {
        self.size.width as usize * 3 * self.channel_bytes
    }
}

/// Compressed rows.
#[derive(Debug)]
struct Band {
    /// Before they were filtered, if they are to be remembered.
    rows: Vec<u8>,
    /// A whole IDAT chunk.
    chunk: Vec<u8>,
    /// Of the filtered rows, and how many bytes they have.
    adler: u32,
    length: usize,
}

/// The image as a PNG file; its bytes do not depend on `last`.
pub(crate) fn encode(image: &StoredImage<'_>, last: &LastPng) -> Vec<u8> {
    let layout = RowLayout { size: image.size(), channel_bytes: image.channel_bytes() };
    let (before, remembered) = last.before(layout);
    let height = layout.size.height as usize;
    let mut buffers = BandBuffers::default();
    let mut same_bands = 0;
    let band = |(number, start): (usize, usize)| {
        let rows = start..height.min(start + ROWS);
        let known = before.as_ref().map(|before| &before.bands[number]);
        if let Some(same) = known.filter(|band| image.rows_are(rows.clone(), &band.rows)) {
            same_bands += 1;
            return Arc::clone(same);
        }
        Arc::new(buffers.band(image.rows(rows), layout, remembered))
    };
    let bands: Vec<Arc<Band>> = (0..height).step_by(ROWS).enumerate().map(band).collect();
    let file = file(layout, &bands);
    last.remember(EncodedImage { layout, bands }, before.map(|_| same_bands));
    file
}

#[derive(Default)]
struct BandBuffers {
    filtered: Vec<u8>,
    data: Vec<u8>,
    deflate: deflate::Buffers,
}

impl BandBuffers {
    fn band(&mut self, rows: Cow<'_, [u8]>, layout: RowLayout, remembered: bool) -> Band {
        self.filtered.clear();
        match layout.channel_bytes {
            1 => filter::rows::<3>(&rows, layout.row_bytes(), &mut self.filtered),
            _ => filter::rows::<6>(&rows, layout.row_bytes(), &mut self.filtered),
        }
        self.data.clear();
        self.deflate.compress(&self.filtered, &mut self.data);
        let mut chunk = Vec::with_capacity(self.data.len() + 12);
        push_chunk(&mut chunk, *b"IDAT", &self.data);
        let adler = simd_adler32::adler32(&self.filtered.as_slice());
        let rows = if remembered { rows.into_owned() } else { Vec::new() };
        Band { rows, chunk, adler, length: self.filtered.len() }
    }
}

fn file(layout: RowLayout, bands: &[Arc<Band>]) -> Vec<u8> {
    /// Deflate with a window of 32 KiB, made fast.
    const ZLIB_HEADER: [u8; 2] = [0x78, 0x01];
    const RGB: [u8; 4] = [2, 0, 0, 0];
    let length: usize = bands.iter().map(|band| band.chunk.len()).sum();
    let mut out = Vec::with_capacity(length + 96);
    out.extend(b"\x89PNG\r\n\x1a\n");
    let [width, height] = [layout.size.width, layout.size.height].map(u32::to_be_bytes);
    push_chunk(&mut out, *b"IHDR", &[&width[..], &height, &[8 * layout.channel_bytes as u8], &RGB].concat());
    push_chunk(&mut out, *b"IDAT", &ZLIB_HEADER);
    let mut adler = 1;
    for band in bands {
        out.extend(&band.chunk);
        adler = adler_of_both(adler, band.adler, band.length);
    }
    push_chunk(&mut out, *b"IDAT", &[&deflate::END[..], &adler.to_be_bytes()].concat());
    push_chunk(&mut out, *b"IEND", &[]);
    out
}

fn push_chunk(out: &mut Vec<u8>, kind: [u8; 4], data: &[u8]) {
    let length = u32::try_from(data.len()).expect("a band is far smaller than 4 GiB");
    out.extend(length.to_be_bytes());
    let start = out.len();
    out.extend(kind);
    out.extend(data);
    out.extend(crc32fast::hash(&out[start..]).to_be_bytes());
}

/// Adler-32 (RFC 1950) of two pieces of data, of which the second has `length` bytes.
fn adler_of_both(first: u32, second: u32, length: usize) -> u32 {
    const MODULUS: u64 = 65_521;
    let [a1, a2] = [first, second].map(|adler| u64::from(adler & 0xffff));
    let [b1, b2] = [first, second].map(|adler| u64::from(adler >> 16));
    let length = length as u64 % MODULUS;
    let a = (a1 + a2 + MODULUS - 1) % MODULUS;
    let b = (b1 + b2 + length * (a1 + MODULUS - 1)) % MODULUS;
    (b << 16 | a) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::decode_png;
    use endless_world::{Image, ImageSize};
    use proptest::prelude::*;

    #[test]
    fn checksums_of_parts_are_that_of_the_whole() {
        let data: Vec<u8> = (0..100_000u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 7) as u8).collect();
        let whole = simd_adler32::adler32(&data.as_slice());
        for cut in [0, 1, 40_000, 65_521, 99_999, 100_000] {
            let [first, second] = [&data[..cut], &data[cut..]].map(|part| simd_adler32::adler32(&part));
            assert_eq!(adler_of_both(first, second, data.len() - cut), whole);
        }
    }

    /// Pictures of smooth parts, flat parts and noise, of some size.
    fn pictures() -> impl Strategy<Value = [StoredImage<'static>; 2]> {
        let size = (1u32..70, 1u32..50).prop_map(|(width, height)| ImageSize { width, height });
        let deep = any::<bool>();
        (size, any::<u32>(), 0u32..9, any::<prop::sample::Index>(), deep).prop_map(
            |(size, seed, kinds, changed, deep)| {
                let value = |i: u32| match i / 300 % 3 * kinds {
                    0 | 8 => 7,
                    2 | 6 => (i ^ seed) as u8 >> 2,
                    _ => (i.wrapping_mul(seed | 1).rotate_left(9) >> 13) as u8,
                };
                let data: Vec<[u8; 3]> =
                    (0..size.pixels() as u32).map(|i| [0, 1, 2].map(|c| value(3 * i + c))).collect();
                let mut other = data.clone();
                other[changed.index(data.len())][1] ^= 64;
                [data, other].map(|data| {
                    let wide = |pixel: &[u8; 3]| pixel.map(|value| u16::from(value).wrapping_mul(0x0b21));
                    match deep {
                        true => Image { size, data: data.iter().map(wide).collect() }.into(),
                        false => Image { size, data }.into(),
                    }
                })
            },
        )
    }

    proptest! {
        #[test]
        fn what_is_written_is_read_and_does_not_depend_on_the_last_image([first, second] in pictures()) {
            let last = LastPng::default();
            for image in [&first, &second, &second, &first] {
                let bytes = encode(image, &last);
                prop_assert_eq!(&decode_png(&bytes).expect("own output"), image);
                prop_assert_eq!(bytes, encode(image, &LastPng::default()));
            }
        }
    }
}
