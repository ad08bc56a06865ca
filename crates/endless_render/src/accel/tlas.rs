//! The top level: a tree over instances of meshes.

use endless_world::math::UnfusedMatrix;
use std::sync::Arc;
use std::time::Duration;

use glam::{Affine3A, Vec3, Vec3A};
use obvhs::BvhBuildParams;
use obvhs::aabb::Aabb;
use obvhs::bvh2::builder::build_bvh2;

use super::blas::Blas;
use super::collapse::{Bvh, SahCosts, collapse};
use super::node::{BvhNode, EMPTY_BOX, NodeLink, corners, half_area, union};
use super::ray::{Hit, LocalRay, Ray, RayTransform};
use super::triangle::intersect_triangle;

/// Acceleration structure over placed meshes, which rays are traced against.
#[derive(Clone, Debug)]
pub struct Tlas {
    tree: Bvh,
    entries: Vec<TlasEntry>,
    instance_bounds: Vec<(Vec3A, Vec3A)>,
    /// By instance; `None` if the mesh lies in world space as it is.
    object_from_world: Vec<Option<RayTransform>>,
    bounds: (Vec3A, Vec3A),
}

/// An entry of a top-level leaf: an instance, or a part of one.
#[derive(Clone, Debug)]
pub(super) struct TlasEntry {
    /// `None` if the mesh lies in world space as it is.
    pub(super) object_from_world: Option<RayTransform>,
    pub(super) blas: Arc<Blas>,
    /// Where in the mesh's tree to start.
    pub(super) root: NodeLink,
    pub(super) instance: u32,
    /// Box in world space, as in the leaf's slot.
    pub(super) bounds: (Vec3A, Vec3A),
}

const COSTS: SahCosts = SahCosts { group: 1.0, group_size: 1, max_leaf: 1 };

impl Tlas {
    /// Builds over instances, each a mesh and its `world_from_object`. Instances whose place is not finite, and
    /// empty meshes, are never hit.
    pub fn build(instances: Vec<(Arc<Blas>, Affine3A)>) -> Self {
        let instance_bounds: Vec<_> =
            instances.iter().map(|(blas, world_from_object)| world_bounds(blas.bounds(), world_from_object)).collect();
        let object_from_world: Vec<_> =
            instances.iter().map(|(_, world_from_object)| object_from_world(world_from_object)).collect();
        let mut parts = Vec::with_capacity(instances.len());
        let mut boxes = Vec::with_capacity(instances.len());
        for (index, (blas, _)) in instances.into_iter().enumerate() {
            let (min, max) = instance_bounds[index];
            if !(min.is_finite() && max.is_finite()) {
                continue;
            }
            let instance = index as u32;
            let root = blas.tree.root;
            let object_from_world = object_from_world[index];
            if object_from_world.is_none() {
                open_parts(&blas, &mut |root, bounds| {
                    parts.push(TlasEntry { object_from_world, blas: Arc::clone(&blas), root, instance, bounds });
                    boxes.push(bounds);
                });
            } else {
                parts.push(TlasEntry { object_from_world, blas, root, instance, bounds: (min, max) });
                boxes.push((min, max));
            }
        }
        let (mut tree, order) = top_tree(&boxes);
        let entries = order.iter().map(|&part| parts[part as usize].clone()).collect();
        let bounds = tree.fit(|leaf| boxes[order[leaf.start()] as usize]);
        Tlas { tree, entries, instance_bounds, object_from_world, bounds }
    }

    /// Where a ray meets one triangle, as [`Self::closest`] tells it if that is the nearest; `corners` is where the mesh
    /// has it. `None` if the ray passes by, or there is no such instance.
    pub(crate) fn hit_on(&self, ray: &Ray, instance: u32, triangle: u32, corners: [Vec3; 3]) -> Option<Hit> {
        let (min, max) = self.instance_bounds.get(instance as usize)?;
        let world = LocalRay::new(ray.origin, ray.direction);
        let tmin = world.enter(min.to_array(), max.to_array())?;
        let local = self.object_from_world[instance as usize]
            .map_or(world, |to_object| LocalRay::new(to_object.point(ray.origin), to_object.vector(ray.direction)));
        let (t, u, v) = intersect_triangle(&local, corners)?;
        let [a, b, c] = corners;
        let tbox = local.enter(a.min(b).min(c).to_array(), a.max(b).max(c).to_array())?;
        let t = t.max(tbox).max(tmin);
        (t <= ray.tmax).then_some(Hit { t, instance, triangle, u, v })
    }

    /// Box around everything, `(min, max)`; `min > max` if there is nothing.
    pub fn bounds(&self) -> (Vec3A, Vec3A) {
        self.bounds
    }

