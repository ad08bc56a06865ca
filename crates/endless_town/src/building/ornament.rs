//! What is fixed to facades: surrounds, shutters, grilles, blinds, pipes, machines, fire escapes, letters, posters.

use super::finish::BuildingFinish;
use super::wall::{Wall, WallOpening};
use endless_asset::Catalogue;
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};
use glam::Vec2;

const fn of(surface: Surface, color: [f32; 3]) -> Material {
    Material::new(surface, color, ClassTag::Buildings)
}

const MACHINE: Material = of(Surface::Painted, [0.58, 0.58, 0.55]);
const DARK: Material = of(Surface::Painted, [0.045, 0.047, 0.05]);
const IRON: Material = of(Surface::Painted, [0.035, 0.036, 0.038]);
const ZINC: Material = of(Surface::Metal, [0.36, 0.37, 0.38]);
const CABLE: Material = of(Surface::Rubber, [0.03, 0.03, 0.03]);

/// What may be read over shops.
const NAMES: &[&str] = &[
    "BAKERY",
    "CAFE",
    "PHARMACY",
    "BOOKS",
    "HOTEL",
    "BANK",
    "FLOWERS",
    "PIZZA",
    "MARKET",
    "BARBER",
    "SHOES",
    "MODE",
    "OPTIK",
    "TABAC",
    "BAR",
    "KEBAB",
    "SUSHI",
    "PHONES",
    "TOYS",
    "BIKES",
    "WINE",
    "LAUNDRY",
    "GRILL",
    "TEA HOUSE",
    "24 HOURS",
    "NAILS",
    "DENTIST",
    "COPY SHOP",
    "HARDWARE",
    "DELI",
];

/// The frame of plaster or stone about a window, with a hood over it if it is a fine one.
pub(super) fn surround(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, fine: bool, material: Material) {
    let ([u0, u1], [v0, v1]) = (hole.u, hole.v);
    let (w, out) = (0.13, [0.0, 0.036]);
    wall.block(mesh, [u0 - w, u0], [v0, v1 + w], out, material);
    wall.block(mesh, [u1, u1 + w], [v0, v1 + w], out, material);
    wall.block(mesh, [u0, u1], [v1, v1 + w], out, material);
    if fine {
        wall.block(mesh, [u0 - 0.22, u1 + 0.22], [v1 + w + 0.10, v1 + w + 0.19], [0.0, 0.17], material);
        for u in [u0 - 0.16, u1 + 0.06] {
            wall.block(mesh, [u, u + 0.10], [v1 + w - 0.14, v1 + w + 0.10], [0.0, 0.12], material);
        }
    }
}

/// A stone over a window.
pub(super) fn lintel(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, material: Material) {
    let ([u0, u1], v) = (hole.u, hole.v[1]);
    wall.block(mesh, [u0 - 0.14, u1 + 0.14], [v, v + 0.2], [0.0, 0.035], material);
    let middle = (u0 + u1) / 2.0;
    wall.block(mesh, [middle - 0.09, middle + 0.09], [v, v + 0.27], [0.0, 0.06], material);
}

/// Open shutters of slats on both sides of a window, as far as there is wall.
pub(super) fn shutters(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    (room, slatted): (f32, bool),
    material: Material,
) {
    let w = (0.5 * (hole.u[1] - hole.u[0])).min(room - 0.04);
    if w < 0.25 {
        return;
    }
    for u in [hole.u[0] - w - 0.02, hole.u[1] + 0.02] {
        let range = [hole.v[0], hole.v[1]];
        wall.block(mesh, [u, u + w], range, [0.0, 0.045], material);
        let slats = if slatted { ((range[1] - range[0] - 0.16) / 0.24) as usize } else { 0 };
        let shade = Material { base_color: material.base_color.map(|c| c * 0.62), ..material };
        for k in 0..slats {
            let v = range[0] + 0.08 + 0.24 * k as f32;
            wall.block(mesh, [u + 0.06, u + w - 0.06], [v, v + 0.12], [0.04, 0.06], shade);
        }
    }
}

/// Bars before a window.
pub(super) fn grille(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, material: Material) {
    let ([u0, u1], [v0, v1]) = (hole.u, hole.v);
    let count = ((u1 - u0) / 0.15) as usize;
    for k in 0..=count {
        let u = u0 + (u1 - u0) * k as f32 / count as f32;
        wall.block(mesh, [u - 0.01, u + 0.01], [v0 - 0.03, v1 + 0.03], [0.07, 0.09], material);
    }
    for v in [v0 - 0.03, v0 + 0.4 * (v1 - v0), v1] {
        wall.block(mesh, [u0 - 0.06, u1 + 0.06], [v, v + 0.03], [0.05, 0.075], material);
    }
}

