//! Bins, hydrants, post boxes, bollards, cones, cabinets, dumpsters, bicycle racks.

use super::paint;
use crate::shape::{Region, Sculpt, rounded};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

pub(crate) fn bin(variant: u32) -> Sculpt {
    let color = paint::fixed(Surface::Painted, [[0.030, 0.075, 0.045], [0.05, 0.055, 0.06]][variant as usize % 2]);
    let mut s = Sculpt::lathe(
        &[(0.0, 0.02), (0.20, 0.02), (0.215, 0.06), (0.235, 0.80), (0.245, 0.82), (0.245, 0.86)],
        20,
        35.0,
        color,
    );
    s.add(Sculpt::lathe(&[(0.245, 0.86), (0.19, 0.86), (0.18, 0.70), (0.0, 0.70)], 20, 35.0, paint::DARK));
    s.add(Sculpt::lathe(
        &[(0.0, 0.985), (0.25, 0.985), (0.26, 1.0), (0.22, 1.05), (0.10, 1.085), (0.0, 1.09)],
        20,
        40.0,
        color,
    ));
    for i in 0..4 {
        let (sin, cos) = endless_world::math::sin_cos(0.785 + 1.571 * i as f32);
        let p = Vec3::new(0.215 * cos, 0.215 * sin, 0.84);
        s.add(Sculpt::tube(&[(p, 0.012), (p + Vec3::Z * 0.16, 0.012)], 6, color));
    }
    s.add(Sculpt::post(Vec3::ZERO, 0.03, 0.17, 0.17, 16, paint::CONCRETE));
    s
}

/// A stout one in red or yellow, or a slim pillar.
pub(crate) fn hydrant(variant: u32) -> Sculpt {
    if variant % 3 == 2 {
        return pillar_hydrant();
    }
    let color = [[0.48, 0.03, 0.02], [0.62, 0.38, 0.01]][variant as usize % 3];
    let red = paint::fixed(Surface::Painted, color);
    let profile = [
        (0.0, 0.0),
        (0.16, 0.0),
        (0.16, 0.04),
        (0.11, 0.06),
        (0.105, 0.50),
        (0.14, 0.51),
        (0.14, 0.55),
        (0.115, 0.56),
        (0.105, 0.66),
        (0.06, 0.73),
        (0.035, 0.74),
        (0.035, 0.79),
        (0.0, 0.79),
    ];
    let mut s = Sculpt::lathe(&profile, 18, 35.0, red);
    let cap = |from: Vec3, to: Vec3, r: f32| Sculpt::tube(&[(from, r), (to, r)], 14, red);
    s.add(cap(Vec3::new(0.08, 0.0, 0.42), Vec3::new(0.19, 0.0, 0.42), 0.065));
    s.add(cap(Vec3::new(0.0, 0.08, 0.46), Vec3::new(0.0, 0.17, 0.46), 0.045).both_sides());
    s
}

/// A pillar of 1.1 m with two outlets, as in central Europe.
fn pillar_hydrant() -> Sculpt {
    let red = paint::fixed(Surface::Painted, [0.45, 0.03, 0.02]);
    let profile =
        [(0.0, 0.0), (0.13, 0.0), (0.13, 0.05), (0.085, 0.08), (0.08, 0.98), (0.095, 1.0), (0.08, 1.06), (0.0, 1.12)];
    let mut s = Sculpt::lathe(&profile, 16, 35.0, red);
    for y in [-1.0, 1.0] {
        let outlet = [(Vec3::new(0.0, 0.06 * y, 0.72), 0.045), (Vec3::new(0.0, 0.17 * y, 0.72), 0.045)];
        s.add(Sculpt::tube(&outlet, 12, paint::STEEL).both_sides());
    }
    s
}

pub(crate) fn post_box(variant: u32) -> Sculpt {
    let color = paint::fixed(Surface::Painted, [[0.72, 0.46, 0.01], [0.50, 0.02, 0.02]][variant as usize % 2]);
    let mut s = Sculpt::cuboid(Vec3::new(-0.20, -0.24, 0.42), Vec3::new(0.20, 0.24, 1.25), 0.045, color);
    let front = |y: f32, z0: f32, z1: f32| {
        Region::end(&rounded(&[(-y, z0), (y, z0), (y, z1), (-y, z1)], 0.01)).facing(Vec3::X, 0.9)
    };
    s.paint(&front(0.16, 1.08, 1.11), paint::DARK);
    s.paint(&front(0.13, 0.78, 0.98), paint::fixed(Surface::Plate, [0.75, 0.75, 0.73]));
    s.add(Sculpt::cuboid(Vec3::new(0.19, -0.18, 1.115), Vec3::new(0.24, 0.18, 1.13), 0.0, color));
    s.add(Sculpt::cuboid(Vec3::new(-0.07, -0.07, 0.0), Vec3::new(0.07, 0.07, 0.43), 0.0, paint::DARK_STEEL));
    s.add(Sculpt::cuboid(Vec3::new(-0.16, -0.16, 0.0), Vec3::new(0.16, 0.16, 0.03), 0.0, paint::DARK_STEEL));
    s
}

