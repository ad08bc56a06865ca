//! What grows and stands on the lawns and yards that cameras see: tufts, groups of bushes, beds of flowers, hedges along
//! the pavement, benches, bicycles, bins, pots. None of it is so tall that it hides a street.

use super::detail_ground::{DetailGround, camera_stream};
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::pavement::crossing;
use crate::geometry::{Rect, unit};
use crate::palette::{LAWN, MEADOW};
use endless_asset::Prop;
use endless_road::{LandUse, LaneType, RoadNetwork};
use endless_world::math::f64::atan2;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, Vec3};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// Lawns are looked at from here to here, metres from the lens.
const SEEN_M: [f64; 2] = [8.0, 62.0];
/// Places that are tried, and most pieces put down, for each camera.
const TRIES: usize = 520;
const MOST: usize = 170;
/// Nothing stands nearer to a pavement than this, metres.
const ASIDE_M: f64 = 0.7;
/// Room about things in yards, metres.
const YARD_M: f64 = 2.2;
/// A pavement within this distance is one that things face, metres.
const BESIDE_M: f64 = 9.0;

/// Dresses lawns.
pub(crate) struct LawnDetail<'a> {
    pub(crate) ground: &'a DetailGround,
    pub(crate) network: &'a RoadNetwork,
}

/// A kind of ground that nobody drives on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LawnKind {
    Kept,
    Wild,
    /// A paved yard.
    Yard,
}

