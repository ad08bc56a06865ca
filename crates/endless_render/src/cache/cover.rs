//! What moves in front of a pixel, and which of its samples must be shaded to tell the pixel's colour.

use super::bake::{CameraBake, planar_depth};
use super::row::Found;
use crate::accel::Ray;
use crate::sampling::SAMPLES;
use crate::scene::{FrameScene, SurfacePoint};
use crate::shade::Seen;
use endless_asset::Surface;
use endless_world::InstancePixel;
use glam::Vec2;
use std::ops::Range;

/// What moves in front of a pixel.
pub(super) struct Cover {
    /// Depth and label, if it covers the pixel's centre.
    pub(super) centre: Option<(f32, InstancePixel)>,
    /// It fills the pixel: the mean of the shaded samples is the pixel's colour.
    pub(super) whole: bool,
    /// Way of what covers it in the image while the shutter is open, pixels.
    pub(super) way: Vec2,
    /// Where the samples to shade stand in the list; all that are covered, in order, if not `whole`.
    pub(super) shaded: Range<usize>,
}

impl Cover {
    /// Nothing.
    pub(super) const NONE: Self = Self { centre: None, whole: false, way: Vec2::ZERO, shaded: 0..0 };

    /// What rays found in front of a pixel; adds the samples to shade to a list.
    pub(super) fn new<'a>(
        bake: &CameraBake,
        frame: &'a FrameScene,
        rays: &[Ray; SAMPLES],
        found: &Found,
        list: &mut Vec<Seen<'a>>,
    ) -> Self {
        let first = list.len();
        let seen = |s: usize| {
            let hit = found.seen[s].as_ref()?;
            Some(Seen { point: SurfacePoint::new(&frame.instances, &rays[s], hit), sample: s })
        };
        let triangle = |s: usize| found.seen[s].as_ref().map(|hit| (hit.instance, hit.triangle));
        let centre = seen(0);
        let label = centre.as_ref().map(|Seen { point, .. }| {
            let label = InstancePixel { tag: point.tag(), id: point.instance.id };
            (planar_depth(&bake.camera, &rays[0], point.distance), label)
        });
        list.extend(centre);
        let way = |seen: &Seen<'_>| bake.way_in_image(seen.point.position, seen.point.instance.velocity);
        let mut whole = triangle(0).is_some() && (1..SAMPLES).all(|s| triangle(s) == triangle(0));
        if !whole {
            list.extend((1..SAMPLES).filter_map(seen));
            if let Some(count) = enough(&list[first..]) {
                whole = true;
                // The centre and a sample on the far side.
                list.swap(first + 1, first + 2);
                list.truncate(first + count);
            }
        }
        Self { centre: label, whole, way: list.get(first).map_or(Vec2::ZERO, way), shaded: first..list.len() }
    }
}

/// How many samples tell a pixel that lies wholly on one smooth piece of something that moves: two on shiny curves, else
/// one.
fn enough(seen: &[Seen<'_>]) -> Option<usize> {
    let [Seen { point: centre, .. }, rest @ ..] = seen else { return None };
    if centre.material.surface == Surface::CarGlass {
        // What it shows of the inside has edges of its own.
        return None;
    }
    let smooth = |s: &Seen<'_>| {
        std::ptr::eq(s.point.material, centre.material)
            && s.point.instance.id == centre.instance.id
            && s.point.normal.dot(centre.normal) > 0.96
    };
    if seen.len() < SAMPLES || !rest.iter().all(smooth) {
        return None;
    }
    let flat = rest.iter().all(|s| s.point.normal.dot(centre.normal) > 0.995);
    let shiny = !flat && matches!(centre.material.surface, Surface::CarPaint | Surface::Chrome | Surface::Painted);
    Some(if shiny { 2 } else { 1 })
}
