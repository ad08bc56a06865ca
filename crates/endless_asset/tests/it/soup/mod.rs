//! Rays against a mesh: the nearest triangle, found in a tree of boxes.

use endless_scene::Mesh;
use endless_world::Stream;
use glam::Vec3;

/// The triangles of a mesh.
pub(crate) struct Soup {
    pub(crate) corners: Vec<[Vec3; 3]>,
    low: Vec3,
    high: Vec3,
    nodes: Vec<Node>,
    /// Numbers of triangles, in the order of the leaves.
    order: Vec<usize>,
}

/// A box around a run of `order`; unless it is a leaf its halves are the next node and `other`.
struct Node {
    low: Vec3,
    high: Vec3,
    run: std::ops::Range<usize>,
    other: usize,
}

/// Triangles in a leaf, at most.
const LEAF: usize = 8;

impl Soup {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let corners: Vec<[Vec3; 3]> = mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize])).collect();
        let (low, high) = mesh.bounds();
        let order = (0..corners.len()).collect();
        let sums: Vec<Vec3> = corners.iter().map(|[a, b, c]| *a + *b + *c).collect();
        let mut soup = Self { order, low, high, nodes: Vec::new(), corners };
        soup.split(0..soup.corners.len(), &sums);
        soup
    }

    /// Adds the nodes of a run, halved where it is longest by the sums of corners.
    fn split(&mut self, run: std::ops::Range<usize>, sums: &[Vec3]) {
        let points = || self.order[run.clone()].iter().flat_map(|&i| self.corners[i]);
        let (low, high) = (points().fold(Vec3::INFINITY, Vec3::min), points().fold(Vec3::NEG_INFINITY, Vec3::max));
        let node = self.nodes.len();
        self.nodes.push(Node { low, high, run: run.clone(), other: 0 });
        if run.len() <= LEAF {
            return;
        }
        let axis = (high - low).max_position();
        let half = run.len() / 2;
        self.order[run.clone()].select_nth_unstable_by(half, |&a, &b| sums[a][axis].total_cmp(&sums[b][axis]));
        self.split(run.start..run.start + half, sums);
        self.nodes[node].other = self.nodes.len();
        self.split(run.start + half..run.end, sums);
    }

    /// Distance and number of the first triangle that a ray meets, from either side.
    pub(crate) fn first(&self, origin: Vec3, direction: Vec3) -> Option<(f32, usize)> {
        let mut best: Option<(f32, usize)> = None;
        let mut open = vec![0];
        while let Some(at) = open.pop() {
            let node = &self.nodes[at];
            let (a, b) = ((node.low - origin) / direction, (node.high - origin) / direction);
            let enters = a.min(b).max_element().max(0.0);
            if enters > a.max(b).min_element() * 1.0001 || best.is_some_and(|(t, _)| t < enters) {
                continue;
            }
            if node.run.len() > LEAF {
                open.extend([at + 1, node.other]);
                continue;
            }
            for &i in &self.order[node.run.clone()] {
                if let Some(t) = meets(self.corners[i], origin, direction)
                    && best.is_none_or(|known| (t, i) < known)
                {
                    best = Some((t, i));
                }
            }
        }
        best
    }

    pub(crate) fn normal(&self, i: usize) -> Vec3 {
        let [a, b, c] = self.corners[i];
        (b - a).cross(c - a).normalize_or_zero()
    }

    /// Of so many rays from where a camera may hang: how many met something, and how many of these its inner side.
    pub(crate) fn inner_sides(&self, rays: usize, name: &str) -> (usize, usize) {
        let (mut met, mut inner) = (0, 0);
        let mut stream = Stream::named(7, name, &[]);
        let middle = 0.5 * (self.low + self.high);
        for _ in 0..rays {
            let azimuth = stream.range_f32(0.0, std::f32::consts::TAU);
            let up = stream.range_f32(0.1, 1.3);
            let (sin, cos) = endless_world::math::sin_cos(azimuth);
            let (up_sin, up_cos) = endless_world::math::sin_cos(up);
            let from = middle + 30.0 * Vec3::new(cos * up_cos, sin * up_cos, up_sin);
            let unit = Vec3::new(stream.f32(), stream.f32(), stream.f32());
            let direction = (self.low + (self.high - self.low) * unit - from).normalize();
            if let Some((_, i)) = self.first(from, direction) {
                met += 1;
                inner += usize::from(self.normal(i).dot(direction) > 0.02);
            }
        }
        (met, inner)
    }
}

/// Distance to a triangle from either side (Möller and Trumbore 1997).
fn meets([a, b, c]: [Vec3; 3], origin: Vec3, direction: Vec3) -> Option<f32> {
    let (e, f) = (b - a, c - a);
    let p = direction.cross(f);
    let determinant = e.dot(p);
    if determinant.abs() < 1e-12 {
        return None;
    }
    let s = origin - a;
    let u = s.dot(p) / determinant;
    let q = s.cross(e);
    let v = direction.dot(q) / determinant;
    let t = f.dot(q) / determinant;
    ((0.0..=1.0).contains(&u) && v >= 0.0 && u + v <= 1.0 && t > 1e-5).then_some(t)
}
