//! Railings and fences.

use super::part::rod;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

/// Two metres of iron railing along x, 1.1 m high.
pub(crate) fn railing() -> Sculpt {
    let iron = Material::new(Surface::Painted, [0.028, 0.032, 0.034], ClassTag::Fences);
    let rod = |a: Vec3, b: Vec3, r: f32| Sculpt::tube(&[(a, r), (b, r)], 8, iron);
    let mut s = Sculpt::new();
    for x in [-0.97, 0.97] {
        s.add(Sculpt::cuboid(Vec3::new(x - 0.03, -0.03, 0.0), Vec3::new(x + 0.03, 0.03, 1.08), 0.006, iron));
        s.add(Sculpt::ellipsoid(Vec3::new(x, 0.0, 1.06), Vec3::splat(0.04), 10, iron));
    }
    s.add(rod(Vec3::new(-1.0, 0.0, 1.03), Vec3::new(1.0, 0.0, 1.03), 0.022));
    s.add(rod(Vec3::new(-1.0, 0.0, 0.14), Vec3::new(1.0, 0.0, 0.14), 0.016));
    for i in 0..15 {
        let x = -0.84 + 0.12 * i as f32;
        s.add(rod(Vec3::new(x, 0.0, 0.14), Vec3::new(x, 0.0, 1.03), 0.009));
    }
    s
}

/// How many railings at kerbs there are.
pub(crate) const KERB_RAILS: u32 = 4;

/// Two metres of railing at a kerb along x, 1 m high: bars in a frame of galvanised or green steel, or two tubes in
/// yellow or in white with red posts.
pub(crate) fn kerb_rail(variant: u32) -> Sculpt {
    let steel = |surface, color| Material::new(surface, color, ClassTag::Fences);
    let (posts, bars, barred) = match variant % KERB_RAILS {
        0 => (steel(Surface::Metal, [0.36, 0.37, 0.38]), steel(Surface::Metal, [0.36, 0.37, 0.38]), true),
        1 => (steel(Surface::Painted, [0.02, 0.07, 0.04]), steel(Surface::Painted, [0.02, 0.07, 0.04]), true),
        2 => (steel(Surface::Painted, [0.66, 0.36, 0.01]), steel(Surface::Painted, [0.66, 0.36, 0.01]), false),
        _ => (steel(Surface::Painted, [0.45, 0.03, 0.02]), steel(Surface::Painted, [0.68, 0.68, 0.66]), false),
    };
    let mut s = Sculpt::new();
    for x in [-0.96, 0.96] {
        s.add(Sculpt::post(Vec3::new(x, 0.0, 0.0), 1.02, 0.028, 0.028, 10, posts));
    }
    let heights: &[f32] = if barred { &[0.12, 0.97] } else { &[0.52, 0.97] };
    for &z in heights {
        s.add(rod(Vec3::new(-1.0, 0.0, z), Vec3::new(1.0, 0.0, z), 0.021, bars));
    }
    if barred {
        for i in 0..17 {
            let x = -0.88 + 0.11 * i as f32;
            s.add(rod(Vec3::new(x, 0.0, 0.12), Vec3::new(x, 0.0, 0.97), 0.007, bars));
        }
    }
    s
}

/// Two metres of boards along x, 1.6 m high.
pub(crate) fn fence_panel() -> Sculpt {
    let mut stream = Stream::named(0, "fence boards", &[]);
    let wood = |k: f32| Material::new(Surface::Wood, [0.26 * k, 0.19 * k, 0.125 * k], ClassTag::Fences);
    let mut s = Sculpt::new();
    for x in [-0.96, 0.96] {
        s.add(Sculpt::cuboid(Vec3::new(x - 0.04, -0.04, 0.0), Vec3::new(x + 0.04, 0.04, 1.6), 0.008, wood(0.8)));
    }
    for z in [0.30, 1.22] {
        s.add(Sculpt::cuboid(Vec3::new(-0.92, -0.035, z), Vec3::new(0.92, 0.0, z + 0.09), 0.0, wood(0.85)));
    }
    for i in 0..15 {
        let x = -0.92 + 0.123 * i as f32;
        let top = 1.56 + stream.range_f32(-0.012, 0.012);
        let outline = [
            Vec2::new(x, 0.06),
            Vec2::new(x + 0.112, 0.06),
            Vec2::new(x + 0.112, top - 0.04),
            Vec2::new(x + 0.056, top),
            Vec2::new(x, top - 0.04),
        ];
        s.add(Sculpt::slab(
            &outline,
            0.0,
            0.022,
            10.0,
            wood(0.75 + 0.5 * stream.f32().round() * 0.5 + 0.25 * stream.f32()),
        ));
    }
    s
}

