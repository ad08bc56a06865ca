//! The lanes of a section as pairs of borders, sampled where they bend.

use super::super::document::{LaneRecord, LaneSection};
use super::profile::value_at;
use super::road::RoadShape;
use endless_world::math::segment::share_along;
use glam::DVec3;

/// Borders may leave the true curve by this, metres.
const CHORD_M: f64 = 0.01;
/// Pieces of the reference line shorter than this were sampled by whoever wrote the file, metres: their ends are kept
/// as they are, unless borders leave the curve by more than the second figure.
const DENSE_M: f64 = 4.0;
const DENSE_CHORD_M: f64 = 0.1;
/// Segments may turn from the true direction by this (as cosine): 3 degrees.
const STRAIGHT: f64 = 0.998_6;
/// At the ends of a section, where others go on: 0.4 degrees, over half as far.
const STRAIGHT_AT_ENDS: f64 = 0.999_975;
/// Stations are not nearer than this, metres.
const NEAREST_M: f64 = 0.2;
/// And joints of pieces that are kept beside the ends of a section.
const TIP_M: f64 = 0.015;
/// Nor further apart than this.
const FARTHEST_M: f64 = 25.0;

/// One lane of a section.
#[derive(Debug, Clone)]
pub(crate) struct LaneShape {
    pub(crate) id: i32,
    /// The border to the left along `s`; on the surface, with the lane's own height.
    pub(crate) left: Vec<DVec3>,
    /// The border to the right.
    pub(crate) right: Vec<DVec3>,
    /// Width at each station.
    pub(crate) width: Vec<f64>,
}

/// A section of a road, sampled.
#[derive(Debug, Clone)]
pub(crate) struct SectionShape {
    /// Ascending `s` on the road; at least two.
    pub(crate) stations: Vec<f64>,
    /// From left to right, the centre lane left out.
    pub(crate) lanes: Vec<LaneShape>,
}

impl LaneShape {
    /// Middle of the lane, along `s`.
    pub(crate) fn middle(&self) -> Vec<DVec3> {
        self.left.iter().zip(&self.right).map(|(l, r)| l.midpoint(*r)).collect()
    }
}

impl SectionShape {
    /// The section between two places of its road. Stations are where any border, or the middle of the road, needs
    /// them.
    pub(crate) fn new(shape: &RoadShape<'_>, section: &LaneSection, from: f64, to: f64) -> Self {
        let across = SectionSampler { shape, section, to };
        let stations = across.stations(from, to);
        let mut lanes: Vec<LaneShape> = section
            .lanes
            .iter()
            .filter(|lane| lane.id != 0)
            .map(|lane| LaneShape { id: lane.id, left: vec![], right: vec![], width: vec![] })
            .collect();
        for &s in &stations {
            for (lane, edges) in lanes.iter_mut().zip(across.lanes(s)) {
                lane.left.push(edges.left);
                lane.right.push(edges.right);
                lane.width.push(edges.width);
            }
        }
        Self { stations, lanes }
    }
}

struct LaneEdges {
    left: DVec3,
    right: DVec3,
    width: f64,
}

struct SectionSampler<'a> {
    shape: &'a RoadShape<'a>,
    section: &'a LaneSection,
    to: f64,
}

