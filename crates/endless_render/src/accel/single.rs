//! Traversal by one ray: nearest child first for the closest hit, any order for occlusion.

use super::blas::Blas;
use super::node::{BvhNode, NodeLink, SlabRay};
use super::ray::{Hit, LocalRay, Ray};
use super::stack::{NearestChildren, PendingNode, Stack};
use super::tlas::{Tlas, TlasEntry};
use std::sync::atomic::{AtomicUsize, Ordering};

impl Tlas {
    /// The nearest hit; of several at the same `t` the one with the lowest instance, then triangle.
    pub fn closest(&self, ray: &Ray) -> Option<Hit> {
        self.trace::<false>(ray).found()
    }

    /// Whether anything is hit.
    pub fn occluded(&self, ray: &Ray) -> bool {
        self.trace::<true>(ray).found().is_some()
    }

    #[inline(always)]
    fn trace<const ANY: bool>(&self, ray: &Ray) -> Hit {
        let mut best = Hit::none(ray.tmax);
        let mut stack = Stack::new();
        let world = LocalRay::new(ray.origin, ray.direction);
        let slab_ray = SlabRay::of_ray(&world);
        walk::<ANY>(self.nodes(), self.root(), 0.0, &slab_ray, &mut best, &mut stack, |link, tnear, best, stack| {
            self.entry(link).trace::<ANY>(ray, &world, &slab_ray, tnear, best, stack)
        });
        best
    }
}

impl Blas {
    /// Whether a ray in the mesh's own frame meets it; `hint` is where rays like it met it before, which is tried first.
    pub(crate) fn occluded(&self, ray: &Ray, hint: &AtomicUsize) -> bool {
        let local = LocalRay::new(ray.origin, ray.direction);
        let mut best = Hit::none(ray.tmax);
        let groups = self.groups();
        let meets = |group: &usize, best: &mut Hit| groups[*group].intersect(&local, 0.0, best, 0);
        let hinted = hint.load(Ordering::Relaxed);
        if hinted < groups.len() && meets(&hinted, &mut best) {
            return true;
        }
        let slab_ray = SlabRay::of_ray(&local);
        walk::<true>(self.nodes(), self.tree.root, 0.0, &slab_ray, &mut best, &mut Stack::new(), |link, _, best, _| {
            let met = link.range().find(|group| meets(group, best));
            met.inspect(|&group| hint.store(group, Ordering::Relaxed)).is_some()
        })
    }
}

impl TlasEntry {
    /// Intersects one instance; says whether a hit was taken.
    #[inline(always)]
    pub(super) fn trace<const ANY: bool>(
        &self,
        ray: &Ray,
        world: &LocalRay,
        slab_ray: &SlabRay,
        tnear: f32,
        best: &mut Hit,
        stack: &mut Stack,
    ) -> bool {
        match &self.object_from_world {
            None => self.trace_mesh::<ANY>(world, slab_ray, 0.0, best, stack),
            Some(transform) => {
                let local = LocalRay::new(transform.point(ray.origin), transform.vector(ray.direction));
                let slab_ray = SlabRay::of_ray(&local);
                self.trace_mesh::<ANY>(&local, &slab_ray, tnear, best, stack)
            }
        }
    }

    /// Intersects the instance's part of its mesh, in the frame of the mesh. Hits count as no nearer than `tmin`.
    #[inline(never)]
    pub(super) fn trace_mesh<const ANY: bool>(
        &self,
        ray: &LocalRay,
        slab_ray: &SlabRay,
        tmin: f32,
        best: &mut Hit,
        stack: &mut Stack,
    ) -> bool {
        let groups = self.blas.groups();
        walk::<ANY>(self.blas.nodes(), self.root, 0.0, slab_ray, best, stack, |link, _, best, _| {
            let mut found = false;
            for group in &groups[link.range()] {
                found |= group.intersect(ray, tmin, best, self.instance);
                if ANY && found {
                    return true;
                }
            }
            found
        })
    }
}

/// Visits the leaves that the ray may enter before `best.t`. Says whether a leaf reported a hit; with `ANY` it
/// stops there.
#[inline(always)]
fn walk<const ANY: bool>(
    nodes: &[BvhNode],
    root: NodeLink,
    tnear: f32,
    slab_ray: &SlabRay,
    best: &mut Hit,
    stack: &mut Stack,
    mut leaf: impl FnMut(NodeLink, f32, &mut Hit, &mut Stack) -> bool,
) -> bool {
    if root == NodeLink::EMPTY {
        return false;
    }
    let base = stack.len();
    let mut found = false;
    let mut next = Some((root, tnear));
    while let Some((mut link, mut tnear)) = next {
        if tnear <= best.t {
            loop {
                if link.is_leaf() {
                    if leaf(link, tnear, best, stack) {
                        found = true;
                        if ANY {
                            stack.truncate(base);
                            return true;
                        }
                    }
                    break;
                }
                // Only rays that are not finite enter empty slots.
                let Some(node) = nodes.get(link.node()) else { break };
                let (mut hits, tnears) = node.enter(slab_ray, best.t);
                if hits == 0 {
                    break;
                }
                let tnears = tnears.as_array();
                let mut take = || {
                    let slot = hits.trailing_zeros() as usize & 7;
                    hits &= hits - 1;
                    (PendingNode::new(node.links[slot], tnears[slot]), hits)
                };
                let (mut nearest, mut rest) = take();
                if rest != 0 {
                    let (second, left) = take();
                    let mut two = if ANY {
                        NearestChildren { first: nearest, second }
                    } else {
                        NearestChildren::of(nearest, second)
                    };
                    rest = left;
                    while rest != 0 {
                        let (other, left) = take();
                        stack.push(if ANY { other } else { two.keep(other) });
                        rest = left;
                    }
                    stack.push(two.second);
                    nearest = two.first;
                }
                (link, tnear) = nearest.parts();
            }
        }
        next = stack.pop(base).map(PendingNode::parts);
    }
    found
}
