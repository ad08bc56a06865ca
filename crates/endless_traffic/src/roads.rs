//! The road network with tables for drivers, by lane.

use crate::attraction::Attraction;
use crate::focus::Focus;
use crate::kerb_sweep::KerbSweeps;
use crate::midblock::MidblockWays;
use crate::overlap::{
    ConflictTables, DesignVehicles, DivergingLane, MergeOverlap, SweptBeside, alongside, make_room, siblings,
};
use crate::parked_beside::ParkedBeside;
use crate::roundabout::going_round;
use crate::sitting::BenchPlaces;
use crate::stop_places::StopPlaces;
use crate::turn_lane;
use endless_road::swept::{LONG_M, fits, leaves_oncoming_room, mean_curvature_per_m, smallest_radius_m};
use endless_road::{Borders, CrossingId, JunctionId, LaneConflict, LaneId, Polyline, RoadNetwork};
use endless_world::{VehicleModelId, VehicleSpec};
use glam::Vec3;
use std::{ops::Deref, sync::Arc};

/// Distance between stations of a speed profile, metres.
const STATION_M: f64 = 1.0;
/// Sideways acceleration that people accept in bends, m/s².
const BEND_MPS2: f64 = 2.0;
/// Bends are felt after this, seconds; over so many metres they are looked at.
const FELT_S: f64 = 0.8;
const BEND_WINDOWS_M: [f64; 4] = [4.0, 8.0, 16.0, 24.0];
/// Braking planned before a bend, m/s².
const PLANNED_BRAKING: f64 = 1.3;

/// Wider models are asked where they fit as if they were long: they fill a narrow lane, and in bends more than it, metres.
pub(crate) const WIDE_M: f64 = 2.2;

/// How fast one may be so far before a place that is passed at a speed, m/s and metres.
pub(crate) fn fastest_before(passed_mps: f64, distance_m: f64) -> f64 {
    (passed_mps * passed_mps + 2.0 * PLANNED_BRAKING * distance_m).sqrt()
}

/// A crossing over a lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CrossingCut {
    pub(crate) crossing: CrossingId,
    /// Range of `s`.
    pub(crate) range: (f64, f64),
    /// Place of the lane along the crossing, metres from its first end.
    pub(crate) along_m: f64,
}

/// One lane's tables.
#[derive(Debug, Clone, Default)]
pub(crate) struct LaneTable {
    pub(crate) length: f64,
    pub(crate) junction: Option<JunctionId>,
    profile: Vec<f64>,
    pub(crate) cuts: Vec<CrossingCut>,
    /// Smallest radius of the centre line, metres.
    pub(crate) radius: f64,
    conflicts: Vec<LaneConflict>,
    /// With a long vehicle, which swings out in bends.
    wide_conflicts: Vec<LaneConflict>,
    pub(crate) siblings: Vec<DivergingLane>,
    pub(crate) alongside: Vec<MergeOverlap>,
    /// Distance from the lane's end at which vehicles wait, so that those who turn get past, metres.
    pub(crate) setback: f64,
    /// Where nobody may stand while a long vehicle turns on it.
    pub(crate) sweeps: SweptBeside,
    /// Whether who drives on straight from here will have to turn where others go straight on, with no room to change lanes before.
    pub(crate) ends_in_turn: bool,
    /// Whether one comes back to it who changes to no other lane.
    pub(crate) leads_back: bool,
}

impl LaneTable {
    /// Conflicts with other lanes of the junction, wider if one of the two vehicles is long.
    pub(crate) fn conflicts(&self, long: bool) -> &[LaneConflict] {
        if long { &self.wide_conflicts } else { &self.conflicts }
    }

    /// Highest comfortable speed at `s`, braking for what follows on this lane included.
    pub(crate) fn speed_at(&self, s: f64) -> f64 {
        let i = ((s / STATION_M).max(0.0) as usize).min(self.profile.len() - 1);
        let next = self.profile[(i + 1).min(self.profile.len() - 1)];
        let t = (s / STATION_M - i as f64).clamp(0.0, 1.0);
        self.profile[i] + (next - self.profile[i]) * t
    }
}

/// A road network with tables for drivers of all models of a fleet: made once a map. Clones share it.
#[derive(Debug, Clone)]
pub struct TrafficMap(pub(crate) Arc<RoadTables>);

/// The network with its tables.
#[derive(Debug)]
pub(crate) struct RoadTables {
    pub(crate) network: RoadNetwork,
    /// Where vehicles come onto the map and leave it; nowhere, where they do not.
    pub(crate) borders: Borders,
    /// The models that drive on it.
    pub(crate) specs: Vec<VehicleSpec>,
    /// Lanes from which vehicles of each model can drive on for ever, or leave the map.
    allowed: Vec<Vec<bool>>,
    lanes: Vec<LaneTable>,
    /// By lane, as [`going_round`] says.
    going_round: Arc<[f64]>,
}

