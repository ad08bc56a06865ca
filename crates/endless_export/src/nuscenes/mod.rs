//! nuScenes: the tables of its devkit in `v1.0-endless/`, pictures in `samples/CAM_A/` (Caesar et al. 2020, schema in
//! `docs/schema_nuscenes.md` of nuscenes-devkit).
//!
//! A video is a scene, an instant a sample. The ego frame of cameras that stand is the world's; that of a camera that moves goes with
//! it. There is no scanner: `num_lidar_pts` is the number of visible pixels in all cameras, since the devkit's evaluation leaves
//! out what has no points.

mod annotation;
mod tables;
mod token;

pub(crate) use tables::NuScenes;
