//! Bus shelter, billboard, kiosk.

use super::glyph::text;
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

fn block(low: (f32, f32, f32), high: (f32, f32, f32), bevel: f32, material: Material) -> Sculpt {
    Sculpt::cuboid(Vec3::from(low), Vec3::from(high), bevel, material)
}

/// Poster: a block of colours as a printer would set them.
pub(crate) fn poster(s: &mut Sculpt, x: f32, y0: f32, y1: f32, z0: f32, z1: f32, variant: u32) {
    let palettes = [
        [[0.03, 0.16, 0.42], [0.75, 0.62, 0.05], [0.80, 0.80, 0.78]],
        [[0.55, 0.04, 0.05], [0.80, 0.78, 0.70], [0.03, 0.03, 0.03]],
        [[0.06, 0.30, 0.16], [0.78, 0.80, 0.74], [0.75, 0.30, 0.04]],
    ];
    let palette = palettes[variant as usize % 3].map(|c| Material::new(Surface::LitSign, c, ClassTag::Static));
    let mut panel = Sculpt::cuboid(Vec3::new(x - 0.01, y0, z0), Vec3::new(x, y1, z1), 0.0, palette[0]);
    let (w, h) = (y1 - y0, z1 - z0);
    let area = |u0: f32, u1: f32, v0: f32, v1: f32| {
        let (a, b) = ((y0 + u0 * w, y0 + u1 * w), (z0 + v0 * h, z0 + v1 * h));
        Region::end(&[(a.0, b.0), (a.1, b.0), (a.1, b.1), (a.0, b.1)].map(Vec2::from)).facing(Vec3::X, 0.9)
    };
    panel.paint(&area(0.08, 0.92, 0.74, 0.90), palette[1]);
    panel.paint(&area(0.10, 0.55, 0.16, 0.62), palette[2]);
    panel.paint(&area(0.62, 0.90, 0.40, 0.46), palette[1]);
    panel.paint(&area(0.62, 0.84, 0.28, 0.34), palette[1]);
    panel.paint(&area(0.08, 0.92, 0.05, 0.10), palette[2]);
    s.add(panel);
}

/// Four metres along y, open to +x.
pub(crate) fn bus_shelter() -> Sculpt {
    let mut s = Sculpt::new();
    for y in [-1.95, -0.65, 0.65, 1.95] {
        s.add(block((-0.74, y - 0.035, 0.0), (-0.67, y + 0.035, 2.45), 0.0, paint::DARK_STEEL));
    }
    s.add(block((0.55, -1.985, 0.0), (0.62, -1.915, 2.45), 0.0, paint::DARK_STEEL));
    s.add(block((-0.85, -2.0, 2.42), (0.85, 2.0, 2.52), 0.035, paint::DARK_STEEL));
    for i in 0..3 {
        let y = -1.90 + 1.3 * i as f32;
        s.add(block((-0.712, y, 0.25), (-0.700, y + 1.2, 2.30), 0.0, paint::GLASS));
    }
    s.add(block((-0.66, -1.956, 0.25), (0.54, -1.944, 2.30), 0.0, paint::GLASS));
    // The end wall carries a lit poster case.
    s.add(block((-0.62, 1.86, 0.10), (0.62, 2.0, 2.42), 0.02, paint::DARK_STEEL));
    for (y, facing) in [(1.858, -1.0f32), (2.002, 1.0)] {
        let print = Material::new(Surface::LitSign, [0.70, 0.66, 0.58], ClassTag::Static);
        let (a, b) = if facing < 0.0 { (y - 0.002, y + 0.004) } else { (y - 0.004, y + 0.002) };
        let mut case = block((-0.54, a, 0.32), (0.54, b, 2.20), 0.0, print);
        let ink = Material::new(Surface::LitSign, [0.10, 0.22, 0.40], ClassTag::Static);
        case.paint(
            &Region::all().beyond(Vec3::Z, 1.1).within(Vec3::Z, 2.0).beyond(Vec3::X, -0.4).within(Vec3::X, 0.4),
            ink,
        );
        s.add(case);
    }
    for i in 0..3 {
        let x = -0.58 + 0.12 * i as f32;
        s.add(block((x, -1.2, 0.45), (x + 0.10, 1.2, 0.485), 0.01, paint::SLATS));
    }
    for y in [-0.9, 0.9] {
        s.add(block((-0.50, y - 0.03, 0.0), (-0.42, y + 0.03, 0.45), 0.0, paint::DARK_STEEL));
    }
    let blue = Material::new(Surface::LitSign, [0.02, 0.12, 0.42], ClassTag::Static);
    s.add(block((0.80, -1.0, 2.42), (0.87, 1.0, 2.66), 0.0, blue));
    s.add(text("BUS", Vec3::new(0.874, 0.0, 2.54), 0.15, 0.024, Material { base_color: [0.8; 3], ..blue }));
    s
}

