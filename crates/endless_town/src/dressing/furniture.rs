//! Benches, bins, hydrants and the rest of what stands on and behind sidewalks.

use super::dresser::{Dresser, Spot, towards_road};
use super::post::POST_M;
use crate::camera::in_the_way;
use crate::network::Street;
use crate::plot::{Rect, inside};
use crate::surface;
use endless_asset::Prop;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A piece of furniture: half its size along its own axes, how often it is found on busy and on quiet streets, and
/// how it is turned from facing the road.
struct Piece {
    prop: Prop,
    half: [f64; 2],
    busy: f64,
    quiet: f64,
    turn: f64,
}

const fn piece(prop: Prop, half: [f64; 2], busy: f64, quiet: f64, turn: f64) -> Piece {
    Piece { prop, half, busy, quiet, turn }
}

/// What fits between kerb and walking strip.
const KERBSIDE: &[Piece] = &[
    piece(Prop::Bench, [0.42, 0.95], 1.2, 0.15, PI),
    piece(Prop::Bin, [0.3, 0.3], 1.6, 0.5, 0.0),
    piece(Prop::Hydrant, [0.25, 0.25], 0.6, 0.6, 0.0),
    piece(Prop::PostBox, [0.35, 0.35], 0.4, 0.25, PI),
    piece(Prop::Bollard, [0.15, 0.15], 1.2, 0.1, 0.0),
    piece(Prop::Planter, [0.4, 0.8], 1.2, 0.1, 0.0),
    piece(Prop::BikeRack, [0.5, 0.4], 1.0, 0.1, FRAC_PI_2),
    piece(Prop::Cabinet, [0.35, 0.6], 0.6, 0.4, PI),
    piece(Prop::ParkingMeter, [0.2, 0.2], 0.9, 0.05, PI),
    piece(Prop::PayStation, [0.25, 0.3], 0.3, 0.05, PI),
    piece(Prop::NewsBox, [0.3, 0.75], 0.4, 0.03, PI),
    piece(Prop::CityLight, [0.2, 0.7], 0.5, 0.0, FRAC_PI_2),
    piece(Prop::BusStop, [0.2, 0.3], 0.35, 0.3, FRAC_PI_2),
    piece(Prop::WheelieBins, [0.45, 1.05], 0.15, 0.9, PI),
    piece(Prop::RubbishBags, [0.55, 0.6], 0.4, 0.2, 0.0),
    piece(Prop::SandwichBoard, [0.3, 0.35], 0.5, 0.0, FRAC_PI_2),
    piece(Prop::BikeStand, [0.4, 1.2], 0.4, 0.08, 0.0),
    piece(Prop::Charger, [0.25, 0.35], 0.3, 0.12, 0.0),
    piece(Prop::DrinkingFountain, [0.3, 0.3], 0.12, 0.0, PI),
    piece(Prop::SpeedCamera, [0.3, 0.3], 0.1, 0.06, FRAC_PI_2),
];

/// What stands behind the sidewalk, facing the road.
const BEHIND: &[Piece] = &[
    piece(Prop::BusShelter, [1.0, 2.2], 1.0, 0.25, 0.0),
    piece(Prop::Billboard, [0.5, 1.8], 0.8, 0.15, 0.0),
    piece(Prop::Kiosk, [1.4, 1.4], 0.7, 0.0, 0.0),
    piece(Prop::CafeTable, [1.3, 1.3], 1.6, 0.0, 0.0),
    piece(Prop::Dumpster, [0.8, 1.1], 0.5, 0.3, FRAC_PI_2),
    piece(Prop::Cone, [0.3, 0.3], 0.2, 0.2, 0.0),
    piece(Prop::Bench, [0.42, 0.95], 0.5, 0.1, 0.0),
    piece(Prop::StoneBench, [0.3, 1.1], 0.4, 0.0, 0.0),
    piece(Prop::PhoneBooth, [0.5, 0.5], 0.3, 0.05, 0.0),
    piece(Prop::AdvertColumn, [0.75, 0.75], 0.4, 0.0, 0.0),
    piece(Prop::BottleBank, [0.75, 0.75], 0.25, 0.3, 0.0),
    piece(Prop::Skip, [1.75, 1.0], 0.2, 0.25, FRAC_PI_2),
    piece(Prop::Pallets, [0.65, 0.45], 0.25, 0.2, FRAC_PI_2),
    piece(Prop::WheelieBins, [0.45, 1.05], 0.3, 0.5, 0.0),
    piece(Prop::MarketStall, [1.2, 1.5], 0.4, 0.0, 0.0),
    piece(Prop::PicnicTable, [0.95, 0.8], 0.2, 0.1, FRAC_PI_2),
    piece(Prop::SiteFence, [1.8, 0.4], 0.2, 0.1, FRAC_PI_2),
];

fn draw<'a>(pieces: &'a [Piece], busy: bool, stream: &mut Stream) -> &'a Piece {
    let weights: Vec<f64> = pieces.iter().map(|p| if busy { p.busy } else { p.quiet }).collect();
    &pieces[stream.weighted(&weights)]
}

