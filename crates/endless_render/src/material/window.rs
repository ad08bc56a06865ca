//! Windows with a room behind them (interior mapping). uv: the integer part numbers the window, the fraction is the position in it.

use super::{Bsdf, noise};
use crate::light::Environment;
use crate::scene::SurfaceInteraction;
use endless_world::math::UnfusedVec3A;
use endless_world::math::{lerp, smoothstep};
use glam::{IVec2, Vec2, Vec3A};

/// Colours of lamps behind windows, linear.
const LAMP_COLORS: [Vec3A; 4] = [
    Vec3A::new(1.0, 0.62, 0.30),
    Vec3A::new(1.0, 0.74, 0.45),
    Vec3A::new(0.95, 0.92, 0.86),
    Vec3A::new(0.70, 0.80, 1.0),
];

pub(super) fn window(point: &SurfaceInteraction<'_>, base: Vec3A, environment: &Environment, shop: bool) -> Bsdf {
    let name = noise::corner_of(point.uv).as_ivec2();
    let place = point.uv - noise::corner_of(point.uv);
    // Windows of different walls may share a name: tell them apart by where the wall stands.
    let wall = ((point.position + point.geometric_normal * 0.5) / 7.0).floor();
    let id = name + IVec2::new(wall.x as i32 * 131, wall.y as i32 * 197);
    let random = |salt: u32| noise::cell2(id, 81 + salt);

    // The room: a box as deep as the window is wide, seen through the pane (van Dongen 2008, interior mapping).
    let inward = -point.geometric_normal;
    let side = inward.cross_unfused(Vec3A::Z).normalize_or(Vec3A::X);
    let d = point.direction;
    let (dx, dy, dz) = (d.dot(side), d.z, d.dot(inward).max(0.05));
    let depth = 1.3;
    let to_side = if dx > 0.0 { (1.0 - place.x) / dx } else { place.x / -dx.min(-1e-4) };
    let to_floor = if dy > 0.0 { (1.0 - place.y) / dy } else { place.y / -dy.min(-1e-4) };
    let to_back = depth / dz;
    let nearest = to_side.min(to_floor).min(to_back);
    let reached = Vec2::new(place.x + dx * nearest, place.y + dy * nearest);
    let falloff = 1.0 / (1.0 + 0.8 * nearest);
    let tone = if to_floor <= nearest {
        if dy > 0.0 { 0.75 } else { 0.30 }
    } else if to_side <= nearest {
        0.55
    } else {
        // The back wall, with something standing in front of it.
        let furniture = noise::cell2(noise::corner_of(reached * 4.0).as_ivec2() + id, 95);
        0.62 - 0.35 * smoothstep(0.55, 0.7, furniture)
    };
    let wall_color = Vec3A::new(0.62, 0.58, 0.52).lerp_unfused(Vec3A::new(0.45, 0.50, 0.55), random(1));
    let mut room = wall_color * (tone * falloff);
    if shop {
        // Shelves and goods.
        let goods = noise::tint(noise::corner_of(reached * Vec2::new(14.0, 6.0)).as_ivec2() + id, 97, 0.5);
        room = room * 0.5 + goods.max(Vec3A::ZERO) * (0.28 * falloff);
    }

    // Curtains and blinds in front of the room.
    let kind = random(2);
    let curtain = if shop {
        0.0
    } else if kind < 0.35 {
        let open = lerp(0.12, 0.34, random(3));
        1.0 - smoothstep(open - 0.01, open + 0.01, place.x.min(1.0 - place.x))
    } else if kind < 0.6 {
        smoothstep(lerp(0.2, 0.9, random(4)), lerp(0.2, 0.9, random(4)) + 0.02, place.y)
    } else {
        0.0
    };
    let folds = 0.85 + 0.15 * noise::value2(Vec2::new(place.x * 23.0, 0.3), 7);
    let cloth = Vec3A::new(0.66, 0.63, 0.58).lerp_unfused(Vec3A::new(0.40, 0.36, 0.33), random(5) * 0.7) * folds;

    let lit_share = if shop { 0.85 } else { 0.36 } * environment.lamps_lit;
    let lit = environment.night && random(6) < lit_share;
    let mut emission = Vec3A::ZERO;
    if lit {
        let lamp = if shop { LAMP_COLORS[2] } else { LAMP_COLORS[(random(7) * 4.0) as usize % 4] };
        let power = if shop { 0.055 } else { 0.018 * lerp(0.5, 1.5, random(8)) };
        let behind = room.lerp_unfused(cloth * 0.45, curtain);
        emission = lamp * behind * power;
    }
    // By day a room gets only what its window lets in.
    let by_day = (room * 0.10).lerp_unfused(cloth * 0.55, curtain);
    let mut bsdf = Bsdf::matte(by_day * base.max(Vec3A::splat(0.5)), point.normal).coated(1.0, 0.07, 0.06);
    bsdf.specular = 0.0;
    bsdf.emission = emission;
    // Panes are never quite flat: reflections break from one to the next.
    let tilt = Vec2::new(random(9), random(10)) - 0.5;
    bsdf.coat_normal = (point.normal + side * (tilt.x * 0.012) + Vec3A::Z * (tilt.y * 0.012)).normalize();
    bsdf
}
