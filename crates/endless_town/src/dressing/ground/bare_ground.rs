//! Land cover where the map has no land use.

use super::land_use_map::LandUseMap;
use crate::dressing::built_up::density::StreetDensity;
use crate::geometry::unit;
use crate::palette::{GRAVEL, LAWN, MEADOW, SOIL, YARD, YARD_DARK, YARD_SLABS};
use endless_road::{LandUse, Lane, RoadNetwork};
use endless_scene::Material;
use endless_world::fnv1a;
use endless_world::math::f64::{atan2, sin, sin_cos};
use glam::DVec2;

/// Metres of lane on a hectare from which land is built up, and from which its yards are paved.
const BUILT_UP: f64 = 60.0;
const PAVED: f64 = 130.0;
/// Size of a piece of ground along and across the streets, metres.
const PARCEL_M: [f64; 2] = [19.0, 26.0];

/// Who owns which piece of the ground between houses: a grid along the map's streets, each piece paved or
/// planted in its own way.
#[derive(Debug, Clone)]
pub(crate) struct YardParcels {
    axis: DVec2,
    /// Share of pieces that are not paved.
    green: f64,
}

impl YardParcels {
    pub(crate) fn new(network: &RoadNetwork, green: f64) -> Self {
        // Streets that cross at right angles share one direction of four times the angle.
        let along = |lane: &Lane| {
            let steps = lane.centerline.points().windows(2).map(|p| (p[1] - p[0]).truncate());
            steps.fold(DVec2::ZERO, |sum, step| {
                let (sin, cos) = sin_cos(4.0 * atan2(step.y, step.x));
                sum + DVec2::new(cos, sin) * step.length()
            })
        };
        let sum = network.lanes.iter().filter(|l| l.junction.is_none()).map(along).sum::<DVec2>();
        Self { axis: unit(atan2(sum.y, sum.x) / 4.0), green }
    }

    /// How the piece at a place is paved, or what grows on it.
    fn ground(&self, p: DVec2) -> Material {
        let row = (p.dot(self.axis.perp()) / PARCEL_M[1]).floor() as i64;
        // Rows are shifted against each other, as lots on two sides of a block are.
        let column = (p.dot(self.axis) / PARCEL_M[0] + 0.37 * row as f64).floor() as i64;
        let owner = [column.to_le_bytes(), row.to_le_bytes()].into_iter().flatten();
        let lot = fnv1a(owner);
        if ((lot >> 20 & 1023) as f64) < 1024.0 * self.green {
            return [LAWN, LAWN, MEADOW, SOIL][(lot >> 30 & 3) as usize];
        }
        match lot >> 40 & 15 {
            0..6 => YARD,
            6..11 => YARD_SLABS,
            11..15 => YARD_DARK,
            _ => GRAVEL,
        }
    }
}

/// What covers a place of which the map says nothing, or that people live there: meadows outside, lawns where roads
/// are many, with yards paved in the midst of towns where there are `parcels`. Its borders wind.
pub(crate) fn bare(p: DVec2, density: &StreetDensity, areas: &LandUseMap, parcels: Option<&YardParcels>) -> Material {
    let winding = sin(0.093 * p.x + 1.7 * sin(0.041 * p.y)) + sin(0.087 * p.y + 1.9 * sin(0.047 * p.x));
    let here = density.at(p) + 9.0 * winding;
    match here {
        d if d > PAVED
            && let Some(parcels) = parcels =>
        {
            parcels.ground(p)
        }
        d if d > BUILT_UP || areas.at(p) == Some(LandUse::Residential) => LAWN,
        _ => MEADOW,
    }
}
