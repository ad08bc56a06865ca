//! Places for one vehicle each: along parking lanes and in rows on car parks.

use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::geometry::{Rect, inside};
use endless_road::LaneSurface;
use endless_world::math::f64::atan2;
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// From bay to bay along the kerb, and across it, metres.
const STEPS_M: [f64; 2] = [5.9, 2.6];
/// Length of a bay along the kerb, and of one on a car park, metres.
const ALONG_M: f64 = 5.7;
const IN_ROWS_M: f64 = 5.1;
/// Parking lanes at least this wide are parked in across.
const ACROSS_FROM_M: f64 = 4.4;
/// Narrower ones are not parked in, metres.
const LEAST_M: f64 = 1.75;

/// A place for one vehicle.
#[derive(Debug, Clone, Copy)]
pub(crate) struct ParkingBay {
    pub(crate) at: DVec3,
    pub(crate) yaw: f64,
    pub(crate) grade: f64,
    /// Length and width of what may stand in it, metres.
    pub(crate) room: DVec2,
}

impl ParkingBay {
    /// What is taken by a vehicle that stands here, whichever it is.
    pub(crate) fn rect(&self) -> Rect {
        Rect::new(self.at.truncate(), self.room / 2.0, self.yaw)
    }

    /// Whether one stands in it along the kerb.
    pub(crate) fn is_along(&self) -> bool {
        self.room.x == ALONG_M
    }

    /// As others know it.
    pub(crate) fn told(&self) -> endless_world::ParkingBay {
        let [length_m, width_m] = self.room.as_vec2().to_array();
        endless_world::ParkingBay { position: self.at.as_vec3(), yaw_rad: self.yaw as f32, length_m, width_m }
    }
}

/// Bays of a parking lane.
pub(crate) fn along(strip: &LaneSurface) -> Vec<ParkingBay> {
    let middle: Vec<DVec3> = strip.left.iter().zip(&strip.right).map(|(l, r)| (*l + *r) / 2.0).collect();
    let widths: Vec<f64> = strip.left.iter().zip(&strip.right).map(|(l, r)| l.distance(*r)).collect();
    let mut bays = Vec::new();
    let mut since = 0.0;
    for k in 0..middle.len() - 1 {
        let (a, b) = (middle[k], middle[k + 1]);
        let length = a.distance(b);
        let width = widths[k].min(widths[k + 1]);
        let across = width > ACROSS_FROM_M;
        let step = STEPS_M[usize::from(across)];
        if width < LEAST_M || length < 1e-3 {
            since = 0.0;
            continue;
        }
        let way = (b - a).truncate();
        let heading = atan2(way.y, way.x);
        let mut s = step / 2.0 - since;
        while s <= length {
            if s >= 0.0 {
                let at = a.lerp(b, s / length);
                let grade = (b.z - a.z) / way.length().max(1e-6);
                bays.push(if across {
                    ParkingBay { at, yaw: heading + FRAC_PI_2, grade: 0.0, room: DVec2::new(width, step) }
                } else {
                    ParkingBay { at, yaw: heading, grade, room: DVec2::new(ALONG_M, width) }
                });
            }
            s += step;
        }
        since = (since + length) % step;
    }
    bays
}

/// Double rows of bays on a car park, in the direction of its longest side.
pub(crate) fn rows(
    outline: &[DVec2],
    holes: &[Vec<DVec2>],
    pavement: &PavementIndex,
    land: &GroundGrid,
) -> Vec<ParkingBay> {
    let rect = crate::geometry::around(outline);
    let (axis, half) = if rect.half.x >= rect.half.y {
        (rect.axis, rect.half)
    } else {
        (rect.axis.perp(), DVec2::new(rect.half.y, rect.half.x))
    };
    let within = |p: DVec2| inside(outline, p) && !holes.iter().any(|h| inside(h, p)) && !pavement.is_paved(p);
    let yaw = atan2(axis.y, axis.x) + FRAC_PI_2;
    let room = DVec2::new(IN_ROWS_M, STEPS_M[1]);
    let mut bays = Vec::new();
    let mut y = -half.y + 2.8;
    while y < half.y - 2.5 {
        let mut x = -half.x + 2.0;
        while x < half.x - 1.5 {
            let at = rect.centre + axis * x + axis.perp() * y;
            if Rect::new(at, DVec2::new(2.4, 1.2), yaw).corners().into_iter().all(within) {
                bays.push(ParkingBay { at: at.extend(land.level(at) - 0.03), yaw, grade: 0.0, room });
            }
            x += STEPS_M[1];
        }
        y += if bays.len() % 2 == 0 { 5.2 } else { 11.0 };
    }
    bays
}
