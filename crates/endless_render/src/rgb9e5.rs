//! Light in four bytes: three mantissas of nine bits that share an exponent of five (OpenGL's `RGB9_E5`, Ward 1991).

use glam::Vec3A;

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
}

/// 2 to a power from -126 to 127.
fn power_of_two(power: i32) -> f32 {
    f32::from_bits(((power + 127) as u32) << 23)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ends_of_the_range() {
        assert_eq!(Rgb9e5::new(Vec3A::ZERO), Rgb9e5::ZERO);
        assert_eq!(Rgb9e5::ZERO.get(), Vec3A::ZERO);
        assert_eq!(Rgb9e5::new(Vec3A::splat(1e9)).get(), Vec3A::splat(MOST));
        assert_eq!(Rgb9e5::new(Vec3A::new(-1.0, f32::MIN_POSITIVE, 0.0)).get(), Vec3A::ZERO);
    }

    proptest! {
        #[test]
        fn what_is_packed_comes_back(power in -16i32..16, most in 1f32..1.99, shares in prop::array::uniform3(0f32..1.0)) {
            let most = most * power_of_two(power);
            let light = Vec3A::from(shares).with_y(1.0) * most;
            let packed = Rgb9e5::new(light);
            let error = (packed.get() - light).abs().max_element();
            prop_assert!(error <= most / 511.0, "{light} became {}", packed.get());
            prop_assert_eq!(Rgb9e5::new(packed.get()), packed);
        }
    }
}
