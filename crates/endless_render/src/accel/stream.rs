//! Rays that are traced together, component by component, and their hits.

use glam::Vec3A;
use wide::f32x8;

use super::ray::{Hit, Ray, TO_LIGHT};

/// N times eight rays: lane `8 × row + column`.
#[derive(Clone, Debug)]
pub struct RayStream<const N: usize> {
    pub(crate) origin: [[f32x8; N]; 3],
    pub(crate) direction: [[f32x8; N]; 3],
    pub(crate) tmax: [f32x8; N],
}

impl<const N: usize> RayStream<N> {
    /// Rays that must be set before they are asked for.
    pub const NONE: Self =
        Self { origin: [[f32x8::ZERO; N]; 3], direction: [[f32x8::ZERO; N]; 3], tmax: [f32x8::ZERO; N] };

    /// These rays.
    pub fn of(rays: &[[Ray; 8]; N]) -> Self {
        let mut bundle = Self::NONE;
        for (row, rays) in rays.iter().enumerate() {
            for k in 0..3 {
                bundle.origin[k][row] = f32x8::new(rays.map(|ray| ray.origin[k]));
                bundle.direction[k][row] = f32x8::new(rays.map(|ray| ray.direction[k]));
            }
            bundle.tmax[row] = f32x8::new(rays.map(|ray| ray.tmax));
        }
        bundle
    }

    /// Sets one ray.
    #[inline]
    pub fn set(&mut self, lane: usize, ray: &Ray) {
        let (row, column) = (lane / 8 % N, lane % 8);
        let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
        for k in 0..3 {
            self.origin[k][row].as_mut_array()[column] = origin[k];
            self.direction[k][row].as_mut_array()[column] = direction[k];
        }
        self.tmax[row].as_mut_array()[column] = ray.tmax;
    }

    /// Makes [`Ray::to_light`]s of all rays, from where they are.
    #[inline]
    pub(crate) fn aim_at(&mut self, light: Vec3A) {
        for (k, direction) in self.direction.iter_mut().enumerate() {
            *direction = self.origin[k].map(|origin| f32x8::splat(light[k]) - origin);
        }
        self.tmax = [f32x8::splat(TO_LIGHT); N];
    }

    /// One ray.
    #[inline]
    pub fn ray(&self, lane: usize) -> Ray {
        let (row, column) = (lane / 8 % N, lane % 8);
        let vector = |v: &[[f32x8; N]; 3]| {
            Vec3A::new(v[0][row].as_array()[column], v[1][row].as_array()[column], v[2][row].as_array()[column])
        };
        let tmax = self.tmax[row].as_array()[column];
        Ray { origin: vector(&self.origin), direction: vector(&self.direction), tmax }
    }

    /// Where eight of them have come after these distances, in units of their directions.
    #[inline]
    pub(crate) fn places(&self, row: usize, distances: f32x8) -> [f32x8; 3] {
        std::array::from_fn(|k| self.origin[k][row] + self.direction[k][row] * distances)
    }

    /// Eight of them.
    pub(super) fn row(&self, row: usize) -> RayStream<1> {
        RayStream {
            origin: self.origin.map(|axis| [axis[row]]),
            direction: self.direction.map(|axis| [axis[row]]),
            tmax: [self.tmax[row]],
        }
    }
}

/// What the rays of a bundle met.
#[derive(Clone, Debug)]
pub struct StreamHits<const N: usize> {
    pub(super) best: [[Hit; 8]; N],
    /// The lanes that were asked, a bit each.
    pub(super) asked: u32,
}

impl<const N: usize> StreamHits<N> {
    /// What a lane's ray met.
    #[inline]
    pub fn get(&self, lane: usize) -> Option<Hit> {
        self.best[lane / 8 % N][lane % 8].found().filter(|_| self.asked >> lane & 1 == 1)
    }

    /// The rays, up to what they met.
    pub(crate) fn shortened(&self, rays: &RayStream<N>) -> RayStream<N> {
        // What met nothing has its ray's own end.
        RayStream { tmax: self.best.map(|row| f32x8::new(row.map(|hit| hit.t))), ..rays.clone() }
    }
}

/// Some of at most four rows of eight lanes, a bit each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct RowMask(u32);

impl RowMask {
    pub(super) const NONE: Self = Self(0);
    const ALL: u32 = 15;

    /// Those in which a mask has any lane.
    #[inline(always)]
    pub(super) fn of(mask: u32) -> Self {
        let bit = |row: u32| u32::from(mask >> (8 * row) & 255 != 0) << row;
        Self(bit(0) | bit(1) | bit(2) | bit(3))
    }

    /// Adds a row if it has any of these eight lanes.
    #[inline(always)]
    pub(super) fn add(&mut self, row: usize, lanes: u32) {
        self.0 |= u32::from(lanes & 255 != 0) << row;
    }

    /// Whether there is more than one.
    pub(super) fn several(self) -> bool {
        self.0 & self.0.wrapping_sub(1) != 0
    }

    /// One by one, of N.
    #[inline(always)]
    pub(super) fn each<const N: usize>(self) -> impl Iterator<Item = usize> {
        lanes(if N == 1 { 1 } else { self.0 }).map(|row| row % N)
    }

    /// Written into the last bits of a distance, which is not negative, and becomes less if anything.
    #[inline(always)]
    pub(super) fn with_distance<const N: usize>(self, t: f32) -> f32 {
        if N == 1 {
            return t;
        }
        f32::from_bits(t.to_bits() & !Self::ALL | self.0)
    }

    /// What `with_distance` has written.
    #[inline(always)]
    pub(super) fn and_distance<const N: usize>(t: f32) -> (Self, f32) {
        if N == 1 {
            return (Self(1), t);
        }
        (Self(t.to_bits() & Self::ALL), f32::from_bits(t.to_bits() & !Self::ALL))
    }
}

/// The lanes of a mask.
pub(crate) fn lanes(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (lane < 32).then_some(lane)
    })
}

/// The lanes of the first `count` (at most eight) of each row, of four rows.
pub(crate) fn first_lanes(count: usize) -> u32 {
    u32::from_ne_bytes([((1u16 << count) - 1) as u8; 4])
}

/// All bits of those of eight lanes whose bit is set, none of the others.
#[inline(always)]
pub(crate) fn lane_mask(bits: u32) -> f32x8 {
    // As exponents the bits are positive numbers, each a normal one.
    const OWN: f32x8 = f32x8::new([
        f32::from_bits(1 << 23),
        f32::from_bits(1 << 24),
        f32::from_bits(1 << 25),
        f32::from_bits(1 << 26),
        f32::from_bits(1 << 27),
        f32::from_bits(1 << 28),
        f32::from_bits(1 << 29),
        f32::from_bits(1 << 30),
    ]);
    (f32x8::splat(f32::from_bits((bits & 255) << 23)) & OWN).simd_gt(f32x8::ZERO)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn masks_have_the_lanes_of_their_bits() {
        for bits in 0..512 {
            let lanes = lane_mask(bits).to_array().map(f32::to_bits);
            let expected = [0, 1, 2, 3, 4, 5, 6, 7].map(|lane| if bits >> lane & 1 == 1 { u32::MAX } else { 0 });
            assert_eq!(lanes, expected, "{bits}");
        }
    }
}
