//! What windows of upper storeys have about them, and balconies.

use super::manner::Manner;
use super::ornament::{air_conditioner, dish, flower_box, grille, lintel, roller_blind, shutters, surround};
use super::style::Style;
use super::wall::{Hole, Wall};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::Stream;

/// Surrounds, shutters, blinds, machines and flowers; `place` is the wall between two windows, the side of the building
/// and the storey.
pub(super) fn dress_window(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &Hole,
    (between, side, storey): (f32, usize, u32),
    style: &Style,
    stream: &mut Stream,
) {
    let front = side == 0;
    // Nothing may stand out where people pass.
    let up = storey > 0;
    let middle = (hole.u[0] + hole.u[1]) / 2.0;
    match style.manner {
        Manner::OldTown if front || storey < 2 => {
            surround(mesh, wall, hole, front && storey == 1, style.accent);
            if style.shuttered {
                shutters(
                    mesh,
                    wall,
                    hole,
                    (between / 2.0, front && storey < 4),
                    Material { surface: Surface::Painted, ..style.joinery.door },
                );
            } else if front && up && stream.chance(0.12) {
                flower_box(mesh, wall, hole, stream);
            }
        }
        Manner::TerracedBrick | Manner::Tenement | Manner::Works => {
            lintel(mesh, wall, hole, style.accent);
            if style.manner == Manner::Tenement && up && stream.chance(0.14) {
                wall.block(
                    mesh,
                    [middle - 0.3, middle + 0.3],
                    [hole.v[0] + 0.02, hole.v[0] + 0.42],
                    [-0.1, 0.32],
                    style.trim,
                );
            }
        }
        Manner::Cottage | Manner::TimberFrame => {
            if style.shuttered {
                shutters(mesh, wall, hole, (between / 2.0, front && storey < 4), style.accent);
            }
            if front && up && stream.chance(0.3) {
                flower_box(mesh, wall, hole, stream);
            }
        }
        Manner::Villa | Manner::Weatherboard => surround(mesh, wall, hole, false, style.accent),
        Manner::Latin => {
            if storey < 2 {
                grille(mesh, wall, hole, style.joinery.frame);
            }
            if up && stream.chance(0.18) {
                air_conditioner(mesh, wall, middle, hole.v[0]);
            }
        }
        Manner::Balconies | Manner::Panels | Manner::BrickFlats => {
            let x = stream.f32();
            if style.manner != Manner::BrickFlats && front && storey < 5 {
                let drop = (stream.range_f32(-0.6, 0.9)).max(0.0);
                roller_blind(mesh, wall, hole, style.joinery.recess, drop, style.trim);
            }
            let window = up && hole.v[1] - hole.v[0] < 1.8;
            if window && x < 0.13 {
                air_conditioner(mesh, wall, middle, hole.v[0]);
            } else if window && x < 0.20 && between > 0.9 {
                dish(mesh, wall, hole.u[1] + 0.35, hole.v[0] + 0.3);
            } else if window && x > 0.93 {
                flower_box(mesh, wall, hole, stream);
            }
        }
        Manner::ConcreteTower if up && stream.chance(0.12) => air_conditioner(mesh, wall, middle, hole.v[0]),
        _ => {}
    }
}

/// A slab before a window with a railing of bars, a solid one, or one of glass, as the manner and the house have it.
pub(super) fn add_balcony(mesh: &mut MeshBuilder, wall: &Wall, hole: &Hole, floor: f32, style: &Style) {
    let u = [(hole.u[0] - 0.5).max(0.1), (hole.u[1] + 0.5).min(wall.width - 0.1)];
    let reach = 1.25;
    wall.block(mesh, u, [floor - 0.16, floor], [0.0, reach], style.trim);
    let rail = style.joinery.frame;
    let solid = style.manner == Manner::Panels || !style.shuttered && style.joinery.recess > 0.19;
    if solid {
        let field = if style.manner == Manner::Panels { style.accent } else { style.wall };
        wall.block(mesh, u, [floor, floor + 0.95], [reach - 0.08, reach], field);
        for end in [u[0], u[1] - 0.08] {
            wall.block(mesh, [end, end + 0.08], [floor, floor + 0.95], [0.0, reach - 0.08], field);
        }
        wall.block(mesh, [u[0] - 0.02, u[1] + 0.02], [floor + 0.95, floor + 1.0], [reach - 0.11, reach + 0.03], rail);
        return;
    }
    wall.block(mesh, u, [floor + 1.0, floor + 1.05], [reach - 0.06, reach - 0.01], rail);
    wall.block(mesh, u, [floor + 0.08, floor + 0.12], [reach - 0.05, reach - 0.02], rail);
    for end in [u[0], u[1] - 0.04] {
        wall.block(mesh, [end, end + 0.04], [floor + 1.0, floor + 1.05], [0.0, reach - 0.06], rail);
        wall.block(mesh, [end, end + 0.04], [floor + 0.08, floor + 0.12], [0.0, reach - 0.06], rail);
        for k in 0..5 {
            let out = 0.16 + 0.21 * k as f32;
            wall.block(mesh, [end, end + 0.02], [floor + 0.12, floor + 1.0], [out, out + 0.02], rail);
        }
    }
    let bars = ((u[1] - u[0]) / 0.2) as usize;
    for k in 0..=bars {
        let at = u[0] + (u[1] - u[0] - 0.02) * k as f32 / bars.max(1) as f32;
        wall.block(mesh, [at, at + 0.02], [floor + 0.0, floor + 1.0], [reach - 0.05, reach - 0.03], rail);
    }
}
