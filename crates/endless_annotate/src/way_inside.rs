//! The part of a straight way that lies inside of something: which share of it that is.

use glam::DVec2;

/// From one share of the way to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct WayInside {
    from: f64,
    to: f64,
}

impl WayInside {
    pub(crate) const ALL: Self = Self { from: 0.0, to: 1.0 };

    /// What is left of it where a number that grows steadily along the way, and is known at both ends, lies in a range (Liang and
    /// Barsky 1984).
    pub(crate) fn between(self, [start, end]: [f64; 2], [low, high]: [f64; 2]) -> Self {
        let step = end - start;
        if step == 0.0 {
            return if (low..=high).contains(&start) { self } else { Self { from: 1.0, to: 0.0 } };
        }
        let [near, far] = [(low - start) / step, (high - start) / step];
        Self { from: self.from.max(near.min(far)), to: self.to.min(near.max(far)) }
    }

    /// What is left of it in a picture of this size.
    pub(crate) fn in_picture(self, [a, b]: [DVec2; 2], size: DVec2) -> Self {
        self.between([a.x, b.x], [0.0, size.x]).between([a.y, b.y], [0.0, size.y])
    }

    /// What is left of it in a circle.
    pub(crate) fn in_circle(self, [a, b]: [DVec2; 2], middle: DVec2, radius: f64) -> Self {
        let (out, way) = (a - middle, b - a);
        let length = way.length();
        if length == 0.0 {
            return self;
        }
        let nearest = -out.dot(way) / length;
        let beside = out.length_squared() - nearest * nearest;
        let half = (radius * radius - beside).max(0.0).sqrt();
        Self { from: self.from.max((nearest - half) / length), to: self.to.min((nearest + half) / length) }
    }

    /// Its middle, if anything is left.
    pub(crate) fn middle(self) -> Option<f64> {
        (self.from < self.to).then_some(self.from.midpoint(self.to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_what_is_left_lies_inside() {
        let way = [DVec2::new(-3.0, 1.0), DVec2::new(1.0, -3.0)];
        let size = DVec2::new(10.0, 10.0);
        assert_eq!(WayInside::ALL.in_picture(way, size).middle(), None);
        let corner = [DVec2::new(-1.0, 2.0), DVec2::new(2.0, -1.0)];
        let share = WayInside::ALL.in_picture(corner, size).middle().expect("a chord of the corner");
        assert!(corner[0].lerp(corner[1], share).abs_diff_eq(DVec2::new(0.5, 0.5), 1e-12));
        let circle = WayInside::ALL.in_circle(corner, DVec2::new(-1.0, 2.0), 1.0);
        assert!(circle.middle().is_some_and(|share| (share - 0.5 / 18f64.sqrt()).abs() < 1e-12));
        assert_eq!(WayInside::ALL.in_circle(corner, DVec2::new(20.0, 2.0), 1.0).middle(), None);
    }
}
