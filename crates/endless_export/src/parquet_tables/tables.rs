//! The columns of both tables.

use super::table::{Cell, Kind, Table};
use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_annotate::visible_mask;
use endless_dataset::Layer;
use endless_world::{Image, InstancePixel};

/// Frames and objects as columns.
#[derive(Debug)]
pub(crate) struct ParquetTables;

const FRAME_COLUMNS: &[(&str, Kind)] = &[
    ("video", Kind::Text),
    ("camera", Kind::Text),
    ("site", Kind::Text),
    ("map", Kind::Text),
    ("weather", Kind::Text),
    ("time_of_day", Kind::Text),
    ("frame", Kind::Whole),
    ("time_s", Kind::Number),
    ("width", Kind::Whole),
    ("height", Kind::Whole),
    ("rgb", Kind::Text),
    ("objects", Kind::Whole),
];

fn frame_row(frame: &LabelledFrame<'_>) -> Vec<Cell> {
    let sequence = frame.sequence;
    let video = &sequence.video;
    let size = sequence.output.size;
    let path = format!(
        "videos/{}/{}/rgb/{:06}.{}",
        video.name,
        sequence.camera_name,
        frame.frame,
        sequence.extension(Layer::Rgb)
    );
    let path = sequence.output.layers.contains(&Layer::Rgb).then_some(path);
    vec![
        video.name.clone().into(),
        sequence.camera_name.clone().into(),
        sequence.site.clone().into(),
        video.map.clone().into(),
        video.weather.name().into(),
        video.time_of_day.name().into(),
        frame.frame.into(),
        frame.time_s.into(),
        size.width.into(),
        size.height.into(),
        path.into(),
        (frame.labels.len() as u32).into(),
    ]
}

const OBJECT_COLUMNS: &[(&str, Kind)] = &[
    ("video", Kind::Text),
    ("camera", Kind::Text),
    ("frame", Kind::Whole),
    ("time_s", Kind::Number),
    ("id", Kind::Whole),
    ("class", Kind::Text),
    ("bbox_x", Kind::Whole),
    ("bbox_y", Kind::Whole),
    ("bbox_w", Kind::Whole),
    ("bbox_h", Kind::Whole),
    ("pixels", Kind::Whole),
    ("truncated", Kind::Truth),
    ("parked", Kind::Truth),
    ("visibility", Kind::Number),
    ("truncation", Kind::Number),
    ("amodal_bbox", Kind::Numbers),
    ("position", Kind::Numbers),
    ("yaw_rad", Kind::Number),
    ("velocity_mps", Kind::Numbers),
    ("speed_mps", Kind::Number),
    ("distance_m", Kind::Number),
    ("box3d_center", Kind::Numbers),
    ("box3d_size", Kind::Numbers),
    ("box3d_rotation", Kind::Numbers),
    ("keypoints", Kind::Numbers),
    ("skin_tone", Kind::Whole),
    ("action", Kind::Text),
    ("lane", Kind::Whole),
    ("rider_id", Kind::Whole),
    ("vehicle_id", Kind::Whole),
    ("mask", Kind::Text),
];

fn object_row(
    frame: &LabelledFrame<'_>,
    label: &Label,
    class: &str,
    instance: Option<&Image<InstancePixel>>,
) -> Vec<Cell> {
    let object = &label.object;
    let [x, y, w, h] = <[u32; 4]>::from(object.bbox);
    let (amodal, box3d) = (object.amodal.as_ref(), object.spatial.as_ref().map(|spatial| &spatial.box3d));
    let keypoints = object.keypoints.as_ref();
    let action =
        object.activity.action.and_then(|action| Some(serde_json::to_value(action).ok()?.as_str()?.to_owned()));
    vec![
        frame.sequence.video.name.clone().into(),
        frame.sequence.camera_name.clone().into(),
        frame.frame.into(),
        frame.time_s.into(),
        object.id.0.into(),
        class.into(),
        x.into(),
        y.into(),
        w.into(),
        h.into(),
        object.pixels.into(),
        object.truncated.into(),
        object.parked.into(),
        amodal.map(|amodal| amodal.visibility).into(),
        amodal.map(|amodal| amodal.truncation).into(),
        amodal.map(|amodal| <[i32; 4]>::from(amodal.amodal_bbox).map(f64::from).to_vec()).into(),
        object.position.to_vec().into(),
        object.yaw_rad.into(),
        object.velocity_mps.to_vec().into(),
        object.speed_mps.into(),
        object.spatial.as_ref().map(|spatial| spatial.distance_m).into(),
        box3d.map(|b| b.center.to_vec()).into(),
        box3d.map(|b| b.size.to_vec()).into(),
        box3d.map(|b| b.rotation.to_vec()).into(),
        keypoints
            .map(|k| k.0.iter().flat_map(|p| [p.x, p.y, f64::from(p.visibility as u8)]).collect::<Vec<_>>())
            .into(),
        object.skin_tone.map(u16::from).into(),
        action.into(),
        object.activity.lane.into(),
        object.rider_id.map(|id| id.0).into(),
        object.vehicle_id.map(|id| id.0).into(),
        instance.map(|image| visible_mask(image, object.id, object.bbox)).into(),
    ]
}

impl Exporter for ParquetTables {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let export = video.export;
        let name = &export.dataset.sequences[video.range.start].video.name;
        let file = |table: &str| export.target.create(format!("{table}/split={}/{name}.parquet", video.split()));
        let mut frames = Table::begin(file("frames")?, "frames", FRAME_COLUMNS)?;
        let mut objects = Table::begin(file("objects")?, "objects", OBJECT_COLUMNS)?;
        for (_, sequence) in video.sequences() {
            let masks = sequence.output.layers.contains(&Layer::Instance);
            let make = |frame: &LabelledFrame<'_>| {
                let instance = if masks && !frame.labels.is_empty() { Some(frame.instance()?) } else { None };
                let row = |label: &Label| {
                    object_row(frame, label, &export.classes.classes[label.class].name, instance.as_deref())
                };
                Ok((frame_row(frame), frame.labels.iter().map(row).collect::<Vec<_>>()))
            };
            video.frames(sequence, make, |(frame, rows)| {
                frames.push(frame)?;
                rows.into_iter().try_for_each(|row| objects.push(row))
            })?;
        }
        frames.finish()?;
        objects.finish()
    }

    fn finish(&self, _export: &Export<'_>) -> Result<(), ExportError> {
        Ok(())
    }
}
