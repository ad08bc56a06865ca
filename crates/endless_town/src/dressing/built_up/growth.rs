//! Buildings where the map knows of none: grown along its roads, higher and closer the denser the roads are, of a kind
//! that fits what the map says of the land.

use super::quarter_profile::{QUARTERS, QuarterProfile, TRADE, WORKS, usual_quarter};
use crate::building::BuildingKind;
use crate::building::{
    BuildingDimensions, BuildingOutline, LATIN, WindowNumbers, eaves, house, on_rectangle, size, storeys,
};
use crate::camera::{BuildingPrism, builds_into_view};
use crate::dressing::built_up::density::StreetDensity;
use crate::dressing::built_up::footprint::PlacedBuilding;
use crate::dressing::built_up::streets::{FootprintGrid, may_be_built_on};
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::preset::TownPreset;
use crate::geometry::{OccupiedSpace, Rect, inside, unit};
use endless_road::{LandUse, Lane, RoadNetwork};
use endless_world::math::lerp;
use endless_world::{CameraSite, Stream};
use glam::{Affine3A, DVec2, Quat};

/// Land so far beside a lane's middle says what is built there, metres.
const BESIDE_M: f64 = 18.0;
/// The steepest ground that is built on: difference of height over a lot, metres.
const STEEPEST_M: f64 = 2.2;
/// Colours of walls where houses are bright; linear.
const BRIGHT: &[[f32; 3]] = &[
    [0.70, 0.42, 0.08],
    [0.62, 0.16, 0.09],
    [0.10, 0.32, 0.50],
    [0.16, 0.42, 0.30],
    [0.72, 0.66, 0.52],
    [0.66, 0.30, 0.28],
    [0.42, 0.22, 0.45],
    [0.74, 0.70, 0.64],
    [0.30, 0.52, 0.52],
    [0.68, 0.52, 0.20],
    [0.40, 0.22, 0.14],
];
/// Most buildings of a map.
const MOST: usize = 2400;
/// Around the buildings that a map knows nothing more is built, metres: on maps that know most buildings, and on maps
/// that know few.
const AROUND_KNOWN_M: [f64; 2] = [40.0, 12.0];
/// A map knows most buildings if it has some along this share of its streets in towns.
const MOST_KNOWN: f64 = 0.45;
/// Width and depth of a house where there is no room for another.
const SLIM_M: [f64; 2] = [6.5, 7.5];
/// Room for the porch of a house, metres.
const PORCH_M: f64 = 1.4;
/// Roads on which shops are, m/s.
const MAIN_STREET_MPS: f64 = 12.5;

/// A grown building with the ground before it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FrontYard {
    /// Its x axis runs along the front, and the front is its lower side.
    pub(crate) rect: Rect,
    /// From the front wall to the pavement, metres.
    pub(crate) front_m: f64,
    pub(crate) kind: BuildingKind,
}

/// A lot for which room is looked for.
#[derive(Debug, Clone, Copy)]
struct WantedLot {
    /// Its middle along the lane, metres.
    s: f64,
    /// Width and depth, metres.
    size: (f64, f64),
    /// From the pavement to the front, metres.
    set_back: f64,
    kind: BuildingKind,
}

/// Builds along streets.
pub(crate) struct BuildingGrowth<'a> {
    pub(crate) network: &'a RoadNetwork,
    pub(crate) pavement: &'a PavementIndex,
    pub(crate) land: &'a GroundGrid,
    pub(crate) areas: &'a LandUseMap,
    pub(crate) density: &'a StreetDensity,
    pub(crate) streets: &'a [bool],
    pub(crate) preset: &'a TownPreset,
    /// The buildings of the map, if it has any: then it is believed where it says that nothing stands.
    pub(crate) mapped: Option<FootprintGrid>,
    /// Cameras of which buildings keep clear.
    pub(crate) sites: &'a [CameraSite],
    pub(crate) seed: u64,
}

