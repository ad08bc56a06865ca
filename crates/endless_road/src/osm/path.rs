//! Ways on foot that are mapped on their own: paths, steps, pedestrian streets. Where they run along a street that has a
//! sidewalk they are that sidewalk, and nothing is added.

use super::class::metres;
use super::extract::{OsmTags, OsmWay};
use super::import_context::ImportContext;
use super::lane::inside;
use super::plan::StreetPlan;
use super::segment_index::SegmentIndex;
use super::street_segment::WayVertex;
use super::surface::ribbon;
use super::walk::WalkNetworkBuilder;
use super::ways::runs;
use crate::{LaneSurface, LaneType, Polyline, RoadNetwork, WalkGraph, WalkKind, WalkNodeId};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Height of paths above the level of roads, metres: nearly that of sidewalks, above the lawns between them.
const PATH_Z_M: f64 = 0.11;
/// Distance between nodes, metres.
const STEP_M: f64 = 8.0;
/// Paths begin this far behind a street's sidewalk.
const BESIDE_M: f64 = 0.8;
/// A path tagged as a sidewalk is the street's own sidewalk within this distance behind it.
const SIDEPATH_M: f64 = 7.0;
/// Paths that end this near to a sidewalk join it.
const JOIN_M: f64 = 12.0;
/// Paths joined to no sidewalk stay if they are this long together.
const ALONE_M: f64 = 80.0;

/// The surfaces of footpaths and cycleways.
#[derive(Debug, Default)]
pub(super) struct PathSurfaces {
    pub(super) lane_surfaces: Vec<LaneSurface>,
}

/// A piece of a path with what it is.
struct PathPiece {
    points: Vec<DVec2>,
    /// The nodes at its ends, where it ends at nodes.
    ends: [Option<i64>; 2],
    width_m: f64,
    kind: LaneType,
    unpaved: bool,
    walkable: bool,
}

fn is_path(tags: &OsmTags) -> bool {
    let open = !tags.is("access", &["private", "no"]) && !tags.is("foot", &["no", "private"]);
    let outside = tags.get("indoor").is_none_or(|v| v == "no")
        && !tags.get("tunnel").is_some_and(|v| v != "no" && v != "building_passage")
        && tags.get("layer").and_then(|v| v.parse::<f64>().ok()).unwrap_or(0.0).abs() < 0.5
        && !tags.is("area", &["yes"]);
    let kind = tags.is("highway", &["footway", "path", "pedestrian", "steps", "cycleway", "track"]);
    kind && open
        && outside
        && !tags.is("footway", &["crossing", "traffic_island", "access_aisle"])
        && !tags.is("cycleway", &["crossing"])
        && !tags.is("path", &["crossing"])
}

/// Adds paths to the walk network.
pub(super) fn add(plan: &StreetPlan, context: &mut ImportContext<'_>, network: &mut RoadNetwork) -> PathSurfaces {
    let hidden = inside(plan);
    let near =
        SegmentIndex::new(plan.streets.iter().enumerate().filter(|(i, _)| !hidden[*i]).map(|(i, s)| (i, &s.line)));
    let extract = context.extract;
    let mut shared: BTreeMap<i64, usize> = BTreeMap::new();
    for way in extract.ways.iter().filter(|w| is_path(&w.tags)) {
        way.nodes.iter().for_each(|&node| *shared.entry(node).or_default() += 1);
    }
    let mut pieces = Vec::new();
    for way in extract.ways.iter().filter(|w| is_path(&w.tags)) {
        for (vertices, _) in runs(way, &way.tags, context) {
            pieces.extend(outside_streets(plan, &near, way, &vertices, &shared));
        }
    }
    let streets_nodes = network.walk.nodes.len();
    let mut paths = PathSurfaces::default();
    let mut at_node: BTreeMap<i64, WalkNodeId> = BTreeMap::new();
    let mut loose: Vec<WalkNodeId> = Vec::new();
    let mut uses: BTreeMap<i64, usize> = BTreeMap::new();
    for node in pieces.iter().flat_map(|p| p.ends).flatten() {
        *uses.entry(node).or_default() += 1;
    }
    let mut walks = WalkNetworkBuilder { walk: &mut network.walk };
    for piece in &pieces {
        paths.lane_surfaces.push(strip(piece, context));
        if piece.walkable {
            lay(piece, context, &mut walks, &mut at_node, &uses, &mut loose);
        }
    }
    for node in loose {
        join(&mut walks, node, streets_nodes);
    }
    drop_disconnected_paths(network, streets_nodes);
    paths
}

