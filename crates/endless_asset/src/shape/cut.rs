//! Painting and cutting surfaces along exact lines.

use super::face::Face;
use super::runs::RUN;
use super::sculpt::Sculpt;
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// A convex region of space, and which way a face must look to be touched.
///
/// Windows, lamps, door gaps and wheel arches are drawn on a body as regions: triangles are split where the region's
/// planes pass, so edges are exact however coarse the body is.
#[derive(Debug, Clone, Default)]
pub(crate) struct Region {
    /// Inside where `normal · p <= offset` for all.
    planes: Vec<(Vec3, f32)>,
    facing: Option<(Vec3, f32)>,
}

impl Region {
    /// Everything.
    pub(crate) fn all() -> Self {
        Self::default()
    }

    /// The prism over a convex polygon drawn in side view, (x, z), on the left side of the body.
    pub(crate) fn side(polygon: &[Vec2]) -> Self {
        Self::prism(polygon, |e| Vec3::new(e.x, 0.0, e.y)).beyond(Vec3::Y, 0.0)
    }

    /// The prism over a convex polygon drawn in side view, (x, z), right through.
    pub(crate) fn elevation(polygon: &[Vec2]) -> Self {
        Self::prism(polygon, |e| Vec3::new(e.x, 0.0, e.y))
    }

    /// The prism over a convex polygon drawn in front or rear view, (y, z).
    pub(crate) fn end(polygon: &[Vec2]) -> Self {
        Self::prism(polygon, |e| Vec3::new(0.0, e.x, e.y))
    }

    /// The prism over a convex polygon drawn in top view, (x, y).
    pub(crate) fn top(polygon: &[Vec2]) -> Self {
        Self::prism(polygon, |e| Vec3::new(e.x, e.y, 0.0))
    }

    fn prism(polygon: &[Vec2], lift: impl Fn(Vec2) -> Vec3) -> Self {
        let n = polygon.len();
        let area: f32 = (0..n).map(|i| polygon[i].perp_dot(polygon[(i + 1) % n])).sum();
        let planes = (0..n)
            .filter_map(|i| {
                let (a, b) = (polygon[i], polygon[(i + 1) % n]);
                let outward = -(b - a).perp().try_normalize()? * area.signum();
                Some((lift(outward), outward.dot(a)))
            })
            .collect();
        Self { planes, facing: None }
    }

    /// Only where `direction · p >= offset`.
    pub(crate) fn beyond(mut self, direction: Vec3, offset: f32) -> Self {
        self.planes.push((-direction, -offset));
        self
    }

    /// Only where `direction · p <= offset`.
    pub(crate) fn within(mut self, direction: Vec3, offset: f32) -> Self {
        self.planes.push((direction, offset));
        self
    }

    /// Only faces whose normal has at least this cosine with the direction.
    pub(crate) fn facing(mut self, direction: Vec3, cosine: f32) -> Self {
        self.facing = Some((direction, cosine));
        self
    }

    /// Left for right.
    pub(crate) fn mirrored(&self) -> Self {
        let flip = |v: Vec3| Vec3::new(v.x, -v.y, v.z);
        Self {
            planes: self.planes.iter().map(|&(n, d)| (flip(n), d)).collect(),
            facing: self.facing.map(|(n, c)| (flip(n), c)),
        }
    }
}

/// A polygon with its corners rounded to this radius where there is room.
pub(crate) fn rounded(corners: &[(f32, f32)], radius: f32) -> Vec<Vec2> {
    let n = corners.len();
    let at = |i: usize| Vec2::from(corners[i % n]);
    let mut out = Vec::with_capacity(n * 4);
    for i in 0..n {
        let (a, b, c) = (at(i + n - 1), at(i), at(i + 1));
        let room = 0.45 * (a - b).length().min((c - b).length());
        let r = radius.min(room);
        let (p, q) = (b + (a - b).normalize_or_zero() * r, b + (c - b).normalize_or_zero() * r);
        for t in [0.0, 0.5, 1.0f32] {
            out.push(p.lerp(b, t).lerp(b.lerp(q, t), t));
        }
    }
    out
}

impl Sculpt {
    /// Gives a region another material.
    pub(crate) fn paint(&mut self, region: &Region, material: Material) {
        for mut face in self.split(region) {
            face.material = material;
            self.faces.push(face);
        }
    }

    /// The same on both sides.
    pub(crate) fn paint_both(&mut self, region: &Region, material: Material) {
        self.paint(region, material);
        self.paint(&region.mirrored(), material);
    }

    /// Removes what lies in a region.
    pub(crate) fn remove(&mut self, region: &Region) {
        drop(self.split(region));
    }

    /// Gives what is of one material in a region another.
    pub(crate) fn repaint(&mut self, region: &Region, from: Material, to: Material) {
        for mut face in self.split_of(region, Some(from)) {
            face.material = to;
            self.faces.push(face);
        }
    }

    /// The same on both sides.
    pub(crate) fn repaint_both(&mut self, region: &Region, from: Material, to: Material) {
        self.repaint(region, from, to);
        self.repaint(&region.mirrored(), from, to);
    }

