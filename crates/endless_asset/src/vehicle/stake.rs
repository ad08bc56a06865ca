//! Light lorries with a flat nose whose bed has high boards: what brings fruit, furniture and scrap.

use super::assemble::VehicleBlueprint;
use super::draw::DesignDraw;
use super::freight::Freight;
use super::lettering::Sign;
use super::lorry::{BODY_HALF_WIDTH, CAB_TOP, Cab, FRAME_Z, Lorry};
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

const W: f32 = BODY_HALF_WIDTH;
const BOARDS: [Material; 4] = [
    paint::WOOD,
    paint::BODY,
    Material::new(Surface::Painted, [0.03, 0.13, 0.30], ClassTag::Truck),
    Material::new(Surface::Painted, [0.34, 0.04, 0.03], ClassTag::Truck),
];
const COVERS: [Material; 3] = [
    Material::new(Surface::Cloth, [0.03, 0.11, 0.28], ClassTag::Truck),
    Material::new(Surface::Cloth, [0.09, 0.12, 0.06], ClassTag::Truck),
    Material::new(Surface::Cloth, [0.42, 0.40, 0.34], ClassTag::Truck),
];

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

fn block(low: Vec3, high: Vec3, material: Material) -> Sculpt {
    Sculpt::cuboid(low, high, 0.0, material)
}

/// Boards between stakes, open above or under a tarpaulin on hoops.
pub(crate) fn stake(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 6.7, 7.6);
    let boards = draw.pick("boards", &BOARDS);
    let rise = draw.range("rise", 1.15, 1.65);
    let covered = draw.chance("covered", 0.35).then(|| draw.pick("cover", &COVERS));
    let freight = draw.pick("freight", &Freight::ALL);
    let sign = draw.chance("sign", 0.4).then(|| Sign::drawn(draw));
    let seed = draw.range("pieces", 0.0, 1e6) as u64;
    let floor = FRAME_Z + 0.12;
    let top = floor + rise;
    let full = freight.height(0.75 * rise);
    let height = if covered.is_some() { top + 0.42 } else { top.max(floor + full) };
    let lorry = Lorry { length, cab: Cab::Day, rear_axles_d: vec![0.70 * length], height: height.max(CAB_TOP + 0.005) };
    let blueprint = lorry.blueprint(move |lorry| {
        let (x0, x1) = (-lorry.length, lorry.body_front());
        let mut s = block(v(x0, -W, floor - 0.12), v(x1, W, floor), paint::CHASSIS);
        walls(&mut s, [x0, x1], [floor, top], boards);
        let (low, high) = (v(x0 + 0.08, -W + 0.08, floor), Vec2::new(x1 - 0.10, W - 0.08));
        if let Some(cloth) = covered {
            s.add(hood([x0, x1], [floor + 0.35 * rise, top], cloth));
            s.add(block(low, high.extend(top - 0.05), paint::DARK));
        } else {
            s.add(freight.on(low, high, full, seed));
        }
        if let Some(sign) = sign {
            let middle = 0.5 * (x0 + x1);
            sign.on_sides(&mut s, [middle - 1.1, middle + 1.1], [floor + 0.2, floor + 0.75], &[boards]);
        }
        s
    });
    blueprint.scaled(draw.range("scale", 0.80, 0.86))
}

/// Three boards with gaps between them, on stakes.
fn walls(s: &mut Sculpt, [x0, x1]: [f32; 2], [floor, top]: [f32; 2], material: Material) {
    let t = 0.035;
    // The lowest is closed; above it one sees through.
    let first = floor + 0.55 * (top - floor);
    let board = 0.13 * (top - floor);
    let rows = [(floor, first), (first + 0.05, first + 0.05 + board), (top - board, top)];
    for (z0, z1) in rows {
        s.add(block(v(x0, W - t, z0), v(x1, W, z1), material).both_sides());
        s.add(block(v(x0, -W + t, z0), v(x0 + t, W - t, z1), material));
        s.add(block(v(x1 - t, -W + t, z0), v(x1, W - t, z1), material));
    }
    let n = 7;
    for i in 0..=n {
        let x = x0 + 0.02 + (x1 - x0 - 0.10) * i as f32 / n as f32;
        s.add(block(v(x, W - 0.01, floor - 0.08), v(x + 0.06, W + 0.025, top + 0.02), material).both_sides());
    }
    for y in [-0.75, -0.25, 0.25, 0.75] {
        s.add(block(v(x0 - 0.025, y - 0.03, floor - 0.04), v(x0 + 0.01, y + 0.03, top), material));
        s.add(block(v(x1 - 0.01, y - 0.03, floor), v(x1 + 0.02, y + 0.03, top), material));
    }
    // Seams between the planks of the lowest board.
    for k in 1..4 {
        let z = floor + (first - floor) * k as f32 / 4.0;
        let seam = [(x0, z), (x1, z), (x1, z + 0.012), (x0, z + 0.012)].map(Vec2::from);
        s.repaint_both(&Region::side(&seam).facing(Vec3::Y, 0.9), material, paint::DARK);
    }
}

/// Cloth over hoops, down over the boards.
fn hood([x0, x1]: [f32; 2], [low, top]: [f32; 2], cloth: Material) -> Sculpt {
    let profile = [(-1.0, low), (-1.0, top + 0.05), (-0.86, top + 0.30), (-0.5, top + 0.41), (0.0, top + 0.42)];
    let mut arch: Vec<(f32, f32)> = profile.to_vec();
    arch.extend(profile.iter().rev().skip(1).map(|&(y, z)| (-y, z)));
    let half = W + 0.035;
    let n = 10;
    let row = |i: usize| -> Vec<Vec3> {
        let x = x0 - 0.03 + (x1 - x0 + 0.05) * i as f32 / n as f32;
        // It sags between the hoops.
        let sag = if i % 2 == 1 { 0.025 } else { 0.0 };
        arch.iter().map(|&(y, z)| v(x, half * y, if z > top { z - sag } else { z })).collect()
    };
    // From the front back, so that it looks outwards.
    let rows: Vec<Vec<Vec3>> = (0..=n).rev().map(row).collect();
    let mut skin = Sculpt::new();
    skin.grid(&rows, false, cloth);
    let mut skin = skin.smooth(40.0);
    skin.polygon(&rows[0].iter().rev().copied().collect::<Vec<_>>(), cloth);
    skin.polygon(&rows[n], cloth);
    skin
}
