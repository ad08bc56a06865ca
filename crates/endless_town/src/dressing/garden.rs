//! Front gardens: paths to doors, drives with a car, hedges and fences.

use super::dresser::Dresser;
use super::furniture::row;
use crate::building::Lot;
use crate::character::Kind;
use crate::network::KERB_HEIGHT_M;
use crate::palette::{GRAVEL, YARD};
use crate::plot::{Rect, inside};
use crate::surface;
use endless_asset::Prop;
use endless_scene::{Material, MeshBuilder};
use endless_world::{ParkedVehicle, Pose, Stream, VehicleModelId, VehicleRef};
use glam::{DVec2, Vec2, Vec3};
use std::f64::consts::FRAC_PI_2;

/// Outlines of the blocks, and of the town.
type Ground = (Vec<Vec<DVec2>>, Vec<DVec2>);

/// Thickness of slabs laid on the ground.
const SLAB_M: f32 = 0.03;

/// A slab in a lot's frame: x along the front, y into the lot from the front wall.
fn slab(mesh: &mut MeshBuilder, lot: &Lot, x: [f64; 2], y: [f64; 2], material: Material) {
    let (axis, into) = (lot.footprint.axis, lot.footprint.axis.perp());
    let z = KERB_HEIGHT_M as f32;
    let p = |x: f64, y: f64, up: f32| (lot.front + axis * x + into * y).as_vec2().extend(z + up);
    let ring = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])];
    let top = ring.map(|(x, y)| p(x, y, SLAB_M));
    mesh.quad(top, top.map(Vec3::truncate), material);
    for k in 0..4 {
        let (a, b) = (ring[k], ring[(k + 1) % 4]);
        let uv = [[0.0, 0.0], [1.0, 0.0], [1.0, SLAB_M], [0.0, SLAB_M]].map(Vec2::from_array);
        mesh.quad([p(a.0, a.1, -0.02), p(b.0, b.1, -0.02), p(b.0, b.1, SLAB_M), p(a.0, a.1, SLAB_M)], uv, material);
    }
}

pub(crate) fn add(dresser: &mut Dresser<'_>, mesh: &mut MeshBuilder, lots: &[Lot]) {
    let ground = (surface::blocks(dresser.plan), surface::outline(dresser.plan));
    for (i, lot) in lots.iter().enumerate().filter(|(_, lot)| lot.set_back > 2.0) {
        let mut stream = dresser.stream(6000 + i as u64);
        let kind = lot.measures.kind;
        let front = -lot.set_back;
        let half = f64::from(lot.measures.width) / 2.0;
        let material = *stream.pick(&[YARD, YARD, GRAVEL]);
        let path = match kind {
            Kind::House => 0.7,
            Kind::Flats => 1.3,
            _ => 0.0,
        };
        let (axis, into) = (lot.footprint.axis, lot.footprint.axis.perp());
        // The way to the door, or the whole forecourt.
        let mut doorway =
            Rect { centre: lot.front + into * (front / 2.0), half: DVec2::new(1.2, -front / 2.0 + 1.0), axis };
        if path > 0.0 {
            let porch = if kind == Kind::House { -1.22 } else { -0.02 };
            slab(mesh, lot, [-path, path], [front + 0.02, porch], material);
            dresser.occupied.take(Rect { half: DVec2::new(path, -front / 2.0 - 0.2), ..doorway });
        } else {
            // Forecourts are paved over the whole front.
            doorway.half = DVec2::new(half, -front / 2.0 - 0.02);
            if !on_one_block(&ground, &doorway) {
                continue;
            }
            slab(mesh, lot, [-half, half], [front + 0.02, -0.02], YARD);
        }
        if kind == Kind::House {
            drive(dresser, mesh, &ground, lot, half, material, &mut stream);
            let line = |x: f64| lot.front + axis * x + into * (front + 0.45);
            match stream.below(4) {
                0 => row(dresser, Prop::Hedge, 1.0, line(-half - 1.0), line(half + 1.0), &doorway),
                1 => row(dresser, Prop::FencePanel, 2.0, line(-half - 1.0), line(half + 1.0), &doorway),
                2 => row(dresser, Prop::Railing, 2.0, line(-half - 1.0), line(half + 1.0), &doorway),
                _ => {}
            }
        } else if kind != Kind::Flats {
            forecourt(dresser, &ground, lot, half, &mut stream);
        }
    }
}

