//! The layers that follow from the hit of the ray through each pixel's centre alone. A new one is a field of both types here.

use crate::accel::Ray;
use crate::camera_rays::measured_depth;
use crate::film::{mix_rgb, mix_values, srgb};
use crate::material::Bsdf;
use crate::scene::SurfaceInteraction;
use endless_world::{
    BodyPart, ClassTag, FAR_PLANE_M, Image, ImageSize, InstanceId, InstancePixel, PinholeCamera, SensorFrame,
    SensorLayers,
};
use glam::Vec3A;

/// What the ray through one pixel's centre met.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SeenPixel {
    /// As the lens measures it, metres.
    pub(crate) depth: f32,
    /// Class and object.
    pub(crate) instance: InstancePixel,
}

/// What all layers but RGB show of a pixel; nothing in those that are not wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PixelLayers {
    seen: SeenPixel,
    normal: [u16; 3],
    albedo: [u8; 3],
    shadow: u8,
    body_part: u8,
}

impl PixelLayers {
    /// The open sky.
    pub(crate) const SKY: Self = Self::nothing(ClassTag::Sky);
    /// Where the lens shows nothing.
    pub(crate) const UNLIT: Self = Self::nothing(ClassTag::Unlabeled);

    /// No surface.
    const fn nothing(tag: ClassTag) -> Self {
        let instance = InstancePixel { tag, id: InstanceId::STUFF };
        let seen = SeenPixel { depth: FAR_PLANE_M, instance };
        Self { seen, normal: [0; 3], albedo: [0; 3], shadow: 0, body_part: 0 }
    }

    /// The point where the ray met a surface, whose BSDF is asked for if it is needed.
    pub(crate) fn new(
        wanted: SensorLayers,
        camera: &PinholeCamera,
        ray: &Ray,
        point: &SurfaceInteraction<'_>,
        bsdf: impl FnOnce() -> Bsdf,
    ) -> Self {
        let albedo = if wanted.albedo { encoded_albedo(&bsdf()) } else { [0; 3] };
        Self { albedo, ..Self::without_albedo(wanted, camera, ray, point) }
    }

    /// The same where nobody wants to know the albedo.
    pub(crate) fn without_albedo(
        wanted: SensorLayers,
        camera: &PinholeCamera,
        ray: &Ray,
        point: &SurfaceInteraction<'_>,
    ) -> Self {
        Self {
            seen: SeenPixel {
                depth: measured_depth(camera, ray, point.distance),
                instance: InstancePixel { tag: point.tag(), id: point.instance.id },
            },
            normal: if wanted.normals { encoded_normal(camera, point.geometric_normal) } else { [0; 3] },
            albedo: [0; 3],
            shadow: 0,
            body_part: if wanted.body_parts { body_part(point) } else { 0 },
        }
    }

    /// The same in the shadow.
    pub(crate) fn with_shadow(self, shadow: u8) -> Self {
        Self { shadow, ..self }
    }
}

/// 0 for what is nobody's.
fn body_part(point: &SurfaceInteraction<'_>) -> u8 {
    point.instance.geometry.body_part(point.triangle).map_or(0, BodyPart::value)
}

/// Camera frame, 65,535 for 1, 0 for −1.
fn encoded_normal(camera: &PinholeCamera, normal: Vec3A) -> [u16; 3] {
    let axes = &camera.world_from_camera;
    [axes.x_axis, axes.y_axis, axes.z_axis].map(|axis| {
        let along = Vec3A::from(axis).dot(normal);
        ((along + 1.0) * (0.5 * 65_535.0) + 0.5) as u16
    })
}

/// What the surface gives back of white light that falls straight on it: of metals, what they mirror. sRGB.
fn encoded_albedo(bsdf: &Bsdf) -> [u8; 3] {
    let coat = bsdf.coat_f0 * bsdf.coat;
    let reflectance = bsdf.albedo * (Vec3A::ONE - coat) + coat;
    reflectance.to_array().map(|linear| (srgb(linear.clamp(0.0, 1.0)) * 255.0 + 0.5) as u8)
}

/// The layers of a whole picture, row-major; those that are not wanted have no pixels.
#[derive(Debug, Clone, Default)]
pub(crate) struct LayerImages {
    depth: Vec<f32>,
    instance: Vec<InstancePixel>,
    normals: Option<Vec<[u16; 3]>>,
    albedo: Option<Vec<[u8; 3]>>,
    shadow: Option<Vec<u8>>,
    body_parts: Option<Vec<u8>>,
}

