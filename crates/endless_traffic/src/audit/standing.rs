//! Who does not get on. Those whom a signal holds do not count meanwhile, nor do those who sit on a bench or are parked.

use super::bench::Benches;
use super::check::AuditCheck;
use super::finding::Worst;
use super::parking::is_parked;
use super::report::AuditLine;
use super::sight::{Glance, Sight, entry};
use endless_road::{Lane, TrafficControl};
use endless_world::SignalAspect;
use glam::DVec2;

/// Who stays within this of a place stands there, metres: vehicles, people.
const CREEPS_M: f64 = 0.5;
const SHUFFLES_M: f64 = 1.0;
/// Signals hold those who stand in a queue of this length before them, metres.
const QUEUE_M: f64 = 150.0;
/// People wait for the signal of a crossing that begins within this, metres.
const KERB_M: f64 = 6.0;

/// Measures for how long road users stand.
#[derive(Debug, Default)]
pub(super) struct Standing {
    /// By id.
    stands: Vec<Option<Stand>>,
    vehicle: Worst,
    person: Worst,
}

#[derive(Debug, Clone, Copy)]
struct Stand {
    at: DVec2,
    /// Seconds in which no signal held them.
    free_s: f64,
}

impl Standing {
    pub(super) fn look(&mut self, sight: &Sight<'_>, benches: &Benches) {
        for gone in &sight.vanished {
            *entry(&mut self.stands, usize::from(gone.id.0)) = None;
        }
        for glance in &sight.glances {
            let reach = if glance.driven.is_some() { CREEPS_M } else { SHUFFLES_M };
            let here = Stand { at: glance.at, free_s: 0.0 };
            let stand = entry(&mut self.stands, glance.place()).get_or_insert(here);
            if stand.at.distance(glance.at) > reach || is_parked(glance) {
                *stand = here;
                continue;
            }
            // Most go on: who held them is asked of those alone who have stood for a moment.
            let sits = glance.driven.is_none() && benches.is_on_seat(glance);
            let held = sits || stand.free_s > 1.0 && (held_in_queue(sight, glance) || held_at_kerb(sight, glance));
            if !held {
                stand.free_s += sight.frame_s;
            }
            let worst = if glance.driven.is_some() { &mut self.vehicle } else { &mut self.person };
            worst.note(stand.free_s, || glance.told(sight));
        }
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![self.vehicle.line(AuditCheck::VehicleStands), self.person.line(AuditCheck::PersonStands)]
    }
}

/// Whether the next signal on the way of a vehicle stops it, or those before it.
fn held_in_queue(sight: &Sight<'_>, glance: &Glance<'_>) -> bool {
    let Some((mut lane, s)) = glance.lane(sight.network) else { return false };
    let mut ahead_m = -s;
    loop {
        ahead_m += lane.centerline.length();
        if ahead_m > QUEUE_M {
            return false;
        }
        if let Some(aspect) = end_aspect(sight, lane) {
            return aspect != SignalAspect::Green;
        }
        // Beyond a fork nobody can say.
        let [next] = lane.successors[..] else { return false };
        lane = sight.network.lane(next);
    }
}

fn end_aspect(sight: &Sight<'_>, lane: &Lane) -> Option<SignalAspect> {
    let TrafficControl::Signal(signal) = lane.end_control else { return None };
    Some(sight.state.signals[usize::from(signal.0)].aspect)
}

/// Whether the signal of the crossing at which somebody waits is not green.
fn held_at_kerb(sight: &Sight<'_>, glance: &Glance<'_>) -> bool {
    if glance.driven.is_some() || !glance.actor.behaviour.waiting {
        return false;
    }
    let near = |crossing: &&endless_road::Crossing| {
        crossing.ends.iter().any(|end| end.truncate().distance(glance.at) < KERB_M)
    };
    let signals = sight.network.crossings.iter().filter(near).filter_map(|crossing| crossing.signal);
    signals.into_iter().any(|signal| sight.state.signals[usize::from(signal.0)].aspect != SignalAspect::Green)
}
