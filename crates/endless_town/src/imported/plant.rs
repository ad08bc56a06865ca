//! Trees and bushes: those of the map, rows along streets, woods and parks, and woods on the hills around.

use super::area::Areas;
use super::cover::Cover;
use super::growth::Density;
use super::land::Land;
use super::look::Look;
use super::post::Poster;
use crate::camera::in_the_way;
use crate::dressing::{Spot, Stage};
use crate::geometry::{Rect, inside};
use endless_asset::Prop;
use endless_road::{AreaKind, MapObjectKind, RoadMap};
use endless_world::math::f64::atan2;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, Vec3};
use std::f64::consts::{PI, TAU};

/// Most trees of each sort of planting.
const MOST_ON_LAND: usize = 2600;
const MOST_ON_HILLS: usize = 1100;
const MOST_IN_ROWS: usize = 900;
/// From this far a field of maize is a colour, metres.
const SEEN_M: f64 = 170.0;
/// Distance between street trees, metres.
const ROW_M: f64 = 15.0;

/// Plants a map.
pub(super) struct Planter<'a> {
    pub(super) map: &'a RoadMap,
    pub(super) cover: &'a Cover,
    pub(super) land: &'a Land,
    pub(super) areas: &'a Areas<'a>,
    pub(super) density: &'a Density,
    pub(super) look: &'a Look,
    pub(super) seed: u64,
}

fn tall(at: DVec2, z: f64, size: (f32, f32), stream: &mut Stream) -> Spot {
    let scale = Vec3::splat(stream.range_f32(size.0, size.1));
    Spot { at, z: z - 0.03, yaw: stream.range_f64(0.0, TAU), scale }
}

