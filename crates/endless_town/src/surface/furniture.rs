//! Manholes and drain grates.

use super::IRON_M;
use super::strip::patch;
use crate::network::Street;
use crate::palette::IRON;
use endless_scene::MeshBuilder;
use endless_world::Stream;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, Vec2};

const MANHOLE_RADIUS_M: f64 = 0.32;

pub(crate) fn add_iron(mesh: &mut MeshBuilder, street: &Street, seed: u64) {
    let (from, to) = street.lane_range();
    let mut stream = Stream::named(seed, "town/iron", &street.ends.map(|e| e as u64));
    let mut s = from + stream.range_f64(10.0, 25.0);
    while s < to - 12.0 {
        let lane = stream.below(street.profile.lanes);
        let side = if stream.chance(0.5) { 1.0 } else { -1.0 };
        // Beside the arrows in the middle of lanes.
        let t = side * (street.profile.lane_centre(lane) + stream.range_f64(0.45, 0.8));
        if !street.near_crossing(s, 1.5) {
            disc(mesh, street.point(s, t));
        }
        s += stream.range_f64(22.0, 45.0);
    }
    let kerb = street.profile.kerb();
    let mut s = from + 4.0;
    while s < to - 4.0 {
        if !street.near_crossing(s, 1.0) {
            patch(mesh, street, (s, s + 0.5), (kerb - 0.27, kerb - 0.02), IRON_M, IRON);
            patch(mesh, street, (s, s + 0.5), (0.02 - kerb, 0.27 - kerb), IRON_M, IRON);
        }
        s += 27.0;
    }
}

fn disc(mesh: &mut MeshBuilder, centre: DVec2) {
    const SIDES: u32 = 16;
    let rim = |k: u32| {
        let (sin, cos) = sin_cos(std::f64::consts::TAU * f64::from(k) / f64::from(SIDES));
        DVec2::new(cos, sin)
    };
    for k in 0..SIDES {
        let (a, b) = (rim(k), rim(k + 1));
        let corners = [DVec2::ZERO, a, b];
        let place = |p: DVec2| (centre + p * MANHOLE_RADIUS_M).as_vec2().extend(IRON_M);
        mesh.triangle(corners.map(place), corners.map(|p| (p * 0.5).as_vec2() + Vec2::splat(0.5)), IRON);
    }
}
