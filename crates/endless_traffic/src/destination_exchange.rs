//! Who cannot get past one another exchange where they go.
//!
//! Where people stand so close that those who come the other way can neither pass nor step back, models let two of them exchange
//! their places (Blue and Adler 2001, "Cellular automata microsimulation for modeling bi-directional pedestrian walkways"). Bodies
//! that do not overlap cannot do that. But who they are does not matter to a crowd: they turn round and exchange their destinations
//! instead. A wish to get out of a jam comes to its edge like that, from one to the next, whatever room there is.

use crate::roads::Roads;
use crate::walk_strip::APART_M;
use crate::walker::Walker;
use endless_road::{WalkEdgeId, WalkGraph, WalkNodeId};
use glam::DVec2;
use std::collections::VecDeque;

/// Who has been stuck for so long exchanges, seconds: by then they have tried to step aside; and with whom.
const STUCK_S: f64 = 2.0;
const HELD_S: f64 = 1.0;
/// They stand so near, metres between their bodies.
const TOUCH_M: f64 = 0.12;
/// Cosine of the angle within which somebody is in the way of another.
const AHEAD: f64 = 0.5;
/// Cosine of the angle up to which two go the same way: they wait for one another.
const ALIKE: f64 = 0.5;

type Way = VecDeque<(WalkEdgeId, WalkNodeId)>;

/// Lets those exchange of whom one stands in the other's way, who have been stuck longest first.
pub(crate) fn step(roads: &Roads, graph: &WalkGraph, walkers: &mut [Walker]) {
    let mut held: Vec<usize> = (0..walkers.len()).filter(|&i| walkers[i].is_stuck_in_crowd(HELD_S)).collect();
    held.sort_by(|&a, &b| walkers[a].crowded_s.total_cmp(&walkers[b].crowded_s));
    while let Some(i) = held.pop().filter(|&i| walkers[i].is_stuck_in_crowd(STUCK_S)) {
        let faces = |&&j: &&usize| are_in_the_way(&walkers[i], &walkers[j]);
        let distance = |j: usize| walkers[i].position.distance_squared(walkers[j].position);
        let nearest = held.iter().filter(faces).copied().min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        if let Some(j) = nearest
            && let Some(ways) = exchanged(roads, graph, &walkers[i], &walkers[j])
        {
            held.retain(|&other| other != j);
            for (number, way) in [i, j].into_iter().zip(ways) {
                walkers[number].turn_back(roads);
                walkers[number].way.extend(way);
            }
        }
    }
}

/// Whether one of them stands in the way of the other, who wants to go elsewhere.
fn are_in_the_way(a: &Walker, b: &Walker) -> bool {
    let away = b.position - a.position;
    let distance = away.length();
    let meets = |walker: &Walker, away: DVec2| walker.intent.dot(away) > AHEAD * walker.intent.length() * distance;
    distance < APART_M + TOUCH_M
        && a.intent.dot(b.intent) < ALIKE * a.intent.length() * b.intent.length()
        && (meets(a, away) || meets(b, -away))
}

/// The ways of both, back from where they came, to where the other goes; nothing, where one of them finds none.
fn exchanged(roads: &Roads, graph: &WalkGraph, a: &Walker, b: &Walker) -> Option<[Way; 2]> {
    let way = |walker: &Walker, other: &Walker| {
        let goal = other.way.back()?.1;
        let way: Way = graph.shortest(&roads.network.walk, walker.from, goal).into();
        // Nobody turns twice.
        way.front().is_none_or(|first| first.0 != walker.way[0].0).then_some(way)
    };
    Some([way(a, b)?, way(b, a)?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Focus, TrafficMap};
    use endless_road::{RoadNetwork, WalkEdge, WalkKind, WalkNetwork};
    use endless_world::Stream;
    use endless_world::walking::PedestrianSpec;
    use glam::DVec3;

    /// Three sidewalks one after another, and two who meet on the one in the middle: their numbers of nodes are their ways.
    fn meet(intents: [DVec2; 2], stuck_s: [f64; 2]) -> [Vec<u32>; 2] {
        let edge =
            |k: u32| WalkEdge { nodes: [WalkNodeId(k), WalkNodeId(k + 1)], width_m: 0.8, kind: WalkKind::Sidewalk };
        let walk = WalkNetwork {
            nodes: (0..4).map(|k| DVec3::new(10.0 * f64::from(k), 0.0, 0.0)).collect(),
            edges: (0..3).map(edge).collect(),
        };
        let network = RoadNetwork { walk, ..RoadNetwork::default() }.finish().expect("ways alone");
        let graph = WalkGraph::new(&network.walk);
        let roads = Roads::new(&TrafficMap::new(network, &[]), &Focus::default(), &[]);
        let walker = |nodes: [u32; 2], x: f64| {
            let stream = Stream::named(1, "test.exchange", &[]);
            let at = (WalkEdgeId(1), nodes.map(WalkNodeId));
            Walker::new(&roads, &PedestrianSpec::default(), at, DVec2::new(x, 0.0), stream)
        };
        let mut walkers = [walker([1, 2], 15.0), walker([2, 1], 15.55)];
        walkers[0].way.push_back((WalkEdgeId(2), WalkNodeId(3)));
        walkers[1].way.push_back((WalkEdgeId(0), WalkNodeId(0)));
        for ((walker, intent), stuck_s) in walkers.iter_mut().zip(intents).zip(stuck_s) {
            (walker.intent, walker.crowded_s) = (intent, stuck_s);
        }
        step(&roads, &graph, &mut walkers);
        walkers.map(|walker| walker.way.iter().map(|(_, node)| node.0).collect())
    }

    #[test]
    fn two_who_cannot_pass_go_back_and_where_the_other_wanted_to() {
        assert_eq!(meet([DVec2::X, -DVec2::X], [2.5, 1.5]), [[1, 0], [2, 3]]);
    }

    #[test]
    fn who_is_not_stuck_or_goes_the_same_way_goes_on() {
        let as_they_were = [[2, 3], [1, 0]];
        assert_eq!(meet([DVec2::X, -DVec2::X], [1.5, 1.5]), as_they_were);
        assert_eq!(meet([DVec2::X, -DVec2::X], [2.5, 0.5]), as_they_were);
        assert_eq!(meet([DVec2::X, DVec2::X], [2.5, 2.5]), as_they_were);
    }
}
