//! Places where vehicles may appear.

use crate::network_fault::enough_reach;
use crate::{LaneId, RoadNetwork, SpawnPoint};

/// Distance between spawn points of a lane, metres.
const SPACING_M: f64 = 8.0;
/// Distance kept from lane ends and crossings, metres.
const CLEAR_M: f64 = 6.0;

pub(crate) fn derive(network: &mut RoadNetwork) {
    let mut blocked: Vec<Vec<(f64, f64)>> = vec![Vec::new(); network.lanes.len()];
    for cut in network.crossings.iter().flat_map(|c| &c.cuts) {
        blocked[cut.lane.index()].push((cut.range.0 - CLEAR_M, cut.range.1 + CLEAR_M));
    }
    let mut points = Vec::new();
    let leads_on = lanes_that_lead_on(network);
    for lane in network.lanes.iter().filter(|lane| lane.junction.is_none() && leads_on[lane.id.index()]) {
        let cuts = &mut blocked[lane.id.index()];
        cuts.sort_by(|a, b| a.0.total_cmp(&b.0));
        let end = lane.centerline.length() - CLEAR_M;
        let mut start = CLEAR_M;
        for &(low, high) in cuts.iter() {
            fill(lane.id, start, low.min(end), &mut points);
            start = start.max(high);
        }
        fill(lane.id, start, end, &mut points);
    }
    network.spawn_points = points;
}

/// For every lane whether vehicles may begin there: nobody does where one gets nowhere; on a map without a way around, as far
/// as may be. Who can leave the map has somewhere to go.
fn lanes_that_lead_on(network: &RoadNetwork) -> Vec<bool> {
    let reach = network.lane_reach();
    let enough = enough_reach(network, &reach);
    let borders = network.borders();
    let used = network.lanes_in_use(&borders);
    reach.into_iter().zip(used).map(|(reach, used)| reach >= enough || borders.are_open() && used).collect()
}

/// As many points as fit between two places, spread evenly.
fn fill(lane: LaneId, start: f64, end: f64, points: &mut Vec<SpawnPoint>) {
    let room = end - start;
    if room < 0.0 {
        return;
    }
    let gaps = (room / SPACING_M).floor();
    let spacing = if gaps > 0.0 { room / gaps } else { 0.0 };
    let first = if gaps > 0.0 { start } else { 0.5 * (start + end) };
    points.extend((0..=gaps as usize).map(|i| SpawnPoint { lane, s: first + spacing * i as f64 }));
}
