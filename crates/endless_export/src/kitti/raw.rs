//! The raw data's layout with its three calibration files: `2026_01_01/2026_01_01_drive_0000_sync/image_02/data`, a drive a camera
//! and video. Here the camera's own frame is kept, tilt and all: `P_rect_02 = K [I | 0]`, and `calib_velo_to_cam.txt` has the tilt.

use super::calibration::{camera_from_sensor, row_major, square};
use crate::{
    ExportError, LabelledFrame, SourceDataset,
    camera::{Camera, CameraWay, perspective_only},
    exporter::Exporter,
    frame_list,
    job::{Export, VideoJob},
    pictures::place_png,
};
use endless_dataset::AtomicFile;
use endless_world::ImageSize;
use glam::{DMat3, DVec3};

/// Pictures, times and calibration.
#[derive(Debug)]
pub(crate) struct KittiRaw;

const DATE: &str = "2026_01_01";
const STAMP: &str = "2026-01-01 12:00:00";

/// Drives differ in their calibration, and KITTI has one a date: so each is a date of its own below its part.
fn folder(split: &str, place: usize) -> String {
    format!("{split}/{place:04}/{DATE}")
}

/// `calib_cam_to_cam.txt`: the four cameras are one.
fn cam_to_cam(camera: &Camera, distortion: &[f64], size: ImageSize) -> String {
    let mut text = format!("calib_time: {STAMP}\ncorner_dist: 0.000000e+00\n");
    let numbers = |list: &[f64]| list.iter().map(|n| format!("{n:.12e}")).collect::<Vec<_>>().join(" ");
    let size = numbers(&[f64::from(size.width), f64::from(size.height)]);
    for number in 0..4 {
        text += &format!("S_{number:02}: {size}\nK_{number:02}: {}\n", square(camera.intrinsics));
        text += &format!("D_{number:02}: {}\n", numbers(distortion));
        text += &format!("R_{number:02}: {}\nT_{number:02}: {}\n", square(DMat3::IDENTITY), numbers(&[0.0; 3]));
        text += &format!("S_rect_{number:02}: {size}\nR_rect_{number:02}: {}\n", square(DMat3::IDENTITY));
        text += &format!("P_rect_{number:02}: {}\n", row_major(camera.intrinsics, DVec3::ZERO));
    }
    text
}

/// A file of one rotation and translation.
fn pose(rotation: DMat3) -> String {
    let zero = "0.000000000000e+00 0.000000000000e+00 0.000000000000e+00";
    format!("calib_time: {STAMP}\nR: {}\nT: {zero}\n", square(rotation))
}

/// Seconds of a day that began at noon, to nanoseconds.
fn stamp(time_s: f64) -> String {
    let nanoseconds = (time_s.max(0.0) * 1e9).round() as u64;
    let seconds = nanoseconds / 1_000_000_000;
    let [hours, minutes] = [12 + seconds / 3600, seconds / 60 % 60];
    format!("2026-01-01 {hours:02}:{minutes:02}:{:02}.{:09}\n", seconds % 60, nanoseconds % 1_000_000_000)
}

impl Exporter for KittiRaw {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        perspective_only("kitti_raw", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let target = video.export.target;
        let mut list = video.create_part(frame_list::PART)?;
        for (place, sequence) in video.sequences() {
            let date = folder(video.split(), place);
            let drive = format!("{date}/{DATE}_drive_{place:04}_sync");
            let first = sequence.frames().next().unwrap_or_default();
            let camera = CameraWay::read(sequence)?.at(sequence, first)?;
            let distortion = &sequence.record.lens.distortion;
            target.write(
                format!("{date}/calib_cam_to_cam.txt"),
                cam_to_cam(&camera, distortion, sequence.output.size).as_bytes(),
            )?;
            let camera_from_level = camera.world_from_camera.transpose() * camera.level_from_world().transpose();
            let velo = pose(camera_from_level * camera_from_sensor());
            target.write(format!("{date}/calib_velo_to_cam.txt"), velo.as_bytes())?;
            target.write(format!("{date}/calib_imu_to_velo.txt"), pose(DMat3::IDENTITY).as_bytes())?;
            // pykitti takes the times of a drive from those of its oxts.
            let mut times = [
                target.create(format!("{drive}/image_02/timestamps.txt"))?,
                target.create(format!("{drive}/oxts/timestamps.txt"))?,
            ];
            let make = |frame: &LabelledFrame<'_>| {
                let name = format!("{drive}/image_02/data/{:010}.png", frame.place);
                place_png(video, frame, &name)?;
                Ok((stamp(frame.time_s), frame_list::line(name, frame)))
            };
            video.frames(sequence, make, |(time, line)| {
                times.iter_mut().try_for_each(|file| file.write(time.as_bytes()))?;
                Ok(list.write(line.as_bytes())?)
            })?;
            times.into_iter().try_for_each(AtomicFile::finish)?;
        }
        Ok(list.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        frame_list::write(export)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_of_the_day() {
        assert_eq!(stamp(0.0), "2026-01-01 12:00:00.000000000\n");
        assert_eq!(stamp(3661.5), "2026-01-01 13:01:01.500000000\n");
        assert_eq!(stamp(1.0 / 30.0), "2026-01-01 12:00:00.033333333\n");
    }
}
