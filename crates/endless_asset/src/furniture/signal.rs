//! Traffic lights.

use super::lamp::pole;
use super::paint;
use super::signal_look::SignalLook;
use crate::shape::Sculpt;
use endless_scene::Material;
use glam::{Affine3A, Quat, Vec3};
use std::f32::consts::FRAC_PI_2;

/// A lens facing +x with a visor over it.
fn lens(centre: Vec3, radius: f32, material: Material, housing: Material) -> Sculpt {
    let mut s = Sculpt::lathe(&[(radius, 0.0), (radius * 0.7, 0.016), (0.0, 0.024)], 20, 60.0, material);
    s.add(Sculpt::lathe(&[(radius * 1.12, 0.0), (radius * 1.12, 0.012), (radius, 0.012)], 20, 30.0, housing));
    // The visor: most of a cylinder, open below, seen from both sides.
    let n = 14;
    let (mut outer, mut inner) = (Vec::new(), Vec::new());
    for (k, depth) in [(0, 0.0f32), (1, 1.0)] {
        let ring = |r: f32| -> Vec<Vec3> {
            (0..=n)
                .map(|i| {
                    let angle = -2.25 + 4.5 * i as f32 / n as f32;
                    let (sin, cos) = endless_world::math::sin_cos(angle);
                    // Longest on top (local −x, which turns upwards).
                    let reach = depth * radius * (0.9 + 0.9 * (0.5 + 0.5 * cos));
                    Vec3::new(-r * cos, r * sin, reach + 0.002 * k as f32)
                })
                .collect()
        };
        outer.push(ring(radius * 1.12).into_iter().rev().collect());
        inner.push(ring(radius * 1.09));
    }
    let mut visor = Sculpt::new();
    visor.grid(&outer, false, housing);
    visor.grid(&inner, false, paint::HOUSING);
    s.add(visor.smooth(40.0));
    // z turns to +x, −x to +z.
    s.placed(Affine3A::from_rotation_translation(Quat::from_rotation_y(FRAC_PI_2), centre))
}

/// Middles of the heads on a pole.
pub(crate) fn heads_on_pole(look: &SignalLook) -> Vec<Vec3> {
    side_by_side(Vec3::new(0.28, 0.0, 3.2), look)
}

/// Middles of the heads on a mast, that on its pole and those on its arm.
pub(crate) fn heads_on_mast(look: &SignalLook) -> [Vec<Vec3>; 2] {
    let on_arm = [-2.6, -5.2].map(|y| Vec3::new(0.24, y, 5.80)).to_vec();
    [side_by_side(Vec3::new(0.33, 0.0, 3.2), look), on_arm]
}

/// Middles of the heads on a pole that bends over the road, that on the pole and that under its end.
pub(crate) fn heads_on_curved_mast(look: &SignalLook) -> [Vec<Vec3>; 2] {
    [side_by_side(Vec3::new(0.31, 0.0, 3.2), look), vec![Vec3::new(0.16, -4.2, 5.22)]]
}

/// One head, or two as near to one another as they fit.
fn side_by_side(middle: Vec3, look: &SignalLook) -> Vec<Vec3> {
    let half = look.outline()[0] + if look.plate.is_some() { 0.01 } else { 0.035 };
    if look.paired { [-half, half].map(|y| middle + Vec3::Y * y).to_vec() } else { vec![middle] }
}

/// A three-lens head facing +x, its middle at this place, on a back-plate if it has one.
fn head(centre: Vec3, look: &SignalLook) -> Sculpt {
    let size = look.head;
    let [width, height] = size.housing;
    let mut s = Sculpt::cuboid(
        centre + Vec3::new(-0.17, -width, -height),
        centre + Vec3::new(0.0, width, height),
        0.025,
        look.housing,
    );
    if let Some(plate) = look.plate {
        let board = |x: [f32; 2], half: [f32; 2], material: Material| {
            let corner = |x: f32, sign: f32| centre + Vec3::new(x, sign * half[0], sign * half[1]);
            Sculpt::cuboid(corner(x[0], -1.0), corner(x[1], 1.0), 0.008, material)
        };
        match plate.edge {
            None => s.add(board([-0.12, -0.10], size.plate, plate.face)),
            Some(edge) => {
                s.add(board([-0.12, -0.105], size.plate, edge));
                s.add(board([-0.115, -0.10], size.plate.map(|half| half - 0.045), plate.face));
            }
        }
    }
    for (i, m) in [paint::GREEN_LENS, paint::YELLOW_LENS, paint::RED_LENS].into_iter().enumerate() {
        let middle = centre + Vec3::new(0.002, 0.0, size.pitch * (i as f32 - 1.0));
        s.add(lens(middle, size.lens_radius, m, look.housing));
    }
    s
}

fn bracket(from: Vec3, to: Vec3, look: &SignalLook) -> Sculpt {
    Sculpt::tube(&[(from, 0.022), (to, 0.022)], 8, look.pole)
}

/// Heads before a pole, each on two brackets from it.
fn on_brackets(middles: &[Vec3], look: &SignalLook) -> Sculpt {
    let mut s = Sculpt::new();
    for &middle in middles {
        s.add(head(middle, look));
        for dz in [-0.3, 0.3] {
            let back = middle + Vec3::new(-0.15, 0.0, dz);
            s.add(bracket(Vec3::new(0.0, 0.0, back.z), back, look));
        }
    }
    s
}

/// A pole with a head at 3.2 m, or a pair.
pub(crate) fn pole_head(look: &SignalLook) -> Sculpt {
    let mut s = pole(3.75, 0.07, 0.055, look.pole);
    s.add(on_brackets(&heads_on_pole(look), look));
    s
}

