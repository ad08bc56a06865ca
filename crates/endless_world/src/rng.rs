//! Counter-based random streams: what comes out depends only on the keys, never on threads, time or order of calls
//! elsewhere.

/// A random stream keyed by what it is for, e.g. `Stream::new(scene_seed, &[PURPOSE_PAINT, vehicle_index])`.
///
/// SplitMix64 (Steele, Lea, Flood 2014) over a key hashed with the same finaliser. Not for cryptography.
#[derive(Debug, Clone)]
pub struct Stream {
    state: u64,
}

const GOLDEN: u64 = 0x9e37_79b9_7f4a_7c15;

/// The SplitMix64 finaliser: a bijection that mixes every bit into every other.
#[inline]
const fn mix(mut z: u64) -> u64 {
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

/// FNV-1a, 64 bits: a name or a file as a number. Not for keys that an adversary chooses.
pub fn fnv1a(bytes: impl IntoIterator<Item = u8>) -> u64 {
    bytes.into_iter().fold(0xcbf2_9ce4_8422_2325, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0100_0000_01b3))
}

impl Stream {
    /// The stream of these keys.
    pub fn new(seed: u64, keys: &[u64]) -> Self {
        let mut state = mix(seed.wrapping_add(GOLDEN));
        for &key in keys {
            state = mix(state ^ mix(key.wrapping_add(GOLDEN)).wrapping_mul(GOLDEN));
        }
        Self { state }
    }

    /// The stream of a name, for keys that are words ("traffic", "plan").
    pub fn named(seed: u64, name: &str, keys: &[u64]) -> Self {
        let hash = fnv1a(name.bytes());
        let mut stream = Self::new(seed ^ hash, keys);
        stream.state = mix(stream.state ^ hash);
        stream
    }

    /// A child stream; the parent goes on as if nothing had happened.
    pub fn fork(&self, key: u64) -> Self {
        Self::new(self.state, &[key])
    }

