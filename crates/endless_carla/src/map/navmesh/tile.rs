//! The file: a set of one tile, as Detour's sample program stores it (`NavMeshSetHeader`) and CARLA's client loads it;
//! `dtMeshHeader` version 7, little-endian, with 32-bit references.
//!
//! Detour's axes are x, up and z; in CARLA's these are x, z and y. So a polygon that is counter-clockwise in our world
//! stays as it is.

use super::polygon_mesh::{MOST_CORNERS, Polygon, PolygonMesh};
use glam::DVec3;

/// In the file these words stand backwards.
const SET_MAGIC: u32 = u32::from_be_bytes(*b"MSET");
const TILE_MAGIC: u32 = u32::from_be_bytes(*b"DNAV");
const SET_VERSION: u32 = 1;
const TILE_VERSION: u32 = 7;
/// Of people, metres.
const HEIGHT_M: f32 = 1.8;
const RADIUS_M: f32 = 0.3;
const CLIMB_M: f32 = 0.4;
/// Side of the cells in which bounds are counted, metres.
const BOUNDS_CELL_M: f32 = 0.25;
/// No link.
const NO_LINK: u32 = u32::MAX;
/// Sides of a detail triangle that lie on its polygon's: from the first corner to the second, and so on.
const AB: u8 = 1;
const BC: u8 = 4;
const CA: u8 = 16;

/// Little-endian bytes.
#[derive(Debug, Default)]
struct Bytes(Vec<u8>);

impl Bytes {
    fn numbers(&mut self, numbers: &[u32]) {
        numbers.iter().for_each(|number| self.0.extend(number.to_le_bytes()));
    }

    fn shorts(&mut self, numbers: &[u16]) {
        numbers.iter().for_each(|number| self.0.extend(number.to_le_bytes()));
    }

    fn floats(&mut self, numbers: &[f32]) {
        numbers.iter().for_each(|number| self.0.extend(number.to_le_bytes()));
    }
}

/// In Detour's axes.
fn detour(place: DVec3) -> [f32; 3] {
    [place.x as f32, place.z as f32, -place.y as f32]
}

/// The whole file.
pub(super) fn file(mesh: &PolygonMesh) -> Vec<u8> {
    let vertices: Vec<[f32; 3]> = mesh.vertices.iter().copied().map(detour).collect();
    let (low, high) = bounds(&vertices);
    let most_polygons = (mesh.polygons.len() as u32).next_power_of_two();
    let tile = tile(mesh, &vertices, low, high);
    let mut bytes = Bytes::default();
    bytes.numbers(&[SET_MAGIC, SET_VERSION, 1]);
    bytes.floats(&low);
    bytes.floats(&[high[0] - low[0], high[2] - low[2]]);
    bytes.numbers(&[1, most_polygons]);
    // Of the first tile, the first time: salt 1 above the bits that number polygons.
    bytes.numbers(&[1 << most_polygons.trailing_zeros(), tile.len() as u32]);
    bytes.0.extend(tile);
    bytes.0
}

fn bounds(vertices: &[[f32; 3]]) -> ([f32; 3], [f32; 3]) {
    let fold = |start: f32, take: fn(f32, f32) -> f32| {
        [0, 1, 2].map(|axis| vertices.iter().map(|v| v[axis]).fold(start, take))
    };
    (fold(f32::INFINITY, f32::min), fold(f32::NEG_INFINITY, f32::max))
}

fn tile(mesh: &PolygonMesh, vertices: &[[f32; 3]], low: [f32; 3], high: [f32; 3]) -> Vec<u8> {
    let count = mesh.polygons.len() as u32;
    let sides: usize = mesh.polygons.iter().map(|polygon| polygon.corners.len()).sum();
    let triangles: usize = mesh.polygons.iter().map(|polygon| polygon.corners.len() - 2).sum();
    let nodes = bounds_tree(mesh, vertices, low);
    let mut bytes = Bytes::default();
    // Column, row, layer and user id of the tile are 0; there are no vertices of details and no off-mesh connections.
    bytes.numbers(&[TILE_MAGIC, TILE_VERSION, 0, 0, 0, 0, count, vertices.len() as u32, sides as u32]);
    bytes.numbers(&[count, 0, triangles as u32, nodes.len() as u32, 0, count]);
    bytes.floats(&[HEIGHT_M, RADIUS_M, CLIMB_M]);
    bytes.floats(&low);
    bytes.floats(&high);
    bytes.floats(&[1.0 / BOUNDS_CELL_M]);
    vertices.iter().for_each(|vertex| bytes.floats(vertex));
    mesh.polygons.iter().for_each(|polygon| write_polygon(polygon, &mut bytes));
    // Links, which the reader fills in.
    bytes.0.resize(bytes.0.len() + 12 * sides, 0);
    let mut first = 0;
    for polygon in &mesh.polygons {
        let triangles = polygon.corners.len() as u32 - 2;
        bytes.numbers(&[0, first]);
        bytes.0.extend([0, triangles as u8, 0, 0]);
        first += triangles;
    }
    mesh.polygons.iter().for_each(|polygon| write_details(polygon, &mesh.vertices, &mut bytes));
    for node in nodes {
        bytes.shorts(&node.low);
        bytes.shorts(&node.high);
        bytes.0.extend(node.polygon_or_skip.to_le_bytes());
    }
    bytes.0
}

