//! Letters and figures as strokes, for sign faces.

use crate::shape::Sculpt;
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// Strokes of a character, `/` between them: pairs of digits are points on a grid of 8 by 8 over a box of width 1 and
/// height 2.
fn strokes(c: char) -> &'static str {
    match c.to_ascii_uppercase() {
        'A' => "00 48 80/13 73",
        'B' => "04 08 58 77 75 54 04 00 60 82 83 64 54",
        'C' => "87 68 28 06 02 20 60 81",
        'D' => "00 08 48 86 82 40 00",
        'E' => "80 00 08 88/04 64",
        'F' => "00 08 88/04 64",
        'G' => "87 68 28 06 02 20 60 82 84 54",
        'H' => "00 08/80 88/04 84",
        'I' => "40 48",
        'J' => "02 20 40 62 68",
        'K' => "00 08/88 03/35 80",
        'L' => "08 00 80",
        'M' => "00 08 44 88 80",
        'N' => "00 08 80 88",
        'O' | '0' => "20 60 82 86 68 28 06 02 20",
        'P' => "00 08 68 87 85 64 04",
        'Q' => "20 60 82 86 68 28 06 02 20/53 80",
        'R' => "00 08 68 87 85 64 04/44 80",
        'S' => "87 68 28 07 05 24 64 83 81 60 20 01",
        'T' => "08 88/48 40",
        'U' => "08 02 20 60 82 88",
        'V' => "08 40 88",
        'W' => "08 20 46 60 88",
        'X' => "00 88/08 80",
        'Y' => "08 44 88/44 40",
        'Z' => "08 88 00 80",
        '1' => "16 48 40/20 60",
        '2' => "06 28 68 86 85 00 80",
        '3' => "07 28 68 87 85 64 34/64 83 81 60 20 01",
        '4' => "60 68 02 82",
        '5' => "88 18 14 64 83 81 60 20 01",
        '6' => "87 68 28 06 02 20 60 82 83 64 24 03",
        '7' => "08 88 30",
        '8' => "24 05 07 28 68 87 85 64 24 03 01 20 60 81 83 64",
        '9' => "01 20 60 82 86 68 28 06 05 24 64 85",
        '-' => "24 64",
        '!' => "48 43/41 40",
        _ => "",
    }
}

/// A point of the grid in a box of width 1 and height 2.
fn point(pair: &str) -> Option<Vec2> {
    let mut digits = pair.chars().filter_map(|c| c.to_digit(10)).map(|d| d as f32);
    Some(Vec2::new(digits.next()? / 8.0, digits.next()? / 4.0))
}

/// Text on a vertical face looking towards +x, as raised strokes; who reads it has +y on the right.
pub(crate) fn text(words: &str, centre: Vec3, height: f32, stroke: f32, material: Material) -> Sculpt {
    let unit = 0.5 * height;
    let width = 0.78 * unit;
    let pitch = width + 2.0 * stroke;
    let count = words.chars().count() as f32;
    let left = -0.5 * (pitch * count - 2.0 * stroke);
    let mut s = Sculpt::new();
    for (i, c) in words.chars().enumerate() {
        for chain in strokes(c).split('/') {
            let place = |p: Vec2| Vec2::new(left + pitch * i as f32 + p.x * width, (p.y - 1.0) * unit);
            let points: Vec<Vec2> = chain.split(' ').filter_map(point).map(place).collect();
            for pair in points.windows(2) {
                line(&mut s, centre, pair[0], pair[1], stroke, material);
            }
        }
    }
    s
}

/// How wide such a text is.
pub(crate) fn text_width(words: &str, height: f32, stroke: f32) -> f32 {
    (0.39 * height + 2.0 * stroke) * words.chars().count() as f32 - 2.0 * stroke
}

/// A flat bar on a face looking towards +x between two points (y, z) of it.
pub(crate) fn line(s: &mut Sculpt, centre: Vec3, a: Vec2, b: Vec2, stroke: f32, material: Material) {
    let along = (b - a).normalize_or(Vec2::X) * stroke * 0.4;
    let (a, b) = (a - along, b + along);
    let across = along.perp().normalize_or(Vec2::Y) * stroke * 0.5;
    let corner = |p: Vec2| centre + Vec3::new(0.0, p.x, p.y);
    s.quad([corner(a - across), corner(b - across), corner(b + across), corner(a + across)], material);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_and_figure_is_drawn_within_its_box() {
        for c in ('A'..='Z').chain('0'..='9') {
            let points: Vec<Vec2> = strokes(c).split(['/', ' ']).filter_map(point).collect();
            assert!(points.len() >= 2, "{c}");
            assert!(points.iter().all(|p| (0.0..=1.0).contains(&p.x) && (0.0..=2.0).contains(&p.y)), "{c}");
            assert_eq!(strokes(c), strokes(c.to_ascii_lowercase()));
        }
    }
}
