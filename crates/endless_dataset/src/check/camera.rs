//! One camera of a video: every file decodes, sizes, counts, alignment, boxes.

use super::{
    agreement::disagreements,
    camera_way::CameraWay,
    map::check_map,
    objects::LabelledFrame,
    progress::CheckProgress,
    report::{CheckReport, Finding},
    tracks::Tracks,
    unexpected_files::unexpected_files,
};
use crate::{
    CameraLayout, CameraOutput, CameraRecord, DatasetError, Layer, Recipe, StoredImage, depth_from_rgb,
    instance_from_rgb, read_json, read_mp4, read_objects, read_rgb, video,
};
use endless_annotate::{FrameObjects, Keypoint, ObjectRecord, Visibility, visible_objects};
use endless_world::{
    ClassTag, FAR_PLANE_M, Image, InstanceId, InstancePixel, KEYPOINTS, PinholeCamera, SceneCamera, SceneSettings,
};
use rayon::prelude::*;
use rusty_h264_decoder::Decoder;
use std::collections::{BTreeMap, BTreeSet};

/// A camera whose files are checked.
pub(super) struct CheckedCamera<'a> {
    pub(super) files: &'a CameraLayout,
    /// What is stored of it.
    pub(super) output: &'a CameraOutput,
    /// Names of its files besides layers, videos and labels.
    pub(super) records: &'a [&'a str],
    /// The camera at a frame; `None` where nothing tells it.
    pub(super) lens: &'a (dyn Fn(u32) -> Option<PinholeCamera> + Sync),
}

/// What a camera's files show.
pub(super) struct CameraCheck {
    pub(super) report: CheckReport,
    pub(super) tracks: Tracks,
}

/// A camera of the scene: its records, and all that is stored of it.
pub(super) fn check_scene_camera(
    files: &CameraLayout,
    settings: &SceneSettings,
    camera: usize,
    recipe: &Recipe,
    progress: &CheckProgress<'_>,
) -> CameraCheck {
    let SceneCamera { site, look } = &settings.cameras[camera];
    let lens = PinholeCamera::new(site, settings.size).with_distortion(look.distortion);
    let output = recipe.camera_output();
    let lens = |_frame| Some(lens.clone());
    let checked = CheckedCamera { files, output: &output, records: &["map.json"], lens: &lens };
    let mut check = check_camera(&checked, progress);
    let record = CameraRecord::new(site, look.distortion, settings.size, settings.fps);
    check.report.findings.extend(check_record(files, record));
    check.report.findings.extend(check_map(files, &settings.cameras[camera], settings.size));
    check
}

/// All that is stored of a camera.
pub(super) fn check_camera(checked: &CheckedCamera<'_>, progress: &CheckProgress<'_>) -> CameraCheck {
    let CheckedCamera { files, output, lens, .. } = *checked;
    let mut report = CheckReport::default();
    report.findings.extend(check_names(checked));
    let lines = read_objects(&files.objects()).unwrap_or_else(|e| {
        report.findings.push(e.into());
        Vec::new()
    });
    if lines.len() != output.count() as usize {
        let problem = format!("has {} lines for {} frames", lines.len(), output.count());
        report.findings.push(Finding::new(files.objects(), problem));
    }
    let mut tracks = Tracks::default();
    for object in lines.iter().flat_map(|l| &l.objects) {
        tracks.add(object.id, object.class);
        report.boxes += 1;
    }
    let numbers: Vec<(usize, u32)> = output.frames().enumerate().collect();
    let frames: Vec<CheckReport> = numbers
        .into_par_iter()
        .map(|(place, frame)| {
            let report = match lens(frame) {
                Some(camera) => {
                    let [before, after] = [frame.checked_sub(1), frame.checked_add(1)].map(|other| lens(other?));
                    let way = CameraWay { before, now: camera, after };
                    check_frame(files, frame, lines.get(place), output, &way)
                }
                None => CheckReport::default(),
            };
            progress.add(1);
            report
        })
        .collect();
    for frame in frames {
        report.merge(frame);
    }
    let mp4 = |layer: &Layer| {
        let finding = check_mp4(files, *layer, output);
        progress.add(output.count().into());
        finding
    };
    let videos: Vec<Finding> = output.mp4.par_iter().filter_map(mp4).collect();
    report.findings.extend(videos);
    CameraCheck { report, tracks }
}