/// A roller blind let down to some height, in its box.
pub(super) fn roller_blind(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    recess: f32,
    drop: f32,
    material: Material,
) {
    let ([u0, u1], [v0, v1]) = (hole.u, hole.v);
    wall.block(mesh, [u0, u1], [v1 - 0.20, v1], [-recess + 0.01, -0.02], material);
    let low = v1 - 0.20 - drop * (v1 - v0 - 0.22);
    if drop > 0.02 {
        wall.block(mesh, [u0 + 0.02, u1 - 0.02], [low, v1 - 0.20], [-recess + 0.02, -recess + 0.05], material);
    }
    let shade = Material { base_color: material.base_color.map(|c| c * 0.75), ..material };
    for k in 0..((v1 - 0.22 - low) / 0.16) as usize {
        let v = low + 0.08 + 0.16 * k as f32;
        wall.panel(mesh, [u0 + 0.02, u1 - 0.02], [v, v + 0.03], -recess + 0.053, shade);
    }
}

/// An outdoor unit of an air conditioner on its bracket, its middle below `v`.
pub(super) fn air_conditioner(mesh: &mut MeshBuilder, wall: &Wall, u: f32, v: f32) {
    wall.block(mesh, [u - 0.42, u + 0.42], [v - 0.62, v - 0.06], [0.06, 0.36], MACHINE);
    wall.block(mesh, [u - 0.34, u + 0.14], [v - 0.58, v - 0.10], [0.355, 0.372], DARK);
    wall.block(mesh, [u - 0.30, u + 0.10], [v - 0.36, v - 0.33], [0.37, 0.385], MACHINE);
    wall.block(mesh, [u - 0.12, u - 0.09], [v - 0.54, v - 0.14], [0.37, 0.385], MACHINE);
    for x in [u - 0.33, u + 0.29] {
        wall.block(mesh, [x, x + 0.04], [v - 0.68, v - 0.62], [0.0, 0.34], ZINC);
    }
    wall.block(mesh, [u + 0.42, u + 0.46], [v - 1.1, v - 0.2], [0.0, 0.04], CABLE);
}

/// A dish for satellites, turned a little aside.
pub(super) fn dish(mesh: &mut MeshBuilder, wall: &Wall, u: f32, v: f32) {
    const SIDES: usize = 14;
    let white = of(Surface::Painted, [0.62, 0.62, 0.60]);
    wall.block(mesh, [u - 0.02, u + 0.02], [v - 0.02, v + 0.02], [0.0, 0.36], ZINC);
    let rim = |k: usize, r: f32, out: f32| {
        let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * k as f32 / SIDES as f32);
        // It looks up and aside.
        wall.at(u + 0.08 + r * cos, v + 0.08 + r * sin * 0.95, out + 0.30 * r * cos + 0.22 * r * sin)
    };
    let middle = wall.at(u + 0.06, v + 0.06, 0.36);
    for k in 0..SIDES {
        let (a, b) = (rim(k, 0.36, 0.47), rim(k + 1, 0.36, 0.47));
        let uv = [Vec2::ZERO, Vec2::X, Vec2::ONE];
        mesh.triangle([middle, a, b], uv, white);
        mesh.triangle([middle, b, a], uv, white);
    }
    wall.bar(mesh, (Vec2::new(u + 0.06, v - 0.28), Vec2::new(u + 0.2, v + 0.02)), 0.025, [0.52, 0.72], ZINC);
    wall.block(mesh, [u + 0.13, u + 0.2], [v + 0.0, v + 0.08], [0.70, 0.78], white);
}

