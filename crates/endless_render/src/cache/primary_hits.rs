//! What the first pass of a bake found.

use super::packed_hit::PackedHit;
use crate::accel::{Hit, Ray};
use crate::indirect::GatherPoint;
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::{ShadingPoint, SurfaceInteraction};

/// What the samples see: all by pixel, row by row.
pub(super) struct PrimaryHits {
    width: usize,
    /// How far each sample lies from the lens, metres; [`f32::MAX`] for the sky.
    pub(super) distances: Vec<[f32; SAMPLES]>,
    /// Which parts of the sun's disc what stands still leaves each sample, a bit each.
    pub(super) sun_free: Vec<[u8; SAMPLES]>,
    /// Whether all samples lie on one flat piece of one surface.
    pub(super) uniform: Vec<bool>,
    /// What is needed no longer once a row is shaded.
    pub(super) surfaces: Vec<RowSurfaces>,
}

/// On what the samples of a row lie.
pub(super) struct RowSurfaces {
    pub(super) hits: Vec<[PackedHit; SAMPLES]>,
    pub(super) normals: Vec<[PackedNormals; SAMPLES]>,
}

impl RowSurfaces {
    /// Of a row of sky.
    pub(super) fn nothing(width: usize) -> Self {
        let (hits, normals) = ([PackedHit::NONE; SAMPLES], [PackedNormals::NONE; SAMPLES]);
        Self { hits: vec![hits; width], normals: vec![normals; width] }
    }
}

/// A row of [`PrimaryHits`].
#[derive(Clone, Copy)]
pub(super) struct PrimaryRow<'a> {
    pub(super) distances: &'a [[f32; SAMPLES]],
    pub(super) sun_free: &'a [[u8; SAMPLES]],
    pub(super) uniform: &'a [bool],
    pub(super) surfaces: &'a RowSurfaces,
}

/// The normals of a surface where a sample sees it, packed.
#[derive(Debug, Clone, Copy)]
pub(super) struct PackedNormals {
    /// Of the triangle.
    pub(super) geometric: u32,
    /// Interpolated.
    pub(super) shading: u32,
}

impl PackedNormals {
    /// Those of the sky.
    pub(super) const NONE: Self = Self { geometric: 0, shading: 0 };

    pub(super) fn new(point: &SurfaceInteraction<'_>) -> Self {
        let geometric = octahedron::pack(point.geometric_normal);
        let is_flat = point.normal == point.geometric_normal;
        Self { geometric, shading: if is_flat { geometric } else { octahedron::pack(point.normal) } }
    }
}

/// What the samples of one pixel see.
#[derive(Clone, Copy)]
pub(super) struct PrimaryPixel<'a> {
    pub(super) distances: &'a [f32; SAMPLES],
    pub(super) hits: &'a [PackedHit; SAMPLES],
    pub(super) normals: &'a [PackedNormals; SAMPLES],
    pub(super) sun_free: &'a [u8; SAMPLES],
    pub(super) uniform: bool,
}

impl PrimaryHits {
    /// Nothing seen yet.
    pub(super) fn new(width: usize, height: usize) -> Self {
        let pixels = width * height;
        Self {
            width,
            distances: vec![[f32::MAX; SAMPLES]; pixels],
            sun_free: vec![[0; SAMPLES]; pixels],
            uniform: vec![false; pixels],
            surfaces: (0..height).map(|_| RowSurfaces::nothing(width)).collect(),
        }
    }

    /// Of one pixel.
    pub(super) fn pixel(&self, pixel: usize) -> PrimaryPixel<'_> {
        let (y, x) = (pixel / self.width, pixel % self.width);
        let row = y * self.width..(y + 1) * self.width;
        let (distances, sun_free) = (&self.distances[row.clone()], &self.sun_free[row.clone()]);
        PrimaryRow { distances, sun_free, uniform: &self.uniform[row], surfaces: &self.surfaces[y] }.pixel(x)
    }
}

impl<'a> PrimaryRow<'a> {
    /// Of one pixel.
    pub(super) fn pixel(&self, x: usize) -> PrimaryPixel<'a> {
        PrimaryPixel {
            distances: &self.distances[x],
            hits: &self.surfaces.hits[x],
            normals: &self.surfaces.normals[x],
            sun_free: &self.sun_free[x],
            uniform: self.uniform[x],
        }
    }
}

impl PrimaryPixel<'_> {
    /// What a sample sees.
    pub(super) fn hit(&self, sample: usize) -> Option<Hit> {
        self.hits[sample].at(self.distances[sample])
    }

    /// Where light is gathered for a sample, seen along its ray.
    pub(super) fn gather_point(&self, ray: &Ray, sample: usize) -> Option<GatherPoint> {
        let (distance, normals) = (self.distances[sample], &self.normals[sample]);
        let facet = || ShadingPoint::along(ray, distance, octahedron::unpack(normals.geometric));
        (distance < f32::MAX).then(|| GatherPoint { facet: facet(), normal: octahedron::unpack(normals.shading) })
    }

    /// How many samples tell what the pixel shows: one if it is uniform or of nothing but sky.
    pub(super) fn kept_samples(&self) -> usize {
        if self.uniform || *self.distances == [f32::MAX; SAMPLES] { 1 } else { SAMPLES }
    }
}
