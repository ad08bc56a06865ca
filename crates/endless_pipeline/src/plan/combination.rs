//! All combinations of map, weather, time of day and cameras, numbered and made on demand.

use super::balanced::Places;
use crate::PlanError;
use endless_dataset::Recipe;
use endless_world::{CameraSite, Stream, TimeOfDay, Weather};
use std::collections::BTreeMap;

/// A map and the cameras that can film it.
pub(super) struct MapSites {
    pub(super) map: String,
    pub(super) sites: Vec<CameraSite>,
}

/// One element of the product.
pub(super) struct Combination<'a> {
    pub(super) map: &'a str,
    pub(super) weather: Weather,
    pub(super) time_of_day: TimeOfDay,
    /// Distinct, in the map's order.
    pub(super) sites: Vec<&'a CameraSite>,
}

/// The product of a recipe's maps, weathers, times of day and sets of cameras.
pub(super) struct Combinations<'a> {
    recipe: &'a Recipe,
    maps: &'a [MapSites],
    /// How many sets of cameras each map has.
    camera_sets: Vec<u128>,
    count: u128,
}

impl<'a> Combinations<'a> {
    /// # Errors
    /// When a map has fewer cameras than a scene needs, or more than sets of them can be counted.
    pub(super) fn new(recipe: &'a Recipe, maps: &'a [MapSites]) -> Result<Self, PlanError> {
        let wanted = recipe.cameras_per_scene as usize;
        let conditions = (recipe.weathers.len() * recipe.times.len()) as u128;
        let mut camera_sets = Vec::with_capacity(maps.len());
        let mut count = 0u128;
        for MapSites { map, sites } in maps {
            if sites.len() < wanted {
                return Err(PlanError::FewCameras { map: map.clone(), cameras: sites.len(), wanted });
            }
            let sets = binomial(sites.len(), wanted);
            let total = sets.and_then(|sets| sets.checked_mul(conditions)).and_then(|n| count.checked_add(n));
            let (Some(sets), Some(total)) = (sets, total) else {
                return Err(PlanError::ManyCameras { map: map.clone(), cameras: sites.len() });
            };
            camera_sets.push(sets);
            count = total;
        }
        Ok(Self { recipe, maps, camera_sets, count })
    }

    /// How many there are.
    pub(super) fn count(&self) -> u128 {
        self.count
    }

    /// How many sets of cameras a map has, by its place.
    pub(super) fn camera_sets(&self, map: usize) -> u128 {
        self.camera_sets[map]
    }

    /// The combination of values by their places in the recipe's lists, and of the map's cameras by the place of their
    /// set in lexicographic order.
    pub(super) fn of(&self, Places { map, weather, time_of_day }: Places, set: u128) -> Combination<'a> {
        let Recipe { weathers, times, cameras_per_scene, .. } = self.recipe;
        let MapSites { map, sites } = &self.maps[map];
        let set = set_of_rank(sites.len(), *cameras_per_scene as usize, set);
        Combination {
            map,
            weather: weathers[weather],
            time_of_day: times[time_of_day],
            sites: set.into_iter().map(|i| &sites[i]).collect(),
        }
    }

    /// The combination of a number below [`Self::count`]: by map, weather, time of day, and cameras in lexicographic order.
    pub(super) fn get(&self, number: u128) -> Combination<'a> {
        let times = self.recipe.times.len();
        let mut rest = number;
        for (map, &sets) in self.camera_sets.iter().enumerate() {
            let of_map = sets * (self.recipe.weathers.len() * times) as u128;
            if rest >= of_map {
                rest -= of_map;
                continue;
            }
            let condition = (rest / sets) as usize;
            return self.of(Places { map, weather: condition / times, time_of_day: condition % times }, rest % sets);
        }
        unreachable!("{number} is below the number of combinations")
    }
}

/// How many sets of `k` there are among `n`; `None` where no 128 bits can hold it.
fn binomial(n: usize, k: usize) -> Option<u128> {
    // Every step is a binomial itself, so that the division leaves nothing.
    (0..k).try_fold(1u128, |c, i| Some(c.checked_mul(n.saturating_sub(i) as u128)? / (i as u128 + 1)))
}

/// The set of `k` of `0..n` with this place in the lexicographic order of all of them.
fn set_of_rank(n: usize, k: usize, mut rank: u128) -> Vec<usize> {
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

/// Up to here all numbers are laid out and shuffled, above it only those that come out: the list of 16 million takes
/// 64 MB.
const LAID_OUT: u128 = 1 << 24;

/// The numbers below `count` in a random order.
pub(super) fn shuffled(count: u128, mut random: Stream) -> Box<dyn Iterator<Item = u128>> {
    if count > LAID_OUT {
        return Box::new(SparseShuffle::new(count, random));
    }
    let mut order: Vec<u32> = (0..count as u32).collect();
    random.shuffle(&mut order);
    Box::new(order.into_iter().map(u128::from))
}

/// Fisher and Yates's shuffle from the front, of a list of which only what was moved is kept.
pub(super) struct SparseShuffle {
    count: u128,
    next: u128,
    moved: BTreeMap<u128, u128>,
    random: Stream,
}

impl SparseShuffle {
    /// Of the numbers below `count`.
    pub(super) fn new(count: u128, random: Stream) -> Self {
        Self { count, next: 0, moved: BTreeMap::new(), random }
    }
}

impl Iterator for SparseShuffle {
    type Item = u128;

    fn next(&mut self) -> Option<u128> {
        if self.next == self.count {
            return None;
        }
        let here = self.next;
        self.next += 1;
        let chosen = here + below(&mut self.random, self.count - here);
        let own = self.moved.remove(&here).unwrap_or(here);
        if chosen == here { Some(own) } else { Some(self.moved.insert(chosen, own).unwrap_or(chosen)) }
    }
}

/// Uniform in `0..n`: draws as many bits as `n` has until they are below it.
fn below(random: &mut Stream, n: u128) -> u128 {
    let bits = u128::MAX >> (n - 1).leading_zeros().min(127);
    loop {
        let drawn = (u128::from(random.next_u64()) << 64 | u128::from(random.next_u64())) & bits;
        if drawn < n {
            return drawn;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

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

        #[test]
        fn a_sparse_shuffle_gives_every_number_once(count in 1u128..300, seed: u64) {
            let order: Vec<u128> = SparseShuffle::new(count, Stream::named(seed, "test", &[])).collect();
            prop_assert_eq!(order.iter().copied().collect::<BTreeSet<_>>(), (0..count).collect());
            prop_assert_eq!(order.len() as u128, count);
        }

        #[test]
        fn astronomically_many_are_shuffled_at_once(bits in 25u32..127, seed: u64) {
            let count = 1u128 << bits;
            let first: Vec<u128> = shuffled(count, Stream::named(seed, "test", &[])).take(100).collect();
            prop_assert!(first.iter().all(|n| *n < count));
            prop_assert!(first.iter().max() > Some(&(count / 2)), "a hundred draws reach the upper half");
            let distinct = first.iter().collect::<BTreeSet<_>>().len();
            prop_assert_eq!(distinct, 100);
        }
    }
}
