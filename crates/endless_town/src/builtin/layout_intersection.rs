//! Where the ways of a layout meet: points at their intersections, and stubs beyond these cut off.

use super::layout::{LayoutWay, TownLayout};
use super::layout_geometry::along;
use glam::DVec2;
use std::collections::BTreeMap;

/// Ends of roads that lie this near to another road join it, metres.
const JOIN_M: f64 = 6.0;
/// Roads that go on this far behind the last other one end there, metres.
const STUB_M: f64 = 14.0;
/// Points nearer than this are one, metres.
const SAME_M: f64 = 0.3;

impl TownLayout {
    /// Puts a common point where roads of one level cross, and where one ends on another.
    pub(super) fn meet(&mut self) {
        let layer = |line: &LayoutWay| line.tags.get("layer").unwrap_or("0").to_owned();
        let roads: Vec<usize> = (0..self.lines.len()).filter(|&i| self.lines[i].road).collect();
        let mut inserts: BTreeMap<usize, Vec<(f64, DVec2)>> = BTreeMap::new();
        for (k, &i) in roads.iter().enumerate() {
            for &j in &roads[k + 1..] {
                let (a, b) = (&self.lines[i], &self.lines[j]);
                if layer(a) != layer(b) {
                    continue;
                }
                for p in meetings(&a.points, &b.points) {
                    inserts.entry(i).or_default().push((along(&a.points, p), p));
                    inserts.entry(j).or_default().push((along(&b.points, p), p));
                }
            }
        }
        for (i, mut list) in inserts {
            list.sort_by(|a, b| a.0.total_cmp(&b.0));
            let points = with_points(&self.lines[i].points, &list);
            let meets: Vec<DVec2> = list.into_iter().map(|l| l.1).collect();
            self.lines[i].points = without_stubs(points, &meets);
        }
    }
}

/// Where two chains of points meet: crossings, and ends near the other.
fn meetings(a: &[DVec2], b: &[DVec2]) -> Vec<DVec2> {
    let mut found: Vec<DVec2> = Vec::new();
    let add = |p: DVec2, found: &mut Vec<DVec2>| {
        if found.iter().all(|q: &DVec2| q.distance(p) > 2.0 * JOIN_M) {
            found.push(p);
        }
    };
    let ends = |line: &[DVec2]| [line[0], line[line.len() - 1]];
    // Ends that follow one another stay where they are; others move onto the road that they join.
    for end in ends(a).into_iter().filter(|p| ends(b).iter().any(|q| q.distance(*p) < SAME_M)) {
        add(end, &mut found);
    }
    for (one, other) in [(a, b), (b, a)] {
        for end in ends(one) {
            let near = super::layout_geometry::at(other, along(other, end));
            if near.distance(end) < JOIN_M {
                add(near, &mut found);
            }
        }
    }
    for p in a.windows(2) {
        for q in b.windows(2) {
            let (u, v) = (p[1] - p[0], q[1] - q[0]);
            let cross = u.perp_dot(v);
            if cross.abs() < 1e-9 {
                continue;
            }
            let d = q[0] - p[0];
            let (s, t) = (d.perp_dot(v) / cross, d.perp_dot(u) / cross);
            if (0.0..=1.0).contains(&s) && (0.0..=1.0).contains(&t) {
                add(p[0] + u * s, &mut found);
            }
        }
    }
    found
}

/// A chain that ends where it meets others, if it goes on just a little.
fn without_stubs(mut points: Vec<DVec2>, meets: &[DVec2]) -> Vec<DVec2> {
    if points[0].distance(points[points.len() - 1]) < SAME_M {
        return points;
    }
    for _ in 0..2 {
        let mut s = 0.0;
        let first = (0..points.len()).find(|&k| {
            s += if k > 0 { points[k - 1].distance(points[k]) } else { 0.0 };
            s > STUB_M || meets.iter().any(|m| m.distance(points[k]) < SAME_M)
        });
        if let Some(k) = first.filter(|_| s <= STUB_M) {
            points.drain(..k);
        }
        points.reverse();
    }
    points
}

/// A chain with more points in it, each at its place along; a point near an own one takes its place.
fn with_points(points: &[DVec2], inserts: &[(f64, DVec2)]) -> Vec<DVec2> {
    let mut placed: Vec<(f64, DVec2, bool)> = Vec::new();
    let mut s = 0.0;
    for (k, &p) in points.iter().enumerate() {
        s += if k > 0 { points[k - 1].distance(p) } else { 0.0 };
        placed.push((s, p, false));
    }
    let closed = points[0].distance(points[points.len() - 1]) < SAME_M;
    for &(s, p) in inserts {
        // An end gives way to the place where it joins; other points to one that is nearly there.
        let is_end = |q: DVec2| !closed && (q == points[0] || q == points[points.len() - 1]);
        let reach = |q: DVec2| if is_end(q) { JOIN_M + SAME_M } else { 1.5 };
        placed.retain(|q| q.2 || q.1.distance(p) > reach(q.1) || (closed && q.1 == points[0]));
        if closed && p.distance(points[0]) < SAME_M {
            continue;
        }
        placed.push((s, p, true));
    }
    placed.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut out: Vec<DVec2> = placed.into_iter().map(|q| q.1).collect();
    out.dedup_by(|a, b| a.distance(*b) < SAME_M);
    out
}
