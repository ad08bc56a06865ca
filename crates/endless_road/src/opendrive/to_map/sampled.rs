//! All roads of a document, sampled once.

use super::super::OpenDriveError;
use super::super::document::{ContactPoint, LaneRecord, OpenDriveDocument, Road};
use super::super::geometry::{LaneShape, RoadShape, SectionShape};
use crate::ImportNote;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

/// More than a map can hold: points of borders.
const MOST_POINTS: usize = 10_000_000;
/// Lane sections.
const MOST_SECTIONS: usize = 500_000;
/// Metres of road.
const MOST_METRES: usize = 5_000_000;
/// No lane is higher or deeper than this, metres.
const HIGHEST_M: f64 = 10_000.0;
/// No lane lies further beside its reference line than this, metres.
const ASIDE_M: f64 = 1000.0;
/// No point of a map is further from its origin, metres: less than numbers may go to, so that a map near this limit can
/// be written and read again.
const FARTHEST_M: f64 = 0.85 * super::super::parse::FARTHEST_M;

/// One lane of one section.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct LaneKey {
    /// Place in the document's roads.
    pub(super) road: usize,
    /// Place in the road's sections.
    pub(super) section: usize,
    /// Its id.
    pub(super) lane: i32,
}

impl LaneKey {
    /// All keys of a road.
    pub(super) fn all_of(road: usize) -> std::ops::Range<Self> {
        let first = |road| Self { road, section: 0, lane: i32::MIN };
        first(road)..first(road + 1)
    }
}

/// A document with the shape of all its lanes.
pub(super) struct SampledDocument<'a> {
    pub(super) document: &'a OpenDriveDocument,
    pub(super) roads: Vec<RoadShape<'a>>,
    /// By road.
    pub(super) sections: Vec<RoadSections>,
    road_places: BTreeMap<&'a str, usize>,
}

/// The sections of a road; `None` for one without length.
type RoadSections = Vec<Option<SectionShape>>;

/// Samples all roads. Those whose lanes no map can hold leave the document, with a note.
///
/// # Errors
/// If there is more than a map can hold.
pub(super) fn sample(document: &mut OpenDriveDocument) -> Result<Vec<RoadSections>, OpenDriveError> {
    let metres: f64 = document.roads.iter().map(|road| road.length).sum();
    if metres > MOST_METRES as f64 {
        return Err(OpenDriveError::TooMuch { what: "metres of road", most: MOST_METRES });
    }
    if document.roads.iter().map(|road| road.sections.len()).sum::<usize>() > MOST_SECTIONS {
        return Err(OpenDriveError::TooMuch { what: "lane sections", most: MOST_SECTIONS });
    }
    let (mut points, mut sections) = (0, Vec::new());
    let mut stays = Vec::with_capacity(document.roads.len());
    for road in &document.roads {
        let sampled = sample_road(road, &mut points)?;
        stays.push(sampled.is_ok());
        match sampled {
            Ok(of_road) => sections.push(of_road),
            Err(note) => document.roads_left_out.push(note),
        }
    }
    let mut stays = stays.into_iter();
    document.roads.retain(|_| stays.next().unwrap_or(true));
    Ok(sections)
}

/// Samples one road, or says why no map can hold it; counts the points on borders of all roads.
fn sample_road(road: &Road, points: &mut usize) -> Result<Result<RoadSections, ImportNote>, OpenDriveError> {
    let shape = RoadShape::new(road);
    let mut sections = Vec::new();
    for (place, section) in road.sections.iter().enumerate() {
        let from = if place == 0 { 0.0 } else { section.s.max(0.0) };
        let to = road.sections.get(place + 1).map_or(road.length, |next| next.s).min(road.length);
        let sampled = (to - from > 1e-3).then(|| SectionShape::new(&shape, section, from, to));
        *points += sampled.as_ref().map_or(0, |s| s.stations.len() * (s.lanes.len() + 1));
        if *points > MOST_POINTS {
            return Err(OpenDriveError::TooMuch { what: "points on lane borders", most: MOST_POINTS });
        }
        if let Some(wrong) = sampled.as_ref().and_then(|section| implausible(&shape, section)) {
            let text = format!("of road {} {wrong}; the road was left out", road.id);
            return Ok(Err(ImportNote { place: format!("line {}: laneSection", section.line), text }));
        }
        sections.push(sampled);
    }
    Ok(Ok(sections))
}

