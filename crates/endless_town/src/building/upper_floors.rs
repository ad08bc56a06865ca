//! Surrounds and shutters of upper windows, and balconies.

use super::finish::BuildingFinish;
use super::ornament::{air_conditioner, dish, flower_box, grille, lintel, roller_blind, shutters, surround};
use super::style::{Balconies, WindowDressing};
use super::wall::{Wall, WallOpening};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::Stream;

/// Surrounds, shutters, blinds, machines and flowers; `place` is the wall between two windows, the side of the building
/// and the storey.
pub(super) fn dress_window(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    (between, side, storey): (f32, usize, u32),
    finish: &BuildingFinish,
    stream: &mut Stream,
) {
    let front = side == 0;
    // Nothing may stand out where people pass.
    let up = storey > 0;
    let middle = (hole.u[0] + hole.u[1]) / 2.0;
    match finish.style.windows {
        WindowDressing::SurroundsAndShutters if front || storey < 2 => {
            surround(mesh, wall, hole, front && storey == 1, finish.accent);
            if finish.shuttered {
                shutters(
                    mesh,
                    wall,
                    hole,
                    (between / 2.0, front && storey < 4),
                    Material { surface: Surface::Painted, ..finish.joinery.door },
                );
            } else if front && up && stream.chance(0.12) {
                flower_box(mesh, wall, hole, stream);
            }
        }
        WindowDressing::Lintels { units } => {
            lintel(mesh, wall, hole, finish.accent);
            if units && up && stream.chance(0.14) {
                wall.block(
                    mesh,
                    [middle - 0.3, middle + 0.3],
                    [hole.v[0] + 0.02, hole.v[0] + 0.42],
                    [-0.1, 0.32],
                    finish.trim,
                );
            }
        }
        WindowDressing::Shutters => {
            if finish.shuttered {
                shutters(mesh, wall, hole, (between / 2.0, front && storey < 4), finish.accent);
            }
            if front && up && stream.chance(0.3) {
                flower_box(mesh, wall, hole, stream);
            }
        }
        WindowDressing::Surrounds => surround(mesh, wall, hole, false, finish.accent),
        WindowDressing::GrillesAndUnits => {
            if storey < 2 {
                grille(mesh, wall, hole, finish.joinery.frame);
            }
            if up && stream.chance(0.18) {
                air_conditioner(mesh, wall, middle, hole.v[0]);
            }
        }
        WindowDressing::Flats { blinds } => {
            let x = stream.f32();
            if blinds && front && storey < 5 {
                let drop = (stream.range_f32(-0.6, 0.9)).max(0.0);
                roller_blind(mesh, wall, hole, finish.joinery.recess, drop, finish.trim);
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
        WindowDressing::Units if up && stream.chance(0.12) => air_conditioner(mesh, wall, middle, hole.v[0]),
        _ => {}
    }
}

/// A slab before a window with a railing of bars, a solid one, or one of glass, as the style and the house have it.
pub(super) fn add_balcony(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    hole: &WallOpening,
    floor: f32,
    finish: &BuildingFinish,
) {
    let u = [(hole.u[0] - 0.5).max(0.1), (hole.u[1] + 0.5).min(wall.width - 0.1)];
    let reach = 1.25;
    wall.block(mesh, u, [floor - 0.16, floor], [0.0, reach], finish.trim);
    let rail = finish.joinery.frame;
    let accented = finish.style.balconies == Balconies::Accented;
    let solid = accented || !finish.shuttered && finish.joinery.recess > 0.19;
    if solid {
        let field = if accented { finish.accent } else { finish.wall };
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
