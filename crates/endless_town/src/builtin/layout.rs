//! A town's layout in the terms of an OpenStreetMap extract, in metres: ways with tags, land use, buildings. Roads that
//! cross at one level meet there; roads that end on another join it.

use super::layout_geometry::{along, split_at};
use crate::building::BuildingKind;
use crate::dressing::{BuildingZone, TownPreset};
use endless_road::osm::{
    OsmExtract, OsmMember, OsmMemberKind, OsmNode, OsmOptions, OsmRelation, OsmTags, OsmWay, map_from,
};
use endless_road::{RoadMap, Terrain};
use endless_world::DrivingSide;
use glam::DVec2;
use std::collections::BTreeMap;

/// Ways of parks lead this far beyond its edge, metres.
const GATE_M: f64 = 2.5;
/// The terrain reaches this far beyond the roads, and its grid, metres.
const TERRAIN_BEYOND_M: f64 = 700.0;
const TERRAIN_STEP_M: f64 = 4.0;

/// A way that is no road, or one.
#[derive(Debug, Clone)]
pub(super) struct LayoutWay {
    pub(super) tags: OsmTags,
    pub(super) points: Vec<DVec2>,
    pub(super) road: bool,
}

/// A town while it is being described.
#[derive(Debug, Clone)]
pub(super) struct TownLayout {
    /// Degrees north and east: whose customs hold.
    pub(super) place: [f64; 2],
    pub(super) lines: Vec<LayoutWay>,
    /// Tags of places; on the nearest point of a road where one is near.
    pub(super) marks: Vec<(DVec2, OsmTags)>,
    pub(super) zones: Vec<BuildingZone>,
    /// Forbidden turns: from a way, at a place, to a way.
    pub(super) forbidden: Vec<(usize, DVec2, usize)>,
    /// Roads that reach further than this from the middle, north or east, leave the map there, metres.
    pub(super) border_m: Option<f64>,
}

/// `secondary lanes=4 sidewalk=both`: the first word is the value of `key`, if it is not a pair itself.
pub(super) fn tags(key: &str, words: &str) -> OsmTags {
    let mut tags = OsmTags::default();
    for word in words.split_whitespace() {
        match word.split_once('=') {
            Some((k, v)) => tags.set(k.to_owned(), v.to_owned()),
            None => tags.set(key.to_owned(), word.to_owned()),
        }
    }
    tags
}

impl TownLayout {
    /// An empty layout of a place, degrees north and east.
    pub(super) fn of(place: [f64; 2]) -> Self {
        Self { place, lines: Vec::new(), marks: Vec::new(), zones: Vec::new(), forbidden: Vec::new(), border_m: None }
    }

    /// A road of a class, with more tags; its number.
    pub(super) fn road(&mut self, words: &str, points: &[DVec2]) -> usize {
        self.lines.push(LayoutWay { tags: tags("highway", words), points: points.to_vec(), road: true });
        self.lines.len() - 1
    }

    /// Nobody turns left from one road to another.
    pub(super) fn no_left(&mut self, from: usize, at: DVec2, to: usize) {
        self.forbidden.push((from, at, to));
    }

    /// A ring of a roundabout, driven counter-clockwise.
    pub(super) fn roundabout(&mut self, words: &str, centre: DVec2, radius: f64) {
        let ring = super::layout_geometry::arc(centre, radius, 0.0, 360.0);
        self.road(&format!("{words} junction=roundabout oneway=yes"), &ring);
    }

    /// A road that crosses something on a bridge around a place, from `half` metres before it to `half` behind.
    pub(super) fn road_with_bridges(&mut self, words: &str, points: &[DVec2], bridges: &[(DVec2, f64)]) {
        let mut cuts: Vec<(f64, f64)> = bridges
            .iter()
            .map(|&(at, half)| {
                let s = along(points, at);
                (s - half, s + half)
            })
            .collect();
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let ends: Vec<f64> = cuts.iter().flat_map(|c| [c.0, c.1]).collect();
        for (k, part) in split_at(points, &ends).into_iter().enumerate() {
            let bridge = if k % 2 == 1 { " bridge=yes layer=1" } else { "" };
            self.road(&format!("{words}{bridge}"), &part);
        }
    }

