//! Rules of the road: lights, stop signs, speed limits.

use super::check::AuditCheck;
use super::finding::{Incidents, Worst};
use super::report::AuditLine;
use super::sight::{Glance, Sight, entry};
use crate::driver::MOST_LIMIT_FACTOR;
use endless_road::{CrossingId, LaneId, RoadNetwork, TrafficControl};
use endless_world::{SignalAspect, VehicleSpec};

/// A light that has been red for longer is run, seconds.
const RED_S: f64 = 1.0;
/// The same for those who had waited at the line for their turn: they clear the junction when the light changes.
const CLEARS_S: f64 = 4.0;
/// Who has stood for longer has waited, seconds.
const WAITED_S: f64 = 1.5;
/// Who stops does so this near before the line, metres: some keep room for those who turn.
const AT_THE_LINE_M: f64 = 12.0;
/// Slower than this a vehicle has stopped, m/s.
const STOPPED_MPS: f64 = 0.3;

/// Watches rules.
#[derive(Debug)]
pub(super) struct Rules {
    /// For how long each signal group has been red, seconds.
    red_s: Vec<f64>,
    /// Whether each was green in the frame before.
    was_green: Vec<bool>,
    /// Vehicles before lines, by id.
    approaches: Vec<Option<Approach>>,
    /// People on crossings, by id.
    crossings: Vec<Option<u16>>,
    red_lights: Incidents,
    people_at_red: Incidents,
    stop_signs: Incidents,
    speeding: Worst,
    /// Factor on the speeds that drivers take.
    pace: f64,
}

/// A vehicle before the end of a lane.
#[derive(Debug, Clone, Copy)]
struct Approach {
    lane: LaneId,
    /// Whether its front is beyond the lane's end.
    passed: bool,
    /// Time for which it has stood near the line, seconds.
    stood_s: f64,
    /// Whether it was seen all the way along the lane.
    seen: bool,
}

impl Rules {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        Self {
            red_s: vec![0.0; usize::from(network.signal_groups)],
            was_green: vec![false; usize::from(network.signal_groups)],
            approaches: Vec::new(),
            crossings: Vec::new(),
            red_lights: Incidents::default(),
            people_at_red: Incidents::default(),
            stop_signs: Incidents::default(),
            speeding: Worst::default(),
            pace: 1.0,
        }
    }

    /// Of drivers who take so many times the usual speeds.
    pub(super) fn with_pace(self, pace: f64) -> Self {
        Self { pace, ..self }
    }

    pub(super) fn look(&mut self, sight: &Sight<'_>) {
        for (red_s, signal) in self.red_s.iter_mut().zip(&sight.state.signals) {
            *red_s = if signal.aspect == SignalAspect::Red { *red_s + sight.frame_s } else { 0.0 };
        }
        for gone in &sight.vanished {
            *entry(&mut self.approaches, usize::from(gone.id.0)) = None;
            *entry(&mut self.crossings, usize::from(gone.id.0)) = None;
        }
        for glance in &sight.glances {
            match glance.driven {
                Some((motion, spec)) => self.driving(sight, glance, f64::from(motion.speed_mps), spec),
                None => self.walking(sight, glance),
            }
        }
        let green = sight.state.signals.iter().map(|signal| signal.aspect == SignalAspect::Green);
        self.was_green.clear();
        self.was_green.extend(green);
    }

    fn driving(&mut self, sight: &Sight<'_>, glance: &Glance<'_>, speed_mps: f64, spec: &VehicleSpec) {
        let Some((lane, s)) = glance.lane(sight.network) else { return };
        let most_mps = lane.speed_limit_mps * MOST_LIMIT_FACTOR * self.pace;
        self.speeding.note(speed_mps - most_mps, || format!("{}, {speed_mps:.1} m/s", glance.told(sight)));
        let to_line_m = lane.centerline.length() - s - 0.5 * f64::from(spec.length_m);
        let before = *entry(&mut self.approaches, glance.place());
        let same = before.filter(|before| before.lane == lane.id);
        let stands = speed_mps < STOPPED_MPS && to_line_m < AT_THE_LINE_M;
        let stood_s = same.map_or(0.0, |before| before.stood_s) + if stands { sight.frame_s } else { 0.0 };
        let seen = same.map_or(before.is_some(), |before| before.seen);
        let now = Approach { lane: lane.id, passed: to_line_m <= 0.0, stood_s, seen };
        *entry(&mut self.approaches, glance.place()) = Some(now);
        // Its front comes over the line while its middle is before it, or both in one frame.
        let over = match (before, same) {
            (_, Some(same)) => (now.passed && !same.passed).then_some(now),
            (Some(before), None) if !before.passed => {
                let follows = sight.network.lane(before.lane).successors.contains(&lane.id);
                follows.then_some(before)
            }
            _ => None,
        };
        if let Some(approach) = over {
            self.passes(sight, glance, &approach);
        }
    }

    /// A vehicle comes over a line.
    fn passes(&mut self, sight: &Sight<'_>, glance: &Glance<'_>, approach: &Approach) {
        match sight.network.lane(approach.lane).end_control {
            TrafficControl::Signal(signal) => {
                let red_s = self.red_s[usize::from(signal.0)];
                let most_s = if approach.stood_s > WAITED_S { CLEARS_S } else { RED_S };
                if red_s > most_s {
                    self.red_lights.add(|| format!("{}, red for {red_s:.1} s", glance.told(sight)));
                }
            }
            TrafficControl::Stop if approach.seen && approach.stood_s <= 0.0 => {
                self.stop_signs.add(|| glance.told(sight));
            }
            _ => {}
        }
    }

    fn walking(&mut self, sight: &Sight<'_>, glance: &Glance<'_>) {
        let now = glance.actor.behaviour.crossing;
        let before = std::mem::replace(entry(&mut self.crossings, glance.place()), now);
        // Of those who are seen for the first time nobody knows when they set out.
        let (Some(crossing), true) = (now.filter(|_| now != before), glance.before.is_some()) else { return };
        let signal = sight.network.crossings[CrossingId(crossing).index()].signal;
        // They set out by what they saw before they moved.
        let green = |signal: usize| sight.state.signals[signal].aspect == SignalAspect::Green || self.was_green[signal];
        if signal.is_some_and(|signal| !green(usize::from(signal.0))) {
            self.people_at_red.add(|| glance.told(sight));
        }
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![
            self.red_lights.line(AuditCheck::RedLights),
            self.people_at_red.line(AuditCheck::PeopleAtRed),
            self.stop_signs.line(AuditCheck::StopSigns),
            self.speeding.line(AuditCheck::Speeding),
        ]
    }
}
