//! Which roads are streets, where buildings are known, and where any may be built.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::geometry::unit;
use endless_road::{BuildingFootprint, LandUse, Lane, LaneType, RoadNetwork};
use glam::DVec2;

/// Faster roads without sidewalks have no houses along them, m/s.
const OPEN_ROAD_MPS: f64 = 20.5;
/// How far from a lane its sidewalk may be, metres.
const SIDEWALK_M: f64 = 16.0;
/// Side of the cells of [`FootprintGrid`], metres.
const CELL_M: f64 = 10.0;

/// For each lane, whether it belongs to a street: slow, or with a sidewalk, as fast roads in towns have.
pub(crate) fn streets(network: &RoadNetwork, pavement: &PavementIndex) -> Vec<bool> {
    let has_sidewalk = |lane: &Lane| {
        let place = lane.centerline.at(lane.centerline.length() / 2.0);
        let (here, z) = (place.position.truncate(), place.position.z);
        let walk = |p: DVec2| pavement.at(p).any(|(piece, h)| piece.kind == LaneType::Sidewalk && (h - z).abs() < 1.0);
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
pub(crate) struct FootprintGrid {
    low: DVec2,
    columns: usize,
    cells: Vec<bool>,
}

impl FootprintGrid {
    pub(crate) fn new(footprints: &[BuildingFootprint], low: DVec2, high: DVec2) -> Self {
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
    pub(crate) fn is_near(&self, p: DVec2, reach: f64) -> bool {
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
pub(crate) fn may_be_built_on(area: Option<LandUse>) -> bool {
    matches!(area, None | Some(LandUse::Residential | LandUse::Commercial | LandUse::Industrial))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn mapped_buildings_are_near_where_they_are() {
        let outline = [(50.0, 50.0), (62.0, 50.0), (62.0, 61.0), (50.0, 61.0)].map(|(x, y)| DVec2::new(x, y)).to_vec();
        let (height_m, levels, color) = (None, None, None);
        let footprint = BuildingFootprint { outline, holes: vec![], height_m, levels, kind: "yes".to_owned(), color };
        let mapped = FootprintGrid::new(&[footprint], DVec2::ZERO, DVec2::new(200.0, 100.0));
        assert!(mapped.is_near(DVec2::new(55.0, 30.0), 30.0) && mapped.is_near(DVec2::new(90.0, 55.0), 40.0));
        assert!(!mapped.is_near(DVec2::new(120.0, 55.0), 40.0) && !mapped.is_near(DVec2::new(-500.0, 900.0), 40.0));
    }
}