/// On two legs, facing +x.
pub(crate) fn billboard(variant: u32) -> Sculpt {
    let mut s = block((-0.09, -1.75, 2.2), (0.055, 1.75, 4.35), 0.02, paint::DARK_STEEL);
    for y in [-1.2, 1.2] {
        s.add(Sculpt::post(Vec3::new(-0.05, y, 0.0), 2.25, 0.085, 0.085, 14, paint::STEEL));
    }
    poster(&mut s, 0.066, -1.67, 1.67, 2.28, 4.27, variant);
    s
}

/// Two and a half metres square, open to +x.
pub(crate) fn kiosk(variant: u32) -> Sculpt {
    let wall = paint::fixed(
        Surface::Painted,
        [[0.04, 0.16, 0.11], [0.09, 0.13, 0.24], [0.34, 0.07, 0.05]][variant as usize % 3],
    );
    let inside = paint::fixed(Surface::Wood, [0.20, 0.14, 0.09]);
    let (h, t) = (1.25, 0.08);
    let mut s = block((-h, -h, 0.0), (h, h, 0.12), 0.0, paint::CONCRETE);
    s.add(block((-h, -h, 0.12), (-h + t, h, 2.45), 0.0, wall));
    s.add(block((-h + t, h - t, 0.12), (h, h, 2.45), 0.0, wall).both_sides());
    s.add(block((h - t, -h + t, 0.12), (h, h - t, 1.05), 0.0, wall));
    s.add(block((h - 0.25, -h + t, 1.05), (h + 0.22, h - t, 1.10), 0.012, inside));
    s.add(block((-h + t, -h + t, 1.9), (-h + 0.5, h - t, 1.94), 0.0, inside));
    // Goods on the counter and shelves.
    let colors = [[0.65, 0.08, 0.06], [0.80, 0.66, 0.10], [0.08, 0.30, 0.55], [0.75, 0.74, 0.70], [0.10, 0.36, 0.14]];
    for i in 0..14 {
        let y = -1.08 + 0.16 * i as f32;
        let m = paint::fixed(Surface::Plastic, colors[(i * 3 + variant as usize) % 5]);
        s.add(block((h - 0.22, y, 1.10), (h - 0.08, y + 0.12, 1.20 + 0.03 * (i % 3) as f32), 0.0, m));
        s.add(block((-h + 0.12, y, 1.94), (-h + 0.4, y + 0.13, 2.14 + 0.05 * (i % 4) as f32), 0.0, m));
        s.add(block((-h + 0.1, y, 1.25), (-h + 0.3, y + 0.13, 1.55 + 0.04 * (i % 5) as f32), 0.0, m));
    }
    s.add(block((-h - 0.12, -h - 0.12, 2.45), (h + 0.12, h + 0.12, 2.62), 0.03, wall));
    let lit = Material::new(Surface::LitSign, [0.78, 0.72, 0.58], ClassTag::Static);
    s.add(block((h + 0.10, -h, 2.47), (h + 0.14, h, 2.85), 0.0, lit));
    // A striped awning.
    for i in 0..10 {
        let y = -h + 0.25 * i as f32;
        let cloth = if i % 2 == 0 { wall } else { paint::fixed(Surface::Cloth, [0.75, 0.73, 0.68]) };
        let (a, b) = (Vec3::new(h + 0.02, y, 2.42), Vec3::new(h + 0.85, y, 2.12));
        let w = Vec3::Y * 0.25;
        s.quad([a, b, b + w, a + w], cloth);
        let down = Vec3::NEG_Z * 0.012;
        s.quad([a + down, a + w + down, b + w + down, b + down], cloth);
        s.quad([b - Vec3::Z * 0.14, b + w - Vec3::Z * 0.14, b + w, b], cloth);
    }
    s
}
