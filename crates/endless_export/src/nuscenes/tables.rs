//! The tables, row by row.

use super::{
    annotation::{ATTRIBUTES, CATEGORIES, attribute, box_in_world, category, visibility_level},
    token::token,
};
use crate::{
    ExportError, Label, LabelledFrame, Sequence, SourceDataset,
    camera::{CameraWay, perspective_only, quaternion},
    exporter::Exporter,
    job::{Export, VideoJob},
    png::encode_grey8,
};
use endless_annotate::ActorRecord;
use endless_dataset::{AtomicFile, Layer, read_actors};
use endless_world::{Image, ImageSize, InstanceId};
use glam::{DMat3, DVec3};
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// All tables.
#[derive(Debug)]
pub(crate) struct NuScenes;

/// Folder of the tables: the devkit's `version`.
const VERSION: &str = "v1.0-endless";
/// Tables that come of videos.
const ROWS: [&str; 8] =
    ["scene", "sample", "sample_data", "ego_pose", "calibrated_sensor", "sample_annotation", "instance", "log"];
/// Microseconds at which videos begin: one after another, an hour apart.
const FIRST_US: u64 = 1_500_000_000_000_000;
const APART_US: u64 = 3_600_000_000;

/// `CAM_A` of `camera_a`.
fn channel(sequence: &Sequence) -> String {
    let name = sequence.camera_name.strip_prefix("camera_").unwrap_or(&sequence.camera_name);
    format!("CAM_{}", name.to_uppercase())
}

/// From the body of a camera (x ahead, y left, z up) to the camera.
fn camera_from_body() -> DMat3 {
    DMat3::from_cols(DVec3::Z, DVec3::NEG_X, DVec3::NEG_Y)
}

/// The token of an instant of a video.
fn sample_token(video: &str, frame: u32) -> String {
    token("sample", &[video, &frame.to_string()])
}

/// The rows of a video.
struct Rows<'v> {
    name: &'v str,
    actors: BTreeMap<InstanceId, ActorRecord>,
    /// The last annotation of each object, which waits for the next one.
    last: BTreeMap<InstanceId, Value>,
    counts: BTreeMap<InstanceId, (String, String, u32)>,
    parts: BTreeMap<&'static str, AtomicFile>,
}

/// An object of a sample.
struct Seen {
    label: Label,
    /// Visible pixels in all cameras, and the largest share of it that one of them sees.
    pixels: u32,
    visibility: f64,
}

/// What an instant has.
struct Instant {
    frame: u32,
    time_s: f64,
    /// Rows of `sample_data` and `ego_pose`.
    data: Vec<[Value; 2]>,
    seen: Vec<Seen>,
}

impl Rows<'_> {
    fn put(&mut self, table: &'static str, row: &Value) -> Result<(), ExportError> {
        let part = self.parts.get_mut(table).expect("a part a table");
        Ok(part.write((row.to_string() + "\n").as_bytes())?)
    }

    fn annotate(&mut self, frame: u32, seen: &Seen) -> Result<(), ExportError> {
        let Some(box3d) = box_in_world(&seen.label) else { return Ok(()) };
        let object = &seen.label.object;
        let id = object.id.to_string();
        let own = token("sample_annotation", &[self.name, &id, &frame.to_string()]);
        let instance = token("instance", &[self.name, &id]);
        let mut before = json!("");
        if let Some(mut row) = self.last.remove(&object.id) {
            row["next"] = json!(own);
            self.put("sample_annotation", &row)?;
            before = row["token"].take();
        }
        let [length, width, height] = box3d.size;
        let row = json!({
            "token": own, "sample_token": sample_token(self.name, frame), "instance_token": instance,
            "visibility_token": visibility_level(seen.visibility),
            "attribute_tokens": [token("attribute", &[attribute(&seen.label)])],
            "translation": box3d.center, "size": [width, length, height], "rotation": box3d.rotation,
            "prev": before, "next": "",
            "num_lidar_pts": seen.pixels, "num_radar_pts": 0,
        });
        let entry = self.counts.entry(object.id).or_insert_with(|| (own.clone(), own.clone(), 0));
        entry.1 = own;
        entry.2 += 1;
        self.last.insert(object.id, row);
        Ok(())
    }

    /// The rows that need all frames.
    fn finish(&mut self, first: &LabelledObjects) -> Result<(), ExportError> {
        for row in std::mem::take(&mut self.last).values() {
            self.put("sample_annotation", row)?;
        }
        for (id, (begin, end, count)) in std::mem::take(&mut self.counts) {
            let category = first.categories.get(&id).copied().unwrap_or(CATEGORIES[0]);
            let row = json!({
                "token": token("instance", &[self.name, &id.to_string()]),
                "category_token": token("category", &[category]),
                "nbr_annotations": count, "first_annotation_token": begin, "last_annotation_token": end,
            });
            self.put("instance", &row)?;
        }
        Ok(())
    }
}

