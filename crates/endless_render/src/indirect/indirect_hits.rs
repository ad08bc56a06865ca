//! Where the indirect rays of a camera's bake end, which depends on the scene, the camera and the pattern of rays alone: it
//! is the same in every weather, at every time of day and in every video.

use super::hit_tape::{HitTape, RayEnd};

/// Bounces of the light that probes gather.
pub(crate) const PROBE_BOUNCES: usize = 2;

/// The ends of all indirect rays of a bake.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct IndirectHits {
    /// Of probes, by bounce and probe.
    pub(crate) probes: [TapeStack; PROBE_BOUNCES],
    /// Of points on a grid, by row.
    pub(crate) points: TapeStack,
    /// Of samples at edges, by block.
    pub(crate) edges: TapeStack,
}

impl IndirectHits {
    /// Memory taken, bytes.
    pub fn memory_bytes(&self) -> usize {
        self.stacks().map(TapeStack::memory_bytes).sum()
    }

    /// As little-endian numbers: of each stack the number of tapes and of ends, where the tapes begin, and the ends.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.memory_bytes() + 64);
        for TapeStack { ends, starts } in self.stacks() {
            bytes.extend([starts.len(), ends.len()].map(|count| (count as u64).to_le_bytes()).as_flattened());
            bytes.extend(starts.iter().flat_map(|start| start.to_le_bytes()));
            bytes.extend(ends.iter().flat_map(|end| [end.instance, end.triangle]).flat_map(u32::to_le_bytes));
        }
        bytes
    }

    /// What [`Self::to_bytes`] wrote; `None` if it is anything else.
    pub fn from_bytes(mut bytes: &[u8]) -> Option<Self> {
        let mut stack = || TapeStack::read(&mut bytes);
        let hits = Self { probes: [stack()?, stack()?], points: stack()?, edges: stack()? };
        bytes.is_empty().then_some(hits)
    }

    fn stacks(&self) -> impl Iterator<Item = &TapeStack> {
        self.probes.iter().chain([&self.points, &self.edges])
    }
}

/// Tapes that are used side by side, one after the other in one list.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct TapeStack {
    ends: Vec<RayEnd>,
    /// Where each tape begins, and where the last one ends.
    starts: Vec<u32>,
}

impl TapeStack {
    /// Without tapes.
    pub(crate) const EMPTY: Self = Self { ends: Vec::new(), starts: Vec::new() };

    /// Of what tapes recorded.
    pub(crate) fn new(tapes: Vec<Vec<RayEnd>>) -> Self {
        let mut stack = Self { ends: Vec::with_capacity(tapes.iter().map(Vec::len).sum()), starts: vec![0] };
        for tape in tapes {
            stack.ends.extend(tape);
            stack.starts.push(stack.ends.len() as u32);
        }
        stack
    }

    /// One of the tapes; an empty one if there is no such.
    fn tape(&self, number: usize) -> &[RayEnd] {
        let Some(&[start, end]) = self.starts.get(number..number + 2).and_then(|pair| pair.first_chunk()) else {
            return &[];
        };
        self.ends.get(start as usize..end as usize).unwrap_or(&[])
    }

    /// Takes a stack from the front of some bytes.
    fn read(bytes: &mut &[u8]) -> Option<Self> {
        let mut count = || Some(u64::from_le_bytes(*take(bytes, 8)?.first_chunk()?));
        let (starts, ends) = (count()?, count()?);
        let mut numbers = |count: u64| {
            let taken = take(bytes, usize::try_from(count.checked_mul(4)?).ok()?)?;
            Some(taken.as_chunks().0.iter().map(|number| u32::from_le_bytes(*number)))
        };
        let starts = numbers(starts)?.collect();
        let ends: Vec<u32> = numbers(ends.checked_mul(2)?)?.collect();
        let end = |&[instance, triangle]: &[u32; 2]| RayEnd { instance, triangle };
        Some(Self { starts, ends: ends.as_chunks().0.iter().map(end).collect() })
    }

    fn memory_bytes(&self) -> usize {
        size_of_val(&self.ends[..]) + size_of_val(&self.starts[..])
    }
}

/// What a bake does with the ends of its indirect rays.
#[derive(Debug, Clone, Copy)]
pub(crate) enum IndirectRays<'a> {
    /// Traces them.
    Trace,
    /// Traces them, and keeps where they end.
    Record,
    /// Reads where they end.
    Replay(&'a IndirectHits),
}

impl<'a> IndirectRays<'a> {
    /// The tape of a number in one of the stacks.
    pub(crate) fn tape(self, stack: impl FnOnce(&'a IndirectHits) -> &'a TapeStack, number: usize) -> HitTape<'a> {
        match self {
            Self::Trace => HitTape::Traced,
            Self::Record => HitTape::Recorded(Vec::new()),
            Self::Replay(hits) => HitTape::Replayed(stack(hits).tape(number).iter()),
        }
    }
}

/// The first of some bytes, which are then without them.
fn take<'b>(bytes: &mut &'b [u8], count: usize) -> Option<&'b [u8]> {
    let (taken, rest) = bytes.split_at_checked(count)?;
    *bytes = rest;
    Some(taken)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn stack() -> BoxedStrategy<TapeStack> {
        let end = (any::<u32>(), any::<u32>()).prop_map(|(instance, triangle)| RayEnd { instance, triangle });
        prop::collection::vec(prop::collection::vec(end, 0..9), 0..9).prop_map(TapeStack::new).boxed()
    }

    proptest! {
        #[test]
        fn what_is_written_is_read(first in stack(), second in stack(), points in stack(), edges in stack()) {
            let hits = IndirectHits { probes: [first, second], points, edges };
            let bytes = hits.to_bytes();
            prop_assert_eq!(IndirectHits::from_bytes(&bytes), Some(hits));
            prop_assert_eq!(IndirectHits::from_bytes(&bytes[..bytes.len() - 1]), None);
        }

        #[test]
        fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(prop_oneof![Just(0u8), any::<u8>()], 0..200)) {
            let read = IndirectHits::from_bytes(&bytes);
            let tapes = |hits: &IndirectHits| (0..4).map(|number| hits.edges.tape(number).len()).sum::<usize>();
            prop_assert!(read.is_none_or(|hits| hits.to_bytes() == bytes && tapes(&hits) <= bytes.len()));
        }
    }
}
