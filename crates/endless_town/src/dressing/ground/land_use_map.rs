//! What covers the land: squares, lawns, fields and water, laid upon flat land or as the colour of uneven land.

use crate::camera::OpenSpace;
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::geometry::inside;
use crate::geometry::{area, triangulate};
use crate::palette::{CAR_PARK, FIELD, GRAVEL, LAWN, MEADOW, PLAZA, PLAZA_BAND, SOIL, WATER, WOODLAND, YARD};
use endless_road::{LandUse, LandUseArea};
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, Vec3};

/// Land that is flatter than this over an area can carry it as one plane, metres.
const FLAT_M: f64 = 0.03;

/// Distance between points at which the rim of an area is looked at, metres, and most of them on one side.
const RIM_STEP_M: f64 = 1.5;
const MOST_STEPS: f64 = 2000.0;

/// Bands of squares: how far apart, how wide, how long their pieces, how far above the paving; metres.
const BANDS_M: f64 = 6.9;
const BAND_M: f64 = 0.45;
const BAND_PIECE_M: f64 = 1.15;
const BAND_LIFT_M: f64 = 0.004;

/// An area with its bounds.
#[derive(Debug, Clone)]
struct BoundedArea {
    area: LandUseArea,
    low: DVec2,
    high: DVec2,
    /// The height of flat land, on which it lies with sharp borders; uneven land takes its colour instead.
    flat: Option<f64>,
}

/// Areas, the smaller before the larger.
#[derive(Debug, Clone)]
pub(crate) struct LandUseMap {
    list: Vec<BoundedArea>,
    /// The land is lower under water than beside it.
    relief: bool,
}

impl LandUseMap {
    pub(crate) fn new(areas: &[LandUseArea], land: &GroundGrid, relief: bool) -> Self {
        let mut list: Vec<BoundedArea> = areas
            .iter()
            .filter(|a| a.outline.len() >= 3)
            .map(|area| {
                let low = area.outline.iter().fold(DVec2::INFINITY, |l, &p| l.min(p));
                let high = area.outline.iter().fold(DVec2::NEG_INFINITY, |h, &p| h.max(p));
                let middle = area.outline.iter().sum::<DVec2>() / area.outline.len() as f64;
                let inner: &[f64] = if relief { &[0.0, 0.3, 0.6] } else { &[0.0] };
                let rim = dense(&area.outline);
                let places: Vec<DVec2> =
                    inner.iter().flat_map(|&t| rim.iter().map(move |p| p.lerp(middle, t))).collect();
                let (least, most) = land.range(&places);
                let flat = if relief && area.kind == LandUse::Water {
                    // Water finds its level between the banks.
                    Some(land.middle(&area.outline))
                } else {
                    (most - least < FLAT_M).then_some(most)
                };
                BoundedArea { area: area.clone(), low, high, flat }
            })
            .collect();
        // Small areas lie upon large ones.
        list.sort_by(|a, b| area(&a.area.outline).abs().total_cmp(&area(&b.area.outline).abs()));
        Self { list, relief }
    }

    /// Squares and parks.
    pub(crate) fn open(&self) -> Vec<OpenSpace> {
        let open = |b: &BoundedArea| {
            let park = b.area.kind == LandUse::Park;
            (park || b.area.kind == LandUse::Plaza).then(|| OpenSpace { outline: b.area.outline.clone(), park })
        };
        self.list.iter().filter_map(open).collect()
    }

    fn over(&self, p: DVec2) -> impl Iterator<Item = &BoundedArea> {
        self.list.iter().filter(move |a| {
            p.cmpge(a.low).all()
                && p.cmple(a.high).all()
                && inside(&a.area.outline, p)
                && !a.area.holes.iter().any(|h| inside(h, p))
        })
    }

    /// The smallest area at a place.
    pub(crate) fn at(&self, p: DVec2) -> Option<LandUse> {
        self.over(p).next().map(|a| a.area.kind)
    }

    /// All of a kind.
    pub(crate) fn of(&self, kind: LandUse) -> impl Iterator<Item = &LandUseArea> {
        self.list.iter().filter(move |a| a.area.kind == kind).map(|a| &a.area)
    }

