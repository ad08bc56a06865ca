//! COCO's panoptic segmentation: `annotations/panoptic_train.json` beside `annotations/panoptic_train/`.

use super::document::{Document, categories, line, write_parts};
use crate::{
    ExportError,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::{encode_png, write_atomic};
use endless_world::{ClassTag, Image, InstanceId, InstancePixel};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// Segments of objects and of stuff. Objects that are not labelled are void.
#[derive(Debug)]
pub(crate) struct CocoPanoptic;

const IMAGES: &str = "images";
const ANNOTATIONS: &str = "panoptic";
/// Categories of stuff are numbered from here on, by class tag.
const FIRST_STUFF: u32 = 100;

struct Segment {
    category: u32,
    area: u32,
    /// Smallest and largest column and row.
    x: [u32; 2],
    y: [u32; 2],
}

/// Number of a segment; 0 is void.
fn segment_id(pixel: InstancePixel) -> u32 {
    u32::from(pixel.id.0) + (u32::from(pixel.tag.value()) << 16)
}

/// The segments of a picture, with their numbers, and the picture itself.
fn segments(
    instance: &Image<InstancePixel>,
    things: &BTreeMap<InstanceId, u32>,
) -> (BTreeMap<u32, Segment>, Image<[u8; 3]>) {
    let mut found: BTreeMap<u32, Segment> = BTreeMap::new();
    let mut data = Vec::with_capacity(instance.data.len());
    for (y, row) in instance.data.chunks(instance.size.width as usize).enumerate() {
        let mut x = 0;
        for run in row.chunk_by(|a, b| a == b) {
            let (pixel, end) = (run[0], x + run.len() as u32);
            let category = if pixel.id == InstanceId::STUFF {
                (pixel.tag != ClassTag::Unlabeled).then(|| FIRST_STUFF + u32::from(pixel.tag.value()))
            } else {
                things.get(&pixel.id).copied()
            };
            let id = category.map_or(0, |_| segment_id(pixel));
            if let Some(category) = category {
                let y = y as u32;
                let segment = found.entry(id).or_insert(Segment { category, area: 0, x: [x, x], y: [y, y] });
                segment.area += run.len() as u32;
                segment.x = [segment.x[0].min(x), segment.x[1].max(end - 1)];
                segment.y[1] = y;
            }
            let [r, g, b, _] = id.to_le_bytes();
            data.extend(std::iter::repeat_n([r, g, b], run.len()));
            x = end;
        }
    }
    (found, Image { size: instance.size, data })
}

impl Exporter for CocoPanoptic {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let split = video.split();
        write_parts(video, &format!("images/{split}"), [IMAGES, ANNOTATIONS], |frame, id| {
            let things = frame.labels.iter().map(|l| (l.object.id, video.export.classes.id(l.class))).collect();
            let instance = frame.instance()?;
            let (segments, picture) = segments(&instance, &things);
            let png = format!("{}.png", frame.name());
            let path = video.export.target.path(format!("annotations/panoptic_{split}/{png}"))?;
            write_atomic(&path, &encode_png(&picture))?;
            let info = |(id, s): (&u32, &Segment)| {
                let bbox = [s.x[0], s.y[0], s.x[1] - s.x[0] + 1, s.y[1] - s.y[0] + 1];
                json!({"id": id, "category_id": s.category, "area": s.area, "bbox": bbox, "iscrowd": 0})
            };
            let infos: Vec<Value> = segments.iter().map(info).collect();
            Ok(line(&json!({"image_id": id, "file_name": png, "segments_info": infos})))
        })
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        let thing = |mut category: Value| {
            category["isthing"] = json!(1);
            category
        };
        let mut categories: Vec<Value> = categories(export).into_iter().map(thing).collect();
        categories.extend(ClassTag::ALL.iter().filter(|&&tag| tag != ClassTag::Unlabeled).map(|tag| {
            json!({"id": FIRST_STUFF + u32::from(tag.value()), "name": format!("stuff {}", tag.name()), "isthing": 0,
                   "supercategory": "stuff"})
        }));
        for (split, name) in export.splits.iter().enumerate() {
            let path = format!("annotations/panoptic_{name}.json");
            let document =
                Document { path, categories: &categories, images: IMAGES, annotations: ANNOTATIONS, numbered: false };
            document.write(export, split)?;
        }
        Ok(())
    }
}
