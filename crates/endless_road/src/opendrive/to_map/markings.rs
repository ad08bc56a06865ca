//! Paint along the lanes' edges.

use super::super::document::{LaneSection, RoadMark};
use super::super::geometry::SectionShape;
use super::sampled::SampledDocument;
use crate::{MarkingColor, Polyline, RoadMarking};
use glam::DVec3;

/// Widths of ordinary and bold lines where the file gives none, metres.
const LINE_M: f64 = 0.12;
const BOLD_M: f64 = 0.25;
/// Between the middles of double lines, metres.
const DOUBLE_M: f64 = 0.24;
/// Paint and gap of broken lines, metres: in towns, and on fast roads.
const DASH_M: [f64; 2] = [3.0, 6.0];
const FAST_DASH_M: [f64; 2] = [6.0, 12.0];
/// Botts' dots.
const DOTS_M: [f64; 2] = [0.1, 1.1];
/// Shorter marks are not drawn, metres.
const SHORTEST_M: f64 = 0.3;
/// A fast road, m/s.
const FAST_MPS: f64 = 23.0;

/// The marks of all lanes.
pub(super) fn markings(sampled: &SampledDocument<'_>) -> Vec<RoadMarking> {
    let mut markings = Vec::new();
    for (road, sections) in sampled.document.roads.iter().zip(&sampled.sections) {
        let fast = road.types.iter().any(|t| t.kind == "motorway" || t.speed.is_some_and(|speed| speed > FAST_MPS));
        let dash = if fast { FAST_DASH_M } else { DASH_M };
        for (section, shape) in road.sections.iter().zip(sections) {
            let Some(shape) = shape else { continue };
            for lane in &section.lanes {
                let Some(edge) = edge(shape, lane.id) else { continue };
                for (mark, from, to) in runs(section, shape, &lane.marks) {
                    draw(mark, &clipped(&shape.stations, edge, from, to), dash, &mut markings);
                }
            }
        }
    }
    markings
}

/// The outer edge of a lane; the middle of the road for the centre lane.
fn edge(shape: &SectionShape, id: i32) -> Option<&[DVec3]> {
    let of = |id: i32| shape.lanes.iter().find(|lane| lane.id == id);
    match id {
        0 => of(-1).map(|lane| &lane.left[..]).or_else(|| of(1).map(|lane| &lane.right[..])),
        id if id > 0 => of(id).map(|lane| &lane.left[..]),
        id => of(id).map(|lane| &lane.right[..]),
    }
}

/// Marks with the range of `s` along which each holds; equal ones that follow one another are one.
fn runs<'a>(section: &LaneSection, shape: &SectionShape, marks: &'a [RoadMark]) -> Vec<(&'a RoadMark, f64, f64)> {
    let last = shape.stations[shape.stations.len() - 1];
    let mut runs: Vec<(&RoadMark, f64, f64)> = Vec::new();
    for (i, mark) in marks.iter().enumerate() {
        let from = (section.s + mark.s).max(shape.stations[0]);
        let to = marks.get(i + 1).map_or(last, |next| section.s + next.s).min(last);
        match runs.last_mut() {
            Some(run) if same(run.0, mark) => run.2 = to,
            _ => runs.push((mark, from, to)),
        }
    }
    runs.retain(|run| run.2 - run.1 > SHORTEST_M);
    runs
}

fn same(a: &RoadMark, b: &RoadMark) -> bool {
    (&a.kind, &a.color, a.width, a.bold, &a.lines) == (&b.kind, &b.color, b.width, b.bold, &b.lines)
}

/// The part of a line given at stations between two of them.
pub(super) fn clipped(stations: &[f64], line: &[DVec3], from: f64, to: f64) -> Vec<DVec3> {
    let at = |s: f64| {
        let i = stations.partition_point(|&x| x <= s).clamp(1, stations.len() - 1) - 1;
        let span = stations[i + 1] - stations[i];
        line[i].lerp(line[i + 1], if span > 0.0 { ((s - stations[i]) / span).clamp(0.0, 1.0) } else { 0.0 })
    };
    let inner = stations.iter().zip(line).filter(|(s, _)| **s > from && **s < to).map(|(_, p)| *p);
    std::iter::once(at(from)).chain(inner).chain([at(to)]).collect()
}

fn draw(mark: &RoadMark, line: &[DVec3], dash: [f64; 2], markings: &mut Vec<RoadMarking>) {
    let width_m = mark.width.unwrap_or(if mark.bold { BOLD_M } else { LINE_M });
    let color = if mark.color == "yellow" { MarkingColor::Yellow } else { MarkingColor::White };
    let mut add_part = |offset: f64, width_m: f64, dash: Option<[f64; 2]>, (skip, length): (f64, f64)| {
        if !is_line(line) {
            return;
        }
        let mut line = Polyline::new(line.iter().copied());
        if skip > 0.0 && skip + SHORTEST_M < line.length() {
            line = part(&line, skip, f64::INFINITY);
        }
        if length < line.length() {
            line = part(&line, 0.0, length.max(0.1));
        }
        if offset != 0.0 {
            line = line.offset(offset);
        }
        markings.push(RoadMarking { line, width_m, dash, color });
    };
    if !mark.lines.is_empty() && !matches!(mark.kind.as_str(), "none" | "curb" | "grass") {
        for l in &mark.lines {
            let broken = l.space > 0.0 && l.length > 0.0;
            let length = if l.once { l.length } else { f64::INFINITY };
            let dash = broken.then_some([l.length, l.space]);
            add_part(l.t_offset, l.width.unwrap_or(width_m), dash, (l.s_offset.max(0.0), length));
        }
        return;
    }
    let mut add =
        |offset: f64, width_m: f64, dash: Option<[f64; 2]>| add_part(offset, width_m, dash, (0.0, f64::INFINITY));
    // Of double lines the first named is the left one (towards higher `t`).
    let half = 0.5 * DOUBLE_M.max(2.0 * width_m);
    match mark.kind.as_str() {
        "solid" => add(0.0, width_m, None),
        "broken" => add(0.0, width_m, Some(dash)),
        "botts dots" => add(0.0, 0.1, Some(DOTS_M)),
        "solid solid" => [half, -half].into_iter().for_each(|t| add(t, width_m, None)),
        "broken broken" => [half, -half].into_iter().for_each(|t| add(t, width_m, Some(dash))),
        "solid broken" => {
            add(half, width_m, None);
            add(-half, width_m, Some(dash));
        }
        "broken solid" => {
            add(half, width_m, Some(dash));
            add(-half, width_m, None);
        }
        // Kerbs and edges are no paint.
        _ => {}
    }
}

/// Whether a line has the extent that a [`Polyline`] needs.
pub(super) fn is_line(points: &[DVec3]) -> bool {
    points.iter().any(|p| p.distance(points[0]) > 0.05)
}

/// A part of a line.
fn part(line: &Polyline, from: f64, to: f64) -> Polyline {
    let to = to.min(line.length());
    let mut s = 0.0;
    let mut rest = vec![line.position(from)];
    for pair in line.points().windows(2) {
        s += pair[0].distance(pair[1]);
        if s > from + 0.01 && s < to - 0.01 {
            rest.push(pair[1]);
        }
    }
    rest.push(line.position(to));
    Polyline::new(rest)
}
