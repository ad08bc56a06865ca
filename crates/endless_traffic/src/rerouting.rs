//! Drivers who see a queue beyond a junction on their way take another way there that is open.
//!
//! Where queues reach back from junction to junction, those who keep to their ways fill the network up until nobody moves; a few
//! who go round the queues dissolve them (Daganzo, Gayah and Gonzales 2011; Mahmassani, Saberi and Zockaie 2013).

use crate::roads::{Roads, fastest_before};
use crate::vehicle::Vehicle;
use endless_road::{LaneId, Turn, likelihood_of};
use endless_world::ObjectClass;

/// A way that leads into a queue which leaves less open is one to get round, and what leaves more is open.
const CLOSED: f64 = 0.4;
const OPEN: f64 = 0.8;
/// Of those who could go round a queue so many do so a second.
const A_SECOND: f64 = 0.1;

/// Looks along the way of a vehicle, once a second.
pub(crate) fn step(roads: &Roads, vehicle: &mut Vehicle) {
    let bound = vehicle.order.is_some() || vehicle.kerb_halt.is_some() || vehicle.filtering.is_some();
    if bound || vehicle.class == ObjectClass::Bus {
        return;
    }
    let Some((place, ways)) = first_closed(roads, vehicle) else { return };
    if !vehicle.stream.chance(A_SECOND) {
        return;
    }
    let likely = ways.iter().map(|&way| likelihood_of(roads.network.lane(way).turn));
    let weights: Vec<f64> =
        likely.zip(roads.attraction.preference(&ways, vehicle.drawn)).map(|(turn, place)| turn * place).collect();
    let way = ways[vehicle.stream.weighted(&weights)];
    vehicle.route.truncate(place);
    vehicle.route.push_back(way);
    vehicle.aim = None;
    vehicle.plan(roads);
}

/// The first way through a junction ahead that leads into a queue where others are open: its place on the route, and those.
fn first_closed(roads: &Roads, vehicle: &Vehicle) -> Option<(usize, Vec<LaneId>)> {
    let allowed = roads.allowed(vehicle.asset.model);
    let openness = |way: LaneId| roads.attraction.queues.openness(way);
    let mut before = vehicle.lane();
    for (k, (lane, base)) in vehicle.ahead(roads).enumerate() {
        let came_from = std::mem::replace(&mut before, lane);
        let Some(junction) = roads.table(lane).junction.filter(|_| k > 0 && base > vehicle.half_length) else {
            continue;
        };
        if roads.table(came_from).junction.is_some()
            || vehicle.right_of_way_at(junction).is_some()
            || openness(lane) > CLOSED
        {
            continue;
        }
        let suits = |way: &LaneId| {
            allowed[way.index()]
                && *way != lane
                && roads.network.lane(*way).turn != Turn::UTurn
                && openness(*way) > OPEN
                && vehicle.speed < fastest_before(roads.table(*way).speed_at(0.0), base - vehicle.half_length)
        };
        let others: Vec<LaneId> = roads.network.lane(came_from).successors.iter().copied().filter(suits).collect();
        if !others.is_empty() {
            return Some((vehicle.here + k, others));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::driver::Driver;
    use crate::focus::Focus;
    use crate::roads::TrafficMap;
    use crate::settings::DrivingCondition;
    use endless_road::{Junction, JunctionId, Lane, Polyline, RoadNetwork};
    use endless_world::{Stream, VehicleModelId, VehicleRef, VehicleSpec};
    use glam::DVec3;

    /// A road (0) from which two ways lead straight on (1, 2) to two others (3, 4).
    fn fork(spec: &VehicleSpec) -> Roads {
        let lane = |id: u32, [x, to_x]: [f64; 2], [y, to_y]: [f64; 2]| {
            let line = Polyline::new([DVec3::new(x, y, 0.0), DVec3::new(to_x, to_y, 0.0)]);
            Lane::new(LaneId(id), line, 3.5, 13.9)
        };
        let mut lanes = vec![
            lane(0, [0.0, 100.0], [0.0, 0.0]),
            lane(1, [100.0, 140.0], [0.0, 2.0]),
            lane(2, [100.0, 140.0], [0.0, -2.0]),
            lane(3, [140.0, 240.0], [2.0, 2.0]),
            lane(4, [140.0, 240.0], [-2.0, -2.0]),
        ];
        lanes[0].successors = vec![LaneId(1), LaneId(2)];
        for way in [1, 2] {
            (lanes[way].junction, lanes[way].successors) = (Some(JunctionId(0)), vec![LaneId(way as u32 + 2)]);
        }
        let junctions = vec![Junction { lanes: vec![LaneId(1), LaneId(2)], ..Junction::default() }];
        let network = RoadNetwork { lanes, junctions, ..RoadNetwork::default() }.finish().expect("a fork");
        Roads::new(&TrafficMap::new(network, std::slice::from_ref(spec)), &Focus::default(), &[])
    }

    #[test]
    fn who_sees_a_queue_beyond_the_junction_takes_the_way_that_is_open() {
        let spec = VehicleSpec::default();
        let mut roads = fork(&spec);
        let asset = VehicleRef { model: VehicleModelId::from_index(0), variant: 0 };
        let mut stream = Stream::named(1, "test.rerouting", &[]);
        let driver = Driver::new(&spec, &DrivingCondition::default(), 0.5, &mut stream);
        let mut vehicle = Vehicle::new(&spec, asset, driver, LaneId(0), 50.0, stream);
        vehicle.plan(&roads);
        let planned = vehicle.route[1];
        let other = LaneId(3 - planned.0);
        let mut after_a_minute = |queues: &[LaneId]| {
            let standing: Vec<(LaneId, f64)> =
                queues.iter().flat_map(|&way| [(LaneId(way.0 + 2), 0.0)].repeat(12)).collect();
            roads.attraction.queues.notice(standing.into_iter());
            (0..60).for_each(|_| step(&roads, &mut vehicle));
            vehicle.route[1]
        };
        assert_eq!(after_a_minute(&[]), planned);
        assert_eq!(after_a_minute(&[planned, other]), planned, "there is no better way");
        assert_eq!(after_a_minute(&[planned]), other);
    }
}
