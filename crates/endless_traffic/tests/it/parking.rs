//! Drivers who park at the kerb, and pull out.

use crate::bus_stops::ring_of;
use crate::watch;
use endless_road::{Lane, RoadNetwork};
use endless_traffic::{Fleet, Simulation, TrafficAudit, TrafficSettings};
use endless_world::{
    Motion, ParkedVehicle, Parking, ParkingBay, Pose, Side, VehicleLights, VehicleModelId, VehicleRef,
};
use glam::Vec3;
use std::collections::BTreeMap;

const FPS: f64 = 30.0;
const WIDTH_M: f64 = 2.2;

/// Bays all along the outer lanes.
fn bays(network: &RoadNetwork) -> Vec<ParkingBay> {
    let of = |lane: &Lane| {
        let line = lane.centerline.clone();
        let left_m = -0.5 * (lane.width_m + WIDTH_M);
        (1..(line.length() / 5.9) as u32 - 1).map(move |k| {
            let s = 5.9 * f64::from(k);
            let position = line.position(s) + (line.direction(s).perp() * left_m).extend(0.0);
            let yaw_rad = line.at(s).heading_rad as f32;
            ParkingBay { position: position.as_vec3(), yaw_rad, length_m: 5.7, width_m: WIDTH_M as f32 }
        })
    };
    network.lanes.iter().filter(|lane| lane.right.is_none()).flat_map(of).collect()
}

/// In all bays but each of these many stands somebody.
fn parked(bays: &[ParkingBay], free: impl Fn(usize) -> bool) -> Vec<ParkedVehicle> {
    let specs = watch::specs();
    let car = specs.iter().position(|spec| spec.class == endless_world::ObjectClass::Car).expect("a car");
    let vehicle = VehicleRef { model: VehicleModelId::from_index(car), variant: 1 };
    let taken = bays.iter().enumerate().filter(|(k, _)| !free(*k));
    taken.map(|(_, bay)| ParkedVehicle { vehicle, pose: Pose::level(bay.position, bay.yaw_rad) }).collect()
}

/// How often vehicles did each of what there is to do, with lamps and indicators as they should be; the audit is content.
fn counts(parking_bays: Vec<ParkingBay>, standing: &[ParkedVehicle], share: f64, seconds: f64) -> [usize; 3] {
    let network = ring_of(true);
    let specs = watch::specs();
    let mut settings =
        TrafficSettings { vehicles: 40, pedestrians: 0, seed: 3, fps: FPS, parking_bays, ..Default::default() };
    settings.profile.parked = share;
    let fleet = Fleet { vehicles: &specs, pedestrian: &|_| endless_world::walking::PedestrianSpec::default() };
    let mut simulation = Simulation::new(&network, &fleet, standing, &settings).expect("few enough");
    let audit = TrafficAudit::new(&network, &specs, simulation.parked(), FPS);
    let mut audit = audit.with_parking_bays(&settings.parking_bays);
    let mut before: BTreeMap<u16, (Parking, f64, Vec3)> = BTreeMap::new();
    let mut counts = [0; 3];
    for _ in 0..(seconds * FPS) as usize {
        let state = simulation.state();
        audit.look(&state);
        for actor in &state.actors {
            let (Some(now), Motion::Vehicle(motion)) = (actor.behaviour.parking, actor.motion) else {
                before.remove(&actor.id.0);
                continue;
            };
            let at = actor.pose.position;
            let (last, since_s, from) = before.get(&actor.id.0).copied().unwrap_or((now, state.time_s, at));
            let is_new = !before.contains_key(&actor.id.0) || last != now;
            counts[now as usize] += usize::from(is_new);
            let since_s = if is_new { state.time_s } else { since_s };
            before.insert(actor.id.0, (now, since_s, if is_new { at } else { from }));
            match now {
                Parking::PullingIn => assert_eq!(actor.behaviour.indicating, Some(Side::Right)),
                Parking::PullingOut => assert_eq!(actor.behaviour.indicating, Some(Side::Left)),
                Parking::Parked => {
                    assert_eq!((actor.behaviour.lane, is_new || at.distance(from) < 0.01), (None, true));
                    let dark = motion.lights == VehicleLights::empty() && actor.behaviour.indicating.is_none();
                    let leaves = actor.behaviour.indicating == Some(Side::Left);
                    assert!(dark || leaves || state.time_s - since_s < 3.0, "{:?}", motion.lights);
                }
            }
        }
        simulation.tick();
    }
    let report = audit.report();
    assert!(report.passed(), "{report}");
    counts
}

#[test]
fn drivers_park_in_long_gaps_for_a_while_and_pull_out_again() {
    let bays = bays(&ring_of(true));
    let standing = parked(&bays, |k| k % 6 > 1);
    let [ins, stands, outs] = counts(bays, &standing, 1.0, 900.0);
    assert!(ins > 5 && outs > 5 && stands > ins, "{ins} in, {stands} parked, {outs} out");
}

#[test]
fn nobody_parks_where_there_is_no_room_or_nobody_is_to() {
    let all = bays(&ring_of(true));
    let singles = parked(&all, |k| k % 4 == 0);
    assert_eq!(counts(all.clone(), &singles, 1.0, 120.0), [0; 3], "bays of a vehicle's length alone");
    assert_eq!(counts(all, &[], 0.0, 120.0), [0; 3], "a share of none");
    assert_eq!(counts(Vec::new(), &[], 1.0, 120.0), [0; 3], "no bays");
}

#[test]
fn the_same_drivers_park_at_the_same_instants() {
    let all = bays(&ring_of(true));
    let standing = parked(&all, |k| k % 6 > 1);
    let run = || counts(all.clone(), &standing, 1.0, 200.0);
    assert_eq!(run(), run());
}
