//! A report as text for a terminal.

use super::model::{Chart, HeatMapFigure, Item, Report, Table, Tile};
use std::fmt::Write as _;

/// Cells of the longest bar.
const BAR: usize = 30;
/// Longer names are cut.
const NAME: usize = 44;
/// More rows than these are left to the JSON and the page.
const ROWS: usize = 40;

impl Report {
    /// As text, with the tables aligned.
    pub fn text(&self) -> String {
        let mut text = format!("{}\n{}\n", plain(&self.title), plain(&self.subtitle));
        for section in &self.sections {
            let _ = write!(text, "\n== {} ==\n", plain(&section.title));
            if !section.note.is_empty() {
                wrap(&mut text, &section.note);
            }
            for item in &section.items {
                match item {
                    Item::Tiles(tiles) => write_tiles(&mut text, tiles),
                    Item::Table(table) => write_table(&mut text, table),
                    Item::Chart(chart) => write_chart(&mut text, chart),
                    Item::HeatMaps(maps) => maps.iter().take(1).for_each(|map| write_heat_map(&mut text, map)),
                    Item::List(sentences) => {
                        text.push('\n');
                        sentences.iter().for_each(|sentence| wrap(&mut text, &format!("- {sentence}")));
                    }
                }
            }
        }
        text
    }
}

/// Without what would move a terminal's cursor, and not longer than a name may be.
fn plain(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect()
}

fn name(text: &str) -> String {
    let text = plain(text);
    if text.chars().count() <= NAME { text } else { text.chars().take(NAME - 1).chain(['\u{2026}']).collect() }
}

/// In lines of at most 100 characters.
fn wrap(text: &mut String, sentence: &str) {
    let mut length = 0;
    for word in plain(sentence).split_whitespace() {
        let word_length = word.chars().count();
        if length > 0 && length + 1 + word_length > 100 {
            text.push('\n');
            length = 0;
        }
        if length > 0 {
            text.push(' ');
            length += 1;
        }
        text.push_str(word);
        length += word_length;
    }
    text.push('\n');
}

fn write_tiles(text: &mut String, tiles: &[Tile]) {
    let width = tiles.iter().map(|tile| tile.value.chars().count()).max().unwrap_or_default();
    for tile in tiles {
        let _ = writeln!(text, "{:>width$} {}", plain(&tile.value), plain(&tile.name));
    }
}

fn write_table(text: &mut String, table: &Table) {
    let _ = write!(text, "\n{}\n", plain(&table.title));
    let heads = std::iter::once(&table.columns).filter(|columns| columns.iter().any(|column| !column.is_empty()));
    let shown = table.rows.iter().take(ROWS);
    let lines: Vec<Vec<String>> = heads.chain(shown).map(|line| line.iter().map(|cell| name(cell)).collect()).collect();
    let widths: Vec<usize> = (0..table.columns.len())
        .map(|column| lines.iter().map(|line| line[column].chars().count()).max().unwrap_or_default())
        .collect();
    for line in &lines {
        let _ = write!(text, "  {:<width$}", line[0], width = widths[0]);
        for (cell, width) in line.iter().zip(&widths).skip(1) {
            let _ = write!(text, "  {cell:>width$}");
        }
        trim_end(text);
        text.push('\n');
    }
    more(text, table.rows.len());
}

fn more(text: &mut String, rows: usize) {
    if rows > ROWS {
        let _ = writeln!(text, "  \u{2026} {} more: --json and --html have all", rows - ROWS);
    }
}

fn trim_end(text: &mut String) {
    text.truncate(text.trim_end_matches(' ').len());
}

/// A line of eighths for quantities, a bar a line for kinds; the numbers of several series beside one another.
fn write_chart(text: &mut String, chart: &Chart) {
    if chart.stacked && chart.ordered && (chart.labels.len() > 12 || chart.series.len() > 3) {
        return write_spark(text, chart);
    }
    let note = if chart.note.is_empty() { String::new() } else { format!(" \u{2014} {}", chart.note) };
    let _ = write!(text, "\n{}, {}{}\n", plain(&chart.title), plain(&chart.value_axis), plain(&note));
    let sums = chart.sums();
    let total: f64 = sums.iter().sum();
    let most = sums.iter().copied().fold(0.0, f64::max);
    let labels: Vec<String> = chart.labels.iter().map(|label| name(label)).collect();
    let width = labels.iter().map(|label| label.chars().count()).max().unwrap_or_default();
    if !chart.stacked {
        let heads: Vec<String> = chart.series.iter().map(|series| name(&series.name)).collect();
        let _ = write!(text, "  {:width$}", "");
        heads.iter().for_each(|head| {
            let _ = write!(text, "  {head:>8}");
        });
        text.push('\n');
        for (place, label) in labels.iter().enumerate().take(ROWS) {
            let _ = write!(text, "  {label:<width$}");
            for (series, head) in chart.series.iter().zip(&heads) {
                let wide = head.chars().count().max(8);
                let _ = write!(text, "  {:>wide$}", format!("{:.1}%", series.values[place]));
            }
            text.push('\n');
        }
        return more(text, labels.len());
    }
    for (label, sum) in labels.iter().zip(&sums).take(ROWS) {
        let cells = if most > 0.0 { (sum / most * BAR as f64).round() as usize } else { 0 };
        let number = super::format::whole(*sum as u64);
        let share = if total > 0.0 { 100.0 * sum / total } else { 0.0 };
        let _ = write!(text, "  {label:<width$}  {number:>9}  {share:5.1}%  {}", "\u{2588}".repeat(cells));
        trim_end(text);
        text.push('\n');
    }
    more(text, labels.len());
}

fn write_spark(text: &mut String, chart: &Chart) {
    let first = chart.labels.first().map_or("", String::as_str);
    let last = chart.labels.last().map_or("", String::as_str);
    let _ = write!(text, "\n{}: {}, {} to {}\n", chart.title, chart.label_axis, first, last);
    let all = (chart.value_axis.clone(), chart.sums());
    let parts = chart.series.iter().map(|series| (series.name.clone(), series.values.clone()));
    let lines: Vec<(String, Vec<f64>)> =
        if chart.series.len() > 1 { [all].into_iter().chain(parts).collect() } else { vec![all] };
    let width = lines.iter().map(|(name, _)| name.chars().count()).max().unwrap_or_default();
    for (name, values) in lines {
        let most = values.iter().copied().fold(0.0, f64::max);
        let eighth = |value: &f64| match (value / most.max(f64::MIN_POSITIVE) * 8.0).ceil() as u32 {
            0 => '\u{b7}',
            eighths => char::from_u32(0x2580 + eighths.min(8)).unwrap_or(' '),
        };
        let spark: String = values.iter().map(eighth).collect();
        let total = super::format::whole(values.iter().sum::<f64>() as u64);
        let _ = writeln!(text, "  {:<width$}  {spark}  {total}", plain(&name));
    }
}

fn write_heat_map(text: &mut String, figure: &HeatMapFigure) {
    let _ = write!(text, "\n{}\n", plain(&figure.title));
    let map = &figure.map;
    let most = map.counts.iter().copied().max().unwrap_or_default().max(1);
    for row in map.counts.chunks(map.columns) {
        let shade = |count: &u64| match (*count * 4).div_ceil(most) {
            0 => '\u{b7}',
            1 => '\u{2591}',
            2 => '\u{2592}',
            3 => '\u{2593}',
            _ => '\u{2588}',
        };
        let _ = writeln!(text, "  {}", row.iter().map(shade).collect::<String>());
    }
}
