//! The file read back as Detour reads it.

use super::super::surface::{SurfaceKind, surfaces};
use super::grid::Grid;
use super::*;
use endless_asset::Catalogue;
use endless_town::Town;
use glam::DVec2;
use std::collections::{BTreeMap, BTreeSet};

/// A cursor.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> [u8; N] {
        let (head, rest) = self.0.split_first_chunk().expect("enough bytes");
        self.0 = rest;
        *head
    }
    fn int(&mut self) -> u32 {
        u32::from_le_bytes(self.take())
    }
    fn short(&mut self) -> u16 {
        u16::from_le_bytes(self.take())
    }
    fn float(&mut self) -> f32 {
        f32::from_le_bytes(self.take())
    }
    fn point(&mut self) -> [f32; 3] {
        [self.float(), self.float(), self.float()]
    }
}

struct ReadPolygon {
    corners: Vec<usize>,
    beside: Vec<u16>,
    area: u8,
}

struct ReadMesh {
    vertices: Vec<[f32; 3]>,
    polygons: Vec<ReadPolygon>,
}

/// Reads a file and checks all that does not need the town.
fn read(bytes: &[u8]) -> ReadMesh {
    let mut from = Reader(bytes);
    assert_eq!((from.take(), from.int(), from.int()), (*b"TESM", 1, 1));
    let origin = from.point();
    let (width, depth) = (from.float(), from.float());
    let (most_tiles, most_polygons) = (from.int(), from.int());
    assert!(most_tiles == 1 && most_polygons.is_power_of_two());
    assert_eq!(from.int(), most_polygons, "salt 1, tile 0");
    assert_eq!(from.int() as usize, from.0.len());
    assert_eq!((from.take(), from.int()), (*b"VAND", 7));
    assert_eq!([from.int(), from.int(), from.int(), from.int()], [0; 4]);
    let [polygons, vertices, links, details, detail_vertices, triangles, nodes, off_mesh, base] =
        std::array::from_fn(|_| from.int() as usize);
    assert!(polygons > 0 && polygons <= most_polygons as usize && polygons < 0x7fff && vertices < 0xffff);
    assert_eq!([details, detail_vertices, nodes, off_mesh, base], [polygons, 0, 2 * polygons - 1, 0, polygons]);
    assert_eq!(from.point(), [1.8, 0.3, 0.4]);
    let (low, high) = (from.point(), from.point());
    assert_eq!((origin, width, depth), (low, high[0] - low[0], high[2] - low[2]));
    let quant = from.float();
    let vertices: Vec<[f32; 3]> = (0..vertices).map(|_| from.point()).collect();
    assert!(vertices.iter().all(|v| (0..3).all(|k| v[k] >= low[k] && v[k] <= high[k])));
    let polygons: Vec<ReadPolygon> = (0..polygons)
        .map(|_| {
            assert_eq!(from.int(), u32::MAX);
            let corners: [u16; 6] = std::array::from_fn(|_| from.short());
            let beside: [u16; 6] = std::array::from_fn(|_| from.short());
            let flags = from.short();
            let [count, area] = from.take();
            assert!((3..=6).contains(&count) && (1..=3).contains(&area) && flags == 1 << area);
            let corners: Vec<usize> = corners[..usize::from(count)].iter().map(|&c| usize::from(c)).collect();
            assert!(corners.iter().all(|&c| c < vertices.len()));
            ReadPolygon { corners, beside: beside[..usize::from(count)].to_vec(), area }
        })
        .collect();
    for _ in 0..links {
        assert_eq!(from.take(), [0; 12]);
    }
    assert!(links >= polygons.iter().map(|p| p.corners.len()).sum());
    let mut next = 0;
    for polygon in &polygons {
        assert_eq!((from.int(), from.int()), (0, next));
        let [corners, count, _, _] = from.take();
        assert_eq!((corners, usize::from(count)), (0, polygon.corners.len() - 2));
        next += u32::from(count);
    }
    assert_eq!(next as usize, triangles);
    for polygon in &polygons {
        let n = polygon.corners.len() as u8;
        let mut on_border = Vec::new();
        for _ in 2..n {
            let [a, b, c, flags] = from.take();
            for (bit, side) in [(1, [a, b]), (4, [b, c]), (16, [c, a])] {
                assert_eq!(flags & bit != 0, side[1] == (side[0] + 1) % n);
                if flags & bit != 0 {
                    on_border.push(side[0]);
                }
            }
        }
        on_border.sort_unstable();
        assert_eq!(on_border, (0..n).collect::<Vec<u8>>());
    }
    check_tree(&mut from, nodes, &vertices, &polygons, low, quant);
    assert!(from.0.is_empty());
    let mesh = ReadMesh { vertices, polygons };
    mesh.check_polygons();
    mesh
}

