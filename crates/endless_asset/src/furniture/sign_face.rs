//! Faces of traffic signs by their codes: of the Vienna Convention (`C,1`) and of the MUTCD (`R5-1`).

use super::glyph::line;
use super::paint;
use super::sign::{FRONT, LAYER, post, regular};
use crate::shape::Sculpt;
use endless_scene::{Material, Mesh};
use endless_world::math;
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_4, PI, TAU};

const YELLOW: Material = paint::face([0.72, 0.44, 0.01]);
const LIME: Material = paint::face([0.52, 0.62, 0.03]);
const ORANGE: Material = paint::face([0.75, 0.20, 0.01]);
const GREEN: Material = paint::face([0.010, 0.18, 0.07]);
const HEIGHT_M: f32 = 2.4;

/// A face under construction: each film lies over the last.
struct SignFace {
    sculpt: Sculpt,
    z: f32,
    layer: f32,
}

fn rectangle(half: Vec2) -> Vec<Vec2> {
    [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec2::new(x, y) * half).to_vec()
}

fn disc(radius: f32) -> Vec<Vec2> {
    regular(32, radius, 0.0)
}

fn moved(outline: &[Vec2], by: Vec2) -> Vec<Vec2> {
    outline.iter().map(|p| *p + by).collect()
}

fn turned(p: Vec2, angle: f32) -> Vec2 {
    let (sin, cos) = math::sin_cos(angle);
    Vec2::new(cos, sin).rotate(p)
}

impl SignFace {
    fn on(outline: &[Vec2], color: Material) -> Self {
        Self::at(HEIGHT_M, outline, color)
    }

    fn at(z: f32, outline: &[Vec2], color: Material) -> Self {
        let top = outline.iter().map(|p| p.y).fold(0.0, f32::max);
        let mut sculpt = post(z + 0.8 * top);
        super::sign::plate(&mut sculpt, outline, z, color);
        Self { sculpt, z, layer: 1.0 }
    }

    /// One more film of a convex outline.
    fn film(mut self, outline: &[Vec2], color: Material) -> Self {
        super::sign::film(&mut self.sculpt, outline, self.z, self.layer, color);
        self.layer += 1.0;
        self
    }

    /// Bars of one colour between points.
    fn bars(mut self, bars: &[[(f32, f32); 2]], width: f32, color: Material) -> Self {
        let centre = Vec3::new(FRONT + self.layer * LAYER, 0.0, self.z);
        for &[a, b] in bars {
            line(&mut self.sculpt, centre, Vec2::from(a), Vec2::from(b), width, color);
        }
        self.layer += 1.0;
        self
    }

    fn chain(self, points: &[(f32, f32)], width: f32, color: Material) -> Self {
        let bars: Vec<[(f32, f32); 2]> = points.windows(2).map(|w| [w[0], w[1]]).collect();
        self.bars(&bars, width, color)
    }

    /// A shaft with a head at its end.
    fn arrow(self, from: (f32, f32), to: (f32, f32), width: f32, color: Material) -> Self {
        let (a, b) = (Vec2::from(from), Vec2::from(to));
        let along = (b - a).normalize_or(Vec2::Y);
        let (back, side) = (b - along * width * 2.2, along.perp() * width * 1.7);
        self.bars(&[[from, back.into()]], width, color).film(&[back - side, b, back + side], color)
    }

    fn words(mut self, lines: &[(&str, f32)], height: f32, color: Material) -> Self {
        for &(words, z) in lines {
            let centre = Vec3::new(FRONT + self.layer * LAYER, 0.0, self.z + z);
            self.sculpt.add(super::glyph::text(words, centre, height, height * 0.17, color));
        }
        self.layer += 1.0;
        self
    }

    /// A walking figure about 0.3 m high.
    fn walker(self, at: Vec2, color: Material) -> Self {
        let p = |x: f32, y: f32| (at.x + x, at.y + y);
        self.bars(&[[p(0.0, 0.04), p(0.0, -0.05)]], 0.055, color)
            .bars(&[[p(0.0, -0.05), p(0.055, -0.16)], [p(0.0, -0.05), p(-0.06, -0.15)]], 0.03, color)
            .bars(&[[p(0.0, 0.04), p(0.075, -0.03)], [p(0.0, 0.04), p(-0.075, -0.03)]], 0.024, color)
            .film(&moved(&regular(12, 0.032, 0.0), at + Vec2::new(0.0, 0.105)), color)
    }
}

/// A red-rimmed triangle, tip up.
fn warning() -> SignFace {
    SignFace::on(&regular(3, 0.50, 0.0), paint::RED).film(&regular(3, 0.335, 0.0), paint::WHITE)
}

/// A yellow or orange diamond with a black border.
fn diamond(color: Material) -> SignFace {
    SignFace::on(&regular(4, 0.53, 0.0), color)
        .film(&regular(4, 0.50, 0.0), paint::BLACK)
        .film(&regular(4, 0.475, 0.0), color)
}

fn blue_disc() -> SignFace {
    SignFace::on(&disc(0.32), paint::WHITE).film(&disc(0.305), paint::BLUE)
}

