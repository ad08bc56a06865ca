//! PNG and JPEG of RGB images.

use crate::{
    png_encoder::{self, LastPng},
    stored_image::StoredImage,
};
use endless_world::{Image, ImageSize};

/// JPEG quality: hardly visible loss at about 0.35 bytes a pixel.
const JPG_QUALITY: u8 = 92;

/// An 8-bit RGB PNG, made fast.
pub fn encode_png(image: &Image<[u8; 3]>) -> Vec<u8> {
    png_encoder::encode(&image.into(), &LastPng::default())
}

/// A baseline JPEG.
///
/// # Errors
/// When a side is longer than a JPEG can be.
pub fn encode_jpg(image: &Image<[u8; 3]>) -> Result<Vec<u8>, String> {
    let side = |n: u32| u16::try_from(n).map_err(|_too_big| format!("{n} pixels are too many for a JPEG"));
    let mut out = Vec::with_capacity(image.data.len() / 2);
    jpeg_encoder::Encoder::new(&mut out, JPG_QUALITY)
        .encode(
            image.data.as_flattened(),
            side(image.size.width)?,
            side(image.size.height)?,
            jpeg_encoder::ColorType::Rgb,
        )
        .map_err(|e| e.to_string())?;
    Ok(out)
}

/// Longest side of an image that is read: what a damaged header asks for is not allocated.
const LONGEST_SIDE: u32 = 1 << 14;

/// Pixels of an RGB PNG of 8 or 16 bits a channel.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn decode_png(bytes: &[u8]) -> Result<StoredImage<'static>, String> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().map_err(|e| e.to_string())?;
    let info = reader.info();
    let depth = info.bit_depth;
    if info.color_type != png::ColorType::Rgb || !matches!(depth, png::BitDepth::Eight | png::BitDepth::Sixteen) {
        return Err(format!("{:?} {depth:?} instead of 8-bit or 16-bit RGB", info.color_type));
    }
    if info.width.max(info.height) > LONGEST_SIDE {
        return Err(format!("{}x{} pixels: at most {LONGEST_SIDE} a side", info.width, info.height));
    }
    let size = ImageSize { width: info.width, height: info.height };
    let mut decode = |bytes: &mut [u8]| {
        reader.next_frame(bytes).map_err(|e| e.to_string())?;
        // Reads the checksum of the data and the end mark, so that a cut file is noticed.
        reader.finish().map_err(|e| e.to_string())
    };
    Ok(match depth {
        png::BitDepth::Eight => {
            let mut image = Image::filled(size, [0u8; 3]);
            decode(image.data.as_flattened_mut())?;
            image.into()
        }
        _ => {
            let mut bytes = vec![0u8; size.pixels() * 6];
            decode(&mut bytes)?;
            let value = |&[high, low]: &[u8; 2]| u16::from_be_bytes([high, low]);
            let pixel = |bytes: &[u8; 6]| std::array::from_fn(|c| value(&bytes.as_chunks::<2>().0[c]));
            Image { size, data: bytes.as_chunks::<6>().0.iter().map(pixel).collect::<Vec<[u16; 3]>>() }.into()
        }
    })
}

/// Pixels of an RGB JPEG.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn decode_jpg(bytes: &[u8]) -> Result<Image<[u8; 3]>, String> {
    let options = zune_core::options::DecoderOptions::default()
        .set_strict_mode(true)
        .set_max_width(LONGEST_SIDE as usize)
        .set_max_height(LONGEST_SIDE as usize)
        .jpeg_set_out_colorspace(zune_core::colorspace::ColorSpace::RGB);
    let cursor = zune_core::bytestream::ZCursor::new(bytes);
    let mut decoder = zune_jpeg::JpegDecoder::new_with_options(cursor, options);
    // Some of its messages end with a line break.
    let pixels = decoder.decode().map_err(|e| e.to_string().trim_end().to_owned())?;
    let (width, height) = decoder.dimensions().ok_or("no size")?;
    let data = pixels.as_chunks::<3>().0.to_vec();
    Ok(Image { size: ImageSize { width: width as u32, height: height as u32 }, data })
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::Stream;

    fn noise(width: u32, height: u32) -> Image<[u8; 3]> {
        let size = ImageSize { width, height };
        let mut stream = Stream::named(1, "raster test", &[]);
        let data = (0..size.pixels()).map(|_| stream.next_u64().to_le_bytes()[..3].try_into().expect("3")).collect();
        Image { size, data }
    }

    #[test]
    fn a_header_that_asks_for_too_much_is_refused() {
        let mut header = b"IHDR\0\0\x4e\x20\0\0\0\x01\x08\x02\0\0\0".to_vec();
        let checksum = header.iter().fold(u32::MAX, |crc, &byte| {
            (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1)))
        });
        header.extend((!checksum).to_be_bytes());
        let png = [b"\x89PNG\r\n\x1a\n\0\0\0\x0d", &header[..], b"\0\0\0\0IDAT\x35\xaf\x06\x1e"].concat();
        assert_eq!(decode_png(&png), Err("20000x1 pixels: at most 16384 a side".to_owned()));
    }

    #[test]
    fn png_round_trip_at_odd_sizes() {
        for (w, h) in [(1, 1), (3, 2), (17, 31), (641, 363)] {
            let image = noise(w, h);
            assert_eq!(decode_png(&encode_png(&image)), Ok(image.into()));
        }
    }

    #[test]
    fn a_cut_png_is_noticed() {
        let bytes = encode_png(&noise(40, 30));
        for keep in [0, 10, bytes.len() / 2, bytes.len() - 30, bytes.len() - 13] {
            assert!(decode_png(&bytes[..keep]).is_err(), "{keep} of {}", bytes.len());
        }
    }

    #[test]
    fn jpg_is_close() {
        let size = ImageSize { width: 65, height: 43 };
        let data = (0..size.pixels()).map(|i| [(i % 65) as u8 * 3, (i / 65) as u8 * 4, 90]).collect();
        let image = Image { size, data };
        let back = decode_jpg(&encode_jpg(&image).expect("small")).expect("own output");
        assert_eq!(back.size, size);
        let error: u32 =
            image.data.iter().flatten().zip(back.data.iter().flatten()).map(|(a, b)| u32::from(a.abs_diff(*b))).sum();
        assert!(error < 3 * size.pixels() as u32 * 4, "mean error {}", error as f32 / (3 * size.pixels()) as f32);
    }
}
