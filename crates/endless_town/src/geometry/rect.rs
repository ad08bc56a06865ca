//! What stands where, seen from above: rectangles that must not meet.

use endless_world::math::f64::sin_cos;
use glam::DVec2;
use std::collections::BTreeMap;

/// The unit vector at an angle from east, radians.
pub(crate) fn unit(angle_rad: f64) -> DVec2 {
    let (sin, cos) = sin_cos(angle_rad);
    DVec2::new(cos, sin)
}

/// An oriented rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub(crate) centre: DVec2,
    /// Half its size along its own axes.
    pub(crate) half: DVec2,
    /// Unit vector of its own x axis.
    pub(crate) axis: DVec2,
}

impl Rect {
    pub(crate) fn new(centre: DVec2, half: DVec2, angle_rad: f64) -> Self {
        Self { centre, half, axis: unit(angle_rad) }
    }

    /// A square around a disc.
    pub(crate) fn around(centre: DVec2, radius: f64) -> Self {
        Self { centre, half: DVec2::splat(radius), axis: DVec2::X }
    }

    pub(crate) fn grown(self, margin: f64) -> Self {
        Self { half: self.half + DVec2::splat(margin), ..self }
    }

    pub(crate) fn corners(&self) -> [DVec2; 4] {
        let (x, y) = (self.axis * self.half.x, self.axis.perp() * self.half.y);
        [self.centre - x - y, self.centre + x - y, self.centre + x + y, self.centre - x + y]
    }

    /// Whether two rectangles share more than their borders (separating axes).
    pub(crate) fn meets(&self, other: &Self) -> bool {
        let between = other.centre - self.centre;
        let reach = self.half.length() + other.half.length();
        if between.length_squared() > reach * reach {
            return false;
        }
        [self.axis, self.axis.perp(), other.axis, other.axis.perp()].iter().all(|&axis| {
            let radius = |r: &Self| r.half.x * r.axis.dot(axis).abs() + r.half.y * r.axis.perp().dot(axis).abs();
            between.dot(axis).abs() < radius(self) + radius(other) - 1e-9
        })
    }
}

/// Whether a point lies inside an outline (even-odd rule).
pub(crate) fn inside(outline: &[DVec2], p: DVec2) -> bool {
    let n = outline.len();
    (0..n)
        .filter(|&i| {
            let (a, b) = (outline[i], outline[(i + 1) % n]);
            (a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)
        })
        .count()
        % 2
        == 1
}

/// The smallest rectangle around an outline that is parallel to one of its walls.
pub(crate) fn around(outline: &[DVec2]) -> Rect {
    let boxes = (0..outline.len()).filter_map(|k| {
        let axis = (outline[(k + 1) % outline.len()] - outline[k]).try_normalize()?;
        let local = outline.iter().map(|p| DVec2::new(p.dot(axis), p.dot(axis.perp())));
        let (low, high) = local.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
        let middle = (low + high) / 2.0;
        Some(Rect { centre: axis * middle.x + axis.perp() * middle.y, half: (high - low) / 2.0, axis })
    });
    boxes.min_by(|a, b| (a.half.x * a.half.y).total_cmp(&(b.half.x * b.half.y))).unwrap_or(Rect {
        centre: DVec2::ZERO,
        half: DVec2::ZERO,
        axis: DVec2::X,
    })
}

/// Side of the bins of [`OccupiedSpace`], metres.
const BIN_M: f64 = 12.0;

/// The footprints of everything placed so far.
#[derive(Debug, Clone, Default)]
pub(crate) struct OccupiedSpace {
    taken: Vec<Rect>,
    /// Numbers of those that may reach into a bin.
    bins: BTreeMap<(i32, i32), Vec<u32>>,
}

/// The bins that a rectangle may reach into.
fn bins(rect: &Rect) -> impl Iterator<Item = (i32, i32)> {
    let corners = rect.corners();
    let low = corners.iter().fold(DVec2::INFINITY, |l, &p| l.min(p)) / BIN_M;
    let high = corners.iter().fold(DVec2::NEG_INFINITY, |h, &p| h.max(p)) / BIN_M;
    let (low, high) = (low.floor().as_ivec2(), high.floor().as_ivec2());
    (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| (x, y)))
}

impl OccupiedSpace {
    pub(crate) fn is_free(&self, rect: &Rect) -> bool {
        let near = |bin| self.bins.get(&bin).into_iter().flatten();
        !bins(rect).flat_map(near).any(|&i| self.taken[i as usize].meets(rect))
    }

    pub(crate) fn take(&mut self, rect: Rect) {
        for bin in bins(&rect) {
            self.bins.entry(bin).or_default().push(self.taken.len() as u32);
        }
        self.taken.push(rect);
    }

    /// Takes the place if it is free.
    pub(crate) fn try_take(&mut self, rect: Rect) -> bool {
        let free = self.is_free(&rect);
        if free {
            self.take(rect);
        }
        free
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn contains(rect: &Rect, p: DVec2) -> bool {
        let q = p - rect.centre;
        q.dot(rect.axis).abs() <= rect.half.x && q.dot(rect.axis.perp()).abs() <= rect.half.y
    }

    proptest! {
        #[test]
        fn rectangles_meet_when_a_point_is_in_both(
            x in -8.0..8.0f64, y in -8.0..8.0f64, turn in 0.0..6.3f64, w in 0.5..4.0f64, h in 0.5..4.0f64,
        ) {
            let a = Rect::new(DVec2::ZERO, DVec2::new(3.0, 1.5), 0.3);
            let b = Rect::new(DVec2::new(x, y), DVec2::new(w, h), turn);
            let shared = (0..400).any(|i| {
                let p = DVec2::new(f64::from(i % 20), f64::from(i / 20)) / 19.0 * 2.0 - 1.0;
                contains(&a, b.centre + b.axis * p.x * w * 0.999 + b.axis.perp() * p.y * h * 0.999)
            });
            prop_assert_eq!(a.meets(&b), b.meets(&a));
            prop_assert!(!shared || a.meets(&b));
        }

        #[test]
        fn what_is_free_meets_nothing(
            places in prop::collection::vec((-60.0..60.0f64, -60.0..60.0f64, 0.0..6.3f64, 0.2..30.0f64, 0.2..4.0f64), 2..40),
        ) {
            let rects: Vec<Rect> =
                places.iter().map(|&(x, y, turn, w, h)| Rect::new(DVec2::new(x, y), DVec2::new(w, h), turn)).collect();
            let mut occupied = OccupiedSpace::default();
            for (i, rect) in rects.iter().enumerate() {
                prop_assert_eq!(occupied.is_free(rect), !rects[..i].iter().any(|r| r.meets(rect)));
                occupied.take(*rect);
            }
        }
    }
}