pub(crate) fn add(dresser: &mut Dresser<'_>, sites: &[CameraSite]) {
    let plan = dresser.plan;
    let outline = surface::outline(plan);
    for (i, street) in plan.streets.iter().enumerate() {
        let mut stream = dresser.stream(5000 + i as u64);
        let busy = street.profile.priority >= 3;
        let (from, to) = street.lane_range();
        if stream.chance(if busy { 0.4 } else { 0.15 }) {
            roadworks(dresser, street, &mut stream);
        }
        for side in [1.0, -1.0] {
            let mut s = from + 3.0;
            while s < to - 3.0 {
                s += stream.range_f64(3.5, if busy { 11.0 } else { 24.0 });
                if s < to - 2.0 {
                    kerbside(dresser, street, (s, side), busy, &mut stream);
                }
            }
            let mut s = from + 3.0;
            while s < to - 3.0 {
                s += stream.range_f64(6.0, if busy { 20.0 } else { 45.0 });
                if s < to - 2.0 {
                    behind(dresser, street, (s, side), busy, sites, &outline, &mut stream);
                }
            }
        }
    }
}

/// A trench at the kerb somewhere along a street: its sign, beacons at both ends, boards between them.
fn roadworks(dresser: &mut Dresser<'_>, street: &Street, stream: &mut Stream) {
    let (from, to) = street.lane_range();
    let length = 2.2 * (2 + stream.below(4)) as f64;
    if to - from < length + 16.0 {
        return;
    }
    let start = from + 6.0 + stream.f64() * (to - from - length - 12.0);
    let side = if stream.chance(0.5) { 1.0 } else { -1.0 };
    let strip = street.profile.kerb() + POST_M + 0.1;
    let spot = |s: f64, turn: f64| Spot::new(street.point(s, side * strip), street.heading(s) + turn);
    let free = |s: f64| !street.near_crossing(s, 2.4);
    let customs = super::post::Customs::of(dresser.character);
    // Who drives on this side sees the sign first.
    let before = if side > 0.0 { start + length + 3.0 } else { start - 3.0 };
    if free(before) {
        let face = if side > 0.0 { 0.0 } else { PI };
        dresser.put_variant(customs.sign(super::post::Says::Works), spot(before, face), DVec2::splat(0.3));
    }
    let mut s = start;
    while s <= start + length {
        let edge = s <= start || s + 2.2 > start + length;
        let (prop, half) = if edge { (Prop::Beacon, [0.25, 0.42]) } else { (Prop::WorksBarrier, [1.05, 0.42]) };
        if free(s) {
            dresser.put(prop, spot(s, 0.0), DVec2::from_array(half), None);
        }
        s += 2.2;
    }
}

fn kerbside(dresser: &mut Dresser<'_>, street: &Street, (s, side): (f64, f64), busy: bool, stream: &mut Stream) {
    let piece = draw(KERBSIDE, busy, stream);
    let wide = street.profile.verge && matches!(piece.prop, Prop::CityLight | Prop::SandwichBoard | Prop::NewsBox);
    if wide || street.near_crossing(s, 2.2) || (street.profile.verge && piece.prop == Prop::Bench) {
        return;
    }
    let at = street.point(s, side * (street.profile.kerb() + POST_M + 0.1));
    let spot = Spot::new(at, towards_road(street, s, side) + piece.turn);
    if !dresser.put(piece.prop, spot, DVec2::from_array(piece.half), None) || piece.prop != Prop::Bollard {
        return;
    }
    // Bollards come in rows.
    for k in 1..=4 {
        let s = s + 1.5 * f64::from(k);
        if !street.near_crossing(s, 2.2) && s < street.lane_range().1 - 1.0 {
            let at = street.point(s, side * (street.profile.kerb() + POST_M));
            dresser.put(Prop::Bollard, Spot::new(at, 0.0), DVec2::splat(0.15), None);
        }
    }
}

fn behind(
    dresser: &mut Dresser<'_>,
    street: &Street,
    (s, side): (f64, f64),
    busy: bool,
    sites: &[CameraSite],
    outline: &[DVec2],
    stream: &mut Stream,
) {
    let piece = draw(BEHIND, busy, stream);
    let half = DVec2::from_array(piece.half);
    let depth = half.x.max(half.y);
    let at = street.point(s, side * (street.profile.back() + depth + 0.2));
    let yaw = towards_road(street, s, side) + piece.turn;
    let rect = Rect::new(at, half, yaw);
    let corridor = dresser
        .plan
        .streets
        .iter()
        .any(|other| rect.corners().iter().any(|c| other.path.project(*c).1.abs() < other.profile.back() + 0.05));
    let tall = matches!(
        piece.prop,
        Prop::BusShelter
            | Prop::Billboard
            | Prop::Kiosk
            | Prop::CafeTable
            | Prop::PhoneBooth
            | Prop::AdvertColumn
            | Prop::MarketStall
    );
    if corridor || (tall && in_the_way(sites, at, depth)) || (piece.prop == Prop::CafeTable && !inside(outline, at)) {
        return;
    }
    dresser.put(piece.prop, Spot::new(at, yaw), half, None);
    if piece.prop == Prop::CafeTable {
        let next = street.point(s + 2.9, side * (street.profile.back() + depth + 0.2));
        dresser.put(piece.prop, Spot::new(next, yaw), half, None);
    }
}

/// A row of pieces `length` long each, along a line, leaving gaps where something stands.
pub(crate) fn row(dresser: &mut Dresser<'_>, prop: Prop, length: f64, from: DVec2, to: DVec2, skip: &Rect) {
    let along = to - from;
    let count = (along.length() / length).floor() as usize;
    let step = along.normalize_or(DVec2::X) * length;
    let yaw = endless_world::math::f64::atan2(along.y, along.x);
    for k in 0..count {
        let at = from + step * (k as f64 + 0.5);
        let half = DVec2::new(length / 2.0 - 0.02, 0.3);
        if !skip.meets(&Rect::new(at, half, yaw)) {
            dresser.put(prop, Spot { scale: Vec3::ONE, ..Spot::new(at, yaw) }, half, None);
        }
    }
}
