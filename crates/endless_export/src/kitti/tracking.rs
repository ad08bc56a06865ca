//! The tracking benchmark: `training/{image_02/0000/000000.png,label_02/0000.txt,calib/0000.txt}`, a number a camera and video.

use super::{calibration::calibration, object_label::kitti_labels};
use crate::{
    ExportError, LabelledFrame, Sequence, SourceDataset,
    camera::{CameraWay, perspective_only, still_only},
    exporter::Exporter,
    frame_list,
    job::{Export, VideoJob},
    pictures::place_png,
};

/// Objects with tracks.
#[derive(Debug)]
pub(crate) struct KittiTracking;

impl Exporter for KittiTracking {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        perspective_only("kitti_tracking", dataset)?;
        still_only("kitti_tracking", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let (export, target) = (video.export, video.export.target);
        let mut list = video.create_part(frame_list::PART)?;
        for (place, sequence) in video.sequences() {
            let camera = CameraWay::read(sequence)?.at(sequence, 0)?;
            let text = calibration(&camera, "R_rect", ["Tr_velo_cam", "Tr_imu_velo"]);
            target.write(format!("training/calib/{place:04}.txt"), text.as_bytes())?;
            let mut labels = target.create(format!("training/label_02/{place:04}.txt"))?;
            let make = |frame: &LabelledFrame<'_>| {
                let name = format!("{place:04}/{:06}", frame.place);
                place_png(video, frame, &format!("training/image_02/{name}.png"))?;
                let found = kitti_labels(frame, &camera, export.classes);
                let lines: String = found.iter().map(|label| label.tracking_line(frame.place)).collect();
                Ok((lines, frame_list::line(name, frame)))
            };
            video.frames(sequence, make, |(lines, line)| {
                labels.write(lines.as_bytes())?;
                Ok(list.write(line.as_bytes())?)
            })?;
            labels.finish()?;
        }
        Ok(list.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let row =
                |(place, sequence): (usize, &Sequence)| format!("{place:04} empty 000000 {:06}\n", sequence.len());
            let text: String =
                export.videos_of(split).flat_map(|video| video.sequences().map(row).collect::<Vec<_>>()).collect();
            export.target.write(format!("training/evaluate_tracking.seqmap.{name}"), text.as_bytes())?;
        }
        frame_list::write(export)
    }
}