/// The parts of a path that lie outside of streets and their sidewalks, divided at the nodes it shares.
fn outside_streets(
    plan: &StreetPlan,
    near: &SegmentIndex,
    way: &OsmWay,
    vertices: &[WayVertex],
    shared: &BTreeMap<i64, usize>,
) -> Vec<PathPiece> {
    let tags = &way.tags;
    let sidepath =
        tags.is("footway", &["sidewalk"]) || tags.is("is_sidepath", &["yes"]) || tags.get("is_sidepath:of").is_some();
    let kind = if tags.is("highway", &["cycleway"]) { LaneType::Biking } else { LaneType::Sidewalk };
    let usual = match tags.get("highway") {
        Some("pedestrian") => 4.5,
        Some("cycleway" | "steps") => 2.2,
        Some("track") => 2.8,
        Some("path") => 1.5,
        _ => 2.0,
    };
    let width_m = tags.get("width").and_then(metres).unwrap_or(usual).clamp(0.8, 15.0);
    let rough =
        ["unpaved", "gravel", "fine_gravel", "ground", "dirt", "earth", "grass", "sand", "compacted", "woodchips"];
    let unpaved =
        tags.is("surface", &rough) || (tags.is("highway", &["track", "path"]) && tags.get("surface").is_none());
    let walkable = kind == LaneType::Sidewalk || tags.is("foot", &["yes", "designated"]);
    let on_street = |p: DVec2| {
        near.at(p).iter().any(|&i| {
            let street = &plan.streets[i];
            let (_, t) = street.line.project(p);
            let side = usize::from(t < 0.0);
            let out = t.abs() - street.section.back(side).abs();
            let own = sidepath && street.section.sidewalks[side] > 0.0;
            out < if own { SIDEPATH_M } else { BESIDE_M }
        })
    };
    let mut pieces = Vec::new();
    let mut points: Vec<DVec2> = Vec::new();
    let mut from: Option<i64> = None;
    let mut finish = |points: &mut Vec<DVec2>, ends: [Option<i64>; 2]| {
        let points = std::mem::take(points);
        let length: f64 = points.windows(2).map(|w| w[0].distance(w[1])).sum();
        let between = ends.iter().all(Option::is_some);
        if length > if between { 0.3 } else { 2.0 } {
            pieces.push(PathPiece { points, ends, width_m, kind, unpaved, walkable });
        }
    };
    for (k, vertex) in vertices.iter().enumerate() {
        if k > 0 {
            let before = vertices[k - 1].at;
            let n = (before.distance(vertex.at) / 1.5).ceil().max(1.0) as usize;
            for i in 1..n {
                let p = before.lerp(vertex.at, i as f64 / n as f64);
                if on_street(p) {
                    finish(&mut points, [from, None]);
                    from = None;
                } else if points.is_empty() || i == n - 1 || i == 1 {
                    points.push(p);
                }
            }
        }
        if on_street(vertex.at) {
            finish(&mut points, [from, None]);
            from = None;
            continue;
        }
        points.push(vertex.at);
        let divides = k == 0 || k + 1 == vertices.len() || shared.get(&vertex.node).is_some_and(|n| *n > 1);
        if divides {
            if points.len() > 1 {
                finish(&mut points, [from, Some(vertex.node)]);
                points.push(vertex.at);
            }
            from = Some(vertex.node);
        }
    }
    finish(&mut points, [from, None]);
    pieces
}

