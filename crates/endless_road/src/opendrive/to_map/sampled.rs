//! All roads of a document, sampled once.

use super::super::OpenDriveError;
use super::super::document::{Document, End, LaneRecord};
use super::super::geometry::{LaneShape, RoadShape, SectionShape};
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
pub(super) struct Sampled<'a> {
    pub(super) document: &'a Document,
    pub(super) roads: Vec<RoadShape<'a>>,
    /// By road; `None` for a section without length.
    pub(super) sections: Vec<Vec<Option<SectionShape>>>,
    road_places: BTreeMap<&'a str, usize>,
}

impl<'a> Sampled<'a> {
    pub(super) fn new(document: &'a Document) -> Result<Self, OpenDriveError> {
        let metres: f64 = document.roads.iter().map(|road| road.length).sum();
        if metres > MOST_METRES as f64 {
            return Err(OpenDriveError::TooMuch { what: "metres of road", most: MOST_METRES });
        }
        if document.roads.iter().map(|road| road.sections.len()).sum::<usize>() > MOST_SECTIONS {
            return Err(OpenDriveError::TooMuch { what: "lane sections", most: MOST_SECTIONS });
        }
        let roads: Vec<RoadShape<'a>> = document.roads.iter().map(RoadShape::new).collect();
        let mut points = 0;
        let mut sections = Vec::new();
        for shape in &roads {
            let mut of_road = Vec::new();
            for (place, section) in shape.road.sections.iter().enumerate() {
                let from = if place == 0 { 0.0 } else { section.s.max(0.0) };
                let to =
                    shape.road.sections.get(place + 1).map_or(shape.road.length, |next| next.s).min(shape.road.length);
                let sampled = (to - from > 1e-3).then(|| SectionShape::new(shape, section, from, to));
                points += sampled.as_ref().map_or(0, |s| s.stations.len() * (s.lanes.len() + 1));
                if points > MOST_POINTS {
                    return Err(OpenDriveError::TooMuch { what: "points on lane borders", most: MOST_POINTS });
                }
                let lanes = sampled.iter().flat_map(|s| &s.lanes);
                if lanes
                    .flat_map(|lane| lane.left.iter().chain(&lane.right))
                    .any(|p| !p.is_finite() || p.abs().max_element() > FARTHEST_M)
                {
                    let (id, km) = (&shape.road.id, FARTHEST_M / 1000.0);
                    let what = format!("of road {id} reaches further than {km} km");
                    return Err(OpenDriveError::Format { line: section.line, element: "laneSection".to_owned(), what });
                }
                if let Some(wrong) = sampled.as_ref().and_then(|section| implausible(shape, section)) {
                    let what = format!("of road {} {wrong}", shape.road.id);
                    return Err(OpenDriveError::Format { line: section.line, element: "laneSection".to_owned(), what });
                }
                of_road.push(sampled);
            }
            sections.push(of_road);
        }
        let mut road_places = BTreeMap::new();
        for (place, road) in document.roads.iter().enumerate() {
            road_places.entry(road.id.as_str()).or_insert(place);
        }
        Ok(Self { document, roads, sections, road_places })
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
    pub(super) fn section_at(&self, road: usize, end: End) -> usize {
        match end {
            End::Start => 0,
            End::End => self.document.roads[road].sections.len() - 1,
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
