//! The traversal stack: links still to visit, with the distance at which the ray enters them.

use super::node::Link;

const INLINE: usize = 96;

/// A stack that lives on the machine stack, and spills to the heap for very deep trees.
pub(super) struct Stack {
    entries: [u64; INLINE],
    len: usize,
    spill: Vec<u64>,
}

impl Stack {
    #[inline]
    pub(super) fn new() -> Self {
        Stack { entries: [0; INLINE], len: 0, spill: Vec::new() }
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// `tnear` must not be negative: then entries compare as their distances do.
    #[inline]
    pub(super) fn push(&mut self, link: Link, tnear: f32) {
        let entry = u64::from(tnear.to_bits()) << 32 | u64::from(link.0);
        if self.len < INLINE {
            self.entries[self.len] = entry;
        } else {
            self.push_spilled(entry);
        }
        self.len += 1;
    }

    /// The last entry, if more than `base` are left.
    #[inline]
    pub(super) fn pop(&mut self, base: usize) -> Option<(Link, f32)> {
        if self.len <= base {
            return None;
        }
        self.len -= 1;
        let entry = if self.len < INLINE { self.entries[self.len] } else { self.pop_spilled() };
        Some((Link(entry as u32), f32::from_bits((entry >> 32) as u32)))
    }

    /// Drops the entries from `base` on.
    #[inline]
    pub(super) fn truncate(&mut self, base: usize) {
        self.len = self.len.min(base);
        self.spill.truncate(self.len.saturating_sub(INLINE));
    }

    /// Sorts the entries from `base` on, so that the nearest is popped first.
    #[inline]
    pub(super) fn sort_from(&mut self, base: usize) {
        if self.len > INLINE {
            return; // Order is only a matter of speed.
        }
        for i in base + 1..self.len {
            let entry = self.entries[i];
            let mut j = i;
            while j > base && self.entries[j - 1] < entry {
                self.entries[j] = self.entries[j - 1];
                j -= 1;
            }
            self.entries[j] = entry;
        }
    }

    #[cold]
    fn push_spilled(&mut self, entry: u64) {
        self.spill.push(entry);
    }

    #[cold]
    fn pop_spilled(&mut self) -> u64 {
        self.spill.pop().unwrap_or_default()
    }
}