/// A drive beside a house, where there is room, often with a car on it.
fn drive(
    dresser: &mut Dresser<'_>,
    mesh: &mut MeshBuilder,
    ground: &Ground,
    lot: &Lot,
    half: f64,
    material: Material,
    stream: &mut Stream,
) {
    let (axis, into) = (lot.footprint.axis, lot.footprint.axis.perp());
    let side = if stream.chance(0.5) { 1.0 } else { -1.0 };
    let x = side * (half + 0.65 + 1.35);
    let (near, far) = (-lot.set_back + 0.02, 3.4);
    let centre = lot.front + axis * x + into * ((near + far) / 2.0);
    let rect = Rect { centre, half: DVec2::new(1.3, (far - near) / 2.0 - 0.05), axis };
    if !on_one_block(ground, &rect) || !dresser.occupied.try_take(rect) {
        return;
    }
    slab(mesh, lot, [x - 1.3, x + 1.3], [near, far], material);
    if stream.chance(0.55) {
        let at = lot.front + axis * (x + stream.range_f64(-0.08, 0.08)) + into * (far - 2.7);
        park(dresser, at, lot.angle_rad + FRAC_PI_2 * if stream.chance(0.7) { 1.0 } else { -1.0 }, stream);
    }
}

/// Cars before shops, halls and barns, nose to the wall.
fn forecourt(dresser: &mut Dresser<'_>, ground: &Ground, lot: &Lot, half: f64, stream: &mut Stream) {
    if lot.set_back < 5.2 {
        return;
    }
    let (axis, into) = (lot.footprint.axis, lot.footprint.axis.perp());
    let mut x = -half + 1.6;
    while x < half - 1.6 {
        // Doors and gates in the middle stay free.
        if x.abs() > 2.8 && stream.chance(dresser.character.parked * 0.8) {
            let at = lot.front + axis * x - into * 2.75;
            let rect = Rect { centre: at, half: DVec2::new(1.15, 2.45), axis };
            if on_one_block(ground, &rect) && dresser.occupied.try_take(rect) {
                park(dresser, at, lot.angle_rad + FRAC_PI_2 + stream.normal().clamp(-1.5, 1.5) * 0.02, stream);
            }
        }
        x += 2.7;
    }
}

/// A car of ordinary length on a slab; the caller has taken the place.
fn park(dresser: &mut Dresser<'_>, at: DVec2, yaw: f64, stream: &mut Stream) {
    let models = dresser.catalogue.vehicles();
    let fits = |length: f32| (3.0..4.85).contains(&length);
    let weights: Vec<f64> =
        models.iter().map(|m| if m.spec.parks && fits(m.spec.length_m) { m.spec.frequency } else { 0.0 }).collect();
    if weights.iter().sum::<f64>() <= 0.0 {
        return;
    }
    let model = VehicleModelId::from_index(stream.weighted(&weights));
    let vehicle = VehicleRef { model, variant: stream.next_u64() };
    let position = at.as_vec2().extend(KERB_HEIGHT_M as f32 + SLAB_M);
    dresser.parked.push(ParkedVehicle { vehicle, pose: Pose::level(position, yaw as f32) });
}

/// Whether a rectangle lies wholly on one block.
fn on_one_block((blocks, outline): &Ground, rect: &Rect) -> bool {
    let corners = rect.corners();
    blocks.iter().any(|block| corners.iter().all(|&c| inside(block, c))) || corners.iter().all(|&c| !inside(outline, c))
}