/// Two metres of brick wall along x with a coping, 1.8 m high, piers at its ends.
pub(crate) fn brick_wall() -> Sculpt {
    let brick = Material::new(Surface::Brick, [0.34, 0.15, 0.10], ClassTag::Walls);
    let coping = Material::new(Surface::Concrete, [0.46, 0.45, 0.42], ClassTag::Walls);
    let mut s = Sculpt::cuboid(Vec3::new(-1.0, -0.11, 0.0), Vec3::new(1.0, 0.11, 1.72), 0.0, brick);
    s.add(Sculpt::cuboid(Vec3::new(-1.0, -0.16, 1.72), Vec3::new(1.0, 0.16, 1.79), 0.012, coping));
    s.add(Sculpt::cuboid(Vec3::new(-1.0, -0.19, 0.0), Vec3::new(-0.64, 0.19, 1.80), 0.0, brick));
    s.add(Sculpt::cuboid(Vec3::new(-1.0, -0.23, 1.80), Vec3::new(-0.60, 0.23, 1.87), 0.012, coping));
    s
}

/// Two metres of field stones along x, 0.8 m high.
pub(crate) fn stone_wall() -> Sculpt {
    let mut stream = Stream::named(0, "field stones", &[]);
    let stone = |k: f32| Material::new(Surface::Plaster, [0.34 * k, 0.32 * k, 0.28 * k], ClassTag::Walls);
    let mut s = Sculpt::cuboid(Vec3::new(-1.0, -0.17, 0.0), Vec3::new(1.0, 0.17, 0.68), 0.0, stone(0.35));
    let mut z = 0.0;
    while z < 0.66 {
        let h = stream.range_f32(0.11, 0.19);
        let mut x = -1.0;
        while x < 0.96 {
            let w = stream.range_f32(0.14, 0.36).min(1.0 - x);
            let (dy, tone) = (stream.range_f32(0.18, 0.23), stream.range_f32(0.65, 1.25));
            let low = Vec3::new(x + 0.006, -dy, z + 0.005);
            s.add(Sculpt::cuboid(low, Vec3::new(x + w - 0.006, dy, z + h - 0.005), 0.035, stone(tone)));
            x += w;
        }
        z += h;
    }
    s
}

/// Two metres of wire netting between steel posts along x, 1.8 m high.
pub(crate) fn chain_link() -> Sculpt {
    let zinc = Material::new(Surface::Metal, [0.36, 0.38, 0.37], ClassTag::Fences);
    let rod = |a: (f32, f32), b: (f32, f32), r: f32, sides: usize| {
        Sculpt::tube(&[(Vec3::new(a.0, 0.0, a.1), r), (Vec3::new(b.0, 0.0, b.1), r)], sides, zinc)
    };
    let mut s = rod((-0.98, 0.0), (-0.98, 1.85), 0.028, 8);
    s.add(rod((-1.0, 1.8), (1.0, 1.8), 0.018, 6));
    for z in [0.06, 0.95] {
        s.add(rod((-1.0, z), (1.0, z), 0.004, 3));
    }
    // Two families of slanting wires.
    let (low, high, pitch) = (0.06, 1.8, 0.16);
    let rise = high - low;
    let mut from = -1.0 - rise;
    while from < 1.0 {
        for mirror in [1.0, -1.0] {
            let enter = (-1.0f32).max(from);
            let leave = 1.0f32.min(from + rise);
            if leave - enter > 0.02 {
                let at = |x: f32| (mirror * x, low + (x - from));
                s.add(rod(at(enter), at(leave), 0.0035, 3));
            }
        }
        from += pitch;
    }
    s
}

/// Two metres of white pickets along x, 0.95 m high.
pub(crate) fn picket_fence() -> Sculpt {
    let white = Material::new(Surface::Painted, [0.68, 0.68, 0.65], ClassTag::Fences);
    let mut s = Sculpt::new();
    for x in [-0.96, 0.96] {
        s.add(Sculpt::cuboid(Vec3::new(x - 0.04, -0.04, 0.0), Vec3::new(x + 0.04, 0.04, 0.95), 0.008, white));
    }
    for z in [0.25, 0.68] {
        s.add(Sculpt::cuboid(Vec3::new(-0.96, -0.025, z), Vec3::new(0.96, 0.0, z + 0.08), 0.0, white));
    }
    for i in 0..14 {
        let x = -0.90 + 0.1335 * i as f32;
        let outline = [(0.0, 0.06), (0.075, 0.06), (0.075, 0.86), (0.0375, 0.93), (0.0, 0.86)];
        s.add(Sculpt::slab(&outline.map(|(u, v)| Vec2::new(x + u - 0.0375, v)), -0.045, -0.025, 10.0, white));
    }
    s
}
