//! Numbers of one pixel, or of eight pixels side by side: a material is written once for both, and both give the same
//! bits.

use super::noise_batch::NoiseBatch;
use super::noise8::{self, NoiseQuestions8};
use super::{noise, noise_questions::NoiseQuestions};
use glam::{IVec2, Vec2};
use std::ops::{Add, Div, Mul, Neg, Sub};
use wide::f32x8;

/// A number of each pixel.
pub(super) trait PerPixel:
    Copy
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Add<f32, Output = Self>
    + Sub<f32, Output = Self>
    + Mul<f32, Output = Self>
    + Div<f32, Output = Self>
{
    /// Whether something holds of each pixel.
    type Truth: Truth<Self>;
    /// How noise is asked for.
    type Noise: NoiseQuestions<Self>;
    const ONE: Self;

    /// The same of all pixels.
    fn splat(value: f32) -> Self;
    fn abs(self) -> Self;
    fn floor(self) -> Self;
    fn min(self, other: Self) -> Self;
    fn max(self, other: Self) -> Self;
    /// Between 0 and 1.
    fn clamped(self) -> Self;
    fn is_below(self, limit: Self) -> Self::Truth;
    /// [`noise::cell2`] of a lattice's cell; of its corner's numbers none has a fraction.
    fn cell2(corner: [Self; 2], salt: u32) -> Self;
    /// [`noise::value2`].
    fn value2(p: [Self; 2], salt: u32) -> Self;
    /// [`noise::filtered_fbm2`].
    fn filtered_fbm2(p: [Self; 2], wavelength_m: f32, octaves: u32, footprint_m: Self) -> Self;
    /// [`noise::cells2`].
    fn cells2(p: [Self; 2], salt: u32) -> [Self; 3];
}

/// Whether something holds of each pixel.
pub(super) trait Truth<N>: Copy {
    fn and(self, other: Self) -> Self;
    /// Of at least one pixel.
    fn anywhere(self) -> bool;
    /// Of all pixels.
    fn everywhere(self) -> bool;
    fn select(self, holds: N, fails: N) -> N;
}

impl PerPixel for f32 {
    type Truth = bool;
    type Noise = NoiseBatch;
    const ONE: Self = 1.0;

    #[inline]
    fn splat(value: f32) -> Self {
        value
    }

    #[inline]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline]
    fn floor(self) -> Self {
        self.floor()
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        self.min(other)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        self.max(other)
    }

    #[inline]
    fn clamped(self) -> Self {
        self.clamp(0.0, 1.0)
    }

    #[inline]
    fn is_below(self, limit: Self) -> bool {
        self < limit
    }

    #[inline]
    fn cell2([x, y]: [Self; 2], salt: u32) -> Self {
        noise::cell2(IVec2::new(x as i32, y as i32), salt)
    }

    #[inline]
    fn value2(p: [Self; 2], salt: u32) -> Self {
        noise::value2(Vec2::from_array(p), salt)
    }

    #[inline]
    fn filtered_fbm2(p: [Self; 2], wavelength_m: f32, octaves: u32, footprint_m: Self) -> Self {
        noise::filtered_fbm2(Vec2::from_array(p), wavelength_m, octaves, footprint_m)
    }

    #[inline]
    fn cells2(p: [Self; 2], salt: u32) -> [Self; 3] {
        noise::cells2(Vec2::from_array(p), salt).into()
    }
}

impl Truth<f32> for bool {
    #[inline]
    fn and(self, other: Self) -> Self {
        self && other
    }

    #[inline]
    fn anywhere(self) -> bool {
        self
    }

    #[inline]
    fn everywhere(self) -> bool {
        self
    }

    #[inline]
    fn select(self, holds: f32, fails: f32) -> f32 {
        if self { holds } else { fails }
    }
}

impl PerPixel for f32x8 {
    type Truth = Self;
    type Noise = NoiseQuestions8;
    const ONE: Self = f32x8::ONE;

    #[inline]
    fn splat(value: f32) -> Self {
        f32x8::splat(value)
    }

    #[inline]
    fn abs(self) -> Self {
        self.abs()
    }

    #[inline]
    fn floor(self) -> Self {
        self.floor()
    }

    #[inline]
    fn min(self, other: Self) -> Self {
        self.fast_min(other)
    }

    #[inline]
    fn max(self, other: Self) -> Self {
        self.fast_max(other)
    }

    #[inline]
    fn clamped(self) -> Self {
        self.fast_clamp(Self::ZERO, Self::ONE)
    }

    #[inline]
    fn is_below(self, limit: Self) -> Self {
        self.simd_lt(limit)
    }

    #[inline]
    fn cell2(corner: [Self; 2], salt: u32) -> Self {
        noise8::cell2x8(corner, salt)
    }

    #[inline]
    fn value2(p: [Self; 2], salt: u32) -> Self {
        noise8::value2x8(p, salt)
    }

    #[inline]
    fn filtered_fbm2(p: [Self; 2], wavelength_m: f32, octaves: u32, footprint_m: Self) -> Self {
        noise8::filtered_fbm2x8(p, Self::splat(wavelength_m), octaves, footprint_m)
    }

    #[inline]
    fn cells2(p: [Self; 2], salt: u32) -> [Self; 3] {
        noise8::cells2x8(p, salt)
    }
}

impl Truth<f32x8> for f32x8 {
    #[inline]
    fn and(self, other: Self) -> Self {
        self & other
    }

    #[inline]
    fn anywhere(self) -> bool {
        self.any()
    }

    #[inline]
    fn everywhere(self) -> bool {
        self.all()
    }

    #[inline]
    fn select(self, holds: f32x8, fails: f32x8) -> f32x8 {
        wide::Select::select(self, holds, fails)
    }
}

/// [`endless_world::math::smoothstep`] between bounds that all pixels share.
#[inline]
pub(super) fn smoothstep<N: PerPixel>(from: f32, to: f32, x: N) -> N {
    smooth((x - from) / (to - from))
}

/// [`endless_world::math::smoothstep`].
#[inline]
pub(super) fn smoothstep_between<N: PerPixel>(from: N, to: N, x: N) -> N {
    smooth((x - from) / (to - from))
}

#[inline]
fn smooth<N: PerPixel>(t: N) -> N {
    let t = t.clamped();
    t * t * (N::splat(3.0) - t * 2.0)
}

/// The smaller of the two distances to the sides of a rectangle along each axis, and of these the smallest: `local` from
/// its low corner, metres.
#[inline]
pub(super) fn edge_distance<N: PerPixel>(local: [N; 2], size: [f32; 2]) -> N {
    let [x, y] = [0, 1].map(|k| local[k].min(N::splat(size[k]) - local[k]));
    x.min(y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn steps_of_eight_are_those_of_one_after_another(
            x in prop::array::uniform8(-2f32..2.0), from in -1f32..0.0, span in prop::array::uniform8(0.01f32..2.0),
        ) {
            let to: [f32; 8] = std::array::from_fn(|i| from + span[i]);
            let eight = smoothstep_between(f32x8::splat(from), f32x8::new(to), f32x8::new(x)).to_array();
            for i in 0..8 {
                let expected = endless_world::math::smoothstep(from, to[i], x[i]).to_bits();
                prop_assert_eq!(eight[i].to_bits(), expected);
                prop_assert_eq!(smoothstep(from, to[i], f32x8::splat(x[i])).to_array()[3].to_bits(), expected);
                prop_assert_eq!(smoothstep(from, to[i], x[i]).to_bits(), expected);
            }
        }
    }
}
