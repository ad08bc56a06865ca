//! Smooth functions of one variable through given points.

/// A monotone cubic through points of ascending x, constant beyond its ends.
///
/// Monotone (Fritsch–Carlson), so that profiles drawn with few points do not overshoot.
#[derive(Debug, Clone)]
pub(crate) struct MonotoneCubic {
    points: Vec<(f32, f32)>,
    slopes: Vec<f32>,
}

impl MonotoneCubic {
    /// Through these points, in any order, with distinct x.
    pub(crate) fn new(points: &[(f32, f32)]) -> Self {
        let mut points = points.to_vec();
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let n = points.len();
        let secants: Vec<f32> = points.windows(2).map(|w| (w[1].1 - w[0].1) / (w[1].0 - w[0].0)).collect();
        let slopes = (0..n)
            .map(|i| match (i.checked_sub(1).map(|j| secants[j]), secants.get(i)) {
                (Some(a), Some(&b)) if a * b > 0.0 => 2.0 * a * b / (a + b),
                (None, Some(&b)) => b,
                (Some(a), None) => a,
                _ => 0.0,
            })
            .collect();
        Self { points, slopes }
    }

    /// The value at `x`.
    pub(crate) fn at(&self, x: f32) -> f32 {
        let last = self.points.len() - 1;
        if x <= self.points[0].0 {
            return self.points[0].1;
        }
        if x >= self.points[last].0 {
            return self.points[last].1;
        }
        let i = self.points.partition_point(|p| p.0 <= x) - 1;
        let ((x0, y0), (x1, y1)) = (self.points[i], self.points[i + 1]);
        let h = x1 - x0;
        let t = (x - x0) / h;
        let (t2, t3) = (t * t, t * t * t);
        y0 * (2.0 * t3 - 3.0 * t2 + 1.0)
            + self.slopes[i] * h * (t3 - 2.0 * t2 + t)
            + y1 * (3.0 * t2 - 2.0 * t3)
            + self.slopes[i + 1] * h * (t3 - t2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn goes_through_its_points_and_does_not_overshoot() {
        let c = MonotoneCubic::new(&[(2.0, 1.0), (0.0, 0.0), (1.0, 1.0)]);
        for (x, y) in [(0.0, 0.0), (1.0, 1.0), (2.0, 1.0), (-5.0, 0.0), (9.0, 1.0)] {
            assert!((c.at(x) - y).abs() < 1e-6);
        }
        for i in 0..=100 {
            let y = c.at(i as f32 * 0.02);
            assert!((0.0..=1.000_01).contains(&y));
        }
    }
}
