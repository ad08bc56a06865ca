//! N times eight rays prepared for box and triangle tests in one frame of reference.

use crate::vec3x8::splat;
use wide::{f32x4, f32x8};

use super::node::{Slab, SlabRay};
use super::packet_traversal::PacketTraversal;
use super::ray::{FAR_PAD, Hit, MAX_INVERSE, RayTransform, permutation};
use super::stream::{RayStream, RowMask, lane_mask, lanes};
use super::triangle::TriangleGroup;

/// N times eight rays whose directions agree in signs and main axis.
pub(super) struct PacketRay<const N: usize> {
    origin: [[f32x8; N]; 3],
    direction: [[f32x8; N]; 3],
    inverse: [[f32x8; N]; 3],
    /// The same for where boxes are left.
    inverse_far: [[f32x8; N]; 3],
    pub(super) negative: [usize; 3],
    axes: [usize; 3],
    /// As `Shear`, by lane.
    shear: [[f32x8; N]; 3],
    /// The interval of all rays.
    pub(super) slab_ray: SlabRay,
}

impl<const N: usize> PacketRay<N> {
    /// `None` if directions do not agree. Lanes that are not active follow one that is.
    #[inline(always)]
    pub(super) fn in_world(rays: &RayStream<N>, active: u32) -> Option<Self> {
        if active == u32::MAX >> (32 - 8 * N) {
            return Self::new(rays.origin, rays.direction);
        }
        let first = active.trailing_zeros() as usize % (8 * N);
        let mask: [f32x8; N] = std::array::from_fn(|row| lane_mask(active >> (8 * row)));
        let follow = |v: &[[f32x8; N]; 3]| {
            v.map(|axis| {
                let followed = f32x8::splat(axis[first / 8].as_array()[first % 8]);
                std::array::from_fn(|row| mask[row].select(axis[row], followed))
            })
        };
        Self::new(follow(&rays.origin), follow(&rays.direction))
    }

    /// The same rays in the frame of an instance; `None` if directions do not agree there.
    #[inline(always)]
    pub(super) fn transformed(&self, transform: &RayTransform) -> Option<Self> {
        let m = &transform.linear;
        let (cx, cy, cz, shift) = (splat(m.x_axis), splat(m.y_axis), splat(m.z_axis), splat(transform.translation));
        let vector =
            |v: &[[f32x8; N]; 3], k: usize, row: usize| (cx[k] * v[0][row] + cy[k] * v[1][row]) + cz[k] * v[2][row];
        let direction = std::array::from_fn(|k| std::array::from_fn(|row| vector(&self.direction, k, row)));
        let origin = std::array::from_fn(|k| std::array::from_fn(|row| vector(&self.origin, k, row) + shift[k]));
        Self::new(origin, direction)
    }

    #[inline(always)]
    fn new(origin: [[f32x8; N]; 3], direction: [[f32x8; N]; 3]) -> Option<Self> {
        let (mut x_main, mut y_main) = (0, 0);
        for row in 0..N {
            let [x, y] = main_axis8(&direction.map(|axis| axis[row]));
            x_main += x.count_ones();
            y_main += y.count_ones();
        }
        let all = 8 * N as u32;
        let axes = permutation(match (x_main, y_main) {
            (x, _) if x == all => 0,
            (0, y) if y == all => 1,
            (0, 0) => 2,
            _ => return None,
        });
        let inverse = direction.map(|d| d.map(inverse));
        let mut negative = [0; 3];
        for k in 0..3 {
            let below = |i: &f32x8| i.simd_lt(f32x8::ZERO).to_bitmask().count_ones();
            negative[k] = match inverse[k].iter().map(below).sum::<u32>() {
                0 => 0,
                n if n == all => 1,
                _ => return None,
            };
        }
        let z = inverse[axes[2]];
        let times_z = |d: &[f32x8; N]| std::array::from_fn(|row| d[row] * z[row]);
        let shear = [times_z(&direction[axes[0]]), times_z(&direction[axes[1]]), z];
        let slab_ray = slab_ray(&origin, &inverse, negative);
        let inverse_far = inverse.map(|axis| axis.map(|i| i * f32x8::splat(FAR_PAD)));
        Some(PacketRay { origin, direction, inverse, inverse_far, negative, axes, shear, slab_ray })
    }

