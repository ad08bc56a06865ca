//! Carriageway, kerbs, sidewalks and islands of one street.

use super::NO_LANE;
use super::strip::{Rail, strip};
use crate::network::{KERB_HEIGHT_M, KERB_M, Profile, Street};
use crate::palette::{ASPHALT, KERB, LAWN, PAVING, VERGE};
use endless_scene::MeshBuilder;

/// Longest piece of a strip, metres.
const STEP_M: f64 = 4.0;
/// Height of the kerb where people cross.
const RAMP_HEIGHT_M: f64 = 0.02;
/// Length over which the kerb comes down beside a crossing.
const FLARE_M: f64 = 0.6;
/// Length of a parking bay.
pub(crate) const BAY_M: f64 = 5.8;

/// Height of the kerb at `s`: lowered at crossings.
pub(crate) fn kerb_height(street: &Street, s: f64) -> f64 {
    street.crossings.iter().fold(KERB_HEIGHT_M, |height, c| {
        let outside = ((s - c.s).abs() - c.width / 2.0) / FLARE_M;
        height.min(RAMP_HEIGHT_M + (KERB_HEIGHT_M - RAMP_HEIGHT_M) * outside.clamp(0.0, 1.0))
    })
}

/// Where the bands of the carriageway meet, from right to left: gutters, lanes, island.
pub(crate) fn band_edges(profile: &Profile) -> Vec<f64> {
    let mut left: Vec<f64> = (0..=profile.lanes).map(|k| profile.median / 2.0 + k as f64 * profile.lane).collect();
    left.push(profile.kerb());
    let mut edges: Vec<f64> = left.iter().rev().map(|t| -t).collect();
    edges.extend(if profile.median > 0.0 { &left[..] } else { &left[1..] });
    edges
}

/// Places along a street at which its strips have vertices.
pub(crate) fn stations(street: &Street) -> Vec<f64> {
    let (from, to) = street.body();
    let mut marks = vec![from, to];
    for c in &street.crossings {
        let half = c.width / 2.0;
        marks.extend([c.s - half - FLARE_M, c.s - half, c.s + half, c.s + half + FLARE_M]);
    }
    marks.extend(island_ranges(street).into_iter().flat_map(|(a, b)| [a, b]));
    marks.retain(|&s| s >= from && s <= to);
    marks.sort_by(f64::total_cmp);
    marks.dedup_by(|a, b| (*a - *b).abs() < 0.02);
    crate::network::subdivided(&marks, STEP_M)
}

/// Where the raised island stands, `(from, to)` along the street.
pub(crate) fn island_ranges(street: &Street) -> Vec<(f64, f64)> {
    if street.profile.median < 1.0 {
        return Vec::new();
    }
    let (from, to) = street.lane_range();
    let mut start = from + 1.0;
    let mut ranges = Vec::new();
    let mut cuts: Vec<_> = street.crossings.iter().filter(|c| c.s > from && c.s < to).collect();
    cuts.sort_by(|a, b| a.s.total_cmp(&b.s));
    for c in cuts {
        ranges.push((start, c.s - c.width / 2.0 - 0.4));
        start = c.s + c.width / 2.0 + 0.4;
    }
    ranges.push((start, to - 1.0));
    ranges.retain(|(a, b)| b - a > 4.0);
    ranges
}

/// Middles of the parking bays along each side.
pub(crate) fn bays(street: &Street) -> Vec<f64> {
    if street.profile.parking == 0.0 {
        return Vec::new();
    }
    let (from, to) = street.lane_range();
    let (from, to) = (from + 5.0, to - 5.0);
    let count = ((to - from) / BAY_M).floor().max(0.0) as usize;
    (0..count)
        .map(|i| from + (i as f64 + 0.5) * BAY_M)
        .filter(|&s| !street.near_crossing(s, BAY_M / 2.0 + 4.0))
        .collect()
}

pub(crate) fn add(mesh: &mut MeshBuilder, street: &Street) {
    let stations = stations(street);
    add_carriageway(mesh, street, &stations);
    for side in [1.0, -1.0] {
        add_sidewalk(mesh, street, &stations, side);
    }
    for (from, to) in island_ranges(street) {
        let part: Vec<f64> = stations.iter().copied().filter(|s| (from..=to).contains(s)).collect();
        add_island(mesh, street, &part);
    }
}

