//! Traffic lights and signs where the exported OpenDRIVE file has them.

use super::light_plan::LightPlan;
use crate::frames;
use crate::wire::{BoundingBox, Location, Rotation, Transform, Vector3D};
use endless_asset::Prop;
use endless_road::{Lane, LaneId, TrafficControl, opendrive};
use endless_town::{PlacedObject, Town};
use endless_world::SignalId;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;

/// A vehicle stands at a light this long before the stop line, seconds at the speed limit: CARLA's traffic manager brakes
/// as soon as it stands there, however far the line is.
const TRIGGER_S: f64 = 0.5;
/// And at least and at most, metres.
const TRIGGER_M: [f64; 2] = [4.0, 12.0];
/// Half the height of a trigger box, metres.
const TRIGGER_HALF_M: f64 = 1.5;
/// Share of a lane's width that its trigger box has.
const TRIGGER_WIDTH: f64 = 0.9;
/// A pole stands no farther than this from the stop line, metres.
const POLE_NEAR_M: f64 = 45.0;
/// From the edge of the road to a pole of which nothing is known, metres.
const ASIDE_M: f64 = 0.8;

/// A traffic light: all that the lanes of one road see of one signal.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficLight {
    /// Id of the signal in the OpenDRIVE file.
    pub sign_id: String,
    /// The signal in our own network.
    pub signal: SignalId,
    /// The lanes that it holds up, from left to right.
    pub lanes: Vec<LaneId>,
    /// The foot of its pole, in the world. As CARLA's poles do, it looks to the right of the traffic that it holds up.
    pub pole: Transform,
    /// Where a vehicle stands at the light, in the world: the last metres of each lane.
    pub trigger_boxes: Vec<BoundingBox>,
    /// The same as one box in the frame of the pole.
    pub trigger_volume: BoundingBox,
    /// The lights of one junction have the same number.
    pub group: u32,
    /// Lights of a group with the same number are green together.
    pub stage: u32,
    /// Number in its group.
    pub pole_index: u32,
}

/// What a sign says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum SignKind {
    /// Stop.
    Stop,
    /// Give way.
    Yield,
    /// No faster than so many kilometres an hour.
    SpeedLimit(u16),
}

impl SignKind {
    /// The name of CARLA's blueprint: there are speed limits of every ten to 130.
    pub fn blueprint(self) -> String {
        match self {
            Self::Stop => "traffic.stop".to_owned(),
            Self::Yield => "traffic.yield".to_owned(),
            Self::SpeedLimit(kmh) => format!("traffic.speed_limit.{}", 10 * ((kmh + 5) / 10).clamp(1, 13)),
        }
    }
}

/// A traffic sign.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficSign {
    /// Id of the signal in the OpenDRIVE file.
    pub sign_id: String,
    /// What it says.
    pub kind: SignKind,
    /// The foot of its pole, in the world, turned as lights are.
    pub pole: Transform,
    /// Where a vehicle stands at the sign, in the world.
    pub trigger_boxes: Vec<BoundingBox>,
    /// The same as one box in the frame of the pole.
    pub trigger_volume: BoundingBox,
}

/// The lights and signs of a town, by road.
pub(super) fn signals(town: &Town) -> (Vec<TrafficLight>, Vec<TrafficSign>) {
    let plan = LightPlan::new(&town.network);
    let (mut lights, mut signs) = (Vec::new(), Vec::new());
    let mut in_group: BTreeMap<u32, u32> = BTreeMap::new();
    for ((road, control), lanes) in by_road(town) {
        let approach = Approach { town, lanes: &lanes };
        let pole = approach.pole(control);
        let (trigger_boxes, trigger_volume) = (approach.boxes(), approach.volume(&pole));
        let sign = |kind: SignKind, word: &str| TrafficSign {
            sign_id: format!("{word}_{road}"),
            kind,
            pole: pole.clone(),
            trigger_boxes: trigger_boxes.clone(),
            trigger_volume: trigger_volume.clone(),
        };
        match control {
            Control::Stop => signs.push(sign(SignKind::Stop, "stop")),
            Control::Yield => signs.push(sign(SignKind::Yield, "yield")),
            Control::Signal(signal) => {
                let (group, stage) = plan.place_of(signal);
                let next = in_group.entry(group).or_default();
                let pole_index = *next;
                *next += 1;
                let sign_id = format!("{}_{road}", signal.0);
                let lanes = lanes.iter().map(|lane| lane.id).collect();
                lights.push(TrafficLight {
                    sign_id,
                    signal,
                    lanes,
                    pole,
                    trigger_boxes,
                    trigger_volume,
                    group,
                    stage,
                    pole_index,
                });
            }
        }
    }
    (lights, signs)
}

