//! Where rays end that every bake of a camera sends in the same order, whatever the light: found once, then read.

use crate::accel::{Hit, Ray};
use crate::scene::StaticScene;
use crate::shade::{SceneHit, Tracer};
use std::slice;

/// The triangle at which a ray ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct RayEnd {
    pub(crate) instance: u32,
    pub(crate) triangle: u32,
}

impl RayEnd {
    /// A ray that meets nothing.
    const NOTHING: Self = Self { instance: u32::MAX, triangle: u32::MAX };

    fn new(hit: Option<&Hit>) -> Self {
        hit.map_or(Self::NOTHING, |hit| Self { instance: hit.instance, triangle: hit.triangle })
    }
}

/// The ends of some rays, in the order in which they are sent.
pub(crate) enum HitTape<'a> {
    /// Rays are traced.
    Traced,
    /// Rays are traced, and their ends kept.
    Recorded(Vec<RayEnd>),
    /// The ends are known.
    Replayed(slice::Iter<'a, RayEnd>),
}

impl HitTape<'_> {
    /// The nearest surface that stands still along the next ray.
    pub(crate) fn closest(&mut self, tracer: &Tracer<'_>, ray: &Ray) -> Option<SceneHit> {
        let hit = match self {
            Self::Replayed(ends) => replayed(tracer.still, ray, ends.next()),
            Self::Traced | Self::Recorded(_) => tracer.still.accel.closest(ray),
        };
        if let Self::Recorded(ends) = self {
            ends.push(RayEnd::new(hit.as_ref()));
        }
        hit.map(SceneHit::still)
    }

    /// [`Self::closest`] for those of the next eight rays whose bit is set in `active`.
    pub(crate) fn closest8(&mut self, tracer: &Tracer<'_>, rays: &[Ray; 8], active: u8) -> [Option<SceneHit>; 8] {
        let asked = |i: &usize| active >> i & 1 == 1;
        let hits = match self {
            Self::Replayed(ends) => {
                let mut replay = |i: usize| replayed(tracer.still, &rays[i], ends.next());
                std::array::from_fn(|i| Some(i).filter(asked).and_then(&mut replay))
            }
            Self::Traced | Self::Recorded(_) => tracer.still.accel.closest8(rays, active),
        };
        if let Self::Recorded(ends) = self {
            ends.extend((0..8).filter(asked).map(|i| RayEnd::new(hits[i].as_ref())));
        }
        hits.map(|hit| hit.map(SceneHit::still))
    }

    /// The ends that were kept.
    pub(crate) fn into_ends(self) -> Vec<RayEnd> {
        match self {
            Self::Recorded(mut ends) => {
                ends.shrink_to_fit();
                ends
            }
            Self::Traced | Self::Replayed(_) => Vec::new(),
        }
    }
}

/// The hit of a ray whose end is known. One that does not meet what it should is traced.
fn replayed(still: &StaticScene, ray: &Ray, end: Option<&RayEnd>) -> Option<Hit> {
    match end {
        Some(&RayEnd::NOTHING) => None,
        Some(end) => still.hit_on(ray, end.instance, end.triangle).or_else(|| still.accel.closest(ray)),
        None => still.accel.closest(ray),
    }
}