    /// 64 random bits.
    #[inline]
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(GOLDEN);
        mix(self.state)
    }

    /// Uniform in [0, 1).
    #[inline]
    pub fn f64(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 * (1.0 / (1u64 << 53) as f64)
    }

    /// Uniform in [0, 1).
    #[inline]
    pub fn f32(&mut self) -> f32 {
        (self.next_u64() >> 40) as f32 * (1.0 / (1u32 << 24) as f32)
    }

    /// Uniform in [low, high).
    pub fn range_f64(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.f64()
    }

    /// Uniform in [low, high).
    pub fn range_f32(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * self.f32()
    }

    /// Uniform in 0..n, without bias that could be seen (n far below 2⁶⁴).
    ///
    /// # Panics
    /// If `n` is 0.
    pub fn below(&mut self, n: usize) -> usize {
        assert!(n > 0, "a choice among nothing");
        ((u128::from(self.next_u64()) * n as u128) >> 64) as usize
    }

    /// True with this probability.
    pub fn chance(&mut self, probability: f64) -> bool {
        self.f64() < probability
    }

    /// One of the items.
    ///
    /// # Panics
    /// If there are none.
    pub fn pick<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len())]
    }

    /// Index drawn in proportion to the weights.
    ///
    /// # Panics
    /// If there are none.
    pub fn weighted(&mut self, weights: &[f64]) -> usize {
        let total: f64 = weights.iter().sum();
        let mut x = self.f64() * total;
        for (i, w) in weights.iter().enumerate() {
            x -= w;
            if x < 0.0 {
                return i;
            }
        }
        weights.len() - 1
    }

    /// Index of one of these keyed choices, in proportion to their weights; `None` if no weight is positive.
    ///
    /// Weighted rendezvous hashing (Thaler and Ravishankar 1998; Schindelhauer and Schomaker 2005): every choice has a
    /// score from its own key, −ln(u) / weight, and the lowest wins. So a choice more or less changes only those draws
    /// that it wins, wherever in the list it stands. Keys must differ. Takes one number from the stream, however many
    /// choices there are.
    ///
    /// ```
    /// use endless_world::Stream;
    ///
    /// let draw = |choices: &[(u64, f64)]| {
    ///     let index = Stream::new(7, &[]).weighted_by_key(choices.iter().copied())?;
    ///     Some(choices[index].0)
    /// };
    /// assert_eq!(draw(&[(1, 3.0), (2, 5.0)]), draw(&[(2, 5.0), (1, 3.0)]));
    /// assert_eq!(draw(&[(1, 0.0)]), None);
    /// ```
    pub fn weighted_by_key(&mut self, choices: impl IntoIterator<Item = (u64, f64)>) -> Option<usize> {
        let salt = self.next_u64();
        let score = |key, weight| -crate::math::f64::ln(1.0 - Self::new(salt, &[key]).f64()) / weight;
        let scores = choices.into_iter().enumerate().filter(|(_, (_, weight))| *weight > 0.0);
        let scores = scores.map(|(index, (key, weight))| (index, score(key, weight)));
        scores.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
    }

    /// One of these items, all alike likely, each by its key: see [`Self::weighted_by_key`].
    ///
    /// # Panics
    /// If there are none.
    pub fn pick_by_key<'a, T>(&mut self, items: &'a [T], key: impl Fn(&T) -> u64) -> &'a T {
        let index = self.weighted_by_key(items.iter().map(|item| (key(item), 1.0)));
        &items[index.expect("a choice among nothing")]
    }

    /// Fisher–Yates shuffle.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for i in (1..items.len()).rev() {
            items.swap(i, self.below(i + 1));
        }
    }

    /// Standard normal (Box–Muller).
    pub fn normal(&mut self) -> f64 {
        let r = (-2.0 * crate::math::f64::ln(1.0 - self.f64())).sqrt();
        r * crate::math::f64::cos(std::f64::consts::TAU * self.f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_decide_and_only_keys() {
        let a: Vec<u64> = {
            let mut s = Stream::new(7, &[1, 2]);
            (0..4).map(|_| s.next_u64()).collect()
        };
        let b: Vec<u64> = {
            let mut s = Stream::new(7, &[1, 2]);
            (0..4).map(|_| s.next_u64()).collect()
        };
        assert_eq!(a, b);
        assert_ne!(a[0], Stream::new(7, &[2, 1]).next_u64());
        assert_ne!(a[0], Stream::new(8, &[1, 2]).next_u64());
    }

    #[test]
    fn a_choice_more_changes_only_the_draws_that_it_wins() {
        const DRAWS: u64 = 20_000;
        let few = [(10, 5.0), (20, 3.0), (30, 2.0)];
        let more = [(40, 2.5), (10, 5.0), (20, 3.0), (50, 0.0), (30, 2.0)];
        let draw = |i, choices: &[(u64, f64)]| {
            let index = Stream::new(3, &[i]).weighted_by_key(choices.iter().copied()).expect("weights");
            choices[index].0
        };
        let mut counts = [0.0; 5];
        for i in 0..DRAWS {
            let (before, after) = (draw(i, &few), draw(i, &more));
            assert!(after == before || after == 40);
            counts[after as usize / 10 - 1] += 1.0 / DRAWS as f64;
        }
        for (share, expected) in counts.into_iter().zip([0.4, 0.24, 0.16, 0.2, 0.0]) {
            assert!((share - expected).abs() < 0.015, "{share} instead of {expected}");
        }
    }

    #[test]
    fn uniform_has_the_right_mean_and_spread() {
        let mut s = Stream::new(1, &[]);
        let n = 100_000;
        let (mut sum, mut sum2) = (0.0, 0.0);
        for _ in 0..n {
            let x = s.f64();
            assert!((0.0..1.0).contains(&x));
            sum += x;
            sum2 += x * x;
        }
        let mean = sum / f64::from(n);
        assert!((mean - 0.5).abs() < 0.005);
        assert!((sum2 / f64::from(n) - mean * mean - 1.0 / 12.0).abs() < 0.002);
    }
}
