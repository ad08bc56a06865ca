//! The sensor frame of one camera at one instant: aligned layers.

use crate::{ClassTag, ImageSize, InstanceId};

/// Depth of the sky: CARLA's far plane, metres.
pub const FAR_PLANE_M: f32 = 1000.0;

/// A row-major image, origin at the top-left pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Image<T> {
    /// Size.
    pub size: ImageSize,
    /// `width × height` values.
    pub data: Vec<T>,
}

impl<T: Clone> Image<T> {
    /// An image of one value.
    pub fn filled(size: ImageSize, value: T) -> Self {
        Self { size, data: vec![value; size.pixels()] }
    }

    /// The value at column x, row y.
    pub fn at(&self, x: u32, y: u32) -> &T {
        &self.data[y as usize * self.size.width as usize + x as usize]
    }
}

/// One pixel of the instance layer: exactly one object, never blended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct InstancePixel {
    /// Class of what the ray through the pixel's centre hit.
    pub tag: ClassTag,
    /// The object; 0 for stuff.
    pub id: InstanceId,
}

/// The images that a sensor frame has only where they are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SensorLayers {
    /// [`SensorFrame::normals`].
    pub normals: bool,
    /// [`SensorFrame::albedo`].
    pub albedo: bool,
    /// [`SensorFrame::shadow`].
    pub shadow: bool,
    /// [`SensorFrame::body_parts`].
    pub body_parts: bool,
    /// [`SensorFrame::flow`].
    pub flow: bool,
    /// [`SensorFrame::flow_backward`].
    pub flow_backward: bool,
}

impl SensorLayers {
    /// Everything.
    pub const ALL: Self =
        Self { normals: true, albedo: true, shadow: true, body_parts: true, flow: true, flow_backward: true };

    /// Whether a frame must know those beside it.
    pub fn needs_neighbours(&self) -> bool {
        self.flow || self.flow_backward
    }
}

/// All layers of one camera at one simulation frame.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorFrame {
    /// Simulation frame.
    pub frame: u32,
    /// sRGB, 8 bit.
    pub rgb: Image<[u8; 3]>,
    /// Planar depth along the optical axis, metres; [`FAR_PLANE_M`] for the sky.
    pub depth: Image<f32>,
    /// Class and instance of every pixel.
    pub instance: Image<InstancePixel>,
    /// Unit normal of the triangle that the ray through the pixel's centre met, on the side of the camera. Camera frame: x
    /// right, y down, z forward. Each is kept as `round((n + 1) / 2 × 65535)`; the sky is 0, 0, 0.
    pub normals: Option<Image<[u16; 3]>>,
    /// Share of white light that the surface at the pixel's centre gives back, without the light that falls on it: sRGB, 8
    /// bit; the sky is black.
    pub albedo: Option<Image<[u8; 3]>>,
    /// Share of the sun's disc that the surface at the pixel's centre does not see, 255 for all of it: because something
    /// is in the way, or because it faces away. 0 for the sky, and everywhere where no sun shines.
    pub shadow: Option<Image<u8>>,
    /// The [`BodyPart`](crate::BodyPart) of people and riders that the pixel's centre shows, 0 for everything else.
    pub body_parts: Option<Image<u8>>,
    /// Optical flow to the next frame of the video, as [`FlowPixel`](crate::FlowPixel) encodes it.
    pub flow: Option<Image<[u16; 3]>>,
    /// Optical flow to the frame before, encoded alike.
    pub flow_backward: Option<Image<[u16; 3]>>,
}