/// Pole with an arm along −y.
pub(crate) fn mast(look: &SignalLook) -> Sculpt {
    let mut s = pole(5.95, 0.13, 0.10, look.pole);
    let [on_pole, on_arm] = heads_on_mast(look);
    s.add(on_brackets(&on_pole, look));
    let arm = [
        (Vec3::new(0.0, 0.12, 5.72), 0.075),
        (Vec3::new(0.0, -0.4, 5.76), 0.072),
        (Vec3::new(0.0, -3.0, 5.80), 0.055),
        (Vec3::new(0.0, -5.5, 5.80), 0.042),
    ];
    s.add(Sculpt::tube(&arm, 12, look.pole));
    for middle in on_arm {
        s.add(head(middle, look));
        s.add(bracket(middle * Vec3::new(0.0, 1.0, 1.0), middle - Vec3::X * 0.14, look));
    }
    s
}

/// Pole that bends over the road along −y.
pub(crate) fn curved_mast(look: &SignalLook) -> Sculpt {
    const BEND: f32 = 1.7;
    const STRAIGHT: f32 = 4.2;
    let bend = (0..=10).map(|k| {
        let (sin, cos) = endless_world::math::sin_cos(FRAC_PI_2 * k as f32 / 10.0);
        (Vec3::new(0.0, -BEND * (1.0 - cos), STRAIGHT + BEND * sin), 0.085 - 0.002 * k as f32)
    });
    let end = Vec3::new(0.0, -4.6, STRAIGHT + BEND + 0.08);
    let path: Vec<_> = [(Vec3::ZERO, 0.105)].into_iter().chain(bend).chain([(end, 0.05)]).collect();
    let mut s = Sculpt::tube(&path, 12, look.pole);
    let [on_pole, on_arm] = heads_on_curved_mast(look);
    s.add(on_brackets(&on_pole, look));
    for middle in on_arm {
        s.add(head(middle, look));
        // Behind the head, up to the arm.
        let back = middle - Vec3::X * 0.16;
        s.add(bracket(back - Vec3::Z * 0.3, back.with_z(end.z - 0.04), look));
    }
    s
}

/// Two poles 14 m apart along y, a wire between them, and two heads hung from it, facing +x.
pub(crate) fn span_wire(look: &SignalLook) -> Sculpt {
    let mut s = Sculpt::new();
    for y in [-7.0, 7.0] {
        s.add(pole(7.6, 0.15, 0.10, look.pole).at(Vec3::Y * y));
    }
    let cable = Material { base_color: [0.03; 3], ..look.pole };
    let sag = |y: f32, depth: f32| 7.4 - depth * (1.0 - (y / 7.0) * (y / 7.0));
    let wire = |depth: f32, r: f32| -> Sculpt {
        let path: Vec<(Vec3, f32)> =
            (0..=16).map(|i| -7.0 + 0.875 * i as f32).map(|y| (Vec3::new(0.0, y, sag(y, depth)), r)).collect();
        Sculpt::tube(&path, 6, cable)
    };
    s.add(wire(0.5, 0.014));
    s.add(wire(0.85, 0.010));
    for y in [-1.9, 1.9] {
        let top = sag(y, 0.85);
        s.add(head(Vec3::new(0.10, y, top - 0.72), look));
        s.add(bracket(Vec3::new(0.0, y, top - 0.2), Vec3::new(0.0, y, sag(y, 0.5)), look));
    }
    s
}

/// A head at 2.2 m for those who wait first in line, over one for cyclists, on a thin pole.
pub(crate) fn cycle_signal(look: &SignalLook) -> Sculpt {
    let mut s = pole(2.7, 0.05, 0.045, look.pole);
    let centre = Vec3::new(0.16, 0.0, 2.35);
    s.add(Sculpt::cuboid(
        centre - Vec3::new(0.10, 0.075, 0.25),
        centre + Vec3::new(0.0, 0.075, 0.25),
        0.015,
        look.housing,
    ));
    for (i, m) in [paint::GREEN_LENS, paint::YELLOW_LENS, paint::RED_LENS].into_iter().enumerate() {
        s.add(lens(centre + Vec3::new(0.002, 0.0, 0.155 * (i as f32 - 1.0)), 0.055, m, look.housing));
    }
    for dz in [-0.2, 0.2] {
        s.add(bracket(Vec3::new(0.0, 0.0, 2.35 + dz), Vec3::new(0.08, 0.0, 2.35 + dz), look));
    }
    s
}

/// Pedestrian signal: red above green at 2.4 m, and a push button.
pub(crate) fn walk(look: &SignalLook) -> Sculpt {
    let mut s = pole(2.75, 0.055, 0.05, look.pole);
    let centre = Vec3::new(0.22, 0.0, 2.4);
    s.add(Sculpt::cuboid(
        centre + Vec3::new(-0.14, -0.13, -0.27),
        centre + Vec3::new(0.0, 0.13, 0.27),
        0.02,
        look.housing,
    ));
    s.add(lens(centre + Vec3::new(0.002, 0.0, 0.125), 0.095, paint::RED_LENS, look.housing));
    s.add(lens(centre + Vec3::new(0.002, 0.0, -0.125), 0.095, paint::GREEN_LENS, look.housing));
    s.add(bracket(Vec3::new(0.0, 0.0, 2.4), centre - Vec3::X * 0.1, look));
    let yellow = Material { base_color: [0.70, 0.42, 0.01], ..look.housing };
    s.add(Sculpt::cuboid(Vec3::new(0.05, -0.05, 0.98), Vec3::new(0.12, 0.05, 1.20), 0.015, yellow));
    s
}
