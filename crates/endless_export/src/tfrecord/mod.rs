//! TFRecord: `train-00000.tfrecord`, a `tf.train.Example` a picture with the keys of TensorFlow's Object Detection API, and
//! `label_map.pbtxt`. A file a video.

mod example;
mod record;

use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::{DatasetError, Layer};
use example::Feature;
use std::{collections::BTreeMap, fs};

/// Records for TensorFlow.
#[derive(Debug)]
pub(crate) struct TfRecord;

fn features(frame: &LabelledFrame<'_>, export: &Export<'_>) -> Result<BTreeMap<String, Feature>, ExportError> {
    let sequence = frame.sequence;
    let path = sequence.image(Layer::Rgb, frame.frame);
    let bytes = fs::read(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
    let size = sequence.output.size;
    let format = if sequence.extension(Layer::Rgb) == "jpg" { "jpeg" } else { "png" };
    let edges = |at: fn(&[f64; 4]) -> f64, side: u32| {
        let share = |label: &Label| (at(&<[u32; 4]>::from(label.object.bbox).map(f64::from)) / f64::from(side)) as f32;
        Feature::Floats(frame.labels.iter().map(share).collect())
    };
    let name = |label: &Label| export.classes.classes[label.class].name.clone().into_bytes();
    let numbers = |value: &dyn Fn(&Label) -> i64| Feature::Whole(frame.labels.iter().map(value).collect());
    let file = format!("{}.{}", frame.name(), sequence.extension(Layer::Rgb));
    let text = |text: &str| Feature::Bytes(vec![text.as_bytes().to_vec()]);
    let entries = [
        ("image/encoded", Feature::Bytes(vec![bytes])),
        ("image/format", text(format)),
        ("image/filename", text(&file)),
        ("image/source_id", text(&frame.name())),
        ("image/height", Feature::Whole(vec![size.height.into()])),
        ("image/width", Feature::Whole(vec![size.width.into()])),
        ("image/object/bbox/xmin", edges(|b| b[0], size.width)),
        ("image/object/bbox/xmax", edges(|b| b[0] + b[2], size.width)),
        ("image/object/bbox/ymin", edges(|b| b[1], size.height)),
        ("image/object/bbox/ymax", edges(|b| b[1] + b[3], size.height)),
        ("image/object/class/text", Feature::Bytes(frame.labels.iter().map(name).collect())),
        ("image/object/class/label", numbers(&|label| export.classes.id(label.class).into())),
        ("image/object/area", Feature::Floats(frame.labels.iter().map(|label| label.object.pixels as f32).collect())),
        ("image/object/is_crowd", numbers(&|_| 0)),
        ("image/object/truncated", numbers(&|label| label.object.truncated.into())),
        ("image/object/track_id", numbers(&|label| label.object.id.0.into())),
        ("image/object/visibility", Feature::Floats(frame.labels.iter().map(|l| l.visibility() as f32).collect())),
    ];
    Ok(entries.into_iter().map(|(key, feature)| (key.to_owned(), feature)).collect())
}

impl Exporter for TfRecord {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let export = video.export;
        let split = export.split_of[video.range.start];
        let number = export.videos_of(split).take_while(|other| other.number < video.number).count();
        let mut file = export.target.create(format!("{}-{number:05}.tfrecord", video.split()))?;
        for (_, sequence) in video.sequences() {
            let make = |frame: &LabelledFrame<'_>| Ok(record::framed(&example::encode(&features(frame, export)?)));
            video.frames(sequence, make, |record| Ok(file.write(&record)?))?;
        }
        Ok(file.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        let item = |place: usize| {
            let name = serde_json::to_string(&export.classes.classes[place].name).expect("plain text");
            format!("item {{\n  id: {}\n  name: {name}\n}}\n", export.classes.id(place))
        };
        let text: String = (0..export.classes.classes.len()).map(item).collect();
        export.target.write("label_map.pbtxt", text.as_bytes())
    }
}
