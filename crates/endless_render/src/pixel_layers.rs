//! All layers but RGB, from the hit of the ray through each pixel's centre. A new layer is a field of both types here.

use crate::accel::Ray;
use crate::camera_rays::planar_depth;
use crate::scene::SurfaceInteraction;
use endless_world::{ClassTag, FAR_PLANE_M, Image, ImageSize, InstanceId, InstancePixel, PinholeCamera, SensorFrame};

/// What the ray through one pixel's centre met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PixelLayers {
    /// Along the optical axis, metres.
    pub(crate) depth: f32,
    /// Class and object.
    pub(crate) instance: InstancePixel,
}

impl PixelLayers {
    /// Nothing.
    pub(crate) const SKY: Self =
        Self { depth: FAR_PLANE_M, instance: InstancePixel { tag: ClassTag::Sky, id: InstanceId::STUFF } };

    /// The point where the ray met a surface.
    pub(crate) fn new(camera: &PinholeCamera, ray: &Ray, point: &SurfaceInteraction<'_>) -> Self {
        Self {
            depth: planar_depth(camera, ray, point.distance),
            instance: InstancePixel { tag: point.tag(), id: point.instance.id },
        }
    }
}

/// The layers of a whole picture, row-major.
#[derive(Debug, Clone, Default)]
pub(crate) struct LayerImages {
    depth: Vec<f32>,
    instance: Vec<InstancePixel>,
}

impl LayerImages {
    /// One pixel's.
    pub(crate) fn at(&self, pixel: usize) -> PixelLayers {
        PixelLayers { depth: self.depth[pixel], instance: self.instance[pixel] }
    }

    /// Sets one pixel.
    pub(crate) fn set(&mut self, pixel: usize, layers: PixelLayers) {
        self.depth[pixel] = layers.depth;
        self.instance[pixel] = layers.instance;
    }

    /// Depth along the optical axis of every pixel, metres.
    pub(crate) fn depth(&self) -> &[f32] {
        &self.depth
    }

    /// With the picture that they belong to.
    pub(crate) fn into_sensor_frame(self, frame: u32, size: ImageSize, rgb: Vec<[u8; 3]>) -> SensorFrame {
        SensorFrame {
            frame,
            rgb: Image { size, data: rgb },
            depth: Image { size, data: self.depth },
            instance: Image { size, data: self.instance },
        }
    }
}

impl FromIterator<PixelLayers> for LayerImages {
    fn from_iter<I: IntoIterator<Item = PixelLayers>>(pixels: I) -> Self {
        let (depth, instance) = pixels.into_iter().map(|pixel| (pixel.depth, pixel.instance)).unzip();
        Self { depth, instance }
    }
}
