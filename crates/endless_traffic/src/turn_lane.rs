//! Lanes on which one must turn soon, or goes round in a ring, unless one gets off them in time.
//!
//! Where left turns are made through the median, the innermost lanes of a road lead nowhere but through it and back, over short
//! roads on which few find room to change lanes. Those who want to go on must be off these lanes before, and when the lanes are
//! full nobody gets off them.

use endless_road::{Lane, LaneId, RoadNetwork, Turn};

/// On roads that are passed in less time few change lanes, seconds.
const CHANGE_S: f64 = 6.0;
/// Roads and junctions that are looked along at most; and those of a ring.
const MOST_PIECES: u32 = 8;
const MOST_RING_PIECES: usize = 16;

/// Whether who drives straight on from a lane comes over short roads alone to where they have to turn, and those on a lane beside go
/// straight on.
pub(crate) fn ends_in_turn(network: &RoadNetwork, lane: &Lane) -> bool {
    ends_in_turn_within(network, lane, MOST_PIECES)
}

fn ends_in_turn_within(network: &RoadNetwork, lane: &Lane, pieces: u32) -> bool {
    let is_short = lane.centerline.length() < CHANGE_S * lane.speed_limit_mps;
    if pieces == 0 || lane.junction.is_none() && !is_short {
        return false;
    }
    let goes_straight = |way: &LaneId| network.lane(*way).turn == Turn::Straight;
    let mut straight = lane.successors.iter().filter(|way| goes_straight(way)).peekable();
    if straight.peek().is_some() {
        return straight.all(|&next| ends_in_turn_within(network, network.lane(next), pieces - 1));
    }
    let mut beside = [lane.left, lane.right].into_iter().flatten();
    !lane.successors.is_empty() && beside.any(|l| network.lane(l).successors.iter().any(goes_straight))
}

/// Whether one comes back to a lane if one changes to no other: on through the only way at each junction.
pub(crate) fn leads_back(network: &RoadNetwork, lane: &Lane) -> bool {
    let only_way = |lane: &Lane| match lane.successors[..] {
        [next] => Some(next),
        _ => None,
    };
    let ways = std::iter::successors(only_way(lane), |&next| only_way(network.lane(next)));
    ways.take(MOST_RING_PIECES).any(|next| next == lane.id)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{JunctionId, Polyline};
    use glam::DVec3;

    /// Two roads of two lanes (0, 1 and 4, 5) with a junction between them (2, 3) and one at the end (6, 7), where one turns left
    /// from the left lane and goes straight on from the right one.
    fn roads(length_m: f64) -> RoadNetwork {
        let line = |x: f64, y: f64, length: f64| Polyline::new([x, x + length].map(|x| DVec3::new(x, y, 0.0)));
        let starts = [(0.0, 150.0), (150.0, 20.0), (170.0, length_m), (170.0 + length_m, 20.0)];
        let piece = |id: u32| {
            let (x, length) = starts[id as usize / 2];
            let y = if id.is_multiple_of(2) { 3.5 } else { 0.0 };
            let successors = if id < 6 { vec![LaneId(id + 2)] } else { vec![] };
            Lane { successors, ..Lane::new(LaneId(id), line(x, y, length), 3.5, 13.9) }
        };
        let mut lanes: Vec<Lane> = (0..8).map(piece).collect();
        for id in [2, 3, 6, 7] {
            lanes[id].junction = Some(JunctionId(u16::from(id > 3)));
        }
        for road in [0, 4] {
            (lanes[road].right, lanes[road + 1].left) = (Some(LaneId(road as u32 + 1)), Some(LaneId(road as u32)));
        }
        lanes[6].turn = Turn::Left;
        RoadNetwork { lanes, ..RoadNetwork::default() }
    }

    #[test]
    fn a_lane_on_which_one_must_turn_is_known_before_the_junction_before() {
        let on = |length_m: f64| {
            let network = roads(length_m);
            network.lanes.iter().map(|lane| ends_in_turn(&network, lane)).collect::<Vec<bool>>()
        };
        assert_eq!(on(70.0), [false, false, true, false, true, false, false, false], "the first road is long enough");
        assert!(on(140.0).iter().all(|ends| !ends));
    }

    #[test]
    fn a_ring_is_where_the_only_ways_lead_back() {
        let mut network = roads(70.0);
        let rings = |network: &RoadNetwork| network.lanes.iter().filter(|lane| leads_back(network, lane)).count();
        assert_eq!(rings(&network), 0);
        network.lanes[6].successors = vec![LaneId(0)];
        assert_eq!(rings(&network), 4);
        network.lanes[4].successors.push(LaneId(7));
        assert_eq!(rings(&network), 0, "one may leave it");
    }
}
