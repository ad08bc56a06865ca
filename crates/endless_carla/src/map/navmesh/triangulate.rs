//! Triangles of a simple polygon, by cutting off ears (Meisters 1975; O'Rourke, Computational Geometry in C, 1.4). All
//! corners are kept, those on straight sides too: neighbours have them.

/// A corner, as whole numbers: everything is exact.
pub(super) type Point = [i32; 2];

/// Triangles of a polygon that is given counter-clockwise, as indices, counter-clockwise. Where the polygon crosses
/// itself what is left of it is missing.
pub(super) fn triangulate(points: &[Point]) -> Vec<[usize; 3]> {
    let mut left: Vec<usize> = (0..points.len()).collect();
    let mut triangles = Vec::new();
    while left.len() > 3 {
        let n = left.len();
        let ring = Ring { points, left: &left };
        let shortest = |strict: bool| {
            let ears = (0..n).filter(|&i| ring.is_ear(i, strict));
            ears.min_by_key(|&i| length(ring.at(i + n - 1), ring.at(i + 1)))
        };
        let Some(ear) = shortest(true).or_else(|| shortest(false)) else { return triangles };
        push(points, [left[(ear + n - 1) % n], left[ear], left[(ear + 1) % n]], &mut triangles);
        left.remove(ear);
    }
    if let [a, b, c] = left[..] {
        push(points, [a, b, c], &mut triangles);
    }
    triangles
}

fn push(points: &[Point], triangle: [usize; 3], into: &mut Vec<[usize; 3]>) {
    let [a, b, c] = triangle.map(|i| points[i]);
    if area(a, b, c) > 0 {
        into.push(triangle);
    }
}

/// Twice the area of a triangle; positive if it is counter-clockwise.
pub(super) fn area(a: Point, b: Point, c: Point) -> i64 {
    let side = |p: Point| [i64::from(p[0]) - i64::from(a[0]), i64::from(p[1]) - i64::from(a[1])];
    let (u, v) = (side(b), side(c));
    u[0] * v[1] - u[1] * v[0]
}

fn length(a: Point, b: Point) -> i64 {
    let [x, y] = [0, 1].map(|k| i64::from(b[k]) - i64::from(a[k]));
    x * x + y * y
}

/// What is left of a polygon.
struct Ring<'a> {
    points: &'a [Point],
    left: &'a [usize],
}

impl Ring<'_> {
    fn at(&self, i: usize) -> Point {
        self.points[self.left[i % self.left.len()]]
    }

    /// Whether the corner can be cut off. Not strictly, cuts may touch other corners.
    fn is_ear(&self, i: usize, strict: bool) -> bool {
        let n = self.left.len();
        let (before, after) = (i + n - 1, i + 1);
        let convex = area(self.at(before), self.at(i), self.at(after)) > 0;
        convex
            && self.in_cone(before, after, strict)
            && self.in_cone(after, before, strict)
            && self.crosses_no_side(before, after, strict)
    }

    /// Whether the way from a corner to another begins inside.
    fn in_cone(&self, from: usize, to: usize, strict: bool) -> bool {
        let n = self.left.len();
        let (a, b) = (self.at(from), self.at(to));
        let (before, after) = (self.at(from + n - 1), self.at(from + 1));
        let left = |p: Point, q: Point, r: Point| area(p, q, r) > 0 || (!strict && area(p, q, r) == 0);
        if area(a, after, before) >= 0 {
            return left(a, b, before) && left(b, a, after);
        }
        let outside = |p: Point, q: Point, r: Point| area(p, q, r) > 0 || (strict && area(p, q, r) == 0);
        !(outside(a, b, after) && outside(b, a, before))
    }

    fn crosses_no_side(&self, from: usize, to: usize, strict: bool) -> bool {
        let n = self.left.len();
        let (a, b) = (self.at(from), self.at(to));
        (0..n).all(|k| {
            let (c, d) = (self.at(k), self.at(k + 1));
            let ends = [from % n, to % n];
            if ends.contains(&k) || ends.contains(&((k + 1) % n)) || [a, b].contains(&c) || [a, b].contains(&d) {
                return true;
            }
            if strict { !touch(a, b, c, d) } else { !cross(a, b, c, d) }
        })
    }
}

/// Whether two lines cross properly.
fn cross(a: Point, b: Point, c: Point, d: Point) -> bool {
    let signs = [area(a, b, c), area(a, b, d), area(c, d, a), area(c, d, b)].map(i64::signum);
    !signs.contains(&0) && signs[0] != signs[1] && signs[2] != signs[3]
}

/// Whether two lines cross or touch.
fn touch(a: Point, b: Point, c: Point, d: Point) -> bool {
    let between = |p: Point, q: Point, r: Point| {
        let within = |k: usize| (p[k].min(q[k])..=p[k].max(q[k])).contains(&r[k]);
        area(p, q, r) == 0 && within(0) && within(1)
    };
    cross(a, b, c, d) || between(a, b, c) || between(a, b, d) || between(c, d, a) || between(c, d, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn whole(points: &[Point]) -> i64 {
        (1..points.len() - 1).map(|i| area(points[0], points[i], points[i + 1])).sum()
    }

    #[test]
    fn corners_on_straight_sides_are_kept() {
        let points = [[0, 0], [1, 0], [2, 0], [4, 0], [4, 3], [2, 3], [0, 3], [0, 1]];
        let triangles = triangulate(&points);
        assert_eq!(triangles.len(), points.len() - 2);
        let covered: i64 = triangles.iter().map(|&[a, b, c]| area(points[a], points[b], points[c])).sum();
        assert_eq!(covered, whole(&points));
    }

    proptest! {
        /// Staircases: one run of cells in each row.
        #[test]
        fn regions_are_covered(rows in prop::collection::vec((-6i32..6, 7i32..20), 1..30)) {
            let mut points: Vec<Point> = Vec::new();
            let numbered: Vec<(i32, i32, i32)> = (0..).zip(&rows).map(|(row, &(from, to))| (row, from, to)).collect();
            points.extend(numbered.iter().flat_map(|&(row, _, to)| [[to, row], [to, row + 1]]));
            points.extend(numbered.iter().rev().flat_map(|&(row, from, _)| [[from, row + 1], [from, row]]));
            points.dedup();
            let triangles = triangulate(&points);
            let covered: i64 = triangles.iter().map(|&[a, b, c]| area(points[a], points[b], points[c])).sum();
            prop_assert_eq!(covered, whole(&points));
            prop_assert_eq!(triangles.len(), points.len() - 2);
        }
    }
}
