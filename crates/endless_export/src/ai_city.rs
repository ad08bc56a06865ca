//! AI City Challenge, multi-camera tracking: a folder a scene with `calibration.json` and `ground_truth.json` as in 2025, each
//! camera's `gt/gt.txt` as in CityFlow, and `ground_truth_train.txt` with the lines that the evaluation server takes.
//!
//! The world is metres, x east, y north, z up. `gt.txt`: `frame,id,left,top,width,height,1,-1,-1,-1`, frames from 1. The
//! evaluation's lines: `scene class object frame x y z width length height yaw`, frames from 0, the middle of the box.

use crate::{
    ExportError, Label, LabelledFrame, Sequence, SourceDataset,
    camera::{CameraWay, perspective_only, still_only},
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::Layer;
use endless_world::{InstanceId, math::f64::atan2};
use glam::DVec3;
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Objects in the world, of all cameras of a scene.
#[derive(Debug)]
pub(crate) struct AiCity;

const LINES: &str = "ground_truth";

fn calibration(sequence: &Sequence) -> Result<Value, ExportError> {
    let camera = CameraWay::read(sequence)?.at(sequence, sequence.frames().next().unwrap_or_default())?;
    let camera_from_world = camera.world_from_camera.transpose();
    let translation = camera_from_world * -camera.position;
    let extrinsic: Vec<[f64; 4]> = (0..3)
        .map(|i| {
            let r = camera_from_world.row(i);
            [r.x, r.y, r.z, translation[i]]
        })
        .collect();
    let row = |i: usize| camera.intrinsics.row(i).to_array();
    let projected = |i: usize| {
        let row = (camera.intrinsics * camera_from_world).row(i);
        [row.x, row.y, row.z, (camera.intrinsics * translation)[i]]
    };
    let homography = sequence.record.ground_plane.as_ref().map(|plane| json!(plane.homography));
    Ok(json!({
        "type": "camera",
        "id": sequence.camera_name,
        "coordinates": {"x": camera.position.x, "y": camera.position.y, "z": camera.position.z},
        "attributes": [
            {"name": "fps", "value": sequence.fps().to_string()},
            {"name": "frameWidth", "value": sequence.output.size.width.to_string()},
            {"name": "frameHeight", "value": sequence.output.size.height.to_string()},
        ],
        "intrinsicMatrix": [row(0), row(1), row(2)],
        "extrinsicMatrix": extrinsic,
        "cameraMatrix": [projected(0), projected(1), projected(2)],
        "homography": homography,
        "distortion": sequence.record.lens.distortion,
    }))
}

/// An object of an instant, with its box in each camera that sees it.
struct Seen<'f> {
    label: &'f Label,
    boxes: BTreeMap<&'f str, [u32; 4]>,
}

fn seen<'f>(frames: &'f [LabelledFrame<'_>]) -> BTreeMap<InstanceId, Seen<'f>> {
    let mut all: BTreeMap<InstanceId, Seen<'f>> = BTreeMap::new();
    for frame in frames {
        for label in &frame.labels {
            let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox);
            let entry = all.entry(label.object.id).or_insert_with(|| Seen { label, boxes: BTreeMap::new() });
            entry.boxes.insert(&frame.sequence.camera_name, [x, y, x + w, y + h]);
        }
    }
    all
}

/// Heading of a box, radians counter-clockwise from east.
fn yaw([w, x, y, z]: [f64; 4]) -> f64 {
    atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
}

/// What an instant adds to `ground_truth.json` and to the evaluation's lines.
fn instant(frames: &[LabelledFrame<'_>], scene: u32, export: &Export<'_>) -> (String, String) {
    let number = frames.first().map_or(0, |frame| frame.frame);
    let (mut entries, mut lines) = (Vec::new(), String::new());
    for (id, Seen { label, boxes }) in seen(frames) {
        let Some(box3d) = label.object.spatial.as_ref().map(|spatial| &spatial.box3d) else { continue };
        let [length, width, height] = box3d.size;
        let (center, yaw) = (DVec3::from(box3d.center), yaw(box3d.rotation));
        entries.push(json!({
            "object type": export.classes.classes[label.class].name,
            "object id": id,
            "3d location": center.to_array(),
            "3d bounding box scale": [width, length, height],
            "3d bounding box rotation": [0.0, 0.0, yaw],
            "2d bounding box visible": boxes,
        }));
        lines += &format!(
            "{scene} {} {id} {number} {:.3} {:.3} {:.3} {width:.3} {length:.3} {height:.3} {yaw:.5}\n",
            label.class, center.x, center.y, center.z
        );
    }
    (format!("\"{number}\": {}", Value::Array(entries)), lines)
}

impl Exporter for AiCity {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        perspective_only("ai_city", dataset)?;
        still_only("ai_city", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let (export, target) = (video.export, video.export.target);
        let sequences: Vec<&Sequence> = video.sequences().map(|(_, sequence)| sequence).collect();
        let (scene, name) = (sequences[0].video.video, &sequences[0].video.name);
        let folder = format!("{}/{name}", video.split());
        let sensors = sequences.iter().map(|s| calibration(s)).collect::<Result<Vec<_>, _>>()?;
        let calibration = json!({"calibrationType": "cartesian", "sensors": sensors});
        target.write(format!("{folder}/calibration.json"), format!("{calibration:#}\n").as_bytes())?;
        let mut tracks = Vec::new();
        for sequence in &sequences {
            let mp4 = sequence.files.mp4(Layer::Rgb);
            if mp4.is_file() {
                let placed = target.path(format!("{folder}/videos/{}.mp4", sequence.camera_name))?;
                export.placing.place(&mp4, &placed)?;
            }
            tracks.push(target.create(format!("{folder}/{}/gt/gt.txt", sequence.camera_name))?);
        }
        let mut truth = target.create(format!("{folder}/ground_truth.json"))?;
        let mut lines = video.create_part(LINES)?;
        truth.write(b"{\n")?;
        let make = |frames: &[LabelledFrame<'_>]| {
            let boxes = |frame: &LabelledFrame<'_>| {
                let line = |label: &Label| {
                    let [x, y, w, h] = <[u32; 4]>::from(label.object.bbox);
                    format!("{},{},{x},{y},{w},{h},1,-1,-1,-1\n", frame.place + 1, label.object.id)
                };
                let camera = sequences.iter().position(|s| s.camera_name == frame.sequence.camera_name).unwrap_or(0);
                (camera, frame.labels.iter().map(line).collect::<String>())
            };
            Ok((instant(frames, scene, export), frames.iter().map(boxes).collect::<Vec<_>>()))
        };
        let mut first = true;
        video.instants(&sequences, make, |((entry, evaluated), boxes)| {
            let comma = if std::mem::take(&mut first) { "" } else { ",\n" };
            truth.write(format!("{comma}{entry}").as_bytes())?;
            lines.write(evaluated.as_bytes())?;
            boxes.into_iter().try_for_each(|(camera, text)| Ok(tracks[camera].write(text.as_bytes())?))
        })?;
        truth.write(b"\n}\n")?;
        truth.finish()?;
        for track in tracks {
            track.finish()?;
        }
        Ok(lines.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("ground_truth_{name}.txt"))?;
            for line in export.lines_of(LINES, split) {
                file.write((line? + "\n").as_bytes())?;
            }
            file.finish()?;
        }
        let classes: String = export
            .classes
            .classes
            .iter()
            .enumerate()
            .map(|(number, class)| format!("{number} {}\n", class.name))
            .collect();
        export.target.write("classes.txt", classes.as_bytes())
    }
}
