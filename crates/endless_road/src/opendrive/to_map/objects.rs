//! What stands beside the road, and paint that files give as objects.

use super::super::document::{RoadObject, Signal, SignalPosition};
use super::super::geometry::RoadShape;
use super::lane_surfaces::KERB_M;
use super::outline::{corners, place, rectangle};
use super::sampled::SampledDocument;
use super::signal_meaning::{SignalMeaning, meaning};
use super::signals::SignalLanes;
use crate::{
    BuildingFootprint, ImportNote, LandUse, LandUseArea, LaneSurface, LaneType, MapObject, MapObjectKind, MarkingColor,
    Polyline, RoadMap, RoadMarking, RoadNetwork,
};
use endless_world::SignalId;
use endless_world::math::f64::wrap_angle;
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Smaller outlines are none, square metres.
const LEAST_M2: f64 = 1.0;
/// Objects given as paint are lines if they are this many times as long as wide.
const SLENDER: f64 = 3.0;

/// Adds signals, signs, objects, painted lines and parking bays to the map.
pub(super) fn add(
    sampled: &SampledDocument<'_>,
    governed: &SignalLanes<'_>,
    groups: &BTreeMap<&str, SignalId>,
    map: &mut RoadMap,
) {
    let mut strange: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    for shape in &sampled.roads {
        for signal in &shape.road.signals {
            if let Some(map_object) = signal_object((sampled, shape), signal, governed, groups, &map.network) {
                map.objects.push(map_object);
            }
        }
        for object in &shape.road.objects {
            if object.kind == "crosswalk" {
                continue;
            }
            if is_line(object) {
                map.markings.extend(line(shape, object));
            } else if object.kind == "parkingSpace" {
                map.lane_surfaces.extend(bay(shape, object));
            } else if object.kind == "building" {
                map.footprints.extend(building(shape, object));
            } else if object.kind == "trafficIsland" {
                map.lane_surfaces.extend(island(shape, object));
            } else if let Some((kind, outline)) = land(shape, object) {
                map.areas.push(LandUseArea { kind, outline, holes: Vec::new() });
            } else if let Some(kind) = object_kind(object) {
                stand(shape, object, &kind, &mut map.objects);
            } else {
                let name = if object.kind.is_empty() || object.kind == "-1" { &object.name } else { &object.kind };
                strange.entry(name.clone()).or_insert((object.line, 0)).1 += 1;
            }
        }
    }
    for (kind, (line, times)) in strange {
        let text = format!("objects of type \"{kind}\" are not placed ({times})");
        map.notes.push(ImportNote { place: format!("line {line}"), text });
    }
}

fn signal_object(
    (sampled, shape): (&SampledDocument<'_>, &RoadShape<'_>),
    signal: &Signal,
    governed: &SignalLanes<'_>,
    groups: &BTreeMap<&str, SignalId>,
    network: &RoadNetwork,
) -> Option<MapObject> {
    use super::super::document::SignalOrientation;
    let position = match &signal.position {
        Some(SignalPosition::Inertial([x, y, z])) => DVec3::new(*x, *y, *z),
        Some(SignalPosition::Road(road, [s, t])) => {
            sampled.road(road).map_or(shape, |place| &sampled.roads[place]).point(*s, *t)
        }
        None => shape.point(signal.s, signal.t),
    };
    // The direction of the traffic it is for; where that is not known, as it is turned.
    let lanes = governed.get(signal.id.as_str()).into_iter().flatten();
    let nearest = lanes
        .map(|&id| network.lane(id))
        .map(|lane| lane.centerline.at(lane.centerline.length()))
        .min_by(|a, b| a.position.distance(position).total_cmp(&b.position.distance(position)));
    let turned = if signal.orientation == SignalOrientation::Against { PI } else { 0.0 };
    let heading = shape.pose(signal.s).heading + turned + signal.h_offset;
    let heading_rad = nearest.map_or(wrap_angle(heading), |end| end.heading_rad);
    let kind = match meaning(signal) {
        // A light that governs nothing that is driven is not lit, and not placed.
        SignalMeaning::Light => MapObjectKind::TrafficLight(*groups.get(signal.id.as_str())?),
        SignalMeaning::WalkLight => {
            let crossing = network.crossings.iter().filter(|c| c.signal.is_some()).min_by(|a, b| {
                let distance = |c: &crate::Crossing| c.ends[0].distance(position).min(c.ends[1].distance(position));
                distance(a).total_cmp(&distance(b))
            });
            MapObjectKind::WalkLight(crossing?.signal?)
        }
        SignalMeaning::Stop => MapObjectKind::Stop,
        SignalMeaning::Yield => MapObjectKind::Yield,
        SignalMeaning::SpeedLimit(kmh) => MapObjectKind::SpeedLimit(kmh),
        SignalMeaning::Other => {
            let code = [&signal.country, &signal.kind, &signal.subtype].map(String::as_str);
            MapObjectKind::Sign(
                code.iter().filter(|part| !matches!(**part, "" | "-1")).copied().collect::<Vec<_>>().join(" "),
            )
        }
    };
    Some(MapObject { kind, position, heading_rad })
}

