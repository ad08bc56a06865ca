//! Pavements: the surface of every strip, kerbs and edges, bridges.

use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::pavement_index::{PavementIndex, PavementPiece, is_carriageway};
use crate::dressing::pavement::travelled::travelled;
use crate::geometry::triangulate;
use crate::geometry::{OccupiedSpace, Rect};
use crate::palette::NO_LANE;
use crate::palette::{BALLAST, CYCLEWAY, DECK, KERB, LAWN, PAVING, TRACK};
use endless_road::{LaneSurface, LaneType, RoadMap};
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, DVec3, Vec2, Vec3};
use std::collections::BTreeSet;

/// Medians at least this wide are raised, by this much, metres.
const MEDIAN_FROM_M: f64 = 0.7;
const MEDIAN_M: f64 = 0.12;
/// Overlapping strips in junctions lie in layers, this far apart, metres.
const LAYER_M: f64 = 0.000_6;
const LAYERS: usize = 14;
/// Height of paint above all layers.
pub(crate) const PAINT_M: f64 = 0.011;
/// From which height above the land a pavement is a bridge.
const BRIDGE_FROM_M: f64 = 1.3;
/// Thickness of a deck, and size of parapets.
const DECK_M: f64 = 0.9;
const PARAPET_M: [f64; 2] = [0.25, 0.95];
/// Distance between piers along a bridge.
const PIERS_M: f64 = 24.0;

/// The strips as they will lie: medians raised, but those that lie behind a kerb, which are as high as it already.
pub(crate) fn laid(map: &RoadMap) -> Vec<LaneSurface> {
    let mut lane_surfaces: Vec<LaneSurface> =
        map.lane_surfaces.iter().filter(|s| s.left.len() == s.right.len() && s.left.len() > 1).cloned().collect();
    let key = |p: &DVec3| p.to_array().map(f64::to_bits);
    let is_kerb = |s: &&LaneSurface| s.kind == LaneType::Curb;
    let kerbs: BTreeSet<_> =
        lane_surfaces.iter().filter(is_kerb).flat_map(|s| s.left.iter().chain(&s.right)).map(key).collect();
    let behind_kerb = |s: &LaneSurface| s.left.iter().chain(&s.right).any(|p| kerbs.contains(&key(p)));
    for strip in lane_surfaces.iter_mut().filter(|s| s.kind == LaneType::Median && !s.in_junction && !behind_kerb(s)) {
        let widest = strip.left.iter().zip(&strip.right).map(|(l, r)| l.distance(*r)).fold(0.0, f64::max);
        if widest > MEDIAN_FROM_M {
            strip.left.iter_mut().chain(&mut strip.right).for_each(|p| p.z += MEDIAN_M);
        }
    }
    lane_surfaces
}

fn material(strip: &LaneSurface, paving: Material) -> Material {
    let wide = strip.left.iter().zip(&strip.right).map(|(l, r)| l.distance(*r)).fold(0.0, f64::max);
    match strip.kind {
        _ if strip.unpaved => TRACK,
        LaneType::Driving | LaneType::Shoulder | LaneType::Parking => paving,
        LaneType::Biking => CYCLEWAY,
        LaneType::Sidewalk => PAVING,
        LaneType::Curb => KERB,
        LaneType::Median if wide > 1.6 => LAWN,
        LaneType::Median => PAVING,
        LaneType::Rail => BALLAST,
    }
}

/// A layer for every strip in a junction, so that no two that overlap share one, where there are enough; those with traces
/// of wheels, of which none overlap, have the top one to themselves.
fn layers(lane_surfaces: &[LaneSurface], travelled: &[bool]) -> Vec<usize> {
    let boxes: Vec<(DVec2, DVec2)> = lane_surfaces.iter().map(bounds).collect();
    let mut layers: Vec<usize> = travelled.iter().map(|&top| if top { LAYERS } else { 0 }).collect();
    let inside: Vec<usize> =
        (0..lane_surfaces.len()).filter(|&i| lane_surfaces[i].in_junction && !travelled[i]).collect();
    for (place, &i) in inside.iter().enumerate() {
        let mut used = [false; LAYERS];
        for &k in &inside[..place] {
            if boxes[i].0.cmplt(boxes[k].1).all() && boxes[k].0.cmplt(boxes[i].1).all() {
                used[layers[k]] = true;
            }
        }
        layers[i] = used.iter().position(|u| !u).unwrap_or(place % LAYERS);
    }
    layers
}

