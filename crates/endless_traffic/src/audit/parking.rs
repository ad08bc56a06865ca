//! Who parks at the kerb: in bays, and beside the lane on purpose on the way there and back.

use super::cell_grid::CellGrid;
use super::check::AuditCheck;
use super::finding::Worst;
use super::report::AuditLine;
use super::sight::{Glance, Sight};
use crate::parking_manoeuvre::{corners, outside_m};
use crate::parking_place::body;
use endless_road::swept::OrientedRectangle;
use endless_world::{Parking, ParkingBay};
use glam::DVec2;

/// Between a lane and the bays beside it is no more than this, metres.
const GUTTER_M: f64 = 0.6;

/// Watches those who park.
#[derive(Debug, Default)]
pub(super) struct ParkedBodies {
    bays: Vec<OrientedRectangle>,
    grid: CellGrid,
    beside_bay: Worst,
}

/// Whether somebody stands parked for a while.
pub(super) fn is_parked(glance: &Glance<'_>) -> bool {
    glance.actor.behaviour.parking == Some(Parking::Parked)
}

impl ParkedBodies {
    pub(super) fn new(bays: &[ParkingBay]) -> Self {
        let bays: Vec<OrientedRectangle> = bays.iter().map(body).collect();
        let mut grid = CellGrid::default();
        grid.rebuild(bays.iter().map(|bay| {
            let reach = DVec2::splat(bay.half.length() + 2.0 * GUTTER_M);
            [bay.center - reach, bay.center + reach]
        }));
        Self { bays, grid, beside_bay: Worst::default() }
    }

    pub(super) fn look(&mut self, sight: &Sight<'_>) {
        for glance in sight.glances.iter().filter(|glance| is_parked(glance)) {
            let Some((_, spec)) = glance.driven else { continue };
            let body = OrientedRectangle::new(spec, glance.at, f64::from(glance.actor.pose.yaw_rad), 0.0);
            let outside = corners(&body).map(|corner| self.outside_m(corner));
            self.beside_bay.note(outside.into_iter().fold(0.0, f64::max), || glance.told(sight));
        }
    }

    /// How far a place is outside of all bays, metres, if one is near.
    fn outside_m(&self, at: DVec2) -> f64 {
        let near: Vec<OrientedRectangle> = self.grid.near([at, at]).map(|bay| self.bays[bay]).collect();
        outside_m(&near, at)
    }

    /// Whether a place is in a bay, or between one and its lane.
    pub(super) fn hold(&self, at: DVec2) -> bool {
        self.outside_m(at) < GUTTER_M
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![self.beside_bay.line(AuditCheck::BesideBay)]
    }
}