/// How many bollards there are.
pub(crate) const BOLLARDS: u32 = 6;
/// The place of the plastic delineator among them.
pub(crate) const DELINEATOR: u32 = 2;

/// Of cast iron with a band, a steel tube, a plastic delineator, of concrete, of timber, or slim in black.
pub(crate) fn bollard(variant: u32) -> Sculpt {
    let band = |low: f32, high: f32| Region::all().beyond(Vec3::Z, low).within(Vec3::Z, high);
    let white = paint::fixed(Surface::Plate, [0.75, 0.75, 0.75]);
    let stick = |radius: f32, height: f32, material: Material| {
        let profile = [
            (0.0, 0.0),
            (radius, 0.0),
            (radius, height - 0.3),
            (radius, height - 0.2),
            (radius, height - 0.1),
            (radius, height - 0.6 * radius),
            (0.6 * radius, height),
            (0.0, height),
        ];
        Sculpt::lathe(&profile, 16, 35.0, material)
    };
    match variant % BOLLARDS {
        1 => {
            let mut s = stick(0.057, 0.95, paint::STEEL);
            s.paint(&band(0.75, 0.85), paint::fixed(Surface::Plate, [0.55, 0.03, 0.02]));
            s
        }
        DELINEATOR => {
            let mut s = stick(0.04, 0.95, paint::fixed(Surface::Plastic, [0.75, 0.15, 0.01]));
            s.paint(&band(0.65, 0.75), white);
            s.paint(&band(0.85, 0.93), white);
            s.add(Sculpt::post(Vec3::ZERO, 0.04, 0.11, 0.10, 14, paint::DARK));
            s
        }
        3 => {
            let profile =
                [(0.0, 0.0), (0.16, 0.0), (0.14, 0.55), (0.15, 0.62), (0.13, 0.72), (0.06, 0.78), (0.0, 0.79)];
            Sculpt::lathe(&profile, 16, 35.0, paint::CONCRETE)
        }
        4 => {
            let mut s = stick(0.075, 0.92, paint::fixed(Surface::Wood, [0.16, 0.10, 0.06]));
            s.paint(&band(0.72, 0.82), white);
            s
        }
        5 => stick(0.045, 1.05, paint::DARK_STEEL),
        _ => cast_bollard(),
    }
}

fn cast_bollard() -> Sculpt {
    let mut s = Sculpt::lathe(
        &[
            (0.0, 0.0),
            (0.085, 0.0),
            (0.085, 0.05),
            (0.062, 0.07),
            (0.058, 0.76),
            (0.072, 0.77),
            (0.072, 0.80),
            (0.058, 0.82),
            (0.045, 0.87),
            (0.0, 0.90),
        ],
        16,
        35.0,
        paint::DARK_STEEL,
    );
    let band = paint::fixed(Surface::Plate, [0.75, 0.75, 0.75]);
    s.paint(&Region::all().beyond(Vec3::Z, 0.60).within(Vec3::Z, 0.68), band);
    s
}

pub(crate) fn cone() -> Sculpt {
    let orange = Material::new(Surface::Plastic, [0.78, 0.12, 0.01], ClassTag::Static);
    let mut s = Sculpt::cuboid(Vec3::new(-0.19, -0.19, 0.0), Vec3::new(0.19, 0.19, 0.035), 0.01, paint::DARK);
    let mut body =
        Sculpt::lathe(&[(0.14, 0.035), (0.135, 0.05), (0.032, 0.72), (0.024, 0.735), (0.0, 0.735)], 18, 40.0, orange);
    let white = paint::fixed(Surface::Plate, [0.80; 3]);
    body.paint(&Region::all().beyond(Vec3::Z, 0.28).within(Vec3::Z, 0.40), white);
    body.paint(&Region::all().beyond(Vec3::Z, 0.50).within(Vec3::Z, 0.58), white);
    s.add(body);
    s
}

