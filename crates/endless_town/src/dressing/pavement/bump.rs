//! Speed bumps: a low ridge from kerb to kerb, striped.

use crate::dressing::ground::pavement_index::{PavementIndex, is_carriageway};
use crate::dressing::pavement::surface::quad;
use crate::palette::{ASPHALT, YELLOW_PAINT};
use endless_road::{MapObjectKind, RoadMap};
use endless_scene::MeshBuilder;
use glam::{DVec2, DVec3};

/// Half its length along the road, its height, and the width of a stripe, metres.
const HALF_M: f64 = 0.55;
const HEIGHT_M: f64 = 0.075;
const STRIPE_M: f64 = 0.5;
/// Widest road, metres.
const MOST_M: f64 = 12.0;

pub(crate) fn add(mesh: &mut MeshBuilder, map: &RoadMap, pavement: &PavementIndex) {
    for object in map.objects.iter().filter(|t| t.kind == MapObjectKind::SpeedBump) {
        let along = crate::geometry::unit(object.heading_rad);
        let across = along.perp();
        let at = object.position.truncate();
        let surface = |p: DVec2| {
            let near =
                pavement.at(p).filter(|(piece, z)| is_carriageway(piece.kind) && (z - object.position.z).abs() < 1.0);
            near.map(|(_, z)| z).max_by(f64::total_cmp)
        };
        let reach = |side: f64| {
            let steps = (0..).map(|k| 0.1 * f64::from(k)).take_while(|d| *d < MOST_M);
            steps.take_while(|d| surface(at + across * (side * d)).is_some()).last()
        };
        let (Some(left), Some(right)) = (reach(1.0), reach(-1.0)) else { continue };
        let count = ((left + right) / STRIPE_M).floor().max(1.0);
        let place = |t: f64, s: f64, up: f64| -> Option<DVec3> {
            let p = at + across * t + along * s;
            Some(p.extend(surface(p)? + up))
        };
        for k in 0..count as usize {
            let edge = |k: usize| -right + 0.05 + (left + right - 0.1) * k as f64 / count;
            let (a, b) = (edge(k), edge(k + 1));
            let material = if k % 2 == 0 { YELLOW_PAINT } else { ASPHALT };
            for (s0, z0, s1, z1) in
                [(-HALF_M, 0.0, -0.2, HEIGHT_M), (-0.2, HEIGHT_M, 0.2, HEIGHT_M), (0.2, HEIGHT_M, HALF_M, 0.0)]
            {
                // Seen along the road its left is at greater `t`.
                let corners = [place(a, s0, z0), place(a, s1, z1), place(b, s1, z1), place(b, s0, z0)];
                if let [Some(p), Some(q), Some(r), Some(u)] = corners {
                    let corners = [p, q, r, u];
                    quad(mesh, corners, corners.map(|p| p.truncate().as_vec2()), material);
                }
            }
        }
    }
}
