//! Buildings on any outline: the same facades, under a flat roof behind a parapet.

use super::dimensions::{BuildingDesign, BuildingDimensions, FacadeRhythm};
use super::finish::BuildingFinish;
use super::opening::WindowNumbers;
use super::storeyed::{add_wall, make_designed};
use super::style::RoofForm;
use super::wall::Wall;
use crate::geometry::triangulate;
use endless_scene::{Material, Mesh, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};
use glam::{DVec2, Vec2, Vec3};

const FELT: Material = Material::new(Surface::FlatRoof, [0.20, 0.20, 0.195], ClassTag::Buildings);
/// Thickness of parapets, and how far foundations reach down, metres.
const PARAPET_M: f64 = 0.22;
const FOUNDATION_M: f32 = 2.0;
/// Walls shorter than this have no windows.
const BLANK_M: f64 = 2.2;

/// A building's outline in its own frame, metres.
#[derive(Debug, Clone)]
pub(crate) struct BuildingOutline<'a> {
    /// Counter-clockwise.
    pub(crate) outline: &'a [DVec2],
    /// Clockwise.
    pub(crate) holes: &'a [Vec<DVec2>],
    /// The edge of the outline at the street.
    pub(crate) front: usize,
    /// Edges that stand against a neighbour.
    pub(crate) blind: &'a [bool],
    /// Colour of the walls, where known.
    pub(crate) color: Option<[f32; 3]>,
    /// Metres from ground to eaves, where known: storeys are stretched to it.
    pub(crate) height: Option<f32>,
}

fn styled(
    dimensions: &BuildingDimensions,
    block: &BuildingOutline<'_>,
    stream: &mut Stream,
) -> (BuildingFinish, FacadeRhythm) {
    let mut finish = dimensions.finish(stream);
    if let Some(color) = block.color {
        finish.wall.base_color = color;
        finish.base.base_color = color;
        finish.joinery.wall.base_color = color;
    }
    let rhythm = FacadeRhythm::of(finish.style, dimensions.shops, stream);
    let rhythm = block.height.map_or(rhythm, |height| rhythm.stretched(height, dimensions.storeys));
    (finish, rhythm)
}

/// A building on an outline.
pub(crate) fn house(
    dimensions: &BuildingDimensions,
    block: &BuildingOutline<'_>,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) -> (Mesh, f32) {
    let (finish, rhythm) = styled(dimensions, block, stream);
    let height = rhythm.height(dimensions.storeys);
    let design = BuildingDesign { dimensions, finish: &finish, rhythm: &rhythm };
    let mut mesh = MeshBuilder::new();
    for (k, wall) in edges(block.outline).enumerate() {
        let blank = f64::from(wall.width) < BLANK_M || block.blind.get(k).copied().unwrap_or(false);
        raise(&mut mesh, &wall, (k == block.front, blank), design, stream, numbers);
    }
    for wall in block.holes.iter().flat_map(|hole| edges(hole)) {
        raise(&mut mesh, &wall, (false, f64::from(wall.width) < BLANK_M), design, stream, numbers);
    }
    let parapet = stream.range_f32(0.35, 0.8);
    flat_roof(&mut mesh, block, height, parapet, &finish);
    let middle = around(block.outline);
    if matches!(finish.style.roof, RoofForm::Unfinished) {
        super::roof_form::on_unfinished_roof(&mut mesh, middle, height, stream);
    } else {
        super::roof_form::on_flat_roof(&mut mesh, dimensions, middle, height, &finish, stream);
    }
    (mesh.finish(), height + parapet)
}

/// A building on a rectangle: front along x at y = 0, with the roofs that rectangles can have.
pub(crate) fn on_rectangle(
    dimensions: &BuildingDimensions,
    block: &BuildingOutline<'_>,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) -> (Mesh, f32) {
    let (finish, rhythm) = styled(dimensions, block, stream);
    let height = rhythm.height(dimensions.storeys);
    let mesh = make_designed(BuildingDesign { dimensions, finish: &finish, rhythm: &rhythm }, stream, numbers);
    let mut whole = MeshBuilder::new();
    whole.mesh(&mesh, glam::Affine3A::IDENTITY);
    for wall in edges(block.outline) {
        wall.panel(&mut whole, [0.0, wall.width], [-FOUNDATION_M, 0.0], 0.0, finish.trim);
    }
    (whole.finish(), height + 1.0)
}

