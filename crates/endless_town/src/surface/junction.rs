//! The area inside a junction and the sidewalks around its corners.

use super::NO_LANE;
use super::street::band_edges;
use super::strip::at_height;
use crate::network::{Arm, FURNITURE_M, KERB_HEIGHT_M, KERB_M, Node, Plan};
use crate::palette::{ASPHALT, KERB, PAVING};
use endless_scene::{Material, MeshBuilder};
use glam::{DVec2, Vec2};

pub(crate) fn add(mesh: &mut MeshBuilder, plan: &Plan, node: &Node) {
    add_area(mesh, plan, node);
    for i in 0..node.arms.len() {
        add_corner(mesh, plan, node, i);
    }
}

/// Counter-clockwise outline of the asphalt: across each arm, with a vertex at each of its bands, and around each
/// corner.
pub(crate) fn area_outline(plan: &Plan, node: &Node) -> Vec<DVec2> {
    let mut outline = Vec::new();
    for (i, &arm) in node.arms.iter().enumerate() {
        let cut = plan.arm_cut(arm);
        outline.extend(band_edges(plan.arm_profile(arm)).into_iter().map(|t| plan.arm_point(arm, cut, t)));
        let corner = plan.corner(node, i, 0.0, 0.0);
        outline.extend(&corner[1..corner.len() - 1]);
    }
    outline
}

fn add_area(mesh: &mut MeshBuilder, plan: &Plan, node: &Node) {
    let outline = area_outline(plan, node);
    let n = outline.len() as f64;
    let centre = outline.iter().sum::<DVec2>() / n;
    for k in 0..outline.len() {
        let corners = [centre, outline[k], outline[(k + 1) % outline.len()]];
        let uvs = corners.map(|p| Vec2::new(p.x as f32, NO_LANE));
        mesh.triangle(corners.map(|p| at_height(p, 0.0)), uvs, ASPHALT);
    }
}

/// Lines around corner `i`, from the kerb's face to the back of the sidewalk.
fn corner_lines(plan: &Plan, node: &Node, i: usize) -> [Vec<DVec2>; 4] {
    let (a, b) = (node.arms[i], node.arms[(i + 1) % node.arms.len()]);
    let face = plan.corner(node, i, 0.0, 0.0);
    let back = back_line(plan, a, b);
    // The lines between run at the sidewalk's own distances, to meet the streets' strips.
    let between = |offset: f64| -> Vec<DVec2> {
        let n = face.len();
        (0..n)
            .map(|k| {
                if k == 0 {
                    plan.arm_point(a, plan.arm_cut(a), plan.arm_profile(a).kerb() + offset)
                } else if k + 1 == n {
                    plan.arm_point(b, plan.arm_cut(b), -plan.arm_profile(b).kerb() - offset)
                } else {
                    face[k] + (back[k] - face[k]).normalize_or_zero() * offset
                }
            })
            .collect()
    };
    let (top, inner) = (between(KERB_M), between(FURNITURE_M));
    [face, top, inner, back]
}

/// The back of the sidewalk around the corner between two neighbouring arms.
pub(crate) fn back_line(plan: &Plan, a: Arm, b: Arm) -> Vec<DVec2> {
    plan.corner_between(a, plan.arm_profile(a).back(), b, plan.arm_profile(b).back(), 0.7)
}

fn add_corner(mesh: &mut MeshBuilder, plan: &Plan, node: &Node, i: usize) {
    let [face, top, inner, back] = corner_lines(plan, node, i);
    let h = KERB_HEIGHT_M;
    ribbon(mesh, (&face, 0.0), (&face, h), KERB);
    ribbon(mesh, (&face, h), (&top, h), KERB);
    ribbon(mesh, (&top, h), (&inner, h), PAVING);
    ribbon(mesh, (&inner, h), (&back, h), PAVING);
}

/// Quads between two lines of equally many points, the first on the right of the second... seen from above, walking
/// the corner from one arm to the next, the sidewalk lies on the left of the kerb's face.
fn ribbon(mesh: &mut MeshBuilder, (near, z0): (&[DVec2], f64), (far, z1): (&[DVec2], f64), material: Material) {
    let mut u = 0.0;
    for k in 0..near.len() - 1 {
        let v = near[k].distance(far[k]).max((z1 - z0).abs()) as f32;
        let next = u + near[k].distance(near[k + 1]) as f32;
        mesh.quad(
            [at_height(near[k + 1], z0), at_height(near[k], z0), at_height(far[k], z1), at_height(far[k + 1], z1)],
            [[next, 0.0], [u, 0.0], [u, v], [next, v]].map(Vec2::from_array),
            material,
        );
        u = next;
    }
}
