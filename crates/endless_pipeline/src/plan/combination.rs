//! All combinations of map, weather, time of day and cameras, numbered and made on demand.

use super::balanced::Places;
use super::overlapping::{OverlappingSets, overlapping_sets};
use super::subsets::{binomial, set_of_rank};
use crate::{PlanError, rig::RigPlaces};
use endless_dataset::Recipe;
use endless_world::{CameraSite, PerVideo, Stream, TimeOfDay, Weather};
use std::collections::BTreeMap;

/// A map and the cameras that can film it.
pub(super) struct MapSites {
    pub(super) map: String,
    pub(super) sites: Vec<CameraSite>,
    /// The places that each sees, where sets of cameras are to overlap.
    pub(super) places: Option<Vec<Vec<u32>>>,
    /// Where the sensors of the rig are.
    pub(super) rig: RigPlaces,
}

/// One element of the product.
pub(super) struct Combination<'a> {
    pub(super) map: &'a str,
    pub(super) weather: Weather,
    pub(super) time_of_day: TimeOfDay,
    /// Distinct, in the map's order.
    pub(super) sites: Vec<&'a CameraSite>,
    /// Where the sensors of the rig are.
    pub(super) rig: &'a RigPlaces,
}

/// The product of a recipe's maps, weathers, times of day and sets of cameras.
pub(super) struct Combinations<'a> {
    recipe: &'a Recipe,
    maps: &'a [MapSites],
    /// Of each map.
    camera_sets: Vec<CameraSets>,
    count: u128,
}

/// The sets of cameras of one map, in lexicographic order.
enum CameraSets {
    /// All of so many.
    All(u128),
    /// One without cameras: they are drawn for each video.
    Drawn,
    /// Those that see the same street.
    Overlapping(Vec<Vec<usize>>),
}

impl CameraSets {
    /// Of so many cameras each; `None` where there are too many.
    fn new(map: &MapSites, cameras: usize) -> Option<Self> {
        Some(match &map.places {
            Some(places) => {
                let OverlappingSets { sets, best } = overlapping_sets(places, cameras)?;
                if best == 0.0 {
                    tracing::warn!("no {cameras} cameras of {} see the same street: any are taken", map.map);
                }
                Self::Overlapping(sets)
            }
            None => Self::All(binomial(map.sites.len(), cameras)?),
        })
    }

    fn count(&self) -> u128 {
        match self {
            Self::All(count) => *count,
            Self::Drawn => 1,
            Self::Overlapping(sets) => sets.len() as u128,
        }
    }
}

impl<'a> Combinations<'a> {
    /// # Errors
    /// When a map has fewer cameras than a scene needs, or more than sets of them can be counted.
    pub(super) fn new(recipe: &'a Recipe, maps: &'a [MapSites]) -> Result<Self, PlanError> {
        let wanted = recipe.cameras_per_scene as usize;
        let conditions = (recipe.weathers.len() * recipe.times.len()) as u128;
        let mut camera_sets = Vec::with_capacity(maps.len());
        let mut count = 0u128;
        for of_map in maps {
            let MapSites { map, sites, .. } = of_map;
            if recipe.sites == PerVideo::Drawn {
                camera_sets.push(CameraSets::Drawn);
                count += conditions;
                continue;
            }
            if sites.len() < wanted {
                return Err(PlanError::FewCameras { map: map.clone(), cameras: sites.len(), wanted });
            }
            let sets = CameraSets::new(of_map, wanted);
            let all = sets.as_ref().and_then(|sets| sets.count().checked_mul(conditions));
            let (Some(sets), Some(total)) = (sets, all.and_then(|n| count.checked_add(n))) else {
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
        self.camera_sets[map].count()
    }

    /// The combination of values by their places in the recipe's lists, and of the map's cameras by the place of their
    /// set in lexicographic order.
    pub(super) fn of(&self, Places { map, weather, time_of_day }: Places, set: u128) -> Combination<'a> {
        let Recipe { weathers, times, cameras_per_scene, .. } = self.recipe;
        let MapSites { map: name, sites, rig, .. } = &self.maps[map];
        let set = match &self.camera_sets[map] {
            CameraSets::All(_) => set_of_rank(sites.len(), *cameras_per_scene as usize, set),
            CameraSets::Drawn => Vec::new(),
            CameraSets::Overlapping(sets) => sets[set as usize].clone(),
        };
        Combination {
            map: name,
            weather: weathers[weather],
            time_of_day: times[time_of_day],
            sites: set.into_iter().map(|i| &sites[i]).collect(),
            rig,
        }
    }

    /// The combination of a number below [`Self::count`]: by map, weather, time of day, and cameras in lexicographic order.
    pub(super) fn get(&self, number: u128) -> Combination<'a> {
        let times = self.recipe.times.len();
        let mut rest = number;
        for (map, sets) in self.camera_sets.iter().enumerate() {
            let sets = sets.count();
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

    proptest! {
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
