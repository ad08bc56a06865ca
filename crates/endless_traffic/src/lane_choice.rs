//! Which lane of a road is the right one: drivers choose where to go at the next junction among the ways from all lanes of their
//! road, and change to a lane from which theirs leads on, if they get there in time. Who does not goes where the lane leads.

use crate::roads::Roads;
use crate::turn_aim::Aim;
use crate::vehicle::Vehicle;
use endless_road::{JunctionId, LaneId, Turn, likelihood_of};
use endless_world::Stream;

/// What a lane change towards the right lane is worth, m/s²: a little more than what bothers a driver enough to change at all.
const WORTH_MPS2: f64 = 0.6;
/// A lane with a queue that leaves less open is one to avoid.
const OPEN: f64 = 0.5;
/// So many lanes follow one another before a junction at most.
const MOST_PIECES: usize = 6;

/// The junction to which a lane leads, and the last lane before it; none where roads part or run together before.
fn approach(roads: &Roads, lane: LaneId) -> Option<(JunctionId, LaneId)> {
    let mut lane = roads.network.lane(lane);
    for _ in 0..MOST_PIECES {
        let first = roads.network.lane(*lane.successors.first()?);
        if let Some(junction) = first.junction {
            return Some((junction, lane.id));
        }
        if lane.successors.len() > 1 {
            return None;
        }
        lane = first;
    }
    None
}

/// The lanes beside one another, this one among them, that lead to a junction: from left to right.
fn lanes_to(roads: &Roads, lane: LaneId, junction: JunctionId) -> Vec<LaneId> {
    let leads = |lane: &LaneId| approach(roads, *lane).is_some_and(|(to, _)| to == junction);
    let side = |next: fn(&endless_road::Lane) -> Option<LaneId>| {
        std::iter::successors(Some(lane), move |&l| next(roads.network.lane(l))).skip(1).take(8).take_while(leads)
    };
    let mut lanes: Vec<LaneId> = side(|l| l.left).collect();
    lanes.reverse();
    lanes.push(lane);
    lanes.extend(side(|l| l.right));
    lanes
}

/// Thinks of where to go at the next junction, if it is another than the one thought of before.
pub(crate) fn think(roads: &Roads, vehicle: &mut Vehicle) {
    let here = vehicle.lane();
    let next = if roads.table(here).junction.is_some() { None } else { approach(roads, here) };
    let Some((junction, before)) = next else { return };
    if vehicle.aim.is_some_and(|aim| aim.junction == junction) {
        return;
    }
    let place = vehicle.route.iter().position(|&lane| lane == before);
    let planned = place.and_then(|place| vehicle.route.get(place + 1)).copied();
    let mut stream = vehicle.stream.fork(u64::from(junction.0));
    vehicle.aim = choose(roads, vehicle, junction, planned, &mut stream).map(|turn| Aim { junction, turn });
}

/// The turn to take at a junction. Of the lane one is on, only the way that is planned already can be had.
fn choose(
    roads: &Roads,
    vehicle: &Vehicle,
    junction: JunctionId,
    planned: Option<LaneId>,
    stream: &mut Stream,
) -> Option<Turn> {
    let here = vehicle.lane();
    let allowed = roads.allowed(vehicle.asset.model);
    let mut turns = Vec::new();
    let mut weights = Vec::new();
    for lane in lanes_to(roads, here, junction) {
        let (_, before) = approach(roads, lane)?;
        let ways = roads.network.lane(before).successors.iter().copied().filter(|way| allowed[way.index()]);
        let ways: Vec<LaneId> = ways.collect();
        let likely = ways.iter().map(|&way| likelihood_of(roads.network.lane(way).turn));
        let likely: Vec<f64> =
            likely.zip(roads.attraction.preference(&ways, vehicle.drawn)).map(|(turn, place)| turn * place).collect();
        if lane == here {
            turns.push(roads.network.lane(planned?).turn);
            weights.push(likely.iter().sum());
        } else {
            turns.extend(ways.iter().map(|&way| roads.network.lane(way).turn));
            weights.extend(likely);
        }
    }
    (turns.len() > 1 && weights.iter().sum::<f64>() > 0.0).then(|| turns[stream.weighted(&weights)])
}

/// Whether a way through a junction leads neither into a queue nor to where one has to turn soon.
fn drives_on(roads: &Roads, way: LaneId) -> bool {
    !roads.table(way).ends_in_turn && roads.attraction.queues.openness(way) > OPEN
}

