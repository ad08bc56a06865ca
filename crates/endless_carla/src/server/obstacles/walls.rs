//! Walls of a building: its upright faces at the height of bumpers, as long thin boxes.

use super::band::within_band;
use super::solid::{Part, bit, solid_triangles};
use crate::physics::OrientedBox;
use endless_scene::Mesh;
use endless_world::ClassTag;
use endless_world::math::f64::atan2;
use glam::{DVec2, DVec3, Vec3};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// A mesh that is larger, metres, is no building: the ground of a town with its bridges, or all its wires.
const LARGEST_M: f32 = 250.0;
/// Half of a wall's thickness, metres.
const HALF_M: f64 = 0.12;
/// Faces in one plane with gaps up to this are one wall, metres.
const GAP_M: f64 = 0.3;
/// Planes that differ by less than this are one: parts of a turn, metres.
const TURNS: f64 = 720.0;
const APART_M: f64 = 0.2;

/// A part of a face, along its plane.
#[derive(Debug, Clone, Copy)]
struct Face {
    from: f64,
    to: f64,
    low_m: f64,
    high_m: f64,
    tag: ClassTag,
    classes: u32,
}

/// The walls of a town's mesh in its own frame.
pub(super) fn walls(mesh: &Mesh) -> Vec<Part> {
    let (low, high) = mesh.bounds();
    if (high - low).truncate().length() > LARGEST_M {
        return piers(mesh);
    }
    let mut planes: BTreeMap<[i64; 2], (DVec2, f64, Vec<Face>)> = BTreeMap::new();
    for (corners, tag) in solid_triangles(mesh) {
        let Some(along) = level_axis(&corners) else { continue };
        let polygon = within_band(&corners);
        if polygon.is_empty() {
            continue;
        }
        let aside = mean(&polygon, |at| at.truncate().dot(along.perp()));
        let turn = (atan2(along.y, along.x) / PI * TURNS / 2.0).round() as i64;
        let key = [turn, (aside / APART_M).round() as i64];
        let (along, _, faces) = planes.entry(key).or_insert((along, aside, Vec::new()));
        faces.push(face(&polygon, *along, tag));
    }
    planes
        .into_values()
        .flat_map(|(along, aside, faces)| joined(faces).map(move |face| part(along, aside, &face)))
        .collect()
}

/// Upright faces under bridges and at their sides, each as high as it is.
fn piers(mesh: &Mesh) -> Vec<Part> {
    let upright = solid_triangles(mesh).filter(|(_, tag)| *tag == ClassTag::Bridge);
    let faces = upright.filter_map(|(corners, tag)| {
        let along = level_axis(&corners)?;
        let polygon = corners.map(Vec3::as_dvec3);
        let aside = mean(&polygon, |at| at.truncate().dot(along.perp()));
        Some(part(along, aside, &face(&polygon, along, tag)))
    });
    faces.collect()
}

/// The level direction in an upright triangle, in a half turn; none of roofs and floors.
fn level_axis([a, b, c]: &[Vec3; 3]) -> Option<DVec2> {
    const UPRIGHT: f64 = 0.7;
    let normal = (*b - *a).cross(*c - *a).as_dvec3().try_normalize()?;
    let along = DVec2::new(-normal.y, normal.x);
    if along.length() < UPRIGHT {
        return None;
    }
    let along = along.normalize();
    // The same axis for both faces of a wall; -0.0 and rounding make no other one of it.
    let is_second = along.y < -1e-6 || (along.y.abs() <= 1e-6 && along.x < 0.0);
    Some(if is_second { -along } else { along })
}

fn mean(polygon: &[DVec3], of: impl Fn(&DVec3) -> f64) -> f64 {
    polygon.iter().map(of).sum::<f64>() / polygon.len() as f64
}

fn face(polygon: &[DVec3], along: DVec2, tag: ClassTag) -> Face {
    let none = Face { from: f64::MAX, to: f64::MIN, low_m: f64::MAX, high_m: f64::MIN, tag, classes: bit(tag) };
    polygon.iter().fold(none, |known, at| {
        let s = at.truncate().dot(along);
        Face {
            from: known.from.min(s),
            to: known.to.max(s),
            low_m: known.low_m.min(at.z),
            high_m: known.high_m.max(at.z),
            ..known
        }
    })
}

/// Faces of one plane, those that meet as one.
fn joined(mut faces: Vec<Face>) -> impl Iterator<Item = Face> {
    faces.sort_by(|a, b| a.from.total_cmp(&b.from));
    let mut walls: Vec<Face> = Vec::new();
    for face in faces {
        match walls.last_mut() {
            Some(wall) if face.from <= wall.to + GAP_M => {
                wall.to = wall.to.max(face.to);
                wall.low_m = wall.low_m.min(face.low_m);
                wall.high_m = wall.high_m.max(face.high_m);
                wall.classes |= face.classes;
            }
            _ => walls.push(face),
        }
    }
    walls.into_iter()
}

fn part(along: DVec2, aside: f64, face: &Face) -> Part {
    let outline = OrientedBox {
        centre: along * (0.5 * (face.from + face.to)) + along.perp() * aside,
        half: DVec2::new((0.5 * (face.to - face.from)).max(HALF_M), HALF_M),
        along,
        low_m: face.low_m,
        high_m: face.high_m,
    };
    Part { tag: face.tag, classes: face.classes, outline }
}
