//! Ambient occlusion of each vertex of a moving body by the body itself and the ground that it shades.
//!
//! It is traced when a vertex is first asked for: most of what moves is out of sight or small, and shows few of its
//! vertices. Whoever asks first finds the same.

use super::posed_mesh::PosedMesh;
use crate::accel::Ray;
use crate::sampling::{cosine_direction, hammersley};
use glam::{IVec3, Vec3, Vec3A};
use std::collections::HashMap;
use std::sync::atomic::{AtomicU32, AtomicUsize, Ordering};
use std::sync::{Arc, LazyLock};

const RAYS: u32 = 24;
const SPARSE: u32 = 3;
const FIRST: u32 = RAYS / SPARSE;
/// Rays start this far off the surface; of the object's largest measure.
const LIFT: f32 = 2e-3;

/// About the normal of the surface, which is up; a third of them, well spread, come first.
static DIRECTIONS: LazyLock<[Vec3A; RAYS as usize]> = LazyLock::new(|| {
    let order = |k: u32| SPARSE * (k % FIRST) + k / FIRST;
    std::array::from_fn(|k| cosine_direction(Vec3A::Z, hammersley(order(k as u32), RAYS)))
});

/// The cosine-weighted share of directions, 0 to 1, that neither meet the body itself nor the dark ground beneath it,
/// at each vertex: as in glTF's occlusion textures.
#[derive(Debug)]
pub(crate) struct AmbientOcclusion {
    /// In the form in which it shades itself.
    body: Arc<PosedMesh>,
    /// The whole object, wheels included, in its own frame.
    low: Vec3A,
    high: Vec3A,
    /// Vertices that stand for all: one of those that lie on one small flat piece of surface, where all see about the
    /// same.
    vertices: Vec<u32>,
    /// Which of them stands for each vertex.
    place_of: Vec<u32>,
    /// Bits of what was found there; [`UNKNOWN`] before.
    open: Vec<AtomicU32>,
    /// What was in the way in each direction before: it mostly is again.
    hints: [AtomicUsize; RAYS as usize],
}

/// Bits of no share.
const UNKNOWN: u32 = u32::MAX;

impl AmbientOcclusion {
    /// Of a body; `low` and `high` bound the whole object, wheels included, in its own frame, metres.
    pub(super) fn new(body: Arc<PosedMesh>, low: Vec3, high: Vec3) -> Self {
        let (vertices, place_of) = places(&body, (high - low).max_element());
        let open = vertices.iter().map(|_| AtomicU32::new(UNKNOWN)).collect();
        let hints = [const { AtomicUsize::new(usize::MAX) }; RAYS as usize];
        Self { body, low: low.into(), high: high.into(), vertices, place_of, open, hints }
    }

    /// At a vertex.
    pub(crate) fn at(&self, vertex: usize) -> f32 {
        let place = self.place_of[vertex] as usize;
        let known = self.open[place].load(Ordering::Relaxed);
        if known != UNKNOWN {
            return f32::from_bits(known);
        }
        let open = self.traced(self.vertices[place] as usize);
        self.open[place].store(open.to_bits(), Ordering::Relaxed);
        open
    }

    fn traced(&self, vertex: usize) -> f32 {
        let mesh = &self.body;
        let size = (self.high - self.low).max_element();
        let normal = mesh.normal(vertex);
        let origin = Vec3A::from(mesh.positions()[vertex]) + normal * (size * LIFT);
        let (a, b) = normal.any_orthonormal_pair();
        let mut light = DIRECTIONS.iter().zip(&self.hints).map(|(d, hint)| {
            let direction = a * d.x + b * d.y + normal * d.z;
            let occluded = mesh.blas.occluded(&Ray { origin, direction, tmax: size }, hint);
            if occluded { 0.0 } else { self.ground_light(origin, direction) }
        });
        let first: f32 = light.by_ref().take(FIRST as usize).sum();
        // Deep inside nothing is seen.
        if first == 0.0 { 0.0 } else { (first + light.sum::<f32>()) / RAYS as f32 }
    }

