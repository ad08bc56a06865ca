//! Where bodies sweep that drive by: long ones cut in and swing out in bends, and bays keep clear of them.

use crate::dressing::road_furniture::parking_bay::ParkingBay;
use endless_road::swept::{DesignVehicle, OrientedRectangle, SweptPath, fits, smallest_radius_m};
use endless_road::{Lane, RoadNetwork};
use endless_world::{TrailerSpec, VehicleSpec};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Beside the middle of their lanes drivers keep within this, and bays are clear by as much of it as they do not use,
/// metres.
const ASIDE_M: f64 = 0.15;
/// Who still comes to its posture after a bend is looked at for this long, metres.
const RUN_OUT_M: f64 = 12.0;
/// Side of the bins in which bays are looked up, metres.
const BIN_M: f64 = 12.0;
/// Whose body begins this far from a bay does not touch it, metres; at least half the longest body and bay.
const NEAR_M: f64 = 14.0;
/// What is further above or below is on another level, metres.
const STOREY_M: f64 = 3.0;

/// Length and width of what goes everywhere: vans, and tractors of trailers, metres.
const EVERYWHERE_M: [f32; 2] = [6.49, 2.45];
/// Lengths of rigid lorries and buses, metres.
const LENGTHS_M: [f32; 8] = [12.6, 11.1, 10.1, 9.1, 8.9, 8.2, 7.4, 6.6];
/// Widest body, and what bodies are narrower than the lanes on which they fit, metres.
const WIDE_M: f32 = 2.55;
const NARROWER_M: f32 = 0.41;
/// Articulated bus, lorry with a semi-trailer, car with a trailer: size, axles of what draws, and what is drawn, metres.
const TRAILERS: [([f32; 2], [f32; 2], TrailerSpec); 3] = [
    ([18.5, 2.55], [6.4, 0.45], TrailerSpec { hitch_m: -2.0, axle_m: -7.0, front_m: -2.5, towing_rear_m: -2.0 }),
    ([16.5, 2.5], [7.0, 3.0], TrailerSpec { hitch_m: 4.0, axle_m: -4.0, front_m: 5.3, towing_rear_m: 2.3 }),
    ([8.0, 1.9], [3.1, 0.4], TrailerSpec { hitch_m: -0.8, axle_m: -3.1, front_m: -0.75, towing_rear_m: -0.7 }),
];

/// Which of these bays nobody touches who drives by.
pub(crate) fn clear_of_traffic(network: &RoadNetwork, bays: &[ParkingBay]) -> Vec<bool> {
    let mut clear = vec![true; bays.len()];
    let bin = |p: DVec2| (p / BIN_M).floor().as_ivec2();
    let mut bins: BTreeMap<[i32; 2], Vec<usize>> = BTreeMap::new();
    for (i, bay) in bays.iter().enumerate() {
        bins.entry(bin(bay.at.truncate()).to_array()).or_default().push(i);
    }
    let near = |p: DVec3| {
        let (low, high) = (bin(p.truncate() - NEAR_M), bin(p.truncate() + NEAR_M));
        let all = (low.x..=high.x).flat_map(move |x| (low.y..=high.y).map(move |y| [x, y]));
        all.filter_map(|bin| bins.get(&bin)).flatten().copied().filter(move |&i| (bays[i].at.z - p.z).abs() < STOREY_M)
    };
    let prints: Vec<OrientedRectangle> =
        bays.iter().map(|bay| OrientedRectangle::of(bay.room / 2.0, bay.at.truncate(), bay.yaw)).collect();
    for lane in &network.lanes {
        let line = &lane.centerline;
        let places = (0..=(line.length() / BIN_M).ceil() as usize).map(|k| line.position(BIN_M * k as f64));
        if places.clone().all(|p| near(p).next().is_none()) {
            continue;
        }
        for body in design_vehicles(network, lane) {
            let (from, to) = (-body.half.x, line.length() + body.half.x + RUN_OUT_M);
            for (print, z) in SweptPath::between(network, lane, body, from, to).footprints() {
                for i in near(print.center.extend(z)) {
                    clear[i] &= !print.overlaps(&prints[i]);
                }
            }
        }
    }
    clear
}

/// The bodies for which room is kept on a lane: what goes everywhere, the longest lorry and bus that fit, and those who
/// draw trailers. They do not follow from the catalogue, so that a design more in it moves no parked car; that every
/// design of it passes is tested.
fn design_vehicles(network: &RoadNetwork, lane: &Lane) -> Vec<DesignVehicle> {
    let radius_m = smallest_radius_m(&lane.centerline);
    let fitting = |spec: &VehicleSpec| fits(network, lane, radius_m, spec);
    let wide = (lane.width_m as f32 - NARROWER_M).min(WIDE_M);
    // A lorry has its engine before its front axle, a bus its door.
    let longest = |axles: [f32; 2]| {
        LENGTHS_M.iter().map(|&length| body([length, wide], axles.map(|x| x * length), None)).find(fitting)
    };
    let [bus, semi, car] = TRAILERS.map(|(size, axles, trailer)| Some(body(size, axles, Some(trailer))));
    let everywhere = Some(body(EVERYWHERE_M, [0.34, -0.27].map(|x| x * EVERYWHERE_M[0]), None));
    let all = [everywhere, longest([0.345, -0.215]), longest([0.265, -0.225]), bus, semi, car];
    all.into_iter().flatten().filter(fitting).map(|spec| DesignVehicle::around([&spec], ASIDE_M)).collect()
}

fn body([length_m, width_m]: [f32; 2], axles: [f32; 2], trailer: Option<TrailerSpec>) -> VehicleSpec {
    let [front_axle_m, rear_axle_m] = axles;
    VehicleSpec { length_m, width_m, front_axle_m, rear_axle_m, trailer, ..VehicleSpec::default() }
}