impl LawnDetail<'_> {
    pub(crate) fn add(&self, assembly: &mut TownAssembly<'_>, sites: &[CameraSite]) {
        for site in sites {
            let mut stream = camera_stream(assembly, 140_000, site);
            let lens = DVec2::new(f64::from(site.position[0]), f64::from(site.position[1]));
            let half = f64::from(site.horizontal_fov_rad) / 2.0;
            let before = assembly.placements.len();
            for _ in 0..TRIES {
                let angle = f64::from(site.yaw_rad) + stream.range_f64(-half, half);
                let at = lens + unit(angle) * stream.range_f64(SEEN_M[0], SEEN_M[1]);
                if let Some(lawn) = self.lawn(at).filter(|_| assembly.placements.len() - before < MOST) {
                    self.piece(assembly, lawn, at, &mut stream);
                }
            }
        }
    }

    /// What kind of lawn a place is on, if it is on one.
    pub(crate) fn lawn(&self, p: DVec2) -> Option<LawnKind> {
        let lawn = match self.ground.areas.at(p) {
            _ if !self.ground.forecourts.is_free(&Rect::around(p, 0.01)) => LawnKind::Yard,
            Some(LandUse::Park) => LawnKind::Kept,
            Some(LandUse::Grass) => LawnKind::Wild,
            None | Some(LandUse::Residential) => match self.ground.bare(p) {
                ground if ground == LAWN => LawnKind::Kept,
                ground if ground == MEADOW => LawnKind::Wild,
                _ => LawnKind::Yard,
            },
            Some(_) => return None,
        };
        (!self.ground.pavement.is_near(p, ASIDE_M) && !self.is_crossed(p)).then_some(lawn)
    }

    /// Whether people cross a road near by, and the verge before it.
    pub(crate) fn is_crossed(&self, p: DVec2) -> bool {
        self.network.crossings.iter().any(|crossing| crossing::is_near(crossing, p, ASIDE_M))
    }

    /// The direction of the nearest pavement, and how far it is.
    fn pavement(&self, p: DVec2) -> Option<(f64, f64)> {
        let ring = |d: f64| {
            let way = |k: i32| FRAC_PI_4 / 2.0 * f64::from(k);
            (0..16).map(way).find(|&angle| self.ground.pavement.is_paved(p + unit(angle) * d)).map(|angle| (angle, d))
        };
        (1..=(BESIDE_M / 0.75) as i32).find_map(|k| ring(0.75 * f64::from(k)))
    }

    fn is_walked_on(&self, p: DVec2) -> bool {
        self.ground.pavement.at(p).any(|(piece, _)| piece.kind == LaneType::Sidewalk)
    }

    fn piece(&self, assembly: &mut TownAssembly<'_>, lawn: LawnKind, at: DVec2, stream: &mut Stream) {
        let (dice, turn) = (stream.f64(), stream.range_f64(0.0, TAU));
        let beside = self.pavement(at);
        if lawn == LawnKind::Yard {
            return self.yard(assembly, at, beside.map_or(turn, |b| b.0), stream);
        }
        // Far from where people walk nobody keeps beds.
        let lawn =
            if beside.is_some_and(|b| self.is_walked_on(at + unit(b.0) * (b.1 + 0.3))) { lawn } else { LawnKind::Wild };
        let facing = beside.map_or(turn, |b| b.0);
        let park = self.ground.areas.at(at) == Some(LandUse::Park);
        let near = beside.is_some_and(|b| b.1 < 3.5);
        match (lawn, dice) {
            (LawnKind::Wild, d) if d < 0.75 => self.tufts(assembly, at, 5, stream),
            (LawnKind::Wild, d) if d < 0.82 => self.put(assembly, Prop::Rock, at, turn, [0.8, 0.8], stream),
            (LawnKind::Wild, _) => self.bushes(assembly, at, turn, stream),
            (LawnKind::Kept, d) if d < 0.30 => self.tufts(assembly, at, 3, stream),
            (LawnKind::Kept, d) if d < 0.46 => self.bushes(assembly, at, facing + FRAC_PI_2, stream),
            (LawnKind::Kept, d) if d < 0.56 && near => {
                self.row(assembly, Prop::FlowerBed, (at, facing + FRAC_PI_2), 2.0, 3, stream);
            }
            (LawnKind::Kept, d) if d < 0.78 && near => {
                self.row(assembly, Prop::Hedge, (at, facing + FRAC_PI_2), 1.0, 9, stream);
            }
            (LawnKind::Kept, d) if d < 0.84 && near => {
                self.put(assembly, Prop::Bench, at, facing, [0.42, 0.95], stream);
            }
            (LawnKind::Kept, d) if d < 0.87 && near => {
                self.put(assembly, Prop::BikeStand, at, facing, [0.4, 1.2], stream);
            }
            (LawnKind::Kept, 0.87..0.90) if park => self.put(assembly, Prop::PicnicTable, at, turn, [1.0, 0.9], stream),
            (LawnKind::Kept, 0.90..0.92) => self.put(assembly, Prop::Rock, at, turn, [0.8, 0.8], stream),
            _ => self.tufts(assembly, at, 4, stream),
        }
    }

    /// What people leave in yards, with room between.
    fn yard(&self, assembly: &mut TownAssembly<'_>, at: DVec2, facing: f64, stream: &mut Stream) {
        if stream.chance(0.5) || !assembly.occupied.is_free(&Rect::around(at, YARD_M)) {
            return;
        }
        let (prop, half) = match stream.f64() {
            d if d < 0.34 => (Prop::Planter, [0.4, 0.8]),
            d if d < 0.48 => (Prop::BikeStand, [0.4, 1.2]),
            d if d < 0.60 => (Prop::Bench, [0.42, 0.95]),
            d if d < 0.74 => (Prop::WheelieBins, [0.45, 1.05]),
            d if d < 0.80 => (Prop::Pallets, [0.65, 0.45]),
            d if d < 0.86 => (Prop::CafeTable, [1.25, 1.25]),
            d if d < 0.90 => (Prop::RubbishBags, [0.55, 0.6]),
            _ => (Prop::FlowerBed, [1.0, 0.4]),
        };
        self.put(assembly, prop, at, facing, half, stream);
    }

    fn spot(&self, at: DVec2, yaw: f64) -> PropPose {
        PropPose { z: self.ground.land.height(at) - 0.02, ..PropPose::new(at, yaw) }
    }

    fn put(
        &self,
        assembly: &mut TownAssembly<'_>,
        prop: Prop,
        at: DVec2,
        yaw: f64,
        half: [f64; 2],
        stream: &mut Stream,
    ) {
        let half = DVec2::from_array(half);
        let rect = Rect::new(at, half, yaw);
        if rect.corners().iter().all(|&c| self.lawn(c).is_some()) {
            let scale = if prop == Prop::Rock { stream.range_f32(0.4, 0.9) } else { 1.0 };
            let spot = PropPose { scale: Vec3::splat(scale), ..self.spot(at, yaw) };
            assembly.put(prop, spot, half, None);
        }
    }

    /// Longer grass here and there.
    fn tufts(&self, assembly: &mut TownAssembly<'_>, at: DVec2, most: usize, stream: &mut Stream) {
        for _ in 0..1 + stream.below(most) {
            let here = at + unit(stream.range_f64(0.0, TAU)) * stream.range_f64(0.1, 1.5);
            let spot = PropPose {
                scale: Vec3::splat(stream.range_f32(0.6, 1.2)),
                ..self.spot(here, stream.range_f64(0.0, TAU))
            };
            if self.lawn(here).is_some() && assembly.occupied.is_free(&Rect::around(here, 0.2)) {
                assembly.place(Prop::GrassTuft, spot, None);
            }
        }
    }

    fn bushes(&self, assembly: &mut TownAssembly<'_>, at: DVec2, yaw: f64, stream: &mut Stream) {
        for k in 0..2 + stream.below(4) {
            let here = at + unit(yaw) * (1.15 * k as f64) + unit(yaw + FRAC_PI_2) * stream.range_f64(-0.3, 0.3);
            let scale = stream.range_f32(0.55, 0.95);
            let spot = PropPose { scale: Vec3::splat(scale), ..self.spot(here, stream.range_f64(0.0, TAU)) };
            if self.lawn(here).is_some() {
                assembly.put(Prop::Bush, spot, DVec2::splat(0.5), None);
            }
        }
    }

    /// Pieces of a length side by side, as far as there is room.
    fn row(
        &self,
        assembly: &mut TownAssembly<'_>,
        prop: Prop,
        (at, yaw): (DVec2, f64),
        length: f64,
        most: usize,
        stream: &mut Stream,
    ) {
        let half = DVec2::new(length / 2.0 - 0.02, 0.4);
        let along = unit(yaw);
        for k in 0..1 + stream.below(most) {
            let here = at + along * (length * k as f64);
            let rect = Rect::new(here, half, atan2(along.y, along.x));
            let open = rect.corners().iter().all(|&c| self.lawn(c) == Some(LawnKind::Kept));
            if !open || !assembly.put(prop, self.spot(here, yaw), half, None) {
                return;
            }
        }
    }
}
