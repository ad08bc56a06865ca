//! What serves passers-by: meters, machines, call boxes, chargers, stops.

use super::glyph::text;
use super::lamp::pole;
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

fn block(low: (f32, f32, f32), high: (f32, f32, f32), bevel: f32, material: Material) -> Sculpt {
    Sculpt::cuboid(Vec3::from(low), Vec3::from(high), bevel, material)
}

/// A rectangle on a face towards +x.
fn on_front(y: [f32; 2], z: [f32; 2]) -> Region {
    Region::end(&[(y[0], z[0]), (y[1], z[0]), (y[1], z[1]), (y[0], z[1])].map(Vec2::from)).facing(Vec3::X, 0.9)
}

fn lit(color: [f32; 3]) -> Material {
    Material::new(Surface::LitSign, color, ClassTag::Static)
}

/// A round head with a window on a pipe; facing +x.
pub(crate) fn parking_meter() -> Sculpt {
    let grey = paint::fixed(Surface::Painted, [0.20, 0.22, 0.24]);
    let mut s = Sculpt::post(Vec3::ZERO, 1.08, 0.032, 0.032, 12, paint::STEEL);
    s.add(Sculpt::post(Vec3::ZERO, 0.02, 0.09, 0.09, 14, paint::STEEL));
    s.add(block((-0.055, -0.09, 1.05), (0.055, 0.09, 1.30), 0.02, grey));
    s.add(Sculpt::ellipsoid(Vec3::Z * 1.33, Vec3::new(0.065, 0.10, 0.13), 18, grey));
    s.paint(&on_front([-0.07, 0.07], [1.32, 1.42]), paint::GLASS);
    s.paint(&on_front([-0.05, 0.05], [1.12, 1.16]), paint::DARK);
    s.add(block((0.05, -0.02, 1.20), (0.075, 0.02, 1.24), 0.005, paint::STEEL));
    s
}

/// A ticket machine with a solar panel, facing +x.
pub(crate) fn pay_station() -> Sculpt {
    let blue = paint::fixed(Surface::Painted, [0.03, 0.06, 0.14]);
    let mut s = block((-0.17, -0.22, 0.0), (0.17, 0.22, 1.55), 0.025, blue);
    s.paint(&on_front([-0.15, 0.15], [1.22, 1.40]), paint::GLASS);
    s.paint(&on_front([-0.14, -0.02], [0.98, 1.15]), paint::STEEL);
    s.paint(&on_front([0.03, 0.14], [0.85, 1.15]), paint::STEEL);
    s.paint(&on_front([-0.12, 0.12], [0.62, 0.74]), paint::DARK);
    s.add(block((-0.19, -0.24, 1.55), (0.20, 0.24, 1.61), 0.015, blue));
    s.add(Sculpt::post(Vec3::Z * 1.6, 0.45, 0.025, 0.025, 10, paint::STEEL));
    s.add(block((-0.15, -0.17, 2.03), (0.15, 0.17, 2.06), 0.0, paint::GLASS));
    s.add(block((0.03, -0.16, 1.66), (0.05, 0.16, 1.98), 0.0, paint::BLUE));
    s.add(text("P", Vec3::new(0.054, 0.0, 1.82), 0.22, 0.04, paint::WHITE));
    s
}

