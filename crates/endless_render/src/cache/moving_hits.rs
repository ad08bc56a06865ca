//! Hits of one pixel's rays on moving objects.

use super::still_pixel::StillPixel;
use super::sun_rays::sun_origin;
use crate::accel::{Hit, Ray};
use crate::light::Environment;
use crate::sampling::SAMPLES;
use crate::scene::FrameScene;

/// What a pixel's rays towards what moves found, a sample each.
#[derive(Debug, Clone, Copy)]
pub(super) struct MovingHits {
    /// In front of the still surface.
    pub(super) primary: [Option<Hit>; SAMPLES],
    /// Directions to the sun that traffic blocks, a bit each.
    pub(super) sun_blocked: [u8; SAMPLES],
    /// In the mirror, nearer than what it mirrors of the town. A uniform pixel asks for every other sample.
    pub(super) mirrored: [Option<Hit>; SAMPLES],
}

impl MovingHits {
    /// Nothing found.
    pub(super) const NOTHING: Self =
        Self { primary: [None; SAMPLES], sun_blocked: [0; SAMPLES], mirrored: [None; SAMPLES] };

    /// Nothing that moves is on its way.
    pub(super) fn is_nothing(&self) -> bool {
        self.sun_blocked == [0; SAMPLES] && self.primary.iter().chain(&self.mirrored).all(Option::is_none)
    }

    /// Asks everything that moves, a ray at a time: the oracle of [`super::row::PixelRow::find`].
    pub(super) fn one_by_one(
        environment: &Environment,
        frame: &FrameScene,
        rays: &[Ray; SAMPLES],
        still: &StillPixel<'_>,
    ) -> Self {
        let mut found = Self::NOTHING;
        for s in 0..SAMPLES {
            let nearer = |ray: Ray| frame.accel.closest(&ray).filter(|hit| hit.t < ray.tmax);
            found.primary[s] = nearer(Ray { tmax: still.distances[s], ..rays[s] });
            if still.is_sky(s) {
                continue;
            }
            let facet = still.facet(&rays[s], s);
            if let Some(sun) = &environment.sun {
                let origin = sun_origin(&facet, sun.direction);
                for (part, direction) in sun.parts(s, still.uniform) {
                    let asked = still.sun_free[s] & part;
                    if asked != 0 && frame.accel.occluded(&Ray { origin, direction, tmax: f32::MAX }) {
                        found.sun_blocked[s] |= asked;
                    }
                }
            }
            if still.mirrored >> s & 1 == 1 {
                found.mirrored[s] = still.mirror(s).and_then(|mirror| nearer(mirror.ray(&facet)));
            }
        }
        found
    }
}
