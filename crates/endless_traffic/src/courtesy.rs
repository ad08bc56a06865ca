//! People let drivers go whom they have held up for long.
//!
//! At a crossing without a signal drivers give way to people, and where people come all the time nobody would ever drive. After a
//! while people wait until some have got past. They do so at all crossings of a junction at once, or who drives over one would
//! stop before the next, and hold up all others in the junction.

use crate::crossing::CrossingState;
use endless_road::{CrossingId, JunctionId, RoadNetwork};
use std::collections::BTreeMap;

/// People let drivers go whom they have held up for so long, seconds; and for so long, as soon as the road is clear.
const HELD_S: f64 = 25.0;
const LET_GO_S: f64 = 15.0;
/// The road is not always clear: they let them go for no longer, seconds.
const AT_MOST_S: f64 = 30.0;
/// Where no driver has been near for so long, people go on, seconds.
const NOBODY_S: f64 = 2.0;

/// What people at the crossings of a junction do.
#[derive(Debug, Clone, Default)]
pub(crate) struct Courtesy {
    crossings: Vec<CrossingId>,
    /// For how long a driver has stood there while people came, less the time in which none did, seconds.
    held_s: f64,
    letting_go: Option<LettingGo>,
}

/// For how long they have let drivers go: in all, with a clear road, and with nobody driving, seconds.
#[derive(Debug, Clone, Copy, Default)]
struct LettingGo {
    since_s: f64,
    clear_s: f64,
    nobody_s: f64,
}

/// The crossings without signals, those of a junction together.
pub(crate) fn courtesies(network: &RoadNetwork) -> Vec<Courtesy> {
    let mut of_junctions: BTreeMap<JunctionId, Vec<CrossingId>> = BTreeMap::new();
    let mut groups = Vec::new();
    for (place, crossing) in network.crossings.iter().enumerate().filter(|(_, crossing)| crossing.signal.is_none()) {
        let id = CrossingId(place as u16);
        match crossing.cuts.iter().find_map(|cut| network.lane(cut.lane).junction) {
            Some(junction) => of_junctions.entry(junction).or_default().push(id),
            None => groups.push(vec![id]),
        }
    }
    groups.extend(of_junctions.into_values());
    groups.into_iter().map(|crossings| Courtesy { crossings, ..Courtesy::default() }).collect()
}

impl Courtesy {
    /// Goes on by a step, after people and drivers were noted.
    pub(crate) fn step(&mut self, crossings: &mut [CrossingState], step_s: f64) {
        let any = |is: fn(&CrossingState) -> bool| self.crossings.iter().any(|id| is(&crossings[id.index()]));
        let holds_up = any(|state| state.waits && (state.wanted || !state.people.is_empty()));
        let (walked, driven) = (any(|state| !state.people.is_empty()), any(|state| state.waits || state.danger));
        match &mut self.letting_go {
            None => {
                self.held_s = (self.held_s + if holds_up { step_s } else { -step_s }).max(0.0);
                self.letting_go = (self.held_s > HELD_S).then(LettingGo::default);
            }
            Some(now) => {
                now.since_s += step_s;
                now.clear_s += if walked { 0.0 } else { step_s };
                now.nobody_s = if driven { 0.0 } else { now.nobody_s + step_s };
                if now.clear_s > LET_GO_S || now.since_s > AT_MOST_S || now.nobody_s > NOBODY_S {
                    (self.letting_go, self.held_s) = (None, 0.0);
                }
            }
        }
        for id in &self.crossings {
            crossings[id.index()].lets_drivers_go = self.letting_go.is_some();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::crossing::CrossingPedestrian;
    use endless_road::{Crossing, Lane, LaneCut, LaneId, Polyline};
    use glam::DVec3;

    const STEP_S: f64 = 0.1;

    fn two() -> (Courtesy, Vec<CrossingState>) {
        let crossings = vec![CrossingId(0), CrossingId(1)];
        (Courtesy { crossings, ..Courtesy::default() }, vec![CrossingState::default(); 2])
    }

    /// Seconds of the next minute and a half in which people let drivers go, where a driver waits at the first crossing as long
    /// as people do not, and is under way then.
    fn let_go_s(driver: bool, walks_on: bool) -> [f64; 2] {
        let (mut courtesy, mut states) = two();
        let mut let_go = [0.0; 2];
        for _ in 0..900 {
            let goes = states[0].lets_drivers_go;
            states[0].waits = driver && !goes;
            states[0].danger = driver && goes;
            states[0].wanted = !goes;
            let person = CrossingPedestrian { along_m: 1.0, direction: 1.0, speed: 0.0 };
            states[1].people = if walks_on { vec![person] } else { Vec::new() };
            courtesy.step(&mut states, STEP_S);
            for (seconds, state) in let_go.iter_mut().zip(&states) {
                *seconds += if state.lets_drivers_go { STEP_S } else { 0.0 };
            }
        }
        let_go
    }

    #[test]
    fn people_at_all_crossings_of_a_junction_let_drivers_go_together() {
        let [here, there] = let_go_s(true, false);
        assert!(here == there && (here - 2.0 * LET_GO_S).abs() < 1.0, "{here} {there}");
        // Those on the road are waited for, but not for ever.
        let [here, _] = let_go_s(true, true);
        assert!((here - (90.0 - 2.0 * HELD_S)).abs() < 1.0, "{here}");
    }

    #[test]
    fn where_no_driver_waits_nobody_is_let_go() {
        assert_eq!(let_go_s(false, false), [0.0, 0.0]);
    }

    #[test]
    fn crossings_belong_to_the_junction_whose_lanes_they_cut() {
        let line = |y: f64| Polyline::new([DVec3::new(0.0, y, 0.0), DVec3::new(50.0, y, 0.0)]);
        let lanes = (0..4).map(|k| Lane {
            junction: (k != 3).then_some(JunctionId(u16::from(k == 2))),
            ..Lane::new(LaneId(k), line(f64::from(k) * 4.0), 3.5, 13.9)
        });
        let crossing = |k: u32| Crossing {
            ends: [DVec3::ZERO; 2],
            width_m: 3.0,
            signal: None,
            cuts: vec![LaneCut { lane: LaneId(k), range: (1.0, 4.0) }],
        };
        let network = RoadNetwork {
            lanes: lanes.collect(),
            crossings: [0, 1, 2, 3].map(crossing).to_vec(),
            ..RoadNetwork::default()
        };
        let groups: Vec<Vec<u16>> =
            courtesies(&network).iter().map(|group| group.crossings.iter().map(|id| id.0).collect()).collect();
        assert_eq!(groups, [vec![3], vec![0, 1], vec![2]]);
    }
}
