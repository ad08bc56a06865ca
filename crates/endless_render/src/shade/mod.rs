//! Radiance from a point towards a viewer: for moving objects, and for hits of mirror and indirect rays.

mod halo;
mod headlight;
mod lamplight;
mod moving;
mod secondary;
mod signal;
mod tracer;

pub(crate) use halo::{halos, halos8};
pub(crate) use moving::{MovingSample, footprint_m, shade_moving, shade_moving_together, sharp_share, soft_mirror};
pub(crate) use secondary::{
    MIRROR_THRESHOLD, mirror_footprint, mirror_light, mirror_ray, shade_hit, shade_hit8, sun_light,
};
pub(crate) use signal::lens_light;
pub(crate) use tracer::{SceneHit, Tracer};
