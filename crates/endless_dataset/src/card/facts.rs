//! What all cards tell, in the same words.

use crate::{Layer, Manifest, ModelSpec, Recipe, VideoState};

/// What the cards of a dataset tell of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CardFacts {
    /// What it is called.
    pub title: String,
    /// What it is, in a few sentences.
    pub description: String,
    /// Videos that are complete.
    pub videos: u64,
    /// Their pictures, those of the rig's cameras included.
    pub camera_frames: u64,
    /// Their boxes.
    pub boxes: u64,
    /// SPDX identifiers of its licences, any of which may be chosen; none if they depend on files that were imported.
    pub licences: &'static [&'static str],
    /// What is to be said of the licence.
    pub licence: String,
    /// BibTeX of the program.
    pub citation: String,
    /// Version of the dataset: that of the program and its sources.
    pub version: String,
}

/// Words that both cards are found by.
pub(super) const KEYWORDS: &[&str] = &[
    "synthetic",
    "computer vision",
    "surveillance",
    "traffic",
    "smart cities",
    "object detection",
    "instance segmentation",
    "depth estimation",
    "multi-object tracking",
];

/// What no picture of it can tell.
pub(super) const LIMITS: &[&str] = &[
    "Everything in it is rendered. What is learnt from it alone must be tested on real pictures before it is relied on.",
    "Towns, vehicles and people are procedural: they have the variety of their generator, not that of the world. Shares of \
     classes, looks and behaviour are those of the recipe, and no city's.",
    "Objects that are hidden as a whole, and those of fewer visible pixels than the recipe's min_pixels, are not listed.",
    "There are no real people, faces or number plates in it, and nothing personal.",
];

const TOOL_AUTHORS: &str = "The ENDLESS developers";
const TOOL_TITLE: &str = "ENDLESS: endless annotated urban datasets seen by surveillance cameras";

impl CardFacts {
    /// The facts of a dataset.
    pub fn new(manifest: &Manifest) -> Self {
        let recipe = &manifest.recipe;
        let complete = manifest.videos.iter().filter(|video| video.state == VideoState::Complete);
        let videos = complete.clone().count() as u64;
        let of_rig: u64 = recipe
            .sensor
            .iter()
            .map(|sensor| match &sensor.model {
                ModelSpec::Camera(camera) => u64::from(recipe.rig_camera_output(sensor, camera).count()),
                _ => 0,
            })
            .sum();
        let camera_frames =
            complete.clone().map(|video| video.cameras.len() as u64 * u64::from(video.frames)).sum::<u64>();
        let boxes = complete.filter_map(|video| video.boxes.as_ref()).flatten().sum();
        let (licences, licence) = licence(recipe);
        let planned = if recipe.videos == 1 { "1 video".to_owned() } else { format!("{} videos", recipe.videos) };
        let state = if videos == u64::from(recipe.videos) { String::new() } else { format!(" ({videos} complete)") };
        Self {
            title: format!("Urban surveillance cameras, synthetic: {planned} of seed {}", manifest.seed),
            description: format!(
                "Synthetic, automatically annotated videos of urban streets seen by surveillance cameras, made by ENDLESS: \
                 {planned}{state}, each {} s long at {} frames a second and {} pixels, with {}. Boxes, tracks, 3D boxes, \
                 keypoints and what each object is doing are in objects.jsonl.",
                recipe.duration,
                recipe.fps,
                recipe.size,
                recipe.layers.iter().map(|layer| layer.name().replace('_', " ")).collect::<Vec<_>>().join(", "),
            ),
            videos,
            camera_frames: camera_frames + videos * of_rig,
            boxes,
            licences,
            licence,
            citation: format!(
                "@software{{endless, author = {{{{{TOOL_AUTHORS}}}}}, title = {{{TOOL_TITLE}}}, version = {{{}}}}}",
                manifest.builds.first().map_or("unknown", |build| &build.version),
            ),
            version: manifest.builds.first().map_or("0.0.0".to_owned(), |build| {
                format!("{}+{}", build.version, build.sources.get(..12).unwrap_or(&build.sources))
            }),
        }
    }
}

impl CardFacts {
    /// The licence by the hub's names, in YAML.
    pub fn hub_licence(&self) -> String {
        if self.licences.is_empty() {
            "other".to_owned()
        } else {
            format!("[{}]", self.licences.join(", ").to_lowercase())
        }
    }
}

/// All that is seen comes with the program, unless the recipe brings more.
fn licence(recipe: &Recipe) -> (&'static [&'static str], String) {
    let mut foreign = Vec::new();
    let mut named = |what: &str, names: Vec<&str>| {
        if !names.is_empty() {
            foreign.push(format!("{what} ({})", names.join(", ")));
        }
    };
    named("imported maps", recipe.map_files.keys().map(String::as_str).collect());
    named("imported models", recipe.asset_files.keys().map(String::as_str).collect());
    named("recorded motion", recipe.traffic_file.as_deref().into_iter().collect());
    if recipe.simulator != "builtin" {
        foreign.push("the simulator's assets".to_owned());
    }
    if foreign.is_empty() {
        let text = "Whatever is seen in it is made by the program's own code, which is licensed under MIT or Apache-2.0, at your \
                    choice. So is this dataset, unless who publishes it says otherwise.";
        return (&["MIT", "Apache-2.0"], text.to_owned());
    }
    let text = format!(
        "The program is licensed under MIT or Apache-2.0. This dataset also shows what has licences of its own: {}. Who publishes \
         it names them here.",
        foreign.join("; "),
    );
    (&[], text)
}

/// The hub's word for so many examples.
pub fn size_category(examples: u64) -> &'static str {
    match examples {
        0..1_000 => "n<1K",
        1_000..10_000 => "1K<n<10K",
        10_000..100_000 => "10K<n<100K",
        100_000..1_000_000 => "100K<n<1M",
        1_000_000..10_000_000 => "1M<n<10M",
        10_000_000..100_000_000 => "10M<n<100M",
        100_000_000..1_000_000_000 => "100M<n<1B",
        _ => "n>1B",
    }
}

/// The tasks that a dataset of these layers serves, by the hub's names.
pub(super) fn tasks(layers: &[Layer]) -> Vec<&'static str> {
    let segments = [Layer::Instance, Layer::Semantic, Layer::Panoptic].iter().any(|layer| layers.contains(layer));
    let mut tasks = vec!["object-detection", "keypoint-detection"];
    tasks.extend(segments.then_some("image-segmentation"));
    tasks.extend(layers.contains(&Layer::Depth).then_some("depth-estimation"));
    tasks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_program_is_cited_as_it_asks_to_be() {
        let asked = include_str!("../../../../CITATION.cff");
        assert!(
            asked.contains(&format!("title: \"{TOOL_TITLE}\"")) && asked.contains(&format!("name: \"{TOOL_AUTHORS}\""))
        );
    }

    #[test]
    fn sizes_are_the_hubs() {
        assert_eq!([999, 1_000, 378_792].map(size_category), ["n<1K", "1K<n<10K", "100K<n<1M"]);
    }
}
