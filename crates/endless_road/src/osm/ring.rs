//! Rings: outlines put in order, joined from pieces, clipped to the extract.

use super::curve::{area, crosses_itself};
use glam::DVec2;

/// Outlines with more corners than this are taken as they are: looking for crossings takes the square of it.
const MOST_CHECKED: usize = 1500;

/// An outline without repeated points, turning as asked; `None` if it has no area or crosses itself.
pub(super) fn tidy(points: &[DVec2], counter_clockwise: bool) -> Option<Vec<DVec2>> {
    let mut ring: Vec<DVec2> = Vec::with_capacity(points.len());
    for &p in points {
        if ring.last().is_none_or(|l| l.distance(p) > 0.02) {
            ring.push(p);
        }
    }
    while ring.len() > 1 && ring[0].distance(ring[ring.len() - 1]) <= 0.02 {
        ring.pop();
    }
    // Corners that are none, and spikes.
    let mut i = 0;
    while ring.len() > 3 && i < ring.len() {
        let n = ring.len();
        let (a, b, c) = (ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]);
        if (b - a).perp_dot(c - b).abs() < 1e-4 * (b - a).length() * (c - b).length() + 1e-6 {
            ring.remove(i);
            i = i.saturating_sub(1);
        } else {
            i += 1;
        }
    }
    let size = area(&ring);
    if ring.len() < 3 || size.abs() < 0.5 || (ring.len() <= MOST_CHECKED && crosses_itself(&ring)) {
        return None;
    }
    if (size > 0.0) != counter_clockwise {
        ring.reverse();
    }
    Some(ring)
}

/// Closed rings from chains of node ids that share their ends; what does not close is dropped.
pub(super) fn joined(mut chains: Vec<Vec<i64>>) -> Vec<Vec<i64>> {
    let mut rings = Vec::new();
    chains.retain(|c| c.len() >= 2);
    while let Some(mut ring) = chains.pop() {
        loop {
            let (first, last) = (ring[0], ring[ring.len() - 1]);
            if first == last {
                if ring.len() > 3 {
                    rings.push(ring);
                }
                break;
            }
            let next = chains.iter().position(|c| c[0] == last || c[c.len() - 1] == last);
            let Some(next) = next else { break };
            let mut chain = chains.swap_remove(next);
            if chain[0] != last {
                chain.reverse();
            }
            ring.extend(&chain[1..]);
        }
    }
    rings
}

/// The part of a ring inside a box (Sutherland and Hodgman 1974).
pub(super) fn clipped(ring: &[DVec2], [low, high]: [DVec2; 2]) -> Vec<DVec2> {
    let mut points = ring.to_vec();
    for (axis, bound, sign) in [(0, low.x, 1.0), (0, high.x, -1.0), (1, low.y, 1.0), (1, high.y, -1.0)] {
        let inside = |p: DVec2| sign * (p[axis] - bound) >= 0.0;
        let mut out = Vec::with_capacity(points.len());
        for (k, &a) in points.iter().enumerate() {
            let b = points[(k + 1) % points.len()];
            if inside(a) {
                out.push(a);
            }
            if inside(a) != inside(b) {
                out.push(a.lerp(b, (bound - a[axis]) / (b[axis] - a[axis])));
            }
        }
        points = out;
    }
    points
}

/// Whether a point lies inside a ring.
pub(super) fn contains(ring: &[DVec2], p: DVec2) -> bool {
    let n = ring.len();
    let crossings = (0..n).filter(|&i| {
        let (a, b) = (ring[i], ring[(i + 1) % n]);
        (a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
    });
    crossings.count() % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn chains_close() {
        let rings = joined(vec![vec![1, 2, 3], vec![5, 4, 3], vec![5, 1], vec![8, 9]]);
        assert_eq!(rings.len(), 1);
        assert_eq!(rings[0].len(), 6);
    }

    #[test]
    fn clips_and_tidies() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0), (0.0, 0.0)].map(|(x, y)| DVec2::new(x, y));
        let ring = tidy(&square, false).expect("a square");
        assert_eq!(ring.len(), 4);
        assert!(area(&ring) < 0.0);
        let half = clipped(&ring, [DVec2::new(-5.0, -5.0), DVec2::new(5.0, 20.0)]);
        assert!((area(&half).abs() - 50.0).abs() < 1e-9);
        assert!(contains(&ring, DVec2::splat(5.0)) && !contains(&ring, DVec2::new(11.0, 5.0)));
        let bow = [(0.0, 0.0), (10.0, 10.0), (10.0, 0.0), (0.0, 9.0)].map(|(x, y)| DVec2::new(x, y));
        assert!(tidy(&bow, true).is_none());
    }

    proptest! {
        #[test]
        fn any_points_are_taken(points in prop::collection::vec((-50.0..50.0f64, -50.0..50.0f64), 0..30)) {
            let points: Vec<DVec2> = points.into_iter().map(|(x, y)| DVec2::new(x, y)).collect();
            if let Some(ring) = tidy(&points, true) {
                prop_assert!(area(&ring) > 0.0 && !crosses_itself(&ring));
            }
        }
    }
}
