//! The JSON file of a part: joined from the lines of its videos, so that memory holds one line.

use crate::{
    ExportError, LabelledFrame,
    job::{Export, VideoJob},
};
use endless_dataset::{AtomicFile, Layer};
use endless_world::ObjectClass;
use serde::Serialize;
use serde_json::{Value, json};

/// An entry of `images`.
#[derive(Debug, Serialize)]
struct CocoImage<'a> {
    id: usize,
    width: u32,
    height: u32,
    file_name: String,
    video: &'a str,
    camera: &'a str,
    site: &'a str,
    map: &'a str,
    weather: &'static str,
    time_of_day: &'static str,
    frame: u32,
    time_s: f64,
}

impl<'a> CocoImage<'a> {
    /// Of a frame, by its place among all that are exported, from 1.
    fn new(frame: &LabelledFrame<'a>, id: usize, file_name: String) -> Self {
        let sequence = frame.sequence;
        let video = &sequence.video;
        Self {
            id,
            width: sequence.output.size.width,
            height: sequence.output.size.height,
            file_name,
            video: &video.name,
            camera: &sequence.camera_name,
            site: &sequence.site,
            map: &video.map,
            weather: video.weather.name(),
            time_of_day: video.time_of_day.name(),
            frame: frame.frame,
            time_s: frame.time_s,
        }
    }
}

/// A line of a part.
pub(super) fn line(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("plain numbers and words") + "\n"
}

/// The categories of the classes.
pub(super) fn categories(export: &Export<'_>) -> Vec<Value> {
    let classes = export.classes.classes.iter().enumerate();
    classes
        .map(|(place, class)| {
            let people = class.from.iter().all(|own| matches!(own, ObjectClass::Pedestrian | ObjectClass::Rider));
            let supercategory = if people { "person" } else { "vehicle" };
            json!({"id": export.classes.id(place), "name": class.name, "supercategory": supercategory})
        })
        .collect()
}

/// Writes the parts of a video: the entry of each image, and what `annotate` says of it, which gets the image's number. Pictures
/// go to `folder`.
pub(super) fn write_parts(
    video: &VideoJob<'_>,
    folder: &str,
    [images, annotations]: [&str; 2],
    annotate: impl Fn(&LabelledFrame<'_>, usize) -> Result<String, ExportError> + Sync,
) -> Result<(), ExportError> {
    let (mut images, mut annotations) = (video.create_part(images)?, video.create_part(annotations)?);
    for (place, sequence) in video.sequences() {
        let before = video.export.frames_before(place);
        let make = |frame: &LabelledFrame<'_>| {
            let file_name = format!("{}.{}", frame.name(), sequence.extension(Layer::Rgb));
            video.place_image(frame, Layer::Rgb, &format!("{folder}/{file_name}"))?;
            let id = before + frame.place + 1;
            Ok((line(&CocoImage::new(frame, id, file_name)), annotate(frame, id)?))
        };
        video.frames(sequence, make, |(image, lines)| {
            images.write(image.as_bytes())?;
            Ok(annotations.write(lines.as_bytes())?)
        })?;
    }
    images.finish()?;
    Ok(annotations.finish()?)
}

/// Which lines become a file.
pub(super) struct Document<'a> {
    /// Path below the target.
    pub(super) path: String,
    pub(super) categories: &'a [Value],
    /// The parts that hold entries of `images` and of `annotations`.
    pub(super) images: &'static str,
    pub(super) annotations: &'static str,
    /// Whether annotations get an `id` each, from 1.
    pub(super) numbered: bool,
}

impl Document<'_> {
    /// Writes it.
    pub(super) fn write(&self, export: &Export<'_>, split: usize) -> Result<(), ExportError> {
        let manifest = &export.dataset.manifest;
        let info = json!({
            "description": format!("endless, seed {}", manifest.seed),
            "version": manifest.labels.version,
            "split": export.splits[split],
        });
        let mut file = export.target.create(&self.path)?;
        file.write(format!("{{\"info\":{info},\n\"licenses\":[],\n\"categories\":[").as_bytes())?;
        let entries: Vec<String> = self.categories.iter().map(Value::to_string).collect();
        file.write(entries.join(",\n").as_bytes())?;
        file.write(b"],\n\"images\":[\n")?;
        join(&mut file, export.lines_of(self.images, split), false)?;
        file.write(b"],\n\"annotations\":[\n")?;
        join(&mut file, export.lines_of(self.annotations, split), self.numbered)?;
        file.write(b"]}\n")?;
        Ok(file.finish()?)
    }
}

/// Writes objects of JSON with commas between, and with a number each where they are numbered.
fn join(
    file: &mut AtomicFile,
    lines: impl Iterator<Item = Result<String, ExportError>>,
    numbered: bool,
) -> Result<(), ExportError> {
    for (place, line) in lines.enumerate() {
        let line = line?;
        if place > 0 {
            file.write(b",\n")?;
        }
        match line.strip_prefix('{').filter(|_| numbered) {
            Some(rest) => file.write(format!("{{\"id\":{},{rest}", place + 1).as_bytes())?,
            None => file.write(line.as_bytes())?,
        }
    }
    Ok(file.write(b"\n")?)
}
