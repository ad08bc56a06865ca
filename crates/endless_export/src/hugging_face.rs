//! Hugging Face image folder: `data/train/NAME.png` with `data/train/metadata.jsonl`, and a dataset card in `README.md`.

use crate::{
    ExportError, Label, LabelledFrame,
    exporter::Exporter,
    job::{Export, VideoJob},
};
use endless_dataset::{CardFacts, Layer, recipe_toml, size_category};
use serde_json::json;

/// A folder that `datasets.load_dataset` opens.
#[derive(Debug)]
pub(crate) struct HuggingFace;

const METADATA: &str = "metadata";

fn metadata(frame: &LabelledFrame<'_>, file: &str) -> String {
    let sequence = frame.sequence;
    let video = &sequence.video;
    let all = |value: fn(&Label) -> serde_json::Value| frame.labels.iter().map(value).collect::<Vec<_>>();
    let entry = json!({
        "file_name": file, "video": video.name, "camera": sequence.camera_name, "map": video.map,
        "weather": video.weather, "time_of_day": video.time_of_day, "frame": frame.frame, "time_s": frame.time_s,
        "width": sequence.output.size.width, "height": sequence.output.size.height,
        "objects": {
            "id": all(|label| json!(label.object.id)),
            "bbox": all(|label| json!(label.object.bbox)),
            "area": all(|label| json!(label.object.pixels)),
            "categories": all(|label| json!(label.class)),
            "visibility": all(|label| json!(label.visibility())),
            "truncated": all(|label| json!(label.object.truncated)),
        },
    });
    entry.to_string() + "\n"
}

/// The card: what the hub shows, with the names of the classes.
fn card(export: &Export<'_>) -> String {
    let manifest = &export.dataset.manifest;
    let quoted = |text: &str| serde_json::to_string(text).expect("plain text");
    let names = export.classes.classes.iter().enumerate();
    let classes: String =
        names.map(|(number, class)| format!("| {number} | {} |\n", class.name.replace('|', "/"))).collect();
    let splits: String = export
        .splits
        .iter()
        .map(|name| format!("  - split: {}\n    path: {}\n", quoted(name), quoted(&format!("data/{name}/**"))))
        .collect();
    let (facts, frames) = (CardFacts::new(manifest), export.frames());
    format!(
        "---\nlicense: {}\ntask_categories:\n- object-detection\nsize_categories:\n- {}\ntags:\n- synthetic\n- surveillance\n- urban\n\
         configs:\n- config_name: default\n  data_files:\n{splits}---\n# Urban surveillance cameras, synthetic\n\n{frames} pictures of {} \
         videos made by endless with seed {}. `objects.bbox` is `[x, y, w, h]` in pixels from the top-left corner, tight around what \
         can be seen; `objects.categories` are:\n\n| number | class |\n|---|---|\n{classes}\nThe recipe, which makes the same dataset \
         again:\n\n```toml\n{}```\n\n## Licence\n\n{}\n\n## Citation\n\n```bibtex\n{}\n```\n",
        facts.hub_licence(),
        size_category(frames),
        export.videos().len(),
        manifest.seed,
        recipe_toml(&manifest.recipe),
        facts.licence,
        facts.citation,
    )
}

impl Exporter for HuggingFace {
    fn video(&self, video: &VideoJob<'_>) -> Result<(), ExportError> {
        let mut lines = video.create_part(METADATA)?;
        for (_, sequence) in video.sequences() {
            let make = |frame: &LabelledFrame<'_>| {
                let file = format!("{}.{}", frame.name(), sequence.extension(Layer::Rgb));
                video.place_image(frame, Layer::Rgb, &format!("data/{}/{file}", video.split()))?;
                Ok(metadata(frame, &file))
            };
            video.frames(sequence, make, |line| Ok(lines.write(line.as_bytes())?))?;
        }
        Ok(lines.finish()?)
    }

    fn finish(&self, export: &Export<'_>) -> Result<(), ExportError> {
        for (split, name) in export.splits.iter().enumerate() {
            let mut file = export.target.create(format!("data/{name}/metadata.jsonl"))?;
            for line in export.lines_of(METADATA, split) {
                file.write((line? + "\n").as_bytes())?;
            }
            file.finish()?;
        }
        export.target.write("README.md", card(export).as_bytes())
    }
}
