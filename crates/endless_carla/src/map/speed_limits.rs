//! Signs of speed limits: where a street begins whose limit is another one, or that of no street before it. Our towns have
//! limits without plates, as lanes have them.

use super::signals::{SignKind, TrafficSign, box_of, standing_near, unit, volume_of};
use crate::frames;
use endless_asset::Prop;
use endless_road::{Lane, LaneId, opendrive};
use endless_town::Town;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Write as _;

/// A vehicle passes the sign in the first metres of its lane.
const PASSED_M: f64 = 4.0;
/// Half the height of a trigger box, metres.
const HALF_HEIGHT_M: f64 = 1.5;
/// From the beginning of the road to the sign, metres.
const BEHIND_M: f64 = 0.5;
/// From the edge of the road to the sign, metres.
const ASIDE_M: f64 = 0.8;
/// A plate that stands in the town is that of a sign no farther away, metres.
const PLATE_NEAR_M: f64 = 15.0;

/// A sign, and where the OpenDRIVE file has it.
pub(super) struct SpeedLimitSign {
    pub(super) sign: TrafficSign,
    road: u32,
    limit_kmh: u16,
    s: f64,
    t: f64,
    /// Numbers of the lanes for which it holds.
    lanes: Vec<i32>,
}

/// The signs of a town, by road.
pub(super) fn speed_limit_signs(town: &Town) -> Vec<SpeedLimitSign> {
    let network = &town.network;
    let names = opendrive::lane_names(network, town.streets.left_hand);
    let mut roads: BTreeMap<u32, Vec<(i32, &Lane)>> = BTreeMap::new();
    for (lane, name) in network.lanes.iter().zip(&names) {
        roads.entry(name.road).or_default().push((name.lane, lane));
    }
    let goes_on = |lane: &Lane| {
        let before = |id: &LaneId| network.lane(*id);
        lane.predecessors.iter().map(before).any(|other| other.junction.is_none() && kmh(other) == kmh(lane))
    };
    let mut signs = Vec::new();
    for (road, mut lanes) in roads {
        // Numbers fall from left to right.
        lanes.sort_by_key(|(number, _)| -number);
        let width_m: f64 = lanes.iter().map(|(_, lane)| lane.width_m).sum();
        let mut by_limit: BTreeMap<u16, Vec<(i32, &Lane)>> = BTreeMap::new();
        for (number, lane) in lanes.into_iter().filter(|(_, lane)| lane.junction.is_none()) {
            by_limit.entry(kmh(lane)).or_default().push((number, lane));
        }
        by_limit.retain(|_, lanes| !lanes.iter().any(|(_, lane)| goes_on(lane)));
        signs.extend(by_limit.into_iter().map(|(limit, lanes)| sign(town, road, limit, &lanes, width_m)));
    }
    signs
}

/// Its limit, kilometres an hour.
fn kmh(lane: &Lane) -> u16 {
    (lane.speed_limit_mps * 3.6).round().clamp(1.0, 1000.0) as u16
}

fn sign(town: &Town, road: u32, limit_kmh: u16, lanes: &[(i32, &Lane)], width_m: f64) -> SpeedLimitSign {
    let left_hand = town.streets.left_hand;
    let outermost = lanes[if left_hand { 0 } else { lanes.len() - 1 }].1;
    let s = BEHIND_M.min(0.5 * outermost.centerline.length());
    let start = outermost.centerline.at(s);
    let out = if left_hand { 1.0 } else { -1.0 };
    let aside = unit(start.heading_rad).perp() * (out * (0.5 * outermost.width_m + ASIDE_M));
    let plate = standing_near(town, start.position, start.heading_rad, PLATE_NEAR_M, |prop, _| prop == Prop::SpeedSign);
    let foot = plate.unwrap_or(start.position + aside.extend(0.0));
    let pole = frames::heading(foot, start.heading_rad - FRAC_PI_2, 0.0);
    let passed: Vec<_> = lanes.iter().map(|(_, lane)| passed(lane)).collect();
    SpeedLimitSign {
        sign: TrafficSign {
            sign_id: format!("speed_{limit_kmh}_{road}"),
            kind: SignKind::SpeedLimit(limit_kmh),
            trigger_boxes: passed.iter().map(box_of).collect(),
            trigger_volume: volume_of(&pole, &passed),
            pole,
        },
        road,
        limit_kmh,
        s,
        t: out * (width_m + ASIDE_M),
        lanes: lanes.iter().map(|(number, _)| *number).collect(),
    }
}

/// Middle, direction and half the size (along, across, up) of where a vehicle passes the sign.
fn passed(lane: &Lane) -> (DVec3, f64, DVec3) {
    let reach = PASSED_M.min(lane.centerline.length());
    let middle = lane.centerline.at(0.5 * reach);
    (middle.position, middle.heading_rad, DVec3::new(0.5 * reach, 0.45 * lane.width_m, HALF_HEIGHT_M))
}

/// An OpenDRIVE text of our own writer with these signs in it: CARLA's towns have them as signals of type 274.
pub(super) fn with_speed_limits(opendrive: &str, signs: &[SpeedLimitSign]) -> String {
    const ROAD: &str = "<road ";
    const NONE: &str = "<signals/>";
    const END: &str = "</signals>";
    let mut of_road: BTreeMap<u32, Vec<&SpeedLimitSign>> = BTreeMap::new();
    for sign in signs {
        of_road.entry(sign.road).or_default().push(sign);
    }
    let mut roads = opendrive.split(ROAD);
    let mut text = roads.next().unwrap_or_default().to_owned();
    for road in roads {
        text.push_str(ROAD);
        let signals: String =
            number(road).and_then(|id| of_road.get(&id)).into_iter().flatten().map(|s| signal(s)).collect();
        match (signals.is_empty(), road.split_once(NONE), road.split_once(END)) {
            (false, Some((before, after)), _) => {
                text.extend([before, "<signals>\n", &signals, "    </signals>", after]);
            }
            (false, None, Some((before, after))) => {
                text.extend([before, signals.trim_start_matches(' '), "    </signals>", after]);
            }
            _ => text.push_str(road),
        }
    }
    text
}

/// The id in a road's tag.
fn number(road: &str) -> Option<u32> {
    let tag = road.split('>').next()?;
    tag.split(" id=\"").nth(1)?.split('"').next()?.parse().ok()
}

fn signal(sign: &SpeedLimitSign) -> String {
    let SpeedLimitSign { sign: TrafficSign { sign_id, .. }, limit_kmh, s, t, lanes, .. } = sign;
    let mut text = format!(
        "      <signal s=\"{s:.4}\" t=\"{t:.4}\" id=\"{sign_id}\" name=\"Speed_{limit_kmh}\" dynamic=\"no\" orientation=\"+\" \
         zOffset=\"0\" country=\"OpenDRIVE\" type=\"274\" subtype=\"{limit_kmh}\" value=\"{limit_kmh}\" unit=\"km/h\" \
         hOffset=\"0\" pitch=\"0\" roll=\"0\" height=\"0.6\" width=\"0.6\">\n"
    );
    for lane in lanes {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "        <validity fromLane=\"{lane}\" toLane=\"{lane}\"/>");
    }
    text + "      </signal>\n"
}