/// A box with flowers under a window.
pub(super) fn flower_box(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, stream: &mut Stream) {
    let green = Material::new(Surface::Foliage, [0.05, 0.11, 0.03], ClassTag::Vegetation);
    let petals = [[0.60, 0.03, 0.05], [0.62, 0.12, 0.40], [0.70, 0.45, 0.05], [0.70, 0.68, 0.66]];
    let petal = Material::new(Surface::Foliage, *stream.pick(&petals), ClassTag::Vegetation);
    let ([u0, u1], v) = (hole.u, hole.v[0]);
    wall.block(mesh, [u0, u1], [v + 0.0, v + 0.16], [0.06, 0.24], of(Surface::Wood, [0.22, 0.13, 0.08]));
    let count = ((u1 - u0) / 0.13) as usize;
    for k in 0..count {
        let u = u0 + 0.05 + 0.13 * k as f32;
        let (h, o) = (stream.range_f32(0.07, 0.2), stream.range_f32(0.09, 0.2));
        wall.block(mesh, [u - 0.055, u + 0.065], [v + 0.15, v + 0.15 + h], [o - 0.03, o + 0.05], green);
        if k % 2 == 0 {
            wall.block(mesh, [u - 0.03, u + 0.03], [v + 0.13 + h, v + 0.18 + h], [o - 0.02, o + 0.07], petal);
        }
    }
}

/// A downpipe with its clamps.
pub(super) fn downpipe(mesh: &mut MeshBuilder, wall: &Wall, u: f32, top: f32) {
    wall.block(mesh, [u, u + 0.09], [0.0, top], [0.0, 0.03], ZINC);
    for k in 0..(top / 2.2) as usize {
        let v = 1.2 + 2.2 * k as f32;
        wall.block(mesh, [u - 0.025, u + 0.115], [v, v + 0.04], [0.0, 0.036], ZINC);
    }
    if top > 3.0 {
        wall.block(mesh, [u - 0.05, u + 0.14], [top - 0.22, top], [0.0, 0.14], ZINC);
    }
}

/// Cables along a wall, with a meter where they begin.
pub(super) fn cables(mesh: &mut MeshBuilder, wall: &Wall, v: f32, stream: &mut Stream) {
    for k in 0..2 {
        let h = v + 0.06 * k as f32;
        wall.block(mesh, [0.05, wall.width - 0.05], [h, h + 0.022], [0.0, 0.022], CABLE);
    }
    let u = wall.width * stream.range_f32(0.1, 0.9);
    wall.block(mesh, [u, u + 0.022], [1.9, v], [0.0, 0.022], CABLE);
    wall.block(mesh, [u - 0.14, u + 0.16], [1.3, 1.75], [0.0, 0.03], MACHINE);
    wall.block(mesh, [u - 0.06, u + 0.08], [1.48, 1.64], [0.03, 0.036], DARK);
}

/// Iron platforms with railings before every storey from the second on, joined by slanting stairs.
pub(super) fn fire_escape(mesh: &mut MeshBuilder, wall: &Wall, middle: f32, floors: &[f32]) {
    let (half, reach) = (1.7, 0.95);
    let u = [middle - half, middle + half];
    for (k, &floor) in floors.iter().enumerate() {
        // A grating of bars lets light through.
        for i in 0..8 {
            let o = 0.06 + 0.115 * i as f32;
            wall.block(mesh, u, [floor - 0.04, floor], [o, o + 0.05], IRON);
        }
        for end in [u[0], u[1] - 0.05] {
            wall.block(mesh, [end, end + 0.05], [floor - 0.12, floor - 0.04], [0.0, reach], IRON);
            wall.block(mesh, [end, end + 0.04], [floor, floor + 1.0], [reach - 0.05, reach - 0.01], IRON);
            wall.block(mesh, [end, end + 0.03], [floor + 0.96, floor + 1.0], [0.0, reach], IRON);
        }
        for v in [0.5, 0.97] {
            wall.block(mesh, u, [floor + v, floor + v + 0.03], [reach - 0.045, reach - 0.015], IRON);
        }
        for i in 1..14 {
            let at = u[0] + 2.0 * half * i as f32 / 14.0;
            wall.block(mesh, [at, at + 0.016], [floor, floor + 0.97], [reach - 0.04, reach - 0.024], IRON);
        }
        let Some(&next) = floors.get(k + 1) else { continue };
        // Flights run one way and then the other.
        let (a, b) = if k % 2 == 0 { (u[0] + 0.5, u[1] - 0.5) } else { (u[1] - 0.5, u[0] + 0.5) };
        for out in [[0.40, 0.44], [0.82, 0.86]] {
            wall.bar(mesh, (Vec2::new(a, floor), Vec2::new(b, next)), 0.14, out, IRON);
            wall.bar(mesh, (Vec2::new(a, floor + 0.85), Vec2::new(b, next + 0.85)), 0.03, out, IRON);
        }
        for i in 1..11 {
            let t = i as f32 / 11.0;
            let (x, y) = (a + (b - a) * t, floor + (next - floor) * t);
            wall.block(mesh, [x - 0.11, x + 0.11], [y - 0.01, y + 0.015], [0.42, 0.84], IRON);
        }
    }
}

