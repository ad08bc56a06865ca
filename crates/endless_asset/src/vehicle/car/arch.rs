//! Wheel arches.

use crate::shape::{Region, Sculpt};
use crate::vehicle::paint;
use crate::vehicle::shell::Arch;
use glam::{Vec2, Vec3};

pub(super) fn disc(arch: &Arch, radius: f32) -> Region {
    let polygon: Vec<Vec2> = (0..24)
        .map(|i| {
            let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * i as f32 / 24.0);
            Vec2::new(arch.x + radius * cos, arch.z + radius * sin)
        })
        .collect();
    Region::side(&polygon)
}

/// Cuts a wheel arch on both sides and lines it with a dark wheel well.
pub(crate) fn open_arch(body: &mut Sculpt, arch: &Arch, half_width: f32, clad: bool) {
    let inner = half_width - 0.36;
    body.remove(&disc(arch, arch.radius).beyond(Vec3::Y, inner));
    body.remove(&disc(arch, arch.radius).beyond(Vec3::Y, inner).mirrored());
    let chord = arch.radius * endless_world::math::cos(std::f32::consts::PI / 24.0);
    let on_rim = |p: Vec3| {
        let r = Vec2::new(p.x - arch.x, p.z - arch.z).length();
        r > chord - 2e-3 && r < arch.radius + 2e-3 && p.y.abs() > inner + 0.02
    };
    // The wall of the well hangs on the very edge of the cut: first a narrow lip, then darkness.
    let mut well = Sculpt::new();
    for face in body.faces() {
        for k in 0..3 {
            let (a, b) = (face.corners[k], face.corners[(k + 1) % 3]);
            if on_rim(a) && on_rim(b) && (a - b).length() > 1e-4 && a.y * b.y > 0.0 {
                let depth = |p: Vec3, y: f32| Vec3::new(p.x, (p.y.abs() - y).max(inner).copysign(p.y), p.z);
                let lip = if clad { paint::TRIM } else { paint::BODY };
                well.quad([b, a, depth(a, 0.025), depth(b, 0.025)], lip);
                well.quad([depth(b, 0.025), depth(a, 0.025), depth(a, 9.0), depth(b, 9.0)], paint::DARK);
            }
        }
    }
    let wall: Vec<Vec3> = disc_points(arch).map(|p| Vec3::new(p.x, inner, p.y)).collect();
    let mut back = Sculpt::new();
    back.polygon(&wall.iter().rev().copied().collect::<Vec<_>>(), paint::DARK);
    back.remove(&Region::all().within(Vec3::Z, arch.z - 0.1));
    well.add(back.both_sides());
    body.add(well);
}

fn disc_points(arch: &Arch) -> impl Iterator<Item = Vec2> + '_ {
    (0..24).map(|i| {
        let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::TAU * i as f32 / 24.0);
        Vec2::new(arch.x + arch.radius * cos, arch.z + arch.radius * sin)
    })
}