fn bounds(strip: &LaneSurface) -> (DVec2, DVec2) {
    let points = strip.left.iter().chain(&strip.right).map(|p| p.truncate());
    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)))
}

/// Lays all pavements.
pub(crate) struct PavementMesher<'a> {
    pavement: &'a PavementIndex,
    land: &'a GroundGrid,
    /// By strip.
    materials: Vec<Material>,
    layers: Vec<usize>,
    /// Whether it shows traces of wheels across a junction.
    travelled: Vec<bool>,
}

impl<'a> PavementMesher<'a> {
    pub(crate) fn new(
        lane_surfaces: &'a [LaneSurface],
        pavement: &'a PavementIndex,
        land: &'a GroundGrid,
        paving: Material,
    ) -> Self {
        let materials = lane_surfaces.iter().map(|strip| material(strip, paving)).collect();
        let travelled = travelled(lane_surfaces);
        let layers = layers(lane_surfaces, &travelled);
        Self { pavement, land, materials, layers, travelled }
    }

    /// The pieces under whose middle a pier finds room, which it takes; by number, in order.
    pub(crate) fn piers(&self, occupied: &mut OccupiedSpace) -> Vec<usize> {
        let has_pier = |&(i, from, to): &(usize, f64, f64)| {
            let piece = &self.pavement.pieces[i];
            (from / PIERS_M).floor() < (to / PIERS_M).floor()
                && self.is_high(piece)
                && !self.is_buried(piece, piece.middle())
                && self.pier(piece).is_some_and(|(_, top)| occupied.try_take(Rect::around(top.truncate(), 4.5)))
        };
        self.along().filter(has_pier).map(|(i, ..)| i).collect()
    }

    /// Numbers of the pieces, and from where to where along its strip each goes, metres.
    fn along(&self) -> impl Iterator<Item = (usize, f64, f64)> {
        let (mut to, mut last) = (0.0, u32::MAX);
        self.pavement.pieces.iter().enumerate().map(move |(i, piece)| {
            let from = if piece.strip == last { to } else { 0.0 };
            let [r0, r1, ..] = piece.corners;
            (to, last) = (from + r0.distance(r1), piece.strip);
            (i, from, to)
        })
    }

    /// All pavements, with piers under these pieces.
    pub(crate) fn pave(&self, mesh: &mut MeshBuilder, piers: &[usize]) {
        let pieces = &self.pavement.pieces;
        let mut piers = piers.iter().peekable();
        for (i, along, _) in self.along() {
            let piece = &pieces[i];
            let ends = |other: Option<&PavementPiece>| other.is_none_or(|other| other.strip != piece.strip);
            let (first, last) = (ends(i.checked_sub(1).map(|k| &pieces[k])), ends(pieces.get(i + 1)));
            let lift = LAYER_M * self.layers[piece.strip as usize] as f64;
            for part in self.shown(piece) {
                self.surface(mesh, piece, part, lift, along);
            }
            if self.is_buried(piece, piece.middle()) {
                continue;
            }
            let high = self.is_high(piece);
            self.edges(mesh, piece, [first, last], high);
            if high {
                self.underside(mesh, piece);
            }
            if piers.next_if(|&&pier| pier == i).is_some()
                && let Some((low, top)) = self.pier(piece)
            {
                let half = DVec3::new(0.6, 0.6, 0.0);
                mesh.cuboid((low - half).as_vec3(), (top + half).as_vec3(), DECK);
            }
        }
    }

    /// Whether the land is far below.
    fn is_high(&self, piece: &PavementPiece) -> bool {
        let middle = piece.middle();
        middle.z - self.land.height(middle.truncate()) > BRIDGE_FROM_M
    }

    /// Whether a driving lane lies over a place of a strip that is not one.
    fn is_buried(&self, piece: &PavementPiece, p: DVec3) -> bool {
        piece.kind != LaneType::Driving
            && self.pavement.at(p.truncate()).any(|(other, z)| {
                other.kind == LaneType::Driving && other.strip != piece.strip && (z - p.z).abs() < 1.0
            })
    }

