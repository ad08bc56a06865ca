//! What keeps traffic on its way: guard rails, blocks of concrete and plastic, boards about roadworks.

use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

const ORANGE: Material = Material::new(Surface::Plastic, [0.78, 0.14, 0.01], ClassTag::Static);
const RED: Material = paint::fixed(Surface::Plastic, [0.58, 0.025, 0.02]);
const WHITE: Material = paint::fixed(Surface::Plate, [0.78, 0.78, 0.76]);

fn block(low: (f32, f32, f32), high: (f32, f32, f32), bevel: f32, material: Material) -> Sculpt {
    Sculpt::cuboid(Vec3::from(low), Vec3::from(high), bevel, material)
}

/// Four metres of steel beam along x on posts, its face towards −y.
pub(crate) fn guard_rail() -> Sculpt {
    let zinc = Material::new(Surface::Metal, [0.46, 0.47, 0.48], ClassTag::GuardRail);
    // The two waves of the beam, in section.
    let wave = [
        (0.00, 0.43),
        (-0.055, 0.46),
        (-0.08, 0.505),
        (-0.055, 0.55),
        (0.0, 0.585),
        (-0.055, 0.62),
        (-0.08, 0.665),
        (-0.055, 0.71),
        (0.0, 0.74),
    ];
    // Rolled of 8 mm sheet: there and back.
    let ring = |x: f32| -> Vec<Vec3> {
        let there = wave.iter().map(|&(y, z)| Vec3::new(x, y - 0.004, z));
        let back = wave.iter().rev().map(|&(y, z)| Vec3::new(x, y + 0.004, z));
        there.chain(back).collect()
    };
    let mut beam = Sculpt::new();
    beam.grid(&[ring(2.0), ring(-2.0)], true, zinc);
    let mut s = beam.smooth(50.0);
    for x in [-1.0, 1.0] {
        s.add(block((x - 0.05, 0.03, 0.0), (x + 0.05, 0.13, 0.72), 0.0, zinc));
        s.add(block((x - 0.04, -0.05, 0.50), (x + 0.04, 0.05, 0.66), 0.0, zinc));
    }
    s
}

/// Three metres of concrete along x with the New Jersey profile (FHWA: 810 mm high, 610 mm wide).
pub(crate) fn jersey_barrier() -> Sculpt {
    let concrete = Material::new(Surface::Concrete, [0.44, 0.43, 0.41], ClassTag::GuardRail);
    let half = [(0.305, 0.0), (0.305, 0.075), (0.125, 0.33), (0.075, 0.79), (0.055, 0.81)];
    let outline: Vec<Vec2> =
        half.iter().map(|&(y, z)| Vec2::new(y, z)).chain(half.iter().rev().map(|&(y, z)| Vec2::new(-y, z))).collect();
    // A slab runs along y: turned about it runs along x.
    let mut s = Sculpt::slab(&outline, -1.49, 1.49, 20.0, concrete)
        .placed(glam::Affine3A::from_rotation_z(std::f32::consts::FRAC_PI_2));
    let dark = Material { base_color: [0.10; 3], ..concrete };
    for x in [-0.9, 0.9] {
        s.paint(&Region::all().beyond(Vec3::X, x - 0.25).within(Vec3::X, x + 0.25).within(Vec3::Z, 0.055), dark);
    }
    for x in [-0.75, 0.75] {
        s.add(block(
            (x - 0.05, -0.02, 0.81),
            (x + 0.05, 0.02, 0.90),
            0.0,
            Material { base_color: [0.7, 0.4, 0.02], ..WHITE },
        ));
    }
    s
}