/// The category of each object.
#[derive(Default)]
struct LabelledObjects {
    categories: BTreeMap<InstanceId, &'static str>,
}

/// The objects of an instant. Riders are part of what they ride.
fn seen(frames: &[LabelledFrame<'_>]) -> Vec<Seen> {
    let mut all: BTreeMap<InstanceId, Seen> = BTreeMap::new();
    for label in frames.iter().flat_map(|frame| &frame.labels) {
        let both = label.object.with_rider.as_ref().map_or(label.object.pixels, |both| both.pixels);
        let visibility = label.visibility();
        let entry =
            all.entry(label.object.id).or_insert_with(|| Seen { label: label.clone(), pixels: 0, visibility: 0.0 });
        entry.pixels += both;
        if label.object.with_rider.is_some() && entry.label.object.with_rider.is_none() {
            entry.label = label.clone();
        }
        entry.visibility = entry.visibility.max(visibility);
    }
    let ridden: BTreeSet<InstanceId> =
        all.values().filter(|seen| seen.label.object.with_rider.is_some()).map(|seen| seen.label.object.id).collect();
    let carried = |seen: &Seen| seen.label.object.vehicle_id.is_some_and(|vehicle| ridden.contains(&vehicle));
    all.into_values().filter(|seen| !carried(seen)).collect()
}

impl Exporter for NuScenes {
    fn fits(&self, dataset: &SourceDataset) -> Result<(), ExportError> {
        perspective_only("nuscenes", dataset)
    }

    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let export = video.export;
        let sequences: Vec<&Sequence> = video.sequences().map(|(_, sequence)| sequence).collect();
        let entry = &sequences[0].video;
        let name = entry.name.as_str();
        let begin_us = FIRST_US + u64::from(entry.video) * APART_US;
        let time_us = |time_s: f64| begin_us + (time_s * 1e6).round() as u64;
        let path = export.dataset.layout.video_named(name).actors();
        let actors = if path.is_file() { read_actors(&path)? } else { Vec::new() };
        let mut rows = Rows {
            name,
            actors: actors.into_iter().map(|actor| (actor.id, actor)).collect(),
            last: BTreeMap::new(),
            counts: BTreeMap::new(),
            parts: ROWS
                .into_iter()
                .map(|table| Ok((table, video.create_part(table)?)))
                .collect::<Result<_, ExportError>>()?,
        };
        let ways = sequences.iter().map(|s| CameraWay::read(s)).collect::<Result<Vec<_>, _>>()?;
        for (sequence, way) in sequences.iter().zip(&ways) {
            let first = way.at(sequence, sequence.frames().next().unwrap_or_default())?;
            let (translation, rotation) = match way {
                CameraWay::Still(camera) => (camera.position, camera.world_from_camera),
                CameraWay::Moving(_) => (DVec3::ZERO, camera_from_body().transpose()),
            };
            let row = |i: usize| first.intrinsics.row(i).to_array();
            let channel = channel(sequence);
            rows.put("calibrated_sensor", &json!({
                "token": token("calibrated_sensor", &[name, &channel]), "sensor_token": token("sensor", &[&channel]),
                "translation": translation.to_array(), "rotation": quaternion(rotation),
                "camera_intrinsic": [row(0), row(1), row(2)],
            }))?;
        }
        let make = |frames: &[LabelledFrame<'_>]| {
            let mut data = Vec::new();
            for frame in frames {
                let sequence = frame.sequence;
                let channel = channel(sequence);
                let below = format!("samples/{channel}/{}.{}", frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &below)?;
                let place = sequences.iter().position(|s| s.camera_name == sequence.camera_name).unwrap_or(0);
                let (translation, rotation) = match &ways[place] {
                    CameraWay::Still(_) => (DVec3::ZERO, DMat3::IDENTITY),
                    CameraWay::Moving(_) => {
                        let camera = ways[place].at(sequence, frame.frame)?;
                        (camera.position, camera.world_from_camera * camera_from_body())
                    }
                };
                let own = |frame: u32| token("sample_data", &[name, &channel, &frame.to_string()]);
                let step = sequence.output.every * sequence.stride.max(1);
                let before = if frame.place > 0 { own(frame.frame - step) } else { String::new() };
                let after = if frame.place + 1 < sequence.len() { own(frame.frame + step) } else { String::new() };
                let pose = token("ego_pose", &[name, &channel, &frame.frame.to_string()]);
                data.push([
                    json!({
                        "token": own(frame.frame), "sample_token": sample_token(name, frame.frame),
                        "ego_pose_token": pose, "calibrated_sensor_token": token("calibrated_sensor", &[name, &channel]),
                        "timestamp": time_us(frame.time_s), "fileformat": sequence.extension(Layer::Rgb),
                        "is_key_frame": true, "height": sequence.output.size.height, "width": sequence.output.size.width,
                        "filename": below, "prev": before, "next": after,
                    }),
                    json!({
                        "token": pose, "timestamp": time_us(frame.time_s), "rotation": quaternion(rotation),
                        "translation": translation.to_array(),
                    }),
                ]);
            }
            let (frame, time_s) = frames.first().map_or((0, 0.0), |frame| (frame.frame, frame.time_s));
            Ok(Instant { frame, time_s, data, seen: seen(frames) })
        };
        let mut objects = LabelledObjects::default();
        let mut samples: Vec<(u32, f64)> = Vec::new();
        video.instants(&sequences, make, |instant| {
            for [data, pose] in &instant.data {
                rows.put("sample_data", data)?;
                rows.put("ego_pose", pose)?;
            }
            for seen in &instant.seen {
                let id = seen.label.object.id;
                objects.categories.entry(id).or_insert_with(|| category(&seen.label, rows.actors.get(&id)));
                rows.annotate(instant.frame, seen)?;
            }
            samples.push((instant.frame, instant.time_s));
            Ok(())
        })?;
        rows.finish(&objects)?;
        let scene = token("scene", &[name]);
        let at = |place: Option<usize>| {
            place.and_then(|place| samples.get(place)).map_or_else(String::new, |(frame, _)| sample_token(name, *frame))
        };
        let (begin, end) = (at(Some(0)), at(samples.len().checked_sub(1)));
        for (place, (frame, time_s)) in samples.iter().enumerate() {
            let row = json!({
                "token": sample_token(name, *frame), "timestamp": time_us(*time_s), "scene_token": scene,
                "prev": at(place.checked_sub(1)), "next": at(place.checked_add(1)),
            });
            rows.put("sample", &row)?;
        }
        let log = token("log", &[name]);
        rows.put(
            "scene",
            &json!({
                "token": scene, "log_token": log, "nbr_samples": samples.len(), "first_sample_token": begin,
                "last_sample_token": end, "name": format!("scene-{:04}", entry.video),
                "description": format!("{}, {}, {}", entry.map, entry.weather, entry.time_of_day),
            }),
        )?;
        rows.put(
            "log",
            &json!({
                "token": log, "logfile": name, "vehicle": "surveillance cameras", "date_captured": "2017-07-14",
                "location": entry.map,
            }),
        )?;
        rows.parts.into_values().try_for_each(|part| Ok(part.finish()?))
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for table in ROWS {
            let mut file = export.target.create(format!("{VERSION}/{table}.json"))?;
            file.write(b"[\n")?;
            let mut first = true;
            for split in 0..export.splits.len() {
                for line in export.lines_of(table, split) {
                    let comma = if std::mem::take(&mut first) { "" } else { ",\n" };
                    file.write(format!("{comma}{}", line?).as_bytes())?;
                }
            }
            file.write(b"\n]\n")?;
            file.finish()?;
        }
        let write = |name: &str, rows: Vec<Value>| {
            export.target.write(format!("{VERSION}/{name}.json"), format!("{:#}\n", Value::Array(rows)).as_bytes())
        };
        let named =
            |table: &str, name: &&str| json!({"token": token(table, &[name]), "name": name, "description": name});
        write("category", CATEGORIES.iter().map(|name| named("category", name)).collect())?;
        write("attribute", ATTRIBUTES.iter().map(|name| named("attribute", name)).collect())?;
        let level = |(token, level): (&str, &str)| json!({"token": token, "level": level, "description": level});
        let levels = [("1", "v0-40"), ("2", "v40-60"), ("3", "v60-80"), ("4", "v80-100")];
        write("visibility", levels.into_iter().map(level).collect())?;
        let channels: BTreeSet<String> = export.dataset.sequences.iter().map(channel).collect();
        let sensor =
            |channel: &String| json!({"token": token("sensor", &[channel]), "channel": channel, "modality": "camera"});
        write("sensor", channels.iter().map(sensor).collect())?;
        // The devkit wants a mask of each place; there is none.
        let empty = Image::filled(ImageSize { width: 16, height: 16 }, 0);
        let mut maps: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for sequence in &export.dataset.sequences {
            maps.entry(sequence.video.map.clone()).or_default().insert(token("log", &[&sequence.video.name]));
        }
        let mut rows = Vec::new();
        for (map, logs) in &maps {
            let filename = format!("maps/{}.png", token("map", &[map]));
            export.target.write(&filename, &encode_grey8(&empty))?;
            rows.push(json!({"token": token("map", &[map]), "category": "semantic_prior", "filename": filename, "log_tokens": logs}));
        }
        write("map", rows)?;
        let splits: BTreeMap<&String, Vec<String>> = export
            .splits
            .iter()
            .enumerate()
            .map(|(split, name)| {
                let scene = |video: VideoJob<'_>| {
                    format!("scene-{:04}", export.dataset.sequences[video.range.start].video.video)
                };
                (name, export.videos_of(split).map(scene).collect())
            })
            .collect();
        export.target.write(format!("{VERSION}/splits.json"), format!("{:#}\n", json!(splits)).as_bytes())
    }
}
