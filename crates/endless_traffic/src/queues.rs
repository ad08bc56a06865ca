//! Where traffic queues, as drivers know it: they go round it if there is another way.

use endless_road::{LaneId, RoadNetwork};

/// Slower than this vehicles queue, m/s.
const QUEUES_MPS: f64 = 2.0;
/// Lane that a vehicle in a queue takes, metres.
const TAKES_M: f64 = 7.5;
/// Shares of a lane in a queue from which on drivers avoid it, and with which they do as much as they ever do: a queue before
/// a red light is none.
const SHORT: f64 = 0.25;
const LONG: f64 = 0.75;
/// Least share of its usual likelihood that a way into a queue keeps.
const LEAST: f64 = 0.02;

/// The queues on all lanes.
#[derive(Debug, Clone, Default)]
pub(crate) struct Queues {
    /// Of each lane: itself, or of one inside a junction the lane to which it leads.
    leads_to: Vec<LaneId>,
    /// Share of each lane that a vehicle in a queue takes.
    taken_by_one: Vec<f64>,
    /// Share of each lane that is in a queue.
    shares: Vec<f64>,
}

impl Queues {
    /// None on the lanes of a network.
    pub(crate) fn new(network: &RoadNetwork) -> Self {
        let leads_to = |lane: &endless_road::Lane| {
            let ways = std::iter::successors(Some(lane), |l| l.successors.first().map(|&next| network.lane(next)));
            ways.take(8).find(|l| l.junction.is_none()).map_or(lane.id, |l| l.id)
        };
        let taken = |lane: &endless_road::Lane| TAKES_M / lane.centerline.length().max(TAKES_M);
        Self {
            leads_to: network.lanes.iter().map(leads_to).collect(),
            taken_by_one: network.lanes.iter().map(taken).collect(),
            shares: vec![0.0; network.lanes.len()],
        }
    }

    /// Takes notice of all vehicles, given their lanes and speeds, m/s.
    pub(crate) fn notice(&mut self, vehicles: impl Iterator<Item = (LaneId, f64)>) {
        self.shares.fill(0.0);
        for (lane, _) in vehicles.filter(|(_, speed)| *speed < QUEUES_MPS) {
            let lane = self.leads_to[lane.index()].index();
            self.shares[lane] += self.taken_by_one[lane];
        }
    }

    /// Factor on the likelihood that somebody takes a lane: 1 where nobody queues.
    pub(crate) fn openness(&self, lane: LaneId) -> f64 {
        let Some(leads_to) = self.leads_to.get(lane.index()) else { return 1.0 };
        let queue = ((self.shares[leads_to.index()] - SHORT) / (LONG - SHORT)).clamp(0.0, 1.0);
        1.0 - (1.0 - LEAST) * queue
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{JunctionId, Lane, Polyline};
    use glam::DVec3;

    #[test]
    fn a_long_queue_is_avoided_from_inside_the_junction_before_it() {
        let line = |x: f64, length: f64| Polyline::new([DVec3::new(x, 0.0, 0.0), DVec3::new(x + length, 0.0, 0.0)]);
        let mut inside = Lane::new(LaneId(0), line(0.0, 15.0), 3.5, 13.9);
        (inside.junction, inside.successors) = (Some(JunctionId(0)), vec![LaneId(1)]);
        let road = Lane::new(LaneId(1), line(15.0, 75.0), 3.5, 13.9);
        let network = RoadNetwork { lanes: vec![inside, road], ..RoadNetwork::default() };
        let mut queues = Queues::new(&network);
        let mut open = |standing: usize, driving: usize| {
            let vehicles = [(LaneId(1), 0.1)].repeat(standing).into_iter().chain([(LaneId(1), 9.0)].repeat(driving));
            queues.notice(vehicles);
            [0, 1].map(|lane| queues.openness(LaneId(lane)))
        };
        assert_eq!(open(0, 8), [1.0, 1.0]);
        assert_eq!(open(2, 0), [1.0, 1.0]);
        let [before, on] = open(5, 0);
        assert!(before == on && (0.45..0.56).contains(&on), "{on}");
        assert!(open(9, 0)[0] <= LEAST + 1e-9);
    }
}
