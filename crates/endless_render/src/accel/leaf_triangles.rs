//! The triangles of a mesh, as its leaves hold them. Those of what deforms are moved when a ray first comes near: most
//! of a crowd is out of sight, and its triangles are many times the memory of its vertices.

use std::ops::Range;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};
use std::{iter, mem};

use glam::{Vec3, Vec3A};

use super::node::{EMPTY_BOX, union};
use super::triangle::TriangleGroup;

/// The groups of all leaves, one leaf after the other.
#[derive(Debug)]
pub(super) struct LeafTriangles {
    /// Their positions; empty until they are first needed after the mesh has moved.
    placed: OnceLock<Vec<TriangleGroup>>,
    soft: Option<DeformingGroups>,
    count: usize,
}

/// The groups of a deforming mesh.
#[derive(Debug)]
struct DeformingGroups {
    /// Vertices of the triangles in the order in which the groups hold them.
    triangles: Arc<[[u32; 3]]>,
    leaves: Arc<[GroupLeaf]>,
    /// Vertices of all leaves, each once a leaf, in fours; the last repeats until a four is full.
    vertices: Arc<[[u32; 4]]>,
    /// `None` while they change.
    positions: Option<Arc<[Vec3]>>,
    /// The groups of an earlier shape: their memory is used again.
    spare: Mutex<Vec<TriangleGroup>>,
}

#[derive(Debug, Clone)]
struct GroupLeaf {
    first_group: usize,
    vertices: Range<usize>,
}

impl LeafTriangles {
    /// Of a mesh that keeps its shape.
    pub(super) fn rigid(groups: Vec<TriangleGroup>) -> Self {
        Self { count: groups.len(), placed: groups.into(), soft: None }
    }

    /// Of one that deforms; `first_groups` says with which group each leaf begins.
    pub(super) fn soft(
        groups: Vec<TriangleGroup>,
        first_groups: &[usize],
        triangles: &[[u32; 3]],
        positions: &[Vec3],
    ) -> Self {
        let of = |group: &TriangleGroup| group.ids.map(|id| triangles.get(id as usize).copied());
        let (mut leaves, mut vertices) = (Vec::with_capacity(first_groups.len()), Vec::new());
        let ends = first_groups.iter().skip(1).copied().chain(iter::once(groups.len()));
        for (&first_group, end) in first_groups.iter().zip(ends) {
            let mut own: Vec<u32> = groups[first_group..end].iter().flat_map(of).flatten().flatten().collect();
            own.sort_unstable();
            own.dedup();
            let first = vertices.len();
            vertices.extend(own.chunks(4).map(|c| std::array::from_fn(|k| c[k.min(c.len() - 1)])));
            leaves.push(GroupLeaf { first_group, vertices: first..vertices.len() });
        }
        let soft = DeformingGroups {
            triangles: groups.iter().flat_map(of).flatten().collect(),
            leaves: leaves.into(),
            vertices: vertices.into(),
            positions: Some(positions.into()),
            spare: Mutex::default(),
        };
        Self { soft: Some(soft), ..Self::rigid(groups) }
    }

    /// Where they are.
    #[inline]
    pub(super) fn placed(&self) -> &[TriangleGroup] {
        match self.placed.get() {
            Some(groups) => groups,
            None => self.place(),
        }
    }

    #[cold]
    fn place(&self) -> &[TriangleGroup] {
        self.placed.get_or_init(|| {
            let Some(DeformingGroups { triangles, positions: Some(positions), spare, .. }) = &self.soft else {
                return vec![];
            };
            let mut groups = mem::take(&mut *spare.lock().unwrap_or_else(PoisonError::into_inner));
            let mut triangles = triangles.iter();
            for group in &mut groups {
                group.place(&mut triangles, positions);
            }
            groups
        })
    }

    /// Lets go of the positions, which are about to change.
    pub(super) fn release(&mut self) {
        let Some(soft) = &mut self.soft else { return };
        soft.positions = None;
        if let Some(groups) = self.placed.take() {
            *soft.spare.get_mut().unwrap_or_else(PoisonError::into_inner) = groups;
        }
    }

    /// Takes new positions, and returns the boxes of leaves by their first group.
    ///
    /// # Panics
    /// If the mesh keeps its shape.
    pub(super) fn move_to(&mut self, positions: Arc<[Vec3]>) -> Vec<(Vec3A, Vec3A)> {
        self.release();
        let soft = self.soft.as_mut().expect("only what is built to deform moves");
        let mut boxes = vec![EMPTY_BOX; self.count];
        for leaf in &*soft.leaves {
            let at = |v: u32| Vec3A::from(positions[v as usize]);
            let mut bounds = EMPTY_BOX;
            for &[a, b, c, d] in &soft.vertices[leaf.vertices.clone()] {
                let (a, b, c, d) = (at(a), at(b), at(c), at(d));
                bounds = union(bounds, (a.min(b).min(c.min(d)), a.max(b).max(c.max(d))));
            }
            boxes[leaf.first_group] = bounds;
        }
        soft.positions = Some(positions);
        boxes
    }

    /// Memory taken, bytes.
    pub(super) fn memory_bytes(&self) -> usize {
        let soft =
            |s: &DeformingGroups| size_of_val(&*s.triangles) + size_of_val(&*s.leaves) + size_of_val(&*s.vertices);
        self.count * size_of::<TriangleGroup>() + self.soft.as_ref().map_or(0, soft)
    }
}

impl Clone for LeafTriangles {
    fn clone(&self) -> Self {
        Self { placed: self.placed.clone(), soft: self.soft.clone(), count: self.count }
    }
}

impl Clone for DeformingGroups {
    fn clone(&self) -> Self {
        let spare = self.spare.lock().unwrap_or_else(PoisonError::into_inner).clone();
        Self {
            triangles: Arc::clone(&self.triangles),
            leaves: Arc::clone(&self.leaves),
            vertices: Arc::clone(&self.vertices),
            positions: self.positions.clone(),
            spare: Mutex::new(spare),
        }
    }
}
