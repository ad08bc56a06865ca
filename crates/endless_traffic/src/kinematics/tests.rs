use super::*;
use crate::driver::Driver;
use crate::settings::DrivingCondition;
use crate::trailer::TrailerState;
use crate::{Focus, TrafficMap};
use endless_asset::Catalogue;
use endless_road::Turn;
use endless_world::{Stream, VehicleModelId, VehicleRef, VehicleSpec};
use glam::DVec2;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Between the outermost lane and the kerb, metres.
const GUTTER_M: f64 = 0.3;

/// Where the outer faces of the four tyres stand.
fn tyres(vehicle: &Vehicle, spec: &VehicleSpec) -> [DVec2; 4] {
    let (sin, cos) = sin_cos(vehicle.yaw);
    let (ahead, left) = (DVec2::new(cos, sin), DVec2::new(-sin, cos));
    let place = |x: f32, side: f64| {
        let across = side * (0.5 * f64::from(spec.width_m) - 0.05);
        vehicle.pose.position.as_dvec3().truncate() + ahead * f64::from(x) + left * across
    };
    [(spec.front_axle_m, 1.0), (spec.front_axle_m, -1.0), (spec.rear_axle_m, 1.0), (spec.rear_axle_m, -1.0)]
        .map(|(x, side)| place(x, side))
}

/// The outer faces of the tyres in the middle of what is drawn.
fn drawn_tyres(trailer: &TrailerState, spec: &VehicleSpec) -> [DVec2; 2] {
    let (sin, cos) = sin_cos(trailer.yaw);
    let across = DVec2::new(-sin, cos) * (0.5 * f64::from(spec.width_m) - 0.05);
    [trailer.axle() + across, trailer.axle() - across]
}

#[test]
fn long_vehicles_keep_their_wheels_on_the_road_in_turns() {
    let catalogue = Catalogue::builtin();
    let specs: Vec<VehicleSpec> = catalogue.vehicle_specs();
    let turns = [AtomicUsize::new(0), AtomicUsize::new(0)];
    endless_town::NAMES.par_iter().for_each(|name| {
        let town = endless_town::load(name, &catalogue).expect("a town");
        let roads = Roads::new(&TrafficMap::new(town.network, &specs), &Focus::default(), &[]);
        let network = &roads.network;
        for (model, spec) in specs.iter().enumerate().filter(|(_, s)| s.length_m > 6.5) {
            let allowed = roads.allowed(VehicleModelId::from_index(model));
            for lane in network.lanes.iter().filter(|l| allowed[l.id.index()] && l.turn != Turn::Straight) {
                let (before, after) = (lane.predecessors[0], lane.successors[0]);
                let mut stream = Stream::new(1, &[]);
                let mut driver = Driver::new(spec, &DrivingCondition::default(), 0.5, &mut stream);
                driver.lateral_m = 0.0;
                let start = (network.lane(before).centerline.length() - 25.0).max(0.0);
                let asset = VehicleRef { model: VehicleModelId::from_index(model), variant: 0 };
                let mut bus = Vehicle::new(spec, asset, driver, before, start, stream);
                bus.route.extend([lane.id, after]);
                settle(&mut bus, &roads);
                bus.speed = 4.0;
                let way = 25.0 + lane.centerline.length() + network.lane(after).centerline.length().min(40.0) - 9.0;
                turns[usize::from(lane.turn == Turn::Left)].fetch_add(1, Ordering::Relaxed);
                for step in 0..(way / 4.0 * 30.0) as usize {
                    advance(&mut bus, &roads, 1.0 / 30.0);
                    // Every 40 cm: the way of a tyre is smooth.
                    if step % 3 > 0 {
                        continue;
                    }
                    // To the left the ground inside is the junction's own: room is kept for what is drawn there.
                    let towed = bus.trailer.filter(|_| lane.turn != Turn::Left).map(|t| drawn_tyres(&t, spec));
                    for tyre in tyres(&bus, spec).into_iter().chain(towed.into_iter().flatten()) {
                        check(&roads, [before, lane.id, after], tyre, &format!("{name} {} {:?}", spec.name, lane.turn));
                    }
                }
            }
        }
    });
    assert!(turns.iter().all(|n| n.load(Ordering::Relaxed) > 20), "{turns:?} right and left turns");
}

/// On a street's lane a tyre keeps to it; inside a junction it may cut the corner to the left, but not over the kerb.
fn check(roads: &Roads, way: [LaneId; 3], tyre: DVec2, what: &str) {
    let (s, t, lane) = way
        .map(|id| {
            let lane = roads.network.lane(id);
            let (s, t) = lane.centerline.project(tyre);
            (s, t, lane)
        })
        .into_iter()
        .filter(|&(s, _, lane)| s > 0.0 && s < lane.centerline.length())
        .min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
        .unwrap_or((0.0, 0.0, roads.network.lane(way[1])));
    let edge = 0.5 * lane.width_m + GUTTER_M;
    if lane.turn != Turn::Left {
        assert!(t.abs() < edge, "{what}: a tyre {t:.2} m beside a lane of {} m at {s:.1} m", lane.width_m);
    } else {
        assert!(t > -3.0 && t < 2.8, "{what}: a tyre {t:.2} m beside its way at {s:.1} m");
    }
}
