//! The graph of driving lanes: one node a lane and section, joined by the links of the document.

use super::super::OpenDriveError;
use super::super::document::ContactPoint;
use super::lane_links::LaneEnd;
use super::lane_types::{is_driven, usual_speed};
use super::sampled::{LaneKey, SampledDocument};
use crate::{ImportNote, Junction, JunctionId, Lane, LaneId, Polyline, TrafficControl, Turn};
use endless_world::math::f64::{atan2, wrap_angle};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// A lane narrower than this along its middle is not driven on, metres.
const NARROWEST_M: f64 = 1.5;
/// Lanes shorter than this are joined to others, metres.
pub(super) const SHORTEST_M: f64 = 1.5;
/// Ends further apart than this are not joined, whatever the file says, metres.
const MOST_GAP_M: f64 = 2.5;
/// Ways through one junction.
const MOST_WAYS: usize = 400;
/// A lane longer than this is no way through a junction, metres.
const LONGEST_WAY_M: f64 = 600.0;
/// Nor lanes that meet at more than this, radians.
const MOST_KINK: f64 = 1.2;

/// A lane to be.
#[derive(Debug, Clone)]
pub(super) struct LaneNode {
    /// In the direction of travel.
    pub(super) points: Vec<DVec3>,
    /// Width at each point.
    pub(super) widths: Vec<f64>,
    /// The lanes of sections it is made of, in the direction of travel.
    pub(super) keys: Vec<LaneKey>,
    pub(super) next: Vec<usize>,
    pub(super) before: Vec<usize>,
    /// Whether it runs in the direction of its road's `s`.
    pub(super) along: bool,
    /// Place of its junction in the document.
    pub(super) junction: Option<usize>,
    /// Joined to others, or dropped.
    pub(super) gone: bool,
}

impl LaneNode {
    pub(super) fn length(&self) -> f64 {
        self.points.windows(2).map(|pair| pair[0].distance(pair[1])).sum()
    }

    pub(super) fn first_heading(&self) -> f64 {
        heading(self.points[0], self.points[1])
    }

    pub(super) fn last_heading(&self) -> f64 {
        let n = self.points.len();
        heading(self.points[n - 2], self.points[n - 1])
    }
}

fn heading(a: DVec3, b: DVec3) -> f64 {
    atan2(b.y - a.y, b.x - a.x)
}

/// Lanes to be, and which follow which.
#[derive(Debug, Clone)]
pub(super) struct LaneGraph {
    pub(super) nodes: Vec<LaneNode>,
    /// The node a lane of a section has become part of.
    pub(super) owner: BTreeMap<LaneKey, usize>,
    /// The lanes' ids, once finished.
    pub(super) ids: Vec<Option<LaneId>>,
}

impl LaneGraph {
    pub(super) fn new(
        sampled: &SampledDocument<'_>,
        joins: &BTreeSet<(LaneEnd, LaneEnd)>,
        notes: &mut Vec<ImportNote>,
    ) -> Self {
        let mut graph = Self { nodes: Vec::new(), owner: BTreeMap::new(), ids: Vec::new() };
        let junction_places: BTreeMap<&str, usize> =
            sampled.document.junctions.iter().enumerate().map(|(i, j)| (j.id.as_str(), i)).collect();
        for (key, record) in sampled.keys().filter(|(_, record)| is_driven(&record.kind)) {
            let Some(node) = node(sampled, key, &junction_places) else { continue };
            if middle_width(&node) < NARROWEST_M {
                let place = format!("line {}", record.line);
                notes.push(ImportNote { place, text: "a lane too narrow to drive on is only drawn".to_owned() });
                continue;
            }
            graph.owner.insert(key, graph.nodes.len());
            graph.nodes.push(node);
        }
        for &(a, b) in joins {
            graph.join(sampled, a, b, notes);
        }
        graph
    }

