//! What stands out of a comparison, in plain words.

use super::table::{NumberRow, ShareTable, Side};
use std::fmt::Write as _;

/// Distributions that are nearer than this are alike.
const ALIKE: f64 = 0.1;
/// A share that differs by less is no news.
const LEAST_DIFFERENCE: f64 = 0.03;
/// Numbers whose ratio is less are alike.
const LEAST_RATIO: f64 = 1.2;
/// So many of each pair are told.
const MOST: usize = 12;

/// Sentences about each side and the last one.
pub(super) fn hints(sides: &[Side], numbers: &[NumberRow], tables: &[ShareTable]) -> Vec<String> {
    let Some((last, others)) = sides.split_last() else { return Vec::new() };
    let pairs = others.iter().enumerate();
    pairs.flat_map(|(place, side)| of_pair(place, side.letter, last.letter, numbers, tables)).collect()
}

fn of_pair(place: usize, side: char, last: char, numbers: &[NumberRow], tables: &[ShareTable]) -> Vec<String> {
    let mut hints = Vec::new();
    for row in numbers.iter().filter(|row| row.name == "boxes a frame, mean") {
        if let [Some(own), Some(other)] = [row.values[place], row.values.last().copied().flatten()]
            && own.min(other) > 0.0
            && own.max(other) / own.min(other) >= LEAST_RATIO
        {
            let (more, less) = if own > other { (side, last) } else { (last, side) };
            let (high, low) = (own.max(other), own.min(other));
            hints.push(format!(
                "{more} has {} times as many boxes a frame as {less}: {high:.1} against {low:.1}.",
                times(high / low)
            ));
        }
    }
    let mut differing: Vec<(f64, &ShareTable)> = tables
        .iter()
        .filter_map(|table| Some((table.distances[place]?, table)))
        .filter(|(distance, table)| *distance >= ALIKE && !table.key.contains('/') && table.key != "views")
        .collect();
    differing.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (_, table) in differing {
        hints.extend(of_table(place, side, last, table));
    }
    hints.truncate(MOST);
    hints
}

/// The label whose share differs most, and what one side lacks.
fn of_table(place: usize, side: char, last: char, table: &ShareTable) -> Option<String> {
    let own = table.shares[place].as_ref()?;
    let other = table.shares.last()?.as_ref()?;
    let difference = |label: &usize| (own[*label] - other[*label]).abs();
    let label = (0..table.labels.len()).max_by(|a, b| difference(a).total_cmp(&difference(b)).then(b.cmp(a)))?;
    if difference(&label) < LEAST_DIFFERENCE {
        return None;
    }
    let (more, less, high, low) = if own[label] > other[label] {
        (side, last, own[label], other[label])
    } else {
        (last, side, other[label], own[label])
    };
    let what = what(table, label);
    let mut text = if low == 0.0 {
        format!("{less} has no {what}; in {more} they are {:.1}% of {}.", 100.0 * high, table.of)
    } else {
        let ratio = times(high / low);
        format!(
            "{more} has {ratio} times the share of {what}: {:.1}% against {:.1}% in {less}.",
            100.0 * high,
            100.0 * low
        )
    };
    let missing: Vec<&str> = (0..table.labels.len())
        .filter(|other_label| {
            *other_label != label && !table.ordered && own[*other_label] > 0.01 && other[*other_label] == 0.0
        })
        .map(|label| table.labels[label].as_str())
        .take(4)
        .collect();
    if !missing.is_empty() && table.labels.len() <= 40 {
        let _ = write!(text, " {last} lacks {}.", missing.join(", "));
    }
    Some(text)
}

