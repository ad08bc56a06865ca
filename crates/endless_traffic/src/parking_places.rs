//! Where drivers can park: bays at kerbs that a car gets into and out of forwards.

use crate::bus_stop::BusHalts;
use crate::driver::Driver;
use crate::kerb_room::{is_straight, room_ahead, room_behind};
use crate::parking_manoeuvre::bay_way;
use crate::parking_place::{NEAR_M, ParkingPlace, body};
use crate::roads::{RoadTables, Roads};
use crate::settings::DrivingCondition;
use crate::vehicle::Vehicle;
use endless_road::swept::OrientedRectangle;
use endless_road::{Lane, LaneId};
use endless_world::math::f64::{cos, wrap_angle};
use endless_world::{ObjectClass, ParkingBay, Side, Stream, VehicleModelId, VehicleRef, VehicleSpec};
use glam::{DVec2, DVec3};

/// A bay's inner edge is so near to the edge of its lane, metres: over it, beside it.
const OVER_M: f64 = 0.15;
const BESIDE_M: f64 = 0.5;
/// It lies along its lane to this angle, radians.
const ALONG_RAD: f64 = 0.06;
/// Its lane is on the same level, metres.
const STOREY_M: f64 = 1.0;
/// Room to the next junction or crossing beyond a place and before it, metres.
const ROOM_M: [f64; 2] = [14.0, 12.0];
/// Nobody parks where others are faster, m/s.
const FASTEST_MPS: f64 = 17.0;
/// Buses reach their stops, metres.
const FROM_STOPS_M: f64 = 55.0;
/// A car that fits in most places, metres.
const USUAL_M: f32 = 4.4;

/// All of a map among these bodies, by lane, and the number of bays along lanes, taken ones too.
pub(crate) fn parking_places(
    roads: &Roads,
    bays: &[ParkingBay],
    standing: &[OrientedRectangle],
    halts: &BusHalts,
) -> (Vec<ParkingPlace>, usize) {
    let Some(usual) = usual_car(roads) else { return (Vec::new(), 0) };
    let bodies: Vec<OrientedRectangle> = bays.iter().map(body).collect();
    let beside = LanesBeside::new(roads);
    let mut at_lanes = 0;
    let mut places = Vec::new();
    for (bay, body) in bays.iter().zip(&bodies) {
        let Some((lane, s, left_m)) = beside.lane_of(bay) else { continue };
        at_lanes += 1;
        let near = |other: &&OrientedRectangle| other.center.distance(body.center) < NEAR_M;
        if standing.iter().any(|other| near(&other) && other.overlaps(body)) || !suits(roads, halts, lane, s) {
            continue;
        }
        let place = ParkingPlace {
            lane: lane.id,
            s,
            left_m,
            edge_m: 0.5 * lane.width_m,
            side: if left_m > 0.0 { Side::Left } else { Side::Right },
            at: body.center,
            room: 2.0 * body.half,
            standing: standing.iter().filter(near).copied().collect(),
            bays: bodies.iter().filter(near).copied().collect(),
        };
        if bay_way(roads, &usual, &place, places.len()).is_some() {
            places.push(place);
        }
    }
    places.sort_by(|a, b| a.lane.cmp(&b.lane).then(a.s.total_cmp(&b.s)));
    (places, at_lanes)
}

/// Whether one can stand there without being in the way of junctions, crossings and buses.
fn suits(roads: &RoadTables, halts: &BusHalts, lane: &Lane, s: f64) -> bool {
    let [beyond_m, before_m] = ROOM_M;
    lane.speed_limit_mps < FASTEST_MPS
        && is_straight(lane, s + 12.0)
        && is_straight(lane, s)
        && room_ahead(roads, lane, s) > beyond_m
        && room_behind(roads, lane, s) > before_m
        && halts.on(lane.id).iter().all(|halt| (halt.s - s).abs() > FROM_STOPS_M)
}

/// A short car as there are many.
fn usual_car(roads: &Roads) -> Option<Vehicle> {
    let fits = |(_, spec): &(usize, &VehicleSpec)| {
        spec.class == ObjectClass::Car && spec.trailer.is_none() && spec.length_m <= USUAL_M
    };
    let (model, spec) =
        roads.specs.iter().enumerate().filter(fits).max_by(|a, b| a.1.length_m.total_cmp(&b.1.length_m))?;
    let mut stream = Stream::named(0, "traffic.parking.usual_car", &[]);
    let driver = Driver { lateral_m: 0.0, ..Driver::new(spec, &DrivingCondition::default(), 0.5, &mut stream) };
    let asset = VehicleRef { model: VehicleModelId::from_index(model), variant: 0 };
    Some(Vehicle::new(spec, asset, driver, LaneId(0), 0.0, stream))
}

/// Lanes with a kerb, to be found by place.
struct LanesBeside<'a> {
    lanes: Vec<(&'a Lane, [DVec2; 2])>,
}

impl<'a> LanesBeside<'a> {
    fn new(roads: &'a Roads) -> Self {
        let lanes = roads.network.lanes.iter().filter(|lane| lane.junction.is_none());
        let lanes = lanes.filter(|lane| lane.left.is_none() || lane.right.is_none());
        let around = |lane: &'a Lane| {
            let length = lane.centerline.length();
            let places = (0..=(length / 10.0).ceil() as u32).map(|k| lane.centerline.position(10.0 * f64::from(k)));
            let around = places
                .map(DVec3::truncate)
                .fold([DVec2::INFINITY, DVec2::NEG_INFINITY], |[low, high], place| [low.min(place), high.max(place)]);
            (lane, around)
        };
        Self { lanes: lanes.map(around).collect() }
    }

    /// The lane along whose edge a bay lies, the bay's place on it, and how far to the left of its middle, metres.
    fn lane_of(&self, bay: &ParkingBay) -> Option<(&'a Lane, f64, f64)> {
        const REACH_M: f64 = 8.0;
        let at = bay.position.as_dvec3();
        let inside = |[low, high]: &[DVec2; 2]| {
            (at.truncate() - (*low - DVec2::splat(REACH_M))).min_element() > 0.0
                && (*high + DVec2::splat(REACH_M) - at.truncate()).min_element() > 0.0
        };
        let beside = |(lane, around): &(&'a Lane, [DVec2; 2])| {
            if !inside(around) {
                return None;
            }
            let (s, left_m) = lane.centerline.project(at.truncate());
            let on = lane.centerline.at(s);
            let gap_m = left_m.abs() - 0.5 * (lane.width_m + f64::from(bay.width_m));
            let neighbour = if left_m > 0.0 { lane.left } else { lane.right };
            let turned = wrap_angle(on.heading_rad - f64::from(bay.yaw_rad));
            let fits = (-OVER_M..BESIDE_M).contains(&gap_m)
                && neighbour.is_none()
                && cos(turned) > 0.0
                && turned.abs() < ALONG_RAD
                && (on.position.z - at.z).abs() < STOREY_M
                && s > 0.0
                && s < lane.centerline.length();
            fits.then_some((*lane, s, left_m))
        };
        self.lanes.iter().filter_map(beside).min_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))
    }
}
