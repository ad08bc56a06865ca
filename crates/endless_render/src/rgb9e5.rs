//! Light in four bytes: three mantissas of nine bits that share an exponent of five (OpenGL's `RGB9_E5`, Ward 1991).

use crate::exact8;
use crate::vec3x8::Vec3x8;
use glam::Vec3A;
use wide::{f32x8, i32x8, u32x8};

const MANTISSA_BITS: u32 = 9;
const BIAS: i32 = 15;
/// The largest number there is.
const MOST: f32 = 65_408.0;
/// Exponent of the smallest numbers, whose mantissas may begin with zeros.
const LEAST_EXPONENT: i32 = -BIAS - 1;

/// Three numbers from 0 to 65,408, each known to 1/512 of the largest of them (where that is no less than 2⁻¹⁶).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Rgb9e5(u32);

impl Rgb9e5 {
    pub(crate) const ZERO: Self = Self(0);

    /// The nearest that can be told; of what is negative, zero.
    pub(crate) fn new(light: Vec3A) -> Self {
        let light = light.max(Vec3A::ZERO).min(Vec3A::splat(MOST));
        let most = light.max_element();
        // The whole part of the logarithm is the number's own exponent.
        let exponent = ((most.to_bits() >> 23) as i32 - 127).max(LEAST_EXPONENT) + 1;
        let steps = |exponent: i32| power_of_two(MANTISSA_BITS as i32 - exponent);
        let exponent = exponent + i32::from((most * steps(exponent)).round() >= (1 << MANTISSA_BITS) as f32);
        let [r, g, b] = (light * steps(exponent)).round().to_array().map(|c| c as u32);
        Self(r | g << 9 | b << 18 | ((exponent + BIAS) as u32) << 27)
    }

    /// The three numbers.
    pub(crate) fn get(self) -> Vec3A {
        let [r, g, b] = [0, 9, 18].map(|shift| (self.0 >> shift & 0x1ff) as f32);
        Vec3A::new(r, g, b) * power_of_two((self.0 >> 27) as i32 - BIAS - MANTISSA_BITS as i32)
    }

    /// [`Self::new`] of eight.
    #[inline]
    pub(crate) fn pack8(light: &Vec3x8) -> [Self; 8] {
        let light = light.map(|c| c.fast_max(f32x8::ZERO).fast_min(f32x8::splat(MOST)));
        let most = light[0].fast_max(light[1]).fast_max(light[2]);
        let own = (most.to_bits() >> 23u32).cast_signed() - i32x8::splat(127);
        let exponent = own.max(i32x8::splat(LEAST_EXPONENT)) + i32x8::ONE;
        let steps = |exponent: i32x8| exact8::power_of_two(i32x8::splat(MANTISSA_BITS as i32) - exponent);
        // A comparison that holds is -1.
        let exponent =
            exponent - exact8::round_int(most * steps(exponent)).simd_gt(i32x8::splat((1 << MANTISSA_BITS) - 1));
        let steps = steps(exponent);
        let [r, g, b] = light.map(|c| exact8::round_int(c * steps).cast_unsigned());
        let exponent = (exponent + i32x8::splat(BIAS)).cast_unsigned();
        (r | g << 9u32 | b << 18u32 | exponent << 27u32).to_array().map(Self)
    }

    /// [`Self::get`] of eight.
    #[inline]
    pub(crate) fn unpack8(packed: &[Self; 8]) -> Vec3x8 {
        let packed = u32x8::new(packed.map(|one| one.0));
        let scale = (packed >> 27u32).cast_signed() - i32x8::splat(BIAS + MANTISSA_BITS as i32);
        let scale = exact8::power_of_two(scale);
        let mantissa = |bits: u32x8| f32x8::from_i32x8((bits & u32x8::splat(0x1ff)).cast_signed());
        [mantissa(packed) * scale, mantissa(packed >> 9u32) * scale, mantissa(packed >> 18u32) * scale]
    }
}

/// 2 to a power from -126 to 127.
fn power_of_two(power: i32) -> f32 {
    f32::from_bits(((power + 127) as u32) << 23)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3x8::side_by_side;
    use proptest::prelude::*;

    #[test]
    fn ends_of_the_range() {
        assert_eq!(Rgb9e5::new(Vec3A::ZERO), Rgb9e5::ZERO);
        assert_eq!(Rgb9e5::ZERO.get(), Vec3A::ZERO);
        assert_eq!(Rgb9e5::new(Vec3A::splat(1e9)).get(), Vec3A::splat(MOST));
        assert_eq!(Rgb9e5::new(Vec3A::new(-1.0, f32::MIN_POSITIVE, 0.0)).get(), Vec3A::ZERO);
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        #[test]
        fn what_is_packed_comes_back(power in -16i32..16, most in 1f32..1.99, shares in prop::array::uniform3(0f32..1.0)) {
            let most = most * power_of_two(power);
            let light = Vec3A::from(shares).with_y(1.0) * most;
            let packed = Rgb9e5::new(light);
            let error = (packed.get() - light).abs().max_element();
            prop_assert!(error <= most / 511.0, "{light} became {}", packed.get());
            prop_assert_eq!(Rgb9e5::new(packed.get()), packed);
        }

        #[test]
        fn eight_are_packed_as_one_after_another(
            lights in prop::array::uniform8(prop::array::uniform3((-20i32..18, -0.3f32..2.0))),
            ends in prop::array::uniform8(0..16),
        ) {
            let lights: [Vec3A; 8] = std::array::from_fn(|i| {
                let light = Vec3A::from(lights[i].map(|(power, share)| power_of_two(power) * share));
                match ends[i] {
                    0 => Vec3A::ZERO,
                    1 => light * -0.0,
                    2 => light * f32::INFINITY,
                    3 => light.with_y(MOST).with_z(-0.0),
                    // Halves of steps, and what is next below them.
                    4 => (light * 256.0).floor() / 512.0,
                    5 => Vec3A::new(0.5, 0.25, 0.5f32.next_down()) * power_of_two(lights[i][0].0),
                    6 => Vec3A::new(511.5, 0.5f32.next_down(), 0.5) * power_of_two(lights[i][0].0 - 9),
                    7 => Vec3A::new(511.5f32.next_down(), 1.5, 2.5) * power_of_two(lights[i][0].0 - 9),
                    8 => light * 1e-38,
                    _ => light,
                }
            });
            let lights = lights.map(|light| if light.is_nan() { Vec3A::ZERO } else { light });
            let packed = Rgb9e5::pack8(&side_by_side(lights));
            prop_assert_eq!(packed, lights.map(Rgb9e5::new));
            let found = Rgb9e5::unpack8(&packed).map(f32x8::to_array);
            for i in 0..8 {
                prop_assert_eq!(found.map(|c| c[i].to_bits()), packed[i].get().to_array().map(f32::to_bits));
            }
        }

        #[test]
        fn any_eight_are_unpacked_as_one_after_another(packed: [u32; 8]) {
            let packed = packed.map(Rgb9e5);
            let found = Rgb9e5::unpack8(&packed).map(f32x8::to_array);
            for i in 0..8 {
                prop_assert_eq!(found.map(|c| c[i].to_bits()), packed[i].get().to_array().map(f32::to_bits));
            }
        }
    }
}
