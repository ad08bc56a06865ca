//! Sets of some of many things, in lexicographic order.

/// How many sets of `k` there are among `n`; `None` where no 128 bits can hold it.
pub(super) fn binomial(n: usize, k: usize) -> Option<u128> {
    // Every step is a binomial itself, so that the division leaves nothing.
    (0..k).try_fold(1u128, |c, i| Some(c.checked_mul(n.saturating_sub(i) as u128)? / (i as u128 + 1)))
}

/// The set of `k` of `0..n` with this place in the lexicographic order of all of them.
pub(super) fn set_of_rank(n: usize, k: usize, mut rank: u128) -> Vec<usize> {
    let mut set = Vec::with_capacity(k);
    let mut next = 0;
    while set.len() < k {
        // So many sets go on with `next`.
        let with_next = binomial(n - next - 1, k - set.len() - 1).expect("fewer than the sets that were counted");
        if rank < with_next {
            set.push(next);
        } else {
            rank -= with_next;
        }
        next += 1;
    }
    set
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn sets_are_counted() {
        assert_eq!(binomial(10, 2), Some(45));
        assert_eq!(binomial(99, 8), Some(171_200_862_756));
        assert_eq!(binomial(3, 4), Some(0));
        assert_eq!(binomial(usize::MAX, 8), None);
    }

    proptest! {
        #[test]
        fn ranks_are_places_in_the_lexicographic_order(n in 1usize..11, k in 1usize..9) {
            let all: Vec<Vec<usize>> =
                (0..binomial(n, k).expect("few")).map(|rank| set_of_rank(n, k, rank)).collect();
            prop_assert!(all.iter().all(|set| set.len() == k && set.is_sorted_by(|a, b| a < b) && set[k - 1] < n));
            prop_assert!(all.is_sorted_by(|a, b| a < b));
        }
    }
}
