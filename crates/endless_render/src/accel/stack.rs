//! The traversal stack: links still to visit, with the distance at which the ray enters them.

use super::node::NodeLink;

const INLINE: usize = 96;

/// A link that waits to be visited: nearer ones are less.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct PendingNode(u64);

impl PendingNode {
    pub(super) const NOTHING: Self = Self(u64::MAX);

    /// `tnear` must not be negative: then its bits compare as distances do.
    #[inline(always)]
    pub(super) fn new(link: NodeLink, tnear: f32) -> Self {
        Self(u64::from(tnear.to_bits()) << 32 | u64::from(link.0))
    }

    #[inline(always)]
    pub(super) fn parts(self) -> (NodeLink, f32) {
        (NodeLink(self.0 as u32), f32::from_bits((self.0 >> 32) as u32))
    }
}

/// A stack that lives on the machine stack, and spills to the heap for very deep trees.
pub(super) struct Stack {
    entries: [PendingNode; INLINE],
    len: usize,
    spill: Vec<PendingNode>,
}

impl Stack {
    #[inline]
    pub(super) fn new() -> Self {
        Stack { entries: [PendingNode(0); INLINE], len: 0, spill: Vec::new() }
    }

    #[inline]
    pub(super) fn len(&self) -> usize {
        self.len
    }

    #[inline]
    pub(super) fn push(&mut self, entry: PendingNode) {
        if self.len < INLINE {
            self.entries[self.len] = entry;
        } else {
            self.push_spilled(entry);
        }
        self.len += 1;
    }

    /// `push`, unless there is nothing to wait.
    #[inline(always)]
    pub(super) fn push_any(&mut self, entry: PendingNode) {
        if self.len < INLINE {
            self.entries[self.len] = entry;
            self.len += usize::from(entry != PendingNode::NOTHING);
        } else if entry != PendingNode::NOTHING {
            self.push_spilled(entry);
            self.len += 1;
        }
    }

    /// The last entry, if more than `base` are left.
    #[inline]
    pub(super) fn pop(&mut self, base: usize) -> Option<PendingNode> {
        if self.len <= base {
            return None;
        }
        self.len -= 1;
        Some(if self.len < INLINE { self.entries[self.len] } else { self.pop_spilled() })
    }

    /// Drops the entries from `base` on.
    #[inline]
    pub(super) fn truncate(&mut self, base: usize) {
        self.len = self.len.min(base);
        self.spill.truncate(self.len.saturating_sub(INLINE));
    }

    #[cold]
    fn push_spilled(&mut self, entry: PendingNode) {
        self.spill.push(entry);
    }

    #[cold]
    fn pop_spilled(&mut self) -> PendingNode {
        self.spill.pop().unwrap_or(PendingNode(0))
    }
}

/// The two nearest of some children, while the others wait on the stack in any order: sorting them all takes longer than
/// it saves.
pub(super) struct NearestChildren {
    pub(super) first: PendingNode,
    pub(super) second: PendingNode,
}

impl NearestChildren {
    pub(super) const NONE: Self = Self { first: PendingNode::NOTHING, second: PendingNode::NOTHING };

    #[inline(always)]
    pub(super) fn of(a: PendingNode, b: PendingNode) -> Self {
        Self { first: a.min(b), second: a.max(b) }
    }

    /// Takes one more, and gives back the one that is not among the two nearest.
    #[inline(always)]
    pub(super) fn keep(&mut self, child: PendingNode) -> PendingNode {
        let farthest = self.second.max(child);
        *self = Self::of(self.first, self.second.min(child));
        farthest
    }
}
