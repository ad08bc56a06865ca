//! Railings and fences.

use crate::shape::Sculpt;
use crate::{Material, Surface};
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
