//! Heat maps as pictures within a page.

use crate::HeatMap;
use endless_dataset::encode_png;
use endless_world::{Image, ImageSize};

/// Colours from none to most, sRGB: ever lighter, so that the map can be read in grey, too (after Matplotlib's viridis).
const COLORS: [[u8; 3]; 6] =
    [[68, 1, 84], [65, 68, 135], [42, 120, 142], [34, 168, 132], [122, 209, 81], [253, 231, 37]];

/// The colour of a share of the most, 0 to 1.
fn color(share: f64) -> [u8; 3] {
    let place = share.clamp(0.0, 1.0) * (COLORS.len() - 1) as f64;
    let low = (place as usize).min(COLORS.len() - 2);
    let between = place - low as f64;
    std::array::from_fn(|i| {
        (f64::from(COLORS[low][i]) * (1.0 - between) + f64::from(COLORS[low + 1][i]) * between).round() as u8
    })
}

/// The map as an address that holds the picture itself.
pub(super) fn png_address(map: &HeatMap) -> String {
    let most = map.counts.iter().copied().max().unwrap_or_default().max(1) as f64;
    // The root shows where few boxes are, too.
    let data = map.counts.iter().map(|count| color((*count as f64 / most).sqrt())).collect();
    address(map.columns, map.rows, data)
}

/// The colours from none to most.
pub(super) fn legend_png() -> String {
    address(64, 1, (0..64).map(|x| color((f64::from(x) / 63.0).sqrt())).collect())
}

fn address(width: usize, height: usize, data: Vec<[u8; 3]>) -> String {
    let size = ImageSize { width: width as u32, height: height as u32 };
    format!("data:image/png;base64,{}", base64(&encode_png(&Image { size, data })))
}

/// RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let word = chunk.iter().fold(0u32, |word, byte| word << 8 | u32::from(*byte)) << (8 * (3 - chunk.len()));
        for digit in 0..4 {
            let bits = word >> (18 - 6 * digit) & 63;
            text.push(if digit <= chunk.len() { char::from(DIGITS[bits as usize]) } else { '=' });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base64_is_that_of_the_standard() {
        let examples = [("", ""), ("M", "TQ=="), ("Ma", "TWE="), ("Man", "TWFu"), ("light work", "bGlnaHQgd29yaw==")];
        for (text, encoded) in examples {
            assert_eq!(base64(text.as_bytes()), encoded);
        }
    }

    #[test]
    fn colours_go_from_dark_to_light() {
        assert_eq!((color(0.0), color(1.0), color(9.0)), (COLORS[0], COLORS[5], COLORS[5]));
        let light = |share: f64| color(share).iter().map(|c| u32::from(*c)).sum::<u32>();
        assert!((0..10).all(|i| light(f64::from(i) / 10.0) < light(f64::from(i + 1) / 10.0) + 40));
    }
}
