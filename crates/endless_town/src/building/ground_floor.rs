//! The street side of the ground floor: shops under signs and awnings, windows about a door, gates.

use super::dimensions::{BuildingDesign, BuildingDimensions};
use super::finish::BuildingFinish;
use super::kind::BuildingKind;
use super::opening::{WindowDetail, WindowNumbers, door, gate, shop_front, window};
use super::ornament::{grille, lintel, projecting_sign, shop_name, surround};
use super::style::{Entrance, GroundFront, GroundWindows};
use super::wall::{Wall, WallOpening};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};

const IRON: Material = Material::new(Surface::Painted, [0.04, 0.042, 0.045], ClassTag::Buildings);

/// Closes the ground floor of a front between two heights; `holes` are where its windows would be.
pub(super) fn add_ground_front(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (range, holes): ([f32; 2], &[WallOpening]),
    design: BuildingDesign<'_>,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let BuildingDesign { dimensions, finish, .. } = design;
    match dimensions.kind {
        BuildingKind::Hall | BuildingKind::Barn => add_gates(mesh, wall, range, dimensions, finish),
        _ if finish.style.front == GroundFront::Market => add_market(mesh, wall, range, finish, numbers),
        _ if dimensions.shops || dimensions.kind == BuildingKind::Shop => {
            add_shops(mesh, wall, range, finish, stream, numbers);
        }
        _ => add_entrance(mesh, wall, (range, holes), dimensions, finish, numbers),
    }
}

/// Roller gates, of warehouses over a dock with rubber bumpers.
fn add_gates(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    range: [f32; 2],
    dimensions: &BuildingDimensions,
    finish: &BuildingFinish,
) {
    let height = range[1] - range[0];
    let barn = dimensions.kind == BuildingKind::Barn;
    let gates = if barn { 1 } else { (wall.width / 7.5).floor().max(1.0) as usize };
    let top = (height - 0.3).min(3.1);
    let pitch = wall.width / gates as f32;
    let openings: Vec<WallOpening> = (0..gates)
        .map(|k| {
            let middle = pitch * (k as f32 + 0.5);
            WallOpening { u: [middle - 1.9, middle + 1.9], v: [0.02, top] }
        })
        .collect();
    wall.pierced(mesh, range, &openings, finish.base);
    for (k, hole) in openings.iter().enumerate() {
        gate(mesh, wall, hole, &finish.joinery);
        if barn {
            // Leaves of a sliding gate with a cross of boards, on a rail.
            let middle = (hole.u[0] + hole.u[1]) / 2.0;
            wall.block(mesh, [hole.u[0] - 0.3, hole.u[1] + 0.3], [top + 0.06, top + 0.14], [0.0, 0.1], IRON);
            for (a, b) in [(hole.u[0], middle - 0.03), (middle + 0.03, hole.u[1])] {
                let corner = |u: f32, v: f32| glam::Vec2::new(u, v);
                wall.bar(mesh, (corner(a + 0.1, 0.2), corner(b - 0.1, top - 0.1)), 0.14, [-0.17, -0.12], finish.accent);
                wall.bar(
                    mesh,
                    (corner(a + 0.1, top - 0.1), corner(b - 0.1, 0.2)),
                    0.14,
                    [-0.17, -0.122],
                    finish.accent,
                );
                for v in [0.1, top - 0.2] {
                    wall.block(mesh, [a + 0.04, b - 0.04], [v, v + 0.14], [-0.17, -0.11], finish.accent);
                }
            }
        } else if finish.style.front == GroundFront::Docks {
            for u in [hole.u[0] - 0.30, hole.u[1] + 0.05] {
                wall.block(mesh, [u, u + 0.25], [0.35, 0.95], [0.0, 0.09], Material { base_color: [0.02; 3], ..IRON });
                wall.block(mesh, [u + 0.09, u + 0.16], [0.95, top + 0.1], [0.0, 0.06], finish.accent);
            }
            wall.block(mesh, [hole.u[0] - 0.35, hole.u[1] + 0.35], [top + 0.1, top + 0.22], [0.0, 1.0], finish.trim);
            let number = ["1", "2", "3", "4", "5", "6"][k % 6];
            let ink = Material { base_color: [0.75, 0.73, 0.66], ..finish.sign };
            let [u0, u1] = hole.u;
            super::ornament::letters(mesh, wall, ([u0 - 1.2, u0 - 0.4], 2.3), 0.012, 0.6, number, ink);
            let lamp = Material { base_color: [0.75, 0.72, 0.62], ..finish.sign };
            wall.block(
                mesh,
                [(u0 + u1) / 2.0 - 0.2, (u0 + u1) / 2.0 + 0.2],
                [top + 0.24, top + 0.34],
                [0.0, 0.2],
                lamp,
            );
        }
    }
}

