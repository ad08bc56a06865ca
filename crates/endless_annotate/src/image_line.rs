//! Lines and areas of the world as a camera shows them: cut to the picture, bent as its lens bends them.

use crate::image_shape::{ImageArea, ImageLine, image_point, world_point};
use crate::lens_projection::{FrustumPlane, LensProjection, between};
use crate::other_lens::OtherLens;
use crate::polygon::cut;
use crate::way_inside::WayInside;
use glam::{DVec2, DVec3};

impl LensProjection {
    /// The parts of a line of the world that lie in the picture and no deeper than `far_m`.
    pub(crate) fn line(&self, line: &[DVec3], far_m: f64) -> Vec<ImageLine> {
        if let Some(other) = self.other_lens() {
            return OtherLens { lens: self, other, far_m }.line(line);
        }
        let frustum = self.frustum(far_m);
        let mut parts = LineParts::default();
        for pair in line.windows(2) {
            let ends = [self.to_camera(pair[0]), self.to_camera(pair[1])];
            let Some([a, b]) = clipped(ends, &frustum) else {
                parts.end();
                continue;
            };
            if a != ends[0] {
                parts.end();
            }
            let samples = self.samples([a, b]);
            for piece in samples.windows(2) {
                self.add_piece([piece[0], piece[1]], &mut parts);
            }
            if b != ends[1] {
                parts.end();
            }
        }
        parts.end();
        parts.done.iter().map(|part| self.image_line(part)).collect()
    }

    fn image_line(&self, part: &[DVec3]) -> ImageLine {
        let inside = |p: DVec2| p.clamp(DVec2::ZERO, self.size);
        ImageLine {
            world: part.iter().map(|&p| world_point(self.to_world(p))).collect(),
            image: part.iter().map(|&p| image_point(inside(self.image(p)))).collect(),
        }
    }

    /// Adds what the picture shows of a piece that looks straight in it.
    fn add_piece(&self, [a, b]: [DVec3; 2], parts: &mut LineParts) {
        match [a, b].map(|p| self.shows(self.image(p))) {
            [true, true] => parts.push([a, b]),
            [true, false] => parts.push([a, self.border(a, b)]),
            [false, true] => parts.push([self.border(b, a), b]),
            [false, false] => {
                let inside = WayInside::ALL.in_picture([self.image(a), self.image(b)], self.size);
                let Some(share) = inside.middle() else { return };
                let middle = between(a, b, share);
                if self.shows(self.image(middle)) {
                    parts.push([self.border(middle, a), self.border(middle, b)]);
                }
            }
        }
    }

    /// Where the way from a point in the picture to one outside leaves it.
    fn border(&self, mut inside: DVec3, mut outside: DVec3) -> DVec3 {
        for _ in 0..50 {
            let middle = inside.midpoint(outside);
            if self.shows(self.image(middle)) { inside = middle } else { outside = middle }
        }
        inside
    }

    /// The parts of a flat area that lie in the picture and no deeper than `far_m`, of at least a pixel each: more than one
    /// only where the left and right edges of the picture meet.
    pub(crate) fn areas(&self, outline: &[DVec3], far_m: f64) -> Vec<ImageArea> {
        let pieces = match self.other_lens() {
            Some(other) => OtherLens { lens: self, other, far_m }.outlines(outline),
            None => vec![self.outline(outline, far_m)],
        };
        let world: Vec<[f64; 3]> = outline.iter().map(|&p| world_point(p)).collect();
        let area = |image: Vec<DVec2>| {
            let mut image: Vec<[f64; 2]> =
                image.into_iter().map(|p| image_point(p.clamp(DVec2::ZERO, self.size))).collect();
            image.dedup();
            (area_px(&image) >= 1.0).then(|| ImageArea { world: world.clone(), image })
        };
        pieces.into_iter().filter_map(area).collect()
    }

    /// The part of a flat area that lies in the picture of a perspective lens.
    fn outline(&self, outline: &[DVec3], far_m: f64) -> Vec<DVec2> {
        let mut corners: Vec<DVec3> = outline.iter().map(|&p| self.to_camera(p)).collect();
        for plane in self.frustum(far_m) {
            corners = cut(&corners, |p| plane.inwards(*p), |a, b, share| a.lerp(*b, share));
        }
        let edges = (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
        let bent = edges.flat_map(|edge| {
            let mut points = self.samples(edge);
            points.pop();
            points
        });
        self.cut_to_picture(bent.map(|p| self.image(p)).collect())
    }
}

/// The parts of a line, in the camera's frame.
#[derive(Default)]
struct LineParts {
    done: Vec<Vec<DVec3>>,
    open: Vec<DVec3>,
}

impl LineParts {
    fn push(&mut self, [a, b]: [DVec3; 2]) {
        if self.open.last() != Some(&a) {
            self.end();
            self.open.push(a);
        }
        self.open.push(b);
    }

    fn end(&mut self) {
        let part = std::mem::take(&mut self.open);
        if part.len() > 1 {
            self.done.push(part);
        }
    }
}

/// The part of a segment on the inner side of all planes.
fn clipped([a, b]: [DVec3; 2], planes: &[FrustumPlane]) -> Option<[DVec3; 2]> {
    let (mut from, mut to) = (0.0f64, 1.0f64);
    for plane in planes {
        let (at_a, at_b) = (plane.inwards(a), plane.inwards(b));
        match (at_a >= 0.0, at_b >= 0.0) {
            (true, true) => {}
            (false, false) => return None,
            (true, false) => to = to.min(at_a / (at_a - at_b)),
            (false, true) => from = from.max(at_a / (at_a - at_b)),
        }
    }
    let at = |share: f64, end: DVec3, whole: f64| if share == whole { end } else { a.lerp(b, share) };
    (from < to).then(|| [at(from, a, 0.0), at(to, b, 1.0)])
}

fn area_px(outline: &[[f64; 2]]) -> f64 {
    let corner = |i: usize| DVec2::from(outline[i % outline.len()]);
    (0..outline.len()).map(|i| corner(i).perp_dot(corner(i + 1))).sum::<f64>().abs() / 2.0
}

#[cfg(test)]
mod tests;
