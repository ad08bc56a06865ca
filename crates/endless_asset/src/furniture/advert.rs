//! What shows something to passers-by: columns, lit posters, boards, flags, names of streets, ways to places.

use super::glyph::{text, text_width};
use super::lamp::pole;
use super::paint;
use super::shelter::poster;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Affine3A, Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, PI};

fn block(low: (f32, f32, f32), high: (f32, f32, f32), bevel: f32, material: Material) -> Sculpt {
    Sculpt::cuboid(Vec3::from(low), Vec3::from(high), bevel, material)
}

/// A round column pasted with posters.
pub(crate) fn advert_column(variant: u32) -> Sculpt {
    let mut stream = Stream::named(u64::from(variant), "advert column", &[]);
    let green = paint::fixed(Surface::Painted, [0.03, 0.10, 0.07]);
    let paper = paint::fixed(Surface::Plaster, [0.60, 0.57, 0.50]);
    let mut s = Sculpt::lathe(&[(0.0, 0.0), (0.68, 0.0), (0.68, 0.30), (0.60, 0.34)], 28, 30.0, paint::CONCRETE);
    let mut drum = Sculpt::lathe(&[(0.60, 0.34), (0.60, 2.75)], 28, 40.0, paper);
    let inks = [
        [0.55, 0.04, 0.04],
        [0.04, 0.14, 0.40],
        [0.75, 0.55, 0.05],
        [0.05, 0.28, 0.14],
        [0.05, 0.05, 0.05],
        [0.60, 0.20, 0.40],
        [0.70, 0.68, 0.62],
    ];
    for k in 0..7 {
        let turn = 2.0 * PI * k as f32 / 7.0;
        let (sin, cos) = endless_world::math::sin_cos(turn);
        let out = Vec3::new(cos, sin, 0.0);
        let side = Vec3::new(-sin, cos, 0.0);
        for row in 0..2 {
            let (z, h) = (0.45 + 1.15 * row as f32, 1.05);
            let mut area = |u: [f32; 2], v: [f32; 2], ink: [f32; 3]| {
                let region = Region::all()
                    .facing(out, 0.8)
                    .beyond(side, u[0])
                    .within(side, u[1])
                    .beyond(Vec3::Z, z + v[0] * h)
                    .within(Vec3::Z, z + v[1] * h);
                drum.paint(&region, paint::fixed(Surface::Plaster, ink));
            };
            area([-0.24, 0.24], [0.0, 1.0], *stream.pick(&inks));
            area([-0.20, 0.20], [0.62, 0.86], *stream.pick(&inks));
            area([-0.20, 0.12], [0.40, 0.50], *stream.pick(&inks));
            area([-0.20, 0.05], [0.12, 0.30], *stream.pick(&inks));
        }
    }
    s.add(drum);
    s.add(Sculpt::lathe(
        &[(0.60, 2.75), (0.74, 2.78), (0.74, 2.92), (0.62, 2.98), (0.45, 3.25), (0.10, 3.42), (0.0, 3.44)],
        28,
        35.0,
        green,
    ));
    s.add(Sculpt::ellipsoid(Vec3::Z * 3.50, Vec3::splat(0.09), 12, green));
    s
}

/// A lit poster case on a foot, 1.3 m wide, facing +x and −x.
pub(crate) fn city_light(variant: u32) -> Sculpt {
    let mut s = block((-0.11, -0.65, 0.50), (0.11, 0.65, 2.65), 0.03, paint::DARK_STEEL);
    s.add(block((-0.08, -0.25, 0.0), (0.08, 0.25, 0.52), 0.0, paint::DARK_STEEL));
    let mut face = Sculpt::new();
    poster(&mut face, 0.118, -0.57, 0.57, 0.60, 2.55, variant);
    s.add(face.clone());
    s.add(face.placed(Affine3A::from_rotation_z(PI)));
    s
}

/// A folding board before a shop, facing +x and −x.
pub(crate) fn sandwich_board(variant: u32) -> Sculpt {
    let frame = paint::fixed(Surface::Wood, [0.16, 0.09, 0.05]);
    let slate = paint::fixed(Surface::Painted, [0.02, 0.024, 0.022]);
    let chalk = paint::fixed(Surface::Plaster, [0.66, 0.65, 0.60]);
    let words = [
        ["MENU", "SOUP", "PASTA", "CAKE"],
        ["SALE", "50 OFF", "TODAY", "ONLY"],
        ["COFFEE", "TO GO", "2 FOR 1", "OPEN"],
    ];
    let mut leaf = block((-0.012, -0.32, 0.0), (0.012, 0.32, 1.05), 0.0, frame);
    leaf.add(block((0.0, -0.28, 0.14), (0.016, 0.28, 1.01), 0.0, slate));
    for (i, line) in words[variant as usize % 3].iter().enumerate() {
        let h: f32 = if i == 0 { 0.15 } else { 0.085 };
        let z = 0.87 - 0.19 * i as f32;
        leaf.add(text(line, Vec3::new(0.018, 0.0, z), h.min(h * 0.5 / text_width(line, h, 0.014)), 0.014, chalk));
    }
    let tilted = Affine3A::from_rotation_translation(glam::Quat::from_rotation_y(-0.2), Vec3::X * 0.22);
    let leaf = leaf.placed(tilted);
    let mut s = leaf.clone();
    s.add(leaf.placed(Affine3A::from_rotation_z(PI)));
    s
}

