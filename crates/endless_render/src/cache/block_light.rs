//! What is kept of the light of a block's samples.

use super::gbuffer_sample::MirrorSample;
use super::row_block::{BLOCK, LANES};
use crate::accel::Ray;
use crate::material::PackedBsdf;
use crate::pixel_layers::PixelLayers;
use crate::rgb9e5::Rgb9e5;
use glam::Vec3A;

/// In the place of the number of a mirror: there is none.
const NO_MIRROR: u16 = u16::MAX;

/// The light of one sample: fog applied.
#[derive(Clone, Copy)]
pub(super) struct KeptLight {
    pub(super) rest: Rgb9e5,
    pub(super) ambient: Rgb9e5,
    pub(super) direct: Rgb9e5,
    /// Which lamps near it light it past the static scene, a bit each.
    pub(super) lamps_free: u32,
    mirror: u16,
    /// On a lens of a traffic light.
    pub(super) is_lens: bool,
}

impl KeptLight {
    const NONE: Self = Self {
        rest: Rgb9e5::ZERO,
        ambient: Rgb9e5::ZERO,
        direct: Rgb9e5::ZERO,
        lamps_free: 0,
        mirror: NO_MIRROR,
        is_lens: false,
    };

    /// Of the rest, of ambient and of direct light.
    pub(super) fn new([rest, ambient, direct]: [Rgb9e5; 3]) -> Self {
        Self { rest, ambient, direct, ..Self::NONE }
    }

    /// Of the sky.
    pub(super) fn sky(rest: Rgb9e5) -> Self {
        Self { rest, ..Self::NONE }
    }
}

/// A sample whose coat mirrors something.
pub(super) struct BlockMirror {
    pub(super) lane: u16,
    /// Into the mirror.
    pub(super) ray: Ray,
    /// Share of the mirrored light that the coat reflects.
    pub(super) weight: Vec3A,
    pub(super) roughness: f32,
    /// Width of the detail that matters in its image, metres.
    pub(super) footprint_m: f32,
    /// Of the air before the sample, and what that adds.
    pub(super) transmittance: f32,
    pub(super) glow: Vec3A,
    /// Direct light before any air.
    pub(super) lamps: Vec3A,
    /// The rest, ambient and direct light of the sample, fog applied: not yet packed.
    pub(super) light: [Vec3A; 3],
    /// What is kept of it, once it is traced.
    pub(super) sample: MirrorSample,
}

/// What is kept of a block's light, by lane; of lanes whose light another tells, nothing.
pub(super) struct BlockLight {
    lights: [KeptLight; LANES],
    /// The light of the sky, not yet packed, by lane.
    pub(super) sky: [Vec3A; LANES],
    pub(super) mirrors: Vec<BlockMirror>,
    /// The rest, ambient and direct light of the third samples of uniform pixels, where they are shaded: not yet packed.
    pub(super) thirds: [[Vec3A; 3]; BLOCK],
    /// What each pixel's centre shows in all layers but RGB.
    pub(super) layers: [PixelLayers; BLOCK],
    /// At night, of the centres of uniform pixels.
    pub(super) bsdfs: [Option<PackedBsdf>; BLOCK],
}

impl BlockLight {
    pub(super) fn new() -> Self {
        Self {
            lights: [KeptLight::NONE; LANES],
            sky: [Vec3A::ZERO; LANES],
            mirrors: Vec::with_capacity(LANES),
            thirds: [[Vec3A::ZERO; 3]; BLOCK],
            layers: [PixelLayers::SKY; BLOCK],
            bsdfs: [const { None }; BLOCK],
        }
    }

    pub(super) fn set(&mut self, lane: usize, light: KeptLight) {
        self.lights[lane] = light;
    }

    /// Gives the light of a lane a mirror.
    pub(super) fn push_mirror(&mut self, mirror: BlockMirror) {
        self.lights[usize::from(mirror.lane)].mirror = self.mirrors.len() as u16;
        self.mirrors.push(mirror);
    }

    /// The light of a lane; of none, none.
    pub(super) fn get(&self, lane: u16) -> &KeptLight {
        self.lights.get(usize::from(lane)).unwrap_or(&KeptLight::NONE)
    }

    /// Its mirror, if it has one.
    pub(super) fn mirror(&self, lane: u16) -> Option<&BlockMirror> {
        self.mirrors.get(usize::from(self.get(lane).mirror))
    }
}
