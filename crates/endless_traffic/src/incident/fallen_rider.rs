//! A fall: somebody on a two-wheeler comes off, slides, and lies on the road.

use super::moment::{Candidate, Moment};
use super::order::{Braking, Fall, Order};
use crate::vehicle::Vehicle;

/// Speeds of those who fall, m/s.
const SPEED_MPS: [f64; 2] = [2.5, 16.0];
/// Friction of a two-wheeler that slides on its side takes so much of the speed, m/s² (0.35 to 0.5 g: Lambourn 1991).
const SLIDES_MPS2: f64 = 4.2;
/// Whose roll is beyond this lies or is about to, radians.
pub(super) const FALLEN: f64 = 0.75;

/// Those who ride at some speed, to either side.
pub(super) fn candidates(moment: &Moment<'_>) -> Vec<Candidate> {
    let rides = |vehicle: &Vehicle| {
        vehicle.class.two_wheeled()
            && vehicle.order.is_none()
            && vehicle.shift.is_none()
            && (SPEED_MPS[0]..SPEED_MPS[1]).contains(&vehicle.speed)
    };
    let riders = moment.watched().filter(|(_, vehicle)| rides(vehicle));
    let both = riders.flat_map(|(i, vehicle)| {
        [-1.0, 1.0].map(|side| {
            let braking = Some(Braking { mps2: SLIDES_MPS2, until_s: f64::INFINITY });
            let order = Order { braking, fall: Some(Fall { side }), ..Order::default() };
            Candidate { roles: vec![(i, order)], walk: None, junction: None, ahead_m: 0.5 * vehicle.speed }
        })
    });
    both.collect()
}

/// From when the fall is beyond help.
pub(super) fn happens(moment: &Moment<'_>, actors: &[usize]) -> bool {
    moment.vehicles[actors[0]].roll.abs() > FALLEN
}
