//! Names written into pictures.

/// Letters, digits and what else is in names, five columns by seven rows: a row a number, the left column its highest
/// bit. Small letters look like large ones.
const GLYPHS: [(char, [u8; 7]); 38] = [
    ('A', [0b01110, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001]),
    ('B', [0b11110, 0b10001, 0b10001, 0b11110, 0b10001, 0b10001, 0b11110]),
    ('C', [0b01110, 0b10001, 0b10000, 0b10000, 0b10000, 0b10001, 0b01110]),
    ('D', [0b11110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b11110]),
    ('E', [0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b11111]),
    ('F', [0b11111, 0b10000, 0b10000, 0b11110, 0b10000, 0b10000, 0b10000]),
    ('G', [0b01110, 0b10001, 0b10000, 0b10111, 0b10001, 0b10001, 0b01111]),
    ('H', [0b10001, 0b10001, 0b10001, 0b11111, 0b10001, 0b10001, 0b10001]),
    ('I', [0b01110, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110]),
    ('J', [0b00111, 0b00010, 0b00010, 0b00010, 0b00010, 0b10010, 0b01100]),
    ('K', [0b10001, 0b10010, 0b10100, 0b11000, 0b10100, 0b10010, 0b10001]),
    ('L', [0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b10000, 0b11111]),
    ('M', [0b10001, 0b11011, 0b10101, 0b10101, 0b10001, 0b10001, 0b10001]),
    ('N', [0b10001, 0b11001, 0b10101, 0b10101, 0b10011, 0b10001, 0b10001]),
    ('O', [0b01110, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110]),
    ('P', [0b11110, 0b10001, 0b10001, 0b11110, 0b10000, 0b10000, 0b10000]),
    ('Q', [0b01110, 0b10001, 0b10001, 0b10001, 0b10101, 0b10010, 0b01101]),
    ('R', [0b11110, 0b10001, 0b10001, 0b11110, 0b10100, 0b10010, 0b10001]),
    ('S', [0b01111, 0b10000, 0b10000, 0b01110, 0b00001, 0b00001, 0b11110]),
    ('T', [0b11111, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100]),
    ('U', [0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01110]),
    ('V', [0b10001, 0b10001, 0b10001, 0b10001, 0b10001, 0b01010, 0b00100]),
    ('W', [0b10001, 0b10001, 0b10001, 0b10101, 0b10101, 0b11011, 0b10001]),
    ('X', [0b10001, 0b10001, 0b01010, 0b00100, 0b01010, 0b10001, 0b10001]),
    ('Y', [0b10001, 0b10001, 0b01010, 0b00100, 0b00100, 0b00100, 0b00100]),
    ('Z', [0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b10000, 0b11111]),
    ('0', [0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110]),
    ('1', [0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110]),
    ('2', [0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111]),
    ('3', [0b11110, 0b00001, 0b00001, 0b01110, 0b00001, 0b00001, 0b11110]),
    ('4', [0b00010, 0b00110, 0b01010, 0b10010, 0b11111, 0b00010, 0b00010]),
    ('5', [0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110]),
    ('6', [0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110]),
    ('7', [0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000]),
    ('8', [0b01110, 0b10001, 0b10001, 0b01110, 0b10001, 0b10001, 0b01110]),
    ('9', [0b01110, 0b10001, 0b10001, 0b01111, 0b00001, 0b00010, 0b01100]),
    ('_', [0, 0, 0, 0, 0, 0, 0b11111]),
    ('-', [0, 0, 0, 0b11111, 0, 0, 0]),
];

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
        let Some((_, rows)) = GLYPHS.iter().find(|(c, _)| *c == letter.to_ascii_uppercase()) else { continue };
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
        let known = |c: char| GLYPHS.iter().any(|(g, _)| *g == c.to_ascii_uppercase());
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
