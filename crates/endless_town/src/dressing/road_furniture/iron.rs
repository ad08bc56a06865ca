//! Iron in the road: covers of manholes on the lanes, gully grates at the kerbs.

use crate::dressing::assembly::TownAssembly;
use crate::dressing::ground::pavement_index::{PavementIndex, is_carriageway};
use crate::dressing::pavement::crossing;
use crate::geometry::unit;
use crate::placement::{PlacedObject, Placement};
use endless_asset::Prop;
use endless_road::{Lane, LaneType, RoadMap};
use endless_world::Stream;
use glam::{Affine3A, DVec3, Mat3, Vec3};

/// Distance between manholes along a lane, and between grates along a kerb, metres.
const MANHOLES_M: [f64; 2] = [24.0, 60.0];
const GRATES_M: [f64; 2] = [18.0, 30.0];
/// Furthest a kerb lies from the middle of the lane beside it, metres.
const KERB_M: f64 = 7.0;
/// From the kerb to the middle of a grate, metres.
const GRATE_M: f64 = 0.3;
/// Iron lies above the layers of pavements.
const LIFT_M: f64 = 0.006;
/// Nothing lies this near to a crossing's bars, metres.
const CROSSING_M: f64 = 1.4;
/// Nor this near to each other, where lanes lie over one another.
const APART_M: f64 = 3.0;
/// Most pieces of a map.
const MOST: usize = 1500;

/// Lays covers and grates.
pub(crate) fn add(assembly: &mut TownAssembly<'_>, map: &RoadMap, pavement: &PavementIndex) {
    let crossed = |p| map.network.crossings.iter().any(|crossing| crossing::holds(crossing, p, CROSSING_M));
    let mut laid: Vec<DVec3> = Vec::new();
    for (i, lane) in map.network.lanes.iter().enumerate() {
        let mut stream = assembly.stream(130_000 + i as u64);
        let streets = lane.speed_limit_mps < 20.0;
        if !streets || laid.len() >= MOST {
            continue;
        }
        let out = if map.left_hand { 1.0 } else { -1.0 };
        let outermost = if map.left_hand { lane.left.is_none() } else { lane.right.is_none() };
        for (prop, offset, s) in pieces(lane, outermost, &mut stream) {
            let t = match offset {
                // Sewers run below streets with kerbs; in junctions nobody looks for one.
                Some(t)
                    if lane.junction.is_some() || [out, -out].iter().any(|&o| kerb(lane, s, o, pavement).is_some()) =>
                {
                    t
                }
                Some(_) => continue,
                None => match kerb(lane, s, out, pavement) {
                    Some(d) => out * (d - GRATE_M),
                    None => continue,
                },
            };
            let place = lane.centerline.at(s);
            let at = place.position.truncate() + unit(place.heading_rad).perp() * t;
            let on_road = pavement.at(at).any(|(p, z)| is_carriageway(p.kind) && (z - place.position.z).abs() < 0.5);
            let Some(z) = pavement.height(at, place.position.z + 0.5).filter(|_| on_road) else { continue };
            let at = at.extend(z + LIFT_M);
            if crossed(at) || laid.iter().any(|other| other.distance(at) < APART_M) {
                continue;
            }
            let ahead = unit(place.heading_rad).extend(place.grade).normalize().as_vec3();
            let left = Vec3::Z.cross(ahead).normalize();
            let turn = Mat3::from_cols(ahead, left, ahead.cross(left));
            let variant = stream.below(assembly.catalogue.prop_variants(prop).max(1) as usize) as u32;
            let world_from_object = Affine3A::from_mat3_translation(turn, at.as_vec3());
            assembly.placements.push(Placement {
                object: PlacedObject::Prop(prop, variant),
                world_from_object,
                signal: None,
            });
            laid.push(at);
        }
    }
}

/// What lies along a lane: its offset to the left, `None` at the kerb, and its place.
fn pieces(lane: &Lane, outermost: bool, stream: &mut Stream) -> Vec<(Prop, Option<f64>, f64)> {
    let length = lane.centerline.length();
    let mut all = Vec::new();
    let mut s = stream.range_f64(2.0, MANHOLES_M[1]);
    while s < length - 1.0 {
        let aside = stream.range_f64(-0.25, 0.25) * lane.width_m;
        all.push((Prop::Manhole, Some(aside), s));
        s += stream.range_f64(MANHOLES_M[0], MANHOLES_M[1]);
    }
    if outermost && lane.junction.is_none() {
        let mut s = stream.range_f64(1.0, 9.0);
        while s < length - 1.0 {
            all.push((Prop::Drain, None, s));
            s += stream.range_f64(GRATES_M[0], GRATES_M[1]);
        }
    }
    all
}

/// From the middle of a lane to the kerb beside it.
fn kerb(lane: &Lane, s: f64, out: f64, pavement: &PavementIndex) -> Option<f64> {
    let place = lane.centerline.at(s);
    let side = unit(place.heading_rad).perp() * out;
    let kind = |d: f64, walk: bool| {
        pavement.at(place.position.truncate() + side * d).any(|(p, z)| {
            let wanted = if walk { p.kind == LaneType::Sidewalk } else { is_carriageway(p.kind) };
            wanted && (z - place.position.z).abs() < 0.6
        })
    };
    let edge = (0..(KERB_M / 0.1) as usize).map(|k| 0.1 * k as f64).find(|&d| !kind(d, false))?;
    (edge > 1.0 && kind(edge + 0.3, true)).then_some(edge)
}
