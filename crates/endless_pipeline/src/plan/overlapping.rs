//! Sets of cameras that see the same street.

use super::subsets::{binomial, set_of_rank};

/// What two cameras see alike, as a share of what the one that sees less sees, to see the same street.
const SAME_STREET: f64 = 0.25;
/// Where no set has that, those are taken that have nearly as much as the best.
const NEARLY: f64 = 0.8;
/// Most sets that are looked through.
const MOST_SETS: u128 = 1 << 20;

/// The sets of cameras that see the same street, and how much they share.
pub(super) struct OverlappingSets {
    /// In lexicographic order; all there are if none hangs together.
    pub(super) sets: Vec<Vec<usize>>,
    /// Of the set that hangs together best, the weakest link.
    pub(super) best: f64,
}

/// Those of all sets of `k` cameras, given the places that each camera sees, ascending. `None` if there are too many.
pub(super) fn overlapping_sets(places: &[Vec<u32>], k: usize) -> Option<OverlappingSets> {
    let n = places.len();
    let count = binomial(n, k).filter(|count| *count <= MOST_SETS)?;
    let shared: Vec<Vec<f64>> = places.iter().map(|a| places.iter().map(|b| shared(a, b)).collect()).collect();
    let sets: Vec<Vec<usize>> = (0..count).map(|rank| set_of_rank(n, k, rank)).collect();
    let links: Vec<f64> = sets.iter().map(|set| weakest_link(set, &shared)).collect();
    let best = links.iter().copied().fold(0.0, f64::max);
    let least = if best >= SAME_STREET { SAME_STREET } else { NEARLY * best };
    let sets = sets.into_iter().zip(links).filter(|(_, link)| *link >= least).map(|(set, _)| set).collect();
    Some(OverlappingSets { sets, best })
}

/// How much of what the one of two cameras sees that sees less the other sees, too.
fn shared(a: &[u32], b: &[u32]) -> f64 {
    let both = a.iter().filter(|place| b.binary_search(place).is_ok()).count();
    both as f64 / a.len().min(b.len()).max(1) as f64
}

/// The most that each camera of a set shares at least with one that is linked to the others: the weakest link of the
/// strongest tree over them (Prim). One camera has no link to be weak.
fn weakest_link(set: &[usize], shared: &[Vec<f64>]) -> f64 {
    let Some((&first, rest)) = set.split_first() else { return 1.0 };
    let mut open: Vec<(usize, f64)> = rest.iter().map(|&camera| (camera, shared[first][camera])).collect();
    let mut weakest = 1.0f64;
    while let Some(next) = (0..open.len()).max_by(|&i, &j| open[i].1.total_cmp(&open[j].1)) {
        let (camera, link) = open.swap_remove(next);
        weakest = weakest.min(link);
        for (other, best) in &mut open {
            *best = best.max(shared[camera][*other]);
        }
    }
    weakest
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn cameras_of_one_junction_are_taken_together() {
        // A chain of three, one far away that sees much, and one that sees nothing.
        let places = [(0..10).collect(), (6..16).collect(), (12..20).collect(), (100..200).collect(), Vec::new()];
        assert_eq!(overlapping_sets(&places, 2).expect("few").sets, [[0, 1], [1, 2]]);
        assert_eq!(overlapping_sets(&places, 3).expect("few").sets, [[0, 1, 2]]);
        assert_eq!(overlapping_sets(&places, 1).expect("few").sets.len(), 5);
        // No four see the same: all sets are as good.
        assert_eq!(overlapping_sets(&places, 4).expect("few").sets.len(), 5);
    }

    #[test]
    fn where_little_is_shared_the_most_counts() {
        let places = [(0..100).collect(), (90..190).collect(), (180..290).collect(), (500..600).collect()];
        assert_eq!(overlapping_sets(&places, 2).expect("few").sets, [[0, 1], [1, 2]]);
        let places = [(0..100).collect(), (90..190).collect(), (187..290).collect()];
        assert_eq!(overlapping_sets(&places, 2).expect("few").sets, [[0, 1]]);
    }

    #[test]
    fn more_sets_than_can_be_looked_through_are_refused() {
        assert!(overlapping_sets(&vec![Vec::new(); 99], 8).is_none());
    }

    proptest! {
        /// The weakest link is the largest share by whose links one comes from each camera to each other.
        #[test]
        fn a_set_hangs_together_by_its_weakest_link(
            values in prop::collection::vec(0.0f64..1.0, 36), k in 2usize..7,
        ) {
            let shared: Vec<Vec<f64>> =
                (0..6).map(|i| (0..6usize).map(|j| values[6 * i.min(j) + i.max(j)]).collect()).collect();
            let set: Vec<usize> = (0..k.min(6)).collect();
            let reached = |least: f64| {
                let mut reached = vec![set[0]];
                for _ in &set {
                    let next = set.iter().filter(|i| reached.iter().any(|j| shared[**i][*j] >= least));
                    let next: Vec<usize> = next.copied().filter(|i| !reached.contains(i)).collect();
                    reached.extend(next);
                }
                reached.len()
            };
            let weakest = weakest_link(&set, &shared);
            prop_assert_eq!(reached(weakest), set.len());
            prop_assert!(reached(weakest + 1e-9) < set.len());
        }
    }
}
