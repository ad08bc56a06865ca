//! What somebody is made to do for an incident; in all else they drive as usual.

use super::sliding_body::SlidingBody;
use endless_road::{LaneId, TrafficControl};
use endless_world::SignalId;

/// An order to a driver.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Order {
    /// Seconds since it was given.
    pub(crate) age_s: f64,
    /// A signal of which the driver takes no notice.
    pub(crate) runs: Option<SignalId>,
    /// They let nobody go first at junctions.
    pub(crate) heedless: bool,
    /// Braking for nothing that is in the way.
    pub(crate) braking: Option<Braking>,
    /// Until then the driver does not see whom they follow, seconds since the order was given.
    pub(crate) sees_after_s: f64,
    /// A move to another place across the lane.
    pub(crate) drift: Option<Drift>,
    /// The lane on which the move leads where others come the other way.
    pub(crate) opposite: Option<LaneId>,
    /// A fall with a two-wheeler.
    pub(crate) fall: Option<Fall>,
    /// They may touch others who may, too.
    pub(crate) collides: bool,
    /// How they move since they have collided.
    pub(crate) crash: Option<SlidingBody>,
    /// Below this speed hazard lights are on, m/s.
    pub(crate) hazards_below_mps: f64,
}

/// A fall from when the order is given.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Fall {
    /// The roll that it leads to is of this sign.
    pub(crate) side: f64,
}

/// Braking from when the order is given.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Braking {
    pub(crate) mps2: f64,
    /// Seconds since the order was given.
    pub(crate) until_s: f64,
}

/// A move across the lane, by the way that the wheels have rolled.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Drift {
    /// Where it begins, metres rolled.
    pub(crate) begin_m: f64,
    /// Metres along the road.
    pub(crate) length_m: f64,
    /// How far to the left it leads, metres.
    pub(crate) left_m: f64,
    /// Where the way back begins, metres rolled; it is as long.
    pub(crate) back_m: Option<f64>,
}

impl Order {
    /// What is left of the acceleration that a driver wants, m/s².
    pub(crate) fn wanted(&self, wanted: f64) -> f64 {
        self.braking.filter(|braking| self.age_s < braking.until_s).map_or(wanted, |braking| wanted.min(-braking.mps2))
    }

    pub(crate) fn sees_leader(&self) -> bool {
        self.age_s >= self.sees_after_s
    }

    pub(crate) fn runs(&self, control: TrafficControl) -> bool {
        matches!((control, self.runs), (TrafficControl::Signal(signal), Some(runs)) if signal == runs)
    }

    /// Metres to the left of the usual place in the lane, and the slope to there.
    pub(crate) fn aside(&self, rolled_m: f64) -> (f64, f64) {
        self.drift.map_or((0.0, 0.0), |drift| drift.at(rolled_m))
    }
}

impl Drift {
    /// Metres to the left, and the slope, where the wheels have rolled so far.
    pub(crate) fn at(&self, rolled_m: f64) -> (f64, f64) {
        let (there, back) = (self.from(self.begin_m, rolled_m), self.back_m.map(|back_m| self.from(back_m, rolled_m)));
        back.map_or(there, |back| (there.0 - back.0, there.1 - back.1))
    }

    /// Metres to go until it is over.
    pub(crate) fn left_to_go_m(&self, rolled_m: f64) -> f64 {
        (self.back_m.unwrap_or(self.begin_m) + self.length_m - rolled_m).max(0.0)
    }

    pub(crate) fn is_over(&self, rolled_m: f64) -> bool {
        self.left_to_go_m(rolled_m) <= 0.0
    }

    /// A move that begins there.
    fn from(&self, begin_m: f64, rolled_m: f64) -> (f64, f64) {
        let u = ((rolled_m - begin_m) / self.length_m).clamp(0.0, 1.0);
        // Quintic, as lane changes.
        let rise = u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
        let slope = 30.0 * u * u * (1.0 - u) * (1.0 - u) / self.length_m;
        (self.left_m * rise, self.left_m * slope)
    }
}

/// Who has begun to fall lies after this, seconds.
const FALLS_S: f64 = 0.85;
/// How far a two-wheeler rolls until it lies on handlebar and pedal, radians.
const LIES: f64 = 1.42;

impl Fall {
    /// The roll after so many seconds, radians: slowly at first, as a pole that falls over.
    pub(crate) fn roll(&self, age_s: f64) -> f64 {
        let u = (age_s / FALLS_S).clamp(0.0, 1.0);
        self.side * LIES * u * u
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_drift_leads_from_one_place_to_the_other_and_its_slope_is_right() {
        let drift = Drift { begin_m: 100.0, length_m: 20.0, left_m: -0.7, back_m: None };
        assert_eq!((drift.at(90.0), drift.at(130.0)), ((0.0, 0.0), (-0.7, 0.0)));
        for k in 1..20 {
            let at = 100.0 + f64::from(k);
            let measured = (drift.at(at + 1e-4).0 - drift.at(at - 1e-4).0) / 2e-4;
            assert!((measured - drift.at(at).1).abs() < 1e-6, "at {at}");
        }
        let and_back = Drift { back_m: Some(140.0), ..drift };
        assert_eq!((and_back.at(130.0).0, and_back.at(165.0).0), (-0.7, 0.0));
        assert_eq!((and_back.left_to_go_m(150.0), and_back.is_over(161.0), drift.is_over(119.0)), (10.0, true, false));
    }

    #[test]
    fn orders_end() {
        let braking = Some(Braking { mps2: 6.0, until_s: 1.5 });
        let order = Order { braking, sees_after_s: 1.0, ..Order::default() };
        assert_eq!((order.wanted(1.2), order.sees_leader()), (-6.0, false));
        let later = Order { age_s: 1.5, ..order };
        assert_eq!((later.wanted(1.2), later.sees_leader()), (1.2, true));
        assert_eq!(Order::default().wanted(-7.0), -7.0);
    }
}
