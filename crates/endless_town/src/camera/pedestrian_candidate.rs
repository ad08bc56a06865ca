//! Camera candidates at squares and in parks.

use super::candidate::{CameraAim, CameraCandidate, CandidateFinder, ViewKind, aimed};
use super::height_field::TopSurface;
use super::roadside::POLE_M;
use crate::geometry::{inside, unit};
use endless_world::Mount;
use glam::DVec2;

/// Distance between places around squares and along ways, metres.
const OPEN_STEP_M: f64 = 6.0;

impl CandidateFinder<'_> {
    /// From the edge of a square over it.
    pub(super) fn at_square(&mut self, outline: &[DVec2]) {
        let middle = outline.iter().sum::<DVec2>() / outline.len() as f64;
        let turned = CameraAim { height: 6.8, fov_deg: 74.0, mount: Mount::Pole };
        for k in 0..outline.len() {
            let (a, b) = (outline[k], outline[(k + 1) % outline.len()]);
            let steps = (a.distance(b) / OPEN_STEP_M).ceil() as usize;
            for i in 0..steps {
                let edge = a.lerp(b, (i as f64 + 0.5) / steps as f64);
                let inwards = (middle - edge).normalize_or(DVec2::X);
                let foot = edge + inwards * POLE_M;
                for turn in [-0.6f64, -0.25, 0.25, 0.6] {
                    let ahead = unit(turn).rotate(inwards);
                    self.push_on_foot(ViewKind::Square, foot, foot + ahead * 20.0, turned);
                }
            }
        }
    }

    /// From beside the ways in a park along them.
    pub(super) fn in_park(&mut self, outline: &[DVec2]) {
        let walk = &self.network.walk;
        let turned = CameraAim { height: 5.6, fov_deg: 70.0, mount: Mount::Pole };
        for edge in &walk.edges {
            let [from, to] = edge.nodes.map(|n| walk.nodes[n.index()].truncate());
            if !inside(outline, from.midpoint(to)) {
                continue;
            }
            let along = (to - from).normalize_or(DVec2::X);
            for side in [-1.0, 1.0] {
                let foot = from.midpoint(to) + along.perp() * (side * (edge.width_m / 2.0 + POLE_M));
                for turn in [0.12f64, 0.5] {
                    for ahead in [along, -along] {
                        let turn = -turn * side * ahead.dot(along);
                        self.push_on_foot(ViewKind::Park, foot, foot + unit(turn).rotate(ahead) * 17.0, turned);
                    }
                }
            }
        }
    }

    /// Where people walk, if a pole may stand there.
    pub(super) fn push_on_foot(&mut self, view: ViewKind, foot: DVec2, aim: DVec2, turned: CameraAim) {
        let (ground, top) = self.relief.at(foot);
        let (level, _) = self.relief.at(aim);
        if !matches!(top, TopSurface::Walk | TopSurface::Green | TopSurface::Ground) || (level - ground).abs() > 3.0 {
            return;
        }
        let (ground, level) = (f64::from(ground), f64::from(level));
        let lens = foot + (aim - foot).normalize_or(DVec2::X) * 0.4;
        let site = aimed(lens, ground, aim, level, turned);
        self.found.push(CameraCandidate { view, pole: Some((foot, ground)), level, site });
    }
}
