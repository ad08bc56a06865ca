//! Drivers leave a roundabout where their way goes on: who turned left or right at random at each of its exits would go round it
//! again and again.

use endless_road::{LaneId, RoadNetwork, likelihood_of};
use endless_world::math::f64::atan2;
use glam::DVec2;
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Longest way round, metres.
const MOST_M: f64 = 400.0;
/// What is round turns everywhere: on each eighth of its way at least so much, as a share of what a circle turns. Around a block
/// of houses one drives straight on between corners.
const TURNS: f64 = 0.4;
const STATIONS: usize = 64;
const EIGHTH: usize = STATIONS / 8;
/// Exits that are passed for each that is taken, in the mean: with four, a quarter turns at the first, half drives straight on,
/// a quarter turns at the third.
const TAKEN: f64 = 2.0;
/// Most who leave at an exit: a few turn back.
const MOST_LEAVE: f64 = 0.9;

/// Factors on the likelihood of ways by lane: where others leave a roundabout, of going on round it; 1 of all other ways.
pub(crate) fn going_round(network: &RoadNetwork) -> Vec<f64> {
    let mut factors = vec![1.0; network.lanes.len()];
    for lane in network.lanes.iter().filter(|lane| lane.successors.len() > 1) {
        for &way in &lane.successors {
            let Some(circle) = circle(network, way).filter(|circle| circle.last() == Some(&lane.id)) else { continue };
            let leads_out = |on: &&LaneId| network.lane(**on).successors.iter().any(|next| !circle.contains(next));
            let exits = circle.iter().filter(leads_out).count();
            let leaves = (TAKEN / exits as f64).min(MOST_LEAVE);
            let likelihood = |way: &LaneId| likelihood_of(network.lane(*way).turn);
            let out: f64 = lane.successors.iter().filter(|other| **other != way).map(likelihood).sum();
            factors[way.index()] = (1.0 - leaves) / leaves * out / likelihood(&way);
        }
    }
    factors
}

/// The lanes of the shortest way from a lane back to it, from that lane on, if it is round.
fn circle(network: &RoadNetwork, first: LaneId) -> Option<Vec<LaneId>> {
    // Dijkstra's algorithm: of lanes that can be reached, how far it is to their ends, and from where.
    let length = |lane: LaneId| network.lane(lane).centerline.length();
    let mut open = BTreeMap::from([(first, (length(first), first))]);
    let mut done: BTreeMap<LaneId, LaneId> = BTreeMap::new();
    let around = loop {
        let (&lane, &(reached, from)) = open.iter().min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
        if reached > MOST_M {
            return None;
        }
        open.remove(&lane);
        done.insert(lane, from);
        if network.lane(lane).successors.contains(&first) {
            break lane;
        }
        for &next in network.lane(lane).successors.iter().filter(|next| !done.contains_key(*next)) {
            let end = reached + length(next);
            let known = open.entry(next).or_insert((end, lane));
            if end < known.0 {
                *known = (end, lane);
            }
        }
    };
    let mut lanes: Vec<LaneId> =
        std::iter::successors(Some(around), |lane| (*lane != first).then(|| done[lane])).collect();
    lanes.reverse();
    is_round(network, &lanes).then_some(lanes)
}

/// Whether these lanes, which lead back to their beginning, turn everywhere and to one side.
fn is_round(network: &RoadNetwork, lanes: &[LaneId]) -> bool {
    let length: f64 = lanes.iter().map(|lane| network.lane(*lane).centerline.length()).sum();
    let direction = |station: usize| -> DVec2 {
        let mut s = length * (station % STATIONS) as f64 / STATIONS as f64;
        let (last, before) = lanes.split_last().expect("a lane");
        for lane in before {
            let line = &network.lane(*lane).centerline;
            if s < line.length() {
                return line.direction(s);
            }
            s -= line.length();
        }
        network.lane(*last).centerline.direction(s)
    };
    let turned: Vec<f64> = (0..STATIONS)
        .map(|k| [direction(k), direction(k + EIGHTH)])
        .map(|[from, to]| atan2(from.perp_dot(to), from.dot(to)))
        .collect();
    let least = TURNS * 2.0 * PI / 8.0;
    turned.iter().all(|turn| *turn > least) || turned.iter().all(|turn| *turn < -least)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{Junction, JunctionId, Lane, Polyline, Turn};
    use endless_world::Stream;
    use endless_world::math::f64::sin_cos;
    use glam::DVec3;

    /// A circle of lanes 0 to 2 × `legs` − 1 with an exit at each second one, drawn out by `stretch` along x.
    fn ring(legs: u32, stretch: f64) -> RoadNetwork {
        let arc = |from: f64, to: f64| {
            Polyline::new((0..=8).map(|k| {
                let (sin, cos) = sin_cos(2.0 * PI * (from + (to - from) * f64::from(k) / 8.0) / f64::from(2 * legs));
                DVec3::new(20.0 * stretch * cos, 20.0 * sin, 0.0)
            }))
        };
        let around = 2 * legs;
        let mut lanes: Vec<Lane> = (0..around)
            .map(|k| {
                let next = LaneId((k + 1) % around);
                let line = arc(f64::from(k), f64::from(k + 1));
                Lane { successors: vec![next], ..Lane::new(LaneId(k), line, 3.5, 8.0) }
            })
            .collect();
        for leg in 0..legs {
            let before = 2 * leg as usize;
            let end = lanes[before].centerline.position(f64::INFINITY);
            let exit = LaneId(around + leg);
            let line = Polyline::new([end, end + DVec3::new(end.x, end.y, 0.0)]);
            lanes.push(Lane { turn: Turn::Right, junction: Some(JunctionId(0)), ..Lane::new(exit, line, 3.5, 8.0) });
            lanes[before].successors.push(exit);
            lanes[before + 1].junction = Some(JunctionId(0));
        }
        let junctions = vec![Junction { lanes: (1..around).step_by(2).map(LaneId).collect(), ..Junction::default() }];
        RoadNetwork { lanes, junctions, ..RoadNetwork::default() }
    }

    /// Of a thousand who come to the first exit, how many leave at each.
    fn leave(network: &RoadNetwork, legs: usize) -> Vec<u32> {
        let factors = going_round(network);
        let allowed = vec![true; network.lanes.len()];
        let mut left = vec![0; legs];
        for seed in 0..1000 {
            let mut stream = Stream::named(seed, "test.roundabout", &[]);
            let (mut lane, mut passed) = (LaneId(0), 0);
            while lane.index() < 2 * legs {
                passed += usize::from(lane.index() % 2 == 1);
                let factors = |ways: &[LaneId]| ways.iter().map(|way| factors[way.index()]).collect();
                lane = network.next_lane_preferring(lane, &allowed, factors, &mut stream).expect("a way");
            }
            left[passed.min(legs - 1)] += 1;
        }
        left
    }

    #[test]
    fn drivers_do_not_go_round_and_round() {
        let two = leave(&ring(2, 1.0), 2);
        assert!(two[0] > 860, "{two:?} take the first of two exits, as the second leads back");
        let four = leave(&ring(4, 1.0), 4);
        assert!((450..550).contains(&four[0]) && (200..300).contains(&four[1]), "{four:?}");
        // Twice as many as leave would go on at each exit, if it were any junction.
        let block = ring(4, 4.0);
        assert!(going_round(&block).iter().all(|factor| *factor == 1.0), "drawn out, it is no roundabout");
    }
}