fn check_tree(
    from: &mut Reader<'_>,
    nodes: usize,
    vertices: &[[f32; 3]],
    polygons: &[ReadPolygon],
    low: [f32; 3],
    quant: f32,
) {
    let mut leaves = BTreeSet::new();
    let mut open: Vec<(usize, [u16; 3], [u16; 3])> = Vec::new();
    for node in 0..nodes {
        let [a, b]: [[u16; 3]; 2] = std::array::from_fn(|_| std::array::from_fn(|_| from.short()));
        let number = i32::from_le_bytes(from.take());
        while open.last().is_some_and(|&(end, ..)| end <= node) {
            open.pop();
        }
        for (_, low, high) in &open {
            assert!((0..3).all(|k| low[k] <= a[k] && b[k] <= high[k]));
        }
        if number < 0 {
            open.push((node + number.unsigned_abs() as usize, a, b));
            continue;
        }
        assert!(leaves.insert(number));
        for &corner in &polygons[number as usize].corners {
            for k in 0..3 {
                let at = (vertices[corner][k] - low[k]) * quant;
                assert!(f32::from(a[k]) <= at && at <= f32::from(b[k]));
            }
        }
    }
    assert_eq!(leaves.len(), polygons.len());
}

impl ReadMesh {
    /// In CARLA's x and y.
    fn flat(&self, corner: usize) -> DVec2 {
        let [x, _, y] = self.vertices[corner];
        DVec2::new(f64::from(x), f64::from(y))
    }

    fn check_polygons(&self) {
        for (number, polygon) in self.polygons.iter().enumerate() {
            let n = polygon.corners.len();
            let at = |i: usize| self.flat(polygon.corners[i % n]);
            // As (0, 0), (0, 1), (1, 1), (1, 0) goes round.
            let turns = (0..n).map(|i| (at(i + 1) - at(i)).perp_dot(at(i + 2) - at(i + 1)));
            assert!(turns.clone().all(|turn| turn <= 1e-3) && turns.sum::<f64>() < -1e-3, "{number}");
            assert!(self.area(polygon) > 0.0);
            for (i, &beside) in polygon.beside.iter().enumerate() {
                let Some(other) = usize::from(beside).checked_sub(1) else { continue };
                let other = &self.polygons[other];
                let side = [polygon.corners[(i + 1) % n], polygon.corners[i]];
                let m = other.corners.len();
                let back = (0..m).find(|&k| [other.corners[k], other.corners[(k + 1) % m]] == side);
                assert_eq!(back.map(|k| usize::from(other.beside[k])), Some(number + 1));
            }
        }
    }

    fn area(&self, polygon: &ReadPolygon) -> f64 {
        let origin = self.flat(polygon.corners[0]);
        let fan = polygon.corners.windows(2).map(|p| (self.flat(p[1]) - origin).perp_dot(self.flat(p[0]) - origin));
        0.5 * fan.sum::<f64>()
    }

    fn area_of(&self, areas: &[u8]) -> f64 {
        self.polygons.iter().filter(|p| areas.contains(&p.area)).map(|p| self.area(p)).sum()
    }

    /// Area of the largest part in which one walks from polygon to polygon without roads, m².
    fn largest_part(&self) -> f64 {
        let walked = |i: usize| self.polygons[i].area != 3;
        let mut seen = vec![false; self.polygons.len()];
        let mut largest = 0.0f64;
        for start in (0..self.polygons.len()).filter(|&i| walked(i)) {
            let (mut open, mut area) = (vec![start], 0.0);
            while let Some(at) = open.pop() {
                if !walked(at) || std::mem::replace(&mut seen[at], true) {
                    continue;
                }
                area += self.area(&self.polygons[at]);
                open.extend(self.polygons[at].beside.iter().filter_map(|&b| usize::from(b).checked_sub(1)));
            }
            largest = largest.max(area);
        }
        largest
    }

