//! Finding points that coincide, quickly.

use std::hash::{Hash, Hasher};

/// Counts different keys as they come. Its table holds numbers alone and so stays in the processor's cache, where a map
/// of the keys would not. Keys are grid cells that our own code made: nobody can choose them so that they collide.
#[derive(Debug)]
pub(crate) struct Census<K> {
    keys: Vec<K>,
    /// Numbers of keys by their hashes, each at the first free slot from its own; twice as many as keys at least.
    slots: Vec<u32>,
}

impl<K: Hash + Eq> Census<K> {
    const FREE: u32 = u32::MAX;

    /// With room for some keys before it must grow.
    pub(crate) fn with_room(keys: usize) -> Self {
        Self { keys: Vec::with_capacity(keys), slots: vec![Self::FREE; (2 * keys).next_power_of_two().max(16)] }
    }

    /// How many there are.
    pub(crate) fn len(&self) -> usize {
        self.keys.len()
    }

    /// The number of a key, which is new if it is that of the last.
    pub(crate) fn number(&mut self, key: K) -> u32 {
        if 2 * self.keys.len() >= self.slots.len() {
            self.grow();
        }
        let slot = self.slot(&key);
        if self.slots[slot] == Self::FREE {
            self.slots[slot] = self.keys.len() as u32;
            self.keys.push(key);
        }
        self.slots[slot]
    }

    /// Where a key is, or would be.
    fn slot(&self, key: &K) -> usize {
        let mut hasher = CellHasher::default();
        key.hash(&mut hasher);
        let last = self.slots.len() - 1;
        let mut slot = hasher.finish() as usize & last;
        while self.slots[slot] != Self::FREE && self.keys[self.slots[slot] as usize] != *key {
            slot = (slot + 1) & last;
        }
        slot
    }

    fn grow(&mut self) {
        self.slots = vec![Self::FREE; 2 * self.slots.len()];
        for number in 0..self.keys.len() {
            let slot = self.slot(&self.keys[number]);
            self.slots[slot] = number as u32;
        }
    }
}

/// Multiplies and rotates; several times as fast as the standard library's hash.
#[derive(Debug, Clone, Copy, Default)]
struct CellHasher(u64);

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
pub(crate) struct Cell(pub(crate) [i32; 3]);

impl std::hash::Hash for Cell {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.0.iter().for_each(|&c| state.write_i32(c));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_counted_as_they_come() {
        let mut census = Census::with_room(1);
        let key = |i: i32| Cell([i % 50, i % 7, -(i % 3)]);
        let mut known: Vec<Cell> = Vec::new();
        for i in 0..2000 {
            let expected = known.iter().position(|&k| k == key(i)).unwrap_or_else(|| {
                known.push(key(i));
                known.len() - 1
            });
            assert_eq!(census.number(key(i)) as usize, expected);
        }
        assert_eq!(census.len(), known.len());
    }
}
