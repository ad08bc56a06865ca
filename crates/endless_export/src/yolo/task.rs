//! What a YOLO model learns, and the lines of its labels.

use super::oriented::smallest_rectangle;
use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
    outline::{joined, outlines},
};
use endless_annotate::Visibility;
use endless_dataset::Layer;
use endless_world::{Image, ImageSize, InstancePixel, KEYPOINT_COUNT, ObjectClass};
use glam::DVec2;
use std::fmt::Write as _;

/// What is to be learnt.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum YoloTask {
    /// `class x y w h`, the middle of the box and its size.
    Detect,
    /// `class x1 y1 x2 y2 ...`, one polygon.
    Segment,
    /// `class x y w h` and `x y v` for each of COCO's keypoints; people and riders only.
    Pose,
    /// `class x1 y1 x2 y2 x3 y3 x4 y4`, the smallest rectangle around what can be seen.
    OrientedBoxes,
}

/// The folders of a task.
#[derive(Debug)]
pub(crate) struct Yolo(pub(crate) YoloTask);

/// What the place of each keypoint becomes when the picture is mirrored.
const FLIP_IDX: [usize; KEYPOINT_COUNT] = [0, 2, 1, 4, 3, 6, 5, 8, 7, 10, 9, 12, 11, 14, 13, 16, 15];

impl Yolo {
    /// The classes that there are, by place in the mapping: those with keypoints where poses are learnt.
    fn classes(&self, export: &Export<'_>) -> Vec<usize> {
        let has_pose = |class: &ObjectClass| matches!(class, ObjectClass::Pedestrian | ObjectClass::Rider);
        let classes = export.classes.classes.iter().enumerate();
        let taken = classes.filter(|(_, c)| self.0 != YoloTask::Pose || c.from.iter().any(has_pose));
        taken.map(|(place, _)| place).collect()
    }

    fn line(&self, classes: &[usize], label: &Label, size: ImageSize, image: Option<&Image<InstancePixel>>) -> String {
        let object = &label.object;
        let Some(class) = classes.iter().position(|&place| place == label.class) else { return String::new() };
        let mut line = class.to_string();
        let [x, y, w, h] = <[u32; 4]>::from(object.bbox).map(f64::from);
        let share = |at: [f64; 2]| [at[0] / f64::from(size.width), at[1] / f64::from(size.height)];
        let put = |line: &mut String, at: [f64; 2]| {
            let [x, y] = share(at);
            // A string takes whatever is written to it.
            let _ = write!(line, " {x:.6} {y:.6}");
        };
        let polygons = || image.map(|image| outlines(image, object.id, object.bbox)).unwrap_or_default();
        match self.0 {
            YoloTask::Detect | YoloTask::Pose => {
                put(&mut line, [x + w / 2.0, y + h / 2.0]);
                put(&mut line, [w, h]);
            }
            YoloTask::Segment => {
                joined(polygons()).into_iter().for_each(|corner| put(&mut line, corner.map(f64::from)));
            }
            YoloTask::OrientedBoxes => {
                let corners = polygons().into_iter().flatten().map(|[x, y]| DVec2::new(f64::from(x), f64::from(y)));
                let around = smallest_rectangle(&corners.collect::<Vec<_>>());
                around.into_iter().flatten().for_each(|corner| put(&mut line, corner.to_array()));
            }
        }
        if self.0 == YoloTask::Pose {
            let Some(keypoints) = &object.keypoints else { return String::new() };
            for point in &keypoints.0 {
                put(&mut line, [point.x, point.y]);
                let _ = write!(line, " {}", point.visibility as u8);
                debug_assert!(point.visibility != Visibility::Outside || point.x == 0.0);
            }
        }
        line + "\n"
    }
}

impl Exporter for Yolo {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let classes = self.classes(video.export);
        let split = video.split();
        let needs_masks = matches!(self.0, YoloTask::Segment | YoloTask::OrientedBoxes);
        for (_, sequence) in video.sequences() {
            let make = |frame: &LabelledFrame<'_>| {
                let name = frame.name();
                video.place_image(
                    frame,
                    Layer::Rgb,
                    &format!("images/{split}/{name}.{}", sequence.extension(Layer::Rgb)),
                )?;
                let image = if needs_masks && !frame.labels.is_empty() { Some(frame.instance()?) } else { None };
                let line = |label: &Label| self.line(&classes, label, sequence.output.size, image.as_deref());
                let lines: String = frame.labels.iter().map(line).collect();
                video.export.target.write(format!("labels/{split}/{name}.txt"), lines.as_bytes())
            };
            video.frames(sequence, make, Ok)?;
        }
        Ok(())
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        // Without `path`, Ultralytics looks beside this file, wherever that is moved.
        let mut yaml = String::new();
        for name in &export.splits {
            let _ = writeln!(yaml, "{name}: images/{name}");
        }
        if !export.splits.iter().any(|name| name == "val") {
            // Ultralytics wants one; there are no other videos.
            let _ = writeln!(yaml, "val: images/{}", export.splits[0]);
        }
        if self.0 == YoloTask::Pose {
            let _ = writeln!(yaml, "kpt_shape: [{KEYPOINT_COUNT}, 3]\nflip_idx: {FLIP_IDX:?}");
        }
        yaml.push_str("names:\n");
        for (number, place) in self.classes(export).into_iter().enumerate() {
            let name = serde_json::to_string(&export.classes.classes[place].name).expect("plain text");
            let _ = writeln!(yaml, "  {number}: {name}");
        }
        export.target.write("data.yaml", yaml.as_bytes())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::KEYPOINTS;

    #[test]
    fn mirrored_keypoints_are_those_of_the_other_side() {
        for (place, name) in KEYPOINTS.iter().enumerate() {
            let other = if let Some(rest) = name.strip_prefix("left_") {
                format!("right_{rest}")
            } else if let Some(rest) = name.strip_prefix("right_") {
                format!("left_{rest}")
            } else {
                (*name).to_owned()
            };
            assert_eq!(KEYPOINTS[FLIP_IDX[place]], other);
        }
    }
}