/// Standard types first; for those that programs give no type, the name.
fn object_kind(object: &RoadObject) -> Option<MapObjectKind> {
    let name = object.name.to_ascii_lowercase();
    let height = (object.size[2] > 0.5).then_some(object.size[2].min(60.0));
    let named = |words: &[&str]| words.iter().any(|word| name.contains(word));
    match object.kind.as_str() {
        "tree" => return Some(MapObjectKind::Tree(height)),
        "vegetation" if !matches!(object.subtype.as_str(), "bush" | "hedge" | "forest") => {
            return Some(MapObjectKind::Tree(height));
        }
        "streetLamp" | "streetlamp" => return Some(MapObjectKind::StreetLamp),
        "pole" if named(&["lamp", "light", "streetlight"]) && !named(&["traffic", "signal"]) => {
            return Some(MapObjectKind::StreetLamp);
        }
        "pole" if object.subtype == "bollard" => return Some(MapObjectKind::Bollard),
        // Posts of signals and signs come with these.
        "pole" if !named(&["signal", "sign", "mastarm"]) => return Some(MapObjectKind::UtilityPole),
        _ => {}
    }
    let by_name: [(&[&str], MapObjectKind); 7] = [
        (&["streetlight", "street_light", "streetlamp", "lamp_post"], MapObjectKind::StreetLamp),
        (&["bench"], MapObjectKind::Bench),
        (&["busstop", "bus_stop"], MapObjectKind::BusStop),
        (&["bollard"], MapObjectKind::Bollard),
        (&["trash", "litter", "rubbish", "garbage"], MapObjectKind::Bin),
        (&["hydrant"], MapObjectKind::Hydrant),
        (&["utilitypole", "utility_pole", "powerpole", "telephone"], MapObjectKind::UtilityPole),
    ];
    by_name.into_iter().find(|(words, _)| named(words)).map(|(_, kind)| kind)
}

fn stand(shape: &RoadShape<'_>, object: &RoadObject, kind: &MapObjectKind, things: &mut Vec<MapObject>) {
    let mut put = |s: f64, t: f64| {
        let position = shape.point(s, t);
        let heading_rad = wrap_angle(shape.pose(s).heading + object.heading);
        things.push(MapObject { kind: kind.clone(), position, heading_rad });
    };
    if object.repeats.is_empty() {
        put(object.s, object.t);
    }
    for repeat in object.repeats.iter().filter(|repeat| repeat.distance > 0.0) {
        for i in 0..=(repeat.length / repeat.distance) as usize {
            let along = i as f64 * repeat.distance;
            let share = if repeat.length > 0.0 { along / repeat.length } else { 0.0 };
            put(repeat.s + along, repeat.t[0] + share * (repeat.t[1] - repeat.t[0]));
        }
    }
}

