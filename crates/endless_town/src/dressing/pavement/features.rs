//! What labels tell of a town's paint and sidewalks, as it is laid.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::{crossing, paint};
use crate::street_features::{PaintedCrosswalk, PaintedMark, PaintedStopLine, SidewalkStrip, StreetFeatures};
use endless_road::{
    CrossingId, Lane, LaneId, LaneSurface, LaneType, MarkingColor, RoadMap, RoadMarking, TrafficControl,
};
use glam::{DVec2, DVec3};

/// Broad marks are stop lines and bars of crossings, no lines along the road.
const BROAD_M: f64 = 0.25;
/// From the end of a lane to the line at which it stops, metres.
const STOP_NEAR_M: f64 = 2.5;
const LEVEL_M: f64 = 1.5;

/// Of a map whose lane surfaces are laid so.
pub(crate) fn features(map: &RoadMap, laid: &[LaneSurface], pavement: &PavementIndex) -> StreetFeatures {
    let sidewalk = |strip: &LaneSurface| SidewalkStrip { left: strip.left.clone(), right: strip.right.clone() };
    StreetFeatures {
        left_hand: map.left_hand,
        marks: marks(map),
        stop_lines: stop_lines(map),
        crosswalks: crosswalks(map, pavement),
        sidewalks: laid.iter().filter(|strip| strip.kind == LaneType::Sidewalk).map(sidewalk).collect(),
    }
}

fn pieces(mark: &RoadMarking, map: &RoadMap) -> Vec<Vec<DVec3>> {
    let painted = paint::painted(mark, &map.network.crossings);
    painted.into_iter().map(|piece| paint::middle(&mark.line, piece, 0.0)).collect()
}

fn marks(map: &RoadMap) -> Vec<PaintedMark> {
    let of_map = map.markings.iter().filter(|mark| mark.width_m < BROAD_M).map(|mark| PaintedMark {
        pieces: pieces(mark, map),
        broken: mark.dash.is_some(),
        width_m: mark.width_m,
        color: mark.color,
    });
    let lanes = map.network.lanes.iter().filter(|lane| map.markings.is_empty() && lane.junction.is_none());
    let usual = lanes.flat_map(|lane| {
        paint::usual_lines(lane, map.left_hand).into_iter().map(|line| PaintedMark {
            pieces: line.pieces.iter().map(|&piece| paint::middle(&lane.centerline, piece, line.t)).collect(),
            broken: line.broken,
            width_m: paint::USUAL_M,
            color: MarkingColor::White,
        })
    });
    of_map.chain(usual).filter(|mark| !mark.pieces.is_empty()).collect()
}

fn stop_lines(map: &RoadMap) -> Vec<PaintedStopLine> {
    let lies_on_crossing = |mark: &RoadMarking| {
        let middle = mark.line.position(mark.line.length() / 2.0);
        map.network.crossings.iter().any(|crossing| crossing::holds(crossing, middle, paint::PAINT_APART_M))
    };
    let broad = map.markings.iter().filter(|mark| mark.width_m >= BROAD_M && !lies_on_crossing(mark));
    let of_map = broad.map(|mark| PaintedStopLine {
        pieces: pieces(mark, map),
        broken: mark.dash.is_some(),
        width_m: mark.width_m,
        lanes: lanes_ending_at(mark, &map.network.lanes),
    });
    let added = paint::added_stop_lines(map).map(|(lane, [back_right, front_right, front_left, back_left])| {
        let middle = vec![back_left.midpoint(front_left), back_right.midpoint(front_right)];
        PaintedStopLine { pieces: vec![middle], broken: false, width_m: paint::STOP_M, lanes: vec![lane.id] }
    });
    of_map.filter(|line| !line.lanes.is_empty()).chain(added).collect()
}

/// The lanes that somebody must stop at the end of, and that end at a mark across them.
fn lanes_ending_at(mark: &RoadMarking, lanes: &[Lane]) -> Vec<LaneId> {
    let points = || mark.line.points().iter().map(|p| p.truncate());
    let low = points().fold(DVec2::INFINITY, DVec2::min) - STOP_NEAR_M;
    let high = points().fold(DVec2::NEG_INFINITY, DVec2::max) + STOP_NEAR_M;
    let ends_there = |lane: &&Lane| {
        let end = lane.centerline.at(lane.centerline.length());
        let p = end.position.truncate();
        if lane.end_control == TrafficControl::Free || p.cmplt(low).any() || p.cmpgt(high).any() {
            return false;
        }
        let (s, _) = mark.line.project(p);
        let nearest = mark.line.position(s);
        let across = mark.line.direction(s).dot(crate::geometry::unit(end.heading_rad)).abs() < 0.5;
        across && nearest.truncate().distance(p) < STOP_NEAR_M && (nearest.z - end.position.z).abs() < LEVEL_M
    };
    lanes.iter().filter(ends_there).map(|lane| lane.id).collect()
}

fn crosswalks(map: &RoadMap, pavement: &PavementIndex) -> Vec<PaintedCrosswalk> {
    let ids = (0..).map(CrossingId);
    let painted = ids.zip(&map.network.crossings).map(|(crossing, place)| {
        let bars = paint::bars(place, pavement);
        let there = bars.iter().flat_map(|[near, .., far]| [*near, *far]);
        let back = bars.iter().rev().flat_map(|[_, near, far, _]| [*far, *near]);
        PaintedCrosswalk { crossing, outline: there.chain(back).collect() }
    });
    painted.filter(|crosswalk| crosswalk.outline.len() > 2).collect()
}
