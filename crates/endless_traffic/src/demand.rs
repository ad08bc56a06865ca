//! How much traffic each lane carries beside others: wide and fast roads carry more.

use endless_road::{LaneId, RoadNetwork};

/// Limit of a usual street, m/s.
const USUAL_MPS: f64 = 50.0 / 3.6;
/// Least and most of the demand of a lane, as a multiple of that of a street with one lane each way.
const BOUNDS: [f64; 2] = [0.6, 2.2];

/// Relative demand by lane: 1 of a usual street with one lane in each direction. Arterials carry more on each of their lanes
/// than side streets do: in the Highway Capacity Manual's classes of urban streets (Transportation Research Board 2016,
/// chapter 16) about three times as many vehicles a lane on a principal arterial as on a local street.
pub(crate) fn lane_demand(network: &RoadNetwork) -> Vec<f64> {
    let own = |id: LaneId| {
        let lane = network.lane(id);
        let beside = |step: fn(&endless_road::Lane) -> Option<LaneId>| {
            std::iter::successors(step(lane), |id| step(network.lane(*id))).take(8).count()
        };
        let lanes = (1 + beside(|l| l.left) + beside(|l| l.right)) as f64;
        let pace = lane.speed_limit_mps / USUAL_MPS;
        (lanes * pace).sqrt().clamp(BOUNDS[0], BOUNDS[1])
    };
    let demand = |lane: &endless_road::Lane| match lane.junction {
        None => own(lane.id),
        // What leads to a road carries what goes there.
        Some(_) => {
            let ways = std::iter::successors(Some(lane), |l| l.successors.first().map(|&next| network.lane(next)));
            let exit = ways.take(8).find(|l| l.junction.is_none());
            exit.map_or(1.0, |exit| own(exit.id))
        }
    };
    network.lanes.iter().map(demand).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{Lane, Polyline};
    use glam::DVec3;

    #[test]
    fn wide_and_fast_roads_carry_more() {
        let line = |y: f64| Polyline::new((0..=10).map(|k| DVec3::new(10.0 * f64::from(k), y, 0.0)));
        let lane = |id: u32, limit: f64| Lane::new(LaneId(id), line(f64::from(id) * 3.5), 3.5, limit);
        let street = lane(0, USUAL_MPS);
        let (mut right, mut left) = (lane(1, USUAL_MPS), lane(2, USUAL_MPS));
        (right.left, left.right) = (Some(LaneId(2)), Some(LaneId(1)));
        let (fast, slow) = (lane(3, 2.0 * USUAL_MPS), lane(4, 0.3 * USUAL_MPS));
        let network = RoadNetwork { lanes: vec![street, right, left, fast, slow], ..RoadNetwork::default() };
        let demand = lane_demand(&network);
        assert_eq!((demand[0], demand[4]), (1.0, BOUNDS[0]));
        assert!(demand[1] > 1.3 && demand[1] == demand[2] && demand[3] > 1.3, "{demand:?}");
    }
}