    fn join(&mut self, sampled: &SampledDocument<'_>, a: LaneEnd, b: LaneEnd, notes: &mut Vec<ImportNote>) {
        let (Some(&x), Some(&y)) = (self.owner.get(&a.0), self.owner.get(&b.0)) else { return };
        let leaves = |(key, end): LaneEnd| sampled.runs_along(key) == (end == ContactPoint::End);
        let (from, to) = match (leaves(a), leaves(b)) {
            (true, false) => (x, y),
            (false, true) => (y, x),
            _ => return,
        };
        let (p, q) = (&self.nodes[from], &self.nodes[to]);
        let gap = p.points[p.points.len() - 1].distance(q.points[0]);
        let kink = wrap_angle(q.first_heading() - p.last_heading()).abs();
        if gap > MOST_GAP_M || kink > MOST_KINK {
            let line = sampled.record(a.0).map_or(0, |lane| lane.line);
            let road = |key: LaneKey| &sampled.document.roads[key.road].id;
            let text = format!(
                "lane {} of road {} and lane {} of road {} are linked but {gap:.2} m and {:.0}° apart: not joined",
                a.0.lane,
                road(a.0),
                b.0.lane,
                road(b.0),
                kink.to_degrees()
            );
            notes.push(ImportNote { place: format!("line {line}"), text });
            return;
        }
        if !self.nodes[from].next.contains(&to) {
            self.nodes[from].next.push(to);
            self.nodes[to].before.push(from);
        }
    }

    /// Lanes and junctions with their final ids.
    pub(super) fn finish(
        &mut self,
        sampled: &SampledDocument<'_>,
    ) -> Result<(Vec<Lane>, Vec<Junction>), OpenDriveError> {
        self.ids = vec![None; self.nodes.len()];
        let mut count = 0;
        for (node, id) in self.nodes.iter().zip(&mut self.ids) {
            if !node.gone && node.points.iter().any(|p| p.distance(node.points[0]) > 0.01) {
                *id = Some(LaneId(count));
                count += 1;
            }
        }
        let used: BTreeSet<usize> = self.present().filter_map(|(node, _)| node.junction).collect();
        if used.len() > usize::from(u16::MAX) {
            return Err(OpenDriveError::TooMuch { what: "junctions", most: usize::from(u16::MAX) });
        }
        let places: BTreeMap<usize, JunctionId> =
            used.iter().enumerate().map(|(i, &j)| (j, JunctionId(i as u16))).collect();
        let mut junctions = vec![Junction::default(); used.len()];
        let mut lanes = Vec::new();
        for (node, id) in self.present() {
            let junction = node.junction.map(|j| places[&j]);
            if let Some(junction) = junction {
                junctions[junction.index()].lanes.push(id);
            }
            lanes.push(Lane {
                id,
                centerline: Polyline::new(node.points.iter().copied()),
                width_m: middle_width(node),
                speed_limit_mps: self.speed(sampled, node),
                successors: node.next.iter().filter_map(|&next| self.ids[next]).collect(),
                predecessors: Vec::new(),
                left: None,
                right: None,
                junction,
                turn: if junction.is_some() { turn(node) } else { Turn::Straight },
                end_control: TrafficControl::Free,
            });
        }
        // Conflicts are sought between all pairs.
        if junctions.iter().any(|junction| junction.lanes.len() > MOST_WAYS) {
            return Err(OpenDriveError::TooMuch { what: "lanes in one junction", most: MOST_WAYS });
        }
        Ok((lanes, junctions))
    }

    /// The id of the lane that a lane of a section has become part of.
    pub(super) fn id(&self, key: LaneKey) -> Option<LaneId> {
        self.ids[*self.owner.get(&key)?]
    }

