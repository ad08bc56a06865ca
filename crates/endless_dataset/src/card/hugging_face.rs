//! `README.md`: the card that Hugging Face shows.

use super::{
    facts::{CardFacts, KEYWORDS, LIMITS, size_category, tasks},
    recipe_toml::recipe_toml,
};
use crate::{Layer, Manifest, VideoEntry};
use std::{collections::BTreeMap, fmt::Write as _};

/// The line of those that follow from the manifest.
pub(super) const MARK: &str = "# Written by endless. Without this line it stays as you change it.";

/// Its text.
pub(super) fn readme(manifest: &Manifest, facts: &CardFacts) -> String {
    let (front, body) = (front_matter(manifest, facts), body(manifest, facts));
    format!("---\n{}\n{front}---\n\n{body}", MARK)
}

fn front_matter(manifest: &Manifest, facts: &CardFacts) -> String {
    let recipe = &manifest.recipe;
    let list =
        |key: &str, words: &[&str]| format!("{key}:\n{}", words.iter().map(|w| format!("- {w}\n")).collect::<String>());
    let mut text = format!("pretty_name: {}\n", quoted(&facts.title));
    let _ = writeln!(text, "license: {}", facts.hub_licence());
    text += &list("task_categories", &tasks(&recipe.layers));
    text += &list("size_categories", &[size_category(facts.camera_frames)]);
    text += &list("tags", KEYWORDS);
    // One folder of pictures can be opened by itself; labels are nested and lie beside it.
    if recipe.cameras_per_scene > 0 && recipe.layers.contains(&Layer::Rgb) {
        let pictures = format!("videos/*/camera_?/rgb/*.{}", recipe.rgb_format);
        let _ =
            writeln!(text, "configs:\n- config_name: rgb\n  data_files: {}\n  drop_labels: true", quoted(&pictures));
    }
    text
}

fn body(manifest: &Manifest, facts: &CardFacts) -> String {
    let recipe = &manifest.recipe;
    let builds: String = manifest.builds.iter().map(|build| format!("- endless {build}\n")).collect();
    let (made_by, again) = if recipe.simulator == "builtin" {
        (
            "ENDLESS moves vehicles and people through a procedural town and traces the rays of each camera. Labels come from this \
             motion and from the rays themselves: nobody has drawn any.",
            "The same bytes come again from this recipe, saved as `recipe.toml`, by the same build, on any number of threads and \
             machines:",
        )
    } else {
        (
            "A CARLA server simulates and renders; ENDLESS places cameras, records and labels.",
            "This recipe, saved as `recipe.toml`, makes another dataset of its kind: the server never does the same twice.",
        )
    };
    let limits: String = LIMITS.iter().map(|limit| format!("- {limit}\n")).collect();
    format!(
        "# {}\n\n{}\n\n\
         | | |\n|---|---|\n| videos | {} |\n| camera frames | {} |\n| boxes | {} |\n| cameras a video | {} |\n| seed | {} |\n\n\
         {}\n## Files\n\n{}\n\
         `videos/NAME/camera_a/objects.jsonl` has one line a frame; its fields, the class tags of images and all conventions stand \
         in `dataset.json` under `labels`. `croissant.json` describes the same files for programs.\n\n\
         ## Classes\n\n| id | class | tag |\n|---|---|---|\n{}\n\
         ## How it was made\n\n{}\n\n\
         Objects of fewer than {} visible pixels have no label{}.\n\n{}\n\n\
         ```sh\nendless generate --config recipe.toml out\n```\n\n```toml\n{}```\n\nBuilds at work:\n\n{builds}\n\
         ## Limits\n\n{limits}\n\
         ## Licence\n\n{}\n\n\
         ## Citation\n\n```bibtex\n{}\n```\n",
        facts.title,
        facts.description,
        facts.videos,
        facts.camera_frames,
        facts.boxes,
        recipe.cameras_per_scene,
        manifest.seed,
        conditions(&manifest.videos),
        layers(&recipe.layers),
        manifest.labels.classes.iter().map(|c| format!("| {} | {} | {} |\n", c.id, c.name, c.tag)).collect::<String>(),
        made_by,
        recipe.min_pixels,
        if recipe.amodal_masks { "; amodal masks are COCO's run lengths" } else { "" },
        again,
        recipe_toml(recipe),
        facts.licence,
        facts.citation,
    )
}

/// How many videos there are of each map and condition.
fn conditions(videos: &[VideoEntry]) -> String {
    let row = |name: &str, value: &dyn Fn(&VideoEntry) -> String| {
        let mut counts = BTreeMap::<String, u64>::new();
        videos.iter().for_each(|video| *counts.entry(value(video)).or_default() += 1);
        let counts: Vec<String> = counts.iter().map(|(word, count)| format!("{word} {count}")).collect();
        format!("| {name} | {} |\n", counts.join(", "))
    };
    let head = "| videos by | |\n|---|---|\n".to_owned();
    head + &row("map", &|video| video.map.clone())
        + &row("weather", &|video| video.weather.to_string())
        + &row("time of day", &|video| video.time_of_day.to_string())
}

fn layers(layers: &[Layer]) -> String {
    let row = |layer: &Layer| format!("| `{layer}` | {} |\n", layer.entry().summary.replace('|', "\\|"));
    "| layer | what a pixel is |\n|---|---|\n".to_owned() + &layers.iter().map(row).collect::<String>()
}

/// A string of YAML, which has those of JSON.
fn quoted(text: &str) -> String {
    serde_json::to_string(text).expect("plain text")
}
