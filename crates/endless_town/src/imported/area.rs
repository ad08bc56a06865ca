//! What covers the land: fields, woods, lawns as the ground's own colour; squares, car parks and water laid upon it.

use super::land::Land;
use crate::palette::{CAR_PARK, FIELD, GRAVEL, LAWN, MEADOW, PLAZA, SOIL, WATER, WOODLAND, YARD};
use crate::plot::inside;
use crate::surface::{area, triangulate, with_holes};
use endless_asset::{Material, MeshBuilder};
use endless_road::{Area, AreaKind};
use glam::{DVec2, Vec3};

/// Land that is flatter than this over an area can carry it as one plane, metres.
const FLAT_M: f64 = 0.25;

/// Areas with their bounds.
pub(super) struct Areas<'a> {
    list: Vec<(&'a Area, DVec2, DVec2)>,
}

impl<'a> Areas<'a> {
    pub(super) fn new(areas: &'a [Area]) -> Self {
        let mut list: Vec<(&Area, DVec2, DVec2)> = areas
            .iter()
            .filter(|a| a.outline.len() >= 3)
            .map(|a| {
                let low = a.outline.iter().fold(DVec2::INFINITY, |l, &p| l.min(p));
                (a, low, a.outline.iter().fold(DVec2::NEG_INFINITY, |h, &p| h.max(p)))
            })
            .collect();
        // Small areas lie upon large ones.
        list.sort_by(|a, b| area(&a.0.outline).abs().total_cmp(&area(&b.0.outline).abs()));
        Self { list }
    }

    /// The smallest area at a place.
    pub(super) fn at(&self, p: DVec2) -> Option<AreaKind> {
        let within = |a: &&(&Area, DVec2, DVec2)| {
            p.cmpge(a.1).all()
                && p.cmple(a.2).all()
                && inside(&a.0.outline, p)
                && !a.0.holes.iter().any(|h| inside(h, p))
        };
        self.list.iter().find(within).map(|a| a.0.kind)
    }

    /// All of a kind.
    pub(super) fn of(&self, kind: AreaKind) -> impl Iterator<Item = &'a Area> {
        self.list.iter().filter(move |a| a.0.kind == kind).map(|a| a.0)
    }

    /// What the ground is made of at a place; `usual` where no area says.
    pub(super) fn material(&self, p: DVec2, usual: Material) -> Material {
        self.at(p).map_or(usual, ground)
    }

    /// Lays plazas, car parks and water on flat land with sharp borders, larger ones below smaller ones.
    pub(super) fn lay(&self, mesh: &mut MeshBuilder, land: &Land) {
        let sharp =
            |kind: AreaKind| matches!(kind, AreaKind::Plaza | AreaKind::Parking | AreaKind::Water | AreaKind::Park);
        for (place, (area_, ..)) in self.list.iter().rev().filter(|a| sharp(a.0.kind)).enumerate() {
            let (low, high) = land.range(&area_.outline);
            if high - low > FLAT_M {
                continue;
            }
            let mut outline = area_.outline.clone();
            if area(&outline) < 0.0 {
                outline.reverse();
            }
            outline.dedup();
            let joined = with_holes(&outline, &area_.holes);
            // Above the ground beside pavements, below the pavements.
            let z = high - 0.035 + 0.000_05 * (place % 400) as f64;
            let base = mesh.vertices(joined.iter().map(|p| (p.extend(z).as_vec3(), Vec3::Z, p.as_vec2())));
            for t in triangulate(&joined) {
                if area(&t.map(|k| joined[k])) > 1e-4 {
                    mesh.triangle_indices(t.map(|k| base + k as u32), ground(area_.kind));
                }
            }
        }
    }
}

fn ground(kind: AreaKind) -> Material {
    match kind {
        AreaKind::Park | AreaKind::Residential => LAWN,
        AreaKind::Wood => WOODLAND,
        AreaKind::Farmland => FIELD,
        AreaKind::Grass => MEADOW,
        AreaKind::Water => WATER,
        AreaKind::Plaza => PLAZA,
        AreaKind::Parking => CAR_PARK,
        AreaKind::Commercial => YARD,
        AreaKind::Industrial => GRAVEL,
        AreaKind::Bare => SOIL,
    }
}
