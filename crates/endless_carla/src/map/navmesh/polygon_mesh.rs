//! Convex polygons that meet edge to edge.

use super::contour::Contour;
use super::triangulate::{Point, area, triangulate};
use super::walk_area::WalkArea;
use glam::DVec3;
use std::collections::HashMap;

/// Most corners of a polygon in the format.
pub(super) const MOST_CORNERS: usize = 6;
/// Most polygons and corners in one tile: their numbers have 15 and 16 bits.
const MOST_POLYGONS: usize = 0x7ffe;
const MOST_VERTICES: usize = 0xfffe;

/// A convex polygon.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Polygon {
    pub(super) area: WalkArea,
    /// Indices of its corners, counter-clockwise seen from above.
    pub(super) corners: Vec<u32>,
    /// The polygon beyond the side that begins at each corner.
    pub(super) beside: Vec<Option<u32>>,
}

/// Polygons and their corners.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct PolygonMesh {
    /// In the world, metres.
    pub(super) vertices: Vec<DVec3>,
    pub(super) polygons: Vec<Polygon>,
}

impl PolygonMesh {
    pub(super) fn new(outlines: &[Contour]) -> Self {
        let mut mesh = Self::default();
        let mut numbers: HashMap<([i32; 2], u32), u32> = HashMap::new();
        let mut flat: Vec<Point> = Vec::new();
        for outline in outlines {
            let points: Vec<Point> = outline.corners.iter().map(|corner| corner.key.0).collect();
            let corners: Vec<u32> = outline
                .corners
                .iter()
                .map(|corner| {
                    *numbers.entry(corner.key).or_insert_with(|| {
                        mesh.vertices.push(corner.place);
                        flat.push(corner.key.0);
                        mesh.vertices.len() as u32 - 1
                    })
                })
                .collect();
            let triangles = triangulate(&points).into_iter().map(|t| t.map(|i| corners[i]).to_vec()).collect();
            let joined = joined(&flat, triangles);
            mesh.polygons.extend(joined.into_iter().map(|corners| {
                let beside = vec![None; corners.len()];
                Polygon { area: outline.area, corners, beside }
            }));
        }
        mesh.find_neighbours();
        mesh
    }

    /// Whether the format has room for it.
    pub(super) fn fits(&self) -> bool {
        self.polygons.len() <= MOST_POLYGONS && self.vertices.len() <= MOST_VERTICES
    }

    fn find_neighbours(&mut self) {
        let mut sides: HashMap<[u32; 2], u32> = HashMap::new();
        for (number, polygon) in (0..).zip(&self.polygons) {
            for side in sides_of(&polygon.corners) {
                sides.entry(side).or_insert(number);
            }
        }
        for number in 0..self.polygons.len() {
            let polygon = &self.polygons[number];
            let beside: Vec<Option<u32>> = sides_of(&polygon.corners)
                .map(|[a, b]| {
                    // Only where both think so: a side that two polygons claim has one neighbour.
                    let own = sides.get(&[a, b]) == Some(&(number as u32));
                    sides.get(&[b, a]).copied().filter(|_| own)
                })
                .collect();
            self.polygons[number].beside = beside;
        }
    }
}

fn sides_of(corners: &[u32]) -> impl Iterator<Item = [u32; 2]> + '_ {
    (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]])
}

/// Triangles joined over their common sides, the longest first, as long as what results is convex.
fn joined(points: &[Point], mut pieces: Vec<Vec<u32>>) -> Vec<Vec<u32>> {
    let length = |[a, b]: [u32; 2]| {
        let [p, q] = [points[a as usize], points[b as usize]];
        let [x, y] = [0, 1].map(|k| i64::from(q[k]) - i64::from(p[k]));
        x * x + y * y
    };
    let mut home: HashMap<[u32; 2], usize> = HashMap::new();
    for (number, piece) in pieces.iter().enumerate() {
        home.extend(sides_of(piece).map(|side| (side, number)));
    }
    let mut common: Vec<[u32; 2]> =
        pieces.iter().flat_map(|piece| sides_of(piece)).filter(|&[a, b]| a < b && home.contains_key(&[b, a])).collect();
    common.sort_by_key(|&side| (-length(side), side));
    for [a, b] in common {
        let (Some(&one), Some(&other)) = (home.get(&[a, b]), home.get(&[b, a])) else { continue };
        if one == other {
            continue;
        }
        let Some(whole) = union(points, &pieces[one], &pieces[other], [a, b]) else { continue };
        home.remove(&[a, b]);
        home.remove(&[b, a]);
        home.extend(sides_of(&whole).map(|side| (side, one)));
        pieces[one] = whole;
        pieces[other].clear();
    }
    pieces.retain(|piece| !piece.is_empty());
    pieces
}

/// Two polygons in one, without the side `[a, b]` of the first and `[b, a]` of the second; `None` if it would not be
/// convex or have too many corners.
fn union(points: &[Point], one: &[u32], other: &[u32], [a, b]: [u32; 2]) -> Option<Vec<u32>> {
    if one.len() + other.len() - 2 > MOST_CORNERS {
        return None;
    }
    let from = |ring: &[u32], first: u32| {
        let at = ring.iter().position(|&corner| corner == first)?;
        Some(ring[at..].iter().chain(&ring[..at]).copied().collect::<Vec<u32>>())
    };
    // From b round to a, and from a round to b.
    let (mut whole, rest) = (from(one, b)?, from(other, a)?);
    whole.extend(&rest[1..rest.len() - 1]);
    let n = whole.len();
    let corner = |i: usize| points[whole[i % n] as usize];
    let convex = (0..n).all(|i| area(corner(i), corner(i + 1), corner(i + 2)) >= 0);
    // Where the two meet there is a corner, not a straight side that doubles back.
    let distinct = (0..n).all(|i| (i + 1..n).all(|k| whole[i] != whole[k]));
    (convex && distinct).then_some(whole)
}
