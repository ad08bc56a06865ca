//! The watertight ray/triangle test of Woop, Benthin and Wald (JCGT 2013), for four triangles at a time.
//!
//! Vertices are moved into a frame where the ray is the z axis; three 2D edge functions decide. Rounded products
//! compare in the order of the exact ones, so an edge function never has the wrong sign, at worst it is zero, and
//! zero counts as inside: two triangles that share an edge cannot both miss a ray. For that the code below must not
//! use fused multiply-add.
//!
//! A hit also needs the ray to enter the triangle's own box, and counts as no nearer than that box: this makes the
//! result independent of the boxes around it (see `LocalRay::enter`).

use glam::{Vec3, Vec3A};
use wide::f32x4;

use super::node::{EMPTY_BOX, union};
use super::ray::{Hit, LocalRay, Shear};

/// Four triangles: `vertices[corner][axis]`, lanes are triangles. Unused lanes are NaN, which hits nothing.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(32))]
pub(super) struct TriangleGroup {
    pub(super) vertices: [[f32x4; 3]; 3],
    /// Indices in the mesh; `u32::MAX` in unused lanes, which are last.
    pub(super) ids: [u32; 4],
}

impl TriangleGroup {
    pub(super) const SIZE: usize = 4;

    /// A group of up to four triangles by index, still without vertices.
    pub(super) fn new(ids: &[u32]) -> Self {
        let mut group =
            TriangleGroup { vertices: [[f32x4::splat(f32::NAN); 3]; 3], ids: [u32::MAX; TriangleGroup::SIZE] };
        group.ids[..ids.len()].copy_from_slice(ids);
        group
    }

    /// Number of used lanes.
    #[inline]
    pub(super) fn len(&self) -> usize {
        self.ids.iter().filter(|&&id| id != u32::MAX).count()
    }

    /// Puts its triangles where their corners are in `positions`; takes a triangle for each, and returns the box around
    /// all.
    pub(super) fn place<'a>(
        &mut self,
        triangles: &mut impl Iterator<Item = &'a [u32; 3]>,
        positions: &[Vec3],
    ) -> (Vec3A, Vec3A) {
        triangles.take(self.len()).enumerate().fold(EMPTY_BOX, |bounds, (lane, corners)| {
            let [a, b, c] = corners.map(|i| positions[i as usize]);
            self.set_triangle(lane, [a, b, c]);
            let [a, b, c] = [a, b, c].map(Vec3A::from);
            union(bounds, (a.min(b).min(c), a.max(b).max(c)))
        })
    }

    fn set_triangle(&mut self, lane: usize, corners: [Vec3; 3]) {
        for (planes, corner) in self.vertices.iter_mut().zip(corners) {
            for k in 0..3 {
                planes[k].as_mut_array()[lane] = corner[k];
            }
        }
    }

    /// Box of one triangle, `(min, max)`.
    #[inline]
    pub(super) fn bounds(&self, lane: usize) -> ([f32; 3], [f32; 3]) {
        let [a, b, c] = &self.vertices;
        let of = |axis: f32x4| axis.as_array()[lane & 3];
        (
            [0, 1, 2].map(|k| of(a[k].fast_min(b[k]).fast_min(c[k]))),
            [0, 1, 2].map(|k| of(a[k].fast_max(b[k]).fast_max(c[k]))),
        )
    }

    /// Calls `found` for each triangle hit at `tmin <= t <= tmax()`; `tmin` is where the ray enters the instance.
    #[inline(always)]
    pub(super) fn intersect(&self, ray: &LocalRay, tmin: f32, best: &mut Hit, instance: u32) -> bool {
        let Shear { axes: [x, y, z], .. } = ray.shear;
        let (sx, sy) = (f32x4::splat(ray.shear.x), f32x4::splat(ray.shear.y));
        let [ox, oy, oz] = ray.shear.axes.map(|k| f32x4::splat(ray.origin[k]));
        let corner = |c: usize| {
            let v = &self.vertices[c];
            let cz = v[z] - oz;
            [(v[x] - ox) - sx * cz, (v[y] - oy) - sy * cz, cz]
        };
        let (a, b, c) = (corner(0), corner(1), corner(2));
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let low = u.fast_min(v).fast_min(w);
        let high = u.fast_max(v).fast_max(w);
        let mut inside = (low.simd_ge(f32x4::ZERO) | high.simd_le(f32x4::ZERO)).to_bitmask();
        if inside == 0 {
            return false;
        }
        let (us, vs, ws) = (u.to_array(), v.to_array(), w.to_array());
        let (az, bz, cz) = (a[2].to_array(), b[2].to_array(), c[2].to_array());
        let mut any = false;
        while inside != 0 {
            let lane = inside.trailing_zeros() as usize & 3;
            inside &= inside - 1;
            let edges = [us[lane], vs[lane], ws[lane]];
            let Some((t, u, v)) = solve(edges, [az[lane], bz[lane], cz[lane]], ray.shear.z) else { continue };
            if t > best.t {
                continue;
            }
            let (min, max) = self.bounds(lane);
            let Some(tbox) = ray.enter(min, max) else { continue };
            let hit = Hit { t: t.max(tbox).max(tmin), instance, triangle: self.ids[lane], u, v };
            if hit.precedes(best) {
                *best = hit;
                any = true;
            }
        }
        any
    }
}

/// Distance and barycentric weights of the second and third vertex, from edge functions and depths.
/// `None` if the triangle is seen edge-on or lies behind.
#[inline]
fn solve(edges: [f32; 3], depths: [f32; 3], shear_z: f32) -> Option<(f32, f32, f32)> {
    let [u, v, w] = edges;
    let det = (u + v) + w;
    let t = ((u * depths[0] + v * depths[1]) + w * depths[2]) * shear_z / det;
    (t > 0.0 && t < f32::INFINITY).then(|| (t, v / det, w / det))
}

/// The triangle test, one triangle at a time: distance and barycentric weights of the second and third vertex.
pub(super) fn intersect_triangle(ray: &LocalRay, corners: [Vec3; 3]) -> Option<(f32, f32, f32)> {
    let [x, y, z] = ray.shear.axes;
    let [a, b, c] = corners.map(|p| {
        let p = Vec3A::from(p) - Vec3A::from(ray.origin);
        [p[x] - ray.shear.x * p[z], p[y] - ray.shear.y * p[z], p[z]]
    });
    let u = c[0] * b[1] - c[1] * b[0];
    let v = a[0] * c[1] - a[1] * c[0];
    let w = b[0] * a[1] - b[1] * a[0];
    let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    if !inside {
        return None;
    }
    solve([u, v, w], [a[2], b[2], c[2]], ray.shear.z)
}
