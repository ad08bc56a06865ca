//! The street plan: streets with their centre lines and cross-sections, and the intersections where they meet.

use super::class::RoadClass;
use super::curve::{angle, line_through, relaxed, rounded, simplified};
use super::graph::{self, StreetSegmentEnd};
use super::height::GroundHeight;
use super::lift::lifted;
use super::section::CrossSection;
use super::street_segment::{StreetSegment, StructureLevel};
use crate::{CrossingId, LaneId, Polyline, TrafficControl};
use endless_world::SignalId;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Vertices this near to the line through the others are no bends, metres.
const TOLERANCE_M: f64 = 0.12;

/// What crosses a street on foot.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FootwayCrossing {
    /// Place along the street, metres.
    pub(super) s: f64,
    /// Painted: bars, or two lines.
    pub(super) painted: bool,
    /// With lights.
    pub(super) signal: Option<SignalId>,
    /// At which end of the street it belongs to the junction; `None` between junctions.
    pub(super) end: Option<usize>,
    /// Its number in the network, once it is there.
    pub(super) id: Option<CrossingId>,
}

/// A street between two intersections.
#[derive(Debug, Clone)]
pub(super) struct Street {
    pub(super) line: Polyline,
    pub(super) section: CrossSection,
    pub(super) class: RoadClass,
    pub(super) link: bool,
    pub(super) roundabout: bool,
    pub(super) speed_mps: f64,
    pub(super) ways: [i64; 2],
    pub(super) nodes: [i64; 2],
    pub(super) intersections: [usize; 2],
    /// Distance from each end to the junction's area, metres.
    pub(super) cuts: [f64; 2],
    /// Distance from each end to the stop line: where lanes begin and end.
    pub(super) stops: [f64; 2],
    /// Nodes on it with their places.
    pub(super) on: Vec<(i64, f64)>,
    /// Where levels begin, with the level.
    pub(super) levels: Vec<(f64, StructureLevel)>,
    pub(super) crossings: Vec<FootwayCrossing>,
    /// Half the width of the median on its left, by place; empty without one.
    pub(super) median: Vec<(f64, f64)>,
    /// What governs its ends for who arrives there.
    pub(super) control: [TrafficControl; 2],
    /// Lanes by band, once they are there.
    pub(super) lanes: Vec<Option<LaneId>>,
}

/// Where streets meet.
#[derive(Debug, Clone, Default)]
pub(super) struct Intersection {
    pub(super) nodes: Vec<i64>,
    /// Ends of streets, counter-clockwise.
    pub(super) arms: Vec<StreetSegmentEnd>,
    /// Streets that lie inside it whole.
    pub(super) inside: Vec<usize>,
    pub(super) at: DVec2,
    /// Traffic lights for vehicles.
    pub(super) signals: bool,
    /// The way on at a dead end is a loop to the other carriageway.
    pub(super) turnaround: bool,
    /// The road goes on beyond the extract's edge.
    pub(super) open: bool,
}

/// All of it.
#[derive(Debug, Clone, Default)]
pub(super) struct StreetPlan {
    pub(super) streets: Vec<Street>,
    pub(super) intersections: Vec<Intersection>,
}

impl StreetPlan {
    /// From stretches that meet at their ends only.
    pub(super) fn new(mut stretches: Vec<StreetSegment>, ground: Option<GroundHeight<'_>>) -> Self {
        let heights = super::height::heights(&mut stretches, ground);
        let mut plan = Self::default();
        let mut knot_at: BTreeMap<i64, usize> = BTreeMap::new();
        for (node, arms) in graph::ends(&stretches) {
            let first = &stretches[arms[0].stretch];
            let at = first.vertices[if arms[0].end == 0 { 0 } else { first.vertices.len() - 1 }].at;
            knot_at.insert(node, plan.intersections.len());
            plan.intersections.push(Intersection { nodes: vec![node], arms, at, ..Intersection::default() });
        }
        plan.streets = stretches.iter().map(|s| street(s, &heights, &knot_at)).collect();
        plan
    }

    pub(super) fn street(&self, arm: StreetSegmentEnd) -> &Street {
        &self.streets[arm.stretch]
    }

    /// The place at `d` metres outwards along an arm and `t` to the left, looking outwards.
    pub(super) fn arm_point(&self, arm: StreetSegmentEnd, d: f64, t: f64) -> DVec3 {
        let street = self.street(arm);
        if arm.end == 0 { street.point(d, t) } else { street.point(street.length() - d, -t) }
    }

    /// Outwards at `d` metres.
    pub(super) fn arm_direction(&self, arm: StreetSegmentEnd, d: f64) -> DVec2 {
        let street = self.street(arm);
        if arm.end == 0 { street.direction(d) } else { -street.direction(street.length() - d) }
    }

    /// The section as seen by who looks outwards.
    pub(super) fn arm_section(&self, arm: StreetSegmentEnd) -> CrossSection {
        let section = &self.street(arm).section;
        if arm.end == 0 { section.clone() } else { section.reversed() }
    }

    pub(super) fn cut(&self, arm: StreetSegmentEnd) -> f64 {
        self.street(arm).cuts[arm.end]
    }

    pub(super) fn stop(&self, arm: StreetSegmentEnd) -> f64 {
        self.street(arm).stops[arm.end]
    }

