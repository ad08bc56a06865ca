//! What the first pass of a bake found.

use super::packed_hit::PackedHit;
use crate::accel::{Hit, Ray};
use crate::indirect::GatherPoint;
use crate::octahedron;
use crate::sampling::SAMPLES;
use crate::scene::{ShadingPoint, SurfaceInteraction};

/// What the samples see: all by pixel, row-major.
pub(super) struct PrimaryHits {
    /// How far each sample lies from the lens, metres; [`f32::MAX`] for the sky.
    pub(super) distances: Vec<[f32; SAMPLES]>,
    pub(super) hits: Vec<[PackedHit; SAMPLES]>,
    pub(super) normals: Vec<[PackedNormals; SAMPLES]>,
    /// Which parts of the sun's disc what stands still leaves each sample, a bit each.
    pub(super) sun_free: Vec<[u8; SAMPLES]>,
    /// Whether all samples lie on one flat piece of one surface.
    pub(super) uniform: Vec<bool>,
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
        Self { geometric: octahedron::pack(point.geometric_normal), shading: octahedron::pack(point.normal) }
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
    pub(super) fn new(pixels: usize) -> Self {
        Self {
            distances: vec![[f32::MAX; SAMPLES]; pixels],
            hits: vec![[PackedHit::NONE; SAMPLES]; pixels],
            normals: vec![[PackedNormals::NONE; SAMPLES]; pixels],
            sun_free: vec![[0; SAMPLES]; pixels],
            uniform: vec![false; pixels],
        }
    }

    /// Of one pixel.
    pub(super) fn pixel(&self, pixel: usize) -> PrimaryPixel<'_> {
        PrimaryPixel {
            distances: &self.distances[pixel],
            hits: &self.hits[pixel],
            normals: &self.normals[pixel],
            sun_free: &self.sun_free[pixel],
            uniform: self.uniform[pixel],
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