/// Windows about a door that stands in the place of the middle one.
fn add_entrance(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (range, holes): ([f32; 2], &[WallOpening]),
    dimensions: &BuildingDimensions,
    finish: &BuildingFinish,
    numbers: &mut WindowNumbers,
) {
    let mut openings = holes.to_vec();
    let entrance = if finish.style.door_aside { 0 } else { openings.len() / 2 };
    let mut door_hole = None;
    if let Some(hole) = openings.get_mut(entrance) {
        let middle = (hole.u[0] + hole.u[1]) / 2.0;
        let narrow = matches!(dimensions.kind, BuildingKind::House | BuildingKind::Terrace);
        let wide = if narrow { 0.52 } else { 0.95 };
        *hole = WallOpening { u: [middle - wide, middle + wide], v: [0.05, (range[1] - 0.3).min(2.5)] };
        door_hole = Some(*hole);
    }
    wall.pierced(mesh, range, &openings, finish.base);
    for (k, hole) in openings.iter().enumerate() {
        if k == entrance {
            door(mesh, wall, hole, &finish.joinery, numbers);
            continue;
        }
        window(mesh, wall, hole, &finish.joinery, WindowDetail::Full, numbers);
        match finish.style.ground_windows {
            GroundWindows::Grilles => grille(mesh, wall, hole, finish.joinery.frame),
            GroundWindows::Surrounds => surround(mesh, wall, hole, false, finish.accent),
            GroundWindows::Lintels => lintel(mesh, wall, hole, finish.accent),
            GroundWindows::Bare => {}
        }
    }
    let Some(hole) = door_hole else { return };
    match finish.style.entrance {
        Entrance::Surround => {
            surround(mesh, wall, &hole, true, finish.accent);
        }
        Entrance::IronGate => {
            // A gate of iron before the door.
            grille(mesh, wall, &hole, IRON);
        }
        Entrance::Canopy if dimensions.kind != BuildingKind::House => {
            let u = [hole.u[0] - 0.35, hole.u[1] + 0.35];
            wall.block(mesh, u, [2.62, 2.74], [0.0, 0.7], finish.trim);
        }
        Entrance::Canopy => {}
    }
    // A lamp, and bells with letter boxes where many live.
    let lamp = Material { surface: Surface::LitSign, base_color: [0.72, 0.66, 0.52], ..finish.trim };
    wall.block(mesh, [hole.u[1] + 0.22, hole.u[1] + 0.34], [2.05, 2.28], [0.0, 0.10], lamp);
    if dimensions.storeys > 2 {
        wall.block(mesh, [hole.u[1] + 0.2, hole.u[1] + 0.42], [1.2, 1.55], [0.0, 0.03], finish.joinery.sill);
    }
}

