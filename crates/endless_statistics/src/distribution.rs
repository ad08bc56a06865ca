//! The shares of everything that is counted, in one form: of this are charts and comparisons made.

use crate::Histogram;

/// How much of something there is of each kind.
#[derive(Debug, Clone, PartialEq)]
pub struct Distribution {
    /// Its name in the JSON of a comparison.
    pub key: String,
    /// Its title.
    pub title: String,
    /// What is counted, in the plural: videos, boxes.
    pub of: &'static str,
    /// What the labels are, with their unit.
    pub axis: String,
    /// Whether the labels are in the order of some quantity.
    pub ordered: bool,
    /// The kinds.
    pub labels: Vec<String>,
    /// How much there is of each.
    pub counts: Vec<u64>,
    /// The same in parts, by the name of the part; they add up to the counts. None where it has no parts.
    pub parts: Vec<(String, Vec<u64>)>,
    /// Mean of a quantity, in the unit of the labels.
    pub mean: Option<f64>,
}

impl Distribution {
    /// Of kinds that have no order.
    pub(crate) fn of_kinds<L: Into<String>>(
        [key, title, of, axis]: [&'static str; 4],
        kinds: impl IntoIterator<Item = (L, u64)>,
    ) -> Self {
        let (labels, counts) = kinds.into_iter().map(|(label, count)| (label.into(), count)).unzip();
        let (key, title, axis) = (key.into(), title.into(), axis.into());
        Self { key, title, of, axis, ordered: false, labels, counts, parts: Vec::new(), mean: None }
    }

    /// Of kinds in an order.
    pub(crate) fn in_order(self) -> Self {
        Self { ordered: true, ..self }
    }

    /// Of a quantity.
    pub(crate) fn of_histogram(words: [&'static str; 4], histogram: &Histogram) -> Self {
        let scale = histogram.scale();
        let mut own = Self::of_kinds(words, scale.labels().into_iter().zip(histogram.by_label())).in_order();
        own.mean = histogram.mean();
        if !scale.unit.is_empty() {
            own.axis = format!("{} ({})", own.axis, scale.unit);
        }
        own
    }

    /// The most frequent kinds first.
    pub(crate) fn largest_first(mut self) -> Self {
        let mut kinds: Vec<(String, u64)> = self.labels.into_iter().zip(self.counts).collect();
        // The sort keeps the order of names among equals.
        kinds.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
        (self.labels, self.counts) = kinds.into_iter().unzip();
        self
    }

    /// With parts.
    pub(crate) fn with_parts(self, parts: impl IntoIterator<Item = (String, Vec<u64>)>) -> Self {
        let parts = parts.into_iter().filter(|(_, counts)| counts.iter().any(|count| *count > 0)).collect();
        Self { parts, ..self }
    }

    /// One of its parts as a distribution of its own.
    pub(crate) fn part(&self, name: &str) -> Option<Self> {
        let (name, counts) = self.parts.iter().find(|(part, _)| part == name)?;
        Some(Self {
            key: format!("{}/{name}", self.key),
            title: format!("{} \u{2014} {name}", self.title),
            counts: counts.clone(),
            parts: Vec::new(),
            mean: None,
            ..self.clone()
        })
    }

    /// How much there is in all.
    pub fn total(&self) -> u64 {
        self.counts.iter().sum()
    }

    /// The share of a label, 0 to 1; 0 where there is nothing.
    pub fn share(&self, label: &str) -> f64 {
        let place = self.labels.iter().position(|own| own == label);
        place.map_or(0.0, |place| self.counts[place] as f64 / self.total().max(1) as f64)
    }

    /// The labels of several, each once: those of the first, then what others have besides.
    pub(crate) fn all_labels(of: &[&Self]) -> Vec<String> {
        let mut labels: Vec<String> = Vec::new();
        for label in of.iter().flat_map(|distribution| &distribution.labels) {
            if !labels.contains(label) {
                labels.push(label.clone());
            }
        }
        labels
    }

    /// Total variation distance: the share of one that would have to be of another kind to be as the other. 0 where both are
    /// the same, 1 where they have nothing in common.
    pub fn total_variation(&self, other: &Self) -> f64 {
        let labels = Self::all_labels(&[self, other]);
        0.5 * labels.iter().map(|label| (self.share(label) - other.share(label)).abs()).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(kinds: &[(&str, u64)]) -> Distribution {
        Distribution::of_kinds(["k", "K", "boxes", "class"], kinds.iter().map(|(label, count)| (*label, *count)))
    }

    #[test]
    fn the_distance_is_what_would_have_to_be_of_another_kind() {
        let a = of(&[("car", 6), ("bus", 2), ("van", 2)]);
        assert_eq!(a.total_variation(&of(&[("bus", 20), ("car", 60), ("van", 20)])), 0.0);
        assert_eq!(a.total_variation(&of(&[("tram", 5)])), 1.0);
        let distance = a.total_variation(&of(&[("car", 5), ("bus", 5)]));
        assert!((distance - 0.3).abs() < 1e-12, "{distance}");
        assert_eq!((a.share("bus"), a.share("tram"), of(&[]).share("bus")), (0.2, 0.0, 0.0));
    }

    #[test]
    fn parts_are_distributions_of_their_own() {
        let whole = of(&[("a", 3), ("b", 1)]).with_parts([("car".into(), vec![2, 1]), ("bus".into(), vec![0, 0])]);
        let part = whole.part("car").expect("a part");
        assert_eq!((part.key.as_str(), part.total(), whole.part("bus")), ("k/car", 3, None));
    }

    proptest! {
        #[test]
        fn the_distance_is_a_distance(counts in proptest::collection::vec((0..9u64, 0..9u64, 1..9u64), 1..8)) {
            let names: Vec<String> = (0..counts.len()).map(|i| i.to_string()).collect();
            let kinds = |which: fn(&(u64, u64, u64)) -> u64| {
                let counts = counts.iter().map(which);
                Distribution::of_kinds(["k", "K", "boxes", "class"], names.iter().cloned().zip(counts))
            };
            let [a, b, c] = [kinds(|t| t.0 + 1), kinds(|t| t.1 + 1), kinds(|t| t.2)];
            prop_assert!((a.total_variation(&b) - b.total_variation(&a)).abs() < 1e-12);
            prop_assert!((0.0..=1.0 + 1e-12).contains(&a.total_variation(&b)));
            prop_assert!(a.total_variation(&c) <= a.total_variation(&b) + b.total_variation(&c) + 1e-12);
        }
    }
}
