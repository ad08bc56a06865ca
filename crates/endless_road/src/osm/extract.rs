//! What an OpenStreetMap file holds: nodes, ways, relations, each with tags.

use glam::DVec2;
use std::collections::BTreeMap;

/// Keys and values.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct OsmTags(BTreeMap<String, String>);

impl OsmTags {
    /// The value of a key.
    pub fn get(&self, key: &str) -> Option<&str> {
        self.0.get(key).map(String::as_str)
    }

    /// Whether a key has one of these values.
    pub fn is(&self, key: &str, values: &[&str]) -> bool {
        self.get(key).is_some_and(|v| values.contains(&v))
    }

    /// Sets a key; what it was before is lost.
    pub fn set(&mut self, key: String, value: String) {
        self.0.insert(key, value);
    }

    /// All pairs, by key.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &str)> {
        self.0.iter().map(|(k, v)| (k.as_str(), v.as_str()))
    }
}

/// A point.
#[derive(Debug, Clone, PartialEq)]
pub struct OsmNode {
    /// Degrees north.
    pub lat: f64,
    /// Degrees east.
    pub lon: f64,
    /// Its tags.
    pub tags: OsmTags,
}

/// A chain of nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct OsmWay {
    /// Its id.
    pub id: i64,
    /// Ids of its nodes; some may lie outside the extract.
    pub nodes: Vec<i64>,
    /// Its tags.
    pub tags: OsmTags,
}

/// Kind of a relation's member.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OsmMemberKind {
    /// A node.
    Node,
    /// A way.
    Way,
    /// Another relation.
    Relation,
}

/// A member of a relation.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OsmMember {
    /// Its kind.
    pub kind: OsmMemberKind,
    /// Its id.
    pub id: i64,
    /// Its part.
    pub role: String,
}

/// Things that belong together.
#[derive(Debug, Clone, PartialEq)]
pub struct OsmRelation {
    /// Its id.
    pub id: i64,
    /// Its members.
    pub members: Vec<OsmMember>,
    /// Its tags.
    pub tags: OsmTags,
}

/// Degrees: the box an extract was cut to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OsmBounds {
    /// South, west.
    pub low: [f64; 2],
    /// North, east.
    pub high: [f64; 2],
}

/// A whole file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OsmExtract {
    /// Nodes by id.
    pub nodes: BTreeMap<i64, OsmNode>,
    /// Ways, by id, each once.
    pub ways: Vec<OsmWay>,
    /// Relations, by id, each once.
    pub relations: Vec<OsmRelation>,
    /// The box it was cut to, if the file says.
    pub bounds: Option<OsmBounds>,
}

impl OsmExtract {
    /// Degrees north and east of a place that is given in metres east and north of a centre.
    pub fn degrees(centre: [f64; 2], metres: DVec2) -> [f64; 2] {
        super::projection::Projection::around(centre[0], centre[1]).unproject(metres)
    }

    /// Sorts by id and keeps the last of each: the same file in another order gives the same map.
    pub(super) fn put_in_order(&mut self) {
        self.ways.sort_by_key(|w| w.id);
        self.ways.reverse();
        self.ways.dedup_by_key(|w| w.id);
        self.ways.reverse();
        self.relations.sort_by_key(|r| r.id);
        self.relations.reverse();
        self.relations.dedup_by_key(|r| r.id);
        self.relations.reverse();
    }
}
