//! The bottom level: a tree over the triangles of one mesh, in the mesh's own frame.

use std::sync::Arc;
use std::time::Duration;

use glam::{Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::builder::build_bvh2;
use obvhs::ploc::PlocSearchDistance;

use super::collapse::{Bvh, SahCosts, collapse};
use super::leaf_triangles::LeafTriangles;
use super::node::{BvhNode, EMPTY_BOX, NodeLink, half_area, union};
use super::triangle::TriangleGroup;

/// Acceleration structure over one mesh, to be shared by all its instances.
#[derive(Clone, Debug)]
pub struct Blas {
    pub(super) tree: Bvh,
    groups: LeafTriangles,
    triangles: usize,
    bounds: (Vec3A, Vec3A),
}

/// What is done with a mesh: how much its tree is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GeometryUse {
    /// It stands in the town, and meets nearly every ray.
    Still,
    /// It moves as it is: a good tree, soon made.
    Rigid,
    /// It deforms with every frame: few boxes and full groups, which are soon refitted.
    Deforming,
}

impl GeometryUse {
    fn costs(self) -> SahCosts {
        let group = if self == Self::Deforming { 0.8 } else { 1.5 };
        SahCosts { group, group_size: TriangleGroup::SIZE as u32, max_leaf: 16 }
    }

    fn params(self, triangles: usize) -> BvhBuildParams {
        let search = if self == Self::Still { PlocSearchDistance::Low } else { PlocSearchDistance::VeryLow };
        let usual = BvhBuildParams {
            // To search wide only after the first pass, and improve once, costs a third less than the preset, and the
            // trees are as good.
            ploc_search_distance: search,
            search_depth_threshold: 1,
            post_collapse_reinsertion_batch_ratio_multiplier: 0.0,
            ..BvhBuildParams::medium_build()
        };
        let params = if triangles > LARGE_MESH { BvhBuildParams::fast_build() } else { usual };
        BvhBuildParams { max_prims_per_leaf: 1, ..params }
    }
}

/// Meshes above this many triangles are built with a quicker preset.
const LARGE_MESH: usize = 2_000_000;

/// What the tree is built over: single triangles, and pairs of neighbours in the list that lie in about one box, as the
/// halves of most quadrilaterals do. Piece `i` holds the triangles from `starts[i]` to before `starts[i + 1]`. A tree over
/// half as many boxes takes half the time, and its groups are fuller.
fn pieces(positions: &[Vec3], triangles: &[[u32; 3]]) -> (Vec<u32>, Vec<Aabb>) {
    /// Surface of a pair's box, of that of the boxes of both.
    const MOST: f32 = 0.75;
    let box_of = |t: &[u32; 3]| Aabb::from_points(&t.map(|i| Vec3A::from(positions[i as usize])));
    let (mut starts, mut boxes) = (Vec::with_capacity(triangles.len() + 1), Vec::with_capacity(triangles.len()));
    let mut alone: Option<Aabb> = None;
    for (i, triangle) in (0..).zip(triangles) {
        let own = box_of(triangle);
        if let Some(before) = alone {
            let both = before.union(&own);
            if both.half_area() <= MOST * (before.half_area() + own.half_area()) {
                boxes.push(both);
                alone = None;
                continue;
            }
            boxes.push(before);
        }
        starts.push(i);
        alone = Some(own);
    }
    boxes.extend(alone);
    starts.push(triangles.len() as u32);
    (starts, boxes)
}

impl Blas {
    /// Builds over `triangles`, which index `positions`, what stands still. Positions must be finite; degenerate
    /// triangles are allowed and hit nothing.
    pub fn build(positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        Self::build_for(GeometryUse::Still, positions, triangles)
    }

    /// The same for another use.
    pub(crate) fn build_for(purpose: GeometryUse, positions: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let (pieces, boxes) = pieces(positions, triangles);
        let ids = |piece: u32| pieces[piece as usize]..pieces[piece as usize + 1];
        let mut groups = Vec::with_capacity(triangles.len() / 3 + 1);
        let mut first_groups = Vec::new();
        let mut tree = if triangles.is_empty() {
            Bvh::empty()
        } else {
            let source = build_bvh2(&boxes, purpose.params(triangles.len()), &mut Duration::default());
            let mut own = Vec::new();
            collapse(
                &source,
                purpose.costs(),
                |piece| ids(piece).len() as u32,
                |pieces| {
                    let start = groups.len();
                    first_groups.push(start);
                    own.clear();
                    own.extend(pieces.iter().flat_map(|&piece| ids(piece)));
                    groups.extend(own.chunks(TriangleGroup::SIZE).map(TriangleGroup::new));
                    NodeLink::leaf(start, groups.len() - start)
                },
            )
        };
        groups.shrink_to_fit();
        let place = |group: &mut TriangleGroup| {
            let ids = group.ids;
            group.place(&mut ids.iter().map(|&id| &triangles[id as usize]), positions)
        };
        let boxes: Vec<_> = groups.iter_mut().map(place).collect();
        let bounds = tree.fit(|leaf| boxes[leaf.range()].iter().copied().fold(EMPTY_BOX, union));
        let groups = match purpose {
            GeometryUse::Deforming => LeafTriangles::soft(groups, &first_groups, triangles, positions),
            GeometryUse::Still | GeometryUse::Rigid => LeafTriangles::rigid(groups),
        };
        Blas { tree, groups, triangles: triangles.len(), bounds }
    }

    /// Lets go of the positions of what deforms, so that they can be changed where they are.
    pub(crate) fn release(&mut self) {
        self.groups.release();
    }

    /// Takes new positions of the same vertices. Hits are then the same as after a fresh build; speed is that of
    /// the old tree, so rebuild when the shape has changed much.
    ///
    /// # Panics
    /// If it was not built to deform.
    pub(crate) fn refit(&mut self, positions: Arc<[Vec3]>) {
        let boxes = self.groups.move_to(positions);
        self.bounds = self.tree.fit(|leaf| boxes[leaf.start()]);
    }

    /// Box around all triangles, `(min, max)`; `min > max` if there are none.
    pub fn bounds(&self) -> (Vec3A, Vec3A) {
        self.bounds
    }

    /// Boxes that together hold all triangles, about `count` of them: the tree's own, cut where they are largest.
    pub(crate) fn parts(&self, count: usize) -> Vec<(Vec3A, Vec3A)> {
        let with_area = |(link, bounds): (NodeLink, (Vec3A, Vec3A))| (link, bounds, half_area(bounds));
        let mut open = vec![with_area((self.tree.root, self.bounds))];
        open.retain(|(root, ..)| *root != NodeLink::EMPTY);
        let mut whole = Vec::new();
        while !open.is_empty() && open.len() + whole.len() < count {
            let largest = (0..open.len()).max_by(|&a, &b| open[a].2.total_cmp(&open[b].2)).unwrap_or(0);
            let (link, bounds, _) = open.swap_remove(largest);
            if link.is_leaf() {
                whole.push(bounds);
                continue;
            }
            open.extend(self.tree.nodes[link.node()].children().map(with_area));
        }
        whole.extend(open.into_iter().map(|(_, bounds, _)| bounds));
        whole
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.triangles
    }

    /// Memory taken, bytes.
    pub fn memory_bytes(&self) -> usize {
        size_of_val(&self.tree.nodes[..]) + self.groups.memory_bytes()
    }

    /// The triangles that leaves point to.
    #[inline]
    pub(super) fn groups(&self) -> &[TriangleGroup] {
        self.groups.placed()
    }

    pub(super) fn nodes(&self) -> &[BvhNode] {
        &self.tree.nodes
    }
}
