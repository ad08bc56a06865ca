//! The eight-wide node: boxes of up to eight children, side by side.

use glam::Vec3A;
use wide::f32x8;

use super::ray::{FAR_PAD, LocalRay};

/// What a child slot points to, in 32 bits: nothing, an inner node, or a range of primitives in a leaf.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct NodeLink(pub(super) u32);

impl NodeLink {
    pub(super) const EMPTY: NodeLink = NodeLink(0x7fff_ffff);
    const LEAF: u32 = 0x8000_0000;
    const COUNT_SHIFT: u32 = 27;
    const START_MASK: u32 = (1 << Self::COUNT_SHIFT) - 1;
    /// Most primitives in one leaf.
    pub(super) const MAX_COUNT: usize = 15;

    pub(super) fn inner(node: usize) -> Self {
        assert!(node < Self::EMPTY.0 as usize, "too many nodes for one tree");
        NodeLink(node as u32)
    }

    pub(super) fn leaf(start: usize, count: usize) -> Self {
        assert!(start <= Self::START_MASK as usize && count <= Self::MAX_COUNT, "leaf out of range");
        NodeLink(Self::LEAF | (count as u32) << Self::COUNT_SHIFT | start as u32)
    }

    #[inline]
    pub(super) fn is_leaf(self) -> bool {
        self.0 & Self::LEAF != 0
    }

    /// Node index of an inner link.
    #[inline]
    pub(super) fn node(self) -> usize {
        self.0 as usize
    }

    /// First primitive of a leaf.
    #[inline]
    pub(super) fn start(self) -> usize {
        (self.0 & Self::START_MASK) as usize
    }

    /// The range of primitives of a leaf.
    #[inline]
    pub(super) fn range(self) -> std::ops::Range<usize> {
        self.start()..self.start() + (self.0 >> Self::COUNT_SHIFT & 15) as usize
    }
}

/// Eight child boxes as planes `[low, high][axis]`; an empty slot has its low above its high.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct BvhNode {
    pub(super) planes: [[f32x8; 3]; 2],
    pub(super) links: [NodeLink; 8],
}

impl BvhNode {
    pub(super) const EMPTY: BvhNode = BvhNode {
        planes: [[f32x8::new([f32::INFINITY; 8]); 3], [f32x8::new([f32::NEG_INFINITY; 8]); 3]],
        links: [NodeLink::EMPTY; 8],
    };

    /// Takes the boxes of all children; empty slots have empty ones.
    pub(super) fn set_boxes(&mut self, boxes: &[(Vec3A, Vec3A); 8]) {
        let mut rows = [f32x8::ZERO; 8];
        for (row, (low, high)) in rows.iter_mut().zip(boxes) {
            *row = f32x8::new([low.x, low.y, low.z, 0.0, high.x, high.y, high.z, 0.0]);
        }
        let [lx, ly, lz, _, hx, hy, hz, _] = f32x8::transpose(rows);
        self.planes = [[lx, ly, lz], [hx, hy, hz]];
    }

    /// Box of one child.
    pub(super) fn child_box(&self, slot: usize) -> (Vec3A, Vec3A) {
        let corner = |side: usize| {
            Vec3A::new(
                self.planes[side][0].as_array()[slot],
                self.planes[side][1].as_array()[slot],
                self.planes[side][2].as_array()[slot],
            )
        };
        (corner(0), corner(1))
    }

    /// The planes of all children that rays of these signs meet first along each axis, and those that they meet last.
    #[inline(always)]
    pub(super) fn facing(&self, negative: [usize; 3]) -> [[&[f32; 8]; 3]; 2] {
        let [x, y, z] = negative.map(|n| n & 1);
        let side = |x: usize, y: usize, z: usize| {
            [self.planes[x][0].as_array(), self.planes[y][1].as_array(), self.planes[z][2].as_array()]
        };
        [side(x, y, z), side(1 - x, 1 - y, 1 - z)]
    }