/// Two metres of water-filled plastic along x, red or white.
pub(crate) fn water_barrier(variant: u32) -> Sculpt {
    let plastic = if variant.is_multiple_of(2) { RED } else { paint::fixed(Surface::Plastic, [0.70, 0.70, 0.68]) };
    let mut s = block((-1.0, -0.24, 0.0), (1.0, 0.24, 0.22), 0.05, plastic);
    s.add(block((-0.98, -0.12, 0.20), (0.98, 0.12, 0.78), 0.05, plastic));
    for x in [-0.66, 0.0, 0.66] {
        s.add(block((x - 0.15, -0.19, 0.18), (x + 0.15, 0.19, 0.70), 0.06, plastic));
    }
    s.add(Sculpt::post(Vec3::new(-0.6, 0.0, 0.77), 0.04, 0.06, 0.06, 12, paint::DARK));
    s
}

/// Red and white stripes on a board along x.
fn striped(x: [f32; 2], z: [f32; 2], y: f32, slant: f32) -> Sculpt {
    let mut s = block((x[0], y - 0.015, z[0]), (x[1], y + 0.015, z[1]), 0.0, WHITE);
    let (pitch, h) = (0.30, z[1] - z[0]);
    let count = ((x[1] - x[0]) / pitch).ceil() as i32 + 1;
    for k in -((slant * h / pitch) as i32 + 1)..count {
        let from = x[0] + pitch * k as f32;
        let corners = [
            (from, z[0]),
            (from + pitch / 2.0, z[0]),
            (from + pitch / 2.0 + slant * h, z[1]),
            (from + slant * h, z[1]),
        ];
        let stripe = corners.map(Vec2::from);
        for facing in [Vec3::Y, Vec3::NEG_Y] {
            s.paint(&Region::elevation(&stripe).facing(facing, 0.9), paint::fixed(Surface::Plate, [0.55, 0.02, 0.02]));
        }
    }
    s
}

/// Two metres of boards along x about roadworks, on rubber feet.
pub(crate) fn works_barrier() -> Sculpt {
    let mut s = striped([-1.0, 1.0], [0.82, 1.02], 0.0, 0.0);
    s.add(striped([-1.0, 1.0], [0.18, 0.30], 0.0, 0.0));
    for x in [-0.85, 0.85] {
        s.add(block((x - 0.03, -0.045, 0.05), (x + 0.03, -0.016, 1.04), 0.0, paint::STEEL));
        s.add(block((x - 0.13, -0.40, 0.0), (x + 0.13, 0.40, 0.10), 0.02, paint::DARK));
    }
    let amber = paint::fixed(Surface::LitSign, [0.80, 0.42, 0.02]);
    s.add(
        Sculpt::lathe(&[(0.0, 1.10), (0.085, 1.12), (0.085, 1.28), (0.0, 1.30)], 16, 40.0, amber).at(Vec3::X * -0.85),
    );
    s.add(block((-0.93, -0.05, 1.02), (-0.77, 0.05, 1.11), 0.01, paint::fixed(Surface::Plastic, [0.70, 0.40, 0.02])));
    s
}

/// A barricade of three slanting striped boards that closes a road (MUTCD type III), 1.8 m along x.
pub(crate) fn barricade() -> Sculpt {
    let mut s = Sculpt::new();
    for z in [0.45, 0.92, 1.38] {
        s.add(striped([-0.9, 0.9], [z, z + 0.2], 0.0, 1.0));
    }
    for x in [-0.72, 0.72] {
        s.add(block((x - 0.03, -0.05, 0.05), (x + 0.03, -0.016, 1.6), 0.0, paint::STEEL));
        s.add(block((x - 0.03, -0.65, 0.0), (x + 0.03, 0.65, 0.06), 0.0, paint::STEEL));
        s.add(block(
            (x - 0.16, 0.35, 0.06),
            (x + 0.16, 0.62, 0.16),
            0.04,
            paint::fixed(Surface::Cloth, [0.55, 0.17, 0.03]),
        ));
    }
    s
}

