//! KITTI: object detection, tracking, and the layout of the raw data.
//!
//! Geiger, Lenz and Urtasun 2012; the fields are those of the devkits' `readme.txt`. Boxes of KITTI turn about one axis only, the
//! camera's y, as KITTI's cameras stand level. Ours look down. So labels are in the frame of a camera at the same place that stands
//! level, and `P2` takes that frame to the picture: `P2 = K [R | 0]` with the tilt in R. `Tr_velo_to_cam` takes a sensor at the
//! same place (x ahead, y left, z up) to the level camera.

mod calibration;
mod object;
mod object_label;
mod raw;
mod tracking;

pub(crate) use object::KittiObject;
pub(crate) use raw::KittiRaw;
pub(crate) use tracking::KittiTracking;
