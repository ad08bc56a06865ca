//! Open borders: where traffic comes onto a map, and where it leaves it.
//!
//! An extract of a city cuts roads. Where a whole carriageway begins, vehicles come in; where one ends, they go. A lane that
//! begins or ends beside others is none of these: drivers change lanes there.

use crate::{Lane, LaneId, RoadNetwork};
use endless_world::math::f64::{cos, wrap_angle};
use glam::DVec3;
use std::collections::BTreeSet;

/// Lanes of the same direction this near beside an end, centre to centre, are of its carriageway, metres.
const BESIDE_M: f64 = 5.5;
/// Lanes this far above or below are on another level, metres.
const OTHER_LEVEL_M: f64 = 2.5;
/// Lanes beside an end that reach this far beyond it go on, metres.
const BEYOND_M: f64 = 8.0;

/// The lanes at which a network is open.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Borders {
    /// Lanes at whose beginning vehicles come onto the map, ascending.
    pub entries: Vec<LaneId>,
    /// Lanes at whose end they leave it, ascending.
    pub exits: Vec<LaneId>,
}

impl Borders {
    /// Whether vehicles can leave and others come.
    pub fn are_open(&self) -> bool {
        !self.entries.is_empty() && !self.exits.is_empty()
    }
}

/// One end of a lane.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    First,
    Last,
}

impl RoadNetwork {
    /// Where whole carriageways begin and end.
    pub fn borders(&self) -> Borders {
        let boxes: Vec<[DVec3; 2]> = self.lanes.iter().map(bounding_box).collect();
        let at = |end| -> Vec<LaneId> {
            let open =
                |lane: &&Lane| lane.junction.is_none() && next(lane, end).is_empty() && self.alone(lane, end, &boxes);
            self.lanes.iter().filter(open).map(|lane| lane.id).collect()
        };
        Borders { entries: at(End::First), exits: at(End::Last) }
    }

    /// The lanes from which one can drive on for ever or leave the map: with closed borders
    /// [those among which vehicles circulate](Self::circulating_lanes), with open ones also all from which an exit or those can
    /// be reached. Each that is no exit has a successor among them.
    pub fn lanes_in_use(&self, borders: &Borders) -> Vec<bool> {
        let mut used = self.circulating_lanes();
        if !borders.are_open() {
            return used;
        }
        for &exit in &borders.exits {
            used[exit.index()] = true;
        }
        let mut open: Vec<LaneId> = self.lanes.iter().map(|lane| lane.id).filter(|id| used[id.index()]).collect();
        while let Some(lane) = open.pop() {
            for &before in &self.lane(lane).predecessors {
                if !std::mem::replace(&mut used[before.index()], true) {
                    open.push(before);
                }
            }
        }
        used
    }

    /// Whether no lane of the same direction goes on beside this end of a lane.
    fn alone(&self, lane: &Lane, end: End, boxes: &[[DVec3; 2]]) -> bool {
        let on = lane.centerline.at(if end == End::First { 0.0 } else { lane.centerline.length() });
        let reach = DVec3::new(BESIDE_M, BESIDE_M, OTHER_LEVEL_M);
        let near =
            |[low, high]: &[DVec3; 2]| on.position.cmpge(*low - reach).all() && on.position.cmple(*high + reach).all();
        let others = self.lanes.iter().zip(boxes).filter(|(other, bounds)| other.id != lane.id && near(bounds));
        !others.map(|(other, _)| other).any(|other| {
            let (s, t) = other.centerline.project(on.position.truncate());
            let there = other.centerline.at(s);
            let along = (on.position - there.position).truncate().dot(other.centerline.direction(s));
            let beside = t.abs() < BESIDE_M
                && along.abs() < BEYOND_M
                && (there.position.z - on.position.z).abs() < OTHER_LEVEL_M
                && cos(wrap_angle(there.heading_rad - on.heading_rad)) > 0.7;
            let left = if end == End::First { s + along } else { other.centerline.length() - s - along };
            beside && self.reaches(other, end, left)
        })
    }