impl SectionSampler<'_> {
    /// Left and right edge of every lane but the centre, left to right.
    fn lanes(&self, s: f64) -> Vec<LaneEdges> {
        let road = self.shape.road;
        // What begins exactly where the section ends belongs to the next one.
        let inside = s.min(self.to - 1e-7);
        let ds = (s - self.section.s).max(0.0);
        let frame = self.shape.frame(inside);
        let centre = value_at(&road.lane_offset, inside);
        let left_of_centre = self.section.lanes.partition_point(|lane| lane.id > 0);
        let (left, right) = self.section.lanes.split_at(left_of_centre);
        let surface = |t: f64, height: f64| frame.point(t, height + self.shape.height(inside, t));
        let side = |lanes: &mut dyn Iterator<Item = &LaneRecord>, sign: f64| {
            let mut inner = centre;
            let mut level_from: Option<DVec3> = None;
            let mut edges = Vec::new();
            for lane in lanes.filter(|lane| lane.id != 0) {
                let outer = if lane.widths.is_empty() && !lane.borders.is_empty() {
                    let t = centre + value_at(&lane.borders, ds);
                    if sign > 0.0 { t.max(inner) } else { t.min(inner) }
                } else {
                    inner + sign * value_at(&lane.widths, ds).max(0.0)
                };
                let [low, high] = heights(lane, ds);
                let (mut a, mut b) = (surface(inner, low), surface(outer, high));
                if lane.level || level_from.is_some() {
                    let from = *level_from.get_or_insert(surface(inner, 0.0));
                    (a.z, b.z) = (from.z + low, from.z + high);
                }
                edges.push((a, b, (outer - inner).abs()));
                inner = outer;
            }
            edges
        };
        let mut all: Vec<LaneEdges> = side(&mut left.iter().rev(), 1.0)
            .into_iter()
            .rev()
            .map(|(inner, outer, width)| LaneEdges { left: outer, right: inner, width })
            .collect();
        all.extend(side(&mut right.iter(), -1.0).into_iter().map(|(inner, outer, width)| LaneEdges {
            left: inner,
            right: outer,
            width,
        }));
        all
    }

    /// The lines that must be followed: both outer borders, the borders of the middle, and the reference line.
    fn probes(&self, s: f64) -> Vec<DVec3> {
        let edges = self.lanes(s);
        let mut probes = vec![self.shape.frame(s.min(self.to - 1e-7)).point(0.0, 0.0)];
        probes.extend(edges.iter().map(|edge| edge.left));
        probes.extend(edges.last().map(|edge| edge.right));
        probes
    }

    fn stations(&self, from: f64, to: f64) -> Vec<f64> {
        let mut fixed = vec![from];
        // Short pieces at the ends are kept: they say in which direction a lane begins and ends.
        let least = |s: f64| if s <= from || s >= to { TIP_M } else { 0.25 * NEAREST_M };
        let far = |a: f64, b: f64| b - a > least(a).min(least(b));
        // Where pieces begin, and what is on a bridge or of another material.
        let bridges = self.shape.road.bridges.iter().flat_map(|&(a, b)| [a, b]);
        let materials = self.section.lanes.iter().flat_map(|lane| &lane.materials).map(|m| self.section.s + m.0);
        let mut joints: Vec<f64> = self.shape.joints().chain(bridges).chain(materials).collect();
        joints.sort_by(f64::total_cmp);
        for joint in joints.into_iter().filter(|&s| s > from && s < to) {
            if far(fixed[fixed.len() - 1], joint) && far(joint, to) {
                fixed.push(joint);
            }
        }
        fixed.push(to);
        let mut stations = vec![from];
        for pair in fixed.windows(2) {
            let n = ((pair[1] - pair[0]) / FARTHEST_M).ceil().max(1.0) as usize;
            for i in 0..n {
                let at = |k: usize| pair[0] + (pair[1] - pair[0]) * k as f64 / n as f64;
                let (a, b) = (at(i), if i + 1 == n { pair[1] } else { at(i + 1) });
                let dense = pair[1] - pair[0] < DENSE_M && to - from > DENSE_M;
                let (chord, strict) =
                    if dense { (DENSE_CHORD_M, (false, false)) } else { (CHORD_M, (a <= from, b >= to)) };
                self.split((a, &self.probes(a)), (b, &self.probes(b)), chord, strict, &mut stations);
                stations.push(b);
            }
        }
        stations
    }

    /// Adds the stations needed between two, in order.
    fn split(&self, a: (f64, &[DVec3]), b: (f64, &[DVec3]), chord: f64, strict: (bool, bool), stations: &mut Vec<f64>) {
        let span = b.0 - a.0;
        if span < 2.0 * NEAREST_M {
            return;
        }
        let middle = 0.5 * (a.0 + b.0);
        let at_middle = self.probes(middle);
        let quarters = [0.25, 0.75].map(|share| (share, self.probes(a.0 + span * share)));
        let straight = a.1.iter().zip(b.1).enumerate().all(|(i, (&p, &q))| {
            let along = q - p;
            let near = |r: DVec3| {
                let share = share_along(r, p, q);
                (p + along * share).distance(r) < chord
            };
            let aligned = |r: DVec3, s: DVec3, most: f64| {
                let (u, v) = ((r - p).normalize_or_zero(), (s - r).normalize_or_zero());
                u.dot(v) > most || s.distance(p) < 0.02 || chord >= DENSE_CHORD_M
            };
            let m = at_middle[i];
            let (first, third) = (quarters[0].1[i], quarters[1].1[i]);
            near(m)
                && near(first)
                && near(third)
                && aligned(first, m, if strict.0 { STRAIGHT_AT_ENDS } else { STRAIGHT })
                && aligned(first, third, STRAIGHT)
                && aligned(m, q, if strict.1 { STRAIGHT_AT_ENDS } else { STRAIGHT })
        });
        if straight {
            return;
        }
        self.split(a, (middle, &at_middle), chord, (strict.0, false), stations);
        stations.push(middle);
        self.split((middle, &at_middle), b, chord, (false, strict.1), stations);
    }
}

fn heights(lane: &LaneRecord, ds: f64) -> [f64; 2] {
    let at = lane.heights.partition_point(|height| height[0] <= ds);
    if at == 0 { [0.0, 0.0] } else { [lane.heights[at - 1][1], lane.heights[at - 1][2]] }
}
