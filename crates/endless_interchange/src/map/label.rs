//! Names written into pictures.

use endless_world::glyph;

/// Width of a letter with the gap after it, and its height, pixels.
const ADVANCE: usize = 6;
const HEIGHT: usize = 7;
/// From the text to the edge of its ground, pixels.
const EDGE: usize = 2;

/// Writes a name on a dark ground, its upper left corner at a pixel, into rows of `width` pixels. What reaches beyond
/// the right or the lower edge is left out.
pub(super) fn write(pixels: &mut [[u8; 3]], width: usize, [left, top]: [usize; 2], name: &str) {
    let mut set = |x: usize, y: usize, color: [u8; 3]| {
        if let Some(pixel) = pixels.get_mut(y * width + x).filter(|_| x < width) {
            *pixel = color;
        }
    };
    let letters = name.chars().count();
    for y in 0..HEIGHT + 2 * EDGE {
        for x in 0..letters * ADVANCE - usize::from(letters > 0) + 2 * EDGE {
            set(left + x, top + y, [18, 18, 20]);
        }
    }
    for (n, letter) in name.chars().enumerate() {
        let Some(rows) = glyph(letter) else { continue };
        for (y, row) in rows.iter().enumerate() {
            for x in (0..5).filter(|x| row >> (4 - x) & 1 == 1) {
                set(left + EDGE + n * ADVANCE + x, top + EDGE + y, [240; 3]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_cameras_can_be_written() {
        let known = |c: char| glyph(c).is_some();
        assert!(
            "junction_northwest_2 square crossing highway wall rural park Town10HD"
                .replace(' ', "_")
                .chars()
                .all(known)
        );
    }

    #[test]
    fn what_does_not_fit_is_left_out() {
        let mut pixels = vec![[90; 3]; 30 * 12];
        write(&mut pixels, 30, [20, 5], "ABC");
        assert!(pixels.contains(&[240; 3]));
        // Nothing runs on at the left edge of the next row.
        assert!((0..12).all(|y| pixels[y * 30] == [90; 3]));
        write(&mut pixels, 30, [0, 11], "");
    }
}
