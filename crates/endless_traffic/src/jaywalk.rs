//! Crossings of roads away from the crossings on them: what whoever makes one sees coming, and what drivers see.

use crate::crossing::{comfortable_stop_m, in_the_way_m, nears_lane};
use crate::midblock::{MidblockCut, MidblockWay};
use crate::occupancy::PersonOnLane;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use crate::walk_strip::DirectedEdge;
use endless_road::{LaneId, WalkKind};
use glam::{DVec2, DVec3};

/// Who comes may speed up like this, m/s².
const SPEEDS_UP_MPS2: f64 = 1.0;
/// Vehicles are looked out for up to this far, metres.
const LOOK_M: f64 = 130.0;
/// People wait this far before the roadway, metres.
pub(crate) const BEFORE_KERB_M: f64 = 0.35;
/// Half the width of the way over the road, and the room that drivers leave before it, metres.
const HALF_WIDTH_M: f64 = 0.5;
/// A vehicle that changes lanes is in the way this far beside its lane, metres.
const SHIFTING_M: f64 = 6.0;

/// How far somebody is with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stage {
    /// On the way to the place.
    Coming,
    /// At the kerb.
    Waiting,
    /// On the roadway.
    Crossing,
}

/// Somebody's crossing of a road.
#[derive(Debug, Clone)]
pub(crate) struct Jaywalk {
    pub(crate) way: MidblockWay,
    pub(crate) stage: Stage,
    pub(crate) waited_s: f64,
}

/// What somebody who waits or crosses sees coming in a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Approach {
    /// The lane, metres along the way over the road.
    pub(crate) along_m: f64,
    /// How far beside its middle the vehicle sweeps, metres.
    pub(crate) beside_m: f64,
    pub(crate) arrives_s: f64,
    /// It is there, or too close to stop.
    pub(crate) late: bool,
}

/// A lane that somebody waits to cross or crosses.
#[derive(Debug, Clone, Copy)]
struct Watch {
    lane: LaneId,
    walker: usize,
    s: f64,
    along_m: f64,
}

/// Traffic as those see it who cross away from crossings.
#[derive(Debug, Clone, Default)]
pub(crate) struct Roadway {
    /// By lane.
    watches: Vec<Watch>,
    /// By walker; empty where nobody crosses.
    approaches: Vec<Vec<Approach>>,
}