    /// Takes out what lies in a region and returns it.
    fn split(&mut self, region: &Region) -> Vec<Face> {
        self.split_of(region, None)
    }

    /// Takes out what lies in a region, of one material if it is given, and returns it. The faces that stay are not
    /// moved in memory: most regions touch few of a body's faces.
    fn split_of(&mut self, region: &Region, material: Option<Material>) -> Vec<Face> {
        let (mut inside, mut rest) = (Vec::new(), Vec::new());
        let (mut pieces, mut next, mut outside) = (Vec::new(), Vec::new(), Vec::new());
        self.runs.learn(&self.faces);
        // Neighbours lie beyond the same plane: it is asked first.
        let mut likely = 0;
        let mut i = 0;
        while i < self.faces.len() {
            if i % RUN == 0 && region.planes.iter().any(|&plane| self.runs.is_beyond(i, plane)) {
                i += RUN;
                continue;
            }
            let face = &self.faces[i];
            let [a, b, c] = face.corners;
            let beyond = |&(n, d): &(Vec3, f32)| (n.dot(a) >= d) & (n.dot(b) >= d) & (n.dot(c) >= d);
            let mut misses = region.planes.get(likely).is_some_and(beyond);
            if !misses && let Some(found) = region.planes.iter().position(beyond) {
                (likely, misses) = (found, true);
            }
            if misses
                || material.is_some_and(|m| m != face.material)
                || !region.facing.is_none_or(|(d, cosine)| face.area_normal().normalize_or_zero().dot(d) >= cosine)
            {
                i += 1;
                continue;
            }
            pieces.clear();
            outside.clear();
            pieces.push(*face);
            for &(n, d) in &region.planes {
                next.clear();
                for piece in &pieces {
                    clip(piece, n, d, &mut next, &mut outside);
                }
                std::mem::swap(&mut pieces, &mut next);
            }
            if pieces.is_empty() {
                // A face that only looked as if it were touched stays whole.
                i += 1;
                continue;
            }
            self.faces.swap_remove(i);
            self.runs.removed(i, &self.faces);
            rest.append(&mut outside);
            inside.append(&mut pieces);
        }
        self.faces.append(&mut rest);
        inside
    }
}

/// Splits a face by a plane into what lies below and above.
fn clip(face: &Face, normal: Vec3, offset: f32, below: &mut Vec<Face>, above: &mut Vec<Face>) {
    let distance = face.corners.map(|p| {
        let d = normal.dot(p) - offset;
        if d.abs() < 1e-5 { 0.0 } else { d }
    });
    if distance.iter().all(|&d| d <= 0.0) {
        return below.push(*face);
    }
    if distance.iter().all(|&d| d >= 0.0) {
        return above.push(*face);
    }
    let (mut low, mut high) = (Vec::with_capacity(4), Vec::with_capacity(4));
    for i in 0..3 {
        let j = (i + 1) % 3;
        let corner = (face.corners[i], face.normals[i]);
        if distance[i] <= 0.0 {
            low.push(corner);
        }
        if distance[i] >= 0.0 {
            high.push(corner);
        }
        if distance[i] * distance[j] < 0.0 {
            // Always from the lower end, so that both neighbours of an edge get the same point.
            let (a, b) = if distance[i] < 0.0 { (i, j) } else { (j, i) };
            let t = distance[a] / (distance[a] - distance[b]);
            let point = face.corners[a].lerp(face.corners[b], t);
            let n = face.normals[a].lerp(face.normals[b], t).normalize_or(face.normals[a]);
            low.push((point, n));
            high.push((point, n));
        }
    }
    for (polygon, out) in [(low, below), (high, above)] {
        for k in 2..polygon.len() {
            let c = [polygon[0], polygon[k - 1], polygon[k]];
            let piece = Face { corners: c.map(|x| x.0), normals: c.map(|x| x.1), material: face.material };
            if piece.area_normal().length() > 1e-8 {
                out.push(piece);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_scene::Surface;
    use endless_world::ClassTag;

    #[test]
    fn painting_keeps_the_area() {
        let [a, b] = [0.1, 0.9].map(|c| Material::new(Surface::Metal, [c; 3], ClassTag::Static));
        let mut s = Sculpt::new();
        s.quad([Vec3::ZERO, Vec3::X, Vec3::X + Vec3::Z, Vec3::Z], a);
        s.paint(&Region::end(&[]).within(Vec3::X, 0.5), b);
        let disc = rounded(&[(0.2, 0.2), (0.8, 0.2), (0.8, 0.8), (0.2, 0.8)], 0.1);
        s.paint(&Region::prism(&disc, |e| Vec3::new(e.x, 0.0, e.y)), b);
        let area = |m| s.faces.iter().filter(|f| f.material == m).map(|f| f.area_normal().length() / 2.0).sum::<f32>();
        assert!((area(a) + area(b) - 1.0).abs() < 1e-5);
        // Half the square, and the other half of the rounded square within it.
        assert!(area(b) > 0.67 && area(b) < 0.68);
    }
}
