//! The roof of a building, by its form, and the equipment on it.

use super::dimensions::{BuildingDesign, BuildingDimensions};
use super::finish::BuildingFinish;
use super::kind::BuildingKind;
use super::opening::WindowNumbers;
use super::roof::{boxed, chimney, flat, gabled, hipped, plant};
use super::rooftop::{aerial, barrel, dormer, gutter, machines, rebar, skylight, solar, water_tank};
use super::style::{RoofEquipment, RoofForm};
use super::wall::Wall;
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

/// From where to where a roof reaches along x and y, metres.
type RoofExtent = ([f32; 2], [f32; 2]);

/// The roof of a rectangular building, with what stands on it.
pub(super) fn add_roof(
    mesh: &mut MeshBuilder,
    design: BuildingDesign<'_>,
    (x, y): RoofExtent,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let BuildingDesign { dimensions, finish, rhythm } = design;
    let height = rhythm.height(dimensions.storeys);
    let low_terrace = dimensions.kind == BuildingKind::Terrace && dimensions.storeys <= 4;
    match finish.style.roof {
        RoofForm::Hipped => {
            let rise = dimensions.depth.min(dimensions.width) * stream.range_f32(0.3, 0.4);
            hipped(mesh, (x, y), height, rise, (finish.roof, finish.trim));
            chimney(mesh, dimensions.width * 0.2, dimensions.depth * 0.58, height + 0.2, height + rise + 0.7);
            dormers(
                mesh,
                dimensions,
                height,
                rise / (dimensions.depth.min(dimensions.width) / 2.0 + 0.4),
                finish,
                numbers,
            );
        }
        RoofForm::Gabled => {
            let along = dimensions.width >= dimensions.depth || stream.chance(0.4);
            let across = if along { dimensions.depth } else { dimensions.width };
            let rise = across * stream.range_f32(0.3, 0.42);
            let slopes = gabled(mesh, (x, y), height, rise, (along, 0.45, 0.3), (finish.roof, finish.wall));
            dress_slopes(mesh, &slopes, dimensions, stream, numbers);
            let cx = dimensions.width * stream.range_f32(-0.3, 0.3);
            chimney(mesh, cx, dimensions.depth * 0.58, height + 0.2, height + rise + 0.7);
        }
        RoofForm::Row { dormers: always } if low_terrace => {
            let rise = dimensions.depth * stream.range_f32(0.28, 0.38);
            let slopes = gabled(mesh, (x, y), height, rise, (true, 0.3, 0.0), (finish.roof, finish.wall));
            gutter(mesh, &slopes[0]);
            gutter(mesh, &slopes[1]);
            if always || stream.chance(0.4) {
                dormers(mesh, dimensions, height, rise / (dimensions.depth / 2.0), finish, numbers);
            } else {
                skylight(mesh, &slopes[0], slopes[0].width * 0.5, 1.6, numbers);
            }
            chimney(mesh, x[0] + 0.6, dimensions.depth * 0.62, height + 0.3, height + rise + 0.6);
            if stream.chance(0.5) {
                aerial(mesh, Vec3::new(x[1] - 1.0, dimensions.depth * 0.5, height + rise + 0.1), stream);
            }
        }
        RoofForm::Barn => {
            let rise = dimensions.width * 0.42;
            gabled(mesh, (x, y), height, rise, (false, 0.5, 0.4), (finish.roof, finish.wall));
            // A vent on the ridge.
            let middle = dimensions.depth / 2.0;
            boxed(
                mesh,
                [-0.5, 0.5],
                [middle - 0.5, middle + 0.5],
                [height + rise - 0.2, height + rise + 0.8],
                finish.wall,
            );
        }
        RoofForm::SawTooth => saw_tooth(mesh, (x, y), height, finish, numbers),
        RoofForm::Rooflights => {
            flat(mesh, (x, y), height, 0.35, (finish.wall, finish.trim));
            for k in 1..4 {
                let cx = x[0] + dimensions.width * k as f32 / 4.0;
                boxed(mesh, [cx - 0.9, cx + 0.9], [3.0, dimensions.depth - 3.0], [height, height + 0.45], finish.trim);
            }
            machines(mesh, (x, y), height, stream);
        }
        RoofForm::Unfinished => {
            flat(mesh, (x, y), height, stream.range_f32(0.15, 0.7), (finish.wall, finish.trim));
            on_unfinished_roof(mesh, (x, y), height, stream);
        }
        RoofForm::Row { .. } | RoofForm::Flat => {
            flat(mesh, (x, y), height, stream.range_f32(0.45, 1.0), (finish.wall, finish.trim));
            plant(mesh, (x, y), height, stream);
            on_flat_roof(mesh, dimensions, (x, y), height, finish, stream);
        }
    }
}

