//! The flow of what stands still before a camera that moves, as depth and the camera's places tell it.

use crate::{Layer, StoredImage};
use endless_world::{FAR_PLANE_M, FlowPixel, Image, InstancePixel, PinholeCamera};
use glam::Vec2;
use std::collections::BTreeMap;

/// A camera at a frame, and at those before and after it, where something tells it.
pub(super) struct CameraWay {
    pub(super) before: Option<PinholeCamera>,
    pub(super) now: PinholeCamera,
    pub(super) after: Option<PinholeCamera>,
}

/// How far a point may lie from where it is expected, pixels, and share of its way: places and depth are rounded.
const OFF_PX: f32 = 0.5;
const OFF_SHARE: f32 = 0.02;

impl CameraWay {
    /// Whether the camera is in one place at all three.
    pub(super) fn stands(&self) -> bool {
        [&self.before, &self.after].into_iter().flatten().all(|other| *other == self.now)
    }

    /// The layers of flow in which points of what is nobody's are not where they must be.
    pub(super) fn wrong_flow<'a>(
        &'a self,
        stored: &'a BTreeMap<Layer, StoredImage<'_>>,
        instance: &'a Image<InstancePixel>,
        depth: Option<&'a Image<f32>>,
    ) -> impl Iterator<Item = (Layer, String)> + 'a {
        let sides = [(Layer::Flow, &self.after), (Layer::FlowBackward, &self.before)];
        sides.into_iter().filter(|_| !self.stands()).filter_map(move |(layer, other)| {
            let (image, depth, other) = (stored.get(&layer)?.rgb16().ok()?, depth?, other.as_ref()?);
            let wrong = (0..image.data.len())
                .filter(|&i| instance.data[i].id.0 == 0 && self.is_wrong(i, image.data[i], depth.data[i], other));
            let count = wrong.count();
            (count > 0).then(|| (layer, format!("does not follow from the camera's way at {count} pixels")))
        })
    }

    fn is_wrong(&self, pixel: usize, stored: [u16; 3], depth: f32, other: &PinholeCamera) -> bool {
        let Ok(Some(FlowPixel { flow_px, .. })) = FlowPixel::decoded(stored) else { return false };
        if depth >= 0.999 * FAR_PLANE_M {
            return false;
        }
        let width = self.now.size.width as usize;
        let at = Vec2::new((pixel % width) as f32 + 0.5, (pixel / width) as f32 + 0.5);
        let Some(ray) = self.now.ray(at.x, at.y) else { return true };
        let distance = depth / self.now.depth_along(ray.direction, 1.0);
        let Some((place, _)) = other.project(ray.origin + ray.direction * distance) else { return true };
        let expected = self.now.way_in_image(at, place);
        (expected - flow_px).length() > OFF_PX + OFF_SHARE * expected.length()
    }
}
