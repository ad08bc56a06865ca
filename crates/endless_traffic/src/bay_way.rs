//! How a vehicle gets into a parking bay and out of it.

use crate::incident::Drift;

/// How a vehicle gets into a bay and out of it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BayWay {
    /// Of the place, in the list of all.
    pub(crate) place: usize,
    /// Metres along which it moves across.
    pub(crate) in_m: f64,
    pub(crate) out_m: f64,
    /// From there straight on to the place, metres.
    pub(crate) straight_m: f64,
}

impl BayWay {
    /// Before the place by so much the vehicle begins to move across, metres.
    pub(crate) fn begins_m(&self) -> f64 {
        self.in_m + self.straight_m
    }

    /// The way in, for who has rolled so far.
    pub(crate) fn inwards(rolled_m: f64, length_m: f64, left_m: f64) -> Drift {
        Drift { begin_m: rolled_m, length_m, left_m, back_m: None }
    }

    /// The way out.
    pub(crate) fn outwards(&self, rolled_m: f64, left_m: f64) -> Drift {
        out(rolled_m, self.out_m, left_m)
    }
}

/// A move back to the usual place in the lane, from so far to the left, metres.
pub(crate) fn out(rolled_m: f64, length_m: f64, left_m: f64) -> Drift {
    Drift { begin_m: rolled_m - length_m, length_m, left_m, back_m: Some(rolled_m) }
}
