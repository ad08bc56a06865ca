//! What labels tell of a town: its lanes, and what is painted and stands in its streets.

use endless_annotate::{
    CrosswalkAttributes, CrosswalkFeature, FeatureBody, LaneAttributes, LaneControl, LaneFeature, LensColor,
    MapFeatures, MarkAttributes, MarkFeature, PaintColor, SidewalkFeature, SignAttributes, SignFeature,
    SignalAttributes, SignalFeature, SignalKind, SignalLens, StopLineAttributes, StopLineFeature,
};
use endless_asset::{Catalogue, Prop, SignalHead};
use endless_road::opendrive::LaneName;
use endless_road::{Lane, LaneId, MarkingColor, TrafficControl, Turn};
use endless_scene::LensAspect;
use endless_town::{PlacedObject, Placement, SidewalkStrip, Town};
use endless_world::SignalId;
use glam::{Affine3A, DVec3, Vec3};
use std::collections::BTreeMap;

/// Sidewalks are told of in pieces about this long, metres.
const SIDEWALK_PIECE_M: f64 = 20.0;

/// Everything that labels tell of a town.
pub(super) fn map_features(town: &Town, catalogue: &Catalogue, lane_names: &[LaneName]) -> MapFeatures {
    let streets = &town.streets;
    let marks = (0..).zip(&streets.marks).map(|(id, mark)| {
        let color = match mark.color {
            MarkingColor::White => PaintColor::White,
            MarkingColor::Yellow => PaintColor::Yellow,
        };
        let attributes = MarkAttributes { id, broken: mark.broken, color, width_m: mark.width_m };
        MarkFeature { attributes, pieces: mark.pieces.clone() }
    });
    let stop_lines = (0..).zip(&streets.stop_lines).map(|(id, line)| {
        let lanes = numbers(&line.lanes);
        let attributes = StopLineAttributes { id, broken: line.broken, width_m: line.width_m, lanes };
        StopLineFeature { attributes, pieces: line.pieces.clone() }
    });
    let crosswalks = streets.crosswalks.iter().map(|crosswalk| {
        let crossing = &town.network.crossings[crosswalk.crossing.index()];
        let lanes = crossing.cuts.iter().map(|cut| cut.lane.0).collect();
        let attributes = CrosswalkAttributes { id: crosswalk.crossing.0.into(), signal: crossing.signal, lanes };
        CrosswalkFeature { attributes, outline: crosswalk.outline.clone() }
    });
    MapFeatures {
        lanes: town.network.lanes.iter().zip(lane_names).map(lane).collect(),
        marks: marks.collect(),
        stop_lines: stop_lines.collect(),
        crosswalks: crosswalks.collect(),
        sidewalks: (0..).zip(&streets.sidewalks).flat_map(|(id, strip)| sidewalk(id, strip)).collect(),
        signals: signals(town),
        signs: signs(town, catalogue),
    }
}

fn numbers(lanes: &[LaneId]) -> Vec<u32> {
    lanes.iter().map(|lane| lane.0).collect()
}

fn lane((lane, name): (&Lane, &LaneName)) -> LaneFeature {
    let (control, signal) = match lane.end_control {
        TrafficControl::Free => (LaneControl::Free, None),
        TrafficControl::Signal(signal) => (LaneControl::Signal, Some(signal)),
        TrafficControl::Stop => (LaneControl::Stop, None),
        TrafficControl::Yield => (LaneControl::Yield, None),
    };
    let turn = match lane.turn {
        Turn::Straight => "straight",
        Turn::Left => "left",
        Turn::Right => "right",
        Turn::UTurn => "u_turn",
    };
    let attributes = LaneAttributes {
        id: lane.id.0,
        road: name.road,
        road_lane: name.lane,
        kind: "driving".into(),
        junction: lane.junction.map(|junction| junction.0),
        turn: turn.into(),
        width_m: lane.width_m,
        speed_limit_mps: lane.speed_limit_mps,
        control,
        signal,
        predecessors: numbers(&lane.predecessors),
        successors: numbers(&lane.successors),
        left_lane: lane.left.map(|lane| lane.0),
        right_lane: lane.right.map(|lane| lane.0),
    };
    let beside = |t: f64| lane.centerline.offset(t).points().to_vec();
    LaneFeature {
        attributes,
        center: lane.centerline.points().to_vec(),
        left: beside(lane.width_m / 2.0),
        right: beside(-lane.width_m / 2.0),
    }
}