/// A flag on a pole of 9 m, in a light wind along +y.
pub(crate) fn flagpole(variant: u32) -> Sculpt {
    let white = paint::fixed(Surface::Painted, [0.70, 0.70, 0.70]);
    let mut s = pole(9.0, 0.06, 0.03, Material { tag: ClassTag::Poles, ..white });
    s.add(Sculpt::ellipsoid(Vec3::Z * 9.05, Vec3::splat(0.07), 12, paint::fixed(Surface::Chrome, [0.60, 0.45, 0.12])));
    let bands = [
        [[0.03, 0.10, 0.36], [0.72, 0.72, 0.70], [0.55, 0.03, 0.04]],
        [[0.04, 0.30, 0.12], [0.74, 0.60, 0.05], [0.50, 0.03, 0.03]],
        [[0.03, 0.16, 0.50], [0.03, 0.16, 0.50], [0.74, 0.62, 0.05]],
    ][variant as usize % 3]
        .map(|c| paint::fixed(Surface::Cloth, c));
    let n = 14;
    let wave = |i: usize, z: f32| {
        let t = i as f32 / n as f32;
        let (a, b) = (endless_world::math::sin(7.0 * t + z), endless_world::math::sin(3.5 * t));
        Vec3::new(0.13 * t * a, 0.06 + 1.75 * t, z - 0.35 * t * t + 0.05 * b)
    };
    for (k, &m) in bands.iter().enumerate() {
        let (top, low) = (8.85 - 0.4 * k as f32, 8.45 - 0.4 * k as f32);
        let row = |z: f32, off: f32| -> Vec<Vec3> { (0..=n).map(|i| wave(i, z) + Vec3::X * off).collect() };
        let mut cloth = Sculpt::new();
        cloth.grid(&[row(low, 0.004), row(top, 0.004)], false, m);
        cloth.grid(&[row(top, -0.004), row(low, -0.004)], false, m);
        s.add(cloth.smooth(60.0));
    }
    s
}

/// Two plates with names of streets at right angles on a post.
pub(crate) fn street_name(variant: u32) -> Sculpt {
    let colors = [[0.010, 0.20, 0.08], [0.012, 0.085, 0.42], [0.70, 0.70, 0.70]];
    let names = [["MAIN ST", "OAK AVE"], ["PARK LANE", "ELM ST"], ["MARKET ST", "LAKE RD"]];
    let pick = variant as usize % 3;
    let (plate, ink) = (paint::face(colors[pick]), if pick == 2 { paint::BLACK } else { paint::WHITE });
    let mut s = pole(3.0, 0.034, 0.03, paint::POLE);
    for (i, name) in names[pick].iter().enumerate() {
        let half = 0.5 * text_width(name, 0.13, 0.022) + 0.07;
        let z = 2.80 - 0.20 * i as f32;
        let mut sign = block((-0.006, -half, z - 0.09), (0.006, half, z + 0.09), 0.0, plate);
        let words = text(name, Vec3::new(0.0075, 0.0, z), 0.13, 0.022, ink);
        sign.add(words.clone());
        sign.add(words.placed(Affine3A::from_rotation_z(PI)));
        s.add(sign.at(Vec3::X * 0.04).placed(Affine3A::from_rotation_z(FRAC_PI_2 * i as f32)));
    }
    s
}

/// A board of directions on two posts, 3.2 m along y, facing +x.
pub(crate) fn guide_sign(variant: u32) -> Sculpt {
    let blue = if variant.is_multiple_of(2) { paint::BLUE } else { paint::face([0.010, 0.17, 0.07]) };
    let mut s = Sculpt::new();
    for y in [-1.15, 1.15] {
        s.add(Sculpt::post(Vec3::new(-0.06, y, 0.0), 4.55, 0.055, 0.055, 12, paint::POLE));
    }
    s.add(block((-0.02, -1.6, 2.5), (0.0, 1.6, 4.6), 0.0, paint::WHITE));
    s.add(block((0.0, -1.57, 2.53), (0.004, 1.57, 4.57), 0.0, blue));
    let names = [["CENTRE", "AIRPORT", "HARBOUR"], ["DOWNTOWN", "STADIUM", "EXIT 12"]][variant as usize % 2];
    for (i, name) in names.iter().enumerate() {
        let z = 4.20 - 0.64 * i as f32;
        let width = text_width(name, 0.36, 0.06);
        s.add(text(name, Vec3::new(0.006, -0.95 + 0.5 * width, z), 0.36, 0.06, paint::WHITE));
        // Ahead, left, right.
        let turn = [0.0, FRAC_PI_2, -FRAC_PI_2][i];
        let mut arrow = Sculpt::new();
        let bar = |a: (f32, f32), b: (f32, f32), s: &mut Sculpt| {
            super::glyph::line(s, Vec3::ZERO, Vec2::from(a), Vec2::from(b), 0.07, paint::WHITE);
        };
        bar((0.0, -0.18), (0.0, 0.16), &mut arrow);
        bar((0.0, 0.17), (-0.13, 0.03), &mut arrow);
        bar((0.0, 0.17), (0.13, 0.03), &mut arrow);
        let place = Affine3A::from_rotation_translation(glam::Quat::from_rotation_x(turn), Vec3::new(0.006, -1.28, z));
        s.add(arrow.placed(place));
    }
    s
}
