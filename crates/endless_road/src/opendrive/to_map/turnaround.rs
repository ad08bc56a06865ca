//! Where a map ends, traffic turns back: a loop from every lane that ends there to the lane that begins beside it.
//!
//! The file has no such loops; without them, nothing could drive on a map whose roads all lead out of it.

use super::lanes::{LaneGraph, LaneNode};
use crate::{ImportNote, LaneSurface, LaneType};
use endless_world::math::f64::{atan2, sin_cos, wrap_angle};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Ends of one road lie at most this far apart, metres.
const REACH_M: f64 = 30.0;
/// Radius of the innermost loop, and how much wider the next are, metres.
const RADIUS_M: f64 = 6.5;
const WIDER_M: f64 = 3.5;
/// Length of the loops' segments, metres: the first leaves the lane at less than 2 degrees.
const CHORD_M: f64 = 0.4;
/// The lanes must be opposite to within this, radians.
const ASKEW: f64 = 0.12;
/// Beside the lane's own width, metres.
const SPARE_M: f64 = 1.0;

/// Adds loops to the graph; returns their surfaces.
pub(super) fn add(graph: &mut LaneGraph, first_junction: usize, notes: &mut Vec<ImportNote>) -> Vec<LaneSurface> {
    let here = |node: &LaneNode| !node.gone && node.junction.is_none() && node.points.len() > 1;
    let ends: Vec<usize> = (0..graph.nodes.len())
        .filter(|&i| here(&graph.nodes[i]) && graph.nodes[i].next.is_empty() && !graph.nodes[i].before.contains(&i))
        .collect();
    let starts: Vec<usize> =
        (0..graph.nodes.len()).filter(|&i| here(&graph.nodes[i]) && graph.nodes[i].before.is_empty()).collect();
    // Nearest pairs first: the innermost lanes of a road, then those around them.
    let mut pairs = Vec::new();
    for &end in &ends {
        for &start in &starts {
            let (a, b) = (&graph.nodes[end], &graph.nodes[start]);
            let same_road = a.keys.last().map(|k| k.road) == b.keys.first().map(|k| k.road);
            let gap = a.points[a.points.len() - 1].distance(b.points[0]);
            let askew = wrap_angle(b.first_heading() - a.last_heading() - PI).abs();
            if same_road && gap < REACH_M && askew < ASKEW && end != start {
                pairs.push((gap, end, start));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)).then(a.2.cmp(&b.2)));
    let mut lane_surfaces = Vec::new();
    let mut used = std::collections::BTreeSet::new();
    let mut loops_at: BTreeMap<(usize, bool), usize> = BTreeMap::new();
    for (_, end, start) in pairs {
        if used.contains(&(end, true)) || used.contains(&(start, false)) {
            continue;
        }
        let place = (graph.nodes[end].keys.last().map_or(0, |key| key.road), graph.nodes[end].along);
        let already = loops_at.get(&place).copied().unwrap_or(0);
        let Some(points) = loop_line(&graph.nodes[end], &graph.nodes[start], already) else { continue };
        used.extend([(end, true), (start, false)]);
        *loops_at.entry(place).or_default() += 1;
        let junction = first_junction + 2 * place.0 + usize::from(place.1);
        let wide = |node: usize, at: usize| graph.nodes[node].widths[at];
        let width = wide(end, graph.nodes[end].widths.len() - 1).min(wide(start, 0)).max(2.5);
        lane_surfaces.push(strip(&points, width + SPARE_M));
        let added = graph.nodes.len();
        graph.nodes.push(LaneNode {
            widths: vec![width; points.len()],
            points,
            keys: Vec::new(),
            next: vec![start],
            before: vec![end],
            along: true,
            junction: Some(junction),
            gone: false,
        });
        graph.nodes[end].next.push(added);
        graph.nodes[start].before.push(added);
    }
    if !lane_surfaces.is_empty() {
        let text = format!("{} loops were added where roads end, for traffic to turn back", lane_surfaces.len());
        notes.push(ImportNote { place: "file".to_owned(), text });
    }
    lane_surfaces
}

/// Outwards, round, and back in: three arcs of one radius, tangent to one another and to both lanes.
fn loop_line(end: &LaneNode, start: &LaneNode, already: usize) -> Option<Vec<DVec3>> {
    let heading = end.last_heading();
    let (sin, cos) = sin_cos(heading);
    let ahead = DVec2::new(cos, sin);
    let (from, to) = (end.points[end.points.len() - 1], start.points[0]);
    let between = (to - from).truncate();
    let (along, across) = (between.dot(ahead), ahead.perp_dot(between));
    let side = if across < 0.0 { -1.0 } else { 1.0 };
    let half = 0.5 * across.abs();
    let radius = (RADIUS_M + WIDER_M * already as f64).max(half);
    // Turn away until the round fits between the lanes.
    let away = {
        let cosine = ((radius + half) / (2.0 * radius)).clamp(-1.0, 1.0);
        atan2((1.0 - cosine * cosine).max(0.0).sqrt(), cosine)
    };
    let mut local = vec![DVec2::ZERO];
    let mut heading_now = 0.0;
    let straight = |line: &mut Vec<DVec2>, heading: f64, length: f64| {
        if length > 0.05 {
            let (sin, cos) = sin_cos(heading);
            let last = line[line.len() - 1];
            line.push(last + DVec2::new(cos, sin) * length);
        }
    };
    straight(&mut local, 0.0, along.max(0.0));
    for turn in [-away * side, (PI + 2.0 * away) * side, -away * side] {
        let n = (radius * turn.abs() / CHORD_M).ceil().max(1.0) as usize;
        for _ in 0..n {
            let step = turn / n as f64;
            let chord = 2.0 * radius * sin_cos(step.abs() / 2.0).0;
            let (sin, cos) = sin_cos(heading_now + step / 2.0);
            let last = local[local.len() - 1];
            local.push(last + DVec2::new(cos, sin) * chord);
            heading_now += step;
        }
    }
    straight(&mut local, heading_now, (-along).max(0.0));
    // Lanes that are not quite parallel: the rest of the way is spread over the loop.
    let n = local.len() - 1;
    let to_world = |v: DVec2| from.truncate() + ahead * v.x + ahead.perp() * v.y;
    let miss = to.truncate() - to_world(local[n]);
    if miss.length() > 1.0 {
        return None;
    }
    Some(
        (0..=n)
            .map(|i| {
                let share = i as f64 / n as f64;
                (to_world(local[i]) + miss * share).extend(from.z + (to.z - from.z) * share)
            })
            .collect(),
    )
}

fn strip(points: &[DVec3], width: f64) -> LaneSurface {
    let n = points.len();
    let side = |sign: f64| -> Vec<DVec3> {
        (0..n)
            .map(|i| {
                let along = (points[(i + 1).min(n - 1)] - points[i.max(1) - 1]).truncate().normalize_or_zero();
                points[i] + (along.perp() * (0.5 * width * sign)).extend(0.0)
            })
            .collect()
    };
    LaneSurface {
        kind: LaneType::Driving,
        left: side(1.0),
        right: side(-1.0),
        in_junction: true,
        unpaved: false,
        bridge: false,
    }
}
