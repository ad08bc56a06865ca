//! Ground between streets, around the town, and the hills that hide the world's edge.

use super::junction::back_line;
use super::polygon::{area, triangulate};
use super::strip::at_height;
use crate::character::{Character, Kind};
use crate::network::{Arm, KERB_HEIGHT_M, Plan};
use crate::palette::{HILL, LAWN, MEADOW, PLAZA, YARD};
use endless_scene::{Material, MeshBuilder};
use endless_world::math::f64::{atan2, sin};
use endless_world::{Stream, math};
use glam::{DVec2, DVec3, Vec2, Vec3};

/// Outlines of the blocks between streets, counter-clockwise.
pub(crate) fn blocks(plan: &Plan) -> Vec<Vec<DVec2>> {
    faces(plan).into_iter().filter(|f| area(f) > 0.0).collect()
}

/// Outline of the whole town behind its outermost sidewalk, counter-clockwise.
pub(crate) fn outline(plan: &Plan) -> Vec<DVec2> {
    let mut outer = faces(plan).into_iter().find(|f| area(f) < 0.0).expect("streets enclose the town");
    outer.reverse();
    outer
}

/// Walks around every face of the street plan, keeping it on the left, behind the sidewalks.
fn faces(plan: &Plan) -> Vec<Vec<DVec2>> {
    let mut done = vec![[false; 2]; plan.streets.len()];
    let mut faces = Vec::new();
    for street in 0..plan.streets.len() {
        for end in 0..2 {
            let mut face = Vec::new();
            let mut arm = Arm { street, end };
            while !std::mem::replace(&mut done[arm.street][arm.end], true) {
                face.extend(side_line(plan, arm));
                let there = Arm { street: arm.street, end: 1 - arm.end };
                let node = &plan.nodes[plan.streets[arm.street].ends[there.end]];
                let k = node.arms.iter().position(|&a| a == there).expect("every end is an arm");
                let next = node.arms[(k + node.arms.len() - 1) % node.arms.len()];
                let mut corner = back_line(plan, next, there);
                corner.reverse();
                face.extend(&corner[1..corner.len() - 1]);
                arm = next;
            }
            if !face.is_empty() {
                faces.push(face);
            }
        }
    }
    faces
}

/// The back of the sidewalk on the left of a street, walking out along an arm; the same points as its strips have.
fn side_line(plan: &Plan, arm: Arm) -> Vec<DVec2> {
    let street = &plan.streets[arm.street];
    let mut stations = super::street::stations(street);
    let side = if arm.end == 0 { 1.0 } else { -1.0 };
    if arm.end == 1 {
        stations.reverse();
    }
    stations.into_iter().map(|s| street.point(s, side * street.profile.back())).collect()
}

/// What covers a block between its buildings.
fn block_material(character: &Character, index: usize) -> Material {
    let mut stream = Stream::named(character.seed, "town/block", &[index as u64]);
    let share = |kind: Kind| character.kinds.iter().filter(|k| k.0 == kind).map(|k| k.1).sum::<f64>();
    let green = share(Kind::House) + share(Kind::Barn) + 0.6 * share(Kind::Flats) + 0.3;
    let hard = share(Kind::Office) + share(Kind::Tower) + share(Kind::Terrace) + share(Kind::Hall);
    if stream.chance(green / (green + hard)) {
        if share(Kind::Barn) > 0.0 { MEADOW } else { LAWN }
    } else {
        *stream.pick(&[PLAZA, YARD])
    }
}

/// Whether a block is paved between its buildings.
pub(crate) fn is_paved(character: &Character, index: usize) -> bool {
    let material = block_material(character, index);
    material == PLAZA || material == YARD
}

pub(crate) fn add(mesh: &mut MeshBuilder, character: &Character, plan: &Plan) {
    for (i, block) in blocks(plan).iter().enumerate() {
        let material = block_material(character, i);
        let vertices = block.iter().map(|&p| (at_height(p, KERB_HEIGHT_M), Vec3::Z, p.as_vec2()));
        let base = mesh.vertices(vertices);
        for t in triangulate(block) {
            mesh.triangle_indices(t.map(|k| base + k as u32), material);
        }
    }
    add_surroundings(mesh, &outline(plan), character);
    // Below everything: what shows through the finest crack is ground, never sky.
    let w = 2500.0f32;
    mesh.quad(
        [[-w, -w], [w, -w], [w, w], [-w, w]].map(|[x, y]| Vec3::new(x, y, -0.4)),
        [[0.0, 0.0], [w, 0.0], [w, w], [0.0, w]].map(Vec2::from_array),
        MEADOW,
    );
}

/// Distance from the town's outline of each ring of ground, and the height of its hills, metres.
const RINGS: [(f64, f64); 10] = [
    (0.0, 0.0),
    (15.0, 0.0),
    (40.0, 0.0),
    (75.0, 0.6),
    (130.0, 6.0),
    (220.0, 18.0),
    (360.0, 36.0),
    (600.0, 62.0),
    (1000.0, 80.0),
    (1500.0, 60.0),
];

fn add_surroundings(mesh: &mut MeshBuilder, outline: &[DVec2], character: &Character) {
    let point = |ring: usize, k: usize| ring_point(outline, character.seed, ring, k).as_vec3();
    for ring in 0..RINGS.len() - 1 {
        let material = match ring {
            0 | 1 => LAWN,
            2 | 3 => MEADOW,
            _ => HILL,
        };
        for k in 0..outline.len() {
            let corners = [point(ring, k + 1), point(ring, k), point(ring + 1, k), point(ring + 1, k + 1)];
            mesh.quad(corners, corners.map(Vec3::truncate), material);
        }
    }
}

/// The vertex of a ring of ground beyond vertex `k` of the town's outline.
fn ring_point(outline: &[DVec2], seed: u64, ring: usize, k: usize) -> DVec3 {
    let from = outline[k % outline.len()];
    let p = from + from.normalize_or(DVec2::X) * RINGS[ring].0;
    p.extend(KERB_HEIGHT_M + RINGS[ring].1 * hilliness(p, seed))
}

/// Places on the ground outside the town.
pub(crate) struct Slopes {
    outline: Vec<DVec2>,
    seed: u64,
}

impl Slopes {
    pub(crate) fn new(plan: &Plan, character: &Character) -> Self {
        Self { outline: outline(plan), seed: character.seed }
    }

    /// A random place from behind the outermost houses up to the nearer hills, exactly on the ground.
    pub(crate) fn place(&self, stream: &mut Stream) -> DVec3 {
        let k = stream.below(self.outline.len());
        let ring = 2 + stream.weighted(&[1.0, 1.4, 1.6, 1.2]);
        let (a, b) = (ring_point(&self.outline, self.seed, ring, k), ring_point(&self.outline, self.seed, ring + 1, k));
        a.lerp(b, stream.f64())
    }
}

/// 0.3 to 1: where hills are high, smooth and different in every town.
fn hilliness(p: DVec2, seed: u64) -> f64 {
    let phase = (seed % 97) as f64;
    let around = atan2(p.y, p.x);
    let wave = sin(3.0 * around + phase) + 0.7 * sin(7.0 * around + 2.3 * phase) + 0.4 * sin(0.011 * p.x + 0.017 * p.y);
    f64::from(math::lerp(0.3, 1.0, math::smoothstep(-1.6, 1.8, wave as f32)))
}
