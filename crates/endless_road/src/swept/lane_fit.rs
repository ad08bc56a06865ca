//! On which lanes a vehicle fits.

use super::drawbar::DRAWBAR;
use crate::{Lane, Polyline, RoadNetwork, Turn};
use endless_world::VehicleSpec;
use endless_world::math::f64::wrap_angle;

/// Vehicles longer than this are long: they do not fit everywhere, metres.
pub const LONG_M: f64 = 6.5;
/// Vehicles longer than this are given more room where ways meet in bends, metres.
pub const SWINGS_OUT_M: f64 = 5.4;
/// Distance between the places at which bends are looked at, metres.
const STATION_M: f64 = 1.0;
/// Long vehicles need right turns of this many lengths, or their rear wheels would climb the kerb.
const LONG_RADIUS: f64 = 1.3;
/// And left turns of this many: the ground inside them is the junction's own, kept free for them.
const LONG_RADIUS_LEFT: f64 = 0.9;
/// And of this many where nobody makes room for them: beside oncoming traffic.
const LONG_RADIUS_BESIDE_OTHERS: f64 = 2.6;
/// And of this many where they arrive beside the kerb: their front corner would sweep over who waits there.
const LONG_RADIUS_LEFT_TO_KERB: f64 = 1.8;
/// Long vehicles need lanes wider than they are by this, metres.
const BESIDE_M: f64 = 0.4;
/// Vehicles longer than this keep to streets of several lanes, metres.
const BUS_M: f64 = 9.0;
/// Width of the widest vehicles and what they keep from the middle of their lanes, metres.
const WIDEST_M: f64 = 2.8;
/// Beside the middle of their lanes drivers of long vehicles keep within this, metres.
const STEERS_M: f64 = 0.05;
/// Vehicles of two pieces turn like rigid ones this many times as long as the longer piece.
const BENDS: f64 = 1.15;

/// How much a line bends at `s`, radians a metre, over four metres of it.
pub fn curvature_per_m(line: &Polyline, s: f64) -> f64 {
    mean_curvature_per_m(line, s, 4.0)
}

/// How much a line bends at `s`, radians a metre, over some metres of it.
pub fn mean_curvature_per_m(line: &Polyline, s: f64, over_m: f64) -> f64 {
    let (before, after) = ((s - 0.5 * over_m).max(0.0), (s + 0.5 * over_m).min(line.length()));
    let turn = wrap_angle(line.at(after).heading_rad - line.at(before).heading_rad).abs();
    turn / (after - before).max(0.5)
}

/// Radius of the tightest bend of a line, metres.
pub fn smallest_radius_m(line: &Polyline) -> f64 {
    let stations = (line.length() / STATION_M).ceil() as usize + 1;
    let bends = (0..stations).map(|i| curvature_per_m(line, (i as f64 * STATION_M).min(line.length())));
    1.0 / bends.fold(1e-6, f64::max)
}

/// Whether a vehicle fits on a lane whose tightest bend has this radius ([`smallest_radius_m`]): short ones do
/// everywhere, long ones where it is wide enough and does not bend too tightly for them.
pub fn fits(network: &RoadNetwork, lane: &Lane, radius_m: f64, spec: &VehicleSpec) -> bool {
    let length_m = f64::from(spec.length_m);
    if length_m < LONG_M {
        return true;
    }
    // What bends turns like its longest piece, and a little wider.
    let rigid_m = f64::from(spec.rigid_length_m()) * if spec.trailer.is_some() { BENDS } else { 1.0 };
    let lengths = match (lane.junction, lane.turn) {
        (None, _) => LONG_RADIUS_BESIDE_OTHERS,
        (Some(_), Turn::Left) if lane.successors.iter().all(|&to| network.lane(to).right.is_some()) => LONG_RADIUS_LEFT,
        (Some(_), Turn::Left) => LONG_RADIUS_LEFT_TO_KERB,
        (Some(_), _) => LONG_RADIUS,
    };
    let broad = lane.junction.is_some() || lane.left.is_some() || lane.right.is_some();
    let wide = lane.width_m > f64::from(spec.width_m) + BESIDE_M;
    // Two long ones side by side would touch in a bend: those that stray from their lanes keep to the last one.
    let last = lane.junction.is_some() || lane.right.is_none();
    // There they leave room for the widest that keep to theirs.
    let is_beside = lane.junction.is_none() && lane.left.is_some();
    let leaves_room = || !is_beside || strays_m(spec, radius_m) + STEERS_M < lane.width_m - 0.5 * WIDEST_M;
    let alone = || last && leaves_room() || strays_m(spec, radius_m) + STEERS_M < 0.5 * lane.width_m;
    wide && radius_m > lengths * rigid_m && (broad || length_m < BUS_M) && alone()
}