    /// Land of a use: `landuse=farmland`, `leisure=park`, `natural=water`, `place=square`.
    pub(super) fn land(&mut self, words: &str, outline: &[DVec2]) {
        let mut points = outline.to_vec();
        points.push(outline[0]);
        self.lines.push(LayoutWay { tags: tags("landuse", words), points, road: false });
    }

    /// A paved square to walk on.
    pub(super) fn square(&mut self, outline: &[DVec2]) {
        self.land("place=square", outline);
    }

    /// A park of four corners, with ways across that lead to the sidewalks around it.
    pub(super) fn park(&mut self, corners: &[DVec2]) {
        self.land("leisure=park", corners);
        let middle = corners.iter().sum::<DVec2>() / corners.len() as f64;
        let gate = |k: usize| {
            let at = corners[k % corners.len()].midpoint(corners[(k + 1) % corners.len()]);
            at + (at - middle).normalize_or_zero() * GATE_M
        };
        let half = gate(0).distance(middle).min(gate(1).distance(middle));
        let ring = super::layout_geometry::arc(middle, 0.36 * half, 0.0, 360.0);
        for k in 0..corners.len() {
            let on_ring = ring.iter().copied().min_by(|a, b| a.distance(gate(k)).total_cmp(&b.distance(gate(k))));
            self.path(&[on_ring.unwrap_or(middle), gate(k)]);
        }
        self.path(&ring);
    }

    /// A way on foot.
    pub(super) fn path(&mut self, points: &[DVec2]) {
        let tags = tags("highway", "footway width=2.6 surface=paving_stones");
        self.lines.push(LayoutWay { tags, points: points.to_vec(), road: false });
    }

    /// A building of a kind: `church building:levels=3`.
    pub(super) fn building(&mut self, words: &str, outline: &[DVec2]) {
        let mut points = outline.to_vec();
        points.push(outline[0]);
        self.lines.push(LayoutWay { tags: tags("building", words), points, road: false });
    }

    /// A row of trees.
    pub(super) fn tree_row(&mut self, points: &[DVec2]) {
        self.lines.push(LayoutWay { tags: tags("natural", "tree_row"), points: points.to_vec(), road: false });
    }

    /// Traffic lights where roads meet.
    pub(super) fn lights(&mut self, at: DVec2) {
        self.marks.push((at, tags("highway", "traffic_signals")));
    }

    /// A zebra crossing over a road.
    pub(super) fn zebra(&mut self, at: DVec2) {
        self.marks.push((at, tags("highway", "crossing crossing=marked")));
    }

    /// A speed bump on a road.
    pub(super) fn bump(&mut self, at: DVec2) {
        self.marks.push((at, tags("traffic_calming", "bump")));
    }

    /// Something that stands at a place: `amenity=bench`.
    pub(super) fn feature(&mut self, words: &str, at: DVec2) {
        self.marks.push((at, tags("amenity", words)));
    }

    /// What is built on land of an outline, with the fewest and most storeys and the share of lots left open.
    pub(super) fn zone(
        &mut self,
        outline: Vec<DVec2>,
        kinds: &'static [(BuildingKind, f64)],
        storeys: (u32, u32),
        open: f64,
    ) {
        self.zones.push(BuildingZone { outline, kinds, storeys, open });
    }