/// A strip in pieces.
fn sidewalk(id: u32, strip: &SidewalkStrip) -> Vec<SidewalkFeature> {
    let mut pieces = Vec::new();
    let (mut from, mut length) = (0, 0.0);
    for to in 1..strip.left.len() {
        length += strip.left[to].distance(strip.left[to - 1]).max(strip.right[to].distance(strip.right[to - 1]));
        if length > SIDEWALK_PIECE_M || to + 1 == strip.left.len() {
            let there = strip.right[from..=to].iter();
            let outline = there.chain(strip.left[from..=to].iter().rev()).copied().collect();
            pieces.push(SidewalkFeature { id, outline });
            (from, length) = (to, 0.0);
        }
    }
    pieces
}

fn signals(town: &Town) -> Vec<SignalFeature> {
    let mut signals = Vec::new();
    for placement in &town.placements {
        let (PlacedObject::Prop(prop, variant), Some(group)) = (placement.object, placement.signal) else { continue };
        for head in Catalogue::signal_heads(prop, variant) {
            let attributes = signal_attributes(town, prop, group, signals.len() as u32);
            let lenses = lenses(&head, &placement.world_from_object);
            signals.push(SignalFeature { attributes, body: body([head.low, head.high], placement), lenses });
        }
    }
    signals
}

fn signal_attributes(town: &Town, prop: Prop, group: SignalId, id: u32) -> SignalAttributes {
    let kind = match prop {
        Prop::WalkSignal => SignalKind::Pedestrian,
        Prop::CycleSignal => SignalKind::Bicycle,
        _ => SignalKind::Vehicle,
    };
    let governed = |lane: &&Lane| lane.end_control == TrafficControl::Signal(group);
    let crossings = (0..).zip(&town.network.crossings).filter(|(_, crossing)| crossing.signal == Some(group));
    SignalAttributes {
        id,
        group,
        kind,
        lanes: town.network.lanes.iter().filter(governed).map(|lane| lane.id.0).collect(),
        crosswalks: crossings.map(|(id, _)| id).collect(),
    }
}

fn lenses(head: &SignalHead, world_from_object: &Affine3A) -> Vec<SignalLens> {
    let lens = |&(aspect, center): &(LensAspect, Vec3)| SignalLens {
        color: match aspect {
            LensAspect::Red => LensColor::Red,
            LensAspect::Yellow => LensColor::Yellow,
            LensAspect::Green => LensColor::Green,
        },
        center: world_from_object.transform_point3(center).as_dvec3(),
        radius_m: f64::from(head.lens_radius_m),
    };
    head.lenses.iter().map(lens).collect()
}

fn signs(town: &Town, catalogue: &Catalogue) -> Vec<SignFeature> {
    let mut signs = Vec::new();
    // Many stand in a town of each.
    let mut plates = BTreeMap::new();
    for placement in &town.placements {
        let PlacedObject::Prop(prop, variant) = placement.object else { continue };
        let plate = plates.entry((prop, variant)).or_insert_with(|| catalogue.sign_plate(prop, variant));
        let Some(plate) = plate else { continue };
        let attributes = SignAttributes {
            id: signs.len() as u32,
            code: plate.code.into(),
            convention: if plate.code.contains(',') { "vienna" } else { "mutcd" }.into(),
            value: plate.limit.map(|limit| limit.0),
            unit: plate.limit.map(|limit| limit.1.into()),
            text: plate.words.map(Into::into),
        };
        signs.push(SignFeature { attributes, body: body([plate.low, plate.high], placement) });
    }
    signs
}

/// A box in the object frame, as it stands; its front looks towards +x.
fn body([low, high]: [Vec3; 2], placement: &Placement) -> FeatureBody {
    let place = |p: Vec3| placement.world_from_object.transform_point3(p).as_dvec3();
    let corner = |i: usize| {
        let pick = |bit: usize, axis: usize| if i >> bit & 1 == 0 { low[axis] } else { high[axis] };
        place(Vec3::new(pick(0, 0), pick(1, 1), pick(2, 2)))
    };
    let facing: DVec3 = placement.world_from_object.transform_vector3(Vec3::X).as_dvec3();
    FeatureBody {
        corners: std::array::from_fn(corner),
        center: place(low.midpoint(high).with_x(high.x)),
        facing: facing.normalize_or(DVec3::X),
    }
}

#[cfg(test)]
mod tests;