fn strip(piece: &PathPiece, context: &ImportContext<'_>) -> LaneSurface {
    let points: Vec<DVec3> = piece.points.iter().map(|p| p.extend(PATH_Z_M)).collect();
    let (mut left, mut right) = ribbon(&points, 0.5 * piece.width_m, -0.5 * piece.width_m, 1.5);
    left.iter_mut().chain(&mut right).for_each(|p| p.z += context.ground(p.truncate()));
    LaneSurface { kind: piece.kind, left, right, in_junction: true, unpaved: piece.unpaved, bridge: false }
}

fn lay(
    piece: &PathPiece,
    context: &ImportContext<'_>,
    walks: &mut WalkNetworkBuilder<'_>,
    at_node: &mut BTreeMap<i64, WalkNodeId>,
    uses: &BTreeMap<i64, usize>,
    loose: &mut Vec<WalkNodeId>,
) {
    let line = Polyline::new(piece.points.iter().map(|p| p.extend(PATH_Z_M)));
    let n = (line.length() / STEP_M).ceil().max(1.0) as usize;
    let mut last: Option<WalkNodeId> = None;
    for k in 0..=n {
        let p = line.at(line.length() * k as f64 / n as f64).position;
        let p = p + DVec3::Z * context.ground(p.truncate());
        let end = if k == 0 { Some(piece.ends[0]) } else { (k == n).then_some(piece.ends[1]) };
        let here = match end {
            Some(Some(node)) => *at_node.entry(node).or_insert_with(|| walks.node(p)),
            _ => walks.node(p),
        };
        // Ends that no other path shares look for a sidewalk.
        if end.is_some_and(|e| e.is_none_or(|node| uses.get(&node).is_none_or(|n| *n < 2))) {
            loose.push(here);
        }
        if let Some(last) = last {
            walks.edge(last, here, piece.width_m, WalkKind::Sidewalk);
        }
        last = Some(here);
    }
}

/// Joins the end of a path to the nearest node of a sidewalk.
fn join(walks: &mut WalkNetworkBuilder<'_>, node: WalkNodeId, streets_nodes: usize) {
    let at = walks.walk.nodes[node.index()];
    let nearest = (0..streets_nodes)
        .map(|i| (walks.walk.nodes[i].distance_squared(at), i))
        .min_by(|a, b| a.0.total_cmp(&b.0))
        .filter(|(d, _)| *d < JOIN_M * JOIN_M && *d > 0.04);
    if let Some((_, i)) = nearest {
        walks.edge(node, WalkNodeId(i as u32), 1.8, WalkKind::Sidewalk);
    }
}

/// Takes away what is joined to no street and too short to stroll on.
fn drop_disconnected_paths(network: &mut RoadNetwork, streets_nodes: usize) {
    let walk = &mut network.walk;
    let graph = WalkGraph::new(walk);
    let mut length: BTreeMap<u32, f64> = BTreeMap::new();
    for edge in &walk.edges {
        let [a, b] = edge.nodes.map(|n| walk.nodes[n.index()]);
        *length.entry(graph.part(edge.nodes[0])).or_default() += a.distance(b);
    }
    let street_part: Vec<bool> = {
        let parts = (0..walk.nodes.len()).map(|i| graph.part(WalkNodeId(i as u32))).max().map_or(0, |p| p as usize + 1);
        let mut of_street = vec![false; parts];
        (0..streets_nodes).for_each(|i| of_street[graph.part(WalkNodeId(i as u32)) as usize] = true);
        of_street
    };
    let keep: Vec<bool> = (0..walk.nodes.len())
        .map(|i| {
            let part = graph.part(WalkNodeId(i as u32));
            street_part[part as usize] || length.get(&part).is_some_and(|l| *l > ALONE_M)
        })
        .collect();
    let mut new_id = vec![WalkNodeId(0); walk.nodes.len()];
    let mut nodes = Vec::new();
    for (i, node) in walk.nodes.iter().enumerate().filter(|(i, _)| keep[*i]) {
        new_id[i] = WalkNodeId(nodes.len() as u32);
        nodes.push(*node);
    }
    walk.edges.retain(|e| keep[e.nodes[0].index()]);
    walk.edges.iter_mut().for_each(|e| e.nodes = e.nodes.map(|n| new_id[n.index()]));
    walk.nodes = nodes;
}