/// Whether `camera.json` is what it should be. Its ground plane, if it has one, is taken as it is.
pub(super) fn check_record(files: &CameraLayout, expected: CameraRecord) -> Option<Finding> {
    match read_json::<CameraRecord>(&files.camera()) {
        Ok(record) if same_camera(&record, expected) => None,
        Ok(_) => Some(Finding::new(files.camera(), "does not describe the camera of the scene")),
        Err(e) => Some(e.into()),
    }
}

/// Whether a record is that of this camera, and its ground plane, if it has one, is seen so by it. Numbers in the file are
/// as short as they can be, and read as they were.
fn same_camera(record: &CameraRecord, expected: CameraRecord) -> bool {
    *record == expected.with_ground(record.ground_plane.as_ref().map(|plane| plane.z_m))
}

fn check_names(checked: &CheckedCamera<'_>) -> Vec<Finding> {
    let CheckedCamera { files, output, records, .. } = *checked;
    let mut expected = BTreeSet::from(["camera.json".to_owned(), "objects.jsonl".to_owned()]);
    expected.extend(records.iter().filter(|name| files.folder().join(name).is_file()).map(ToString::to_string));
    expected.extend(output.layers.iter().map(Layer::to_string));
    expected.extend(output.mp4.iter().map(|l| format!("{l}.mp4")));
    let mut findings = unexpected_files(files.folder(), &expected);
    for &layer in &output.layers {
        let extension = layer.format(output.rgb_format);
        let frames: BTreeSet<String> = output.frames().map(|f| format!("{f:06}.{extension}")).collect();
        findings.extend(unexpected_files(&files.layer(layer), &frames));
    }
    findings
}

fn check_frame(
    layout: &CameraLayout,
    frame: u32,
    line: Option<&FrameObjects>,
    output: &CameraOutput,
    way: &CameraWay,
) -> CheckReport {
    let camera = &way.now;
    let mut report = CheckReport::default();
    // The layers that decode.
    let mut stored: BTreeMap<Layer, StoredImage<'_>> = BTreeMap::new();
    for &layer in &output.layers {
        match read_layer(layout, layer, frame, output) {
            Ok(image) => {
                report.images += 1;
                stored.insert(layer, image);
            }
            Err(error) => report.findings.push(error.into()),
        }
    }
    let eight = |layer: Layer| stored.get(&layer)?.rgb8().ok();
    let depth = eight(Layer::Depth).map(depth_from_rgb);
    let instance = eight(Layer::Instance).and_then(|image| instance_from_rgb(image).ok());
    if let (Some(depth), Some(instance)) = (&depth, &instance) {
        let path = layout.frame(Layer::Depth, frame, output.rgb_format);
        report.findings.extend(misaligned(depth, instance).map(|problem| Finding::new(path, problem)));
    }
    if let Some(instance) = &instance {
        let wrong_flow = way.wrong_flow(&stored, instance, depth.as_ref());
        let problems = disagreements(&stored, instance, way.stands()).chain(wrong_flow);
        report.findings.extend(
            problems.map(|(layer, problem)| Finding::new(layout.frame(layer, frame, output.rgb_format), problem)),
        );
    }
    if let Some(line) = line {
        let labelled = LabelledFrame { camera, instance: instance.as_ref(), depth: depth.as_ref() };
        let mut problems = line_problems(line, frame, &labelled, output);
        let wrong =
            |object: &ObjectRecord| Some(format!("frame {frame}: object {} {}", object.id, labelled.problem(object)?));
        problems.extend(line.objects.iter().filter_map(wrong));
        report.findings.extend(problems.into_iter().map(|problem| Finding::new(layout.objects(), problem)));
    }
    report
}

fn read_layer(
    layout: &CameraLayout,
    layer: Layer,
    frame: u32,
    output: &CameraOutput,
) -> Result<StoredImage<'static>, DatasetError> {
    let path = layout.frame(layer, frame, output.rgb_format);
    let image = read_rgb(&path, layer.format(output.rgb_format))?;
    if image.size() != output.size {
        return Err(DatasetError::malformed(path, format!("is {} instead of {}", image.size(), output.size)));
    }
    match (layer.entry().check)(&image) {
        Ok(()) => Ok(image),
        Err(reason) => Err(DatasetError::malformed(path, reason)),
    }
}

