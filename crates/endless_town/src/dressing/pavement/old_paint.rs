//! Paint of other times and for other users: what is left of lines that were moved, and lanes for buses.

use crate::dressing::pavement::paint::{line, painted};
use endless_road::{Lane, RoadMap};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{ClassTag, Stream};

/// A line that was ground off: paler than the asphalt, duller than paint; linear albedo.
const GROUND_OFF: Material = Material::new(Surface::Asphalt, [0.21, 0.21, 0.205], ClassTag::Roads);
/// Where old lines lie beside new ones, metres.
const ASIDE_M: [f64; 2] = [0.18, 1.1];
/// Above the asphalt and below all other paint, metres.
const BELOW_PAINT_M: f64 = 0.006;
/// Roads of lanes this long have a lane for buses, if the town has such lanes; paint ends this far before its ends, metres.
const BUS_LANE_M: f64 = 40.0;
const BUS_LANE_ENDS_M: f64 = 3.0;
/// Between the paint of a bus lane and the lane's edges, metres.
const BUS_LANE_EDGE_M: f64 = 0.25;

/// Leaves traces beside a share of a map's lines.
pub(crate) fn add_traces(mesh: &mut MeshBuilder, map: &RoadMap, share: f64, seed: u64) {
    for (i, mark) in map.markings.iter().enumerate() {
        let mut random = Stream::named(seed, "town/old paint", &[i as u64]);
        if mark.width_m > 0.25 || !random.chance(share) {
            continue;
        }
        let side = if random.chance(0.5) { 1.0 } else { -1.0 };
        let aside = side * random.range_f64(ASIDE_M[0], ASIDE_M[1]);
        for piece in painted(mark, &map.network.crossings) {
            line(mesh, &mark.line, piece, (aside, mark.width_m), GROUND_OFF, BELOW_PAINT_M);
        }
    }
}

/// Paints the outer lanes of roads of several lanes in a colour.
pub(crate) fn add_bus_lanes(mesh: &mut MeshBuilder, map: &RoadMap, color: [f32; 3]) {
    let paint = Material::new(Surface::RoadPaint, color, ClassTag::RoadLines);
    let outer = |lane: &&Lane| {
        let (outwards, inwards) = if map.left_hand { (lane.left, lane.right) } else { (lane.right, lane.left) };
        lane.junction.is_none() && outwards.is_none() && inwards.is_some() && lane.centerline.length() > BUS_LANE_M
    };
    for lane in map.network.lanes.iter().filter(outer) {
        let piece = (BUS_LANE_ENDS_M, lane.centerline.length() - BUS_LANE_ENDS_M);
        let width = lane.width_m - 2.0 * BUS_LANE_EDGE_M;
        line(mesh, &lane.centerline, piece, (0.0, width), paint, BELOW_PAINT_M);
    }
}