/// A rectangle about the middle of an outline that lies within it, if it is not too crooked.
fn around(outline: &[DVec2]) -> ([f32; 2], [f32; 2]) {
    let middle = outline.iter().sum::<DVec2>() / outline.len() as f64;
    let near =
        |way: fn(DVec2) -> f64| 0.62 * outline.iter().map(|p| way(*p - middle).abs()).fold(f64::INFINITY, f64::min);
    let (w, d) = (near(|p| p.x).max(0.8) as f32, near(|p| p.y).max(0.8) as f32);
    let (x, y) = (middle.x as f32, middle.y as f32);
    ([x - w, x + w], [y - d, y + d])
}

fn edges(outline: &[DVec2]) -> impl Iterator<Item = Wall> {
    (0..outline.len()).filter_map(|k| {
        let (a, b) = (outline[k], outline[(k + 1) % outline.len()]);
        let right = (b - a).try_normalize()?.extend(0.0).as_vec3();
        Some(Wall::upright(a.extend(0.0).as_vec3(), right, a.distance(b) as f32))
    })
}

fn raise(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (front, blank): (bool, bool),
    design: BuildingDesign<'_>,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let BuildingDesign { dimensions, finish, rhythm } = design;
    wall.panel(mesh, [0.0, wall.width], [-FOUNDATION_M, 0.0], 0.0, finish.trim);
    if blank {
        wall.panel(mesh, [0.0, wall.width], [0.0, rhythm.height(dimensions.storeys)], 0.0, finish.wall);
    } else {
        add_wall(mesh, wall, if front { 0 } else { 2 }, design, stream, numbers);
    }
}

/// A roof at `height`, and a parapet around it and around courtyards.
fn flat_roof(mesh: &mut MeshBuilder, block: &BuildingOutline<'_>, height: f32, parapet: f32, finish: &BuildingFinish) {
    let inner = inset(block.outline);
    let holes: Vec<Vec<DVec2>> = block.holes.iter().map(|hole| inset(hole)).collect();
    let (corners, triangles) = triangulate(&inner, &holes);
    let base = mesh.vertices(corners.iter().map(|p| (p.extend(f64::from(height)).as_vec3(), Vec3::Z, p.as_vec2())));
    for t in triangles {
        mesh.triangle_indices(t.map(|k| base + k as u32), FELT);
    }
    let rings = std::iter::once((block.outline, &inner[..]))
        .chain(block.holes.iter().map(Vec::as_slice).zip(holes.iter().map(Vec::as_slice)));
    for (outer, inner) in rings {
        for k in 0..outer.len() {
            let next = (k + 1) % outer.len();
            let at = |p: DVec2, z: f32| p.as_vec2().extend(z);
            let (top, w) = (height + parapet, outer[k].distance(outer[next]) as f32);
            let uv = |h: f32| [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]].map(Vec2::from_array);
            let (a, b, c, d) = (outer[k], outer[next], inner[next], inner[k]);
            if a.distance(b) < 0.01 || c.distance(d) < 0.01 {
                continue;
            }
            mesh.quad([at(a, height), at(b, height), at(b, top), at(a, top)], uv(parapet), finish.wall);
            mesh.quad([at(c, height), at(d, height), at(d, top), at(c, top)], uv(parapet), finish.wall);
            mesh.quad([at(a, top), at(b, top), at(c, top), at(d, top)], uv(PARAPET_M as f32), finish.trim);
        }
    }
}

/// The outline moved inwards by the thickness of a parapet.
fn inset(outline: &[DVec2]) -> Vec<DVec2> {
    let n = outline.len();
    (0..n)
        .map(|k| {
            let (before, here, after) = (outline[(k + n - 1) % n], outline[k], outline[(k + 1) % n]);
            let (u, v) = ((here - before).normalize_or(DVec2::X), (after - here).normalize_or(DVec2::X));
            let mitre = (u.perp() + v.perp()).normalize_or(u.perp());
            here + mitre * (PARAPET_M / mitre.dot(u.perp()).max(0.4))
        })
        .collect()
}