/// The sky and what a lens does not show, and nothing that the instance image shows as an object, lie on the far plane.
fn misaligned(depth: &Image<f32>, instance: &Image<InstancePixel>) -> Option<String> {
    let pairs = || depth.data.iter().zip(&instance.data);
    let near_sky =
        pairs().filter(|(d, p)| [ClassTag::Sky, ClassTag::Unlabeled].contains(&p.tag) && **d < FAR_PLANE_M).count();
    let far_objects = pairs().filter(|(d, p)| p.id != InstanceId::STUFF && **d >= FAR_PLANE_M).count();
    let count = near_sky + far_objects;
    (count > 0).then(|| format!("is not aligned with the instance image: {count} pixels of sky or objects disagree"))
}

fn line_problems(line: &FrameObjects, frame: u32, labelled: &LabelledFrame<'_>, output: &CameraOutput) -> Vec<String> {
    let instance = labelled.instance;
    let mut problems = Vec::new();
    if line.frame != frame || (line.time_s - f64::from(frame) / output.scene_fps).abs() > 1e-6 {
        problems.push(format!("line {} is of frame {} at {} s", frame + 1, line.frame, line.time_s));
    }
    problems.extend(line.objects.iter().filter_map(|object| keypoint_problem(object, frame, instance, output)));
    let Some(instance) = instance else { return problems };
    let seen: Vec<_> = visible_objects(instance).into_iter().filter(|v| v.pixels >= output.min_pixels).collect();
    let seen: Vec<_> = seen.iter().map(|v| (v.id, v.tag, v.bbox, v.pixels)).collect();
    let written: Vec<_> = line.objects.iter().map(|o| (o.id, o.class.tag(), o.bbox, o.pixels)).collect();
    if written != seen {
        let odd = written.iter().find(|o| !seen.contains(o)).or(seen.iter().find(|o| !written.contains(o)));
        let odd = odd.map(|o| format!(", first at object {}", o.0)).unwrap_or_default();
        problems.push(format!(
            "frame {frame}: {} boxes differ from the {} of the instance image{odd}",
            written.len(),
            seen.len()
        ));
    }
    problems
}

/// Keypoints lie in the picture, are counted, and those to be seen lie on pixels of who has them.
fn keypoint_problem(
    object: &ObjectRecord,
    frame: u32,
    instance: Option<&Image<InstancePixel>>,
    output: &CameraOutput,
) -> Option<String> {
    let who = format!("frame {frame}: object {}", object.id);
    let Some(keypoints) = &object.keypoints else {
        return object.num_keypoints.map(|n| format!("{who} has {n} keypoints and none is listed"));
    };
    if object.num_keypoints != Some(keypoints.labelled()) {
        return Some(format!("{who} lists {} keypoints and says {:?}", keypoints.labelled(), object.num_keypoints));
    }
    let (width, height) = (output.size.width, output.size.height);
    let own = |image: &Image<InstancePixel>, k: &Keypoint| {
        k.pixels_around(image.size).any(|[x, y]| image.at(x, y).id == object.id)
    };
    let wrong = |k: &Keypoint| match k.visibility {
        Visibility::Outside => k.x != 0.0 || k.y != 0.0,
        _ if !(0.0..=f64::from(width)).contains(&k.x) || !(0.0..=f64::from(height)).contains(&k.y) => true,
        Visibility::Hidden => false,
        Visibility::Visible => instance.is_some_and(|image| !own(image, k)),
    };
    let place = keypoints.0.iter().position(wrong)?;
    Some(format!("{who} does not show its {}", KEYPOINTS[place]))
}

fn check_mp4(layout: &CameraLayout, layer: Layer, output: &CameraOutput) -> Option<Finding> {
    let path = layout.mp4(layer);
    let mp4 = match read_mp4(&path) {
        Ok(mp4) => mp4,
        Err(e) => return Some(e.into()),
    };
    let problem = |text: String| Some(Finding::new(&path, text));
    if mp4.samples() != output.count() as usize {
        return problem(format!("has {} frames instead of {}", mp4.samples(), output.count()));
    }
    let size = video::even(output.size);
    if mp4.size != size {
        return problem(format!("is {} instead of {size}", mp4.size));
    }
    let mut decoder = Decoder::new();
    for i in 0..mp4.samples() {
        let decoded = mp4.access_unit(i).and_then(|unit| decoder.decode(&unit).ok().flatten());
        if decoded.is_none_or(|p| (p.width, p.height) != (size.width as usize, size.height as usize)) {
            return problem(format!("frame {i} does not decode"));
        }
    }
    None
}