/// A glazed call box with a lit head on all sides.
pub(crate) fn phone_booth(variant: u32) -> Sculpt {
    let frame = paint::fixed(Surface::Painted, [[0.45, 0.02, 0.025], [0.10, 0.11, 0.12]][variant as usize % 2]);
    let mut s = block((-0.46, -0.46, 0.0), (0.46, 0.46, 0.10), 0.0, frame);
    for (x, y) in [(-0.43, -0.43), (0.43, -0.43), (0.43, 0.43), (-0.43, 0.43)] {
        s.add(block((x - 0.035, y - 0.035, 0.1), (x + 0.035, y + 0.035, 2.15), 0.0, frame));
    }
    for k in 0..4 {
        let turn = glam::Affine3A::from_rotation_z(std::f32::consts::FRAC_PI_2 * k as f32);
        let mut side = block((0.425, -0.40, 0.55), (0.437, 0.40, 2.10), 0.0, if k == 2 { frame } else { paint::GLASS });
        side.add(block((0.41, -0.40, 0.1), (0.45, 0.40, 0.55), 0.0, frame));
        if k != 2 {
            for i in 1..6 {
                let z = 0.55 + 0.26 * i as f32;
                side.add(block((0.42, -0.40, z - 0.014), (0.447, 0.40, z + 0.014), 0.0, frame));
            }
            for y in [-0.14, 0.14] {
                side.add(block((0.42, y - 0.014, 0.55), (0.447, y + 0.014, 2.10), 0.0, frame));
            }
        }
        side.add(block((0.44, -0.36, 2.17), (0.475, 0.36, 2.33), 0.0, lit([0.78, 0.76, 0.68])));
        side.add(text("PHONE", Vec3::new(0.478, 0.0, 2.25), 0.11, 0.018, lit([0.05; 3])));
        s.add(side.placed(turn));
    }
    s.add(block((-0.47, -0.47, 2.13), (0.47, 0.47, 2.37), 0.0, frame));
    s.add(block((-0.44, -0.44, 2.37), (0.44, 0.44, 2.46), 0.08, frame));
    s.add(block((-0.38, -0.13, 1.05), (-0.25, 0.13, 1.55), 0.01, paint::DARK));
    s
}

/// Two or three boxes for newspapers, facing +x.
pub(crate) fn news_box(variant: u32) -> Sculpt {
    let colors = [[0.50, 0.05, 0.03], [0.03, 0.12, 0.36], [0.72, 0.48, 0.02], [0.04, 0.24, 0.12]];
    let mut s = Sculpt::new();
    let n = 2 + variant as usize % 2;
    for i in 0..n {
        let y = 0.5 * (i as f32 - 0.5 * (n - 1) as f32);
        let m = paint::fixed(Surface::Painted, colors[(i + variant as usize) % 4]);
        let section = [(-0.20, 0.38), (0.20, 0.38), (0.20, 0.98), (0.10, 1.12), (-0.20, 1.12)].map(Vec2::from);
        let mut case = Sculpt::slab(&section, y - 0.21, y + 0.21, 20.0, m);
        case.paint(&on_front([y - 0.16, y + 0.16], [0.70, 0.95]), paint::GLASS);
        case.paint(&on_front([y - 0.16, y + 0.16], [0.46, 0.60]), paint::fixed(Surface::Plate, [0.75, 0.74, 0.70]));
        s.add(case);
        s.add(block((0.20, y - 0.10, 0.63), (0.23, y + 0.10, 0.66), 0.0, paint::STEEL));
        for dy in [-0.16, 0.16] {
            s.add(block((-0.15, y + dy - 0.02, 0.0), (-0.11, y + dy + 0.02, 0.38), 0.0, paint::DARK_STEEL));
            s.add(block((0.11, y + dy - 0.02, 0.0), (0.15, y + dy + 0.02, 0.38), 0.0, paint::DARK_STEEL));
        }
    }
    s
}

/// A charging point for two cars with hanging cables, facing +x.
pub(crate) fn charger() -> Sculpt {
    let white = paint::fixed(Surface::Painted, [0.66, 0.67, 0.67]);
    let mut s = block((-0.15, -0.22, 0.0), (0.15, 0.22, 1.62), 0.05, white);
    s.paint(&on_front([-0.13, 0.13], [1.22, 1.42]), paint::GLASS);
    s.paint(&on_front([-0.17, 0.17], [0.45, 0.52]), paint::fixed(Surface::LitSign, [0.05, 0.45, 0.16]));
    for side in [-1.0, 1.0] {
        let path: Vec<(Vec3, f32)> =
            [(0.23, 1.05), (0.30, 0.75), (0.33, 0.40), (0.28, 0.22), (0.25, 0.40), (0.23, 0.85)]
                .iter()
                .map(|&(y, z)| (Vec3::new(0.05, side * y, z), 0.014))
                .collect();
        s.add(Sculpt::tube(&path, 6, paint::DARK));
        s.add(block((-0.02, side * 0.235 - 0.03, 0.95), (0.12, side * 0.235 + 0.03, 1.12), 0.01, paint::DARK));
    }
    s.add(text("E", Vec3::new(0.154, 0.0, 0.85), 0.2, 0.035, paint::fixed(Surface::Plate, [0.03, 0.30, 0.10])));
    s
}

