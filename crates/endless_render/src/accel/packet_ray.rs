//! Eight rays prepared for box and triangle tests in one frame of reference.

use glam::Vec3A;
use wide::f32x8;

use super::node::Beam;
use super::packet::{Trip, lanes};
use super::ray::{FAR_PAD, Hit, MAX_INVERSE, Ray, Transform, permutation};
use super::triangle::TriangleGroup;

/// Eight rays whose directions agree in signs and main axis.
pub(super) struct PacketRay {
    origin: [f32x8; 3],
    direction: [f32x8; 3],
    inverse: [f32x8; 3],
    negative: [usize; 3],
    axes: [usize; 3],
    /// As `Shear`, by lane.
    shear: [f32x8; 3],
    /// The interval of all rays.
    pub(super) beam: Beam,
}

impl PacketRay {
    /// `None` if directions do not agree. Lanes that are not active follow one that is.
    pub(super) fn in_world(rays: &[Ray; 8], active: u8) -> Option<Self> {
        let first = active.trailing_zeros() as usize & 7;
        let ray = |lane: usize| if active >> lane & 1 != 0 { &rays[lane] } else { &rays[first] };
        let lanes = |of: fn(&Ray) -> Vec3A| {
            let v: [Vec3A; 8] = std::array::from_fn(|lane| of(ray(lane)));
            [f32x8::new(v.map(|v| v.x)), f32x8::new(v.map(|v| v.y)), f32x8::new(v.map(|v| v.z))]
        };
        Self::new(lanes(|ray| ray.origin), lanes(|ray| ray.direction))
    }

    /// The same rays in the frame of an instance; `None` if directions do not agree there.
    pub(super) fn transformed(&self, transform: &Transform) -> Option<Self> {
        let m = &transform.linear;
        let splat = |v: Vec3A| v.to_array().map(f32x8::splat);
        let (cx, cy, cz, shift) = (splat(m.x_axis), splat(m.y_axis), splat(m.z_axis), splat(transform.translation));
        let vector = |v: &[f32x8; 3], k: usize| (cx[k] * v[0] + cy[k] * v[1]) + cz[k] * v[2];
        let direction = std::array::from_fn(|k| vector(&self.direction, k));
        let origin = std::array::from_fn(|k| vector(&self.origin, k) + shift[k]);
        Self::new(origin, direction)
    }

    #[inline(always)]
    fn new(origin: [f32x8; 3], direction: [f32x8; 3]) -> Option<Self> {
        let [ax, ay, az] = direction.map(f32x8::abs);
        let x_main = (ax.simd_ge(ay) & ax.simd_ge(az)).to_bitmask();
        let y_main = ay.simd_ge(az).to_bitmask();
        let axes = permutation(match (x_main, y_main) {
            (255, _) => 0,
            (0, 255) => 1,
            (0, 0) => 2,
            _ => return None,
        });
        let inverse = direction.map(inverse);
        let mut negative = [0; 3];
        for k in 0..3 {
            negative[k] = match inverse[k].simd_lt(f32x8::ZERO).to_bitmask() {
                0 => 0,
                255 => 1,
                _ => return None,
            };
        }
        let z = inverse[axes[2]];
        let shear = [direction[axes[0]] * z, direction[axes[1]] * z, z];
        let beam = beam(&origin, &inverse, negative);
        Some(PacketRay { origin, direction, inverse, negative, axes, shear, beam })
    }

    /// `LocalRay::enter` by lane: which live lanes enter a box before their best hit, and where.
    #[inline(always)]
    pub(super) fn enter(&self, min: [f32; 3], max: [f32; 3], trip: &Trip) -> (u32, [f32; 8]) {
        let (tnear, tfar) = self.slabs(min, max);
        (tnear.simd_le(tfar.fast_min(trip.ends)).to_bitmask() & trip.live, tnear.to_array())
    }

    #[inline(always)]
    fn slabs(&self, min: [f32; 3], max: [f32; 3]) -> (f32x8, f32x8) {
        let (mut near, mut far) = (f32x8::ZERO, f32x8::splat(f32::INFINITY));
        let pad = f32x8::splat(FAR_PAD);
        for k in 0..3 {
            let (first, last) = if self.negative[k] == 0 { (min[k], max[k]) } else { (max[k], min[k]) };
            near = near.fast_max((f32x8::splat(first) - self.origin[k]) * self.inverse[k]);
            far = far.fast_min((f32x8::splat(last) - self.origin[k]) * (self.inverse[k] * pad));
        }
        (near, far)
    }

