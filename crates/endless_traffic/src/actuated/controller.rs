//! The controller of one junction.

use super::detector::Calls;
use super::stage::Stage;
use endless_road::SignalPhase;
use endless_world::{SignalAspect, SignalId};

/// Least and most green of vehicles, seconds: within what the Signal Timing Manual gives for minor arterials (least 4 to 10 s; most
/// 30 to 50 s). The most counts from the first call of somebody else.
pub(super) const LEAST_GREEN_S: f64 = 7.0;
pub(super) const MOST_GREEN_S: f64 = 40.0;
/// Passage time: green goes on for so long after the last vehicle has left the detector, seconds.
pub(super) const PASSAGE_S: f64 = 1.0;
/// People's green, seconds.
pub(super) const WALK_S: f64 = 7.0;

/// A part of a stage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Interval {
    Lead(usize),
    Walk,
    Clearance,
    Green,
    Tail(usize),
}

/// What a junction shows, and since when.
#[derive(Debug, Clone)]
pub(super) struct Controller {
    stages: Vec<Stage>,
    stage: usize,
    interval: Interval,
    /// Seconds in this interval, since vehicles got green, since the last of them was detected, and for which somebody else has called.
    since_s: f64,
    green_s: f64,
    idle_s: f64,
    competing_s: f64,
}

impl Controller {
    /// Begins with the first stage that has vehicles.
    pub(super) fn new(stages: Vec<Stage>) -> Self {
        let stage = stages.iter().position(|stage| stage.green.is_some()).unwrap_or(0);
        let mut controller = Self {
            stages,
            stage,
            interval: Interval::Green,
            since_s: 0.0,
            green_s: 0.0,
            idle_s: 0.0,
            competing_s: 0.0,
        };
        controller.begin(stage, false);
        controller
    }

    /// What its signals show.
    pub(super) fn shown(&self) -> &[(SignalId, SignalAspect)] {
        let stage = &self.stages[self.stage];
        let phase = match self.interval {
            Interval::Lead(number) => Some(&stage.lead[number]),
            Interval::Walk => stage.walk.as_ref(),
            Interval::Clearance => stage.clearance.as_ref(),
            Interval::Green => None,
            Interval::Tail(number) => Some(&stage.tail[number]),
        };
        phase.map_or_else(|| stage.green.as_deref().unwrap_or_default(), |phase| &phase.aspects)
    }

    pub(super) fn step(&mut self, calls: &Calls, step_s: f64) {
        let stage = &self.stages[self.stage];
        let is_called = |stage: &Stage| calls.calls(&stage.vehicles) || calls.calls(&stage.people);
        let others = self.stages.iter().enumerate().any(|(k, other)| k != self.stage && is_called(other));
        self.since_s += step_s;
        let is_green = matches!(self.interval, Interval::Walk | Interval::Clearance | Interval::Green);
        if is_green {
            self.green_s += step_s;
            self.idle_s = if calls.calls(&stage.vehicles) { 0.0 } else { self.idle_s + step_s };
            self.competing_s = if others { self.competing_s + step_s } else { 0.0 };
        }
        let over = |phase: Option<&SignalPhase>| phase.is_none_or(|phase| self.since_s >= phase.duration_s - 1e-9);
        match self.interval {
            Interval::Lead(number) if over(stage.lead.get(number)) => {
                if number + 1 < stage.lead.len() {
                    self.go_to(Interval::Lead(number + 1));
                } else {
                    self.set_off(calls.calls(&stage.people));
                }
            }
            Interval::Walk if self.since_s >= WALK_S - 1e-9 => {
                let next = if stage.clearance.is_some() { Interval::Clearance } else { self.after_people() };
                self.go_to(next);
            }
            Interval::Clearance if over(stage.clearance.as_ref()) => self.go_to(self.after_people()),
            Interval::Green => {
                let gap = self.idle_s >= PASSAGE_S;
                let goes_home = self.stage != self.home();
                let ends = if others { gap || self.competing_s >= MOST_GREEN_S } else { gap && goes_home };
                if ends && self.green_s >= LEAST_GREEN_S {
                    self.go_to(Interval::Tail(0));
                } else if !others && stage.walk.is_some() && calls.calls(&stage.people) {
                    self.go_to(Interval::Walk);
                }
            }
            Interval::Tail(number) if over(stage.tail.get(number)) => {
                if number + 1 < stage.tail.len() {
                    self.go_to(Interval::Tail(number + 1));
                } else {
                    let count = self.stages.len();
                    let in_turn = (1..=count).map(|later| (self.stage + later) % count);
                    let next = in_turn.into_iter().find(|&k| is_called(&self.stages[k])).unwrap_or(self.home());
                    self.begin(next, calls.calls(&self.stages[next].people));
                }
            }
            _ => {}
        }
    }

    /// The stage that is green when nobody calls.
    fn home(&self) -> usize {
        self.stages.iter().position(|stage| stage.green.is_some()).unwrap_or(0)
    }

    fn begin(&mut self, stage: usize, with_people: bool) {
        self.stage = stage;
        (self.green_s, self.idle_s, self.competing_s) = (0.0, 0.0, 0.0);
        if self.stages[stage].lead.is_empty() {
            self.set_off(with_people);
        } else {
            self.go_to(Interval::Lead(0));
        }
    }

    fn set_off(&mut self, with_people: bool) {
        let stage = &self.stages[self.stage];
        let walks = stage.walk.is_some() && (with_people || stage.green.is_none());
        self.go_to(if walks { Interval::Walk } else { Interval::Green });
    }

    fn after_people(&self) -> Interval {
        if self.stages[self.stage].green.is_some() { Interval::Green } else { Interval::Tail(0) }
    }

    fn go_to(&mut self, interval: Interval) {
        (self.interval, self.since_s) = (interval, 0.0);
    }
}
