//! An object as COCO has it.

use crate::{ExportError, Label, LabelledFrame, PooledInstance, job::Export, outline::outlines};
use endless_annotate::visible_mask;
use endless_world::{Image, InstancePixel};
use serde_json::{Map, Value, json};

/// How masks are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Masks {
    /// Run lengths: exact.
    RunLengths,
    /// Polygons along the edges of pixels.
    Polygons,
}

/// An annotation without its `id`.
pub(super) fn annotation(
    export: &Export<'_>,
    image_id: usize,
    label: &Label,
    instance: &Image<InstancePixel>,
    masks: Masks,
) -> Map<String, Value> {
    let object = &label.object;
    let size = instance.size;
    let segmentation = match masks {
        Masks::RunLengths => {
            json!({"size": [size.height, size.width], "counts": visible_mask(instance, object.id, object.bbox)})
        }
        Masks::Polygons => {
            let flat = |polygon: Vec<[u32; 2]>| polygon.into_iter().flatten().collect::<Vec<u32>>();
            json!(outlines(instance, object.id, object.bbox).into_iter().map(flat).collect::<Vec<_>>())
        }
    };
    let mut entry = Map::new();
    let mut put = |key: &str, value: Value| drop(entry.insert(key.into(), value));
    put("image_id", json!(image_id));
    put("category_id", json!(export.classes.id(label.class)));
    put("bbox", json!(object.bbox));
    put("area", json!(object.pixels));
    put("iscrowd", json!(0));
    put("segmentation", segmentation);
    put("track_id", json!(object.id));
    put("visibility", json!(label.visibility()));
    put("truncated", json!(object.truncated));
    if let Some(amodal) = &object.amodal {
        put("amodal_bbox", json!(amodal.amodal_bbox));
    }
    entry
}

/// The instance image of a frame, if anything is labelled in it.
pub(super) fn instance_if_labelled(frame: &LabelledFrame<'_>) -> Result<Option<PooledInstance>, ExportError> {
    if frame.labels.is_empty() { Ok(None) } else { frame.instance().map(Some) }
}