/// Whether a vehicle that fits on a lane leaves room there for one as long that comes the other way: on a street with one
/// lane each way both must keep to their lanes.
pub fn leaves_oncoming_room(lane: &Lane, radius_m: f64, spec: &VehicleSpec) -> bool {
    let alone = lane.junction.is_none() && lane.left.is_none() && lane.right.is_none();
    let short = f64::from(spec.length_m) < LONG_M;
    short || !alone || strays_m(spec, radius_m) + STEERS_M < 0.5 * lane.width_m
}

/// How far from the line that it follows a vehicle reaches to either side in a long bend of this radius, metres: its
/// front sweeps outwards, its rear and what it draws inwards.
fn strays_m(spec: &VehicleSpec, radius_m: f64) -> f64 {
    let across = 0.5 * f64::from(spec.width_m);
    let far = |a: f64, b: f64| (a * a + b * b).sqrt();
    let leg = |hypotenuse: f64, other: f64| (hypotenuse * hypotenuse - other * other).max(0.0).sqrt();
    let [front, rear] = [spec.front_axle_m, spec.rear_axle_m].map(f64::from);
    // Radii on which rear axle, hitch and trailer run about the same middle.
    let axle = leg(radius_m, DRAWBAR * (front - rear));
    let last = spec.trailer.map_or(axle, |t| {
        let [hitch, drawn] = [t.hitch_m, t.axle_m].map(f64::from);
        leg(far(axle, hitch - rear), hitch - drawn)
    });
    let outwards = far(axle + across, 0.5 * f64::from(spec.length_m) - rear) - radius_m;
    outwards.max(radius_m - last + across)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::LaneId;
    use glam::DVec3;

    #[test]
    fn long_vehicles_keep_to_the_last_lane_in_bends_and_to_any_on_straights() {
        let line = || Polyline::new([DVec3::ZERO, DVec3::X]);
        let mut left = Lane::new(LaneId(0), line(), 3.25, 14.0);
        let mut right = Lane::new(LaneId(1), line(), 3.25, 14.0);
        (left.right, right.left) = (Some(LaneId(1)), Some(LaneId(0)));
        let network = RoadNetwork { lanes: vec![left, right], ..RoadNetwork::default() };
        let bus = VehicleSpec {
            length_m: 12.0,
            width_m: 2.55,
            front_axle_m: 3.1,
            rear_axle_m: -2.7,
            ..VehicleSpec::default()
        };
        let allowed = |radius_m| [0, 1].map(|k| fits(&network, &network.lanes[k], radius_m, &bus));
        assert_eq!([allowed(25.0), allowed(50.0), allowed(400.0)], [[false; 2], [false, true], [true; 2]]);
        // Here its front would meet the side of the widest beside it.
        assert_eq!(allowed(36.0), [false; 2]);
        // Alone on its side of the street it meets another one.
        let alone = Lane::new(LaneId(0), line(), 3.25, 14.0);
        assert_eq!(
            [25.0, 40.0, 400.0].map(|radius_m| leaves_oncoming_room(&alone, radius_m, &bus)),
            [false, false, true]
        );
        assert!(leaves_oncoming_room(&network.lanes[0], 25.0, &bus), "beside others it is not alone");
        // In a bend of 40 m its front sweeps 0.6 m further than its side.
        assert!((strays_m(&bus, 40.0) - 1.9).abs() < 0.1, "{}", strays_m(&bus, 40.0));
    }
}
