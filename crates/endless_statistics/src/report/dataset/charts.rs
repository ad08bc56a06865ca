//! Charts of distributions.

use crate::Distribution;
use crate::report::model::{Chart, Item, Series};

/// So many kinds are shown.
const KINDS: usize = 30;

/// The distributions, of which sections take what is theirs.
pub(super) struct Charts(Vec<Distribution>);

impl Charts {
    pub(super) fn new(distributions: Vec<Distribution>) -> Self {
        Self(distributions)
    }

    /// The charts of these distributions; of those that were counted.
    pub(super) fn of(&self, keys: &[&str]) -> impl Iterator<Item = Item> {
        let found = keys.iter().filter_map(|key| self.0.iter().find(|distribution| distribution.key == *key));
        found.map(|distribution| Item::Chart(chart(distribution))).collect::<Vec<_>>().into_iter()
    }
}

fn chart(distribution: &Distribution) -> Chart {
    let values = |counts: &[u64]| counts.iter().map(|count| *count as f64).collect();
    let all = || vec![(distribution.of.to_owned(), distribution.counts.clone())];
    let parts = if distribution.parts.is_empty() { all() } else { distribution.parts.clone() };
    let series = parts.iter().map(|(name, counts)| Series { name: name.clone(), values: values(counts) });
    let chart = Chart {
        title: distribution.title.clone(),
        label_axis: distribution.axis.clone(),
        value_axis: distribution.of.to_owned(),
        labels: distribution.labels.clone(),
        series: series.collect(),
        stacked: true,
        ordered: distribution.ordered,
        percent: false,
        note: distribution.mean.map_or_else(String::new, |mean| format!("mean {mean:.2}{}", unit(&distribution.axis))),
    };
    chart.without_empty_ends().largest(KINDS)
}

/// The unit of an axis, `distance (m)`, behind a number.
fn unit(axis: &str) -> String {
    let unit = axis.rsplit_once(" (").and_then(|(_, unit)| unit.strip_suffix(')'));
    match unit {
        Some("%") => "%".into(),
        Some(unit) => format!("\u{a0}{unit}"),
        None => String::new(),
    }
}
