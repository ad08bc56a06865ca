//! COCO: detection, keypoints and panoptic segmentation, and the folder layout of Roboflow.
//!
//! Format: <https://cocodataset.org/#format-data>. Boxes are `[x, y, w, h]` in pixels from the top-left corner, `w = xmax - xmin +
//! 1`; masks are compressed run lengths by column, as pycocotools writes them, or polygons along the edges of pixels.

mod annotation;
mod detection;
mod document;
mod keypoints;
mod panoptic;

pub(crate) use detection::CocoDetection;
pub(crate) use keypoints::CocoKeypoints;
pub(crate) use panoptic::CocoPanoptic;