impl LayerImages {
    /// No pixels yet, and room for so many.
    pub(crate) fn with_capacity(wanted: SensorLayers, pixels: usize) -> Self {
        Self {
            depth: Vec::with_capacity(pixels),
            instance: Vec::with_capacity(pixels),
            normals: wanted.normals.then(|| Vec::with_capacity(pixels)),
            albedo: wanted.albedo.then(|| Vec::with_capacity(pixels)),
            shadow: wanted.shadow.then(|| Vec::with_capacity(pixels)),
            body_parts: wanted.body_parts.then(|| Vec::with_capacity(pixels)),
        }
    }

    /// Adds the next pixel.
    pub(crate) fn push(&mut self, pixel: &PixelLayers) {
        self.depth.push(pixel.seen.depth);
        self.instance.push(pixel.seen.instance);
        self.normals.iter_mut().for_each(|normals| normals.push(pixel.normal));
        self.albedo.iter_mut().for_each(|albedo| albedo.push(pixel.albedo));
        self.shadow.iter_mut().for_each(|shadow| shadow.push(pixel.shadow));
        self.body_parts.iter_mut().for_each(|parts| parts.push(pixel.body_part));
    }

    /// The picture of these rows.
    pub(crate) fn of_rows(wanted: SensorLayers, rows: Vec<Self>) -> Self {
        let mut images = Self::with_capacity(wanted, rows.iter().map(|row| row.depth.len()).sum());
        for row in rows {
            images.depth.extend(row.depth);
            images.instance.extend(row.instance);
            images.normals.iter_mut().for_each(|normals| normals.extend(row.normals.iter().flatten()));
            images.albedo.iter_mut().for_each(|albedo| albedo.extend(row.albedo.iter().flatten()));
            images.shadow.iter_mut().for_each(|shadow| shadow.extend(row.shadow.iter().flatten()));
            images.body_parts.iter_mut().for_each(|parts| parts.extend(row.body_parts.iter().flatten()));
        }
        images
    }

    /// What a pixel shows.
    pub(crate) fn at(&self, pixel: usize) -> SeenPixel {
        SeenPixel { depth: self.depth[pixel], instance: self.instance[pixel] }
    }

    /// Sets one pixel.
    pub(crate) fn set(&mut self, pixel: usize, layers: &PixelLayers) {
        self.depth[pixel] = layers.seen.depth;
        self.instance[pixel] = layers.seen.instance;
        if let Some(normals) = &mut self.normals {
            normals[pixel] = layers.normal;
        }
        if let Some(albedo) = &mut self.albedo {
            albedo[pixel] = layers.albedo;
        }
        if let Some(parts) = &mut self.body_parts {
            parts[pixel] = layers.body_part;
        }
        self.set_shadow(pixel, layers.shadow);
    }

    /// Sets the shadow of one pixel, if it is wanted.
    pub(crate) fn set_shadow(&mut self, pixel: usize, value: u8) {
        if let Some(shadow) = &mut self.shadow {
            shadow[pixel] = value;
        }
    }

    /// The same instant in a light that is this share of the way to another: only the light differs.
    pub(crate) fn mixed(mut self, other: &Self, share: f32) -> Self {
        if let (Some(albedo), Some(next)) = (&mut self.albedo, &other.albedo) {
            mix_rgb(albedo, next, share);
        }
        if let (Some(shadow), Some(next)) = (&mut self.shadow, &other.shadow) {
            mix_values(shadow, next, share);
        }
        self
    }

    /// Depth of every pixel as the lens measures it, metres.
    pub(crate) fn depth(&self) -> &[f32] {
        &self.depth
    }

    /// With the picture that they belong to, without flow.
    pub(crate) fn into_sensor_frame(self, frame: u32, size: ImageSize, rgb: Vec<[u8; 3]>) -> SensorFrame {
        SensorFrame {
            frame,
            rgb: Image { size, data: rgb },
            depth: Image { size, data: self.depth },
            instance: Image { size, data: self.instance },
            normals: self.normals.map(|data| Image { size, data }),
            albedo: self.albedo.map(|data| Image { size, data }),
            shadow: self.shadow.map(|data| Image { size, data }),
            body_parts: self.body_parts.map(|data| Image { size, data }),
            flow: None,
            flow_backward: None,
        }
    }
}
