//! The records: one a video, one a frame of a camera with its objects, and one an image of each layer.

use super::{distribution::files_id, files::ImageFiles};
use serde_json::{Value, json};

/// The sets of records of a dataset.
pub(super) fn record_sets(images: &[ImageFiles]) -> Value {
    let mut sets = vec![videos()];
    if !images.is_empty() {
        sets.push(frames());
    }
    sets.extend(images.iter().map(image_records));
    json!(sets)
}

const OBJECTS: &str = "object_files";
/// Of a path: the video, the camera, the frame.
const VIDEO: &str = "^videos/([^/]+)/";
const CAMERA: &str = "^videos/[^/]+/([^/]+)/";
const FRAME: &str = "^videos/[^/]+/[^/]+/[^/]+/0*([0-9]+)[.]";

fn videos() -> Value {
    let of_scene = |name: &str, kind: &str, description: &str| {
        field("videos", name, kind, description, source("scene_files", &json!({"jsonPath": format!("$.{name}")}), None))
    };
    json!({
        "@type": "cr:RecordSet", "@id": "videos", "name": "videos",
        "description": "A scene, filmed by all its cameras at the same instants",
        "key": [{"@id": "videos/video"}],
        "field": [
            of_scene("video", "sc:Integer", "Its number in the plan, with which the name of its folder begins"),
            of_scene("map", "sc:Text", "The town"),
            of_scene("weather", "sc:Text", "The weather"),
            of_scene("time_of_day", "sc:Text", "The time of day"),
            of_scene("fps", "sc:Float", "Frames a second"),
            of_scene("frames", "sc:Integer", "Frames of each camera"),
        ],
    })
}

fn frames() -> Value {
    let column = |column: &str, path: Option<&str>| {
        source(OBJECTS, &json!({"column": column}), path.map(|path| json!({"jsonPath": path})))
    };
    let of_object = |name: &str, kind: &str, description: &str| {
        field("frames/objects", name, kind, description, column("objects", Some(name)))
    };
    let mut bbox = of_object("bbox", "sc:Float", "[x, y, width, height], pixels from the top-left corner");
    bbox["isArray"] = json!(true);
    bbox["arrayShape"] = json!("4");
    let mut fields = place("frames", OBJECTS);
    fields.extend([
        field("frames", "frame", "sc:Integer", "Its number, from 0", column("frame", None)),
        field("frames", "time_s", "sc:Float", "Seconds since frame 0", column("time_s", None)),
        json!({
            "@type": "cr:Field", "@id": "frames/objects", "name": "objects", "isArray": true, "arrayShape": "-1",
            "description": "The annotated objects; files have more of each, as dataset.json tells",
            "subField": [
                of_object("id", "sc:Integer", "The track: the same in all cameras and frames of a video"),
                of_object("class", "sc:Text", "The class"),
                bbox,
                of_object("pixels", "sc:Integer", "Visible pixels"),
            ],
        }),
    ]);
    records("frames", "A frame of a camera with its objects", &fields)
}

fn image_records(files: &ImageFiles) -> Value {
    let (name, set) = (files.layer.name(), files_id(files));
    let mut fields = place(name, &set);
    fields.extend([
        field(name, "frame", "sc:Integer", "Its number, from 0", path_source(&set, FRAME)),
        field(
            name,
            "image",
            "sc:ImageObject",
            files.layer.entry().summary,
            source(&set, &json!({"fileProperty": "content"}), None),
        ),
    ]);
    records(name, &format!("The layer {name} of a frame of a camera"), &fields)
}

/// Records that a video, a camera and a frame tell from one another.
fn records(name: &str, description: &str, fields: &[Value]) -> Value {
    let key: Vec<Value> =
        ["video", "camera", "frame"].iter().map(|part| json!({"@id": format!("{name}/{part}")})).collect();
    json!({"@type": "cr:RecordSet", "@id": name, "name": name, "description": description, "key": key, "field": fields})
}

/// Where a record is from.
fn place(records: &str, set: &str) -> Vec<Value> {
    vec![
        field(records, "video", "sc:Text", "The folder of its video", path_source(set, VIDEO)),
        field(records, "camera", "sc:Text", "The folder of its camera", path_source(set, CAMERA)),
    ]
}

fn field(parent: &str, name: &str, kind: &str, description: &str, source: Value) -> Value {
    json!({
        "@type": "cr:Field", "@id": format!("{parent}/{name}"), "name": name, "description": description, "dataType": kind,
        "source": source,
    })
}

fn path_source(set: &str, regex: &str) -> Value {
    source(set, &json!({"fileProperty": "fullpath"}), Some(json!({"regex": regex})))
}

fn source(set: &str, extract: &Value, transform: Option<Value>) -> Value {
    let mut source = json!({"fileSet": {"@id": set}, "extract": extract});
    if let Some(transform) = transform {
        source["transform"] = transform;
    }
    source
}