    /// The map with its roads built, on a terrain; and the preset with the layout's zones.
    pub(super) fn build(mut self, height: Option<&dyn Fn(DVec2) -> f64>, preset: TownPreset) -> (RoadMap, TownPreset) {
        self.meet();
        let terrain = height.map(|height| {
            let points = self.lines.iter().filter(|l| l.road).flat_map(|l| &l.points);
            let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), &p| (l.min(p), h.max(p)));
            Terrain::new(low - TERRAIN_BEYOND_M, high + TERRAIN_BEYOND_M, TERRAIN_STEP_M, height)
        });
        let options = OsmOptions { driving_side: Some(DrivingSide::Right), terrain };
        let map = map_from(&self.extract(), &options).expect("a plan has roads");
        (map, TownPreset { zones: self.zones, ..preset })
    }

    fn extract(&self) -> OsmExtract {
        let degrees = |p: DVec2| OsmExtract::degrees(self.place, p);
        let mut extract = OsmExtract::default();
        let mut ids: BTreeMap<(i64, i64, i64), i64> = BTreeMap::new();
        let mut on_roads: Vec<(DVec2, i64)> = Vec::new();
        let beyond =
            || self.lines.iter().flat_map(|l| &l.points).map(|p| p.abs().max_element()).fold(0.0, f64::max) + 100.0;
        let half = self.border_m.unwrap_or_else(beyond);
        let (low, high) = (degrees(DVec2::splat(-half)), degrees(DVec2::splat(half)));
        let centred = |k: usize| (high[k] - self.place[k]).max(self.place[k] - low[k]);
        let reach = [centred(0), centred(1)];
        extract.bounds = Some(endless_road::osm::OsmBounds {
            low: [self.place[0] - reach[0], self.place[1] - reach[1]],
            high: [self.place[0] + reach[0], self.place[1] + reach[1]],
        });
        for (way, line) in self.lines.iter().enumerate() {
            let mut nodes = Vec::new();
            let last = line.points.len() - 1;
            for (k, &p) in line.points.iter().enumerate() {
                // Land shares no nodes with roads, nor roads of different levels but at their ends.
                let level = line.tags.get("layer").filter(|_| k > 0 && k < last).map_or(0, |l| l.parse().unwrap_or(0));
                let level = if line.road { 1 + level } else { 0 };
                let key = ((p.x * 20.0).round() as i64, (p.y * 20.0).round() as i64, level);
                let next = ids.len() as i64 + 1;
                let id = *ids.entry(key).or_insert(next);
                extract.nodes.entry(id).or_insert_with(|| {
                    let [lat, lon] = degrees(p);
                    OsmNode { lat, lon, tags: OsmTags::default() }
                });
                if line.road {
                    on_roads.push((p, id));
                }
                nodes.push(id);
            }
            nodes.dedup();
            extract.ways.push(OsmWay { id: way as i64 + 1, nodes, tags: line.tags.clone() });
        }
        for (at, tags) in &self.marks {
            let on_road = tags.get("highway").is_some_and(|v| matches!(v, "traffic_signals" | "crossing"));
            if on_road {
                let near = on_roads.iter().min_by(|a, b| a.0.distance(*at).total_cmp(&b.0.distance(*at)));
                if let Some(node) = near.and_then(|(_, id)| extract.nodes.get_mut(id)) {
                    tags.iter().for_each(|(k, v)| node.tags.set(k.to_owned(), v.to_owned()));
                }
                continue;
            }
            let [lat, lon] = degrees(*at);
            let id = 1_000_000 + extract.nodes.len() as i64;
            extract.nodes.insert(id, OsmNode { lat, lon, tags: tags.clone() });
        }
        for (k, (from, at, to)) in self.forbidden.iter().enumerate() {
            let Some(&(_, via)) = on_roads.iter().min_by(|a, b| a.0.distance(*at).total_cmp(&b.0.distance(*at))) else {
                continue;
            };
            let member = |kind, id, role: &str| OsmMember { kind, id, role: role.to_owned() };
            let members = vec![
                member(OsmMemberKind::Way, *from as i64 + 1, "from"),
                member(OsmMemberKind::Node, via, "via"),
                member(OsmMemberKind::Way, *to as i64 + 1, "to"),
            ];
            let tags = tags("restriction", "no_left_turn type=restriction");
            extract.relations.push(OsmRelation { id: k as i64 + 1, members, tags });
        }
        extract
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roads_of_one_level_meet_and_those_of_two_do_not() {
        let p = DVec2::new;
        let mut layout = TownLayout::of([50.0, 9.0]);
        layout.road("residential", &[p(-50.0, 0.0), p(50.0, 0.0)]);
        layout.road("residential", &[p(0.0, -50.0), p(0.0, 50.0)]);
        layout.road("residential", &[p(20.0, 3.4), p(20.0, 60.0)]);
        layout.road("residential bridge=yes layer=1", &[p(-20.0, -30.0), p(-20.0, 30.0)]);
        layout.meet();
        assert_eq!(layout.lines[0].points.len(), 4, "{:?}", layout.lines[0].points);
        assert_eq!(layout.lines[1].points.len(), 3);
        assert_eq!(layout.lines[2].points.len(), 2);
        assert_eq!(layout.lines[3].points.len(), 2);
        let extract = layout.extract();
        assert_eq!(extract.nodes.len(), 4 + 2 + 1 + 2);
    }
}