    /// Whether this lane, or one that it leads to, reaches `BEYOND_M` beyond a place to which `left` metres are left.
    fn reaches(&self, lane: &Lane, end: End, left: f64) -> bool {
        let mut seen = BTreeSet::from([lane.id]);
        let mut open = vec![(lane, left)];
        while let Some((lane, left)) = open.pop() {
            if left > BEYOND_M {
                return true;
            }
            let then = next(lane, end).iter().filter(|&&id| seen.insert(id)).map(|&id| self.lane(id));
            open.extend(then.map(|then| (then, left + then.centerline.length())));
        }
        false
    }
}

fn next(lane: &Lane, end: End) -> &[LaneId] {
    if end == End::First { &lane.predecessors } else { &lane.successors }
}

fn bounding_box(lane: &Lane) -> [DVec3; 2] {
    let points = lane.centerline.points().iter();
    let around = |low: DVec3, high: DVec3, p: &DVec3| (low.min(*p), high.max(*p));
    let (low, high) = points.fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), p| around(low, high, p));
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Polyline;

    fn lane(id: u32, [from, to]: [f64; 2], y: f64, successors: &[u32]) -> Lane {
        let line = Polyline::new([DVec3::new(from, y, 0.0), DVec3::new(to, y, 0.0)]);
        Lane { successors: successors.iter().copied().map(LaneId).collect(), ..Lane::new(LaneId(id), line, 3.5, 13.9) }
    }

    fn network(lanes: Vec<Lane>) -> RoadNetwork {
        RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a network")
    }

    #[test]
    fn a_street_without_ends_is_open_at_both() {
        let network = network(vec![lane(0, [0.0, 50.0], 0.0, &[1]), lane(1, [50.0, 100.0], 0.0, &[])]);
        let borders = network.borders();
        assert_eq!(borders, Borders { entries: vec![LaneId(0)], exits: vec![LaneId(1)] });
        assert!(borders.are_open());
        assert_eq!(network.lanes_in_use(&borders), [true, true]);
        assert_eq!(network.circulating_lanes(), [false, false]);
    }

    #[test]
    fn a_lane_that_ends_or_begins_beside_another_is_no_border() {
        // A third lane from 20 m to 70 m, without links, beside two lanes that go on.
        let lanes = vec![
            lane(0, [0.0, 50.0], 0.0, &[1]),
            lane(1, [50.0, 100.0], 0.0, &[]),
            lane(2, [20.0, 70.0], -3.5, &[]),
            // The way back, beside both ends.
            lane(3, [100.0, 0.0], 3.5, &[]),
        ];
        let network = network(lanes);
        let borders = network.borders();
        assert_eq!(borders.entries, [LaneId(0), LaneId(3)]);
        assert_eq!(borders.exits, [LaneId(1), LaneId(3)]);
        assert_eq!(network.lanes_in_use(&borders), [true, true, false, true]);
    }

    #[test]
    fn who_cannot_leave_and_cannot_go_round_does_not_enter() {
        // Lane 1 leaves the map; lane 2 ends before lane 3 begins in the middle of the same carriageway.
        let lanes =
            vec![lane(0, [0.0, 50.0], 0.0, &[1]), lane(1, [50.0, 100.0], 0.0, &[]), lane(2, [0.0, 30.0], 3.5, &[])];
        let network = network(lanes);
        let borders = network.borders();
        assert_eq!(borders.exits, [LaneId(1)]);
        assert_eq!(network.lanes_in_use(&borders), [true, true, false]);
    }

    #[test]
    fn lanes_of_a_few_metres_at_the_edge_are_borders_of_a_carriageway() {
        // Two lanes, each with a short one before the edge of the map.
        let lanes = vec![
            lane(0, [0.0, 50.0], 0.0, &[1]),
            lane(1, [50.0, 53.0], 0.0, &[]),
            lane(2, [0.0, 50.0], -3.5, &[3]),
            lane(3, [50.0, 53.0], -3.5, &[]),
        ];
        assert_eq!(network(lanes).borders().exits, [LaneId(1), LaneId(3)]);
    }
}
