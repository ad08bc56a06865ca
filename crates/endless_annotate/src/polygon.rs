//! Polygons, cut.

use crate::lens_projection::LensProjection;
use glam::DVec2;

/// The part of a polygon where `inwards` is at least 0 (Sutherland and Hodgman 1974).
pub(crate) fn cut<P: Copy>(corners: &[P], inwards: impl Fn(&P) -> f64, lerp: impl Fn(&P, &P, f64) -> P) -> Vec<P> {
    let mut kept = Vec::with_capacity(corners.len() + 2);
    for (i, here) in corners.iter().enumerate() {
        let next = &corners[(i + 1) % corners.len()];
        let (at_here, at_next) = (inwards(here), inwards(next));
        if at_here >= 0.0 {
            kept.push(*here);
        }
        if (at_here >= 0.0) != (at_next >= 0.0) {
            kept.push(lerp(here, next, at_here / (at_here - at_next)));
        }
    }
    kept
}

impl LensProjection {
    /// The part of a polygon that lies in the picture.
    pub(crate) fn cut_to_picture(&self, mut image: Vec<DVec2>) -> Vec<DVec2> {
        let sides: [fn(DVec2, DVec2) -> f64; 4] =
            [|p, _| p.x, |p, _| p.y, |p, size| size.x - p.x, |p, size| size.y - p.y];
        for side in sides {
            image = cut(&image, |p| side(*p, self.size), |a, b, share| a.lerp(*b, share));
        }
        image
    }
}