    /// The parts of a piece that are to be seen, as ranges across it from right to left: in junctions, sidewalks and
    /// shoulders give way to driving lanes.
    fn shown(&self, piece: &PavementPiece) -> Vec<[f64; 2]> {
        if piece.kind == LaneType::Driving {
            return vec![[0.0, 1.0]];
        }
        const PARTS: usize = 4;
        let [r0, r1, l1, l0] = piece.corners;
        let covered = |t: f64| {
            let (a, b) = (r0.lerp(l0, t), r1.lerp(l1, t));
            [0.2, 0.8].iter().any(|&s| self.is_buried(piece, a.lerp(b, s)))
        };
        let part = |k: usize| [k as f64 / PARTS as f64, (k + 1) as f64 / PARTS as f64];
        let shown: Vec<[f64; 2]> = (0..PARTS).map(part).filter(|[a, b]| !covered((a + b) / 2.0)).collect();
        if shown.len() == PARTS { vec![[0.0, 1.0]] } else { shown }
    }

    fn surface(&self, mesh: &mut MeshBuilder, piece: &PavementPiece, [from, to]: [f64; 2], lift: f64, along: f64) {
        let material = self.materials[piece.strip as usize];
        let [r0, r1, l1, l0] = piece.corners;
        let up = DVec3::Z * lift;
        let corners = [r0.lerp(l0, from), r1.lerp(l1, from), r1.lerp(l1, to), r0.lerp(l0, to)].map(|p| p + up);
        let lane = piece.kind == LaneType::Driving && (!piece.in_junction || self.travelled[piece.strip as usize]);
        let half = r0.distance(l0).max(r1.distance(l1)) / 2.0;
        let v = |t: f64| if lane { (half * (2.0 * t - 1.0)) as f32 } else { NO_LANE };
        let (u0, u1) = (along as f32, (along + r0.distance(r1)) as f32);
        let uvs = if is_carriageway(piece.kind) {
            [[u0, v(from)], [u1, v(from)], [u1, v(to)], [u0, v(to)]].map(Vec2::from_array)
        } else {
            corners.map(|p| p.truncate().as_vec2())
        };
        // Where a border waits in a tight bend a piece may turn over.
        let flat = corners.map(DVec3::truncate);
        let c = corners.map(DVec3::as_vec3);
        for [i, j, k] in [[0, 1, 2], [0, 2, 3]] {
            if (flat[j] - flat[i]).perp_dot(flat[k] - flat[i]) > 2e-4 {
                mesh.triangle([c[i], c[j], c[k]], [uvs[i], uvs[j], uvs[k]], material);
            }
        }
    }

    /// Kerbs where a neighbour lies lower, skirts into the ground where there is none, parapets on bridges.
    fn edges(&self, mesh: &mut MeshBuilder, piece: &PavementPiece, [first, last]: [bool; 2], high: bool) {
        let [r0, r1, l1, l0] = piece.corners;
        let raised = matches!(piece.kind, LaneType::Sidewalk | LaneType::Median | LaneType::Curb);
        let own = self.materials[piece.strip as usize];
        // Each with the ends of the side across.
        let sides = [(r0, r1, true), (r1, l1, last), (l1, l0, true), (l0, r0, first)];
        let across = [[l0, l1], [r0, l0], [r1, r0], [l1, r1]];
        for (k, (a, b, wanted)) in sides.into_iter().enumerate() {
            let along = (b - a).truncate();
            if !wanted || along.length() < 1e-3 {
                continue;
            }
            let out = -along.normalize().perp();
            let middle = (a + b) / 2.0;
            let beyond = middle.truncate() + out * 0.22;
            let neighbour = self
                .pavement
                .at(beyond)
                .filter(|(other, z)| !std::ptr::eq(*other, piece) && (z - middle.z).abs() < 0.8)
                .map(|(_, z)| z)
                .max_by(f64::total_cmp);
            let end = k % 2 == 1;
            let lower = neighbour.is_none_or(|z| middle.z - z > 0.02);
            if lower && !high && raised && own == LAWN {
                kerb_stone(mesh, (a, b), across[k]);
            }
            match neighbour {
                Some(z) if lower => {
                    face(mesh, (a, b), [z - middle.z - 0.02, 0.0], if raised { KERB } else { own });
                }
                Some(_) => {}
                None if high && !end => self.parapet(mesh, a, b, out),
                None if high => face(mesh, (a, b), [-DECK_M, 0.0], DECK),
                None => {
                    face(mesh, (a, b), [-0.6, 0.0], if raised { KERB } else { own });
                }
            }
        }
    }

