//! Functions of [`endless_world::math`] of eight numbers side by side: the same bits in each.

use std::f32::consts::{FRAC_PI_2, LOG2_E, PI};
use wide::{f32x8, i32x8};

/// [`endless_world::math::exp`]: the steps of `libm` (FreeBSD's `e_expf.c`). Its longest way gives what most of its other
/// branches give, if no power of two is taken out where they take none.
#[inline]
pub(crate) fn exp(x: f32x8) -> f32x8 {
    const LN2_HI: f32 = 0.693_145_75;
    const LN2_LO: f32 = 1.428_606_8e-6;
    const P1: f32 = 0.166_666_25;
    const P2: f32 = -2.766_733_3e-3;
    /// ln 2 / 2, up to which `libm` takes no power of two out.
    const SMALL: f32 = f32::from_bits(0x3eb1_7218);
    /// Up to which `libm` takes the curve for straight.
    const TINY: f32 = f32::from_bits(0x3900_0000);
    // Beyond these, nothing is left and nothing is finite.
    let x = x.fast_clamp(f32x8::splat(-104.0), f32x8::splat(89.0));
    let size = x.abs();
    let straight = f32x8::ONE + x;
    let nearest = (f32x8::splat(LOG2_E) * x + f32x8::HALF.copysign(x)).trunc();
    let whole = size.simd_gt(f32x8::splat(SMALL)) & nearest;
    let (high, low) = (x - whole * f32x8::splat(LN2_HI), whole * f32x8::splat(LN2_LO));
    let x = high - low;
    let xx = x * x;
    let c = x - xx * (f32x8::splat(P1) + xx * f32x8::splat(P2));
    let y = f32x8::ONE + (x * c / (f32x8::splat(2.0) - c) - low + high);
    // In two steps, of which the first is exact: some powers of two are too large or too small for one number.
    let power = whole.fast_trunc_int();
    let first = power >> 1u32;
    let grown = y * power_of_two(first) * power_of_two(power - first);
    size.simd_gt(f32x8::splat(TINY)).select(grown, straight)
}

/// 2 to a power from -126 to 127.
#[inline]
pub(crate) fn power_of_two(power: i32x8) -> f32x8 {
    f32x8::from_bits((power + i32x8::splat(127)).cast_unsigned() << 23u32)
}

/// [`endless_world::math::atan2_approx`].
#[inline]
pub(crate) fn atan2_approx(y: f32x8, x: f32x8) -> f32x8 {
    let (ax, ay) = (x.abs(), y.abs());
    let t = ax.fast_min(ay) / ax.fast_max(ay).fast_max(f32x8::splat(f32::MIN_POSITIVE));
    let t2 = t * t;
    let poly = f32x8::splat(-0.085_133) + t2 * f32x8::splat(0.020_835_1);
    let poly = f32x8::splat(-0.330_299_5) + t2 * (f32x8::splat(0.180_141) + t2 * poly);
    let octant = t * (f32x8::splat(0.999_866) + t2 * poly);
    let quadrant = ay.simd_gt(ax).select(f32x8::splat(FRAC_PI_2) - octant, octant);
    let half = x.simd_lt(f32x8::ZERO).select(f32x8::splat(PI) - quadrant, quadrant);
    negated(half, y.simd_lt(f32x8::ZERO))
}

/// Numbers with their signs turned where something holds.
#[inline]
pub(crate) fn negated(x: f32x8, holds: f32x8) -> f32x8 {
    x ^ (holds & f32x8::splat(-0.0))
}

/// [`f32::round`] of numbers from -2²² to 2²². What is added is a little less than a half: with a half, the number next below
/// it would become 1, while sums with halves become whole this way, too, for want of digits.
#[inline]
pub(crate) fn round_int(x: f32x8) -> i32x8 {
    (x + f32x8::splat(0.5f32.next_down()).copysign(x)).fast_trunc_int()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::math;
    use proptest::prelude::*;

    /// Bits of numbers at which the one-number way takes another branch.
    const TURNS: [u32; 6] = [0x3900_0000, 0x3eb1_7218, 0x3f85_1592, 0x42ae_ac50, 0x42b1_7218, 0x42cf_f1b5];

    fn check_exp(x: [f32; 8]) {
        let eight = exp(f32x8::new(x)).to_array();
        for (x, found) in x.into_iter().zip(eight) {
            assert_eq!(found.to_bits(), math::exp(x).to_bits(), "{x}");
        }
    }

    #[test]
    fn powers_of_e_at_the_turns_are_those_of_one_number() {
        for turn in TURNS {
            for first in (turn - 4096..turn + 4096).step_by(8) {
                for sign in [0, 1 << 31] {
                    check_exp(std::array::from_fn(|i| f32::from_bits((first + i as u32) | sign)));
                }
            }
        }
        check_exp([0.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN, 1e-40, -1e-40]);
    }

    /// Every 509th number there is: some eight million.
    #[test]
    fn powers_of_e_of_all_sizes_are_those_of_one_number() {
        for first in (0..f32::INFINITY.to_bits()).step_by(8 * 509) {
            for sign in [0, 1 << 31] {
                check_exp(std::array::from_fn(|i| f32::from_bits((first + 509 * i as u32).min(0x7f80_0000) | sign)));
            }
        }
    }

    fn check_rounding(x: [f32; 8]) {
        assert_eq!(round_int(f32x8::new(x)).to_array(), x.map(|x| x.round() as i32), "{x:?}");
    }

    #[test]
    fn rounded_numbers_are_those_of_one_number() {
        for n in -70_000..70_000 {
            let half = n as f32 + 0.5;
            let (below, above) = (half.next_down(), half.next_up());
            check_rounding([
                half,
                below,
                above,
                n as f32,
                below.next_down(),
                above.next_up(),
                half * 59.0,
                n as f32 * 0.01,
            ]);
        }
        // Every 509th number there is of these.
        for first in (0..4_194_304f32.to_bits()).step_by(8 * 509) {
            let x: [f32; 8] = std::array::from_fn(|i| f32::from_bits(first + 509 * i as u32).min(4_194_304.0));
            check_rounding(x);
            check_rounding(x.map(|x| -x));
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(16_384))]

        #[test]
        fn powers_of_e_are_those_of_one_number(x in prop::array::uniform8(-110f32..95.0), scale in 0..4) {
            check_exp(x.map(|x| x * [1.0, 0.1, 0.01, 1e-4][scale as usize]));
        }

        #[test]
        fn angles_are_those_of_one_vector(
            y in prop::array::uniform8(-1f32..1.0), x in prop::array::uniform8(-1f32..1.0),
            ends in prop::array::uniform8(0..20usize),
        ) {
            let end = |value: f32, end: usize| match end {
                0 => 0.0,
                1 => -0.0,
                2 => 1.0,
                3 => -1.0,
                4 => value * 1e-40,
                _ => value,
            };
            let y: [f32; 8] = std::array::from_fn(|i| end(y[i], ends[i]));
            let x: [f32; 8] = std::array::from_fn(|i| end(x[i], ends[(i + 1) % 8]));
            let eight = atan2_approx(f32x8::new(y), f32x8::new(x)).to_array();
            for i in 0..8 {
                prop_assert_eq!(eight[i].to_bits(), math::atan2_approx(y[i], x[i]).to_bits());
            }
        }
    }
}
