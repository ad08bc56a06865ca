//! How people who walk together wait for one another, and stand and talk.

use crate::company::ABREAST_M;
use crate::people_grid::Passer;
use crate::walk_strip::DirectedEdge;
use crate::walker::Walker;
use endless_road::WalkKind;
use endless_world::Gait;
use glam::DVec2;
use std::cmp::Ordering;

/// How much faster those behind go, and how much slower those ahead, for each metre.
const CATCH_UP: f64 = 0.25;
const WAIT: f64 = 0.5;
/// Slowest of who waits, as a share of their pace.
const SLOWEST: f64 = 0.1;
/// Nobody waits longer for those behind, seconds.
const PATIENCE_S: f64 = 25.0;
/// Nobody waits longer for the others to come to where they talk, seconds.
const ASSEMBLY_S: f64 = 10.0;
/// Sidewalks on which they talk leave room beside them: half their usable width, metres.
const ROOMY_M: f64 = 0.6;

impl Walker {
    /// Factor on the pace of who walks with these others.
    pub(crate) fn keeps_together(&mut self, strip: &DirectedEdge, others: &[Passer], step_s: f64) -> f64 {
        if others.is_empty() {
            return 1.0;
        }
        let ahead = |other: &Passer| match other.passed.cmp(&self.passed) {
            Ordering::Equal => (other.at - self.position).dot(strip.along),
            Ordering::Greater => other.at.distance(self.position),
            Ordering::Less => -other.at.distance(self.position),
        };
        let mean = others.iter().map(ahead).sum::<f64>() / others.len() as f64;
        if mean >= 0.0 {
            return 1.0 + CATCH_UP * mean.min(1.0);
        }
        let pace = (1.0 + WAIT * (mean + 0.2).min(0.0)).max(SLOWEST);
        // Whoever does not come in time has lost them.
        if let Some(company) = self.company.as_deref_mut() {
            company.waited_s = if pace < 0.5 { company.waited_s + step_s } else { 0.0 };
            if company.waited_s > PATIENCE_S {
                self.company = None;
            }
        }
        if strip.kind == WalkKind::Sidewalk { pace } else { 1.0 }
    }

    /// Where to stand and talk, at the right edge of the last sidewalk of their way; while they do.
    pub(crate) fn talks_at(&mut self, strip: &DirectedEdge, step_s: f64) -> Option<DVec2> {
        let (edge, along) = (self.way[0].0, strip.local(self.position).0);
        let stands = self.velocity.length() < 0.1;
        let company = self.company.as_deref_mut()?;
        let line = ABREAST_M * company.members.len() as f64;
        let talk = company.talk.as_mut()?;
        let place = 0.5 * strip.length + company.slot * ABREAST_M;
        let roomy = edge == talk.edge
            && strip.kind == WalkKind::Sidewalk
            && strip.half_width > ROOMY_M
            && strip.length > 2.0 * line + 4.0
            && along < place + 1.0;
        let spent = if stands { &mut talk.left_s } else { &mut talk.assembly_s };
        if stands {
            *spent -= step_s;
        } else if place - along < 2.0 {
            *spent += step_s;
        }
        if !roomy || talk.left_s <= 0.0 || talk.assembly_s > ASSEMBLY_S {
            company.talk = None;
            return None;
        }
        (place - along < 2.0).then(|| strip.point(place, -strip.half_width))
    }

    /// Turned to the others while they stand and talk.
    pub(crate) fn talks_to(&self, others: &[Passer]) -> Option<DVec2> {
        let middle = others.iter().map(|other| other.at).sum::<DVec2>() / others.len().max(1) as f64;
        (!others.is_empty()).then(|| (middle - self.position).normalize_or_zero())
    }

    /// Their gait while they talk, if it is that of somebody who stands about.
    pub(crate) fn talk(&mut self) {
        if matches!(self.gait, Gait::Idle | Gait::Wait) {
            self.gait = Gait::Talk;
        }
    }
}