fn board(width: f32, height: f32, rim: Material, color: Material) -> SignFace {
    let half = Vec2::new(0.5 * width, 0.5 * height);
    SignFace::on(&rectangle(half), rim).film(&rectangle(half - 0.018), color)
}

fn no_parking(crossed: bool) -> SignFace {
    let d = 0.18;
    let face = SignFace::on(&disc(0.32), paint::RED).film(&disc(0.255), paint::BLUE);
    let face = face.bars(&[[(-d, d), (d, -d)]], 0.055, paint::RED);
    if crossed { face.bars(&[[(-d, -d), (d, d)]], 0.055, paint::RED) } else { face }
}

fn roundabout() -> SignFace {
    let mut face = blue_disc();
    for k in 0..3 {
        let turn = TAU * k as f32 / 3.0;
        let arc: Vec<(f32, f32)> = (0..6).map(|i| turned(Vec2::X * 0.18, turn - 0.26 * i as f32).into()).collect();
        let end = Vec2::from(arc[5]);
        let along = turned(Vec2::NEG_Y, turn - 1.3);
        let side = along.perp() * 0.062;
        face = face.chain(&arc, 0.045, paint::WHITE).film(&[end - side, end + along * 0.10, end + side], paint::WHITE);
    }
    face
}

fn cycle_path() -> SignFace {
    let ring = |x: f32| -> Vec<(f32, f32)> {
        (0..=12).map(|i| (turned(Vec2::X * 0.075, TAU * i as f32 / 12.0) + Vec2::new(x, -0.06)).into()).collect()
    };
    blue_disc()
        .chain(&ring(-0.125), 0.018, paint::WHITE)
        .chain(&ring(0.125), 0.018, paint::WHITE)
        .chain(&[(-0.125, -0.06), (-0.05, 0.06), (0.08, 0.06), (0.0, -0.06), (-0.125, -0.06)], 0.02, paint::WHITE)
        .bars(&[[(0.125, -0.06), (0.06, 0.12)], [(0.02, 0.12), (0.10, 0.12)]], 0.02, paint::WHITE)
        .bars(&[[(-0.05, 0.06), (-0.065, 0.09)], [(-0.10, 0.09), (-0.03, 0.09)]], 0.02, paint::WHITE)
}

/// A figure at a heap.
fn digger(face: SignFace) -> SignFace {
    face.walker(Vec2::new(-0.04, -0.03), paint::BLACK)
        .film(&[Vec2::new(0.03, -0.20), Vec2::new(0.17, -0.20), Vec2::new(0.10, -0.10)], paint::BLACK)
        .bars(&[[(0.0, 0.02), (0.11, -0.12)]], 0.016, paint::BLACK)
}

fn lights(face: SignFace, size: f32) -> SignFace {
    let mut face = face.film(&rectangle(Vec2::new(0.07, 0.19) * size), paint::BLACK);
    for (y, color) in [(0.12, paint::RED), (0.0, YELLOW), (-0.12, GREEN)] {
        face = face.film(&moved(&regular(14, 0.045 * size, 0.0), Vec2::new(0.0, y * size)), color);
    }
    face
}

fn bend(face: SignFace) -> SignFace {
    face.chain(&[(-0.09, -0.20), (-0.09, -0.06), (0.05, 0.05)], 0.05, paint::BLACK).arrow(
        (0.05, 0.05),
        (0.05, 0.17),
        0.05,
        paint::BLACK,
    )
}

fn speed_limit_mph() -> SignFace {
    board(0.61, 0.76, paint::BLACK, paint::WHITE).words(&[("SPEED", 0.25), ("LIMIT", 0.11)], 0.11, paint::BLACK).words(
        &[("25", -0.16)],
        0.28,
        paint::BLACK,
    )
}

fn school() -> SignFace {
    let house = [(-0.38, -0.38), (0.38, -0.38), (0.38, 0.12), (0.0, 0.42), (-0.38, 0.12)].map(Vec2::from);
    let inner: Vec<Vec2> = house.iter().map(|p| *p * 0.955).collect();
    let within: Vec<Vec2> = house.iter().map(|p| *p * 0.91).collect();
    SignFace::on(&house, LIME)
        .film(&inner, paint::BLACK)
        .film(&within, LIME)
        .walker(Vec2::new(-0.11, -0.06), paint::BLACK)
        .walker(Vec2::new(0.13, -0.11), paint::BLACK)
}

fn do_not_enter() -> SignFace {
    SignFace::on(&rectangle(Vec2::splat(0.38)), paint::WHITE)
        .film(&disc(0.35), paint::RED)
        .film(&rectangle(Vec2::new(0.27, 0.055)), paint::WHITE)
        .words(&[("DO NOT", 0.16), ("ENTER", -0.16)], 0.10, paint::WHITE)
}

fn chevron() -> SignFace {
    SignFace::on(&rectangle(Vec2::new(0.23, 0.31)), YELLOW).chain(
        &[(-0.08, -0.22), (0.10, 0.0), (-0.08, 0.22)],
        0.13,
        paint::BLACK,
    )
}

