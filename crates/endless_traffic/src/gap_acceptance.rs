//! People who cross a road away from its crossings when a gap in traffic lets them.

use crate::crossing::{CrossingPedestrian, step_is_unsafe};
use crate::jaywalk::{Approach, BEFORE_KERB_M, Jaywalk, Roadway, Stage};
use crate::roads::Roads;
use crate::walk_strip::DirectedEdge;
use crate::walker::Walker;
use endless_road::WalkEdgeId;
use glam::DVec2;

/// Time that people want beyond that to cross a lane, seconds: the critical gap of a pedestrian is the crossing's length over
/// the walking speed and 3 s to start and to be clear (Highway Capacity Manual 2010, equation 19-69). Here it is asked of each
/// lane, up to its far side.
const START_AND_CLEAR_S: f64 = 3.0;
/// Who has waited for so long goes on along the sidewalk, seconds.
const PATIENCE_S: f64 = 25.0;
/// Who is this near to the place has come to it, metres.
const THERE_M: f64 = 0.45;
/// Faster than at their usual pace.
const HURRY: f64 = 1.15;
/// Likelihood of crossing at a sidewalk without need.
const WHIM: f64 = 0.5;

impl Walker {
    /// Whether they stand at a kerb away from crossings.
    pub(crate) fn waits_for_gap(&self) -> bool {
        self.jaywalk.as_deref().is_some_and(|jaywalk| jaywalk.stage == Stage::Waiting)
    }

    /// Whether they are on a road away from its crossings.
    pub(crate) fn on_roadway(&self) -> bool {
        self.jaywalk.as_deref().is_some_and(|jaywalk| jaywalk.stage == Stage::Crossing)
    }

    /// Height of the road underfoot, where they cross it.
    pub(crate) fn height_on_roadway(&self) -> Option<f64> {
        let jaywalk = self.jaywalk.as_deref().filter(|_| self.on_roadway())?;
        Some(jaywalk.way.height(jaywalk.along(self.position)))
    }

    /// Where they stand before they cross, once they are near.
    pub(crate) fn kerb_ahead(&self, strip: &DirectedEdge, near_m: f64) -> Option<DVec2> {
        let jaywalk = self.jaywalk.as_deref().filter(|jaywalk| jaywalk.stage != Stage::Crossing)?;
        let kerb = jaywalk.kerb();
        (jaywalk.stage == Stage::Waiting || strip.local(kerb).0 - strip.local(self.position).0 < near_m).then_some(kerb)
    }

    /// Having come onto a sidewalk, they may want to cross the road beside it: if their way leads to the other side, or on a
    /// whim.
    pub(crate) fn want_to_cross(&mut self, roads: &Roads) {
        const AHEAD_M: f64 = 3.0;
        let (edge, to) = self.way[0];
        if !self.jaywalks || self.jaywalk.is_some() || roads.midblock.from(edge).is_empty() {
            return;
        }
        let nodes = roads.network.walk.edges[edge.index()].nodes;
        let strip = DirectedEdge::new(roads, self.from, edge, to);
        let along = strip.local(self.position).0 + AHEAD_M;
        let range = if to == nodes[1] { [along, strip.length] } else { [0.0, strip.length - along] };
        let planned: Vec<WalkEdgeId> = self.way.iter().skip(1).map(|(edge, _)| *edge).collect();
        let short = roads.midblock.draw(edge, range, |onto| planned.contains(&onto), &mut self.stream);
        let way = match short {
            None if self.stream.chance(WHIM) => roads.midblock.draw(edge, range, |_| true, &mut self.stream),
            short => short,
        };
        self.jaywalk = way.map(|way| Box::new(Jaywalk { way, stage: Stage::Coming, waited_s: 0.0 }));
    }

    /// Goes on with a crossing that they are about to make or make. Whether there is one.
    pub(crate) fn cross_roadway(&mut self, roads: &Roads, roadway: &Roadway, number: usize, step_s: f64) -> bool {
        let Some(mut jaywalk) = self.jaywalk.take() else { return false };
        let approaches = roadway.of(number);
        match jaywalk.stage {
            Stage::Coming => {
                // Somebody else may stand there.
                jaywalk.waited_s += if self.velocity.length() < 0.2 { step_s } else { 0.0 };
                if jaywalk.kerb().distance(self.position) < THERE_M {
                    (jaywalk.stage, jaywalk.waited_s) = (Stage::Waiting, 0.0);
                } else if jaywalk.waited_s > PATIENCE_S {
                    return false;
                }
            }
            Stage::Waiting => {
                jaywalk.waited_s += step_s;
                let pace = HURRY * self.pace;
                let crosses_in = |along_m: f64| {
                    let half =
                        jaywalk.way.cuts.iter().find(|cut| cut.along_m == along_m).map_or(0.0, |c| c.half_width_m);
                    (along_m + half - jaywalk.way.kerbs_m[0] + BEFORE_KERB_M) / pace
                };
                let lets = |a: &Approach| !a.late && a.arrives_s > crosses_in(a.along_m) + START_AND_CLEAR_S;
                // What comes is looked at from the step on in which they have come to the kerb.
                if jaywalk.waited_s > 2.0 * step_s && approaches.iter().all(lets) {
                    jaywalk.stage = Stage::Crossing;
                } else if jaywalk.waited_s > PATIENCE_S {
                    return false;
                }
            }
            Stage::Crossing => {
                let along = jaywalk.along(self.position);
                let over = along > jaywalk.way.kerbs_m[1] + BEFORE_KERB_M;
                if over {
                    self.arrive(roads, jaywalk.way.onto, jaywalk.across());
                    return false;
                }
            }
        }
        self.jaywalk = Some(jaywalk);
        true
    }

    /// Their pace on the roadway, m/s: they stop before a lane in which something comes that cannot stop.
    pub(crate) fn pace_on_roadway(&self, roadway: &Roadway, number: usize) -> Option<f64> {
        let jaywalk = self.jaywalk.as_deref().filter(|_| self.on_roadway())?;
        let along_m = jaywalk.along(self.position);
        let person = CrossingPedestrian { along_m, direction: 1.0, speed: self.velocity.length() };
        let late = roadway.of(number).iter().filter(|approach| approach.late);
        let halts =
            late.map(|approach| (approach.along_m, approach.beside_m)).any(|taken| step_is_unsafe(taken, person));
        Some(if halts { 0.0 } else { HURRY * self.pace })
    }

    /// Goes on along the sidewalk on the other side: on the way that was planned, if it leads there.
    fn arrive(&mut self, roads: &Roads, onto: WalkEdgeId, heading: DVec2) {
        let nodes = roads.network.walk.edges[onto.index()].nodes;
        if let Some(place) = self.way.iter().position(|(edge, _)| *edge == onto) {
            self.way.drain(..place);
        } else {
            // As they walked before, as far as that goes on here.
            let walk = &roads.network.walk;
            let before = DirectedEdge::new(roads, self.from, self.way[0].0, self.way[0].1).along;
            let [a, b] = nodes.map(|node| walk.nodes[node.index()].truncate());
            let to = if (b - a).dot(before + 0.1 * heading) > 0.0 { nodes[1] } else { nodes[0] };
            self.way = [(onto, to)].into();
        }
        self.around_corner = false;
        self.from = if self.way[0].1 == nodes[0] { nodes[1] } else { nodes[0] };
    }
}