/// A control that has a sign or a light.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Control {
    Signal(SignalId),
    Stop,
    Yield,
}

/// The lanes of every control of every road of the file, from left to right.
fn by_road(town: &Town) -> BTreeMap<(u32, Control), Vec<&Lane>> {
    let left_hand = town.streets.left_hand;
    let names = opendrive::lane_names(&town.network, left_hand);
    let mut found: BTreeMap<(u32, Control), Vec<(i32, &Lane)>> = BTreeMap::new();
    for (lane, name) in town.network.lanes.iter().zip(names) {
        let control = match lane.end_control {
            TrafficControl::Free => continue,
            TrafficControl::Signal(signal) => Control::Signal(signal),
            TrafficControl::Stop => Control::Stop,
            TrafficControl::Yield => Control::Yield,
        };
        found.entry((name.road, control)).or_default().push((name.lane, lane));
    }
    let mut ordered = BTreeMap::new();
    for (at, mut lanes) in found {
        // Numbers fall from left to right.
        lanes.sort_by_key(|(number, _)| -number);
        ordered.insert(at, lanes.into_iter().map(|(_, lane)| lane).collect());
    }
    ordered
}

/// Lanes side by side that end at one light or sign.
struct Approach<'a> {
    town: &'a Town,
    /// At least one, from left to right.
    lanes: &'a [&'a Lane],
}

impl Approach<'_> {
    /// The lane beside the pole.
    fn outermost(&self) -> &Lane {
        let place = if self.town.streets.left_hand { 0 } else { self.lanes.len() - 1 };
        self.lanes[place]
    }

    fn pole(&self, control: Control) -> Transform {
        let lane = self.outermost();
        let end = lane.centerline.at(lane.centerline.length());
        let aside = 0.5 * lane.width_m + ASIDE_M;
        let side = if self.town.streets.left_hand { aside } else { -aside };
        let beside = end.position + (unit(end.heading_rad).perp() * side).extend(0.0);
        let foot = self.standing(control, end.position, end.heading_rad).unwrap_or(beside);
        frames::heading(foot, end.heading_rad - FRAC_PI_2, 0.0)
    }

    /// The foot of the pole that stands in the town for a control, facing those who come.
    fn standing(&self, control: Control, end: DVec3, heading_rad: f64) -> Option<DVec3> {
        let near = if matches!(control, Control::Signal(_)) { POLE_NEAR_M } else { 10.0 };
        standing_near(self.town, end, heading_rad, near, |prop, shown| match (control, prop) {
            (Control::Signal(signal), prop) if prop.is_vehicle_signal() => shown == Some(signal),
            (Control::Stop, Prop::StopSign) | (Control::Yield, Prop::YieldSign) => true,
            _ => false,
        })
    }

    /// The last metres of each lane.
    fn boxes(&self) -> Vec<BoundingBox> {
        self.lanes.iter().map(|lane| box_of(&trigger(lane))).collect()
    }

    /// Around all of these, in the frame of the pole.
    fn volume(&self, pole: &Transform) -> BoundingBox {
        volume_of(pole, &self.lanes.iter().map(|lane| trigger(lane)).collect::<Vec<_>>())
    }
}