    /// `LocalRay::enter` by lane: which live lanes of some rows enter a box before their best hit, and where.
    #[inline(always)]
    pub(super) fn enter(&self, slab: &Slab, rows: RowMask, trip: &PacketTraversal<N>) -> (u32, [f32x8; N]) {
        let mut entered = 0;
        let mut tnears = [f32x8::ZERO; N];
        for row in rows.each::<N>() {
            let (tnear, tfar) = self.slabs(slab, row);
            entered |= tnear.simd_le(tfar.fast_min(trip.ends[row])).to_bitmask() << (8 * row);
            tnears[row] = tnear;
        }
        (entered & trip.live, tnears)
    }

    /// Those of some rows that have a live lane which enters a box before its best hit.
    #[inline(always)]
    pub(super) fn enters(&self, slab: &Slab, rows: RowMask, trip: &PacketTraversal<N>) -> RowMask {
        let mut entered = RowMask::NONE;
        for row in rows.each::<N>() {
            let (tnear, tfar) = self.slabs(slab, row);
            let lanes = tnear.simd_le(tfar.fast_min(trip.ends[row])).to_bitmask();
            entered.add(row, lanes & trip.live >> (8 * row));
        }
        entered
    }

    #[inline(always)]
    fn slabs(&self, slab: &Slab, row: usize) -> (f32x8, f32x8) {
        let (mut near, mut far) = (f32x8::ZERO, f32x8::splat(f32::INFINITY));
        for k in 0..3 {
            near = near.fast_max((f32x8::splat(slab.first[k]) - self.origin[k][row]) * self.inverse[k][row]);
            far = far.fast_min((f32x8::splat(slab.last[k]) - self.origin[k][row]) * self.inverse_far[k][row]);
        }
        (near, far)
    }

    /// `TriangleGroup::intersect` for the live lanes of some rows; with `ANY` lanes that hit are no longer live.
    #[inline(always)]
    pub(super) fn intersect<const ANY: bool>(
        &self,
        group: &TriangleGroup,
        rows: RowMask,
        tmin: Option<&[f32x8; N]>,
        trip: &mut PacketTraversal<N>,
        instance: u32,
    ) {
        let mut found = 0;
        let [x, y, z] = self.axes;
        let axes = [x.min(2), y.min(2), z.min(2)];
        for lane in 0..TriangleGroup::SIZE {
            let triangle = group.ids[lane];
            if triangle == u32::MAX {
                break;
            }
            let mut vertices = [[f32x8::ZERO; 3]; 3];
            for (vertex, planes) in vertices.iter_mut().zip(&group.vertices) {
                for (along, axis) in vertex.iter_mut().zip(axes) {
                    *along = f32x8::splat(planes[axis].as_array()[lane]);
                }
            }
            let mut hit = 0;
            for row in rows.each::<N>() {
                hit |= self.intersect_row(&PacketTriangle { group, lane, vertices, instance }, row, tmin, trip)
                    << (8 * row);
            }
            found |= hit;
            if ANY {
                trip.live &= !hit;
            }
        }
        if found != 0 {
            trip.update_reach();
        }
    }

