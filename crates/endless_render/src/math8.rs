//! Functions of eight numbers side by side: the same bits on every processor, for they fuse nothing.

use std::f32::consts::{FRAC_PI_2, LOG2_E};
use wide::f32x8;

/// e to the power of each number, within 3e-7 of it; beyond -87 and 88 that of those (Cephes, Moshier 1989).
#[inline]
pub(crate) fn exp(x: f32x8) -> f32x8 {
    const POLYNOMIAL: [f32; 6] = [1.987_569_1e-4, 1.398_199_9e-3, 8.333_452e-3, 4.166_579_6e-2, 1.666_666_5e-1, 0.5];
    let x = x.fast_max(f32x8::splat(-87.0)).fast_min(f32x8::splat(88.0));
    let whole = (x * f32x8::splat(LOG2_E) + f32x8::splat(0.5)).floor();
    // ln 2 in two parts, the first of which has few digits.
    let rest = x - whole * f32x8::splat(0.693_359_4) + whole * f32x8::splat(2.121_944_4e-4);
    let [first, others @ ..] = POLYNOMIAL.map(f32x8::splat);
    let sum = others.into_iter().fold(first, |sum, c| sum * rest + c);
    let power = whole.fast_round_int().to_array().map(|n| f32::from_bits(((n + 127) as u32) << 23));
    (sum * rest * rest + rest + f32x8::ONE) * f32x8::new(power)
}

/// Angle of each (x, y) whose x is positive, within 2e-5 radians (Abramowitz and Stegun 4.4.49).
#[inline]
pub(crate) fn atan2_approx(y: f32x8, x: f32x8) -> f32x8 {
    const POLYNOMIAL: [f32; 5] = [0.020_835_1, -0.085_133, 0.180_141, -0.330_299_5, 0.999_866];
    let steep = y.abs().simd_gt(x);
    let t = x.fast_min(y.abs()) / x.fast_max(y.abs());
    let t2 = t * t;
    let [first, others @ ..] = POLYNOMIAL.map(f32x8::splat);
    let octant = t * others.into_iter().fold(first, |sum, c| sum * t2 + c);
    steep.select(f32x8::splat(FRAC_PI_2) - octant, octant).flip_signs(y)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn powers_of_e_are_right(x in -86.9f32..87.9) {
            let expected = endless_world::math::f64::exp(f64::from(x));
            for power in exp(f32x8::splat(x)).to_array() {
                prop_assert!((f64::from(power) / expected - 1.0).abs() < 3e-7, "{power} {expected}");
            }
        }

        #[test]
        fn angles_are_right(y in -100f32..100.0, x in 1e-3f32..100.0) {
            let angle = atan2_approx(f32x8::splat(y), f32x8::splat(x)).to_array()[3];
            prop_assert!((angle - endless_world::math::atan2(y, x)).abs() < 2e-5);
        }
    }

    #[test]
    fn far_powers_are_bounded() {
        let powers = exp(f32x8::new([-1e9, -87.0, 0.0, 88.0, 1e9, f32::NEG_INFINITY, 1.0, -1.0])).to_array();
        assert!(powers[0] > 0.0 && powers[0] == powers[1] && powers[5] == powers[0] && powers[2] == 1.0);
        assert_eq!(powers[3], powers[4]);
    }
}
