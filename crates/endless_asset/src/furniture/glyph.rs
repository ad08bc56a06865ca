//! Letters and figures as strokes, for sign faces.

use crate::Material;
use crate::shape::Sculpt;
use glam::{Vec2, Vec3};

/// Strokes of a character in a box of width 1 and height 2, as chains of points.
fn strokes(c: char) -> &'static [&'static [(f32, f32)]] {
    match c {
        'S' => &[&[
            (0.95, 1.75),
            (0.7, 2.0),
            (0.3, 2.0),
            (0.05, 1.75),
            (0.05, 1.35),
            (0.3, 1.05),
            (0.7, 0.95),
            (0.95, 0.65),
            (0.95, 0.25),
            (0.7, 0.0),
            (0.3, 0.0),
            (0.05, 0.25),
        ]],
        'T' => &[&[(0.0, 2.0), (1.0, 2.0)], &[(0.5, 2.0), (0.5, 0.0)]],
        'O' | '0' => &[&[
            (0.3, 0.0),
            (0.7, 0.0),
            (0.95, 0.35),
            (0.95, 1.65),
            (0.7, 2.0),
            (0.3, 2.0),
            (0.05, 1.65),
            (0.05, 0.35),
            (0.3, 0.0),
        ]],
        'P' => &[&[(0.05, 0.0), (0.05, 2.0), (0.7, 2.0), (0.95, 1.75), (0.95, 1.25), (0.7, 1.0), (0.05, 1.0)]],
        'B' => &[&[
            (0.05, 1.0),
            (0.05, 2.0),
            (0.7, 2.0),
            (0.9, 1.75),
            (0.9, 1.25),
            (0.7, 1.0),
            (0.05, 1.0),
            (0.05, 0.0),
            (0.7, 0.0),
            (0.95, 0.3),
            (0.95, 0.75),
            (0.7, 1.0),
        ]],
        'U' => &[&[(0.05, 2.0), (0.05, 0.3), (0.3, 0.0), (0.7, 0.0), (0.95, 0.3), (0.95, 2.0)]],
        '3' => &[&[
            (0.05, 1.75),
            (0.3, 2.0),
            (0.7, 2.0),
            (0.95, 1.7),
            (0.95, 1.3),
            (0.7, 1.05),
            (0.4, 1.0),
            (0.7, 0.95),
            (0.95, 0.7),
            (0.95, 0.3),
            (0.7, 0.0),
            (0.3, 0.0),
            (0.05, 0.25),
        ]],
        '4' => &[&[(0.75, 0.0), (0.75, 2.0), (0.0, 0.6), (1.0, 0.6)]],
        '5' => &[&[
            (0.95, 2.0),
            (0.1, 2.0),
            (0.05, 1.1),
            (0.6, 1.2),
            (0.95, 0.9),
            (0.95, 0.3),
            (0.65, 0.0),
            (0.3, 0.0),
            (0.05, 0.2),
        ]],
        _ => &[],
    }
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
        for chain in strokes(c) {
            let place = |(u, v): (f32, f32)| Vec2::new(left + pitch * i as f32 + u * width, (v - 1.0) * unit);
            for pair in chain.windows(2) {
                line(&mut s, centre, place(pair[0]), place(pair[1]), stroke, material);
            }
        }
    }
    s
}

/// A flat bar on a face looking towards +x between two points (y, z) of it.
pub(crate) fn line(s: &mut Sculpt, centre: Vec3, a: Vec2, b: Vec2, stroke: f32, material: Material) {
    let along = (b - a).normalize_or(Vec2::X) * stroke * 0.4;
    let (a, b) = (a - along, b + along);
    let across = along.perp().normalize_or(Vec2::Y) * stroke * 0.5;
    let corner = |p: Vec2| centre + Vec3::new(0.0, p.x, p.y);
    s.quad([corner(a - across), corner(b - across), corner(b + across), corner(a + across)], material);
}
