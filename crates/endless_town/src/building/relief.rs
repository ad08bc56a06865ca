//! What stands out from walls, and what the years leave on them.

use super::dimensions::BuildingDesign;
use super::finish::BuildingFinish;
use super::kind::BuildingKind;
use super::ornament::{cables, downpipe, graffito, posters};
use super::style::FacadeRelief;
use super::wall::Wall;
use endless_scene::MeshBuilder;
use endless_world::Stream;
use glam::Vec2;

/// What stands out from a wall as a whole: plinth, string courses, cornice, pilasters, fins, frames of timber.
pub(super) fn relief(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (side, bays, pitch): (usize, usize, f32),
    design: BuildingDesign<'_>,
    top: f32,
) {
    let BuildingDesign { dimensions, finish, rhythm } = design;
    let front = side == 0;
    if !(front || dimensions.kind == BuildingKind::Barn) {
        wall.block(mesh, [0.01, wall.width - 0.01], [0.0, 0.35], [0.0, 0.04], finish.trim);
    }
    let string = |mesh: &mut MeshBuilder, v: [f32; 2], out: f32| {
        wall.block(mesh, [0.005, wall.width - 0.005], v, [0.0, out], finish.accent);
    };
    let pier = |mesh: &mut MeshBuilder, half: f32, v: [f32; 2], out: f32| {
        for k in 0..=bays {
            let u = (0.4 + pitch * k as f32 - half).clamp(0.02, wall.width - 2.0 * half - 0.02);
            wall.block(mesh, [u, u + 2.0 * half], v, [0.0, out], finish.accent);
        }
    };
    let ground = rhythm.ground;
    match finish.style.relief {
        FacadeRelief::Cornice if front => {
            string(mesh, [ground - 0.12, ground + 0.1], 0.1);
            wall.block(mesh, [0.0, wall.width], [top - 0.34, top - 0.22], [0.0, 0.14], finish.accent);
            wall.block(mesh, [0.0, wall.width], [top - 0.12, top - 0.01], [0.0, 0.34], finish.accent);
            for k in 0..(wall.width / 0.45) as usize {
                let u = 0.12 + 0.45 * k as f32;
                wall.block(mesh, [u, u + 0.16], [top - 0.22, top - 0.12], [0.0, 0.28], finish.accent);
            }
            for u in [0.0, wall.width - 0.42] {
                for k in 0..((top - ground - 0.6) / 0.6) as usize {
                    let (v, w) = (ground + 0.14 + 0.6 * k as f32, if k % 2 == 0 { 0.42 } else { 0.28 });
                    let from = if u == 0.0 { 0.0 } else { wall.width - w };
                    wall.block(mesh, [from, from + w], [v, v + 0.52], [0.0, 0.03], finish.accent);
                }
            }
        }
        FacadeRelief::StringCourse if front => {
            string(mesh, [ground - 0.05, ground + 0.1], 0.06);
            wall.block(mesh, [0.0, wall.width], [top - 0.25, top - 0.02], [0.0, 0.16], finish.accent);
        }
        FacadeRelief::Pilasters => {
            string(mesh, [ground - 0.15, ground + 0.15], 0.12);
            string(mesh, [top - 0.35, top - 0.02], 0.26);
            if dimensions.storeys > 1 {
                pier(mesh, 0.2, [ground + 0.15, top - 0.35], 0.14);
            }
        }
        FacadeRelief::Ribbons => {
            for storey in 1..dimensions.storeys {
                let v = ground + rhythm.storey * (storey - 1) as f32;
                string(mesh, [v + 0.06, v + 0.14], 0.10);
                string(mesh, [v + 0.72, v + 0.80], 0.10);
            }
        }
        FacadeRelief::Mullions => {
            pier(mesh, 0.035, [ground, top], 0.16);
            for storey in 1..dimensions.storeys {
                let v = ground + rhythm.storey * (storey - 1) as f32;
                wall.block(mesh, [0.0, wall.width], [v - 0.08, v + 0.08], [0.0, 0.05], finish.accent);
            }
        }
        FacadeRelief::Piers => pier(mesh, 0.28, [ground, top], 0.22),
        FacadeRelief::PanelJoints => joints(mesh, wall, (bays, pitch), (ground, rhythm.storey), top, finish),
        FacadeRelief::FloorBands => {
            for storey in 0..dimensions.storeys {
                let v = ground + rhythm.storey * storey as f32;
                string(mesh, [(v - 0.2).min(top - 0.22), (v + 0.02).min(top - 0.01)], 0.03);
            }
        }
        FacadeRelief::SchoolPiers => {
            string(mesh, [top - 0.4, top - 0.02], 0.2);
            pier(mesh, 0.14, [2.2, top - 0.4], 0.10);
        }
        FacadeRelief::WorksPiers => pier(mesh, 0.22, [2.2, top - 0.1], 0.11),
        FacadeRelief::Timbers => timbers(mesh, wall, (bays, pitch), (ground, rhythm.storey), top, finish),
        FacadeRelief::Coping if front => string(mesh, [top - 0.15, top - 0.01], 0.12),
        FacadeRelief::CornerBoards => {
            let w = 0.12;
            for u in [0.0, wall.width - w] {
                wall.block(mesh, [u, u + w], [0.0, top], [0.0, 0.03], finish.accent);
            }
        }
        _ => {}
    }
}

