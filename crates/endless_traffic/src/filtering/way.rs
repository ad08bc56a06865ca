//! How far a rider is on the way past a queue.

use crate::incident::Drift;
use endless_world::Side;

/// Riders are so much faster than those they pass at most, m/s, and brake for that as hard as this before they are beside them,
/// m/s².
const FASTER_MPS: f64 = 4.0;
const EASES_MPS2: f64 = 1.5;

/// How somebody passes a queue.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Filtering {
    /// From the usual place in the lane, and back.
    pub(super) drift: Drift,
    /// The lane beside over whose line the body reaches.
    pub(super) straddles: Option<Side>,
}

impl Filtering {
    /// Metres to the left of the usual place in the lane, and the slope to there.
    pub(crate) fn aside(&self, rolled_m: f64) -> (f64, f64) {
        self.drift.at(rolled_m)
    }

    /// Where the way leads, metres to the left of the usual place.
    pub(crate) fn goal_m(&self) -> f64 {
        if self.drift.back_m.is_some() { 0.0 } else { self.drift.left_m }
    }

    /// From here on the way leads back, along so many metres at the most if that can be.
    pub(super) fn back(self, rolled_m: f64, speed_mps: f64, most_m: f64) -> Self {
        let back_m = Some(rolled_m);
        // Who turns round on the way there takes as long back.
        let drift = if self.drift.is_over(rolled_m) {
            let shortest_m = drift_length_m(self.drift.left_m, 0.0);
            let length_m = drift_length_m(self.drift.left_m, speed_mps).min(most_m).max(shortest_m);
            Drift { begin_m: rolled_m - length_m, length_m, back_m, ..self.drift }
        } else {
            Drift { back_m, ..self.drift }
        };
        Self { drift, ..self }
    }

    pub(super) fn is_over(&self, rolled_m: f64) -> bool {
        self.drift.back_m.is_some() && self.drift.is_over(rolled_m)
    }
}

/// The speed at which a rider comes to somebody so far ahead, to pass, m/s.
pub(crate) fn pace_past(speed_mps: f64, gap_m: f64) -> f64 {
    let pace_mps = speed_mps + FASTER_MPS;
    (pace_mps * pace_mps + 2.0 * EASES_MPS2 * gap_m.max(0.0)).sqrt()
}

/// Ways past a queue need as much of the road, metres: `aside_m` across at a speed. Sideways nobody accelerates by more than
/// 1.5 m/s², which is 5.77 times the way across by the square of the time it takes.
pub(super) fn drift_length_m(aside_m: f64, speed_mps: f64) -> f64 {
    let aside_m = aside_m.abs();
    (4.5 * aside_m).max(speed_mps * (3.85 * aside_m).sqrt()).max(4.0)
}
