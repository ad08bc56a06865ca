//! What one stands on in a town, as pieces with four corners: sidewalks, crossings, lanes.

use endless_road::{Lane, RoadNetwork, WalkKind};
use endless_town::{SidewalkStrip, Town};
use glam::{DVec2, DVec3};

/// Crossings reach so far onto the sidewalks at their ends, metres: over the kerb stones.
const OVER_KERB_M: f64 = 0.6;
/// Between the outermost lane and the kerb, metres.
const GUTTER_M: f64 = 0.5;
/// Ways of the walk network are kept open this wide, metres.
const WAY_M: f64 = 1.25;
/// They reach so far beyond their ends, so that they meet in bends, metres.
const BEYOND_M: f64 = 0.3;

/// The kind of a surface. Where some lie on one another the last of these counts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum SurfaceKind {
    /// A lane for vehicles.
    Road,
    /// A way of the walk network: sidewalk, whatever else lies there.
    Way,
    /// A pedestrian crossing.
    Crosswalk,
    /// A sidewalk or square.
    Sidewalk,
}

/// A piece of ground: two triangles, of the first three corners, and of the first and the last two.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Surface {
    pub(super) kind: SurfaceKind,
    /// Around it, in the world, metres.
    pub(super) corners: [DVec3; 4],
}

impl Surface {
    /// Its two triangles.
    pub(super) fn triangles(&self) -> [[DVec3; 3]; 2] {
        let [a, b, c, d] = self.corners;
        [[a, b, c], [a, c, d]]
    }

    /// Its smallest and largest coordinates, seen from above.
    pub(super) fn bounds(&self) -> [DVec2; 2] {
        let flat = self.corners.map(DVec3::truncate);
        [flat.into_iter().fold(flat[0], DVec2::min), flat.into_iter().fold(flat[0], DVec2::max)]
    }

    /// Its height at a place; `None` beside it.
    pub(super) fn height(&self, place: DVec2) -> Option<f64> {
        self.triangles().iter().find_map(|triangle| height_on(triangle, place))
    }
}

/// Height of a triangle at a place; `None` beside it.
fn height_on([a, b, c]: &[DVec3; 3], place: DVec2) -> Option<f64> {
    let (u, v, p) = ((*b - *a).truncate(), (*c - *a).truncate(), place - a.truncate());
    let area = u.perp_dot(v);
    if area.abs() < 1e-9 {
        return None;
    }
    let (s, t) = (p.perp_dot(v) / area, u.perp_dot(p) / area);
    let inside = s >= -1e-9 && t >= -1e-9 && s + t <= 1.0 + 1e-9;
    inside.then_some(a.z + s * (b.z - a.z) + t * (c.z - a.z))
}

/// All surfaces of a town.
pub(super) fn surfaces(town: &Town) -> Vec<Surface> {
    let mut all = Vec::new();
    for strip in &town.streets.sidewalks {
        sidewalk(strip, &mut all);
    }
    for crossing in &town.network.crossings {
        let [a, b] = crossing.ends;
        all.extend(strip(SurfaceKind::Crosswalk, [a, b], crossing.width_m, OVER_KERB_M));
    }
    ways(&town.network, &mut all);
    for lane in &town.network.lanes {
        road(lane, &mut all);
    }
    all
}

fn sidewalk(strip: &SidewalkStrip, into: &mut Vec<Surface>) {
    for (left, right) in strip.left.windows(2).zip(strip.right.windows(2)) {
        into.push(Surface { kind: SurfaceKind::Sidewalk, corners: [right[0], right[1], left[1], left[0]] });
    }
}

/// The ways of the walk network beside roads, and from its nodes to the kerbs of crossings.
fn ways(network: &RoadNetwork, into: &mut Vec<Surface>) {
    let walk = &network.walk;
    for edge in &walk.edges {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()]);
        let width_m = edge.width_m.clamp(0.75, WAY_M);
        match edge.kind {
            WalkKind::Sidewalk => into.extend(strip(SurfaceKind::Way, [a, b], width_m, BEYOND_M)),
            WalkKind::Crossing(crossing) => {
                let Some(crossing) = network.crossings.get(crossing.index()) else { continue };
                let [p, q] = crossing.ends;
                let (near, far) =
                    if a.distance(p) + b.distance(q) < a.distance(q) + b.distance(p) { (p, q) } else { (q, p) };
                for (node, kerb) in [(a, near), (b, far)] {
                    into.extend(strip(SurfaceKind::Way, [node, kerb.truncate().extend(node.z)], WAY_M, BEYOND_M));
                }
            }
        }
    }
}

fn road(lane: &Lane, into: &mut Vec<Surface>) {
    let points = lane.centerline.points();
    let half = 0.5 * lane.width_m + GUTTER_M;
    let across = |i: usize| {
        let (before, after) = (points[i.saturating_sub(1)], points[(i + 1).min(points.len() - 1)]);
        (after - before).truncate().perp().normalize_or_zero().extend(0.0) * half
    };
    for i in 1..points.len() {
        let (from, to) = (across(i - 1), across(i));
        let corners = [points[i - 1] - from, points[i] - to, points[i] + to, points[i - 1] + from];
        into.push(Surface { kind: SurfaceKind::Road, corners });
    }
}

/// A straight strip that reaches beyond its ends; `None` if it has no length.
fn strip(kind: SurfaceKind, [a, b]: [DVec3; 2], width_m: f64, beyond_m: f64) -> Option<Surface> {
    let along = (b - a).truncate().try_normalize()?;
    let (side, end) = ((along.perp() * (0.5 * width_m)).extend(0.0), (along * beyond_m).extend(0.0));
    Some(Surface { kind, corners: [a - end - side, b + end - side, b + end + side, a - end + side] })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_those_of_the_plane() {
        let corner = |x: f64, y: f64| DVec3::new(x, y, 1.0 + 0.1 * x - 0.2 * y);
        let corners = [corner(0.0, 0.0), corner(4.0, 0.0), corner(4.0, 2.0), corner(0.0, 2.0)];
        let surface = Surface { kind: SurfaceKind::Road, corners };
        for (x, y) in [(0.5, 1.5), (3.5, 0.5), (2.0, 1.0)] {
            assert!((surface.height(DVec2::new(x, y)).expect("inside") - corner(x, y).z).abs() < 1e-9);
        }
        assert_eq!(surface.height(DVec2::new(4.5, 1.0)), None);
    }
}
