//! PNG files of one channel.

use endless_world::{Image, ImageSize};

/// 8 bits a pixel.
pub(crate) fn encode_grey8(image: &Image<u8>) -> Vec<u8> {
    encode(image.size, png::BitDepth::Eight, &image.data)
}

/// 16 bits a pixel.
pub(crate) fn encode_grey16(image: &Image<u16>) -> Vec<u8> {
    let bytes: Vec<u8> = image.data.iter().flat_map(|value| value.to_be_bytes()).collect();
    encode(image.size, png::BitDepth::Sixteen, &bytes)
}

fn encode(size: ImageSize, depth: png::BitDepth, bytes: &[u8]) -> Vec<u8> {
    let mut out = Vec::new();
    let mut encoder = png::Encoder::new(&mut out, size.width, size.height);
    encoder.set_color(png::ColorType::Grayscale);
    encoder.set_depth(depth);
    encoder.set_compression(png::Compression::Fast);
    let mut writer = encoder.write_header().expect("memory takes it");
    writer.write_image_data(bytes).expect("as many bytes as pixels");
    writer.finish().expect("memory takes it");
    out
}