impl BuildingGrowth<'_> {
    /// Distance from known buildings within which nothing is built.
    fn around_known(&self) -> f64 {
        let Some(mapped) = &self.mapped else { return 0.0 };
        let (mut places, mut known) = (0u32, 0u32);
        for lane in self.network.lanes.iter().filter(|l| self.streets[l.id.index()] && l.right.is_none()) {
            let length = lane.centerline.length();
            for k in 0..(length / 20.0) as usize {
                let place = lane.centerline.at(20.0 * k as f64 + 10.0);
                let beside = place.position.truncate() - unit(place.heading_rad).perp() * BESIDE_M;
                if self.density.at(beside) >= QUARTERS[1].0 && may_be_built_on(self.areas.at(beside)) {
                    places += 1;
                    known += u32::from(mapped.is_near(beside, 20.0));
                }
            }
        }
        AROUND_KNOWN_M[usize::from(f64::from(known) < MOST_KNOWN * f64::from(places))]
    }

    /// Fills the land on both sides of streets.
    pub(crate) fn grow(
        &self,
        occupied: &mut OccupiedSpace,
        numbers: &mut WindowNumbers,
    ) -> Vec<(PlacedBuilding, FrontYard)> {
        let mut built = Vec::new();
        let around_known = self.around_known();
        for lane in self.network.lanes.iter().filter(|l| self.streets[l.id.index()]) {
            for side in [-1.0, 1.0] {
                let outermost = if side < 0.0 { lane.right.is_none() } else { lane.left.is_none() };
                if outermost {
                    self.row(lane, side, around_known, occupied, numbers, &mut built);
                }
            }
        }
        built
    }

    fn row(
        &self,
        lane: &Lane,
        side: f64,
        around_known: f64,
        occupied: &mut OccupiedSpace,
        numbers: &mut WindowNumbers,
        built: &mut Vec<(PlacedBuilding, FrontYard)>,
    ) {
        let mut stream = Stream::named(self.seed, "town/growth", &[u64::from(lane.id.0), (side > 0.0).into()]);
        let length = lane.centerline.length();
        let mut s = 1.0;
        while s < length - 4.0 && built.len() < MOST {
            let place = lane.centerline.at(s);
            let beside = place.position.truncate() + unit(place.heading_rad).perp() * (side * BESIDE_M);
            let Some(quarter) = self.quarter(beside, around_known) else {
                s += 8.0;
                continue;
            };
            let main = lane.speed_limit_mps > MAIN_STREET_MPS;
            let likely = |kind: BuildingKind| if main && kind == BuildingKind::House { 0.4 } else { 1.0 };
            let weights: Vec<f64> = quarter.kinds.iter().map(|k| k.1 * likely(k.0)).collect();
            let kind = quarter.kinds[stream.weighted(&weights)].0;
            let (width, depth) = size(kind, &mut stream);
            let gap = match kind {
                BuildingKind::Terrace => 0.02,
                BuildingKind::House => stream.range_f64(3.0, 6.0),
                _ => stream.range_f64(2.0, 8.0),
            };
            let set_back = match kind {
                BuildingKind::Terrace => 0.15,
                BuildingKind::House | BuildingKind::Flats => stream.range_f64(3.0, 8.0),
                BuildingKind::Hall | BuildingKind::Barn => stream.range_f64(5.0, 10.0),
                _ => stream.range_f64(0.5, 4.0),
            };
            let storeys = storeys(kind, quarter.storeys.0, quarter.storeys.1, &mut stream);
            let shops = kind == BuildingKind::Terrace && stream.chance(if main { 0.75 } else { 0.35 })
                || kind == BuildingKind::Office && stream.chance(0.5);
            let seed = stream.next_u64();
            if stream.chance(quarter.open) {
                s += width + gap;
                continue;
            }
            let dimensions = BuildingDimensions {
                kind,
                style: (self.preset.bright && storeys <= 4 && kind == BuildingKind::Terrace).then_some(&LATIN),
                width: width as f32,
                depth: depth as f32,
                storeys,
                shops,
                party_walls: [kind == BuildingKind::Terrace; 2],
            };
            let wide =
                self.lot(lane, side, WantedLot { s: s + width / 2.0, size: (width, depth), set_back, kind }, occupied);
            // Corners and narrow blocks have room for a small house at least.
            let narrow = || {
                let dimensions = BuildingDimensions {
                    kind: BuildingKind::Terrace,
                    width: SLIM_M[0] as f32,
                    depth: SLIM_M[1] as f32,
                    ..dimensions
                };
                let dense = quarter.storeys.1 >= 5;
                let slim = WantedLot {
                    s: s + SLIM_M[0] / 2.0,
                    size: SLIM_M.into(),
                    set_back: 0.15,
                    kind: BuildingKind::Terrace,
                };
                let rect = dense.then(|| self.lot(lane, side, slim, occupied))?;
                Some((dimensions, rect?))
            };
            let porch = if kind == BuildingKind::House { PORCH_M } else { 0.0 };
            let wide = wide.map(|rect| (dimensions, rect, set_back + porch));
            match wide.or_else(|| narrow().map(|(dimensions, rect)| (dimensions, rect, 0.15))) {
                Some((dimensions, rect, front_m)) => {
                    let kind = dimensions.kind;
                    occupied.take(rect.grown(eaves(kind) + if kind == BuildingKind::House { 1.3 } else { 0.0 }));
                    built.push((self.raise(dimensions, &rect, seed, numbers), FrontYard { rect, front_m, kind }));
                    s += 2.0 * rect.half.x + gap;
                }
                None => s += 5.0,
            }
        }
    }

    /// What is built at a place; `None` where the map says that nothing is.
    fn quarter(&self, p: DVec2, around_known: f64) -> Option<QuarterProfile> {
        let area = self.areas.at(p);
        if let Some(zone) = self.preset.zones.iter().find(|zone| inside(&zone.outline, p)) {
            let quarter = QuarterProfile { kinds: zone.kinds, storeys: zone.storeys, open: zone.open };
            return may_be_built_on(area).then_some(quarter);
        }
        let usual = usual_quarter(self.density.at(p));
        let built_up = area.is_some() || self.density.at(p) >= QUARTERS[1].0;
        let known = self.mapped.as_ref().is_some_and(|m| !built_up || m.is_near(p, around_known));
        if known || !may_be_built_on(area) {
            return None;
        }
        Some(match area {
            Some(LandUse::Industrial) => WORKS,
            Some(LandUse::Commercial) => TRADE,
            Some(_) if self.density.at(p) < QUARTERS[1].0 => QUARTERS[1].1,
            _ => usual,
        })
    }

    /// A free rectangle beside a lane, its front towards the road.
    fn lot(&self, lane: &Lane, side: f64, wanted: WantedLot, occupied: &OccupiedSpace) -> Option<Rect> {
        let WantedLot { s, size: (width, depth), set_back, kind } = wanted;
        let place = lane.centerline.at(s);
        let out = unit(place.heading_rad).perp() * side;
        let here = place.position.truncate();
        // Beyond the last pavement: a metre and a half without any.
        let steps = 70;
        let paved = |d: f64| self.pavement.is_paved(here + out * d);
        let edge =
            (0..steps).map(|k| 0.5 * f64::from(k)).find(|&d| [0.0, 0.5, 1.0, 1.5].iter().all(|e| !paved(d + e)))?;
        let porch = if kind == BuildingKind::House { PORCH_M } else { 0.0 };
        let centre = here + out * (edge + set_back + porch + depth / 2.0);
        // The front looks at the road: the lot lies to the left of its axis.
        let rect = Rect { centre, half: DVec2::new(width / 2.0, depth / 2.0), axis: -out.perp() };
        let margin = if kind == BuildingKind::Terrace { 0.3 } else { 1.0 };
        let clear = self.clear_of_pavement(&rect.grown(margin)) && occupied.is_free(&rect.grown(eaves(kind)));
        let (low, high) = self.land.range(&rect.corners());
        let clear = clear && rect.corners().into_iter().all(|p| may_be_built_on(self.areas.at(p)));
        let clear = clear && !builds_into_view(self.sites, &rect);
        (clear && high - low < STEEPEST_M && (low - place.position.z).abs() < 4.0).then_some(rect)
    }

    fn clear_of_pavement(&self, rect: &Rect) -> bool {
        let steps = |half: f64| (half * 2.0 / 2.0).ceil().max(1.0) as i32;
        let (nx, ny) = (steps(rect.half.x), steps(rect.half.y));
        (0..=nx).all(|i| {
            (0..=ny).all(|j| {
                let x = rect.half.x * (2.0 * f64::from(i) / f64::from(nx) - 1.0);
                let y = rect.half.y * (2.0 * f64::from(j) / f64::from(ny) - 1.0);
                !self.pavement.is_paved(rect.centre + rect.axis * x + rect.axis.perp() * y)
            })
        })
    }

    fn raise(
        &self,
        dimensions: BuildingDimensions,
        rect: &Rect,
        seed: u64,
        numbers: &mut WindowNumbers,
    ) -> PlacedBuilding {
        let front = rect.centre - rect.axis.perp() * rect.half.y;
        let base = self.land.level(front).max(self.land.range(&rect.corners()).0);
        let half = rect.half.x;
        let depth = 2.0 * rect.half.y;
        let local = [(-half, 0.0), (half, 0.0), (half, depth), (-half, depth)].map(|(x, y)| DVec2::new(x, y));
        let mut stream = Stream::named(seed, "town/building", &[]);
        let color = (self.preset.bright && is_low(&dimensions)).then(|| faded(*stream.pick(BRIGHT), seed));
        // Terraces stand wall to wall.
        let wall_to_wall = dimensions.kind == BuildingKind::Terrace;
        let blind = [false, wall_to_wall, false, wall_to_wall];
        let block = BuildingOutline { outline: &local, holes: &[], front: 0, blind: &blind, color, height: None };
        let flat = self.preset.bright && dimensions.storeys <= 4;
        let (mesh, top) = if flat {
            house(&dimensions, &block, &mut stream, numbers)
        } else {
            on_rectangle(&dimensions, &block, &mut stream, numbers)
        };
        let angle = endless_world::math::f64::atan2(rect.axis.y, rect.axis.x);
        let turn = Quat::from_rotation_z(angle as f32);
        let solid = BuildingPrism { outline: rect.corners().to_vec(), base, top: base + f64::from(top) };
        PlacedBuilding { mesh, place: Affine3A::from_rotation_translation(turn, front.extend(base).as_vec3()), solid }
    }
}

/// Whether a building is a house, or as low as one: large ones have the colours of their materials.
fn is_low(dimensions: &BuildingDimensions) -> bool {
    let low = matches!(
        dimensions.kind,
        BuildingKind::House | BuildingKind::Terrace | BuildingKind::Shop | BuildingKind::Flats
    );
    low && dimensions.storeys <= 5
}

/// A bright colour, bleached by the sun for longer or shorter.
fn faded(paint: [f32; 3], seed: u64) -> [f32; 3] {
    const BLEACHED: [f32; 3] = [0.62, 0.60, 0.56];
    let share = Stream::named(seed, "town/building/bleached", &[]).range_f32(0.0, 0.6);
    std::array::from_fn(|k| lerp(paint[k], BLEACHED[k], share))
}
