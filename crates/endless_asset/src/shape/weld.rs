//! Finding points that coincide, quickly.

use indexmap::IndexSet;
use std::hash::{BuildHasherDefault, Hasher};

/// Different keys, numbered as they come. Its table holds numbers alone and so stays in the processor's cache, where a
/// map of the keys would not. Keys are grid cells that our own code made: nobody can choose them so that they collide.
pub(crate) type Interner<K> = IndexSet<K, BuildHasherDefault<CellHasher>>;

/// With room for some keys before it must grow.
pub(crate) fn interner<K>(keys: usize) -> Interner<K> {
    Interner::with_capacity_and_hasher(keys, BuildHasherDefault::default())
}

/// Multiplies and rotates; several times as fast as the standard library's hash.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct CellHasher(u64);

impl Hasher for CellHasher {
    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 29)
    }

    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|&b| self.write_u64(u64::from(b)));
    }

    fn write_i32(&mut self, n: i32) {
        self.write_u64(u64::from(n as u32));
    }

    fn write_u64(&mut self, n: u64) {
        self.0 = (self.0.rotate_left(23) ^ n).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    }

    // Lengths of arrays say nothing.
    fn write_usize(&mut self, _: usize) {}
}

/// A point of a grid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct WeldCell(pub(crate) [i32; 3]);

impl std::hash::Hash for WeldCell {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.iter().for_each(|&c| state.write_i32(c));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_counted_as_they_come() {
        let mut interner = interner(1);
        let key = |i: i32| WeldCell([i % 50, i % 7, -(i % 3)]);
        let mut known: Vec<WeldCell> = Vec::new();
        for i in 0..2000 {
            let expected = known.iter().position(|&k| k == key(i)).unwrap_or_else(|| {
                known.push(key(i));
                known.len() - 1
            });
            assert_eq!(interner.insert_full(key(i)).0, expected);
        }
        assert_eq!(interner.len(), known.len());
    }
}
