//! `/api/dataset`: what the list of videos shows.

use crate::{dataset::Dataset, facts::VideoFacts, folder::is_plain_name, refusal::Refusal};
use endless_dataset::{BuildIdentity, LabelSchema, Layer, Manifest, Recipe, VideoEntry, VideoState};
use serde::Serialize;
use std::collections::BTreeSet;

/// The dataset in short.
#[derive(Debug, Serialize)]
struct Overview<'d> {
    name: String,
    format: u32,
    tool: &'d str,
    builds: &'d [BuildIdentity],
    recipe: &'d Recipe,
    labels: &'d LabelSchema,
    /// Complete videos whose facts are not known yet.
    pending: usize,
    videos: Vec<VideoOverview<'d>>,
}

#[derive(Debug, Serialize)]
struct VideoOverview<'d> {
    #[serde(flatten)]
    entry: &'d VideoEntry,
    /// Of a video that is being recorded: how many frames there are.
    #[serde(skip_serializing_if = "Option::is_none")]
    recorded: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    facts: Option<VideoFacts>,
}

/// The overview as JSON.
pub(crate) fn overview(dataset: &Dataset, manifest: &Manifest) -> Result<Vec<u8>, Refusal> {
    let begun: BTreeSet<String> = dataset.folder.list(&dataset.layout.videos()).into_iter().collect();
    let mut pending = 0;
    let videos = manifest.videos.iter().map(|entry| {
        let complete = entry.state == VideoState::Complete;
        if !complete {
            dataset.forget_facts(entry);
        }
        let facts = dataset.facts(entry);
        pending += usize::from(complete && facts.is_none());
        let recorded = (!complete && begun.contains(&entry.name)).then(|| recorded(dataset, manifest, entry));
        VideoOverview { entry, recorded, facts: facts.flatten() }
    });
    let videos = videos.collect();
    let overview = Overview {
        name: dataset.folder.name(),
        format: manifest.format,
        tool: &manifest.tool,
        builds: &manifest.builds,
        recipe: &manifest.recipe,
        labels: &manifest.labels,
        pending,
        videos,
    };
    serde_json::to_vec(&overview).map_err(|cause| Refusal::Damaged(cause.to_string()))
}

/// Pictures of the first camera so far.
fn recorded(dataset: &Dataset, manifest: &Manifest, entry: &VideoEntry) -> u32 {
    if !is_plain_name(&entry.name) || entry.cameras.is_empty() {
        return 0;
    }
    let layer = manifest.recipe.layers.first().copied().unwrap_or(Layer::Rgb);
    let camera = dataset.layout.video_named(&entry.name).camera(0);
    let ending = format!(".{}", layer.format(manifest.recipe.rgb_format));
    let names = dataset.folder.list(&camera.layer(layer));
    names.iter().filter(|name| name.ends_with(&ending)).count() as u32
}
