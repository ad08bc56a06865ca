//! Grass that grows over the edges of pavements, where cameras stand near: nobody cuts it to a line.

use super::detail_ground::camera_stream;
use super::lawn::{LawnDetail, LawnKind};
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::ground::pavement_index::PavementPiece;
use crate::geometry::unit;
use endless_asset::Prop;
use endless_road::LaneType;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::TAU;

/// Edges are seen from here to here, metres from the lens.
const SEEN_M: [f64; 2] = [5.0, 26.0];
/// Between two tufts, on average, metres.
const STEP_M: f64 = 0.32;
/// Share of places without one.
const BARE: f64 = 0.3;
/// Most tufts before a camera.
const MOST: usize = 380;
/// A lawn begins within this distance of the edge, metres; nearer than what it carries, it says nothing of itself.
const LAWN_M: f64 = 0.9;

impl LawnDetail<'_> {
    /// Puts small tufts along the edges of sidewalks that lie on lawns.
    pub(crate) fn fray_edges(&self, assembly: &mut TownAssembly<'_>, sites: &[CameraSite]) {
        for site in sites {
            let mut stream = camera_stream(assembly, 145_000, site);
            let before = assembly.placements.len();
            for piece in
                self.ground.pavement.pieces.iter().filter(|piece| piece.kind == LaneType::Sidewalk && sees(site, piece))
            {
                let [right, right_end, left_end, left] = piece.corners.map(DVec3::truncate);
                for (from, to, side) in [(right, right_end, -1.0), (left, left_end, 1.0)] {
                    if assembly.placements.len() - before < MOST {
                        self.edge(assembly, from, to, (to - from).normalize_or_zero().perp() * side, &mut stream);
                    }
                }
            }
        }
    }

    /// One edge of a pavement; `out` points away from it.
    fn edge(&self, assembly: &mut TownAssembly<'_>, from: DVec2, to: DVec2, out: DVec2, stream: &mut Stream) {
        let steps = (from.distance(to) / STEP_M).ceil() as usize;
        for k in 0..steps {
            let along = from.lerp(to, (k as f64 + stream.f64()) / steps as f64);
            let (aside, turn) = (stream.range_f64(-0.01, 0.10), stream.range_f64(0.0, TAU));
            let size = stream.range_f32(0.18, 0.42);
            let grows = || matches!(self.lawn(along + out * LAWN_M), Some(LawnKind::Kept | LawnKind::Wild));
            let at = along + out * aside;
            if stream.chance(BARE)
                || self.ground.pavement.is_paved(along + out * 0.12)
                || self.is_crossed(at)
                || !grows()
            {
                continue;
            }
            let scale = Vec3::new(1.15 * size, 1.15 * size, size);
            assembly.place(
                Prop::GrassTuft,
                PropPose { z: self.ground.land.height(at) - 0.01, scale, ..PropPose::new(at, turn) },
                None,
            );
        }
    }
}

/// Whether a camera looks at a piece from near by.
fn sees(site: &CameraSite, piece: &PavementPiece) -> bool {
    let [x, y, _] = site.position.map(f64::from);
    let towards = piece.middle().truncate() - DVec2::new(x, y);
    let ahead = towards.normalize_or_zero().dot(unit(f64::from(site.yaw_rad)));
    (SEEN_M[0]..SEEN_M[1]).contains(&towards.length())
        && ahead > endless_world::math::f64::cos(f64::from(site.horizontal_fov_rad) / 2.0)
}
