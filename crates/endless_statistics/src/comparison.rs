//! Datasets side by side.

mod hints;
mod table;

pub use table::{NumberRow, ShareTable, Side};

use crate::merge::Merge as _;
use crate::{BoxStatistics, DatasetStatistics, Distribution, distributions};
use endless_world::ObjectClass;
use serde::Serialize;
use std::collections::BTreeMap;

/// Parts of these distributions are compared by themselves, too: each class.
const BY_CLASS: [&str; 4] = ["side_px", "aspect_ratio", "visibility", "distance_m"];
/// What has fewer values than this is not compared by class.
const FEW: u64 = 100;

/// Datasets side by side; the last is the one that the others are compared with.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Comparison {
    /// Version of these fields.
    pub format: u32,
    /// How distances are measured.
    pub distance: &'static str,
    /// The datasets.
    pub sides: Vec<Side>,
    /// Plain numbers.
    pub numbers: Vec<NumberRow>,
    /// Shares, the most different first.
    pub distributions: Vec<ShareTable>,
    /// What stands out, in words.
    pub hints: Vec<String>,
    /// Classes that another dataset does not tell apart, and what they were counted as.
    pub classes_counted_as: BTreeMap<ObjectClass, ObjectClass>,
}

impl Comparison {
    /// Version of the fields that this program writes.
    pub const FORMAT: u32 = 1;

    /// Lays datasets side by side: the first as `A`. The last is what the others are compared with. Where one does not
    /// tell riders from people on foot or vans from cars, as COCO does not, they are counted as these on all sides.
    pub fn new(sides: Vec<DatasetStatistics>) -> Self {
        let classes_counted_as = counted_as(&sides);
        let side = |(statistics, letter): (DatasetStatistics, char)| Side {
            letter,
            name: statistics.name(),
            statistics: with_classes(statistics, &classes_counted_as),
        };
        let sides: Vec<Side> = sides.into_iter().zip('A'..='Z').map(side).collect();
        let mut tables = share_tables(&sides);
        // The sort keeps the order of the report among equals.
        tables.sort_by(|a, b| b.distance().total_cmp(&a.distance()));
        let numbers = numbers(&sides);
        let hints = hints::hints(&sides, &numbers, &tables);
        Self {
            format: Self::FORMAT,
            distance: "total variation: half the sum of the differences of shares, 0 to 1",
            sides,
            numbers,
            distributions: tables,
            hints,
            classes_counted_as,
        }
    }
}

fn counted_as(sides: &[DatasetStatistics]) -> BTreeMap<ObjectClass, ObjectClass> {
    let known = |class| sides.iter().all(|side| side.classes.contains_key(&class));
    let wider = [(ObjectClass::Rider, ObjectClass::Pedestrian), (ObjectClass::Van, ObjectClass::Car)];
    wider.into_iter().filter(|(class, as_class)| !known(*class) && known(*as_class)).collect()
}

fn with_classes(mut of: DatasetStatistics, counted_as: &BTreeMap<ObjectClass, ObjectClass>) -> DatasetStatistics {
    let mut classes: BTreeMap<ObjectClass, BoxStatistics> = BTreeMap::new();
    for (class, boxes) in of.classes {
        classes.entry(*counted_as.get(&class).unwrap_or(&class)).or_default().absorb(boxes);
    }
    of.classes = classes;
    of.finish()
}

fn share_tables(sides: &[Side]) -> Vec<ShareTable> {
    let of_sides: Vec<Vec<Distribution>> = sides.iter().map(|side| compared(&side.statistics)).collect();
    let mut keys: Vec<&str> = Vec::new();
    for distribution in of_sides.iter().flatten() {
        if !keys.contains(&distribution.key.as_str()) {
            keys.push(&distribution.key);
        }
    }
    let table = |key: &str| {
        let found: Vec<Option<&Distribution>> =
            of_sides.iter().map(|side| side.iter().find(|distribution| distribution.key == key)).collect();
        let known: Vec<&Distribution> = found.iter().flatten().copied().collect();
        // What only one side knows cannot be compared.
        let (first, rest) = known.split_first()?;
        if rest.is_empty() {
            return None;
        }
        let labels = Distribution::all_labels(&known);
        let last = *found.last()?;
        let distance = |side: &Option<&Distribution>| Some(side.as_ref()?.total_variation(last?));
        let shares = |side: &Option<&Distribution>| {
            let side = side.as_ref()?;
            Some(labels.iter().map(|label| side.share(label)).collect())
        };
        Some(ShareTable {
            key: key.into(),
            title: first.title.clone(),
            of: first.of,
            axis: first.axis.clone(),
            ordered: first.ordered,
            distances: found[..found.len() - 1].iter().map(distance).collect(),
            shares: found.iter().map(shares).collect(),
            labels,
        })
    };
    keys.into_iter().filter_map(table).collect()
}

/// Those of a dataset, some of them class by class, too.
fn compared(statistics: &DatasetStatistics) -> Vec<Distribution> {
    let mut all = distributions(statistics);
    let by_class: Vec<Distribution> = all
        .iter()
        .filter(|distribution| BY_CLASS.contains(&distribution.key.as_str()))
        .flat_map(|whole| whole.parts.iter().filter_map(|(name, _)| whole.part(name)))
        .filter(|part| part.total() >= FEW)
        .collect();
    all.extend(by_class);
    all
}

fn numbers(sides: &[Side]) -> Vec<NumberRow> {
    type Number = fn(&DatasetStatistics) -> Option<f64>;
    let rows: [(&'static str, Number); 13] = [
        ("videos", |of| (of.totals.videos > 0).then_some(of.totals.videos as f64)),
        ("camera views", |of| Some(of.world.as_ref()?.scenes.views.len() as f64)),
        ("camera frames", |of| Some(of.totals.camera_frames as f64)),
        ("boxes", |of| Some(of.totals.boxes as f64)),
        ("boxes a frame, mean", |of| of.totals.boxes_per_frame.mean()),
        ("boxes a frame, median", |of| of.totals.boxes_per_frame.median()),
        ("boxes a frame, most", |of| of.totals.boxes_per_frame.max().map(|most| most as f64)),
        ("frames without a box, %", |of| {
            Some(100.0 * of.totals.empty_frames as f64 / of.totals.camera_frames_read.max(1) as f64)
        }),
        ("box size, mean, px", |of| of.boxes.side_px.mean()),
        ("box size, mean, % of the picture", |of| of.boxes.side_percent.mean()),
        ("visibility, mean", |of| of.boxes.visibility.mean()),
        ("distance, mean, m", |of| of.boxes.distance_m.mean()),
        ("speed of vehicles that move, mean, m/s", |of| of.world.as_ref()?.motion.vehicles.speed_mps.mean()),
    ];
    let row = |(name, number): (&'static str, Number)| NumberRow {
        name,
        values: sides.iter().map(|side| number(&side.statistics)).collect(),
    };
    rows.into_iter().map(row).filter(|row| row.values.iter().any(Option::is_some)).collect()
}
