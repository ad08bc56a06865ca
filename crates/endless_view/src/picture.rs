//! Images of layers as people look at them: in colour, or small.

use crate::depth_color::depth_in_color;
use endless_dataset::{Layer, RgbFormat, encode_jpg, encode_png};
use endless_world::{Image, ImageSize};

/// Width of small pictures.
const SMALL_WIDTH: u32 = 480;

/// The image of a layer in colour, as a PNG.
pub(crate) fn in_color(bytes: &[u8], layer: Layer, format: RgbFormat) -> Result<Vec<u8>, String> {
    let stored = (layer.format(format).entry().decode)(bytes)?;
    if layer == Layer::Depth {
        return Ok(encode_png(&depth_in_color(stored.rgb8()?)));
    }
    let shown = (layer.entry().preview)(&stored)?;
    Ok(encode_png(&shown))
}

/// The image of a layer, small, as a JPEG.
pub(crate) fn small(bytes: &[u8], layer: Layer, format: RgbFormat) -> Result<Vec<u8>, String> {
    let stored = (layer.format(format).entry().decode)(bytes)?;
    let shown = (layer.entry().preview)(&stored)?;
    encode_jpg(&shrunk(&shown))
}

/// The mean of whole blocks of pixels, so that the picture is no wider than it need be.
fn shrunk(image: &Image<[u8; 3]>) -> Image<[u8; 3]> {
    let block = image.size.width.div_ceil(SMALL_WIDTH).max(1);
    let size = ImageSize { width: (image.size.width / block).max(1), height: (image.size.height / block).max(1) };
    let (columns, rows) = (block.min(image.size.width), block.min(image.size.height));
    let mut data = Vec::with_capacity(size.pixels());
    for y in 0..size.height {
        for x in 0..size.width {
            let mut sums = [0u32; 3];
            for row in 0..rows {
                let begin = ((y * block + row) * image.size.width + x * block) as usize;
                for pixel in &image.data[begin..begin + columns as usize] {
                    for (sum, value) in sums.iter_mut().zip(pixel) {
                        *sum += u32::from(*value);
                    }
                }
            }
            data.push(sums.map(|sum| (sum / (columns * rows)) as u8));
        }
    }
    Image { size, data }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_pictures_are_means_of_whole_blocks() {
        for (width, height, expected) in
            [(1280, 720, (426, 240)), (480, 3, (480, 3)), (961, 1, (320, 1)), (1, 1, (1, 1))]
        {
            let size = ImageSize { width, height };
            let small = shrunk(&Image::filled(size, [10, 200, 255]));
            assert_eq!((small.size.width, small.size.height), expected);
            assert!(small.data.iter().all(|pixel| *pixel == [10, 200, 255]));
        }
        let data = vec![[0, 0, 0], [100, 2, 4], [50, 2, 2], [50, 0, 2]];
        let image = Image { size: ImageSize { width: 2, height: 2 }, data };
        assert_eq!(shrunk(&image), image, "narrow enough");
    }
}