    /// The lanes outside junctions from which a lane inside one is reached; a lane outside is its own.
    pub(super) fn approaches(&self, node: usize) -> BTreeSet<LaneId> {
        let mut found = BTreeSet::new();
        let mut seen = BTreeSet::from([node]);
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            if self.nodes[node].junction.is_none() {
                found.extend(self.ids[node]);
            } else {
                open.extend(self.nodes[node].before.iter().copied().filter(|&before| seen.insert(before)));
            }
        }
        found
    }

    /// The lanes at which the way along a road ends that goes through this lane.
    pub(super) fn last_on_road(&self, node: usize, road: usize) -> BTreeSet<LaneId> {
        let mut found = BTreeSet::new();
        let mut seen = BTreeSet::from([node]);
        let mut open = vec![node];
        while let Some(node) = open.pop() {
            let here = |n: usize| self.nodes[n].keys.iter().any(|key| key.road == road);
            let next: Vec<usize> = self.nodes[node].next.iter().copied().filter(|&n| here(n)).collect();
            if next.is_empty() {
                found.extend(self.ids[node]);
            }
            open.extend(next.into_iter().filter(|&n| seen.insert(n)));
        }
        found
    }

    /// The lanes that are left, with their ids.
    pub(super) fn present(&self) -> impl Iterator<Item = (&LaneNode, LaneId)> {
        self.nodes.iter().zip(&self.ids).filter_map(|(node, id)| id.map(|id| (node, id)))
    }

    /// What is stated for the lane or its road, or what is usual; ways through junctions are as fast as the slower
    /// of the lanes they join.
    fn speed(&self, sampled: &SampledDocument<'_>, node: &LaneNode) -> f64 {
        if let Some(stated) = node.keys.iter().find_map(|&key| stated_speed(sampled, key)) {
            return stated;
        }
        let around = node.before.iter().chain(&node.next).map(|&other| &self.nodes[other]);
        let speeds = around.filter_map(|other| other.keys.iter().find_map(|&key| stated_speed(sampled, key)));
        let usual = || {
            let types = node.keys.first().map(|key| &sampled.document.roads[key.road].types);
            usual_speed(types.and_then(|types| types.first()).map_or("", |first| first.kind.as_str()))
        };
        speeds.min_by(f64::total_cmp).unwrap_or_else(usual)
    }
}

fn stated_speed(sampled: &SampledDocument<'_>, key: LaneKey) -> Option<f64> {
    let record = sampled.record(key)?;
    let road = &sampled.document.roads[key.road];
    let section = sampled.sections[key.road][key.section].as_ref()?;
    let (from, to) = (section.stations[0], section.stations[section.stations.len() - 1]);
    let middle = 0.5 * (from + to);
    let of_lane = record.speeds.iter().rev().find(|speed| speed.0 <= middle - from).map(|speed| speed.1);
    let of_road = road.types.iter().rev().find(|kind| kind.s <= middle).and_then(|kind| kind.speed);
    of_lane.or(of_road).map(|speed| speed.clamp(1.5, 100.0))
}

fn node(sampled: &SampledDocument<'_>, key: LaneKey, junctions: &BTreeMap<&str, usize>) -> Option<LaneNode> {
    let lane = sampled.lane(key)?;
    let (mut points, mut widths) = (lane.middle(), lane.width.clone());
    let along = sampled.runs_along(key);
    if !along {
        points.reverse();
        widths.reverse();
    }
    let road = &sampled.document.roads[key.road];
    let junction = road.junction.as_deref();
    let short_enough = road.length < LONGEST_WAY_M;
    Some(LaneNode {
        points,
        widths,
        keys: vec![key],
        next: Vec::new(),
        before: Vec::new(),
        along,
        junction: junction.and_then(|id| junctions.get(id).copied()).filter(|_| short_enough),
        gone: false,
    })
}

/// The least width between a quarter and three quarters of the lane.
pub(super) fn middle_width(node: &LaneNode) -> f64 {
    let length = node.length();
    let (mut s, mut least) = (0.0, f64::INFINITY);
    for i in 0..node.points.len() {
        if i > 0 {
            s += node.points[i - 1].distance(node.points[i]);
        }
        if s >= 0.25 * length && s <= 0.75 * length {
            least = least.min(node.widths[i]);
        }
    }
    if least.is_finite() { least } else { 0.5 * (node.widths[0] + node.widths[node.widths.len() - 1]) }
}

fn turn(node: &LaneNode) -> Turn {
    // Summed along the way, so that a loop counts as what it is.
    let mut total = 0.0;
    let mut last = node.first_heading();
    for pair in node.points.windows(2) {
        let here = heading(pair[0], pair[1]);
        total += wrap_angle(here - last);
        last = here;
    }
    match total.to_degrees() {
        angle if angle.abs() < 35.0 => Turn::Straight,
        angle if angle.abs() > 150.0 => Turn::UTurn,
        angle if angle > 0.0 => Turn::Left,
        _ => Turn::Right,
    }
}
