//! What a camera saw, and whether another one at its place saw the same.

use endless_dataset::{CameraLayout, Layer, RgbFormat, depth_from_rgb, instance_from_rgb, read_rgb};
use endless_world::{ClassTag, DepthMeasure, Image, ImageSize, InstancePixel, PinholeCamera, SensorFrame};

/// A frame of a camera.
pub(crate) struct Seen {
    pub(crate) camera: PinholeCamera,
    pub(crate) depth: Image<f32>,
    pub(crate) instance: Image<InstancePixel>,
    pub(crate) rgb: Image<[u8; 3]>,
}

impl Seen {
    /// Frame 1 as it is stored.
    pub(crate) fn read(files: &CameraLayout, camera: PinholeCamera) -> Self {
        let layer = |layer: Layer| read_rgb(&files.frame(layer, 1, RgbFormat::Png), layer.format(RgbFormat::Png));
        let layer = |named: Layer| layer(named).expect("a picture").rgb8().expect("8 bit").clone();
        let instance = instance_from_rgb(&layer(Layer::Instance)).expect("ids");
        Self { camera, depth: depth_from_rgb(&layer(Layer::Depth)), instance, rgb: layer(Layer::Rgb) }
    }

    /// As it is rendered.
    pub(crate) fn new(camera: PinholeCamera, frame: SensorFrame) -> Self {
        let SensorFrame { rgb, depth, instance, .. } = frame;
        Self { camera, depth, instance, rgb }
    }

    /// Distance from the lens of what a pixel shows, and what it is; `None` beside edges, where places decide.
    pub(crate) fn inner(&self, x: i32, y: i32) -> Option<(f32, InstancePixel)> {
        let ImageSize { width, height } = self.camera.size;
        if x < 1 || y < 1 || x + 1 >= width as i32 || y + 1 >= height as i32 {
            return None;
        }
        let (here, depth) = (*self.instance.at(x as u32, y as u32), *self.depth.at(x as u32, y as u32));
        let even = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (x + dx, y + dy))).all(|(x, y)| {
            let (x, y) = (x as u32, y as u32);
            *self.instance.at(x, y) == here && (self.depth.at(x, y) - depth).abs() < 0.1 * depth
        });
        let forward = self.camera.world_from_camera.z_axis;
        let ray = self.camera.ray(x as f32 + 0.5, y as f32 + 0.5).filter(|_| even)?;
        let planar = self.camera.lens.depth_measure() == DepthMeasure::Planar;
        Some((if planar { depth / ray.direction.dot(forward) } else { depth }, here))
    }

    /// How many of this one's pixels away from edges another camera at the same place shows, how many of those it shows
    /// as something else, and at how many of those that are alike it is nearer or farther.
    pub(crate) fn compare(&self, other: &Self) -> [u32; 4] {
        let ImageSize { width, height } = self.camera.size;
        let [mut asked, mut objects, mut unlike, mut apart] = [0; 4];
        for (x, y) in (0..height as i32).flat_map(|y| (0..width as i32).map(move |x| (x, y))) {
            let Some((distance, here)) = self.inner(x, y) else { continue };
            let ray = self.camera.ray(x as f32 + 0.5, y as f32 + 0.5).expect("it is shown");
            let Some((at, _)) = other.camera.project(ray.origin + ray.direction * distance) else { continue };
            let Some((there_m, there)) = other.inner(at.x.floor() as i32, at.y.floor() as i32) else { continue };
            asked += 1;
            objects += u32::from(here.id.0 > 0);
            unlike += u32::from(here != there);
            apart += u32::from(here == there && here.tag != ClassTag::Sky && (there_m / distance - 1.0).abs() > 0.1);
        }
        [asked, objects, unlike, apart]
    }
}