/// Tanks, bars and aerials over low houses.
pub(super) fn on_unfinished_roof(mesh: &mut MeshBuilder, (x, y): RoofExtent, height: f32, stream: &mut Stream) {
    let (w, d) = (x[1] - x[0], y[1] - y[0]);
    if stream.chance(0.6) {
        rebar(mesh, (x, y), height, stream);
    }
    for _ in 0..1 + stream.below(2) {
        let at = Vec3::new(x[0] + w * stream.range_f32(0.2, 0.8), y[0] + d * stream.range_f32(0.3, 0.8), height);
        water_tank(mesh, at, stream);
    }
    if stream.chance(0.4) {
        aerial(mesh, Vec3::new(x[0] + w * 0.3, y[0] + d * 0.25, height), stream);
    }
}

/// What flats, offices and tenements have up there.
pub(super) fn on_flat_roof(
    mesh: &mut MeshBuilder,
    dimensions: &BuildingDimensions,
    (x, y): RoofExtent,
    height: f32,
    finish: &BuildingFinish,
    stream: &mut Stream,
) {
    let middle = Vec3::new((x[0] + x[1]) / 2.0, (y[0] + y[1]) / 2.0, height);
    match dimensions.kind {
        BuildingKind::Office | BuildingKind::Tower | BuildingKind::Shop => machines(mesh, (x, y), height, stream),
        _ => {}
    }
    if finish.style.on_roof == RoofEquipment::WaterBarrel && dimensions.storeys >= 4 && stream.chance(0.6) {
        barrel(mesh, middle + Vec3::new(0.0, 1.0, 0.0));
    }
    if matches!(dimensions.kind, BuildingKind::Flats | BuildingKind::Terrace) {
        for _ in 0..1 + stream.below(3) {
            let off = Vec3::new(
                stream.range_f32(-0.35, 0.35) * (x[1] - x[0]),
                stream.range_f32(-0.3, 0.3) * (y[1] - y[0]),
                0.0,
            );
            aerial(mesh, middle + off, stream);
        }
    }
    if finish.style.on_roof == RoofEquipment::Mast && stream.chance(0.5) {
        let steel = Material::new(Surface::Metal, [0.40, 0.40, 0.41], ClassTag::Buildings);
        boxed(mesh, [middle.x - 0.2, middle.x + 0.2], [middle.y - 0.2, middle.y + 0.2], [height, height + 9.0], steel);
    }
}

/// Gutters, skylights and sometimes solar panels.
fn dress_slopes(
    mesh: &mut MeshBuilder,
    slopes: &[Wall; 2],
    dimensions: &BuildingDimensions,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    for slope in slopes {
        gutter(mesh, slope);
    }
    let slope = &slopes[stream.below(2)];
    let long = dimensions.depth.min(dimensions.width) / 2.0;
    if stream.chance(0.3) && long > 3.2 {
        let count = ((slope.width - 2.0) / 1.08) as usize;
        solar(mesh, slope, 1.0, 1.2, count.min(6));
    } else if stream.chance(0.5) {
        skylight(mesh, slope, slope.width * 0.35, 1.3, numbers);
        skylight(mesh, slope, slope.width * 0.65, 1.3, numbers);
    }
}

/// Dormers on the slope towards the street; `rise` is metres up a metre in.
fn dormers(
    mesh: &mut MeshBuilder,
    dimensions: &BuildingDimensions,
    height: f32,
    rise: f32,
    finish: &BuildingFinish,
    numbers: &mut WindowNumbers,
) {
    // Flat roofs have no room for them, and short slopes end below their ridges.
    if rise < 0.45 || rise * dimensions.depth / 2.0 < 2.6 {
        return;
    }
    let count = ((dimensions.width - 2.5) / 3.2).floor().max(1.0) as usize;
    let pitch = (dimensions.width - 2.0) / count as f32;
    for k in 0..count {
        let x = -dimensions.width / 2.0 + 1.0 + pitch * (k as f32 + 0.5);
        let y = 0.55;
        let z = height + rise * y + 0.1;
        dormer(mesh, (x, y, z), rise, (finish.wall, finish.roof, finish.joinery.frame), numbers);
    }
}