pub(crate) fn cabinet() -> Sculpt {
    let grey = paint::fixed(Surface::Painted, [0.33, 0.35, 0.34]);
    let mut s = Sculpt::cuboid(Vec3::new(-0.24, -0.45, 0.12), Vec3::new(0.24, 0.45, 1.32), 0.015, grey);
    let front = |y0: f32, y1: f32, z0: f32, z1: f32| {
        Region::end(&[(y0, z0), (y1, z0), (y1, z1), (y0, z1)].map(Vec2::from)).facing(Vec3::X, 0.9)
    };
    s.paint(&front(-0.006, 0.006, 0.16, 1.28), paint::DARK);
    for i in 0..5 {
        let z = 1.08 + 0.03 * i as f32;
        s.paint(&front(-0.36, -0.10, z, z + 0.012), paint::DARK);
        s.paint(&front(0.10, 0.36, z, z + 0.012), paint::DARK);
    }
    s.add(Sculpt::cuboid(Vec3::new(0.24, 0.03, 0.70), Vec3::new(0.265, 0.06, 0.85), 0.005, paint::DARK));
    s.add(Sculpt::cuboid(Vec3::new(-0.27, -0.48, 1.32), Vec3::new(0.27, 0.48, 1.37), 0.015, grey));
    s.add(Sculpt::cuboid(Vec3::new(-0.26, -0.47, 0.0), Vec3::new(0.26, 0.47, 0.12), 0.0, paint::CONCRETE));
    s
}

pub(crate) fn dumpster(variant: u32) -> Sculpt {
    let color = paint::fixed(
        Surface::Painted,
        [[0.03, 0.13, 0.07], [0.06, 0.10, 0.20], [0.20, 0.20, 0.19]][variant as usize % 3],
    );
    let section = [
        Vec2::new(-0.42, 0.18),
        Vec2::new(0.42, 0.18),
        Vec2::new(0.58, 1.05),
        Vec2::new(0.52, 1.15),
        Vec2::new(-0.52, 1.25),
        Vec2::new(-0.58, 1.15),
    ];
    let mut s = Sculpt::slab(&section, -0.85, 0.85, 30.0, color);
    let lid = [Vec2::new(-0.60, 1.24), Vec2::new(0.58, 1.13), Vec2::new(0.58, 1.17), Vec2::new(-0.55, 1.30)];
    for (a, b) in [(-0.87, -0.01), (0.01, 0.87)] {
        s.add(Sculpt::slab(&lid, a, b, 30.0, paint::fixed(Surface::Plastic, [0.03; 3])));
    }
    for y in [-0.6, -0.2, 0.2, 0.6] {
        s.add(Sculpt::slab(
            &[Vec2::new(0.40, 0.2), Vec2::new(0.47, 0.2), Vec2::new(0.61, 1.0), Vec2::new(0.54, 1.0)],
            y - 0.03,
            y + 0.03,
            30.0,
            color,
        ));
    }
    s.add(Sculpt::cuboid(Vec3::new(-0.1, 0.85, 0.82), Vec3::new(0.1, 1.0, 0.94), 0.0, color).both_sides());
    for x in [-0.34, 0.34] {
        s.add(
            Sculpt::tube(&[(Vec3::new(x, 0.64, 0.09), 0.09), (Vec3::new(x, 0.70, 0.09), 0.09)], 14, paint::DARK)
                .both_sides(),
        );
        s.add(
            Sculpt::cuboid(Vec3::new(x - 0.03, 0.62, 0.09), Vec3::new(x + 0.03, 0.72, 0.20), 0.0, paint::STEEL)
                .both_sides(),
        );
    }
    s
}

/// A hoop along x.
pub(crate) fn bike_rack() -> Sculpt {
    let path: Vec<(Vec3, f32)> = [
        (-0.40, 0.0),
        (-0.40, 0.62),
        (-0.36, 0.74),
        (-0.26, 0.80),
        (0.0, 0.80),
        (0.26, 0.80),
        (0.36, 0.74),
        (0.40, 0.62),
        (0.40, 0.0),
    ]
    .iter()
    .map(|&(x, z)| (Vec3::new(x, 0.0, z), 0.024))
    .collect();
    let mut s = Sculpt::sweep(
        &path.iter().map(|&(p, r)| (p, Vec2::splat(r))).collect::<Vec<_>>(),
        Vec3::Y,
        10,
        2.0,
        true,
        paint::STEEL,
    );
    for x in [-0.40, 0.40] {
        s.add(Sculpt::post(Vec3::new(x, 0.0, 0.0), 0.012, 0.06, 0.06, 12, paint::STEEL));
    }
    s
}
