//! What is town and what is country: which roads are streets, where buildings are known, what covers bare ground.

use super::area::Areas;
use super::cover::Cover;
use super::growth::Density;
use crate::geometry::unit;
use crate::palette::{GRAVEL, LAWN, MEADOW, YARD, YARD_DARK, YARD_SLABS};
use endless_road::{AreaKind, BuildingFootprint, Lane, RoadNetwork, StripKind};
use endless_scene::Material;
use endless_world::fnv1a;
use endless_world::math::f64::{atan2, sin, sin_cos};
use glam::DVec2;

/// Faster roads without sidewalks have no houses along them, m/s.
const OPEN_ROAD_MPS: f64 = 20.5;
/// How far from a lane its sidewalk may be, metres.
const SIDEWALK_M: f64 = 16.0;
/// Metres of lane on a hectare from which land is built up, and from which its yards are paved.
pub(super) const BUILT_UP: f64 = 60.0;
pub(super) const PAVED: f64 = 130.0;
/// Size of a piece of ground along and across the streets, metres.
const PARCEL_M: [f64; 2] = [19.0, 26.0];
/// Side of the cells of [`Mapped`], metres.
const CELL_M: f64 = 10.0;

/// For each lane, whether it belongs to a street: slow, or with a sidewalk, as fast roads in towns have.
pub(super) fn streets(network: &RoadNetwork, cover: &Cover) -> Vec<bool> {
    let has_sidewalk = |lane: &Lane| {
        let place = lane.centerline.at(lane.centerline.length() / 2.0);
        let (here, z) = (place.position.truncate(), place.position.z);
        let walk = |p: DVec2| cover.at(p).any(|(piece, h)| piece.kind == StripKind::Sidewalk && (h - z).abs() < 1.0);
        [-1.0, 1.0].iter().any(|side| {
            let out = unit(place.heading_rad).perp() * *side;
            (2..=SIDEWALK_M as i32).any(|d| walk(here + out * f64::from(d)))
        })
    };
    network
        .lanes
        .iter()
        .map(|l| l.junction.is_none() && (l.speed_limit_mps < OPEN_ROAD_MPS || has_sidewalk(l)))
        .collect()
}

/// Where the map has buildings, on a grid.
pub(super) struct Mapped {
    low: DVec2,
    columns: usize,
    cells: Vec<bool>,
}

impl Mapped {
    pub(super) fn new(footprints: &[BuildingFootprint], low: DVec2, high: DVec2) -> Self {
        let size = (high - low).max(DVec2::ONE) / CELL_M;
        let (columns, rows) = (size.x.ceil() as usize, size.y.ceil() as usize);
        let mut mapped = Self { low, columns, cells: vec![false; columns * rows] };
        for footprint in footprints {
            let ring = footprint.outline.iter().zip(footprint.outline.iter().cycle().skip(1));
            for (a, b) in ring.filter(|(a, b)| a.is_finite() && b.is_finite()) {
                let steps = (a.distance(*b) / CELL_M).ceil().clamp(1.0, 200.0) as usize;
                for i in 0..steps {
                    if let Some(cell) = mapped.cell(a.lerp(*b, i as f64 / steps as f64)) {
                        mapped.cells[cell] = true;
                    }
                }
            }
        }
        mapped
    }

    fn cell(&self, p: DVec2) -> Option<usize> {
        let q = (p - self.low) / CELL_M;
        let (x, y) = (q.x.floor(), q.y.floor());
        let inside = x >= 0.0 && y >= 0.0 && (x as usize) < self.columns;
        inside.then(|| y as usize * self.columns + x as usize).filter(|i| *i < self.cells.len())
    }

    /// Whether a building of the map stands within about `reach` metres.
    pub(super) fn is_near(&self, p: DVec2, reach: f64) -> bool {
        let n = (reach / CELL_M).ceil() as i32;
        (-n..=n).any(|y| {
            (-n..=n).any(|x| {
                let step = DVec2::new(f64::from(x), f64::from(y)) * CELL_M;
                step.length() <= reach && self.cell(p + step).is_some_and(|i| self.cells[i])
            })
        })
    }
}

/// Whether people may have built where the map says this of the land.
pub(super) fn may_be_built_on(area: Option<AreaKind>) -> bool {
    matches!(area, None | Some(AreaKind::Residential | AreaKind::Commercial | AreaKind::Industrial))
}

/// Who owns which piece of the ground between houses: a grid along the map's streets, each piece paved in its own way.
pub(super) struct Parcels {
    axis: DVec2,
}

impl Parcels {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        // Streets that cross at right angles share one direction of four times the angle.
        let along = |lane: &Lane| {
            let steps = lane.centerline.points().windows(2).map(|p| (p[1] - p[0]).truncate());
            steps.fold(DVec2::ZERO, |sum, step| {
                let (sin, cos) = sin_cos(4.0 * atan2(step.y, step.x));
                sum + DVec2::new(cos, sin) * step.length()
            })
        };
        let sum = network.lanes.iter().filter(|l| l.junction.is_none()).map(along).sum::<DVec2>();
        Self { axis: unit(atan2(sum.y, sum.x) / 4.0) }
    }

    /// How the piece at a place is paved.
    fn paving(&self, p: DVec2) -> Material {
        let row = (p.dot(self.axis.perp()) / PARCEL_M[1]).floor() as i64;
        // Rows are shifted against each other, as lots on two sides of a block are.
        let column = (p.dot(self.axis) / PARCEL_M[0] + 0.37 * row as f64).floor() as i64;
        let owner = [column.to_le_bytes(), row.to_le_bytes()].into_iter().flatten();
        match fnv1a(owner) >> 40 & 15 {
            0..6 => YARD,
            6..11 => YARD_SLABS,
            11..15 => YARD_DARK,
            _ => GRAVEL,
        }
    }
}

/// What covers a place of which the map says nothing, or that people live there: meadows outside, lawns where roads
/// are many, with yards paved in the midst of towns where there are `parcels`. Its borders wind.
pub(super) fn bare(p: DVec2, density: &Density, areas: &Areas<'_>, parcels: Option<&Parcels>) -> Material {
    let winding = sin(0.093 * p.x + 1.7 * sin(0.041 * p.y)) + sin(0.087 * p.y + 1.9 * sin(0.047 * p.x));
    let here = density.at(p) + 9.0 * winding;
    match here {
        d if d > PAVED
            && let Some(parcels) = parcels =>
        {
            parcels.paving(p)
        }
        d if d > BUILT_UP || areas.at(p) == Some(AreaKind::Residential) => LAWN,
        _ => MEADOW,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mapped_buildings_are_near_where_they_are() {
        let outline = [(50.0, 50.0), (62.0, 50.0), (62.0, 61.0), (50.0, 61.0)].map(|(x, y)| DVec2::new(x, y)).to_vec();
        let (height_m, levels, color) = (None, None, None);
        let footprint = BuildingFootprint { outline, holes: vec![], height_m, levels, kind: "yes".to_owned(), color };
        let mapped = Mapped::new(&[footprint], DVec2::ZERO, DVec2::new(200.0, 100.0));
        assert!(mapped.is_near(DVec2::new(55.0, 30.0), 30.0) && mapped.is_near(DVec2::new(90.0, 55.0), 40.0));
        assert!(!mapped.is_near(DVec2::new(120.0, 55.0), 40.0) && !mapped.is_near(DVec2::new(-500.0, 900.0), 40.0));
    }
}
