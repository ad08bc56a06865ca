//! The sensors of a rig: their records and poses, and all that is stored of them.

use super::{
    camera::{CameraCheck, CheckedCamera, check_camera, check_record},
    progress::CheckProgress,
    report::Finding,
    sensor_files::check_sensor_files,
    tracks::Tracks,
};
use crate::{
    CameraLayout, CameraRecord, CameraSpec, ModelSpec, PoseLine, Recipe, SensorRecord, SensorSpec, VideoLayout,
    read_json, read_lines,
};
use endless_world::{Lens, PinholeCamera, RigCamera, SceneSensor, SceneSettings, SensorModel};
use std::collections::BTreeMap;

/// Largest difference of a position from where its sensor should be, metres, and of an orientation, radians.
const MOST_OFF: f64 = 1e-6;

/// One sensor.
pub(super) fn check_sensor(
    video: &VideoLayout,
    settings: &SceneSettings,
    recipe: &Recipe,
    place: usize,
    progress: &CheckProgress<'_>,
) -> CameraCheck {
    let (sensor, spec) = (&settings.sensors[place], &recipe.sensor[place]);
    let files = video.sensor(&sensor.name);
    let lines = read_lines::<PoseLine>(&files.poses());
    let findings = [lines.as_ref().err().map(|e| Finding::new(files.poses(), e.to_string()))];
    let lines = lines.unwrap_or_default();
    let mut check = match (&sensor.model, &spec.model) {
        (SensorModel::Camera(camera), ModelSpec::Camera(asked)) => {
            let rig_camera = RigCameraFiles { files: &files, sensor, camera, spec, asked };
            rig_camera.check(recipe, &lines, progress)
        }
        _ => {
            let frames: Vec<u32> = (0..settings.frames).step_by(sensor.every.max(1) as usize).collect();
            let report = check_sensor_files(&files, &spec.model, &frames, progress);
            CameraCheck { report, tracks: Tracks::default() }
        }
    };
    check.report.findings.extend(findings.into_iter().flatten());
    check.report.findings.extend(wrong_sensor(&files, sensor, settings.fps));
    check.report.findings.extend(wrong_poses(&files, sensor, settings, &lines));
    check
}

/// A camera of a rig.
struct RigCameraFiles<'a> {
    files: &'a CameraLayout,
    sensor: &'a SceneSensor,
    camera: &'a RigCamera,
    spec: &'a SensorSpec,
    asked: &'a CameraSpec,
}

impl RigCameraFiles<'_> {
    fn check(&self, recipe: &Recipe, lines: &[PoseLine], progress: &CheckProgress<'_>) -> CameraCheck {
        let Self { files, sensor, camera, spec, asked } = *self;
        let output = recipe.rig_camera_output(spec, asked);
        let distortion = camera.look.distortion;
        let fixed = sensor.fixed_camera();
        let lens_of = |line: &PoseLine| match &fixed {
            Some(fixed) => Some(PinholeCamera::new(&fixed.site, output.size).with_distortion(distortion)),
            None => {
                let fov_rad = sensor.mount.fov_at(line.time_s).unwrap_or(camera.horizontal_fov_rad);
                let lens = camera.lens.lens(fov_rad as f32);
                Some(PinholeCamera { lens, ..line.camera(output.size)? }.with_distortion(distortion))
            }
        };
        let lenses: BTreeMap<u32, PinholeCamera> =
            lines.iter().filter_map(|line| Some((line.frame, lens_of(line)?))).collect();
        let lens = |frame| lenses.get(&frame).cloned();
        let records = ["sensor.json", "poses.jsonl"];
        let mut check =
            check_camera(&CheckedCamera { files, output: &output, records: &records, lens: &lens }, progress);
        let expected = match &fixed {
            Some(fixed) => CameraRecord::new(&fixed.site, distortion, output.size, output.fps()),
            None => {
                let fov_rad = camera.horizontal_fov_rad as f32;
                CameraRecord::moving(camera.lens, fov_rad, distortion, output.size, output.fps())
            }
        };
        check.report.findings.extend(check_record(files, expected));
        let told = |line: &PoseLine| {
            let wanted = PinholeCamera { lens: Lens::PINHOLE, ..lens_of(line)? };
            (line.camera(output.size) != Some(wanted)).then_some(line.frame)
        };
        if let Some(frame) = lines.iter().find_map(told) {
            let problem = format!("frame {frame}: does not tell the camera of the scene");
            check.report.findings.push(Finding::new(files.poses(), problem));
        }
        check
    }
}

fn wrong_sensor(files: &CameraLayout, sensor: &SceneSensor, scene_fps: f64) -> Option<Finding> {
    let record: SensorRecord = match read_json(&files.sensor()) {
        Ok(record) => record,
        Err(error) => return Some(error.into()),
    };
    let expected = SensorRecord::new(sensor, scene_fps, record.carrier_id);
    let carried = sensor.mount.carrier().is_some();
    let right = record == expected && carried == record.carrier_id.is_some();
    (!right).then(|| Finding::new(files.sensor(), "does not describe the sensor of the scene"))
}

/// There is a line for each frame at which it measures, and those that go their own way are where they should be.
fn wrong_poses(
    files: &CameraLayout,
    sensor: &SceneSensor,
    settings: &SceneSettings,
    lines: &[PoseLine],
) -> Option<Finding> {
    let frames = || (0..settings.frames).step_by(sensor.every.max(1) as usize);
    let problem = |text: String| Some(Finding::new(files.poses(), text));
    if lines.len() != frames().len() {
        return problem(format!("has {} lines for {} frames", lines.len(), frames().len()));
    }
    for (line, frame) in lines.iter().zip(frames()) {
        let time_s = f64::from(frame) / settings.fps;
        if line.frame != frame || (line.time_s - time_s).abs() > 1e-6 {
            return problem(format!("frame {frame}: a line of frame {} at {} s", line.frame, line.time_s));
        }
        let pose = line.pose();
        if (pose.world_from_sensor.length() - 1.0).abs() > MOST_OFF {
            return problem(format!("frame {frame}: the quaternion has no unit length"));
        }
        let Some(expected) = sensor.mount.pose_at(line.time_s) else { continue };
        let turned = 1.0 - expected.world_from_sensor.dot(pose.world_from_sensor).abs();
        if expected.position.distance(pose.position) > MOST_OFF || turned > MOST_OFF {
            return problem(format!("frame {frame}: the sensor is not where it should be"));
        }
    }
    None
}
