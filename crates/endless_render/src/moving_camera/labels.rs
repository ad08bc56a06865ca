//! What a camera sees, without light: for who asks for no colours.

use crate::accel::{Hit, RayStream, first_lanes, lanes};
use crate::camera_rays::{aims8, is_nowhere, set_row};
use crate::pixel_layers::{LayerImages, PixelLayers};
use crate::scene::{FrameScene, Instance, StaticScene, SurfaceInteraction};
use endless_world::{PinholeCamera, SensorFrame, SensorLayers};
use rayon::prelude::*;
use wide::f32x8;

/// Rows of a picture that are traced together.
const ROWS: usize = 4;

/// Depth and instances, and normals and parts of bodies if they are wanted, as a [`super::RoamingCamera`] shows them at this
/// instant. RGB is black. Albedo, shadow and flow are not told.
pub fn render_labels(
    still: &StaticScene,
    frame: &FrameScene,
    camera: &PinholeCamera,
    wanted: SensorLayers,
) -> SensorFrame {
    let wanted = SensorLayers { normals: wanted.normals, body_parts: wanted.body_parts, ..SensorLayers::default() };
    let height = camera.size.height as usize;
    let seen = LabelRays { still, frame, camera, wanted };
    let bands: Vec<Vec<LayerImages>> =
        (0..height.div_ceil(ROWS)).into_par_iter().with_max_len(1).map(|band| seen.band(ROWS * band)).collect();
    let layers = LayerImages::of_rows(wanted, bands.into_iter().flatten().collect());
    layers.into_sensor_frame(frame.frame, camera.size, vec![[0; 3]; camera.size.pixels()])
}

/// The rays through the centres of pixels.
struct LabelRays<'a> {
    still: &'a StaticScene,
    frame: &'a FrameScene,
    camera: &'a PinholeCamera,
    wanted: SensorLayers,
}

impl LabelRays<'_> {
    /// Some rows of the picture, the first of which is given.
    fn band(&self, y: usize) -> Vec<LayerImages> {
        let (width, rows) = (self.camera.size.width as usize, (self.camera.size.height as usize - y).min(ROWS));
        let mut layers: Vec<_> = (0..rows).map(|_| LayerImages::with_capacity(self.wanted, width)).collect();
        for first in (0..width).step_by(8) {
            let columns = (width - first).min(8);
            let mut rays = RayStream::<ROWS>::NONE;
            rays.tmax = [f32x8::splat(f32::MAX); ROWS];
            for row in 0..rows {
                let (x0, x1) = (first as u32, (first + columns) as u32);
                set_row(self.camera, &mut rays, row, aims8(self.camera, x0, x1, (y + row) as u32, 0));
            }
            let active = first_lanes(columns) & (u32::MAX >> (8 * (ROWS - rows)));
            let behind = self.still.accel.closest32(&rays, active);
            let nearer = self.frame.accel.closest32(&behind.shortened(&rays), active);
            for lane in lanes(active) {
                let in_front = nearer.get(lane).filter(|near| behind.get(lane).is_none_or(|far| near.t < far.t));
                let seen = match in_front {
                    Some(hit) => Some((&self.frame.instances, hit)),
                    None => behind.get(lane).map(|hit| (&self.still.instances, hit)),
                };
                layers[lane / 8].push(&self.labels(&rays, lane, seen));
            }
        }
        layers
    }

    fn labels(&self, rays: &RayStream<ROWS>, lane: usize, seen: Option<(&Vec<Instance>, Hit)>) -> PixelLayers {
        let ray = rays.ray(lane);
        let Some((instances, hit)) = seen else {
            return if is_nowhere(&ray) { PixelLayers::UNLIT } else { PixelLayers::SKY };
        };
        let point = SurfaceInteraction::new(instances, &ray, &hit);
        PixelLayers::without_albedo(self.wanted, self.camera, &ray, &point)
    }
}
