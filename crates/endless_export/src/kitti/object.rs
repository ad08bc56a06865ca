//! The object benchmark: `training/{image_2,label_2,calib}/000000` and `ImageSets/train.txt`.

use super::{
    calibration::calibration,
    object_label::{KittiLabel, kitti_labels},
};
use crate::{
    ExportError, LabelledFrame, SourceDataset,
    camera::{CameraWay, perspective_only},
    exporter::Exporter,
    frame_list,
    job::{Export, VideoJob},
    pictures::place_png,
};

/// Objects of single pictures.
#[derive(Debug)]
pub(crate) struct KittiObject;

impl Exporter for KittiObject {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        perspective_only("kitti_object", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let (export, target) = (video.export, video.export.target);
        let mut list = video.create_part(frame_list::PART)?;
        for (place, sequence) in video.sequences() {
            let way = CameraWay::read(sequence)?;
            let before = export.frames_before(place);
            let make = |frame: &LabelledFrame<'_>| {
                let number = format!("{:06}", before + frame.place);
                let camera = way.at(sequence, frame.frame)?;
                place_png(video, frame, &format!("training/image_2/{number}.png"))?;
                let lines: String = kitti_labels(frame, &camera, export.classes).iter().map(KittiLabel::line).collect();
                target.write(format!("training/label_2/{number}.txt"), lines.as_bytes())?;
                let text = calibration(&camera, "R0_rect", ["Tr_velo_to_cam", "Tr_imu_to_velo"]);
                target.write(format!("training/calib/{number}.txt"), text.as_bytes())?;
                Ok(frame_list::line(number, frame))
            };
            video.frames(sequence, make, |line| Ok(list.write(line.as_bytes())?))?;
        }
        Ok(list.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("ImageSets/{name}.txt"))?;
            for line in export.lines_of(frame_list::PART, split) {
                let line = line?;
                let number = line.split(',').next().unwrap_or_default();
                file.write(format!("{number}\n").as_bytes())?;
            }
            file.finish()?;
        }
        frame_list::write(export)
    }
}