/// Teeth of glass towards the back, of tiles towards the front.
fn saw_tooth(
    mesh: &mut MeshBuilder,
    (x, y): RoofExtent,
    height: f32,
    finish: &BuildingFinish,
    numbers: &mut WindowNumbers,
) {
    let teeth = ((y[1] - y[0]) / 5.0).round().max(1.0) as usize;
    let pitch = (y[1] - y[0]) / teeth as f32;
    let rise = 2.1;
    let p = |x: f32, y: f32, z: f32| Vec3::new(x, y, z);
    let width = x[1] - x[0];
    for k in 0..teeth {
        let (a, b) = (y[0] + pitch * k as f32, y[0] + pitch * (k + 1) as f32);
        let slant = (pitch * pitch + rise * rise).sqrt();
        let uv = [[0.0, 0.0], [width, 0.0], [width, slant], [0.0, slant]].map(Vec2::from_array);
        let top = height + rise;
        mesh.quad([p(x[0], a, height), p(x[1], a, height), p(x[1], b, top), p(x[0], b, top)], uv, finish.accent);
        let glazed = Wall::upright(p(x[1], b, height), Vec3::NEG_X, width);
        glazed.panel(mesh, [0.0, width], [0.0, 0.35], 0.0, finish.wall);
        glazed.panel(mesh, [0.0, width], [rise - 0.2, rise], 0.0, finish.wall);
        let panes = (width / 1.6).round().max(1.0) as usize;
        let glass = Material::new(Surface::WindowGlass, [0.05, 0.06, 0.07], ClassTag::Buildings);
        for i in 0..panes {
            let u = [width * i as f32 / panes as f32, width * (i + 1) as f32 / panes as f32];
            glazed.panel(mesh, [u[0], u[0] + 0.06], [0.35, rise - 0.2], 0.0, finish.joinery.frame);
            glazed.panel_uv(mesh, [u[0] + 0.06, u[1]], [0.35, rise - 0.2], 0.0, numbers.next_square(), glass);
        }
        let uv3 = [[0.0, 0.0], [pitch, 0.0], [pitch, rise]].map(Vec2::from_array);
        mesh.triangle([p(x[1], a, height), p(x[1], b, height), p(x[1], b, top)], uv3, finish.wall);
        mesh.triangle([p(x[0], b, height), p(x[0], a, height), p(x[0], b, top)], uv3, finish.wall);
    }
}

/// A step and a little roof on two posts before a house's door; of boarded houses a veranda over the whole front.
pub(super) fn add_porch(mesh: &mut MeshBuilder, dimensions: &BuildingDimensions, finish: &BuildingFinish) {
    let half = if finish.style.veranda { (dimensions.width / 2.0 - 0.3).min(3.2) } else { 0.9 };
    boxed(mesh, [-half, half], [-1.2, -0.01], [0.0, 0.05], finish.trim);
    boxed(mesh, [-half - 0.1, half + 0.1], [-1.3, -0.01], [2.6, 2.72], finish.accent);
    let posts = (half / 0.9).round().max(1.0) as usize;
    for k in 0..=posts {
        let x = -half + (2.0 * half - 0.1) * k as f32 / posts as f32;
        boxed(mesh, [x, x + 0.1], [-1.2, -1.1], [0.05, 2.6], finish.joinery.frame);
    }
    if half > 1.0 {
        for (a, b) in [(-half, -0.7), (0.7, half)] {
            boxed(mesh, [a, b], [-1.17, -1.13], [0.85, 0.92], finish.joinery.frame);
            for k in 0..((b - a) / 0.2) as usize {
                let x = a + 0.1 + 0.2 * k as f32;
                boxed(mesh, [x, x + 0.03], [-1.17, -1.14], [0.05, 0.85], finish.joinery.frame);
            }
        }
    }
}
