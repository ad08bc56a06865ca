//! The report of datasets side by side.

use super::dataset::subtitle;
use super::format::whole;
use super::model::{Chart, HeatMapFigure, Item, Report, Section, Series, Table};
use crate::{Comparison, NumberRow, ShareTable, Side};

/// So many kinds are shown.
const KINDS: usize = 30;
/// What differs by so much is called different.
const DIFFERENT: f64 = 0.1;

impl Report {
    /// What is told of datasets side by side.
    pub fn of_comparison(comparison: &Comparison) -> Self {
        let sides = &comparison.sides;
        let title = sides.iter().map(|side| side.name.as_str()).collect::<Vec<_>>().join(" and ");
        let subtitles = sides.iter().map(|side| format!("{}: {}", side.letter, subtitle(&side.statistics)));
        let mut sections = vec![overview(comparison)];
        let (different, alike): (Vec<&ShareTable>, Vec<&ShareTable>) = comparison
            .distributions
            .iter()
            .filter(|table| table.key != "places")
            .partition(|t| t.distance() >= DIFFERENT);
        for (title, tables) in [("What differs", different), ("What is alike", alike)] {
            let items = tables.into_iter().map(|table| Item::Chart(chart(comparison, table))).collect();
            let note = "Shares of each side in percent, the most different first.".into();
            sections.push(Section { title: title.into(), note, items });
        }
        let figure = |side: &Side| HeatMapFigure {
            title: format!("{}: {}", side.letter, side.name),
            map: side.statistics.heat_map.clone(),
        };
        let figures = sides.iter().map(figure).collect();
        let note = "Where in the picture the middles of boxes lie; each map has its own scale.".into();
        let items = vec![Item::HeatMaps(figures)];
        sections.push(Section { title: "Places in the picture".into(), note, items });
        sections.retain(|section| !section.items.is_empty());
        let subtitle = subtitles.collect::<Vec<_>>().join("; ");
        Self { title: format!("Comparison of {title}"), subtitle, sections }
    }
}

fn overview(comparison: &Comparison) -> Section {
    let sides = &comparison.sides;
    let number = |value: &Option<f64>| match value {
        Some(value) if value.fract() == 0.0 && *value < 1e15 => whole(*value as u64),
        Some(value) => format!("{value:.2}"),
        None => "\u{2013}".into(),
    };
    let ratio = |values: &[Option<f64>]| match (values.first().copied().flatten(), values.last().copied().flatten()) {
        (Some(first), Some(last)) if first > 0.0 && last > 0.0 => format!("{:.2}", first / last),
        _ => "\u{2013}".into(),
    };
    let two = sides.len() == 2;
    let heads = sides.iter().map(|side| format!("{}: {}", side.letter, side.name));
    let row = |row: &NumberRow| {
        let cells = row.values.iter().map(number).chain(two.then(|| ratio(&row.values)));
        [row.name.to_owned()].into_iter().chain(cells).collect()
    };
    let table = Table {
        title: "Side by side".into(),
        columns: [String::new()].into_iter().chain(heads).chain(two.then(|| "A / B".to_owned())).collect(),
        rows: comparison.numbers.iter().map(row).collect(),
        sums: 0,
    };
    let mut items = Vec::new();
    if !comparison.hints.is_empty() {
        items.push(Item::List(comparison.hints.clone()));
    }
    items.push(Item::Table(table));
    items.push(Item::Table(distances(comparison)));
    let counted = comparison.classes_counted_as.iter().map(|(class, as_class)| format!("{class} as {as_class}"));
    let counted: Vec<String> = counted.collect();
    let mut note = "Distances are total variation: the share of one side that would have to be of another kind to be as the other. \
                    0 is the same, 1 has nothing in common. A few videos differ from others by chance alone."
        .to_owned();
    if !counted.is_empty() {
        note +=
            &format!(" Not all sides tell these classes apart, so they are counted as others: {}.", counted.join(", "));
    }
    Section { title: "Overview".into(), note, items }
}

fn distances(comparison: &Comparison) -> Table {
    let Some((last, others)) = comparison.sides.split_last() else { return Table::default() };
    let heads = others.iter().map(|side| format!("{} from {}", side.letter, last.letter));
    let row = |table: &ShareTable| {
        let cell = |distance: &Option<f64>| distance.map_or_else(|| "\u{2013}".into(), |d| format!("{d:.3}"));
        [table.title.clone(), table.of.to_owned()].into_iter().chain(table.distances.iter().map(cell)).collect()
    };
    Table {
        title: "Distances, the most different first".into(),
        columns: ["distribution", "of"].map(String::from).into_iter().chain(heads).collect(),
        rows: comparison.distributions.iter().map(row).collect(),
        sums: 0,
    }
}

fn chart(comparison: &Comparison, table: &ShareTable) -> Chart {
    let of_side = |(side, shares): (&Side, &Option<Vec<f64>>)| {
        let values = shares.as_ref()?.iter().map(|share| 100.0 * share).collect();
        Some(Series { name: format!("{}: {}", side.letter, side.name), values })
    };
    let distances: Vec<String> = table.distances.iter().flatten().map(|distance| format!("{distance:.3}")).collect();
    let chart = Chart {
        title: table.title.clone(),
        label_axis: table.axis.clone(),
        value_axis: format!("share of {} (%)", table.of),
        labels: table.labels.clone(),
        series: comparison.sides.iter().zip(&table.shares).filter_map(of_side).collect(),
        stacked: false,
        ordered: table.ordered,
        percent: true,
        note: format!("distance {}", distances.join(", ")),
    };
    chart.without_empty_ends().largest(KINDS)
}