    /// The children there are, and their boxes.
    pub(super) fn children(&self) -> impl Iterator<Item = (NodeLink, (Vec3A, Vec3A))> {
        (0..8).filter(|&slot| self.links[slot] != NodeLink::EMPTY).map(|slot| (self.links[slot], self.child_box(slot)))
    }

    /// Which children a ray (or every ray that a `SlabRay` stands for) may enter before `tmax`, and where.
    #[inline(always)]
    pub(super) fn enter(&self, slab_ray: &SlabRay, tmax: f32) -> (u32, f32x8) {
        let near =
            |k: usize| (self.planes[slab_ray.negative[k] & 1][k] - slab_ray.origin_near[k]) * slab_ray.inverse_near[k];
        let far = |k: usize| {
            (self.planes[1 - (slab_ray.negative[k] & 1)][k] - slab_ray.origin_far[k]) * slab_ray.inverse_far[k]
        };
        let tnear = near(0).fast_max(near(1)).fast_max(near(2).fast_max(f32x8::ZERO));
        let tfar = far(0).fast_min(far(1)).fast_min(far(2).fast_min(f32x8::splat(tmax)));
        (tnear.simd_le(tfar).to_bitmask(), tnear)
    }
}

/// A box by the planes that a ray meets first and last along each axis.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slab {
    pub(super) first: [f32; 3],
    pub(super) last: [f32; 3],
}

impl Slab {
    /// Of one child, by the planes of all.
    #[inline(always)]
    pub(super) fn of_child([first, last]: [[&[f32; 8]; 3]; 2], slot: usize) -> Self {
        let slot = slot & 7;
        Slab {
            first: [first[0][slot], first[1][slot], first[2][slot]],
            last: [last[0][slot], last[1][slot], last[2][slot]],
        }
    }

    /// Of a box; `negative` as in `LocalRay`.
    #[inline(always)]
    pub(super) fn of(min: [f32; 3], max: [f32; 3], negative: [usize; 3]) -> Self {
        let sides = [min, max];
        let mut slab = Slab { first: [0.0; 3], last: [0.0; 3] };
        for k in 0..3 {
            slab.first[k] = sides[negative[k] & 1][k];
            slab.last[k] = sides[1 - (negative[k] & 1)][k];
        }
        slab
    }
}

/// The slab test's operands: of one ray, or of the interval of several rays whose signs agree.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlabRay {
    pub(super) negative: [usize; 3],
    pub(super) origin_near: [f32x8; 3],
    pub(super) origin_far: [f32x8; 3],
    pub(super) inverse_near: [f32x8; 3],
    pub(super) inverse_far: [f32x8; 3],
}

impl SlabRay {
    #[inline(always)]
    pub(super) fn of_ray(ray: &LocalRay) -> Self {
        let origin = ray.origin.map(f32x8::splat);
        SlabRay {
            negative: ray.negative,
            origin_near: origin,
            origin_far: origin,
            inverse_near: ray.inverse.map(f32x8::splat),
            inverse_far: ray.inverse.map(|i| f32x8::splat(i * FAR_PAD)),
        }
    }
}

/// The box around nothing.
pub(super) const EMPTY_BOX: (Vec3A, Vec3A) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);

/// Box around two boxes.
pub(super) fn union(a: (Vec3A, Vec3A), b: (Vec3A, Vec3A)) -> (Vec3A, Vec3A) {
    (a.0.min(b.0), a.1.max(b.1))
}

/// Half of a box's surface.
pub(super) fn half_area((min, max): (Vec3A, Vec3A)) -> f32 {
    let d = max - min;
    d.x * d.y + d.y * d.z + d.z * d.x
}

/// The eight corners of a box; bit k of the index picks the upper side along axis k.
pub(crate) fn corners((min, max): (Vec3A, Vec3A)) -> [Vec3A; 8] {
    std::array::from_fn(|i| {
        let pick = |axis: usize| if i >> axis & 1 == 0 { min[axis] } else { max[axis] };
        Vec3A::new(pick(0), pick(1), pick(2))
    })
}
