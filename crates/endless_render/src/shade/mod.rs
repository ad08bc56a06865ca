//! Light from a point towards a viewer: for what moves, and for what is seen in mirrors and by indirect rays.

mod headlight;
mod lamplight;
mod moving;
mod secondary;
mod tracer;

pub(crate) use moving::{Seen, footprint_m, shade_moving, shade_moving_together};
pub(crate) use secondary::{
    MIRROR_THRESHOLD, mirror_footprint, mirror_light, mirror_ray, shade_secondary, shade_secondary8, shade_struck,
    shade_struck8,
};
pub(crate) use tracer::{Struck, Tracer};
