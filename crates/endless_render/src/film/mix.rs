//! Two pictures of one instant in different light, laid over each other.

/// Brings a picture this share of the way to another of the same size, in the values that are seen: a change goes on as
/// evenly as its share.
pub(crate) fn mix_rgb(picture: &mut [[u8; 3]], other: &[[u8; 3]], share: f32) {
    mix_values(picture.as_flattened_mut(), other.as_flattened(), share);
}

/// The same of values.
pub(crate) fn mix_values(picture: &mut [u8], other: &[u8], share: f32) {
    debug_assert_eq!(picture.len(), other.len());
    // Sixteen bits are enough to tell all shares of a change apart that eight bits of colour can show.
    let weight = (share.clamp(0.0, 1.0) * 65_536.0) as u32;
    for (value, other) in picture.iter_mut().zip(other) {
        let sum = u32::from(*value) * (65_536 - weight) + u32::from(*other) * weight;
        *value = ((sum + 32_768) >> 16) as u8;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_mixture_lies_between_and_its_ends_are_the_pictures(a: [u8; 3], b: [u8; 3], share in 0f32..=1.0) {
            let mixed = |share| {
                let mut picture = [a; 5];
                mix_rgb(&mut picture, &[b; 5], share);
                picture[3]
            };
            prop_assert_eq!((mixed(0.0), mixed(1.0)), (a, b));
            for k in 0..3 {
                let exact = f32::from(a[k]) + (f32::from(b[k]) - f32::from(a[k])) * share;
                prop_assert!((f32::from(mixed(share)[k]) - exact).abs() <= 0.51);
            }
        }
    }
}