fn write_polygon(polygon: &Polygon, bytes: &mut Bytes) {
    let (mut corners, mut beside) = ([0u16; MOST_CORNERS], [0u16; MOST_CORNERS]);
    for (i, &corner) in polygon.corners.iter().enumerate() {
        corners[i] = corner as u16;
        beside[i] = polygon.beside[i].map_or(0, |other| other as u16 + 1);
    }
    bytes.numbers(&[NO_LINK]);
    bytes.shorts(&corners);
    bytes.shorts(&beside);
    bytes.shorts(&[polygon.area.flag()]);
    bytes.0.extend([polygon.corners.len() as u8, polygon.area.number()]);
}

/// A fan of triangles from the corner from which the smallest of them is largest.
fn write_details(polygon: &Polygon, vertices: &[DVec3], bytes: &mut Bytes) {
    let n = polygon.corners.len();
    let place = |i: usize| vertices[polygon.corners[i % n] as usize].truncate();
    let smallest = |from: usize| {
        let area = |k: usize| (place(from + k) - place(from)).perp_dot(place(from + k + 1) - place(from));
        (1..n - 1).map(area).fold(f64::INFINITY, f64::min)
    };
    let from = (0..n).rev().max_by(|&a, &b| smallest(a).total_cmp(&smallest(b))).unwrap_or(0);
    for k in 1..n - 1 {
        let mut flags = BC;
        if k == 1 {
            flags |= AB;
        }
        if k == n - 2 {
            flags |= CA;
        }
        bytes.0.extend([from, from + k, from + k + 1].map(|i| (i % n) as u8));
        bytes.0.push(flags);
    }
}

/// A box of the tree by which polygons are found.
#[derive(Debug, Clone, Copy)]
struct BoundsNode {
    low: [u16; 3],
    high: [u16; 3],
    /// The number of a polygon, or minus the number of nodes that are skipped where the box is missed.
    polygon_or_skip: i32,
}

fn bounds_tree(mesh: &PolygonMesh, vertices: &[[f32; 3]], low: [f32; 3]) -> Vec<BoundsNode> {
    let counted = |value: f32, axis: usize, up: bool| {
        let cells = (value - low[axis]) / BOUNDS_CELL_M;
        (if up { cells.ceil() } else { cells.floor() }).clamp(0.0, 65535.0) as u16
    };
    let mut leaves: Vec<BoundsNode> = (0..)
        .zip(&mesh.polygons)
        .map(|(polygon_or_skip, polygon)| {
            let corners: Vec<[f32; 3]> = polygon.corners.iter().map(|&corner| vertices[corner as usize]).collect();
            let (from, to) = bounds(&corners);
            let [low, high] =
                [(from, false), (to, true)].map(|(ends, up)| [0, 1, 2].map(|axis| counted(ends[axis], axis, up)));
            BoundsNode { low, high, polygon_or_skip }
        })
        .collect();
    let mut nodes = Vec::with_capacity(2 * leaves.len());
    if !leaves.is_empty() {
        subdivide(&mut leaves, &mut nodes);
    }
    nodes
}

/// Halves boxes along the longer side of what is around them.
fn subdivide(leaves: &mut [BoundsNode], nodes: &mut Vec<BoundsNode>) {
    if let [leaf] = leaves {
        nodes.push(*leaf);
        return;
    }
    let low = [0, 1, 2].map(|axis| leaves.iter().map(|leaf| leaf.low[axis]).min().unwrap_or(0));
    let high = [0, 1, 2].map(|axis| leaves.iter().map(|leaf| leaf.high[axis]).max().unwrap_or(0));
    let axis = if high[2] - low[2] > high[0] - low[0] { 2 } else { 0 };
    leaves.sort_by_key(|leaf| (leaf.low[axis], leaf.polygon_or_skip));
    let own = nodes.len();
    nodes.push(BoundsNode { low, high, polygon_or_skip: 0 });
    let (one, other) = leaves.split_at_mut(leaves.len() / 2);
    subdivide(one, nodes);
    subdivide(other, nodes);
    nodes[own].polygon_or_skip = -((nodes.len() - own) as i32);
}