fn add_carriageway(mesh: &mut MeshBuilder, street: &Street, stations: &[f64]) {
    let profile = &street.profile;
    let flat = |_: f64| 0.0;
    let edges = band_edges(profile);
    for pair in edges.windows(2) {
        let middle = (pair[0] + pair[1]) / 2.0;
        let lane = middle.abs() > profile.median / 2.0 && middle.abs() < profile.lane_edge();
        let island = middle.abs() < profile.median / 2.0;
        // Metres left of the lane's centre, seen by its driver.
        let v = |t: f64| match lane {
            true if middle < 0.0 => (t - middle) as f32,
            true => (middle - t) as f32,
            false => NO_LANE,
        };
        let rails = [pair[0], pair[1]].map(|t| Rail { t, height: &flat });
        if !island {
            strip(mesh, street, stations, [&rails[0], &rails[1]], [v(pair[0]), v(pair[1])], &|_| ASPHALT);
            continue;
        }
        // The ground under an island is never seen: leave it out.
        let ranges = island_ranges(street);
        let covered = |s: f64| ranges.iter().any(|&(a, b)| s > a && s < b);
        for two in stations.windows(2).filter(|two| !covered((two[0] + two[1]) / 2.0)) {
            strip(mesh, street, two, [&rails[0], &rails[1]], [NO_LANE; 2], &|_| ASPHALT);
        }
    }
}

/// Kerb and sidewalk on one side: +1 left, −1 right.
fn add_sidewalk(mesh: &mut MeshBuilder, street: &Street, stations: &[f64], side: f64) {
    let profile = &street.profile;
    let low = |_: f64| 0.0;
    let kerb = |s: f64| kerb_height(street, s);
    let high = |_: f64| KERB_HEIGHT_M;
    let rail = |t: f64, height| Rail { t: side * t, height };
    let rails = [
        rail(profile.kerb(), &low as &dyn Fn(f64) -> f64),
        rail(profile.kerb(), &kerb),
        rail(profile.kerb() + KERB_M, &kerb),
        rail(profile.walk_edge(), &high),
        rail(profile.back(), &high),
    ];
    let (first, last) = (stations[0], stations[stations.len() - 1]);
    let grows = |s: f64| profile.verge && !street.near_crossing(s, 1.4) && s > first + 2.0 && s < last - 2.0;
    for (k, pair) in rails.windows(2).enumerate() {
        let material = |s: f64| match k {
            0 | 1 => KERB,
            2 if grows(s) => VERGE,
            _ => PAVING,
        };
        // Looking along the street, rails of the left side come in order from right to left.
        let (order, v) =
            if side > 0.0 { ([&pair[0], &pair[1]], [0.0, 1.0]) } else { ([&pair[1], &pair[0]], [1.0, 0.0]) };
        let width = (pair[1].t - pair[0].t).abs().max(KERB_HEIGHT_M) as f32;
        strip(mesh, street, stations, order, v.map(|x: f32| x * width), &material);
    }
}

/// A raised, planted island between the two directions.
fn add_island(mesh: &mut MeshBuilder, street: &Street, stations: &[f64]) {
    let half = street.profile.median / 2.0;
    let low = |_: f64| 0.0;
    let high = |_: f64| KERB_HEIGHT_M;
    let planted = half > 1.3;
    let rails = [
        Rail { t: -half, height: &low },
        Rail { t: -half, height: &high },
        Rail { t: -half + 0.2, height: &high },
        Rail { t: half - 0.2, height: &high },
        Rail { t: half, height: &high },
        Rail { t: half, height: &low },
    ];
    for (k, pair) in rails.windows(2).enumerate() {
        let material = match k {
            2 if planted => LAWN,
            2 => PAVING,
            _ => KERB,
        };
        strip(mesh, street, stations, [&pair[0], &pair[1]], [0.0, (pair[1].t - pair[0].t).max(0.15) as f32], &|_| {
            material
        });
    }
    let (first, last) = (stations[0], stations[stations.len() - 1]);
    for (s, flip) in [(first, false), (last, true)] {
        let at = |t: f64, z: f64| super::strip::at_height(street.point(s, t), z);
        let (l, r) = if flip { (-half, half) } else { (half, -half) };
        let (w, h) = (2.0 * half as f32, KERB_HEIGHT_M as f32);
        mesh.quad(
            [at(l, 0.0), at(r, 0.0), at(r, KERB_HEIGHT_M), at(l, KERB_HEIGHT_M)],
            [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]].map(glam::Vec2::from_array),
            KERB,
        );
    }
}
