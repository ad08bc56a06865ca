//! A breakdown: a vehicle rolls out to a stand in its lane, hazard lights on, and stays there.

use super::moment::{Candidate, Moment};
use super::order::{Braking, Order};
use super::standing::{place, stop_m};

/// Braking of who rolls out, m/s².
const BRAKING_MPS2: f64 = 1.8;
/// Speeds at which a breakdown is noticed, m/s.
const SPEED_MPS: [f64; 2] = [3.0, 16.0];
/// Below this speed hazard lights are on, m/s.
const HAZARDS_MPS: f64 = 3.0;

/// Those who would stand alone, on a lane that is no junction.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let who = |(i, vehicle): (usize, &crate::vehicle::Vehicle)| {
        let rolls = (SPEED_MPS[0]..SPEED_MPS[1]).contains(&vehicle.speed) && !vehicle.class.two_wheeled();
        let ahead_m = stop_m(vehicle, BRAKING_MPS2);
        let fits = rolls && place(moment, i, ahead_m).is_some();
        let braking = Some(Braking { mps2: BRAKING_MPS2, until_s: f64::INFINITY });
        let order = Order { braking, hazards_below_mps: HAZARDS_MPS, ..Order::default() };
        fits.then(|| Candidate { roles: vec![(i, order)], walk: None, junction: None, ahead_m })
    };
    moment.watched().filter_map(who).collect()
}
