//! Deliveries: vans and lorries that stand in the lane at the kerb for a minute or two, hazard lights on, where others can pass on
//! another lane.

use crate::bus_stop::BusHalts;
use crate::emergency::is_emergency;
use crate::kerb_halt::KerbHalt;
use crate::kerb_room::{is_straight, kerb_m, kerb_side, left_m, room_ahead, room_behind, sign};
use crate::occupancy::Occupancy;
use crate::roads::Roads;
use crate::vehicle::Vehicle;
use endless_road::swept::OrientedRectangle;
use endless_road::{Lane, LaneId};
use endless_world::{ObjectClass, Side, Stream};

/// The share of vans and lorries that deliver on a working day.
pub const USUAL_DELIVERIES: f64 = 0.5;
/// Somebody who delivers looks at a place so often on average, seconds; most do not suit.
const EVERY_S: f64 = 12.0;
/// For how long they stand, seconds.
const STANDS_S: [f64; 2] = [60.0, 110.0];
/// Longer vehicles do not deliver in streets, metres.
const LONGEST_M: f64 = 9.0;
/// Nor does anybody where others are faster, m/s.
const FASTEST_MPS: f64 = 17.0;
/// Room beyond the place and before it to junctions and crossings, metres, for those who change lanes.
const ROOM_M: [f64; 2] = [20.0, 40.0];
/// Nobody stands ahead within this of the place, metres.
const ALONE_M: f64 = 15.0;
/// Buses reach their stops, metres.
const FROM_STOPS_M: f64 = 50.0;
/// A place is looked for from where they can halt to so much further, metres.
const FURTHER_M: f64 = 80.0;

/// Who delivers, and where they cannot stand.
#[derive(Debug, Clone)]
pub(crate) struct Deliveries {
    /// Of vans and lorries, 0 to 1.
    share: f64,
    standing: Vec<OrientedRectangle>,
}

impl Deliveries {
    pub(crate) fn new(share: f64, standing: &[OrientedRectangle]) -> Self {
        Self { share, standing: if share > 0.0 { standing.to_vec() } else { Vec::new() } }
    }

    /// Somebody who delivers may find a place. To be called once a second.
    pub(crate) fn look_out(
        &self,
        roads: &Roads,
        occupancy: &Occupancy,
        halts: &BusHalts,
        vehicles: &mut [Vehicle],
        i: usize,
    ) {
        let me = &vehicles[i];
        let busy = me.kerb_halt.is_some() || me.order.is_some() || me.shift.is_some() || me.intent.is_some();
        if self.share > 0.0 && !busy && self.delivers(roads, me) {
            vehicles[i].kerb_halt = self.place(roads, occupancy, halts, vehicles, i);
        }
    }

    fn delivers(&self, roads: &Roads, vehicle: &Vehicle) -> bool {
        let class = matches!(vehicle.class, ObjectClass::Van | ObjectClass::Truck);
        class
            && !is_emergency(roads.specs[vehicle.asset.model.index()].name)
            && vehicle.trailer.is_none()
            && 2.0 * vehicle.half_length < LONGEST_M
            && Stream::named(vehicle.asset.variant, "traffic.deliverer", &[]).chance(self.share)
    }

    fn place(
        &self,
        roads: &Roads,
        occupancy: &Occupancy,
        halts: &BusHalts,
        vehicles: &[Vehicle],
        i: usize,
    ) -> Option<KerbHalt> {
        let me = &vehicles[i];
        let mut own = Stream::named(me.asset.variant, "traffic.delivery", &[me.rolled.to_bits()]);
        if me.speed < 2.0 || !own.chance(1.0 / EVERY_S) {
            return None;
        }
        let ahead_m = KerbHalt::least_ahead_m(me.speed) + own.range_f64(0.0, FURTHER_M);
        let (lane, base) = me.ahead(roads).take_while(|(_, base)| *base <= ahead_m).last()?;
        let lane = roads.network.lane(lane);
        let front = ahead_m + me.half_length - base;
        if !suits(roads, lane, front, me) {
            return None;
        }
        let reach = ahead_m + me.half_length + ALONE_M;
        let leader = occupancy.leader(roads, vehicles, i, reach);
        let alone = leader.is_none_or(|leader| leader.gap > ahead_m + ALONE_M || leader.speed > me.speed.max(4.0));
        let stop_near = |lane: LaneId| halts.on(lane).iter().any(|halt| (halt.s - front).abs() < FROM_STOPS_M);
        if !alone || stop_near(lane.id) {
            return None;
        }
        let side = if kerb_side(roads, lane, front)? > 0.0 { Side::Left } else { Side::Right };
        let passed_by = if side == Side::Left { lane.right } else { lane.left };
        passed_by?;
        let along = [front - 60.0, front + 40.0];
        let kerb_m = kerb_m(lane, along, sign(side), &self.standing);
        let width_m = f64::from(roads.specs[me.asset.model.index()].width_m);
        let left_m = left_m(side, kerb_m, width_m);
        let stands_s = own.range_f64(STANDS_S[0], STANDS_S[1]);
        Some(
            KerbHalt::new(me.driver.lateral_m, (lane.id, front, ahead_m), (side, left_m), stands_s)
                .with_hazard_lights(),
        )
    }
}

/// Whether others can get past somebody whose front is at this place of a lane.
fn suits(roads: &Roads, lane: &Lane, front: f64, me: &Vehicle) -> bool {
    let [beyond_m, before_m] = ROOM_M;
    lane.junction.is_none()
        && lane.speed_limit_mps < FASTEST_MPS
        && (lane.left.is_some() || lane.right.is_some())
        && is_straight(lane, front)
        && room_ahead(roads, lane, front) > beyond_m
        && room_behind(roads, lane, front) > 2.0 * me.half_length + before_m
}
