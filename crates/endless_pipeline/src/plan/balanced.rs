//! Videos in which every map, every weather and every time of day comes equally often, whatever their number.
//!
//! Counts that differ by at most one after every video mean that each list is told in rounds: all its values, then all of
//! them again. What is free is how the rounds of the three lists lie beside each other. Here, as in a Latin square, each
//! round of a list is the one before it, shifted where the lists would fall into step, so that all combinations of the
//! three come up once before one comes again.

use endless_world::Stream;

/// Places in the lists of maps, weathers and times of day.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Places {
    pub(super) map: usize,
    pub(super) weather: usize,
    pub(super) time_of_day: usize,
}

/// The endless list of them.
pub(super) struct Balanced {
    seed: u64,
    /// Lengths of the three lists.
    maps: usize,
    weathers: usize,
    times: usize,
    /// By how much each round of times is shifted, in the videos of all pairs of map and weather.
    time_shifts: Vec<usize>,
    /// Which values are meant by the places of this cycle.
    names: [Vec<usize>; 3],
    video: usize,
}

impl Balanced {
    /// Of lists of these lengths, none empty.
    pub(super) fn new([maps, weathers, times]: [usize; 3], seed: u64) -> Self {
        let names = [Vec::new(), Vec::new(), Vec::new()];
        let mut balanced = Self { seed, maps, weathers, times, time_shifts: Vec::new(), names, video: 0 };
        if (maps * weathers).is_multiple_of(times) {
            balanced.time_shifts = balanced.shifts_of_times();
        }
        balanced
    }

    /// How many combinations of the three there are: a cycle of as many videos has each once.
    fn combinations(&self) -> usize {
        self.maps * self.weathers * self.times
    }

    /// The weather of a video in the cycle: every pair of map and weather comes once in `maps × weathers` videos. Where
    /// both lists are through at once, the next round of weathers begins one later.
    fn weather(&self, video: usize) -> usize {
        let together = greatest_common_divisor(self.maps, self.weathers);
        let both_through = self.maps / together * self.weathers;
        (video + video / both_through % together) % self.weathers
    }

    /// The time of day of a video in the cycle.
    fn time_of_day(&self, video: usize) -> usize {
        let pairs = self.maps * self.weathers;
        let shift = if self.time_shifts.is_empty() {
            let together = greatest_common_divisor(pairs, self.times);
            video / (pairs / together * self.times)
        } else {
            self.time_shifts[video % pairs / self.times] + video / pairs
        };
        (video + shift) % self.times
    }

    /// Each round of times is shifted such that the maps and weathers beside it have had those times least often.
    fn shifts_of_times(&self) -> Vec<usize> {
        let (maps, weathers, times) = (self.maps, self.weathers, self.times);
        let mut with_map = vec![0; maps * times];
        let mut with_weather = vec![0; weathers * times];
        let rounds = (0..maps * weathers).step_by(times);
        let least = rounds.map(|first| {
            let pairs = |shift: usize| {
                (first..first + times).map(move |video| {
                    let time = (video + shift) % times;
                    (video % maps * times + time, self.weather(video) * times + time)
                })
            };
            let had = |shift: &usize| pairs(*shift).map(|(m, w)| with_map[m] + with_weather[w]).sum::<u32>();
            let shift = (0..times).min_by_key(had).expect("a list has a value");
            for (m, w) in pairs(shift) {
                with_map[m] += 1;
                with_weather[w] += 1;
            }
            shift
        });
        least.collect()
    }
}

impl Iterator for Balanced {
    type Item = Places;

    fn next(&mut self) -> Option<Places> {
        let (cycle, video) = (self.video / self.combinations(), self.video % self.combinations());
        if video == 0 {
            let mut random = Stream::named(self.seed, "balance", &[cycle as u64]);
            self.names = [self.maps, self.weathers, self.times].map(|values| {
                let mut names: Vec<usize> = (0..values).collect();
                random.shuffle(&mut names);
                names
            });
        }
        self.video += 1;
        let [maps, weathers, times] = &self.names;
        Some(Places {
            map: maps[video % self.maps],
            weather: weathers[self.weather(video)],
            time_of_day: times[self.time_of_day(video)],
        })
    }
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// How often each of `values` came, and that no two counts differ by more than one.
    fn even(places: impl Iterator<Item = usize>, values: usize) -> bool {
        let mut counts = vec![0u32; values];
        let mut all_even = true;
        for place in places {
            counts[place] += 1;
            all_even &= counts.iter().max().expect("values") - counts.iter().min().expect("values") <= 1;
        }
        all_even
    }

    proptest! {
        #[test]
        fn values_come_equally_often_and_combinations_in_turn(
            maps in 1usize..13, weathers in 1usize..6, times in 1usize..7, cycles in 1usize..3, seed: u64,
        ) {
            let combinations = maps * weathers * times;
            let places: Vec<Places> = Balanced::new([maps, weathers, times], seed).take(cycles * combinations).collect();
            prop_assert!(even(places.iter().map(|p| p.map), maps));
            prop_assert!(even(places.iter().map(|p| p.weather), weathers));
            prop_assert!(even(places.iter().map(|p| p.time_of_day), times));
            let number = |p: &Places| (p.map * weathers + p.weather) * times + p.time_of_day;
            prop_assert!(even(places.iter().map(number), combinations), "all once before one comes again");
        }

        #[test]
        fn pairs_are_spread(maps in 1usize..13, weathers in 1usize..6, times in 1usize..4, seed: u64) {
            let places: Vec<Places> = Balanced::new([maps, weathers, times], seed).take(maps * weathers * times).collect();
            for n in 1..places.len() {
                let most = |pair: &dyn Fn(&Places) -> usize| {
                    let mut counts = vec![0usize; maps.max(weathers) * weathers.max(times)];
                    places[..n].iter().for_each(|p| counts[pair(p)] += 1);
                    counts.into_iter().max().expect("pairs")
                };
                let by_map = most(&|p| p.map * weathers + p.weather);
                prop_assert!(by_map <= n.div_ceil(maps * weathers));
                let by_time = most(&|p| p.map * times + p.time_of_day);
                prop_assert!(by_time <= n.div_ceil(maps * times) + 1, "{by_time} of {n}");
                let conditions = most(&|p| p.weather * times + p.time_of_day);
                prop_assert!(conditions <= n.div_ceil(weathers * times) + 3, "{conditions} of {n}");
            }
        }
    }

    #[test]
    fn one_value_is_always_that_value() {
        let all: Vec<Places> = Balanced::new([1, 1, 1], 3).take(4).collect();
        assert_eq!(all, [Places { map: 0, weather: 0, time_of_day: 0 }; 4]);
    }
}
