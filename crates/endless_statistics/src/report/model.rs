//! Sections, tables and charts.

use crate::HeatMap;

/// A report: sections under a title.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Report {
    /// Its title.
    pub title: String,
    /// What it is about, in a line.
    pub subtitle: String,
    /// Its sections.
    pub sections: Vec<Section>,
}

/// A section.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Section {
    /// Its title.
    pub title: String,
    /// How to read it; may be empty.
    pub note: String,
    /// What is in it.
    pub items: Vec<Item>,
}

/// Something in a section.
#[derive(Debug, Clone, PartialEq)]
pub enum Item {
    /// Numbers to be seen first.
    Tiles(Vec<Tile>),
    /// A table.
    Table(Table),
    /// A chart.
    Chart(Chart),
    /// Heat maps, side by side.
    HeatMaps(Vec<HeatMapFigure>),
    /// Sentences.
    List(Vec<String>),
}

/// A number with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Tile {
    /// Its name.
    pub name: String,
    /// The number.
    pub value: String,
}

/// A table. Numbers stand to the right.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// Its title.
    pub title: String,
    /// Names of the columns; the first is that of the rows.
    pub columns: Vec<String>,
    /// As many cells as columns.
    pub rows: Vec<Vec<String>>,
    /// How many of the last rows are sums.
    pub sums: usize,
}

/// A chart of bars.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// Its title.
    pub title: String,
    /// What the labels are, with their unit.
    pub label_axis: String,
    /// What the values are, with their unit.
    pub value_axis: String,
    /// Places of the bars.
    pub labels: Vec<String>,
    /// Bars at these places.
    pub series: Vec<Series>,
    /// Whether series stand on one another, as parts of a whole; else beside one another.
    pub stacked: bool,
    /// Whether the labels are in the order of some quantity; else bars may lie, with the labels beside them.
    pub ordered: bool,
    /// Whether values are percent.
    pub percent: bool,
    /// What else is to be known, as the mean; may be empty.
    pub note: String,
}

/// Values of a chart.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Series {
    /// Its name.
    pub name: String,
    /// One a label.
    pub values: Vec<f64>,
}

/// A heat map with its title.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMapFigure {
    /// Its title.
    pub title: String,
    /// The map.
    pub map: HeatMap,
}

impl Chart {
    /// Without the empty ends of a long scale.
    pub(super) fn without_empty_ends(mut self) -> Self {
        let sums = self.sums();
        let filled = |sum: &f64| *sum > 0.0;
        let (Some(first), Some(last)) = (sums.iter().position(filled), sums.iter().rposition(filled)) else {
            return self;
        };
        if !self.ordered || self.labels.len() <= 10 {
            return self;
        }
        // One empty bin is left at each end: that nothing is there can be seen.
        let kept = first.saturating_sub(1)..(last + 2).min(self.labels.len());
        self.labels = self.labels[kept.clone()].to_vec();
        for series in &mut self.series {
            series.values = series.values[kept.clone()].to_vec();
        }
        self
    }

    /// The largest kinds of those that have no order, and a note where that is not all of them.
    pub(super) fn largest(mut self, most: usize) -> Self {
        if self.ordered || self.labels.len() <= most {
            return self;
        }
        let of = self.labels.len();
        let largest = |place: usize| self.series.iter().map(|s| s.values[place]).fold(0.0, f64::max);
        let mut places: Vec<usize> = (0..of).collect();
        places.sort_by(|a, b| largest(*b).total_cmp(&largest(*a)));
        places.truncate(most);
        self.labels = places.iter().map(|place| self.labels[*place].clone()).collect();
        for series in &mut self.series {
            series.values = places.iter().map(|place| series.values[*place]).collect();
        }
        let note = format!("the {most} largest of {of}");
        self.note = if self.note.is_empty() { note } else { format!("{}, {note}", self.note) };
        self
    }

    /// Sums of the series at each label.
    pub(super) fn sums(&self) -> Vec<f64> {
        (0..self.labels.len()).map(|place| self.series.iter().map(|series| series.values[place]).sum()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chart(values: &[f64], ordered: bool) -> Chart {
        let labels = (0..values.len()).map(|i| i.to_string()).collect();
        Chart {
            labels,
            ordered,
            series: vec![Series { name: "n".into(), values: values.to_vec() }],
            ..Chart::default()
        }
    }

    #[test]
    fn long_scales_lose_their_empty_ends() {
        let long = [0.0, 0.0, 0.0, 2.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let cut = chart(&long, true).without_empty_ends();
        assert_eq!(
            (cut.labels.join(" "), cut.series[0].values.clone()),
            ("2 3 4 5 6".into(), vec![0.0, 2.0, 0.0, 1.0, 0.0])
        );
        assert_eq!(chart(&long, false).without_empty_ends().labels.len(), 11);
        assert_eq!(chart(&[0.0, 1.0], true).without_empty_ends().labels.len(), 2);
        assert_eq!(chart(&[0.0; 12], true).without_empty_ends().labels.len(), 12);
    }

    #[test]
    fn of_many_kinds_the_largest_are_shown() {
        let cut = chart(&[1.0, 5.0, 3.0], false).largest(2);
        assert_eq!((cut.labels.join(" "), cut.note.as_str()), ("1 2".into(), "the 2 largest of 3"));
        assert_eq!(chart(&[1.0, 5.0, 3.0], true).largest(2).labels.len(), 3);
    }
}