/// The dark joints between prefabricated panels, and coloured fields below some windows.
fn joints(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (bays, pitch): (usize, f32),
    (ground, storey): (f32, f32),
    top: f32,
    finish: &BuildingFinish,
) {
    let seal = endless_scene::Material { base_color: [0.16, 0.155, 0.15], ..finish.wall };
    for k in 0..=bays {
        let u = 0.4 + pitch * k as f32;
        wall.block(mesh, [u - 0.012, u + 0.012], [0.35, top], [0.0, 0.008], seal);
    }
    let mut v = ground;
    let mut number = 0;
    while v < top - 0.5 {
        wall.block(mesh, [0.0, wall.width], [v - 0.012, v + 0.012], [0.0, 0.009], seal);
        for k in (0..bays).filter(|k| (k + number) % 3 == 0) {
            let u = 0.4 + pitch * k as f32;
            wall.block(mesh, [u + 0.1, u + pitch - 0.1], [v + 0.06, v + 0.76], [0.0, 0.03], finish.accent);
        }
        v += storey;
        number += 1;
    }
}

/// Posts, rails and braces of dark timber.
fn timbers(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (bays, pitch): (usize, f32),
    (ground, storey): (f32, f32),
    top: f32,
    finish: &BuildingFinish,
) {
    let out = [0.0, 0.035];
    let mut v = ground;
    while v < top - 0.3 {
        let high = (v + storey).min(top);
        for y in [v - 0.09, v + 0.80, high - 0.22] {
            wall.block(mesh, [0.0, wall.width], [y, y + 0.17], out, finish.accent);
        }
        for k in 0..=bays {
            let u = 0.4 + pitch * k as f32;
            wall.block(mesh, [u - 0.08, u + 0.08], [v, high], out, finish.accent);
            // Braces in the fields below windows.
            if k < bays && k % 2 == 0 {
                let (a, b) = (Vec2::new(u + 0.1, v + 0.1), Vec2::new(u + pitch - 0.1, v + 0.80));
                wall.bar(mesh, (a, b), 0.13, [0.0, 0.03], finish.accent);
                wall.bar(mesh, (Vec2::new(a.x, b.y), Vec2::new(b.x, a.y)), 0.13, [0.0, 0.028], finish.accent);
            }
        }
        for u in [0.02, wall.width - 0.2] {
            wall.block(mesh, [u, u + 0.18], [v, high], out, finish.accent);
        }
        v += storey;
    }
}

/// Pipes, cables, posters and tags.
pub(super) fn dirt(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    side: usize,
    design: BuildingDesign<'_>,
    top: f32,
    stream: &mut Stream,
) {
    let BuildingDesign { dimensions, finish, .. } = design;
    let street = !matches!(dimensions.kind, BuildingKind::House | BuildingKind::Barn);
    if finish.style.downpipes && (side == 0 || side == 2) && wall.width > 3.0 {
        downpipe(mesh, wall, 0.03, top - 0.05);
        if wall.width > 14.0 {
            downpipe(mesh, wall, wall.width - 0.14, top - 0.05);
        }
    }
    if finish.style.cables && side == 0 {
        cables(mesh, wall, 2.7, stream);
    }
    let blank_foot = side != 0 && street && wall.width > 5.0;
    if blank_foot && dimensions.storeys <= 6 && stream.chance(0.16) {
        graffito(mesh, wall, wall.width * stream.range_f32(0.05, 0.5), stream);
    } else if blank_foot && stream.chance(0.10) {
        posters(mesh, wall, 0.5, stream);
    }
}