/// The foot of the nearest pole that shows something, faces those who come with a heading to a place, and is near that.
pub(super) fn standing_near(
    town: &Town,
    place: DVec3,
    heading_rad: f64,
    near_m: f64,
    shows: impl Fn(Prop, Option<SignalId>) -> bool,
) -> Option<DVec3> {
    let mut best: Option<(f64, DVec3)> = None;
    for placement in &town.placements {
        let PlacedObject::Prop(prop, _) = placement.object else { continue };
        let at = placement.world_from_object.translation.as_dvec3();
        let faces = placement.world_from_object.matrix3.x_axis.as_dvec3().truncate();
        let away = at.distance(place);
        let faced = faces.dot(unit(heading_rad)) < -0.5;
        let is_nearer = away < near_m && best.is_none_or(|(least, _)| away < least);
        if is_nearer && faced && shows(prop, placement.signal) {
            best = Some((away, at));
        }
    }
    best.map(|(_, at)| at)
}

/// A place where vehicles stand or pass, in the world: its middle, its direction and half its size (along, across, up).
pub(super) fn box_of((middle, heading_rad, half): &(DVec3, f64, DVec3)) -> BoundingBox {
    let pose = frames::heading(*middle + DVec3::Z * (TRIGGER_HALF_M - 0.5), *heading_rad, 0.0);
    BoundingBox { location: pose.location, extent: vector(*half), rotation: pose.rotation, actor_id: 0 }
}

/// The box around such places, in the frame of a pole.
pub(super) fn volume_of(pole: &Transform, places: &[(DVec3, f64, DVec3)]) -> BoundingBox {
    let origin = frames::from_carla(&pole.location).as_dvec3();
    let forward = unit(-f64::from(pole.rotation.yaw).to_radians());
    let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    for (middle, heading_rad, half) in places {
        let along = unit(*heading_rad);
        for (u, v) in [(1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0)] {
            let corner = *middle + (along * (u * half.x) + along.perp() * (v * half.y)).extend(0.0) - origin;
            // The frame of the pole has y to its right.
            let local = DVec2::new(corner.truncate().dot(forward), -forward.perp_dot(corner.truncate()));
            low = low.min(local.extend(corner.z - 0.5));
            high = high.max(local.extend(corner.z - 0.5 + 2.0 * TRIGGER_HALF_M));
        }
    }
    let middle = 0.5 * (low + high);
    BoundingBox {
        location: vector(middle),
        extent: vector(0.5 * (high - low)),
        rotation: Rotation::default(),
        actor_id: 0,
    }
}

/// Middle, direction and half the size (along, across, up) of the place where a vehicle on a lane stands at its end.
fn trigger(lane: &Lane) -> (DVec3, f64, DVec3) {
    let reach = (TRIGGER_S * lane.speed_limit_mps).clamp(TRIGGER_M[0], TRIGGER_M[1]).min(lane.centerline.length());
    let middle = lane.centerline.at(lane.centerline.length() - 0.5 * reach);
    let half = DVec3::new(0.5 * reach, 0.5 * TRIGGER_WIDTH * lane.width_m, TRIGGER_HALF_M);
    (middle.position, middle.heading_rad, half)
}

pub(super) fn unit(angle: f64) -> DVec2 {
    let (sin, cos) = sin_cos(angle);
    DVec2::new(cos, sin)
}

fn vector(v: DVec3) -> Vector3D {
    Vector3D { x: v.x as f32, y: v.y as f32, z: v.z as f32 }
}

/// Whether a place is in a box; both in the world.
pub(super) fn holds(bounds: &BoundingBox, place: &Location) -> bool {
    let away = frames::from_carla(place).as_dvec3() - frames::from_carla(&bounds.location).as_dvec3();
    let along = unit(-f64::from(bounds.rotation.yaw).to_radians());
    let local = DVec3::new(away.truncate().dot(along), along.perp_dot(away.truncate()), away.z);
    let half = DVec3::new(f64::from(bounds.extent.x), f64::from(bounds.extent.y), f64::from(bounds.extent.z));
    local.abs().cmple(half).all()
}
