//! Ground truth from the instance image and the state of the scene: boxes, visible pixels, tracks.
//!
//! Boxes are in image coordinates: pixels from the top-left corner, `[x, y, w, h]` with `w = xmax − xmin + 1`, tight
//! around the pixels that the object shows (COCO's convention). A track is an [`endless_world::InstanceId`]: the same
//! object in all cameras and in all frames of a video.

mod frame;
mod keypoint;
mod object;
mod visible;

pub use frame::{AnnotateError, FrameObjects, annotate};
pub use keypoint::{Bodies, Keypoint, Keypoints, Picture, Visibility};
pub use object::{ObjectRecord, SceneObjects};
pub use visible::{PixelBox, Visible, visible_objects};