    /// What the ground is made of at a place; `usual` where no area says, or one is laid upon the ground.
    pub(crate) fn material(&self, p: DVec2, usual: &dyn Fn() -> Material) -> Material {
        let bed = |a: &BoundedArea| self.relief && a.area.kind == LandUse::Water;
        let own = |a: &BoundedArea| if bed(a) { Some(SOIL) } else { ground(a.area.kind) };
        self.over(p).filter(|a| a.flat.is_none() || bed(a)).find_map(own).unwrap_or_else(usual)
    }

    /// Lays areas on flat land with sharp borders, larger ones below smaller ones.
    pub(crate) fn lay(&self, mesh: &mut MeshBuilder) {
        for (place, bounded) in self.list.iter().rev().enumerate() {
            let (Some(level), Some(material)) = (bounded.flat, ground(bounded.area.kind)) else { continue };
            let mut outline = bounded.area.outline.clone();
            if area(&outline) < 0.0 {
                outline.reverse();
            }
            outline.dedup();
            if outline.len() < 3 {
                continue;
            }
            let (corners, triangles) = triangulate(&outline, &bounded.area.holes);
            // Above the ground beside pavements, below the pavements.
            let z = level - 0.048 + 0.000_1 * (place % 350) as f64;
            let base = mesh.vertices(corners.iter().map(|p| (p.extend(z).as_vec3(), Vec3::Z, p.as_vec2())));
            for t in triangles {
                if area(&t.map(|k| corners[k])) > 1e-4 {
                    mesh.triangle_indices(t.map(|k| base + k as u32), material);
                }
            }
            if bounded.area.kind == LandUse::Plaza {
                add_bands(mesh, &bounded.area, z + BAND_LIFT_M);
            }
        }
    }
}

/// Points along an outline: those between its corners, too, so that a road that cuts into an area is noticed.
fn dense(outline: &[DVec2]) -> Vec<DVec2> {
    let mut points = Vec::with_capacity(outline.len());
    for (k, &a) in outline.iter().enumerate() {
        let b = outline[(k + 1) % outline.len()];
        let n = (a.distance(b) / RIM_STEP_M).ceil().clamp(1.0, MOST_STEPS);
        points.extend((0..n as usize).map(|i| a.lerp(b, i as f64 / n)));
    }
    points
}

/// Bands of darker stone across a square.
fn add_bands(mesh: &mut MeshBuilder, square: &LandUseArea, z: f64) {
    let rect = crate::geometry::around(&square.outline);
    let within = |p: DVec2| inside(&square.outline, p) && !square.holes.iter().any(|h| inside(h, p));
    for (axis, along, across) in [(rect.axis, rect.half.x, rect.half.y), (rect.axis.perp(), rect.half.y, rect.half.x)] {
        for line in bands(across) {
            for k in 0..(2.0 * along / BAND_PIECE_M).floor() as usize {
                let from = rect.centre + axis.perp() * line + axis * (BAND_PIECE_M * k as f64 - along);
                let (to, side) = (from + axis * BAND_PIECE_M, axis.perp() * (BAND_M / 2.0));
                let corners = [from - side, to - side, to + side, from + side];
                if corners.iter().all(|&p| within(p)) {
                    let at = corners.map(|p| p.extend(z).as_vec3());
                    mesh.quad(at, corners.map(DVec2::as_vec2), PLAZA_BAND);
                }
            }
        }
    }
}

/// Where bands lie across half a width, symmetric about the middle.
fn bands(half: f64) -> impl Iterator<Item = f64> {
    let n = (half / BANDS_M).floor() as i32;
    (-n..=n).map(|k| f64::from(k) * BANDS_M)
}

/// What covers an area; `None` where it says nothing of it.
fn ground(kind: LandUse) -> Option<Material> {
    Some(match kind {
        LandUse::Residential => return None,
        LandUse::Park => LAWN,
        LandUse::Wood => WOODLAND,
        LandUse::Farmland => FIELD,
        LandUse::Grass => MEADOW,
        LandUse::Water => WATER,
        LandUse::Plaza => PLAZA,
        LandUse::Parking => CAR_PARK,
        LandUse::Commercial => YARD,
        LandUse::Industrial => GRAVEL,
        LandUse::Bare => SOIL,
    })
}
