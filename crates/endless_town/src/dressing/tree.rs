//! Trees: rows along streets, gardens and parks, woods on the slopes around the town.

use super::dresser::{Dresser, Spot};
use crate::camera::in_the_way;
use crate::network::{KERB_HEIGHT_M, Street};
use crate::palette::SOIL;
use crate::plot::{Rect, inside};
use crate::surface;
use endless_asset::Prop;
use endless_scene::MeshBuilder;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, Vec2, Vec3};
use std::f64::consts::TAU;

/// From the kerb's face to the trunk.
const TRUNK_M: f64 = 0.7;
/// A crown this wide must not touch a wall.
const CROWN_M: f64 = 2.3;

/// A species by the town's shares.
fn species(dresser: &Dresser<'_>, stream: &mut Stream) -> Prop {
    let x = stream.f64();
    let character = dresser.character;
    if x < character.conifers {
        Prop::Conifer
    } else if x < character.conifers + character.palms {
        Prop::Palm
    } else {
        Prop::BroadleafTree
    }
}

fn grown(at: DVec2, z: f64, size: (f32, f32), stream: &mut Stream) -> Spot {
    let scale = Vec3::splat(stream.range_f32(size.0, size.1));
    Spot { at, z, yaw: stream.range_f64(0.0, TAU), scale }
}

/// Rows of one species along each street; in paved sidewalks each stands in a pit of soil.
pub(crate) fn add_street_trees(
    dresser: &mut Dresser<'_>,
    pits: &mut MeshBuilder,
    sites: &[CameraSite],
    houses: &[Rect],
) {
    let plan = dresser.plan;
    for (i, street) in plan.streets.iter().enumerate() {
        let mut stream = dresser.stream(1000 + i as u64);
        // Streets have trees of one kind, as planted; wires and trees share quiet streets badly.
        let row = match species(dresser, &mut stream) {
            Prop::Conifer => Prop::BroadleafTree,
            other => other,
        };
        let spacing = dresser.character.street_trees_m;
        if spacing <= 0.0 {
            continue;
        }
        for side in [1.0, -1.0] {
            let (from, to) = street.lane_range();
            let mut s = from + 6.0 + stream.range_f64(0.0, spacing / 2.0);
            while s < to - 6.0 {
                if stream.chance(0.85) {
                    street_tree(dresser, pits, street, (s, side), row, (sites, houses), &mut stream);
                }
                s += spacing * stream.range_f64(0.9, 1.15);
            }
        }
        for (from, to) in surface::island_ranges(street).into_iter().filter(|_| street.profile.median > 3.0) {
            let mut s = from + 5.0;
            while s < to - 5.0 {
                let at = street.point(s, 0.0);
                if !in_the_way(sites, at, 2.0) {
                    let spot = grown(at, KERB_HEIGHT_M, (0.75, 0.95), &mut stream);
                    dresser.put(row, spot, DVec2::splat(0.3), None);
                }
                s += 11.0;
            }
        }
    }
}

fn street_tree(
    dresser: &mut Dresser<'_>,
    pits: &mut MeshBuilder,
    street: &Street,
    (s, side): (f64, f64),
    prop: Prop,
    (sites, houses): (&[CameraSite], &[Rect]),
    stream: &mut Stream,
) {
    let at = street.point(s, side * (street.profile.kerb() + TRUNK_M));
    let crown = Rect::around(at, CROWN_M);
    let lit = dresser.lamps.iter().any(|l| l.position.truncate().as_dvec2().distance(at) < 4.5);
    let blocked = street.near_crossing(s, 7.0) || lit || in_the_way(sites, at, 2.6);
    if blocked || houses.iter().any(|h| h.meets(&crown)) {
        return;
    }
    let spot = grown(at, KERB_HEIGHT_M, (0.85, 1.05), stream);
    if dresser.put(prop, spot, DVec2::splat(0.4), None) && !street.profile.verge {
        pit(pits, |x, y| street.point(s + x * side, side * (street.profile.kerb() + TRUNK_M + y)), 0.42);
    }
}

/// A square of soil in paving, `half` as wide from its middle; `place` tells where the points of its own plane lie.
fn pit(pits: &mut MeshBuilder, place: impl Fn(f64, f64) -> DVec2, half: f64) {
    let corners = [(-half, -half), (half, -half), (half, half), (-half, half)];
    let points = corners.map(|(x, y)| place(x, y).as_vec2().extend(KERB_HEIGHT_M as f32 + 0.004));
    pits.quad(points, corners.map(|(x, y)| Vec2::new((x + half) as f32, (y + half) as f32)), SOIL);
}

/// Trees and bushes on what the buildings leave of each block.
pub(crate) fn add_garden_trees(dresser: &mut Dresser<'_>, pits: &mut MeshBuilder, sites: &[CameraSite]) {
    for (i, block) in surface::blocks(dresser.plan).iter().enumerate() {
        let mut stream = dresser.stream(2000 + i as u64);
        let (low, high) = block.iter().fold((block[0], block[0]), |(l, h), &p| (l.min(p), h.max(p)));
        let size = high - low;
        let paved = surface::is_paved(dresser.character, i);
        let wanted = (size.x * size.y / 1000.0 * dresser.character.garden_trees) as usize;
        for k in 0..wanted * 2 {
            let at = low + size * DVec2::new(stream.f64(), stream.f64());
            let bush = k >= wanted;
            let room = if bush { 0.8 } else { CROWN_M + 0.3 };
            let fits = Rect::around(at, room).corners().iter().all(|&c| inside(block, c));
            if !fits || in_the_way(sites, at, room) || !dresser.occupied.is_free(&Rect::around(at, room)) {
                continue;
            }
            let prop = if bush { Prop::Bush } else { species(dresser, &mut stream) };
            let spot = grown(at, KERB_HEIGHT_M, (0.85, 1.15), &mut stream);
            if dresser.put(prop, spot, DVec2::splat(if bush { 0.6 } else { 1.2 }), None) && paved {
                pit(pits, |x, y| at + DVec2::new(x, y), if bush { 0.55 } else { 0.7 });
            }
        }
    }
}

/// Woods behind the outermost houses: they hide the world's edge.
pub(crate) fn add_woods(dresser: &mut Dresser<'_>) {
    let mut stream = dresser.stream(3000);
    let conifers = 0.25 + dresser.character.conifers;
    let slopes = surface::Slopes::new(dresser.plan, dresser.character);
    for _ in 0..900 {
        let place = slopes.place(&mut stream);
        let prop = if stream.chance(conifers) { Prop::Conifer } else { Prop::BroadleafTree };
        let spot = grown(place.truncate(), place.z - 0.05, (0.9, 1.35), &mut stream);
        if dresser.occupied.is_free(&Rect::around(spot.at, 3.0)) {
            dresser.put(prop, spot, DVec2::splat(0.6), None);
        }
    }
}
