//! YOLO, as Ultralytics reads it: detection, segmentation, pose and oriented boxes.
//!
//! Format: <https://docs.ultralytics.com/datasets/>. `data.yaml` names the parts and the classes; each image has a text file of
//! the same name below `labels`, a line an object; numbers are shares of the picture's width and height. A picture without
//! objects has an empty file.

mod oriented;
mod task;

pub(crate) use task::{Yolo, YoloTask};