    /// `TriangleGroup::intersect` for the live lanes; with `ANY` lanes that hit are no longer live.
    #[inline(always)]
    pub(super) fn intersect<const ANY: bool>(
        &self,
        group: &TriangleGroup,
        tmin: Option<&[f32; 8]>,
        trip: &mut Trip,
        instance: u32,
    ) {
        let [x, y, z] = self.axes;
        let [sx, sy, sz] = self.shear;
        let (ox, oy, oz) = (self.origin[x], self.origin[y], self.origin[z]);
        for lane in 0..TriangleGroup::SIZE {
            let triangle = group.ids[lane];
            if triangle == u32::MAX {
                break;
            }
            let corner = |c: usize| {
                let v = |k: usize| f32x8::splat(group.vertices[c][k].as_array()[lane]);
                let cz = v(z) - oz;
                [(v(x) - ox) - sx * cz, (v(y) - oy) - sy * cz, cz]
            };
            let (a, b, c) = (corner(0), corner(1), corner(2));
            let u = c[0] * b[1] - c[1] * b[0];
            let v = a[0] * c[1] - a[1] * c[0];
            let w = b[0] * a[1] - b[1] * a[0];
            let low = u.fast_min(v).fast_min(w);
            let high = u.fast_max(v).fast_max(w);
            let inside = (low.simd_ge(f32x8::ZERO) | high.simd_le(f32x8::ZERO)).to_bitmask() & trip.live;
            if inside == 0 {
                continue;
            }
            let det = (u + v) + w;
            let t = ((u * a[2] + v * b[2]) + w * c[2]) * sz / det;
            let reach = f32x8::splat(trip.reach);
            let valid =
                (t.simd_gt(f32x8::ZERO) & t.simd_lt(f32x8::splat(f32::INFINITY)) & t.simd_le(reach)).to_bitmask();
            if inside & valid == 0 {
                continue;
            }
            let (min, max) = group.bounds(lane);
            let (tnear, tfar) = self.slabs(min, max);
            let candidates = inside & valid & tnear.simd_le(tfar).to_bitmask();
            let (ts, us, vs) = (t.fast_max(tnear).to_array(), (v / det).to_array(), (w / det).to_array());
            let mut found = 0;
            for ray in lanes(candidates) {
                let t = tmin.map_or(ts[ray], |tmin| ts[ray].max(tmin[ray]));
                let hit = Hit { t, instance, triangle, u: us[ray], v: vs[ray] };
                if hit.precedes(trip.best(ray)) {
                    trip.improve(ray, hit);
                    found |= 1 << ray;
                }
            }
            if found != 0 {
                if ANY {
                    trip.live &= !found;
                }
                trip.update_reach();
            }
        }
    }
}

/// `ray::inverse` by lane.
#[inline(always)]
fn inverse(d: f32x8) -> f32x8 {
    let largest = (d & f32x8::splat(-0.0)) | f32x8::splat(MAX_INVERSE);
    d.abs().simd_lt(f32x8::splat(1.0 / MAX_INVERSE)).select(largest, f32x8::ONE / d)
}

/// The interval of all rays: it enters a box no later than any of them, and leaves it no sooner.
#[inline(always)]
fn beam(origin: &[f32x8; 3], inverse: &[f32x8; 3], negative: [usize; 3]) -> Beam {
    let zero = [f32x8::ZERO; 3];
    let mut beam = Beam { negative, origin_near: zero, origin_far: zero, inverse_near: zero, inverse_far: zero };
    for k in 0..3 {
        let (low, high) = range(origin[k]);
        let (least, most) = range(inverse[k]);
        let flip = |(a, b): (f32, f32)| if negative[k] == 0 { (a, b) } else { (b, a) };
        let (far, near) = flip((low, high));
        let (slow, fast) = flip((least, most));
        beam.origin_near[k] = f32x8::splat(near);
        beam.origin_far[k] = f32x8::splat(far);
        beam.inverse_near[k] = f32x8::splat(slow);
        beam.inverse_far[k] = f32x8::splat(fast * FAR_PAD);
    }
    beam
}

/// Least and greatest lane.
#[inline(always)]
fn range(v: f32x8) -> (f32, f32) {
    let [a, b, c, d, e, f, g, h] = v.to_array();
    let low = wide::f32x4::new([a, b, c, d]).fast_min(wide::f32x4::new([e, f, g, h])).to_array();
    let high = wide::f32x4::new([a, b, c, d]).fast_max(wide::f32x4::new([e, f, g, h])).to_array();
    (low[0].min(low[1]).min(low[2].min(low[3])), high[0].max(high[1]).max(high[2].max(high[3])))
}