/// A flag with a stop's sign and its timetable, facing +x.
pub(crate) fn bus_stop() -> Sculpt {
    let mut s = pole(2.95, 0.042, 0.036, paint::POLE);
    let green = paint::face([0.01, 0.16, 0.07]);
    let ring: Vec<Vec3> = super::sign::regular(28, 0.24, 0.0).iter().map(|p| Vec3::new(0.0, p.x, p.y + 2.62)).collect();
    let at = |x: f32| -> Vec<Vec3> { ring.iter().map(|p| *p + Vec3::X * x).collect() };
    let mut plate = Sculpt::new();
    plate.polygon(&at(0.062), paint::face([0.70, 0.50, 0.01]));
    plate.polygon(&at(0.045).into_iter().rev().collect::<Vec<_>>(), paint::SIGN_BACK);
    plate.grid(&[at(0.045), at(0.062)], true, paint::SIGN_BACK);
    s.add(plate);
    s.add(text("H", Vec3::new(0.065, 0.0, 2.62), 0.26, 0.05, green));
    s.add(block((0.045, -0.26, 2.18), (0.06, 0.26, 2.34), 0.0, paint::WHITE));
    s.add(text("LINE 4", Vec3::new(0.0625, 0.0, 2.26), 0.08, 0.014, paint::BLACK));
    s.add(block((0.045, -0.20, 1.10), (0.075, 0.20, 1.75), 0.01, paint::POLE));
    s.add(block((0.07, -0.17, 1.13), (0.079, 0.17, 1.72), 0.0, paint::WHITE));
    for i in 0..9 {
        let z = 1.66 - 0.058 * i as f32;
        s.add(block((0.078, -0.14, z), (0.0805, 0.05 + 0.02 * (i % 4) as f32, z + 0.018), 0.0, paint::BLACK));
    }
    s
}

/// A speed camera in a column with two dark eyes, facing +x.
pub(crate) fn speed_camera(variant: u32) -> Sculpt {
    if variant.is_multiple_of(2) {
        let grey = paint::fixed(Surface::Painted, [0.20, 0.21, 0.22]);
        let mut s = Sculpt::lathe(&[(0.0, 0.0), (0.24, 0.0), (0.24, 2.75), (0.22, 2.80), (0.0, 2.80)], 24, 35.0, grey);
        for z in [1.55, 2.05, 2.50] {
            s.paint(&Region::all().beyond(Vec3::Z, z).within(Vec3::Z, z + 0.18).beyond(Vec3::X, 0.0), paint::GLASS);
        }
        return s;
    }
    let mut s = pole(3.0, 0.07, 0.06, paint::POLE);
    s.add(block((-0.30, -0.24, 2.95), (0.35, 0.24, 3.55), 0.03, paint::fixed(Surface::Painted, [0.70, 0.42, 0.01])));
    s.paint(&on_front([-0.16, 0.16], [3.28, 3.44]), paint::DARK);
    s.paint(&on_front([-0.12, 0.12], [3.05, 3.20]), paint::GLASS);
    s
}

/// A drinking fountain of cast iron, facing +x.
pub(crate) fn drinking_fountain() -> Sculpt {
    let iron = paint::fixed(Surface::Painted, [0.02, 0.07, 0.045]);
    let profile = [
        (0.0, 0.0),
        (0.22, 0.0),
        (0.22, 0.06),
        (0.13, 0.10),
        (0.11, 0.72),
        (0.16, 0.80),
        (0.28, 0.92),
        (0.30, 0.95),
        (0.26, 0.95),
        (0.05, 0.88),
        (0.0, 0.88),
    ];
    let mut s = Sculpt::lathe(&profile, 18, 35.0, iron);
    let spout: Vec<(Vec3, f32)> = [(-0.14, 0.90), (-0.14, 1.10), (-0.08, 1.16), (0.0, 1.14), (0.01, 1.09)]
        .iter()
        .map(|&(x, z)| (Vec3::new(x, 0.0, z), 0.018))
        .collect();
    s.add(Sculpt::tube(&spout, 8, paint::STEEL));
    s.add(Sculpt::lathe(
        &[(0.0, 0.885), (0.22, 0.905), (0.0, 0.906)],
        16,
        40.0,
        paint::fixed(Surface::Water, [0.06, 0.10, 0.10]),
    ));
    s
}
