//! Colours by their own keys.

use endless_world::fnv1a;

/// Key of a linear colour in random choices: a colour more in a list changes only those who get it.
pub(crate) fn color_key(color: &[f32; 3]) -> u64 {
    fnv1a(color.iter().flat_map(|c| c.to_bits().to_le_bytes()))
}
