//! The tiles that moving objects can change, and how. Conservative.

use super::bake::CameraBake;
use super::contact_shadow::contact_may_reach;
use super::object_group::ObjectGroup;
use super::ray_bounds::RayBounds;
use super::tile::{Bounds3, TileBounds, TileRayBounds};
use super::tile_hierarchy::{FACTOR, TileHierarchy, TileLevel};
use super::tile_work::{BeamSweep, TileWork};
use super::visible_tiles::each_visible_tile;
use crate::light::{Lamps, VehicleBeam};
use crate::scene::{FrameScene, MovingVolume, StaticScene};
use glam::Vec3A;
use std::cell::LazyCell;

/// The work of every tile of a frame.
pub(super) fn affected(bake: &CameraBake, still: &StaticScene, frame: &FrameScene) -> Vec<TileWork> {
    let mut work = vec![TileWork::default(); bake.tiles.tiles().bounds.len()];
    for (tile, bounds) in work.iter_mut().zip(&bake.tiles.tiles().bounds) {
        tile.lens = bounds.lens;
    }
    each_visible_tile(bake, frame, |tile| work[tile].primary = true);
    let shadows: Vec<Vec<LampShadow>> =
        frame.objects.iter().map(|object| lamp_shadows(bake, &still.lamps, object)).collect();
    let spans: Vec<Bounds3> = shadows.iter().map(|shadows| span_of(shadows)).collect();
    for group in ObjectGroup::all(&frame.objects, &spans) {
        mark(&bake.tiles, &mut work, |area, tile| {
            let may_change = !area.bounds.points.is_empty() && group.may_change(area.bounds, area.rays);
            if let (Some(tile), true) = (tile, may_change) {
                for &i in &group.members {
                    mark_object(&frame.objects[i], &shadows[i], i as u16, area, tile);
                }
            }
            may_change
        });
    }
    for tile in &mut work {
        tile.contacts.sort_unstable();
    }
    // By day vehicle lights are seen, but light nothing.
    let beams: &[VehicleBeam] = if bake.lighting.environment.night { &frame.beams } else { &[] };
    for (i, beam) in beams.iter().enumerate() {
        let range = beam.range_m();
        let near = |o: &&MovingVolume| beam.position.clamp(o.low, o.high).distance(beam.position) <= range * 1.01;
        let objects: LazyCell<Vec<&MovingVolume>, _> = LazyCell::new(|| frame.objects.iter().filter(near).collect());
        mark(&bake.tiles, &mut work, |TileArea { bounds, .. }, tile| {
            let reaches = !bounds.points.is_empty() && beam.reaches(bounds.points.low - 0.1, bounds.points.high + 0.1);
            if let (Some(tile), true) = (tile, reaches) {
                let way = bounds.lamp_rays(beam.position);
                let crossed = objects.iter().any(|o| way.may_meet(o.low, o.high, 1.0));
                tile.beams.push(BeamSweep { beam: i as u16, crossed });
            }
            reaches
        });
    }
    work
}

/// A tile or a larger area.
#[derive(Clone, Copy)]
struct TileArea<'a> {
    bounds: &'a TileBounds,
    rays: &'a TileRayBounds,
}

/// Runs a test over the picture, over those parts of it that pass it, and so on down to tiles.
fn mark(
    TileHierarchy { levels, .. }: &TileHierarchy,
    work: &mut [TileWork],
    mut test: impl FnMut(TileArea<'_>, Option<&mut TileWork>) -> bool,
) {
    mark_area(levels, [0, 0], work, &mut test);
}

/// The same for the area of the last of these levels at a place.
fn mark_area(
    levels: &[TileLevel],
    [x, y]: [u32; 2],
    work: &mut [TileWork],
    test: &mut impl FnMut(TileArea<'_>, Option<&mut TileWork>) -> bool,
) {
    let Some((level, below)) = levels.split_last() else { return };
    let i = (y * level.columns + x) as usize;
    let area = TileArea { bounds: &level.bounds[i], rays: &level.rays[i] };
    let Some(next) = below.last() else {
        test(area, Some(&mut work[i]));
        return;
    };
    if test(area, None) {
        for y in y * FACTOR..((y + 1) * FACTOR).min(next.rows) {
            for x in x * FACTOR..((x + 1) * FACTOR).min(next.columns) {
                mark_area(below, [x, y], work, test);
            }
        }
    }
}

/// Marks a tile with what an object does to it.
fn mark_object(
    object: &MovingVolume,
    shadows: &[LampShadow],
    index: u16,
    TileArea { bounds, rays }: TileArea<'_>,
    tile: &mut TileWork,
) {
    let (low, high) = (object.low, object.high);
    let meets = |rays: &RayBounds, reach: f32| {
        rays.may_meet(low, high, reach) && object.parts.iter().any(|&(low, high)| rays.may_meet(low, high, reach))
    };
    let sun = || rays.sun.as_ref().is_some_and(|b| meets(b, f32::MAX));
    let mirror = || rays.mirror.as_ref().is_some_and(|b| meets(b, bounds.mirror_reach * 1.001 + 0.1));
    let contact = || contact_may_reach(object, &bounds.points);
    let shades = |shadow: &LampShadow| {
        bounds.points.meets(shadow.span.low - 0.1, shadow.span.high + 0.1)
            && bounds.lamp_rays(shadow.position).may_meet(low, high, 1.0)
    };
    tile.sun = tile.sun || sun();
    tile.mirror = tile.mirror || mirror();
    if contact() {
        tile.contacts.push(index);
    }
    for shadow in shadows.iter().filter(|s| shades(s)) {
        if !tile.lamps.contains(&shadow.lamp) {
            tile.lamps.push(shadow.lamp);
        }
    }
}

/// Where an object's shadow by one lamp can lie.
struct LampShadow {
    lamp: u16,
    position: Vec3A,
    span: Bounds3,
}

/// Around all of some shadows, with the slack of a tile's test.
fn span_of(shadows: &[LampShadow]) -> Bounds3 {
    let mut span = Bounds3::EMPTY;
    for shadow in shadows {
        span.join(&Bounds3 { low: shadow.span.low - 0.1, high: shadow.span.high + 0.1 });
    }
    span
}

/// Bounds of the shadows that an object throws by the light of lamps, down to the lowest surface in view.
fn lamp_shadows(bake: &CameraBake, lamps: &Lamps, object: &MovingVolume) -> Vec<LampShadow> {
    let range = Lamps::range_m();
    let reach = |p: Vec3A, low: Vec3A, high: Vec3A| p.clamp(low, high).distance_squared(p) <= range * range * 1.01;
    let floor = bake.tiles.lowest - 0.1;
    if !bake.lighting.environment.night {
        return Vec::new();
    }
    lamps
        .all()
        .iter()
        .enumerate()
        .filter(|(_, lamp)| reach(lamp.position, object.low, object.high))
        .map(|(i, lamp)| {
            let position = lamp.position;
            let mut span = Bounds3 { low: object.low.with_z(floor), high: object.high };
            if position.z > object.high.z + 0.3 {
                // The top's corners, thrown from the lamp onto the floor.
                let stretch = (position.z - floor) / (position.z - object.high.z);
                span.add((position + (object.low - position) * stretch).with_z(floor));
                span.add((position + (object.high - position) * stretch).with_z(floor));
            } else {
                span.add(position - range);
                span.add(position + range);
            }
            LampShadow { lamp: i as u16, position, span }
        })
        .collect()
}
