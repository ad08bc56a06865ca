//! Cuts a list in contiguous pieces whose largest cost is as small as can be.
//!
//! The list comes in groups (videos of one map), and every piece pays once for each group that it has any of. So a cut
//! within a group costs more than one between two. Where several ways of cutting have the same largest cost, the one
//! counts that divides the fewest groups, and then the one whose parts of a divided group are most alike.

use std::ops::Range;

/// A list in groups that follow one another.
#[derive(Debug)]
pub(super) struct Costs {
    /// Of all before each place.
    before: Vec<u64>,
    /// Where the group of each place ends.
    group_end: Vec<usize>,
    /// Where groups begin and end.
    bounds: Vec<usize>,
    /// Of each group in a piece.
    group: u64,
}

impl Costs {
    /// Costs of all elements by group, and what each group costs a piece besides.
    pub(super) fn new(groups: &[Vec<u64>], group: u64) -> Self {
        let (mut before, mut bounds, mut group_end) = (vec![0u64], vec![0], Vec::new());
        for costs in groups.iter().filter(|costs| !costs.is_empty()) {
            let end = group_end.len() + costs.len();
            for cost in costs {
                before.push(before[before.len() - 1].saturating_add(*cost));
                group_end.push(end);
            }
            bounds.push(end);
        }
        Self { before, group_end, bounds, group }
    }

    fn len(&self) -> usize {
        self.group_end.len()
    }

    /// The largest end of a piece that begins here and costs no more than this; the same place if nothing fits.
    fn reach(&self, from: usize, limit: u64) -> usize {
        let (mut place, mut loads) = (from, 0u64);
        while place < self.len() {
            loads = loads.saturating_add(self.group);
            let Some(room) = limit.checked_sub(loads) else { break };
            let most = self.before[from].saturating_add(room);
            let end = self.group_end[place];
            let fits = place + self.before[place + 1..=end].partition_point(|sum| *sum <= most);
            place = fits;
            if fits < end {
                break;
            }
        }
        place
    }

    /// How many pieces of at most this cost a range takes; none if it takes more than so many.
    fn pieces(&self, range: Range<usize>, limit: u64, most: usize) -> Option<usize> {
        let (mut place, mut count) = (range.start, 0);
        while place < range.end {
            let end = self.reach(place, limit);
            if end == place || count == most {
                return None;
            }
            (place, count) = (end, count + 1);
        }
        Some(count)
    }

    /// The least cost with which a range can be cut in so many pieces.
    fn least_largest(&self, range: &Range<usize>, pieces: usize) -> u64 {
        let groups = self.bounds.len() as u64;
        let all = self.before[range.end] - self.before[range.start];
        let (mut too_little, mut enough) = (0, all.saturating_add(groups.saturating_mul(self.group)));
        while too_little + 1 < enough {
            let middle = too_little + (enough - too_little) / 2;
            match self.pieces(range.clone(), middle, pieces) {
                Some(_) => enough = middle,
                None => too_little = middle,
            }
        }
        enough
    }

    /// Cuts a range greedily in pieces of at most this cost.
    fn cut_at(&self, range: Range<usize>, limit: u64, into: &mut Vec<Range<usize>>) {
        let mut place = range.start;
        while place < range.end {
            let end = self.reach(place, limit).min(range.end);
            into.push(place..end);
            place = end;
        }
    }

    /// Cuts the list in so many pieces, of which the last may be empty.
    pub(super) fn cut(&self, pieces: usize) -> Vec<Range<usize>> {
        let whole = 0..self.len();
        let mut cut = Vec::new();
        if !whole.is_empty() {
            let limit = self.least_largest(&whole, pieces);
            for (range, count) in self.segments(limit, pieces) {
                let own_limit = self.least_largest(&range, count);
                self.cut_at(range, own_limit, &mut cut);
            }
        }
        cut.resize(pieces.max(cut.len()), whole.end..whole.end);
        cut
    }

    /// Ranges between the bounds of groups at which it is cut, and the pieces of each, such that the fewest cuts lie
    /// within groups: with `s` segments of `p` pieces in all these are `p - s`.
    fn segments(&self, limit: u64, most: usize) -> Vec<(Range<usize>, usize)> {
        // Pieces that are of use: more than one an element never are.
        let most = most.min(self.len());
        // By bound: what is known with so few cuts within groups; pieces, and the bound before.
        let mut known: Vec<Vec<Way>> = vec![vec![Way { divided: 0, pieces: 0, from: 0, back: 0 }]];
        for end in 1..self.bounds.len() {
            let mut ways: Vec<Way> = Vec::new();
            for from in 0..end {
                let range = self.bounds[from]..self.bounds[end];
                let Some(pieces) = self.pieces(range, limit, most) else { continue };
                let next = known[from].iter().enumerate().map(|(back, way)| Way {
                    divided: way.divided + pieces - 1,
                    pieces: way.pieces + pieces,
                    from,
                    back,
                });
                ways.extend(next.filter(|way| way.pieces <= most));
            }
            // Of those with as few pieces and as few cuts only one is of use.
            ways.sort_by_key(|way| (way.divided, way.pieces, way.from));
            let mut fewest = usize::MAX;
            ways.retain(|way| {
                let useful = way.pieces < fewest;
                fewest = fewest.min(way.pieces);
                useful
            });
            known.push(ways);
        }
        let mut segments = Vec::new();
        let (mut end, mut place) = (self.bounds.len() - 1, 0);
        while end > 0 {
            let way = &known[end][place];
            let range = self.bounds[way.from]..self.bounds[end];
            let pieces = way.pieces - known[way.from][way.back].pieces;
            segments.push((range, pieces));
            (end, place) = (way.from, way.back);
        }
        segments.reverse();
        segments
    }
}

