//! Histograms with fixed edges.

use crate::merge::Merge;
use serde::{Serialize, Serializer, ser::SerializeStruct as _};

/// What a histogram measures, and where its bins lie.
#[derive(Debug, PartialEq)]
pub struct Scale {
    /// Unit of the edges, as text; empty for shares and ratios.
    pub unit: &'static str,
    /// Edges of the bins, ascending; at least two. Where the bins are not equally wide, each is about a third wider than the
    /// one before.
    pub edges: &'static [f64],
    /// Whether values above the last edge are to be expected.
    pub open: bool,
}

impl Scale {
    /// A name for each bin, and for what is above where that is to be expected.
    pub fn labels(&self) -> Vec<String> {
        let bins = self.edges.windows(2).map(|edges| format!("{}\u{2013}{}", edges[0], edges[1]));
        let above = self.edges.last().filter(|_| self.open).map(|last| format!("> {last}"));
        bins.chain(above).collect()
    }
}

/// How many values lie in each bin. As in `numpy.histogram`, a bin has its lower edge and not its upper one, but for the last
/// bin, which has both.
#[derive(Debug, Clone, PartialEq)]
pub struct Histogram {
    scale: &'static Scale,
    counts: Vec<u64>,
    below: u64,
    above: u64,
    sum_thousandths: u64,
}

impl Histogram {
    /// Without values.
    pub fn new(scale: &'static Scale) -> Self {
        Self { scale, counts: vec![0; scale.edges.len() - 1], below: 0, above: 0, sum_thousandths: 0 }
    }

    /// Counts one value; what is no number is not counted.
    pub fn add(&mut self, value: f64) {
        let edges = self.scale.edges;
        let last = edges.len() - 1;
        if value.is_nan() {
            return;
        }
        self.sum_thousandths = self.sum_thousandths.saturating_add((value.max(0.0) * 1000.0 + 0.5).floor() as u64);
        if value < edges[0] {
            self.below += 1;
        } else if value > edges[last] {
            self.above += 1;
        } else {
            let bin = edges.partition_point(|edge| *edge <= value) - 1;
            self.counts[bin.min(last - 1)] += 1;
        }
    }

    /// What it measures, and where its bins lie.
    pub fn scale(&self) -> &'static Scale {
        self.scale
    }

    /// Values in each bin.
    pub fn counts(&self) -> &[u64] {
        &self.counts
    }

    /// Values below the first edge.
    pub fn below(&self) -> u64 {
        self.below
    }

    /// Values above the last edge.
    pub fn above(&self) -> u64 {
        self.above
    }

    /// Values by label of the scale; what lies beyond belongs to the nearest.
    pub fn by_label(&self) -> Vec<u64> {
        let mut counts = self.counts.clone();
        counts[0] += self.below;
        if self.scale.open {
            counts.push(self.above);
        } else if let Some(last) = counts.last_mut() {
            *last += self.above;
        }
        counts
    }

    /// How many values there are.
    pub fn total(&self) -> u64 {
        self.counts.iter().sum::<u64>() + self.below + self.above
    }

    /// Whether there are no values.
    pub fn is_empty(&self) -> bool {
        self.total() == 0
    }

    /// Mean of the values, each rounded to thousandths; none without values.
    pub fn mean(&self) -> Option<f64> {
        (!self.is_empty()).then(|| self.sum_thousandths as f64 / 1000.0 / self.total() as f64)
    }
}

impl Merge for Histogram {
    fn absorb(&mut self, other: Self) {
        assert_eq!(self.scale, other.scale, "histograms of one quantity");
        for (own, other) in self.counts.iter_mut().zip(other.counts) {
            *own += other;
        }
        self.below += other.below;
        self.above += other.above;
        self.sum_thousandths = self.sum_thousandths.saturating_add(other.sum_thousandths);
    }
}

impl Serialize for Histogram {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Histogram", 7)?;
        fields.serialize_field("unit", self.scale.unit)?;
        fields.serialize_field("values", &self.total())?;
        fields.serialize_field("mean", &self.mean())?;
        fields.serialize_field("edges", self.scale.edges)?;
        fields.serialize_field("counts", &self.counts)?;
        fields.serialize_field("below", &self.below)?;
        fields.serialize_field("above", &self.above)?;
        fields.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    static TENTHS: Scale = Scale { unit: "m", edges: &[0.0, 0.1, 0.2, 0.5, 1.0], open: true };

    #[test]
    fn edges_belong_to_the_bin_above_but_the_last() {
        let mut histogram = Histogram::new(&TENTHS);
        for value in [0.0, 0.1, 0.2, 0.3, 0.5, 1.0, 1.000_001, -0.5, f64::NAN] {
            histogram.add(value);
        }
        assert_eq!(histogram.counts(), [1, 1, 2, 2]);
        assert_eq!((histogram.below(), histogram.above(), histogram.total()), (1, 1, 8));
        assert_eq!(histogram.mean(), Some(3.1 / 8.0));
        assert_eq!(Histogram::new(&TENTHS).mean(), None);
        assert_eq!(histogram.by_label(), [2, 1, 2, 2, 1]);
        assert_eq!(TENTHS.labels(), ["0\u{2013}0.1", "0.1\u{2013}0.2", "0.2\u{2013}0.5", "0.5\u{2013}1", "> 1"]);
    }

    proptest! {
        #[test]
        fn parts_add_up_in_any_order(values in proptest::collection::vec(-1.0..2.0f64, 0..40), cut in 0..40usize) {
            let of = |values: &[f64]| {
                let mut histogram = Histogram::new(&TENTHS);
                values.iter().for_each(|value| histogram.add(*value));
                histogram
            };
            let (left, right) = values.split_at(cut.min(values.len()));
            let (mut one, mut other) = (of(left), of(right));
            one.absorb(of(right));
            other.absorb(of(left));
            prop_assert_eq!(&one, &other);
            prop_assert_eq!(&one, &of(&values));
            prop_assert_eq!(one.total(), values.len() as u64);
        }
    }
}