/// How many lanes a lane is beside the nearest one from which the turn can be made, if there is any: one that leads on beyond, if
/// there is one.
fn changes_left(roads: &Roads, lane: LaneId, aim: Aim) -> Option<usize> {
    let lanes = lanes_to(roads, lane, aim.junction);
    let offers = |lane: LaneId, leads_on: bool| {
        let ways = approach(roads, lane).map(|(_, before)| &roads.network.lane(before).successors);
        let suits = |way: LaneId| roads.network.lane(way).turn == aim.turn;
        ways.is_some_and(|ways| ways.iter().any(|&way| suits(way) && (!leads_on || drives_on(roads, way))))
    };
    let here = lanes.iter().position(|&other| other == lane)?;
    let nearest = |leads_on: bool| {
        let right = lanes.iter().enumerate().filter(|(_, lane)| offers(**lane, leads_on));
        right.map(|(k, _)| k.abs_diff(here)).min()
    };
    nearest(true).or_else(|| nearest(false))
}

/// What a change to the lane beside is worth because the way leads on from there, m/s²; negative, where it leads elsewhere.
pub(crate) fn incentive(roads: &Roads, vehicle: &Vehicle, target: LaneId) -> f64 {
    let Some(aim) = vehicle.aim else { return 0.0 };
    let [now, then] = [vehicle.lane(), target].map(|lane| changes_left(roads, lane, aim));
    match (now, then) {
        (Some(now), Some(then)) => WORTH_MPS2 * (now as f64 - then as f64).clamp(-1.0, 1.0),
        _ => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Junction, Lane, Polyline, RoadNetwork};
    use endless_world::math::f64::sin_cos;
    use endless_world::{VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    /// A road of two lanes: from the left one (0) one turns left, from the right one (1) one goes straight on.
    fn fork(spec: &VehicleSpec) -> Roads {
        let line = |points: &[[f64; 2]]| Polyline::new(points.iter().map(|&[x, y]| DVec3::new(x, y, 0.0)));
        let lane = |id: u32, points: &[[f64; 2]]| Lane::new(LaneId(id), line(points), 3.5, 13.9);
        let arc: Vec<[f64; 2]> = (0..=16)
            .map(|i| f64::from(i) / 16.0 * std::f64::consts::FRAC_PI_2)
            .map(sin_cos)
            .map(|(sin, cos)| [200.0 + 15.0 * sin, 3.5 + 15.0 * (1.0 - cos)])
            .collect();
        let mut lanes = vec![
            lane(0, &[[0.0, 3.5], [200.0, 3.5]]),
            lane(1, &[[0.0, 0.0], [200.0, 0.0]]),
            lane(2, &arc),
            lane(3, &[[200.0, 0.0], [230.0, 0.0]]),
            lane(4, &[[215.0, 18.5], [215.0, 150.0]]),
            lane(5, &[[230.0, 0.0], [400.0, 0.0]]),
        ];
        (lanes[0].right, lanes[1].left) = (Some(LaneId(1)), Some(LaneId(0)));
        for (from, to) in [(0, 2), (1, 3), (2, 4), (3, 5)] {
            lanes[from].successors = vec![LaneId(to)];
        }
        lanes[2].turn = Turn::Left;
        for way in [2, 3] {
            lanes[way].junction = Some(JunctionId(0));
        }
        let junctions = vec![Junction { lanes: vec![LaneId(2), LaneId(3)], ..Junction::default() }];
        let network = RoadNetwork { lanes, junctions, ..RoadNetwork::default() }.finish().expect("a fork");
        Roads::new(&TrafficMap::new(network, std::slice::from_ref(spec)), &Focus::default(), &[])
    }

    #[test]
    fn drivers_want_the_lane_from_which_their_way_leads_on() {
        let spec = VehicleSpec::default();
        let roads = fork(&spec);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let mut straight = 0;
        for seed in 0..400 {
            let mut stream = Stream::named(seed, "test.lane_choice", &[]);
            let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
            let mut vehicle = Vehicle::new(&spec, asset, driver, LaneId(0), 20.0, stream);
            vehicle.plan(&roads);
            think(&roads, &mut vehicle);
            let aim = vehicle.aim.expect("a junction ahead");
            let wants_over = incentive(&roads, &vehicle, LaneId(1));
            match aim.turn {
                Turn::Straight => assert_eq!(wants_over, WORTH_MPS2),
                _ => assert_eq!(wants_over, -WORTH_MPS2),
            }
            straight += u32::from(aim.turn == Turn::Straight);
            think(&roads, &mut vehicle);
            assert_eq!(vehicle.aim, Some(aim), "thought of once a junction");
        }
        // Twice as many go straight on as turn.
        assert!((230..300).contains(&straight), "{straight}");
    }
}