/// A way to cut all before the bound of a group.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// Cuts within groups.
    divided: usize,
    /// Pieces in all.
    pieces: usize,
    /// The bound at which the last segment begins.
    from: usize,
    /// Which way led there.
    back: usize,
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn cost_of(groups: &[Vec<u64>], group: u64, range: &Range<usize>) -> u64 {
        let (mut at, mut cost) = (0, 0);
        for costs in groups {
            let own: Vec<u64> = (at..).zip(costs).filter(|(place, _)| range.contains(place)).map(|(_, c)| *c).collect();
            cost += own.iter().sum::<u64>() + if own.is_empty() { 0 } else { group };
            at += costs.len();
        }
        cost
    }

    fn divided(groups: &[Vec<u64>], cut: &[Range<usize>]) -> usize {
        let bounds: Vec<usize> = groups
            .iter()
            .scan(0, |at, costs| {
                *at += costs.len();
                Some(*at)
            })
            .collect();
        cut.iter().filter(|piece| !piece.is_empty() && !bounds.contains(&piece.end)).count()
    }

    /// All ways to cut `len` in at most so many pieces.
    fn every_cut(len: usize, pieces: usize) -> Vec<Vec<Range<usize>>> {
        let mut all = Vec::new();
        for cuts in 0u32..1 << (len - 1) {
            if cuts.count_ones() as usize >= pieces {
                continue;
            }
            let ends = (1..len).filter(|place| cuts & (1 << (place - 1)) != 0).chain([len]);
            let mut from = 0;
            all.push(ends.map(|end| std::mem::replace(&mut from, end)..end).collect());
        }
        all
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(256))]

        #[test]
        fn no_other_way_of_cutting_is_better(
            groups in prop::collection::vec(prop::collection::vec(1u64..30, 0..4), 1..5), group in 0u64..40, pieces in 1usize..7,
        ) {
            let cut = Costs::new(&groups, group).cut(pieces);
            let len = groups.iter().map(Vec::len).sum();
            prop_assert_eq!(cut.len(), pieces);
            prop_assert!(cut.windows(2).all(|pair| pair[0].end == pair[1].start), "in order, without gaps");
            prop_assert_eq!((cut[0].start, cut[pieces - 1].end), (0, len));
            if len > 0 {
                let of = |cut: &Vec<Range<usize>>| {
                    let largest = cut.iter().map(|piece| cost_of(&groups, group, piece)).max();
                    (largest.expect("pieces"), divided(&groups, cut))
                };
                let best = every_cut(len, pieces).iter().map(of).min().expect("at least one");
                prop_assert_eq!(of(&cut), best);
            }
        }

        #[test]
        fn thousands_are_cut_at_once(len in 1000usize..5000, pieces in 1usize..300, seed: u64) {
            let cost = |i: usize| 1 + (seed ^ i as u64).wrapping_mul(0x9e37_79b9_7f4a_7c15) % 1000;
            let groups: Vec<Vec<u64>> = (0..10).map(|g| (0..len / 10).map(|i| cost(g * len + i)).collect()).collect();
            let cut = Costs::new(&groups, 500).cut(pieces);
            let largest = cut.iter().map(|piece| cost_of(&groups, 500, piece)).max().expect("pieces");
            let all: u64 = groups.iter().flatten().sum();
            prop_assert!(largest <= all / pieces as u64 + 1000 + 500 * 10, "{largest} of {all} in {pieces}");
        }
    }

    #[test]
    fn whole_groups_stay_together_where_that_costs_nothing() {
        let cut = |groups: &[Vec<u64>], pieces| Costs::new(groups, 5).cut(pieces);
        assert_eq!(cut(&[vec![10, 10], vec![10, 10], vec![10, 10]], 3), [0..2, 2..4, 4..6]);
        // Nothing is won by dividing the second while the first cannot be.
        assert_eq!(cut(&[vec![100], vec![10, 10], vec![10]], 3), [0..1, 1..4, 4..4]);
        assert_eq!(cut(&[], 2), [0..0, 0..0]);
        assert_eq!(cut(&[vec![1; 4]], 6), [0..1, 1..2, 2..3, 3..4, 4..4, 4..4]);
    }
}