impl Planter<'_> {
    /// The trees that the map knows of; they were there before any camera.
    pub(super) fn known(&self, stage: &mut Stage<'_>) -> Vec<DVec2> {
        let mut stream = stage.stream(20_000);
        let mut placed = Vec::new();
        for thing in &self.map.objects {
            let MapObjectKind::Tree(height) = thing.kind else { continue };
            let at = thing.position.truncate();
            if self.cover.is_carriageway(at) {
                continue;
            }
            let scale = height.map_or_else(|| stream.range_f32(0.85, 1.15), |h| (h as f32 / 9.0).clamp(0.45, 2.0));
            let z = self.cover.height(at, thing.position.z + 2.0).unwrap_or_else(|| self.land.height(at));
            let spot = Spot { at, z, yaw: stream.range_f64(0.0, TAU), scale: Vec3::splat(scale) };
            if stage.put(Prop::BroadleafTree, spot, DVec2::splat(0.4), None) {
                placed.push(at);
            }
        }
        placed
    }

    /// A row behind the kerb or beside the road, where no camera looks through it.
    pub(super) fn rows(&self, stage: &mut Stage<'_>, poster: &Poster<'_>, sites: &[CameraSite], houses: &[Rect]) {
        let mut planted = 0;
        for (i, lane) in self.map.network.lanes.iter().enumerate() {
            let length = lane.centerline.length();
            if lane.junction.is_some() || !poster.is_outermost(lane) || length < 20.0 {
                continue;
            }
            let mut stream = stage.stream(21_000 + i as u64);
            let fast = lane.speed_limit_mps > 16.0;
            let mut s = stream.range_f64(4.0, 10.0);
            while s < length - 5.0 && planted < MOST_IN_ROWS {
                let beyond = if fast { stream.range_f64(4.0, 9.0) } else { 0.75 };
                let verge = poster.verge(lane, s, poster.side(), beyond);
                s += ROW_M * stream.range_f64(0.85, if fast { 2.6 } else { 1.3 });
                let Some(verge) = verge else { continue };
                // Narrow sidewalks have no room for trees.
                let roomy = fast || !verge.walk || {
                    let out = (verge.at - lane.centerline.at(s).position.truncate()).normalize_or(DVec2::X);
                    self.cover.is_paved(verge.at + out * 1.9)
                };
                let lit = stage.lamps.iter().any(|l| l.position.truncate().as_dvec2().distance(verge.at) < 4.5);
                let crown = Rect::around(verge.at, 2.2);
                let blocked = lit || in_the_way(sites, verge.at, 2.6) || houses.iter().any(|h| h.meets(&crown));
                if roomy && !blocked && stream.chance(0.85) {
                    let spot = tall(verge.at, verge.z, (0.8, 1.05), &mut stream);
                    let prop = if stream.chance(self.look.palms) { Prop::Palm } else { Prop::BroadleafTree };
                    planted += usize::from(stage.put(prop, spot, DVec2::splat(0.4), None));
                }
            }
        }
    }

    /// Trees and bushes on open land: dense in woods, sparse in gardens and meadows.
    pub(super) fn land(&self, stage: &mut Stage<'_>, sites: &[CameraSite], low: DVec2, high: DVec2) {
        let mut stream = stage.stream(22_000);
        let (low, size) = (low - 60.0, high - low + 120.0);
        let hectares = size.x * size.y / 10_000.0;
        let tries = (hectares * 70.0).min(60_000.0) as usize;
        let mut planted = 0;
        for _ in 0..tries {
            let at = low + size * DVec2::new(stream.f64(), stream.f64());
            let (dice, kind, height) = (stream.f64(), stream.f64(), stream.range_f32(0.8, 1.2));
            let (tree, bush) = match self.areas.at(at) {
                Some(AreaKind::Wood) => (1.0, 0.0),
                Some(AreaKind::Park) => (0.5, 0.2),
                Some(AreaKind::Grass | AreaKind::Residential) => (0.3, 0.2),
                Some(_) => (0.0, 0.0),
                None if self.density.at(at) > 60.0 => (0.3, 0.25),
                None => (0.4, 0.1),
            };
            let (prop, room) = match dice {
                d if d < tree && kind < self.look.conifers => (Prop::Conifer, 2.2),
                d if d < tree && kind > 1.0 - self.look.palms => (Prop::Palm, 1.8),
                d if d < tree => (Prop::BroadleafTree, 2.4),
                d if d < tree + bush => (Prop::Bush, 0.9),
                _ => continue,
            };
            if planted >= MOST_ON_LAND || self.cover.is_near(at, room + 0.8) || in_the_way(sites, at, room) {
                continue;
            }
            if stage.occupied.is_free(&Rect::around(at, room)) {
                let spot =
                    Spot { scale: Vec3::splat(height), ..tall(at, self.land.height(at), (1.0, 1.01), &mut stream) };
                planted +=
                    usize::from(stage.put(prop, spot, DVec2::splat(if prop == Prop::Bush { 0.6 } else { 1.2 }), None));
            }
        }
    }

    /// Maize on the fields that cameras see.
    pub(super) fn maize(&self, stage: &mut Stage<'_>, sites: &[CameraSite]) {
        const BLOCK_M: f64 = 4.0;
        let mut stream = stage.stream(24_000);
        for field in self.areas.of(AreaKind::Farmland) {
            let rect = super::footprint::around(&field.outline);
            let (nx, ny) = ((2.0 * rect.half.x / BLOCK_M) as i64, (2.0 * rect.half.y / BLOCK_M) as i64);
            for i in 0..nx * ny {
                let step = DVec2::new((i % nx) as f64 + 0.5, (i / nx) as f64 + 0.5) * BLOCK_M - rect.half;
                let at = rect.centre + rect.axis * step.x + rect.axis.perp() * step.y;
                let seen = sites.iter().any(|s| {
                    let [x, y, _] = s.position.map(f64::from);
                    (4.0..SEEN_M).contains(&at.distance(DVec2::new(x, y)))
                });
                let block = Rect { centre: at, half: DVec2::splat(BLOCK_M / 2.0), axis: rect.axis };
                let whole = block.corners().iter().all(|&c| inside(&field.outline, c) && !self.cover.is_near(c, 2.5));
                if seen && whole && stage.occupied.is_free(&block) {
                    let yaw = atan2(rect.axis.y, rect.axis.x) + if stream.chance(0.5) { 0.0 } else { PI };
                    let scale = Vec3::new(1.0, 1.0, stream.range_f32(0.92, 1.06));
                    stage.place(Prop::Corn, Spot { at, z: self.land.height(at), yaw, scale }, None);
                }
            }
        }
    }

    /// Woods around the map: they hide the edge of the world.
    pub(super) fn hills(&self, stage: &mut Stage<'_>) {
        let mut stream = stage.stream(23_000);
        for _ in 0..MOST_ON_HILLS {
            let ring = stream.weighted(&[1.2, 1.5, 1.5, 0.9]);
            let place = self.land.on_hills(self.seed, ring, (stream.f64(), stream.f64()));
            let prop = if stream.chance(self.look.conifers + 0.13) { Prop::Conifer } else { Prop::BroadleafTree };
            let spot = tall(place.truncate(), place.z, (0.9, 1.4), &mut stream);
            stage.place(prop, spot, None);
        }
    }
}
