//! What all steps of an import share: the extract, its projection to metres and bounds, the country's rules, where land
//! is built up, and the notes to the user.

use super::country::CountryRules;
use super::extract::{OsmExtract, OsmTags};
use super::formation::Formation;
use super::mirror;
use super::projection::Projection;
use super::street_segment::WayVertex;
use crate::ImportNote;
use glam::DVec2;
use std::collections::{BTreeMap, BTreeSet};

/// Roads go on this far beyond the extract's box, metres.
const MARGIN_M: f64 = 40.0;
/// Side of the squares in which buildings are counted, metres.
const SQUARE_M: f64 = 80.0;
/// Missing nodes that are noted one by one.
const MOST_NOTES: usize = 200;

/// Shared by all steps of an import.
pub(super) struct ImportContext<'a> {
    pub(super) extract: &'a OsmExtract,
    pub(super) projection: Projection,
    pub(super) country: CountryRules,
    /// Seen in a mirror: traffic keeps to the left.
    pub(super) mirrored: bool,
    pub(super) notes: Vec<ImportNote>,
    /// The land as roads shape it, where its relief is known.
    pub(super) formation: Option<Formation>,
    bounds: Option<[DVec2; 2]>,
    built: BTreeSet<(i64, i64)>,
    missing: BTreeMap<i64, usize>,
    cuts: i64,
}

impl<'a> ImportContext<'a> {
    pub(super) fn new(extract: &'a OsmExtract, left_hand: Option<bool>) -> Self {
        let (lat, lon) = centre(extract);
        let projection = Projection::around(lat, lon);
        let country = CountryRules::at(lat, lon);
        let mut context = Self {
            extract,
            projection,
            country,
            mirrored: left_hand.unwrap_or(country.left_hand),
            notes: Vec::new(),
            formation: None,
            bounds: None,
            built: BTreeSet::new(),
            missing: BTreeMap::new(),
            cuts: 0,
        };
        context.find_bounds();
        context.find_buildings();
        context
    }

    fn find_bounds(&mut self) {
        let Some(bounds) = self.extract.bounds else { return };
        let corners = [bounds.low, [bounds.low[0], bounds.high[1]], bounds.high, [bounds.high[0], bounds.low[1]]]
            .map(|[lat, lon]| self.seen(self.projection.project(lat, lon)));
        let low = corners.into_iter().reduce(DVec2::min).expect("four") - MARGIN_M;
        let high = corners.into_iter().reduce(DVec2::max).expect("four") + MARGIN_M;
        // Some editors leave the box of the first download: a box that most roads do not know is none.
        let (mut inside, mut all) = (0usize, 0usize);
        for way in self.extract.ways.iter().filter(|w| w.tags.get("highway").is_some()) {
            for at in way.nodes.iter().filter_map(|&n| self.place(n)) {
                all += 1;
                inside += usize::from(at.cmpge(low).all() && at.cmple(high).all());
            }
        }
        if inside * 10 >= all * 6 {
            self.bounds = Some([low, high]);
        }
    }

    fn find_buildings(&mut self) {
        for way in self.extract.ways.iter().filter(|w| w.tags.get("building").is_some()) {
            if let Some(at) = way.nodes.iter().find_map(|&n| self.place(n)) {
                let (x, y) = square(at);
                self.built.extend((-1..=1).flat_map(|i| (-1..=1).map(move |j| (x + i, y + j))));
            }
        }
    }

    fn seen(&self, p: DVec2) -> DVec2 {
        if self.mirrored { DVec2::new(-p.x, p.y) } else { p }
    }

    /// Where a node lies, metres; as seen in the mirror for left-hand traffic.
    pub(super) fn place(&self, node: i64) -> Option<DVec2> {
        let node = self.extract.nodes.get(&node)?;
        Some(self.seen(self.projection.project(node.lat, node.lon)))
    }

    /// Height of the land at a place, metres.
    pub(super) fn ground(&self, at: DVec2) -> f64 {
        self.formation.as_ref().map_or(0.0, |f| f.height(at))
    }

    /// A road's tags, as seen in the mirror for left-hand traffic.
    pub(super) fn tags(&self, tags: &OsmTags) -> OsmTags {
        if self.mirrored { mirror::tags(tags) } else { tags.clone() }
    }

    /// The tags of a node.
    pub(super) fn node_tags(&self, node: i64) -> Option<&'a OsmTags> {
        self.extract.nodes.get(&node).map(|n| &n.tags)
    }

    /// Whether a place lies inside the extract.
    pub(super) fn inside(&self, at: DVec2) -> bool {
        self.bounds.is_none_or(|[low, high]| at.cmpge(low).all() && at.cmple(high).all())
    }

    /// The extract's edges.
    pub(super) fn bounds(&self) -> Option<[DVec2; 2]> {
        self.bounds
    }

    /// Where a line leaves the extract.
    pub(super) fn cut(&mut self, a: DVec2, b: DVec2) -> WayVertex {
        let (mut low, mut high) = (0.0, 1.0);
        let a_inside = self.inside(a);
        for _ in 0..40 {
            let middle = 0.5 * (low + high);
            if self.inside(a.lerp(b, middle)) == a_inside {
                low = middle;
            } else {
                high = middle;
            }
        }
        self.cuts += 1;
        WayVertex { node: i64::MIN + self.cuts, at: a.lerp(b, if a_inside { low } else { high }) }
    }

    /// Whether there are buildings near by.
    pub(super) fn built_up(&self, at: DVec2) -> bool {
        self.built.contains(&square(at))
    }

    /// A way names a node that is not in the file.
    pub(super) fn missing(&mut self, way: i64, _node: i64) {
        *self.missing.entry(way).or_default() += 1;
    }

    /// Something to tell the user.
    pub(super) fn note(&mut self, place: impl Into<String>, text: impl Into<String>) {
        self.notes.push(ImportNote { place: place.into(), text: text.into() });
    }

    /// All that there is to tell.
    pub(super) fn into_notes(mut self) -> Vec<ImportNote> {
        let missing = std::mem::take(&mut self.missing);
        let ways = missing.len();
        for (way, count) in missing.into_iter().take(MOST_NOTES) {
            self.note(format!("way {way}"), format!("{count} of its nodes are not in the file: it is cut there"));
        }
        if ways > MOST_NOTES {
            self.note("ways", format!("{} more ways lack nodes", ways - MOST_NOTES));
        }
        self.notes
    }
}

fn square(at: DVec2) -> (i64, i64) {
    let cell = (at / SQUARE_M).floor();
    (cell.x as i64, cell.y as i64)
}

/// The middle of the box, or of the nodes of roads, degrees.
fn centre(extract: &OsmExtract) -> (f64, f64) {
    if let Some(b) = extract.bounds {
        return (0.5 * (b.low[0] + b.high[0]), 0.5 * (b.low[1] + b.high[1]));
    }
    let roads = extract.ways.iter().filter(|w| w.tags.get("highway").is_some());
    let mut low = [f64::INFINITY; 2];
    let mut high = [f64::NEG_INFINITY; 2];
    for node in roads.flat_map(|w| &w.nodes).filter_map(|n| extract.nodes.get(n)) {
        for (i, v) in [node.lat, node.lon].into_iter().enumerate() {
            low[i] = low[i].min(v);
            high[i] = high[i].max(v);
        }
    }
    let middle = |i: usize| if low[i] <= high[i] { 0.5 * (low[i] + high[i]) } else { 0.0 };
    (middle(0), middle(1))
}
