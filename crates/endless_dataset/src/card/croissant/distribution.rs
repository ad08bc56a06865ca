//! The files: a set for each kind. They have no checksums, because a dataset grows.

use super::files::{ImageFiles, camera_folders};
use crate::{ModelSpec, Recipe, RgbFormat, SensorSpec};
use serde_json::{Value, json};

/// The sets of files of a dataset.
pub(super) fn distribution(recipe: &Recipe, images: &[ImageFiles]) -> Value {
    let mut sets = vec![
        set("manifest", "Recipe, seed, builds, labels and videos", "application/json", &["dataset.json".into()]),
        set(
            "scene_files",
            "Settings of each video and what was spawned and staged",
            "application/json",
            &["videos/*/scene.json".into()],
        ),
        set(
            "actor_files",
            "What stays the same of each object of a video",
            "application/json",
            &["videos/*/actors.json".into()],
        ),
        set(
            "scene_frame_files",
            "Weather, light and signals at each frame of a video",
            JSON_LINES,
            &["videos/*/frames.jsonl".into()],
        ),
    ];
    let every_camera = |file: &str| {
        let of_rig = recipe.sensor.iter().filter(|sensor| matches!(sensor.model, ModelSpec::Camera(_)));
        let folders = camera_folders(recipe).map(str::to_owned).into_iter();
        folders
            .chain(of_rig.map(|sensor| format!("videos/*/{}", sensor.name)))
            .map(|folder| format!("{folder}/{file}"))
            .collect()
    };
    let labels: Vec<String> = every_camera("objects.jsonl");
    if !labels.is_empty() {
        sets.push(set("object_files", "The annotated objects of each frame of a camera", JSON_LINES, &labels));
        let cameras: Vec<String> = every_camera("camera.json");
        sets.push(set("camera_files", "Intrinsics, pose and conventions of a camera", "application/json", &cameras));
    }
    for files in images {
        let (id, summary) = (files_id(files), files.layer.entry().summary);
        sets.push(set(&id, summary, image_type(files.format), &files.patterns));
    }
    for layer in recipe.mp4.iter().filter(|_| recipe.cameras_per_scene > 0) {
        let pattern = format!("videos/*/camera_?/{layer}.mp4");
        sets.push(set(&format!("{layer}_videos"), &format!("The layer {layer} as a video"), "video/mp4", &[pattern]));
    }
    sets.extend(recipe.sensor.iter().flat_map(sensor_sets));
    json!(sets)
}

const JSON_LINES: &str = "application/jsonlines";

/// What a set of images is called.
pub(super) fn files_id(files: &ImageFiles) -> String {
    format!("{}_files", files.layer)
}

const fn image_type(format: RgbFormat) -> &'static str {
    match format {
        RgbFormat::Png => "image/png",
        RgbFormat::Jpg => "image/jpeg",
    }
}

fn set(id: &str, description: &str, encoding: &str, includes: &[String]) -> Value {
    json!({
        "@type": "cr:FileSet", "@id": id, "name": id, "description": description, "encodingFormat": encoding, "includes": includes,
    })
}

/// What sensors other than cameras write.
fn sensor_sets(sensor: &SensorSpec) -> Vec<Value> {
    let name = &sensor.name;
    let folders = sensor.model.frame_folders().into_iter().map(|folder| {
        let pattern = format!("videos/*/{name}/{}/*.{}", folder.name(), folder.extension());
        let description = format!("The {} of the sensor {name}", folder.name());
        set(&format!("{name}_{}_files", folder.name()), &description, "application/octet-stream", &[pattern])
    });
    let lines = sensor.model.lines_file().map(|file| {
        set(
            &format!("{name}_lines"),
            &format!("What the sensor {name} measures"),
            JSON_LINES,
            &[format!("videos/*/{name}/{file}")],
        )
    });
    folders.chain(lines).collect()
}