/// The network with its tables, and where traffic goes.
#[derive(Debug, Clone)]
pub(crate) struct Roads {
    tables: Arc<RoadTables>,
    pub(crate) attraction: Attraction,
    /// Where people cross away from crossings; nowhere, if nobody does.
    pub(crate) midblock: Arc<MidblockWays>,
    /// Where people wait for buses.
    pub(crate) stop_places: Arc<StopPlaces>,
    /// Where people sit.
    pub(crate) benches: Arc<BenchPlaces>,
    /// Parked vehicles that reach over walks.
    pub(crate) parked_beside: Arc<ParkedBeside>,
}

impl Roads {
    /// With what is looked at, and where people have something to do.
    pub(crate) fn new(TrafficMap(tables): &TrafficMap, focus: &Focus, errands: &[Vec3]) -> Self {
        Self {
            tables: Arc::clone(tables),
            attraction: Attraction::new(&tables.network, Arc::clone(&tables.going_round), focus, errands),
            midblock: Arc::default(),
            stop_places: Arc::default(),
            benches: Arc::default(),
            parked_beside: Arc::default(),
        }
    }
}

impl Deref for Roads {
    type Target = RoadTables;

    fn deref(&self) -> &RoadTables {
        &self.tables
    }
}

impl TrafficMap {
    /// Of a network and all models that may drive on it. Where its roads leave the map, vehicles leave and others come.
    pub fn new(network: RoadNetwork, specs: &[VehicleSpec]) -> Self {
        let borders = network.borders();
        Self::with_borders(network, specs, if borders.are_open() { borders } else { Borders::default() })
    }

    /// The same, but nobody comes or leaves: only where one can drive for ever are there vehicles.
    pub fn closed(network: RoadNetwork, specs: &[VehicleSpec]) -> Self {
        Self::with_borders(network, specs, Borders::default())
    }

    fn with_borders(network: RoadNetwork, specs: &[VehicleSpec], borders: Borders) -> Self {
        let bodies = DesignVehicles::of(specs);
        let mut lanes: Vec<LaneTable> = network.lanes.iter().map(|lane| table(&network, lane.id)).collect();
        for (place, crossing) in network.crossings.iter().enumerate() {
            let [from, to] = crossing.ends.map(glam::DVec3::truncate);
            let direction = (to - from).normalize_or_zero();
            for cut in &crossing.cuts {
                let middle = network.lane(cut.lane).centerline.at(0.5 * (cut.range.0 + cut.range.1)).position;
                let along_m = (middle.truncate() - from).dot(direction);
                lanes[cut.lane.index()].cuts.push(CrossingCut {
                    crossing: CrossingId(place as u16),
                    range: cut.range,
                    along_m,
                });
            }
        }
        let conflicts = ConflictTables::of(&network, bodies);
        let beside = alongside(&network, bodies);
        for (((table, small), (wide, setback)), beside) in
            lanes.iter_mut().zip(conflicts.small).zip(conflicts.wide.into_iter().zip(conflicts.setbacks)).zip(beside)
        {
            (table.conflicts, table.wide_conflicts, table.setback, table.alongside) = (small, wide, setback, beside);
        }
        for lane in &network.lanes {
            lanes[lane.id.index()].siblings = siblings(&network, lane, &bodies);
        }
        for (table, lane) in lanes.iter_mut().zip(&network.lanes) {
            table.ends_in_turn = turn_lane::ends_in_turn(&network, lane);
            table.leads_back = turn_lane::leads_back(&network, lane);
        }
        let everybody = network.lanes_in_use(&borders);
        let kerbs = KerbSweeps::new(&network, lanes.iter().map(|table| table.radius));
        let mut setbacks: Vec<f64> = lanes.iter().map(|table| table.setback).collect();
        let mut sweeps = vec![SweptBeside::default(); lanes.len()];
        let allowed = specs
            .iter()
            .map(|spec| {
                let mut stays = wide_enough(&network, &lanes, &everybody, spec);
                kerbs.forbid(spec, &mut stays);
                if f64::from(as_asked(spec).length_m) >= LONG_M {
                    make_room(&network, bodies, spec, &mut stays, &mut setbacks, &mut sweeps);
                }
                lanes_that_lead_on(&network, &borders, stays)
            })
            .collect();
        for (table, setback) in lanes.iter_mut().zip(&mut setbacks) {
            *setback = setback.min((table.length - bodies.length_m()).max(0.0));
            table.setback = *setback;
        }
        for (table, mut sweeps) in lanes.iter_mut().zip(sweeps) {
            sweeps
                .approaches
                .iter_mut()
                .for_each(|swept| swept.last_m = swept.last_m.min(setbacks[swept.lane.index()]));
            table.sweeps = sweeps;
        }
        let going_round = going_round(&network).into();
        Self(Arc::new(RoadTables { network, borders, specs: specs.to_vec(), allowed, lanes, going_round }))
    }