/// The kind, as one says it.
fn what(table: &ShareTable, label: usize) -> String {
    let label = &table.labels[label];
    let of = table.of;
    match (table.key.as_str(), label.as_str()) {
        ("sizes", "small") => "boxes smaller than 32 \u{d7} 32 px".into(),
        ("sizes", "medium") => "boxes from 32 \u{d7} 32 to 96 \u{d7} 96 px".into(),
        ("sizes", "large") => "boxes larger than 96 \u{d7} 96 px".into(),
        ("side_px", _) => format!("boxes whose size is {label} px"),
        ("side_percent", _) => format!("boxes whose size is {label}% of the picture's"),
        ("aspect_ratio", _) => format!("boxes that are {label} times as wide as high"),
        ("boxes_per_frame", "1") => "frames with 1 box".into(),
        ("boxes_per_frame", _) => format!("frames with {label} boxes"),
        ("visibility", _) => format!("objects of which a share of {label} is visible"),
        ("truncation", _) => format!("objects of which a share of {label} is outside the picture"),
        ("distance_m", _) => format!("objects {label} m away"),
        ("seconds_seen", _) => format!("tracks of {label} s"),
        ("vehicle_speed_mps", _) => format!("moving vehicles at {label} m/s"),
        ("walking_speed_mps", _) => format!("moving people at {label} m/s"),
        ("skin_tone" | "skin_tone_boxes", _) => format!("{of} of skin tone {label}"),
        ("classes", _) => format!("{label} boxes"),
        ("vehicle_states", _) => format!("{label} vehicles"),
        ("people_states", _) => format!("{label} people"),
        ("at_edge", "inside") => "boxes that touch no edge of the picture".into(),
        ("at_edge", _) => "boxes that touch an edge of the picture".into(),
        ("places", _) => format!("boxes in {label} of the picture's 8 \u{d7} 6 cells"),
        ("people_met" | "vehicles_met", _) => format!("looks that are met in {label} videos"),
        ("age_years", _) => format!("people of {label} years"),
        _ => format!("{of} of {} {label}", table.axis),
    }
}

fn times(ratio: f64) -> String {
    if ratio >= 100.0 { format!("{ratio:.0}") } else { format!("{ratio:.1}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(key: &str, labels: &[&str], own: &[f64], other: &[f64]) -> ShareTable {
        ShareTable {
            key: key.into(),
            title: key.into(),
            of: "boxes",
            axis: "class".into(),
            ordered: false,
            distances: vec![Some(0.5 * own.iter().zip(other).map(|(a, b)| (a - b).abs()).sum::<f64>())],
            labels: labels.iter().map(|label| (*label).to_owned()).collect(),
            shares: vec![Some(own.to_vec()), Some(other.to_vec())],
        }
    }

    #[test]
    fn the_largest_difference_is_said_in_words() {
        let sizes = table("sizes", &["small", "medium", "large"], &[0.16, 0.5, 0.34], &[0.512, 0.4, 0.088]);
        let said = of_pair(0, 'A', 'B', &[], std::slice::from_ref(&sizes));
        assert_eq!(
            said,
            ["B has 3.2 times the share of boxes smaller than 32 \u{d7} 32 px: 51.2% against 16.0% in A."]
        );
        let classes = table("classes", &["car", "bus", "van"], &[0.5, 0.4, 0.1], &[1.0, 0.0, 0.0]);
        let said = of_pair(0, 'A', 'B', &[], &[classes]);
        assert!(
            said[0].starts_with("B has 2.0 times the share of car boxes") && said[0].ends_with("bus, van."),
            "{said:?}"
        );
        let alike = table("classes", &["car", "bus"], &[0.5, 0.5], &[0.55, 0.45]);
        assert_eq!(of_pair(0, 'A', 'B', &[], &[alike]), Vec::<String>::new());
    }

    #[test]
    fn who_has_more_boxes_a_frame_comes_first() {
        let row = |values| NumberRow { name: "boxes a frame, mean", values };
        let said = |values| of_pair(0, 'A', 'B', &[row(values)], &[]);
        assert_eq!(
            said(vec![Some(4.0), Some(10.0)]),
            ["B has 2.5 times as many boxes a frame as A: 10.0 against 4.0."]
        );
        assert!(said(vec![Some(4.0), Some(4.5)]).is_empty() && said(vec![Some(0.0), Some(4.5)]).is_empty());
    }
}