impl Roadway {
    /// Looks at the vehicles that come to where somebody waits or crosses.
    pub(crate) fn note_vehicles<'a>(
        &mut self,
        roads: &Roads,
        vehicles: &[Vehicle],
        jaywalks: impl Iterator<Item = Option<&'a Jaywalk>>,
    ) {
        self.watches.clear();
        self.approaches.clear();
        let mut walkers = 0;
        for (walker, jaywalk) in jaywalks.enumerate() {
            walkers = walker + 1;
            if let Some(jaywalk) = jaywalk.filter(|jaywalk| jaywalk.stage != Stage::Coming) {
                let cuts = jaywalk.way.cuts.iter();
                let watch = cuts.map(|cut| Watch { lane: cut.lane, walker, s: cut.s, along_m: cut.along_m });
                self.watches.extend(watch);
            }
        }
        if self.watches.is_empty() {
            return;
        }
        self.watches.sort_unstable_by_key(|watch| (watch.lane, watch.walker));
        self.approaches.resize(walkers, Vec::new());
        for vehicle in vehicles.iter().filter(|vehicle| !vehicle.is_parked()) {
            let mut base = -vehicle.s;
            for &lane in vehicle.route.iter().take(vehicle.here).rev() {
                base -= roads.table(lane).length;
                self.look(vehicle, lane, base);
            }
            for (lane, base) in vehicle.ahead(roads).take_while(|(_, base)| *base < LOOK_M) {
                self.look(vehicle, lane, base);
            }
        }
    }

    /// Looks at a vehicle on a lane of its way that begins `base` metres ahead of its origin.
    fn look(&mut self, vehicle: &Vehicle, lane: LaneId, base: f64) {
        let from = self.watches.partition_point(|watch| watch.lane < lane);
        for watch in self.watches[from..].iter().take_while(|watch| watch.lane == lane) {
            let at = base + watch.s;
            if at + HALF_WIDTH_M < -vehicle.half_length - 0.3 {
                continue;
            }
            let gap = at - HALF_WIDTH_M - vehicle.half_length;
            let (speed, a) = (vehicle.speed, SPEEDS_UP_MPS2);
            let arrives_s = ((speed * speed + 2.0 * a * gap.max(0.0)).sqrt() - speed) / a;
            let beside_m = in_the_way_m(vehicle).max(if vehicle.shift.is_some() { SHIFTING_M } else { 0.0 });
            let late = gap < comfortable_stop_m(speed);
            self.approaches[watch.walker].push(Approach { along_m: watch.along_m, beside_m, arrives_s, late });
        }
    }

    /// Looks at vehicles that play recorded tracks: parts of lanes that they cover, with their speeds.
    pub(crate) fn note_played(&mut self, covers: impl Iterator<Item = (LaneId, [f64; 2], f64)>) {
        for (lane, [rear, front], speed) in covers {
            let from = self.watches.partition_point(|watch| watch.lane < lane);
            for watch in self.watches[from..].iter().take_while(|watch| watch.lane == lane && watch.s > rear) {
                let gap = (watch.s - HALF_WIDTH_M - front).max(0.0);
                let approach = Approach {
                    along_m: watch.along_m,
                    beside_m: SHIFTING_M,
                    arrives_s: gap / speed.max(0.1),
                    late: gap < comfortable_stop_m(speed),
                };
                self.approaches[watch.walker].push(approach);
            }
        }
    }

    pub(crate) fn of(&self, walker: usize) -> &[Approach] {
        self.approaches.get(walker).map_or(&[], Vec::as_slice)
    }
}

/// The people on roadways as drivers see them, by lane, given where they are.
pub(crate) fn people_on_lanes<'a>(jaywalks: impl Iterator<Item = (&'a Jaywalk, DVec2)>) -> Vec<PersonOnLane> {
    let mut people = Vec::new();
    for (jaywalk, at) in jaywalks.filter(|(jaywalk, _)| jaywalk.stage == Stage::Crossing) {
        let along = jaywalk.along(at);
        let on = |cut: &MidblockCut| PersonOnLane {
            lane: cut.lane,
            s: cut.s,
            half_width_m: HALF_WIDTH_M,
            to_lane_m: cut.along_m - along,
        };
        people.extend(jaywalk.way.cuts.iter().map(on).filter(|person| nears_lane(person.to_lane_m)));
    }
    people.sort_by(|a, b| a.lane.cmp(&b.lane).then(a.s.total_cmp(&b.s)));
    people
}

impl Jaywalk {
    pub(crate) fn across(&self) -> DVec2 {
        let [a, b] = self.way.ends.map(DVec3::truncate);
        (b - a).normalize_or(DVec2::X)
    }

    pub(crate) fn along(&self, at: DVec2) -> f64 {
        (at - self.way.ends[0].truncate()).dot(self.across())
    }

    /// Where to wait for a gap.
    pub(crate) fn kerb(&self) -> DVec2 {
        self.way.ends[0].truncate() + self.across() * (self.way.kerbs_m[0] - BEFORE_KERB_M)
    }

    /// The way over the road as a strip, while they are on it.
    pub(crate) fn strip(&self) -> Option<DirectedEdge> {
        (self.stage == Stage::Crossing).then(|| DirectedEdge {
            from: self.way.ends[0].truncate(),
            along: self.across(),
            length: self.way.length_m(),
            half_width: HALF_WIDTH_M,
            kind: WalkKind::Sidewalk,
            round_m: 0.0,
        })
    }

    /// The way they look while they wait.
    pub(crate) fn waits_for(&self) -> Option<DVec2> {
        (self.stage == Stage::Waiting).then(|| self.across())
    }
}