/// A mesh fence about a building site, 3.5 m along x and 2 m high, on concrete feet.
pub(crate) fn site_fence() -> Sculpt {
    let zinc = Material::new(Surface::Metal, [0.42, 0.43, 0.44], ClassTag::Fences);
    let rod = |a: (f32, f32), b: (f32, f32), r: f32, sides: usize| {
        Sculpt::tube(&[(Vec3::new(a.0, 0.0, a.1), r), (Vec3::new(b.0, 0.0, b.1), r)], sides, zinc)
    };
    let mut s = Sculpt::new();
    for x in [-1.7, 1.7] {
        s.add(rod((x, 0.05), (x, 2.0), 0.021, 8));
        s.add(block((x - 0.11, -0.34, 0.0), (x + 0.11, 0.34, 0.13), 0.03, paint::CONCRETE));
    }
    for z in [0.18, 0.62, 1.06, 1.5, 1.97] {
        s.add(rod((-1.7, z), (1.7, z), if z == 0.18 || z == 1.97 { 0.018 } else { 0.007 }, 6));
    }
    for k in 1..34 {
        let x = -1.7 + 0.1 * k as f32;
        s.add(rod((x, 0.18), (x, 1.97), 0.005, 3));
    }
    s
}

/// An orange drum with white bands.
pub(crate) fn drum() -> Sculpt {
    let profile = [
        (0.0, 0.06),
        (0.29, 0.06),
        (0.28, 0.35),
        (0.265, 0.36),
        (0.25, 0.64),
        (0.235, 0.65),
        (0.22, 0.95),
        (0.20, 0.99),
        (0.0, 1.0),
    ];
    let mut s = Sculpt::lathe(&profile, 20, 35.0, ORANGE);
    for z in [0.40, 0.70] {
        s.paint(&Region::all().beyond(Vec3::Z, z).within(Vec3::Z, z + 0.12), WHITE);
    }
    s.add(Sculpt::post(Vec3::ZERO, 0.08, 0.36, 0.34, 20, paint::DARK));
    s.add(block((-0.09, -0.015, 0.99), (0.09, 0.015, 1.06), 0.01, ORANGE));
    s
}

/// A flat beacon board with slanting stripes, 1 m high, facing +x.
pub(crate) fn beacon() -> Sculpt {
    let mut s = striped([-0.125, 0.125], [0.14, 1.14], 0.0, 1.0)
        .placed(glam::Affine3A::from_rotation_z(std::f32::consts::FRAC_PI_2));
    s.add(block((-0.20, -0.40, 0.0), (0.20, 0.40, 0.12), 0.03, paint::DARK));
    let amber = paint::fixed(Surface::LitSign, [0.80, 0.42, 0.02]);
    s.add(block((-0.05, -0.07, 1.13), (0.05, 0.07, 1.22), 0.0, paint::fixed(Surface::Plastic, [0.70, 0.40, 0.02])));
    s.add(Sculpt::ellipsoid(Vec3::Z * 1.30, Vec3::new(0.05, 0.09, 0.09), 14, amber));
    s
}

/// The boom of a car park: cabinet at the origin, 3 m of striped arm along +y, lowered.
pub(crate) fn boom_gate() -> Sculpt {
    let mut s =
        block((-0.17, -0.20, 0.0), (0.17, 0.20, 1.05), 0.02, paint::fixed(Surface::Painted, [0.70, 0.36, 0.02]));
    s.add(block((-0.19, -0.22, 1.05), (0.19, 0.22, 1.10), 0.01, paint::DARK_STEEL));
    let mut arm = block((0.18, -0.45, 0.88), (0.23, 3.2, 0.98), 0.0, WHITE);
    for k in 0..6 {
        let y = 0.15 + 0.56 * k as f32;
        arm.paint(
            &Region::all().beyond(Vec3::Y, y).within(Vec3::Y, y + 0.28),
            paint::fixed(Surface::Plate, [0.55, 0.02, 0.02]),
        );
    }
    s.add(arm);
    s.add(block((0.15, -0.6, 0.80), (0.26, -0.3, 1.06), 0.01, paint::DARK_STEEL));
    s
}