    /// Ground under the object lies in its shadow: a direction that ends there brings little.
    fn ground_light(&self, origin: Vec3A, direction: Vec3A) -> f32 {
        if direction.z >= -1e-3 {
            return 1.0;
        }
        let end = origin + direction * (origin.z.max(0.0) / -direction.z);
        let outside = (self.low - end).max(end - self.high).max(Vec3A::ZERO);
        let distance = (outside.x * outside.x + outside.y * outside.y).sqrt();
        let reach = (self.high.z - self.low.z) * 0.6;
        0.12 + 0.88 * (distance / reach).min(1.0)
    }
}

/// Vertices that stand for others, and which of them stands for each; `size` is the object's largest measure.
fn places(mesh: &PosedMesh, size: f32) -> (Vec<u32>, Vec<u32>) {
    /// Across the surface, of the object's size and in metres at most.
    const ACROSS: f32 = 0.012;
    const MOST_M: f32 = 0.05;
    /// Along the normal, metres at least.
    const LEAST_M: f32 = 0.006;
    let (across, along) = ((ACROSS * size).min(MOST_M), (LIFT * size).max(LEAST_M));
    let count = mesh.positions().len();
    let mut known: HashMap<(IVec3, IVec3, i32), u32> = HashMap::with_capacity(count);
    let mut vertices = Vec::new();
    let mut place_of = |vertex: usize| {
        let (position, normal) = (Vec3A::from(mesh.positions()[vertex]), mesh.normal(vertex));
        let facing = (normal * 4.0).round();
        let height = (position.dot(facing.normalize_or(Vec3A::Z)) / along).floor();
        let key = ((position / across).floor().as_ivec3(), facing.as_ivec3(), height as i32);
        *known.entry(key).or_insert_with(|| {
            vertices.push(vertex as u32);
            vertices.len() as u32 - 1
        })
    };
    let place_of = (0..count).map(&mut place_of).collect();
    (vertices, place_of)
}

#[cfg(test)]
mod tests {
    use super::super::Geometry;
    use endless_scene::{Material, MeshBuilder, Surface};
    use endless_world::ClassTag;
    use glam::Vec3;

    fn open(geometry: &Geometry, vertex: usize) -> f32 {
        geometry.ambient_occlusion.as_ref().expect("it has been asked for").at(vertex)
    }

    /// A table a metre high, and a lamp that stands on it.
    fn table() -> Geometry {
        let mut builder = MeshBuilder::new();
        let material = Material::new(Surface::Concrete, [0.4; 3], ClassTag::Static);
        builder.cuboid(Vec3::new(-1.0, -1.0, 0.95), Vec3::new(1.0, 1.0, 1.0), material);
        builder.cuboid(Vec3::new(-0.1, -0.1, 1.0), Vec3::new(0.1, 0.1, 1.5), material);
        Geometry::rigid(builder.finish()).with_ambient_occlusion(Vec3::new(-1.0, -1.0, 0.0), Vec3::new(1.0, 1.0, 1.5))
    }

    #[test]
    fn the_top_is_open_and_what_is_beneath_is_dark() {
        let table = table();
        let mesh = table.mesh();
        let at = |position: Vec3, normal: Vec3| {
            let same = |i: &usize| mesh.positions[*i].distance(position) < 1e-4 && mesh.normals[*i].dot(normal) > 0.9;
            let vertex = (0..mesh.positions.len()).find(same).expect("a corner of the table");
            open(&table, vertex)
        };
        assert_eq!(at(Vec3::new(0.1, 0.1, 1.5), Vec3::Z), 1.0);
        let (above, beneath) = (at(Vec3::new(1.0, 1.0, 1.0), Vec3::Z), at(Vec3::new(1.0, 1.0, 0.95), -Vec3::Z));
        assert!(above > 0.9 && beneath < 0.6, "{above} {beneath}");
    }

    #[test]
    fn whoever_asks_first_finds_the_same() {
        let count = table().mesh().positions.len();
        let (forwards, backwards) = (table(), table());
        let first: Vec<f32> = (0..count).map(|vertex| open(&forwards, vertex)).collect();
        let last: Vec<f32> = (0..count).rev().map(|vertex| open(&backwards, vertex)).collect();
        assert!(first.iter().eq(last.iter().rev()));
    }
}