/// The outline of an object, counter-clockwise, if it has some extent.
fn outline(shape: &RoadShape<'_>, object: &RoadObject) -> Option<Vec<DVec2>> {
    let mut outline: Vec<DVec2> = corners(shape, object).iter().map(|p| p.truncate()).collect();
    let twice: f64 = (0..outline.len()).map(|i| outline[i].perp_dot(outline[(i + 1) % outline.len()])).sum();
    if twice < 0.0 {
        outline.reverse();
    }
    (twice.abs() > 2.0 * LEAST_M2).then_some(outline)
}

fn building(shape: &RoadShape<'_>, object: &RoadObject) -> Option<BuildingFootprint> {
    let height_m = (object.size[2] > 1.0).then_some(object.size[2].min(500.0));
    let (outline, kind) = (outline(shape, object)?, "yes".to_owned());
    Some(BuildingFootprint { outline, holes: Vec::new(), height_m, levels: None, kind, color: None })
}

/// Land that is given as an object with an outline: woods and bushes.
fn land(shape: &RoadShape<'_>, object: &RoadObject) -> Option<(LandUse, Vec<DVec2>)> {
    let kind = match (object.kind.as_str(), object.subtype.as_str()) {
        ("vegetation", "forest") => LandUse::Wood,
        ("vegetation", "bush" | "hedge") => LandUse::Grass,
        _ => return None,
    };
    object.outlines.iter().any(|outline| outline.len() >= 3).then_some(())?;
    Some((kind, outline(shape, object)?))
}

/// An island as a raised strip along its longer side.
fn island(shape: &RoadShape<'_>, object: &RoadObject) -> Option<LaneSurface> {
    let mut strip = bay(shape, object)?;
    strip.kind = LaneType::Median;
    let up = if object.size[2] > 0.01 { object.size[2].min(0.5) } else { KERB_M };
    strip.left.iter_mut().chain(&mut strip.right).for_each(|p| p.z += up);
    Some(strip)
}

fn is_line(object: &RoadObject) -> bool {
    let name = object.name.to_ascii_lowercase();
    object.kind == "roadMark" || ["stopline", "solidsingle", "soliddouble", "dashed"].iter().any(|w| name.contains(w))
}

/// A slender painted shape as a line along its middle.
fn line(shape: &RoadShape<'_>, object: &RoadObject) -> Option<RoadMarking> {
    let corners = corners(shape, object);
    let rectangle = rectangle(&corners)?;
    let (long, short) = (rectangle.long.length(), rectangle.short.length());
    if long < SLENDER * short {
        return None;
    }
    let height = corners.iter().map(|p| p.z).sum::<f64>() / corners.len() as f64;
    let ends = [-rectangle.long, rectangle.long].map(|half| (rectangle.middle + half).extend(height));
    let name = object.name.to_ascii_lowercase();
    Some(RoadMarking {
        line: Polyline::new(ends),
        width_m: (2.0 * short).clamp(0.1, 1.0),
        dash: name.contains("dashed").then_some([1.0, 1.0]),
        color: if name.contains("yellow") { MarkingColor::Yellow } else { MarkingColor::White },
    })
}

/// A parking space as a strip along its longer side.
fn bay(shape: &RoadShape<'_>, object: &RoadObject) -> Option<LaneSurface> {
    let corners = corners(shape, object);
    let r = rectangle(&corners).filter(|r| r.short.length() > 0.5)?;
    let height = place(shape, object).z;
    let at = |side: f64| {
        [-1.0, 1.0]
            .map(|end| (r.middle + r.long * end + r.long.normalize().perp() * r.short.length() * side).extend(height))
            .to_vec()
    };
    Some(LaneSurface {
        kind: LaneType::Parking,
        left: at(1.0),
        right: at(-1.0),
        in_junction: shape.road.junction.is_some(),
        unpaved: false,
        bridge: false,
    })
}