fn draw(code: &str) -> SignFace {
    let white = paint::WHITE;
    match code {
        "A,1b" => bend(warning()),
        "A,12" => warning().walker(Vec2::new(0.0, -0.03), paint::BLACK),
        "A,13" => warning().walker(Vec2::new(-0.07, -0.06), paint::BLACK).walker(Vec2::new(0.08, -0.08), paint::BLACK),
        "A,16" => digger(warning()),
        "A,17a" => lights(warning(), 0.95),
        "A,32" => warning().words(&[("!", -0.02)], 0.30, paint::BLACK),
        "B,3" => SignFace::on(&regular(4, 0.45, 0.0), paint::BLACK)
            .film(&regular(4, 0.435, 0.0), white)
            .film(&regular(4, 0.30, 0.0), YELLOW),
        "C,1" => SignFace::on(&disc(0.32), white)
            .film(&disc(0.305), paint::RED)
            .film(&rectangle(Vec2::new(0.22, 0.05)), white),
        "C,2" => SignFace::on(&disc(0.32), paint::RED).film(&disc(0.25), white),
        "C,18" => no_parking(false),
        "C,19" => no_parking(true),
        "D,1a" => blue_disc().arrow((0.0, -0.21), (0.0, 0.21), 0.065, white),
        "D,2" => blue_disc().arrow((-0.14, 0.14), (0.16, -0.16), 0.065, white),
        "D,3" => roundabout(),
        "D,4" => cycle_path(),
        "E,3" => board(0.80, 0.32, white, paint::BLUE).arrow((-0.32, 0.0), (0.32, 0.0), 0.075, white),
        "E,14" => board(0.60, 0.60, white, paint::BLUE).words(&[("P", 0.0)], 0.42, white),
        "R1-2" => SignFace::on(&regular(3, 0.55, PI), paint::RED).film(&regular(3, 0.36, PI), white).words(
            &[("YIELD", 0.085)],
            0.085,
            paint::RED,
        ),
        "R2-1" => speed_limit_mph(),
        "R4-7" => board(0.61, 0.76, paint::BLACK, white).film(&rectangle(Vec2::new(0.05, 0.24)), paint::BLACK).arrow(
            (0.02, 0.24),
            (0.20, -0.24),
            0.05,
            paint::BLACK,
        ),
        "R5-1" => do_not_enter(),
        "R6-1" => board(0.91, 0.30, paint::BLACK, paint::BLACK)
            .film(
                &[(-0.40, -0.05), (0.26, -0.05), (0.26, -0.11), (0.42, 0.0), (0.26, 0.11), (0.26, 0.05), (-0.40, 0.05)]
                    .map(Vec2::from),
                white,
            )
            .words(&[("ONE WAY", 0.0)], 0.06, paint::BLACK),
        "R7-1" => board(0.31, 0.46, paint::RED, white).words(
            &[("NO", 0.15), ("PARKING", 0.05), ("ANY", -0.05), ("TIME", -0.15)],
            0.055,
            paint::RED,
        ),
        "S1-1" => school(),
        "W1-2" => bend(diamond(YELLOW)),
        "W1-8" => chevron(),
        "W2-1" => diamond(YELLOW).bars(&[[(0.0, -0.24), (0.0, 0.24)], [(-0.24, 0.0), (0.24, 0.0)]], 0.07, paint::BLACK),
        "W3-3" => lights(diamond(YELLOW), 1.35),
        "W11-2" => diamond(YELLOW).walker(Vec2::new(0.0, 0.0), paint::BLACK),
        "W20-1" => diamond(ORANGE).words(&[("ROAD", 0.15), ("WORK", 0.0), ("AHEAD", -0.15)], 0.10, paint::BLACK),
        _ => SignFace::on(&regular(4, 0.4, FRAC_PI_4), white),
    }
}

/// Codes of the faces there are.
pub(crate) const CODES: &[&str] = &[
    "A,1b", "A,12", "A,13", "A,16", "A,17a", "A,32", "B,3", "C,1", "C,2", "C,18", "C,19", "D,1a", "D,2", "D,3", "D,4",
    "E,3", "E,14", "R1-2", "R2-1", "R4-7", "R5-1", "R6-1", "R7-1", "S1-1", "W1-2", "W1-8", "W2-1", "W3-3", "W11-2",
    "W20-1",
];

/// The sign of the code of this number, on its post.
pub(crate) fn sign(variant: u32) -> Sculpt {
    draw(CODES[variant as usize % CODES.len()]).sculpt
}

/// Words in raised strokes on a plane that looks towards +x, their middle at the origin; +y is the reader's right.
pub(crate) fn lettering(words: &str, height_m: f32, stroke_m: f32, material: Material) -> Mesh {
    super::glyph::text(words, Vec3::ZERO, height_m, stroke_m, material).into_mesh()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_code_has_a_face_of_its_own() {
        let unknown = draw("none").sculpt.into_mesh();
        for (i, code) in CODES.iter().enumerate() {
            let mesh = draw(code).sculpt.into_mesh();
            assert_ne!(mesh, unknown, "{code}");
            assert!(CODES[..i].iter().all(|other| draw(other).sculpt.into_mesh() != mesh), "{code}");
        }
    }
}