    /// The network of which it was made.
    pub fn network(&self) -> &RoadNetwork {
        &self.0.network
    }
}

impl RoadTables {
    /// Lanes from which vehicles of a model can drive on for ever, or leave the map.
    pub(crate) fn allowed(&self, model: VehicleModelId) -> &[bool] {
        &self.allowed[model.index()]
    }

    pub(crate) fn table(&self, lane: LaneId) -> &LaneTable {
        &self.lanes[lane.index()]
    }

    /// Whether vehicles leave the map at the end of a lane.
    pub(crate) fn is_exit(&self, lane: LaneId) -> bool {
        self.borders.exits.binary_search(&lane).is_ok()
    }
}

/// The lanes on which a model fits, without bends too tight for it.
fn wide_enough(network: &RoadNetwork, lanes: &[LaneTable], everybody: &[bool], spec: &VehicleSpec) -> Vec<bool> {
    let spec = as_asked(spec);
    let fitting = network.lanes.iter().zip(lanes).map(|(lane, table)| {
        fits(network, lane, table.radius, &spec) && leaves_oncoming_room(lane, table.radius, &spec)
    });
    fitting.zip(everybody).map(|(fits, &stays)| fits && stays).collect()
}

/// A model as it is asked whether it fits: a short one that is wide as the shortest of those that do not fit everywhere.
fn as_asked(spec: &VehicleSpec) -> VehicleSpec {
    let wide = f64::from(spec.width_m) > WIDE_M;
    VehicleSpec { length_m: if wide { spec.length_m.max(LONG_M as f32) } else { spec.length_m }, ..spec.clone() }
}

/// The lanes among these on which one can drive for ever or until one leaves the map.
fn lanes_that_lead_on(network: &RoadNetwork, borders: &Borders, mut stays: Vec<bool>) -> Vec<bool> {
    let mut leaves = vec![false; stays.len()];
    borders.exits.iter().for_each(|exit| leaves[exit.index()] = true);
    loop {
        let goes_on = |i: usize| leaves[i] || network.lanes[i].successors.iter().any(|next| stays[next.index()]);
        let stuck: Vec<usize> = (0..stays.len()).filter(|&i| stays[i] && !goes_on(i)).collect();
        if stuck.is_empty() {
            return stays;
        }
        stuck.into_iter().for_each(|i| stays[i] = false);
    }
}

/// The speed at which a bend is felt as much as people accept: a bend that is over sooner than [`FELT_S`] is felt less. Roads of
/// maps are chains of straight pieces with short bends between them.
fn bend_speed_mps(line: &Polyline, s: f64) -> f64 {
    let speeds =
        BEND_WINDOWS_M.map(|over_m| (over_m, (BEND_MPS2 / mean_curvature_per_m(line, s, over_m).max(1e-4)).sqrt()));
    let lasts = speeds.iter().find(|(over_m, mps)| FELT_S * mps <= *over_m);
    lasts.map_or(speeds[speeds.len() - 1].1, |(_, mps)| *mps)
}

fn table(network: &RoadNetwork, id: LaneId) -> LaneTable {
    let lane = network.lane(id);
    let line = &lane.centerline;
    let length = line.length();
    let stations = (length / STATION_M).ceil() as usize + 1;
    let mut profile: Vec<f64> = (0..stations)
        .map(|i| lane.speed_limit_mps.min(bend_speed_mps(line, (i as f64 * STATION_M).min(length))).max(1.5))
        .collect();
    for i in (0..stations - 1).rev() {
        profile[i] = profile[i].min(fastest_before(profile[i + 1], STATION_M));
    }
    let radius = smallest_radius_m(line);
    LaneTable { length, junction: lane.junction, profile, radius, ..LaneTable::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::Lane;
    use glam::DVec3;

    #[test]
    fn a_short_model_that_is_wide_keeps_off_narrow_lanes() {
        let drives = |lane_m: f64, length_m: f32, width_m: f32| {
            let line = Polyline::new([DVec3::ZERO, 100.0 * DVec3::X]);
            let network =
                RoadNetwork { lanes: vec![Lane::new(LaneId(0), line, lane_m, 13.9)], ..RoadNetwork::default() };
            let spec = VehicleSpec { length_m, width_m, ..VehicleSpec::default() };
            wide_enough(&network, &[table(&network, LaneId(0))], &[true], &spec)[0]
        };
        assert!(!drives(2.7, 5.9, 2.47) && drives(3.1, 5.9, 2.47));
        assert!(drives(2.7, 5.9, 2.0), "it is no wider than a van");
    }
}
