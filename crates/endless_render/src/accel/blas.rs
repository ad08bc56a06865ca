//! The bottom level: a tree over the triangles of one mesh, in the mesh's own frame.

use std::sync::Arc;
use std::time::Duration;

use glam::{Vec3, Vec3A};
use obvhs::aabb::Aabb;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::{Boundable, BvhBuildParams};

use super::collapse::{Costs, Tree, collapse};
use super::node::{EMPTY_BOX, Link, Node, half_area, union};
use super::triangle::TriangleGroup;

/// Acceleration structure over one mesh, to be shared by all its instances.
#[derive(Clone, Debug)]
pub struct Blas {
    pub(super) tree: Tree,
    pub(super) groups: Vec<TriangleGroup>,
    /// Vertices of the triangles in the order in which the groups hold them; the same however the mesh deforms.
    corners: Arc<[[u32; 3]]>,
    bounds: (Vec3A, Vec3A),
}

/// What is done with a mesh: how much its tree is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Use {
    /// It stands in the town, and meets nearly every ray.
    Still,
    /// It moves as it is: a good tree, soon made.
    Rigid,
    /// It deforms with every frame: few boxes and full groups, which are soon refitted.
    Deforming,
}

impl Use {
    fn costs(self) -> Costs {
        let group = if self == Self::Deforming { 0.8 } else { 1.5 };
        Costs { group, group_size: TriangleGroup::SIZE as u32, max_leaf: 16 }
    }

    fn params(self, triangles: usize) -> BvhBuildParams {
        let mut params =
            if triangles > LARGE_MESH { BvhBuildParams::fast_build() } else { BvhBuildParams::medium_build() };
        params.max_prims_per_leaf = 1;
        if self != Self::Still {
            // The second round of improvements is twice as dear as the first, and gains little.
            params.post_collapse_reinsertion_batch_ratio_multiplier = 0.0;
        }
        params
    }
}

/// Meshes above this many triangles are built with a quicker preset.
const LARGE_MESH: usize = 2_000_000;

struct Corners([Vec3A; 3]);

impl Boundable for Corners {
    fn aabb(&self) -> Aabb {
        Aabb::from_points(&self.0)
    }
}

impl Blas {
    /// Builds over `triangles`, which index `positions`, what stands still. Positions must be finite; degenerate
    /// triangles are allowed and hit nothing.
    pub fn build(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        Self::build_for(Use::Still, positions, triangles)
    }

    /// The same for another use.
    pub(crate) fn build_for(purpose: Use, positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let corners: Vec<Corners> =
            triangles.iter().map(|t| Corners(t.map(|i| Vec3A::from(positions[i as usize])))).collect();
        let mut groups = Vec::with_capacity(triangles.len() / 3 + 1);
        let tree = if triangles.is_empty() {
            Tree::empty()
        } else {
            let source = build_bvh2(&corners, purpose.params(triangles.len()), &mut Duration::default());
            collapse(&source, purpose.costs(), |things| {
                let start = groups.len();
                groups.extend(things.chunks(TriangleGroup::SIZE).map(TriangleGroup::new));
                Link::leaf(start, groups.len() - start)
            })
        };
        groups.shrink_to_fit();
        let ids = groups.iter().flat_map(|group| &group.ids[..group.len()]);
        let corners = ids.map(|&id| triangles[id as usize]).collect();
        let mut blas = Blas { tree, groups, corners, bounds: EMPTY_BOX };
        blas.refit(positions);
        blas
    }

    /// Takes new positions of the same vertices. Hits are then the same as after a fresh build; speed is that of
    /// the old tree, so rebuild when the shape has changed much.
    pub fn refit(&mut self, positions: &[Vec3]) {
        let mut corners = self.corners.iter();
        let refit = |group: &mut TriangleGroup| {
            let lanes = group.len();
            corners.by_ref().take(lanes).enumerate().fold(EMPTY_BOX, |bounds, (lane, corner)| {
                let [a, b, c] = corner.map(|i| positions[i as usize]);
                group.set_triangle(lane, [a, b, c]);
                let [a, b, c] = [a, b, c].map(Vec3A::from);
                union(bounds, (a.min(b).min(c), a.max(b).max(c)))
            })
        };
        let boxes: Vec<_> = self.groups.iter_mut().map(refit).collect();
        self.bounds = self.tree.fit(|leaf| boxes[leaf.range()].iter().copied().fold(EMPTY_BOX, union));
    }

    /// Box around all triangles, `(min, max)`; `min > max` if there are none.
    pub fn bounds(&self) -> (Vec3A, Vec3A) {
        self.bounds
    }

    /// Boxes that together hold all triangles, about `count` of them: the tree's own, cut where they are largest.
    pub(crate) fn parts(&self, count: usize) -> Vec<(Vec3A, Vec3A)> {
        let mut open = vec![(self.tree.root, self.bounds)];
        open.retain(|(root, _)| *root != Link::EMPTY);
        let mut whole = Vec::new();
        while !open.is_empty() && open.len() + whole.len() < count {
            let area = |i: usize| half_area(open[i].1);
            let largest = (0..open.len()).max_by(|&a, &b| area(a).total_cmp(&area(b))).unwrap_or(0);
            let (link, bounds) = open.swap_remove(largest);
            if link.is_leaf() {
                whole.push(bounds);
                continue;
            }
            open.extend(self.tree.nodes[link.node()].children());
        }
        whole.extend(open.into_iter().map(|(_, bounds)| bounds));
        whole
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.corners.len()
    }

    /// Memory taken, bytes.
    pub fn memory_bytes(&self) -> usize {
        size_of_val(&self.tree.nodes[..]) + size_of_val(&self.groups[..]) + size_of_val(&self.corners[..])
    }

    pub(super) fn nodes(&self) -> &[Node] {
        &self.tree.nodes
    }
}
