//! What is counted in parts and added up: counts are whole numbers, so the sum does not depend on the order of the parts.

use std::collections::BTreeMap;

/// Adds what was counted elsewhere.
pub(crate) trait Merge {
    /// Adds the other's counts to one's own.
    fn absorb(&mut self, other: Self);
}

impl Merge for u64 {
    fn absorb(&mut self, other: Self) {
        *self = self.saturating_add(other);
    }
}

impl<T: Merge> Merge for Option<T> {
    fn absorb(&mut self, other: Self) {
        match (self.as_mut(), other) {
            (Some(own), Some(other)) => own.absorb(other),
            (None, other) => *self = other,
            (Some(_), None) => {}
        }
    }
}

impl<K: Ord, V: Merge> Merge for BTreeMap<K, V> {
    fn absorb(&mut self, other: Self) {
        for (key, value) in other {
            match self.get_mut(&key) {
                Some(own) => own.absorb(value),
                None => {
                    self.insert(key, value);
                }
            }
        }
    }
}

/// A structure is merged field by field; none can be forgotten.
macro_rules! merge_fields {
    ($type:ty { $($field:ident),* $(,)? }) => {
        impl $crate::merge::Merge for $type {
            fn absorb(&mut self, other: Self) {
                let Self { $($field),* } = other;
                $($crate::merge::Merge::absorb(&mut self.$field, $field);)*
            }
        }
    };
}
pub(crate) use merge_fields;
