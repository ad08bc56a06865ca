//! WebDataset: shards `train-000000.tar`. The files of a sample follow one another: `KEY.rgb.png`, `KEY.depth.png`, `KEY.instance.png`
//! and what else is stored, and `KEY.json` with the labels. Keys have no dots.

use crate::{
    ExportError, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
    sink::Sink,
};
use endless_dataset::DatasetError;
use serde_json::json;
use std::{fs, io};

/// Shards for streaming.
#[derive(Debug)]
pub(crate) struct WebDataset;

/// Samples of a shard at most; the last one of a video has fewer.
const SAMPLES: usize = 500;

/// A file of a sample.
struct Member {
    name: String,
    bytes: Vec<u8>,
}

/// The shards of a part are numbered through all its videos.
fn shards_before(video: &VideoJob<'_>) -> usize {
    let split = video.export.split_of[video.range.start];
    let before = video.export.videos_of(split).take_while(|other| other.number < video.number);
    before.map(|other| shards(&other)).sum()
}

fn shards(video: &VideoJob<'_>) -> usize {
    video.sequences().map(|(_, sequence)| sequence.len()).sum::<usize>().div_ceil(SAMPLES)
}

fn sample(frame: &LabelledFrame<'_>, export: &Export<'_>) -> Result<Vec<Member>, ExportError> {
    let sequence = frame.sequence;
    let key = frame.name().replace('.', "_");
    let mut members = Vec::new();
    for &layer in &sequence.output.layers {
        let path = sequence.image(layer, frame.frame);
        let bytes = fs::read(&path).map_err(|e| DatasetError::io("cannot read", &path, e))?;
        members.push(Member { name: format!("{key}.{layer}.{}", sequence.extension(layer)), bytes });
    }
    let video = &sequence.video;
    let objects: Vec<_> = frame
        .labels
        .iter()
        .map(|label| {
            let mut object = json!(label.object);
            object["category"] = json!(export.classes.classes[label.class].name);
            object["category_id"] = json!(label.class);
            object
        })
        .collect();
    let labels = json!({
        "video": video.name, "camera": sequence.camera_name, "site": sequence.site, "map": video.map,
        "weather": video.weather, "time_of_day": video.time_of_day, "frame": frame.frame, "time_s": frame.time_s,
        "width": sequence.output.size.width, "height": sequence.output.size.height, "objects": objects,
    });
    members.push(Member { name: format!("{key}.json"), bytes: labels.to_string().into_bytes() });
    Ok(members)
}

/// A shard that is being written.
type Shard = tar::Builder<Sink>;

fn append(shard: &mut Shard, member: &Member) -> io::Result<()> {
    let mut header = tar::Header::new_gnu();
    header.set_size(member.bytes.len() as u64);
    header.set_mode(0o644);
    header.set_mtime(0);
    shard.append_data(&mut header, &member.name, member.bytes.as_slice())
}

impl Exporter for WebDataset {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let export = video.export;
        let (mut number, mut count) = (shards_before(video), 0);
        let mut shard: Option<Shard> = None;
        let failed = |error: io::Error| -> ExportError {
            match error.downcast::<DatasetError>() {
                Ok(own) => own.into(),
                Err(error) => DatasetError::io("cannot write", export.target.root(), error).into(),
            }
        };
        let finish = |shard: Option<Shard>| match shard {
            Some(shard) => Ok(shard.into_inner().map_err(failed)?.0.finish()?),
            None => Ok::<(), ExportError>(()),
        };
        for (_, sequence) in video.sequences() {
            video.frames(
                sequence,
                |frame| sample(frame, export),
                |members: Vec<Member>| {
                    if count % SAMPLES == 0 {
                        finish(shard.take())?;
                        shard = Some(tar::Builder::new(Sink(
                            export.target.create(format!("{}-{number:06}.tar", video.split()))?,
                        )));
                        number += 1;
                    }
                    count += 1;
                    let Some(shard) = &mut shard else { return Ok(()) };
                    members.iter().try_for_each(|member| append(shard, member).map_err(failed))
                },
            )?;
        }
        finish(shard)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        let mut text = String::new();
        for (split, name) in export.splits.iter().enumerate() {
            let shards: usize = export.videos_of(split).map(|video| shards(&video)).sum();
            let samples: usize =
                export.videos_of(split).flat_map(|v| v.sequences().map(|(_, s)| s.len()).collect::<Vec<_>>()).sum();
            let last = shards.saturating_sub(1);
            text += &format!("{name}-{{000000..{last:06}}}.tar {samples} samples\n");
        }
        export.target.write("shards.txt", text.as_bytes())
    }
}