/// Words on a wall, as wide as there is room for.
pub(super) fn letters(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (u, v): ([f32; 2], f32),
    out: f32,
    height: f32,
    words: &str,
    material: Material,
) {
    let width = 0.9 * (u[1] - u[0]);
    // A letter is 0.39 of its height wide; strokes and gaps come to 0.34 more.
    let height = height.min(width / (0.73 * words.len().max(1) as f32));
    let text = Catalogue::lettering(words, height, height * 0.16, material);
    wall.hang(mesh, &text, (u[0] + u[1]) / 2.0, v, out);
}

/// The name over a shop: dark on light or light on dark.
pub(super) fn shop_name(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    finish: &BuildingFinish,
    stream: &mut Stream,
) {
    let bright: f32 = finish.sign.base_color.iter().sum();
    let ink = if bright > 1.0 { [0.04, 0.04, 0.05] } else { [0.80, 0.79, 0.74] };
    let material = Material { base_color: ink, ..finish.sign };
    let name: &&str = stream.pick(NAMES);
    letters(mesh, wall, (hole.u, 3.25), 0.168, 0.40, name, material);
}

/// A sign that stands out from the wall, to be read from along the street.
pub(super) fn projecting_sign(mesh: &mut MeshBuilder, wall: &Wall, u: f32, v: f32, finish: &BuildingFinish) {
    wall.block(mesh, [u - 0.02, u + 0.02], [v + 0.5, v + 0.54], [0.0, 0.75], IRON);
    wall.block(mesh, [u - 0.05, u + 0.05], [v - 0.1, v + 0.5], [0.12, 0.72], finish.sign);
}

/// Posters pasted side by side.
pub(super) fn posters(mesh: &mut MeshBuilder, wall: &Wall, from: f32, stream: &mut Stream) {
    let inks = [
        [0.60, 0.08, 0.06],
        [0.05, 0.16, 0.42],
        [0.72, 0.56, 0.06],
        [0.65, 0.63, 0.57],
        [0.06, 0.06, 0.07],
        [0.08, 0.32, 0.20],
    ];
    let paper = |c: [f32; 3]| of(Surface::Plaster, c);
    for k in 0..3 + stream.below(3) {
        let u = from + 0.66 * k as f32;
        if u + 0.6 > wall.width - 0.2 {
            return;
        }
        let v = 0.9 + stream.range_f32(-0.05, 0.05);
        wall.block(mesh, [u, u + 0.6], [v, v + 0.85], [0.0, 0.006], paper(*stream.pick(&inks)));
        wall.block(mesh, [u + 0.06, u + 0.54], [v + 0.55, v + 0.75], [0.0, 0.009], paper(*stream.pick(&inks)));
        wall.block(mesh, [u + 0.06, u + 0.35], [v + 0.12, v + 0.32], [0.0, 0.009], paper(*stream.pick(&inks)));
    }
}

/// A tag sprayed on a wall, with its outline.
pub(super) fn graffito(mesh: &mut MeshBuilder, wall: &Wall, u: f32, stream: &mut Stream) {
    let words = ["ZEST", "KROK", "MUON", "AXIS", "OBEY", "RAZE", "NOVA"];
    let paints = [[0.10, 0.25, 0.60], [0.62, 0.10, 0.30], [0.15, 0.45, 0.15], [0.70, 0.35, 0.04], [0.50, 0.50, 0.55]];
    let (word, height) = (stream.pick(&words), stream.range_f32(0.8, 1.3));
    let fill = of(Surface::Plaster, *stream.pick(&paints));
    let width = 0.75 * height * word.len() as f32;
    if u + width > wall.width {
        return;
    }
    let v = 0.35 + height / 2.0;
    // Letter by letter: thick strokes must not move them apart.
    for (stroke, out, material) in [(0.30, 0.004, of(Surface::Plaster, [0.02, 0.02, 0.025])), (0.19, 0.008, fill)] {
        for (k, letter) in word.chars().enumerate() {
            let text = Catalogue::lettering(letter.encode_utf8(&mut [0; 4]), height, height * stroke, material);
            let at = u + 0.4 * height + 0.68 * height * k as f32;
            wall.hang(mesh, &text, at, v + height * lift(k), out);
        }
    }
}

/// Letters of a tag do not stand in line.
fn lift(k: usize) -> f32 {
    [0.0, 0.06, -0.04, 0.08, 0.02][k % 5]
}