    /// One triangle and one row of rays: which of them hit it, a bit each.
    #[inline(always)]
    fn intersect_row(
        &self,
        triangle: &PacketTriangle<'_>,
        row: usize,
        tmin: Option<&[f32x8; N]>,
        trip: &mut PacketTraversal<N>,
    ) -> u32 {
        let PacketTriangle { group, lane, ref vertices, instance } = *triangle;
        let [x, y, z] = self.axes;
        let (sx, sy, sz) = (self.shear[0][row], self.shear[1][row], self.shear[2][row]);
        let (ox, oy, oz) = (self.origin[x][row], self.origin[y][row], self.origin[z][row]);
        let corner = |[vx, vy, vz]: &[f32x8; 3]| {
            let cz = *vz - oz;
            [(*vx - ox) - sx * cz, (*vy - oy) - sy * cz, cz]
        };
        let [a, b, c] = vertices.each_ref().map(corner);
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let low = u.fast_min(v).fast_min(w);
        let high = u.fast_max(v).fast_max(w);
        let live = trip.live >> (8 * row);
        let inside = (low.simd_ge(f32x8::ZERO) | high.simd_le(f32x8::ZERO)).to_bitmask() & live;
        if inside == 0 {
            return 0;
        }
        let det = (u + v) + w;
        let t = ((u * a[2] + v * b[2]) + w * c[2]) * sz / det;
        let ends = trip.ends[row];
        let valid = (t.simd_gt(f32x8::ZERO) & t.simd_lt(f32x8::splat(f32::INFINITY)) & t.simd_le(ends)).to_bitmask();
        if inside & valid == 0 {
            return 0;
        }
        let (min, max) = group.bounds(lane);
        let (tnear, tfar) = self.slabs(&Slab::of(min, max, self.negative), row);
        let candidates = inside & valid & tnear.simd_le(tfar).to_bitmask();
        let (ts, us, vs) = (t.fast_max(tnear).to_array(), (v / det).to_array(), (w / det).to_array());
        let mut found = 0;
        for ray in lanes(candidates) {
            let t = tmin.map_or(ts[ray % 8], |tmin| ts[ray % 8].max(tmin[row].as_array()[ray % 8]));
            let hit = Hit { t, instance, triangle: group.ids[lane], u: us[ray % 8], v: vs[ray % 8] };
            if hit.precedes(trip.best(8 * row + ray)) {
                trip.improve(8 * row + ray, hit);
                found |= 1 << ray;
            }
        }
        found
    }
}

/// A triangle as a packet meets it.
struct PacketTriangle<'a> {
    group: &'a TriangleGroup,
    /// Its place in the group.
    lane: usize,
    /// Along the rays' own axes.
    vertices: [[f32x8; 3]; 3],
    instance: u32,
}

/// Which of eight directions have x for their main axis, and which of them have more of y than of z, a bit each.
#[inline(always)]
pub(super) fn main_axis8(direction: &[f32x8; 3]) -> [u32; 2] {
    let [x, y, z] = direction.map(f32x8::abs);
    [(x.simd_ge(y) & x.simd_ge(z)).to_bitmask(), y.simd_ge(z).to_bitmask()]
}

/// `ray::inverse` by lane.
#[inline(always)]
fn inverse(d: f32x8) -> f32x8 {
    let largest = (d & f32x8::splat(-0.0)) | f32x8::splat(MAX_INVERSE);
    d.abs().simd_lt(f32x8::splat(1.0 / MAX_INVERSE)).select(largest, f32x8::ONE / d)
}

/// The interval of all rays: it enters a box no later than any of them, and leaves it no sooner.
#[inline(always)]
fn slab_ray<const N: usize>(origin: &[[f32x8; N]; 3], inverse: &[[f32x8; N]; 3], negative: [usize; 3]) -> SlabRay {
    let zero = [f32x8::ZERO; 3];
    let mut slab_ray = SlabRay { negative, origin_near: zero, origin_far: zero, inverse_near: zero, inverse_far: zero };
    for k in 0..3 {
        let (low, high) = range(&origin[k]);
        let (least, most) = range(&inverse[k]);
        let flip = |(a, b): (f32, f32)| if negative[k] == 0 { (a, b) } else { (b, a) };
        let (far, near) = flip((low, high));
        let (slow, fast) = flip((least, most));
        slab_ray.origin_near[k] = f32x8::splat(near);
        slab_ray.origin_far[k] = f32x8::splat(far);
        slab_ray.inverse_near[k] = f32x8::splat(slow);
        slab_ray.inverse_far[k] = f32x8::splat(fast * FAR_PAD);
    }
    slab_ray
}

/// Least and greatest lane.
#[inline(always)]
fn range<const N: usize>(rows: &[f32x8; N]) -> (f32, f32) {
    let (mut least, mut most) = (rows[0], rows[0]);
    for row in &rows[1..] {
        (least, most) = (least.fast_min(*row), most.fast_max(*row));
    }
    let halves = |v: f32x8| {
        let [a, b, c, d, e, f, g, h] = v.to_array();
        (f32x4::new([a, b, c, d]), f32x4::new([e, f, g, h]))
    };
    let ((a, b), (c, d)) = (halves(least), halves(most));
    let (low, high) = (a.fast_min(b).to_array(), c.fast_max(d).to_array());
    (low[0].min(low[1]).min(low[2].min(low[3])), high[0].max(high[1]).max(high[2].max(high[3])))
}
