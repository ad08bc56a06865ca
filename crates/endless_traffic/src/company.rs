//! People who walk together: side by side in groups of two to four, as Moussaïd, Perozo, Garnier, Helbing and Theraulaz (2010,
//! "The walking behaviour of pedestrian social groups and its impact on crowd dynamics", PLoS ONE 5) found most people in
//! streets do. Who gets ahead waits for the others; now and then they stand at the sidewalk's edge and talk.

use crate::people_grid::Passer;
use endless_road::WalkEdgeId;
use endless_world::Stream;
use std::ops::Range;

/// Distance between neighbours, metres.
pub(crate) const ABREAST_M: f64 = 0.75;
/// Whoever is further away than this has lost the others, metres.
const LOST_M: f64 = 30.0;
/// Likelihood that they stand and talk on the way to a place, and for how long, seconds.
const TALKS: f64 = 0.3;
const TALK_S: [f64; 2] = [10.0, 45.0];

/// What somebody knows of those with whom they walk.
#[derive(Debug, Clone)]
pub(crate) struct Company {
    /// Numbers of all, this one's included.
    pub(crate) members: Range<usize>,
    /// Their place in line: 0 in the middle, left of it positive.
    pub(crate) slot: f64,
    /// Where they go: alike of all.
    pub(crate) goals: Stream,
    pub(crate) talk: Option<Talk>,
    /// For how long this one has waited for those behind, seconds.
    pub(crate) waited_s: f64,
}

/// A talk to come, or under way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Talk {
    /// The sidewalk on which they stop.
    pub(crate) edge: WalkEdgeId,
    pub(crate) left_s: f64,
    /// For how long they have waited for the others, seconds.
    pub(crate) assembly_s: f64,
}

impl Company {
    /// What is drawn of where they go is the same for all.
    pub(crate) fn goals(&mut self) -> &mut Stream {
        &mut self.goals
    }

    /// Whether they talk on this sidewalk, which is the last of a way.
    pub(crate) fn plan_talk(&mut self, edge: WalkEdgeId) {
        let talks = self.goals.chance(TALKS);
        let left_s = self.goals.range_f64(TALK_S[0], TALK_S[1]);
        self.talk = talks.then_some(Talk { edge, left_s, assembly_s: 0.0 });
    }

    /// The others, as this one sees them; none where one is lost.
    pub(crate) fn others(&self, people: &[Passer], me: usize) -> Vec<Passer> {
        let others = self.members.clone().filter(|other| *other != me).map(|other| people[other]);
        let near = |other: &Passer| other.at.distance_squared(people[me].at) < LOST_M * LOST_M;
        others.filter(near).collect()
    }

    /// Place across a strip, metres to the left of its middle, of somebody whose group keeps to a place.
    pub(crate) fn beside(&self, middle: f64, half_width: f64) -> f64 {
        let line = 0.5 * ABREAST_M * (self.members.len() as f64 - 1.0);
        let room = half_width - line;
        // Where nobody could pass them, they go one behind another.
        if room < 0.5 * ABREAST_M { middle } else { middle.clamp(-room, room) + self.slot * ABREAST_M }
    }
}