    /// Box around one instance in world space, `(min, max)`; `min > max` if its mesh is empty.
    ///
    /// # Panics
    /// If there is no such instance.
    pub fn instance_bounds(&self, instance: usize) -> (Vec3A, Vec3A) {
        self.instance_bounds[instance]
    }

    /// Whether there is nothing to hit.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Memory of the top level alone, bytes.
    pub fn memory_bytes(&self) -> usize {
        let instances = size_of_val(&self.instance_bounds[..]) + size_of_val(&self.object_from_world[..]);
        size_of_val(&self.tree.nodes[..]) + size_of_val(&self.entries[..]) + instances
    }

    pub(super) fn nodes(&self) -> &[BvhNode] {
        &self.tree.nodes
    }

    pub(super) fn root(&self) -> NodeLink {
        self.tree.root
    }

    #[inline]
    pub(super) fn entry(&self, leaf: NodeLink) -> &TlasEntry {
        &self.entries[leaf.start()]
    }
}

/// The way of a ray into a mesh's own frame; `None` if that is the world's.
fn object_from_world(world_from_object: &Affine3A) -> Option<RayTransform> {
    (*world_from_object != Affine3A::IDENTITY).then(|| {
        let inverse = world_from_object.inverse_unfused();
        RayTransform { linear: inverse.matrix3, translation: inverse.translation }
    })
}

/// The tree over boxes and the order of its leaves. Few things move every frame, many never do: quality by number. A town's
/// tree has every node inserted anew (Meister and Bittner: Parallel reinsertion for bounding volume hierarchy optimization,
/// EUROGRAPHICS 2018): every ray of every picture passes through it.
fn top_tree(boxes: &[(Vec3A, Vec3A)]) -> (Bvh, Vec<u32>) {
    let mut order = Vec::with_capacity(boxes.len());
    if boxes.is_empty() {
        return (Bvh::empty(), order);
    }
    let boxes: Vec<Aabb> = boxes.iter().map(|&(min, max)| Aabb::new(min, max)).collect();
    let preset = if boxes.len() > 1000 { BvhBuildParams::very_slow_build() } else { BvhBuildParams::very_fast_build() };
    let params = BvhBuildParams { max_prims_per_leaf: 1, ..preset };
    let source = build_bvh2(&boxes, params, &mut Duration::default());
    let one = |_| 1;
    let mut tree = collapse(&source, COSTS, one, |things| {
        order.extend_from_slice(things);
        NodeLink::leaf(order.len() - 1, 1)
    });
    if tree.root.is_leaf() {
        // Even a lone instance is entered through its box.
        let mut node = BvhNode::EMPTY;
        node.links[0] = tree.root;
        tree = Bvh { nodes: vec![node], root: NodeLink::inner(0) };
    }
    (tree, order)
}

/// Meshes that lie in world space span the town and overlap: the top level gets their parts, so that one tree
/// sorts them all (Benthin et al.: Improved two-level BVHs using partial re-braiding, HPG 2017). Their boxes stay
/// as they are in the mesh's tree, which keeps the box tests monotone.
fn open_parts(blas: &Blas, found: &mut impl FnMut(NodeLink, (Vec3A, Vec3A))) {
    /// Parts of at least this share of the mesh's area are opened further.
    const SHARE: f32 = 1.0 / 256.0;
    let root = blas.tree.root;
    if blas.triangle_count() < 1024 {
        return found(root, blas.bounds());
    }
    let limit = half_area(blas.bounds()) * SHARE;
    let mut open = vec![(root, blas.bounds())];
    while let Some((link, bounds)) = open.pop() {
        if link.is_leaf() || half_area(bounds) < limit {
            found(link, bounds);
            continue;
        }
        open.extend(blas.nodes()[link.node()].children());
    }
}

/// Box around a transformed box, padded for the rounding of the ray's way into object space. The identity gives
/// the box itself.
pub(crate) fn world_bounds((min, max): (Vec3A, Vec3A), world_from_object: &Affine3A) -> (Vec3A, Vec3A) {
    const PAD: f32 = 4e-6;
    if min.cmpgt(max).any() {
        return EMPTY_BOX;
    }
    if *world_from_object == Affine3A::IDENTITY {
        return (min, max);
    }
    let corners = corners((min, max)).map(|c| world_from_object.transform_point3a(c));
    let (low, high) = corners.into_iter().fold(EMPTY_BOX, |b, c| union(b, (c, c)));
    let reach = low.abs().max(high.abs()).max_element() + world_from_object.translation.abs().max_element();
    (low - PAD * reach, high + PAD * reach)
}