    /// Height of the mesh at a place in the world, nearest to a height.
    fn height(&self, place: DVec2, near: f64) -> Option<f64> {
        let at = DVec2::new(place.x, -place.y);
        let heights = self.polygons.iter().flat_map(|polygon| {
            (1..polygon.corners.len() - 1).filter_map(move |k| {
                let ends = [0, k, k + 1].map(|i| polygon.corners[i]);
                let [a, b, c] = ends.map(|corner| self.flat(corner));
                let (u, v, p) = (b - a, c - a, at - a);
                let whole = u.perp_dot(v);
                let (s, t) = (p.perp_dot(v) / whole, u.perp_dot(p) / whole);
                let [za, zb, zc] = ends.map(|corner| f64::from(self.vertices[corner][1]));
                (s >= 0.0 && t >= 0.0 && s + t <= 1.0).then_some(za + s * (zb - za) + t * (zc - za))
            })
        });
        heights.min_by(|a, b| (a - near).abs().total_cmp(&(b - near).abs()))
    }
}

/// Cells of a town's ground by area, without keeping clear of edges, m².
fn walkable_m2(surfaces: &[Surface]) -> f64 {
    // Ways are not kept clear of edges.
    let as_ways: Vec<Surface> = surfaces
        .iter()
        .filter(|s| s.kind != SurfaceKind::Road)
        .map(|s| Surface { kind: SurfaceKind::Way, ..*s })
        .collect();
    let grid = Grid::new(&as_ways, 0.25);
    grid.spans.len() as f64 * 0.25 * 0.25
}

fn judge(town: &Town) {
    let surfaces = surfaces(town);
    let mesh = build(&town.name, &surfaces).expect("people walk");
    assert_eq!(build(&town.name, &surfaces).as_ref(), Some(&mesh), "the same every time");
    let read = read(&mesh.bytes);
    let walked = read.area_of(&[1, 2]);
    let (covered, joined) = (walked / walkable_m2(&surfaces), read.largest_part() / walked);
    println!(
        "{}: {} polygons, {} vertices, sidewalks {:.0} m2, crossings {:.0} m2, roads {:.0} m2, {:.1} % covered, {:.1} % in one",
        mesh.file_name,
        read.polygons.len(),
        read.vertices.len(),
        read.area_of(&[1]),
        read.area_of(&[2]),
        read.area_of(&[3]),
        100.0 * covered,
        100.0 * joined,
    );
    assert!(covered > 0.7 && joined > 0.9);
    assert!(read.area_of(&[2]) > 0.0 && read.area_of(&[3]) > read.area_of(&[2]));
    // People stand on the ground.
    let walk = &town.network.walk;
    let (mut farthest, mut missed) = (0.0f64, 0);
    let mut apart: BTreeMap<u32, u32> = BTreeMap::new();
    for edge in walk.edges.iter().filter(|edge| edge.kind == endless_road::WalkKind::Sidewalk).step_by(3) {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()]);
        let middle = a.midpoint(b);
        match read.height(middle.truncate(), middle.z) {
            Some(z) => {
                farthest = farthest.max((z - middle.z).abs());
                *apart.entry((20.0 * (z - middle.z).abs()) as u32).or_default() += 1;
            }
            None => missed += 1,
        }
    }
    println!("  heights up to {farthest:.3} m apart, by 5 cm {apart:?}; {missed} ways off the mesh");
    assert!(farthest < 0.35 && missed * 50 <= walk.edges.len());
}

fn town(name: &str) -> Town {
    endless_town::load(name, &Catalogue::builtin()).expect("a town")
}

#[test]
fn people_walk_in_streets_of_shops() {
    judge(&town("Town02"));
}

#[test]
fn people_walk_over_bridges() {
    judge(&town("Town01"));
}

#[test]
#[ignore = "all towns: a minute"]
fn people_walk_in_all_towns() {
    for name in endless_town::NAMES {
        let town = town(name);
        let mesh = build(name, &surfaces(&town)).expect("people walk");
        if let Some(folder) = std::env::var_os("NAVMESH_FOLDER") {
            std::fs::write(std::path::Path::new(&folder).join(format!("{name}.bin")), &mesh.bytes).expect("written");
        }
        judge(&town);
    }
}