impl<'a> SampledDocument<'a> {
    /// A document with its roads as they were sampled.
    pub(super) fn new(document: &'a OpenDriveDocument, sections: Vec<RoadSections>) -> Self {
        let roads = document.roads.iter().map(RoadShape::new).collect();
        let mut road_places = BTreeMap::new();
        for (place, road) in document.roads.iter().enumerate() {
            road_places.entry(road.id.as_str()).or_insert(place);
        }
        Self { document, roads, sections, road_places }
    }

    /// The place of the road of this id.
    pub(super) fn road(&self, id: &str) -> Option<usize> {
        self.road_places.get(id).copied()
    }

    /// What the document says of a lane.
    pub(super) fn record(&self, key: LaneKey) -> Option<&'a LaneRecord> {
        let section = self.document.roads.get(key.road)?.sections.get(key.section)?;
        section.lanes.iter().find(|lane| lane.id == key.lane)
    }

    /// The shape of a lane.
    pub(super) fn lane(&self, key: LaneKey) -> Option<&LaneShape> {
        let section = self.sections.get(key.road)?.get(key.section)?.as_ref()?;
        section.lanes.iter().find(|lane| lane.id == key.lane)
    }

    /// The section at an end of a road.
    pub(super) fn section_at(&self, road: usize, end: ContactPoint) -> usize {
        match end {
            ContactPoint::Start => 0,
            ContactPoint::End => self.document.roads[road].sections.len() - 1,
        }
    }

    /// Every lane of every section but the centre lanes.
    pub(super) fn keys(&self) -> impl Iterator<Item = (LaneKey, &'a LaneRecord)> {
        self.document.roads.iter().enumerate().flat_map(|(road, record)| {
            record.sections.iter().enumerate().flat_map(move |(section, lanes)| {
                let lanes = lanes.lanes.iter().filter(|lane| lane.id != 0);
                lanes.map(move |lane| (LaneKey { road, section, lane: lane.id }, lane))
            })
        })
    }

    /// Whether traffic on a lane runs in the direction of `s`.
    pub(super) fn runs_along(&self, key: LaneKey) -> bool {
        let left_hand = self.document.roads[key.road].left_hand;
        let reversed = self.record(key).is_some_and(|lane| lane.reversed);
        ((key.lane < 0) != left_hand) != reversed
    }
}

/// What no lane of a map does, if one does.
fn implausible(shape: &RoadShape<'_>, section: &SectionShape) -> Option<String> {
    let far = |p: &DVec3| !p.is_finite() || p.abs().max_element() > FARTHEST_M;
    if section.lanes.iter().flat_map(|lane| lane.left.iter().chain(&lane.right)).any(far) {
        return Some(format!("reaches further than {} km", FARTHEST_M / 1000.0));
    }
    if let Some(&s) = section.stations.iter().find(|&&s| shape.roll(s).abs() > FRAC_PI_2) {
        return Some(format!("leans by {:.1} radians at s={s:.1}", shape.roll(s)));
    }
    for line in section.lanes.iter().flat_map(|lane| [&lane.left, &lane.right]) {
        for (p, &s) in line.iter().zip(&section.stations) {
            let aside = p.truncate().distance(shape.pose(s).position);
            if aside > ASIDE_M {
                return Some(format!("has a lane {aside:.0} m off its reference line at s={s:.1}"));
            }
            if p.z.abs() > HIGHEST_M {
                return Some(format!("is {:.0} m high at s={s:.1}", p.z));
            }
        }
    }
    None
}
