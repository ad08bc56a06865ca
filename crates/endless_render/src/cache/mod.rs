//! The fixed-camera cache: the static scene is shaded once a video, and a frame retraces only what can have changed.
//!
//! A frame is defined without the cache: every sample of every pixel is the light of a still surface, as the moving
//! world shades, mirrors and lights it now, or the light of a moving surface in front of it
//! ([`CameraBake::render_uncached`]). The cache only leaves out work whose result is known: per tile of pixels it asks
//! which moving objects could touch it (by being seen, by shadow, by contact, in a mirror, by their lights), always
//! erring towards more, and copies the rest. A test proves that both give the same bytes.

mod affected;
mod bake;
mod bake_pass;
mod bake_shading;
mod bake_stats;
mod block_hits;
mod block_light;
mod block_shading;
mod bounds8;
mod camera_film;
mod centre_band;
mod centre_light;
mod centre_pass;
mod compose;
mod contact_shadow;
mod coverage;
mod covered_centres;
mod developed_frame;
mod edge_samples;
mod faint_ends;
mod flow;
mod flow_from_elsewhere;
mod frame;
mod frame_buffer;
mod gbuffer;
mod gbuffer_row;
mod gbuffer_sample;
mod gbuffer_shading;
mod irradiance;
mod lamp_mask;
mod mirror;
mod moving_centre;
mod moving_hits;
mod object_group;
mod other_instant;
mod packed_hit;
mod penumbra;
mod picture_memory;
mod pieces8;
mod pixel;
mod pixel_centre;
mod point_grid;
mod primary;
mod primary_hits;
mod ray_bounds;
mod ray_queue;
mod retrace;
mod row;
mod row_block;
mod sample_bundle;
mod scratch_pool;
mod shaded_pixel;
mod shadow;
mod shadow_edges;
mod sky_sample;
mod sparse_centre;
mod sparse_primary;
mod sparse_row;
mod still_pixel;
mod still_radiance;
mod sun_bundle;
mod sun_rays;
mod surface_ends;
mod sweep;
mod tile;
mod tile_bounds;
mod tile_context;
mod tile_coverage;
mod tile_hierarchy;
mod tile_work;
mod visible_tiles;
mod waiting_sun_rays;

pub use bake::CameraBake;
pub use bake_stats::BakeStats;
pub(crate) use camera_film::FilmResponse;
pub use covered_centres::CoveredCentres;
pub use flow::{NeighbourFrame, NeighbourFrames};
pub(crate) use picture_memory::PictureMemory;
pub(crate) use scratch_pool::ScratchPool;