    fn parapet(&self, mesh: &mut MeshBuilder, a: DVec3, b: DVec3, out: DVec2) {
        let [thick, tall] = PARAPET_M;
        let (c, d) = (a + (out * thick).extend(0.0), b + (out * thick).extend(0.0));
        face(mesh, (c, d), [-DECK_M, tall], DECK);
        face(mesh, (b, a), [0.0, tall], DECK);
        let (up, down) = (DVec3::Z * tall, DVec3::Z * DECK_M);
        quad(mesh, [a + up, c + up, d + up, b + up], flat_uv([a, c, d, b]), DECK);
        quad(mesh, [b - down, d - down, c - down, a - down], flat_uv([b, d, c, a]), DECK);
    }

    fn underside(&self, mesh: &mut MeshBuilder, piece: &PavementPiece) {
        let [r0, r1, l1, l0] = piece.corners.map(|p| p - DVec3::Z * DECK_M);
        quad(mesh, [l0, l1, r1, r0], flat_uv([l0, l1, r1, r0]), DECK);
    }

    /// Foot and head of a column below a deck, where nothing passes.
    fn pier(&self, piece: &PavementPiece) -> Option<(DVec3, DVec3)> {
        let top = piece.middle() - DVec3::Z * DECK_M;
        let at = top.truncate();
        let ground = self.land.level(at) - 0.6;
        let passes = (0..9).any(|k| {
            let p = at + if k == 0 { DVec2::ZERO } else { crate::geometry::unit(f64::from(k) * 0.785) * 1.6 };
            self.pavement.at(p).any(|(_, z)| z < top.z - 0.6)
        });
        (!passes && top.z - ground >= 3.0).then_some((at.extend(ground), top))
    }
}

/// Asphalt where roads meet and no strips say what lies there: a little below strips.
pub(crate) fn junction_areas(mesh: &mut MeshBuilder, map: &RoadMap, paving: Material) {
    for outline in &map.junction_areas {
        let flat: Vec<DVec2> = outline.iter().map(|p| p.truncate()).collect();
        if flat.len() < 3 || crate::geometry::area(&flat) <= 0.0 {
            continue;
        }
        let base = mesh.vertices(outline.iter().map(|p| {
            let p = (*p - DVec3::Z * 0.004).as_vec3();
            (p, Vec3::Z, Vec2::new(p.x, NO_LANE))
        }));
        for t in triangulate(&flat, &[]).1.into_iter().filter(|t| crate::geometry::area(&t.map(|k| flat[k])) > 1e-3) {
            mesh.triangle_indices(t.map(|k| base + k as u32), paving);
        }
        for k in 0..outline.len() {
            face(mesh, (outline[k], outline[(k + 1) % outline.len()]), [-0.6, -0.004], paving);
        }
    }
}

fn flat_uv(corners: [DVec3; 4]) -> [Vec2; 4] {
    corners.map(|p| p.truncate().as_vec2())
}

/// The upper side of the stone along an edge; `across` are the corners on the other side.
fn kerb_stone(mesh: &mut MeshBuilder, (a, b): (DVec3, DVec3), across: [DVec3; 2]) {
    const WIDE_M: f64 = 0.16;
    const LIFT: DVec3 = DVec3::new(0.0, 0.0, 0.006);
    let inwards = |p: DVec3, q: DVec3| p.lerp(q, (WIDE_M / p.distance(q).max(1e-6)).min(1.0));
    let corners = [a, b, inwards(b, across[1]), inwards(a, across[0])];
    quad(mesh, corners.map(|p| p + LIFT), flat_uv(corners), KERB);
    face(mesh, (a, b), [0.0, LIFT.z], KERB);
}

/// A quadrilateral that may be degenerate at one end.
pub(crate) fn quad(mesh: &mut MeshBuilder, corners: [DVec3; 4], uvs: [Vec2; 4], material: Material) {
    let c = corners.map(DVec3::as_vec3);
    for [i, j, k] in [[0, 1, 2], [0, 2, 3]] {
        if (c[j] - c[i]).cross(c[k] - c[i]).length() > 1e-5 {
            mesh.triangle([c[i], c[j], c[k]], [uvs[i], uvs[j], uvs[k]], material);
        }
    }
}

/// A vertical face below or above an edge whose outside is on its right.
fn face(mesh: &mut MeshBuilder, (a, b): (DVec3, DVec3), [low, high]: [f64; 2], material: Material) {
    let (down, up) = (DVec3::Z * low, DVec3::Z * high);
    let (w, h) = (a.distance(b) as f32, (high - low) as f32);
    let uvs = [[0.0, 0.0], [w, 0.0], [w, h], [0.0, h]].map(Vec2::from_array);
    quad(mesh, [a + down, b + down, b + up, a + up], uvs, material);
}