/// Shop fronts between piers, each with its name; some with an awning.
fn add_shops(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    range: [f32; 2],
    finish: &BuildingFinish,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let shops = (wall.width / 7.0).round().max(1.0) as usize;
    let pitch = wall.width / shops as f32;
    let openings: Vec<WallOpening> = (0..shops)
        .map(|k| WallOpening { u: [pitch * k as f32 + 0.35, pitch * (k + 1) as f32 - 0.35], v: [0.02, 2.75] })
        .collect();
    wall.pierced(mesh, range, &openings, finish.base);
    for hole in &openings {
        let closed = stream.chance(0.12);
        // Each shop paints its own sign.
        let mut own = *finish;
        if shops > 1 {
            own.sign = super::palette::sign(stream);
            own.awning = super::palette::awning(stream);
        }
        if closed {
            gate(mesh, wall, hole, &finish.joinery);
        } else {
            shop_front(mesh, wall, hole, &finish.joinery, numbers);
        }
        wall.block(mesh, [hole.u[0] - 0.1, hole.u[1] + 0.1], [2.95, 3.55], [0.0, 0.16], own.sign);
        shop_name(mesh, wall, hole, &own, stream);
        if !closed && stream.chance(0.55) {
            add_awning(mesh, wall, hole, &own);
        }
        if stream.chance(0.35) {
            projecting_sign(mesh, wall, hole.u[0] - 0.12, 3.1, &own);
        }
    }
}

/// The wide glass front of a supermarket under its name.
fn add_market(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    range: [f32; 2],
    finish: &BuildingFinish,
    numbers: &mut WindowNumbers,
) {
    let hole = WallOpening { u: [wall.width * 0.12, wall.width * 0.88], v: [0.02, 2.9] };
    wall.pierced(mesh, range, &[hole], finish.base);
    shop_front(mesh, wall, &hole, &finish.joinery, numbers);
    wall.block(mesh, [hole.u[0] - 0.3, hole.u[1] + 0.3], [2.95, 3.12], [0.0, 1.0], finish.trim);
    let band = [range[1] - 1.75, range[1] - 0.25];
    wall.block(mesh, [0.1, wall.width - 0.1], band, [0.0, 0.10], finish.sign);
    let bright: f32 = finish.sign.base_color.iter().sum();
    let ink = if bright > 1.0 { [0.05, 0.05, 0.06] } else { [0.82, 0.80, 0.74] };
    let names = ["MAXIMART", "FRESCO", "SUPER 7", "HAPPY MARKET", "DISCOUNT"];
    let name = names[(wall.width * 10.0) as usize % names.len()];
    let ink = Material { base_color: ink, ..finish.sign };
    super::ornament::letters(mesh, wall, ([0.1, wall.width - 0.1], (band[0] + band[1]) / 2.0), 0.108, 1.0, name, ink);
}

/// A sloping awning over a shop front in stripes, both sides of the cloth.
fn add_awning(mesh: &mut MeshBuilder, wall: &Wall, hole: &WallOpening, finish: &BuildingFinish) {
    let (u0, u1) = (hole.u[0] - 0.05, hole.u[1] + 0.05);
    let (back, front, reach) = (2.9, 2.42, 1.1);
    let p = |u: f32, v: f32, out: f32| wall.at(u, v, out);
    let stripes = ((u1 - u0) / 0.35).round().max(1.0) as usize;
    let pale = Material { base_color: [0.68, 0.66, 0.60], ..finish.awning };
    let plain = finish.shuttered;
    for k in 0..stripes {
        let (a, b) = (u0 + (u1 - u0) * k as f32 / stripes as f32, u0 + (u1 - u0) * (k + 1) as f32 / stripes as f32);
        let cloth = if plain || k % 2 == 0 { finish.awning } else { pale };
        let top = [p(a, front, reach), p(b, front, reach), p(b, back, 0.01), p(a, back, 0.01)];
        let drop = 0.03;
        let below =
            [p(b, front - drop, reach), p(a, front - drop, reach), p(a, back - drop, 0.01), p(b, back - drop, 0.01)];
        let uv = [[a, 0.0], [b, 0.0], [b, 1.2], [a, 1.2]].map(glam::Vec2::from_array);
        mesh.quad(top, uv, cloth);
        mesh.quad(below, uv, cloth);
        wall.block(mesh, [a, b], [front - 0.25, front], [reach - 0.012, reach], cloth);
    }
    for u in [u0 + 0.03, u1 - 0.06] {
        wall.block(mesh, [u, u + 0.03], [front - 0.05, front - 0.02], [0.0, reach], IRON);
    }
}