    /// Bands that lead into the intersection, from left to right for the driver.
    pub(super) fn lanes_in(&self, arm: StreetSegmentEnd) -> Vec<usize> {
        self.street(arm).section.lanes(arm.end == 1)
    }

    /// Bands that lead out of the intersection, from left to right for the driver.
    pub(super) fn lanes_out(&self, arm: StreetSegmentEnd) -> Vec<usize> {
        self.street(arm).section.lanes(arm.end == 0)
    }

    /// Sorts the arms of an intersection counter-clockwise around the middle of what they leave free.
    pub(super) fn sort_arms(&mut self, intersection: usize) {
        let mut arms = self.intersections[intersection].arms.clone();
        let place = |arm: &StreetSegmentEnd| self.arm_point(*arm, self.cut(*arm), 0.0).truncate();
        let middle = if self.intersections[intersection].nodes.len() == 1 {
            // Looking a little past the cuts tells arms apart that part slowly.
            self.intersections[intersection].at
        } else {
            arms.iter().map(place).sum::<DVec2>() / arms.len() as f64
        };
        let far = |arm: &StreetSegmentEnd| {
            self.arm_point(*arm, (self.cut(*arm) + 1.0).min(self.street(*arm).length()), 0.0).truncate()
        };
        arms.sort_by(|a, b| angle(far(a) - middle).total_cmp(&angle(far(b) - middle)).then(a.cmp(b)));
        self.intersections[intersection].arms = arms;
    }
}

impl Street {
    pub(super) fn length(&self) -> f64 {
        self.line.length()
    }

    /// The place at `s` and `t` to the left.
    pub(super) fn point(&self, s: f64, t: f64) -> DVec3 {
        let at = self.line.at(s);
        at.position + (self.direction(s).perp() * t).extend(0.0)
    }

    pub(super) fn direction(&self, s: f64) -> DVec2 {
        let (sin, cos) = endless_world::math::f64::sin_cos(self.line.at(s).heading_rad);
        DVec2::new(cos, sin)
    }

    /// Stations from `from` to `to`, at the line's own points and no further apart than `step`; the first and last
    /// piece are short, so that chords point as the line does.
    pub(super) fn stations(&self, from: f64, to: f64, step: f64) -> Vec<f64> {
        let length = to - from;
        let tip = (0.04f64).min(0.1 * length);
        let mut fixed = vec![from + tip];
        let mut s = 0.0;
        for pair in self.line.points().windows(2) {
            s += pair[0].distance(pair[1]);
            if s > fixed[fixed.len() - 1] + 0.3 && s < to - tip - 0.3 {
                fixed.push(s);
            }
        }
        fixed.push(to - tip);
        let mut out = vec![from];
        let mut last = from;
        for s in fixed {
            let n = ((s - last) / step).ceil().max(1.0) as usize;
            out.extend((1..=n).map(|k| last + (s - last) * k as f64 / n as f64));
            last = s;
        }
        out.push(to);
        out
    }

    /// The level at a place.
    pub(super) fn level(&self, s: f64) -> StructureLevel {
        let i = self.levels.partition_point(|(from, _)| *from <= s).max(1) - 1;
        self.levels[i].1
    }

    pub(super) fn oneway(&self) -> bool {
        self.section.lanes(false).is_empty()
    }
}

fn street(stretch: &StreetSegment, heights: &BTreeMap<i64, f64>, knot_at: &BTreeMap<i64, usize>) -> Street {
    let points: Vec<DVec3> =
        stretch.vertices.iter().map(|v| v.at.extend(heights.get(&v.node).copied().unwrap_or(0.0))).collect();
    let half = 0.5 * stretch.section.width_m();
    let radius_m = match stretch.class {
        RoadClass::Motorway | RoadClass::Trunk => 60.0,
        _ if stretch.roundabout => 12.0,
        RoadClass::Primary | RoadClass::Secondary => 30.0,
        RoadClass::Tertiary | RoadClass::Unclassified => 20.0,
        _ => 12.0,
    };
    let plain: Vec<DVec3> = points.iter().map(|p| p.with_z(0.0)).collect();
    let bends = rounded(&simplified(&plain, TOLERANCE_M), radius_m + half);
    // Lanes on the inside must not fold.
    let line = lifted(&line_through(relaxed(bends, (0.75 * half + 0.8).min(9.0))), &points);
    let on: Vec<(i64, f64)> = stretch.vertices.iter().map(|v| (v.node, line.project(v.at).0)).collect();
    let mut levels: Vec<(f64, StructureLevel)> = Vec::new();
    for (i, level) in stretch.levels.iter().enumerate() {
        if levels.last().is_none_or(|(_, l)| l != level) {
            levels.push((if i == 0 { 0.0 } else { on[i].1 }, *level));
        }
    }
    let nodes = [stretch.end_node(0), stretch.end_node(1)];
    Street {
        line,
        section: stretch.section.clone(),
        class: stretch.class,
        link: stretch.link,
        roundabout: stretch.roundabout,
        speed_mps: stretch.speed_mps,
        ways: stretch.ways,
        nodes,
        intersections: nodes.map(|n| knot_at[&n]),
        cuts: [0.0; 2],
        stops: [0.0; 2],
        on,
        levels,
        crossings: Vec::new(),
        median: Vec::new(),
        control: [TrafficControl::Free; 2],
        lanes: Vec::new(),
    }
}
