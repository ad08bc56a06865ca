//! One draw from the ranges that a design leaves open.

use endless_world::Stream;

/// Chooses lengths, shapes and equipment of one vehicle. Each choice has a name and a random stream of its own, so that
/// a choice more or less leaves the others as they are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct DesignDraw(u64);

impl DesignDraw {
    /// Number `index` of a design's draws.
    pub(crate) fn new(design: &str, index: u64) -> Self {
        Self(Stream::named(index, design, &[]).next_u64())
    }

    fn stream(&self, choice: &str) -> Stream {
        Stream::named(self.0, choice, &[])
    }

    /// Uniform in a range.
    pub(crate) fn range(&self, choice: &str, low: f32, high: f32) -> f32 {
        self.stream(choice).range_f32(low, high)
    }

    /// True with this probability.
    pub(crate) fn chance(&self, choice: &str, probability: f64) -> bool {
        self.stream(choice).chance(probability)
    }

    /// One of some things.
    pub(crate) fn pick<T: Copy>(&self, choice: &str, things: &[T]) -> T {
        *self.stream(choice).pick(things)
    }
}
