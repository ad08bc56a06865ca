//! `/api/videos/…` without pictures: settings, cameras, objects, what happens.

use crate::{
    dataset::Dataset,
    refusal::Refusal,
    reply::{JSON, Reply, blocking},
};
use axum::{
    extract::{Path, Query, State},
    http::HeaderMap,
    response::Response,
};
use endless_dataset::{Layer, RgbFormat, SceneRecord, VideoState};
use endless_world::{ImageSize, SceneSettings};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::{
    hash::{DefaultHasher, Hash, Hasher},
    path::PathBuf,
    sync::Arc,
};

/// Some lines of a file, from 0.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LineRange {
    from: u32,
    count: u32,
}

#[derive(Debug, Serialize)]
struct VideoReply<'v> {
    video: u32,
    name: &'v str,
    state: VideoState,
    /// Frames that can be shown.
    frames_there: u32,
    rgb_format: RgbFormat,
    has_actors: bool,
    #[serde(flatten)]
    scene: Scene<'v>,
    views: Vec<CameraReply<'v>>,
}

/// Settings, and what came of them.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Scene<'v> {
    Complete { scene: &'v SceneRecord },
    Planned { scene: &'v SceneSettings },
}

#[derive(Debug, Serialize)]
struct CameraReply<'v> {
    name: &'v str,
    folder: &'v str,
    of_rig: bool,
    every: u32,
    size: ImageSize,
    layers: Vec<Layer>,
    has_objects: bool,
    has_map: bool,
    /// `camera.json`, once it is there.
    camera: Option<Value>,
}

pub(crate) async fn overview(State(dataset): State<Arc<Dataset>>, headers: HeaderMap) -> Result<Response, Refusal> {
    let (manifest, bytes) = blocking({
        let dataset = Arc::clone(&dataset);
        move || {
            let manifest = dataset.manifest()?;
            let bytes = crate::overview::overview(&dataset, &manifest)?;
            Ok((manifest, bytes))
        }
    })
    .await?;
    // Nobody waits for it: the page asks again.
    drop(tokio::task::spawn_blocking(move || dataset.gather_facts(&manifest)));
    Ok(hashed(bytes).to(&headers))
}

/// JSON that is made anew at each question.
fn hashed(bytes: Vec<u8>) -> Reply {
    let mut hasher = DefaultHasher::new();
    bytes.hash(&mut hasher);
    Reply { kind: JSON, etag: format!("\"{:x}\"", hasher.finish()), bytes }
}

pub(crate) async fn video(
    State(dataset): State<Arc<Dataset>>,
    Path(number): Path<u32>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let bytes = blocking(move || video_reply(&dataset, number)).await?;
    Ok(hashed(bytes).to(&headers))
}

fn video_reply(dataset: &Dataset, number: u32) -> Result<Vec<u8>, Refusal> {
    let video = dataset.video(number)?;
    let manifest = dataset.manifest()?;
    let rig_size = |name: &str| {
        let sensor = video.settings.sensors.iter().find(|sensor| sensor.name == name);
        sensor.and_then(|sensor| sensor.model.camera()).map(|camera| camera.size)
    };
    let views = video.cameras.iter().map(|camera| CameraReply {
        name: &camera.name,
        folder: &camera.folder,
        of_rig: camera.of_rig,
        every: camera.every,
        size: camera.of_rig.then(|| rig_size(&camera.name)).flatten().unwrap_or(video.settings.size),
        layers: camera.layers(&dataset.folder),
        has_objects: dataset.folder.stamp(&camera.layout.objects()).is_ok(),
        has_map: dataset.folder.stamp(&camera.layout.map()).is_ok(),
        camera: dataset.folder.json(&camera.layout.camera()).ok(),
    });
    let reply = VideoReply {
        video: number,
        name: &video.entry.name,
        state: video.entry.state,
        frames_there: video.frames_there(&dataset.folder, &manifest),
        rgb_format: manifest.recipe.rgb_format,
        has_actors: dataset.folder.stamp(&video.layout.actors()).is_ok(),
        scene: match &video.record {
            Some(scene) => Scene::Complete { scene },
            None => Scene::Planned { scene: &video.settings },
        },
        views: views.collect(),
    };
    serde_json::to_vec(&reply).map_err(|cause| Refusal::Damaged(cause.to_string()))
}

pub(crate) async fn timeline(
    State(dataset): State<Arc<Dataset>>,
    Path(number): Path<u32>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let bytes = blocking(move || {
        let timeline = dataset.timeline(number)?;
        serde_json::to_vec(timeline.as_ref()).map_err(|cause| Refusal::Damaged(cause.to_string()))
    });
    Ok(hashed(bytes.await?).to(&headers))
}

pub(crate) async fn actors(
    State(dataset): State<Arc<Dataset>>,
    Path(number): Path<u32>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let reply = blocking(move || {
        let path = dataset.video(number)?.layout.actors();
        file(&dataset, path)
    });
    Ok(reply.await?.to(&headers))
}

pub(crate) async fn map(
    State(dataset): State<Arc<Dataset>>,
    Path((number, camera)): Path<(u32, usize)>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let reply = blocking(move || {
        let path = dataset.video(number)?.camera(camera)?.layout.map();
        file(&dataset, path)
    });
    Ok(reply.await?.to(&headers))
}

/// A JSON file as it is.
#[expect(clippy::needless_pass_by_value, reason = "a path that was made for it")]
fn file(dataset: &Dataset, path: PathBuf) -> Result<Reply, Refusal> {
    let (bytes, stamp) = dataset.folder.read(&path)?;
    Ok(Reply { kind: JSON, etag: stamp.etag(), bytes })
}

pub(crate) async fn frames(
    State(dataset): State<Arc<Dataset>>,
    Path(number): Path<u32>,
    Query(range): Query<LineRange>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let reply = blocking(move || {
        let path = dataset.video(number)?.layout.frames();
        lines(&dataset, path, range)
    });
    Ok(reply.await?.to(&headers))
}

pub(crate) async fn objects(
    State(dataset): State<Arc<Dataset>>,
    Path((number, camera)): Path<(u32, usize)>,
    Query(range): Query<LineRange>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let reply = blocking(move || {
        let path = dataset.video(number)?.camera(camera)?.layout.objects();
        lines(&dataset, path, range)
    });
    Ok(reply.await?.to(&headers))
}

pub(crate) async fn poses(
    State(dataset): State<Arc<Dataset>>,
    Path((number, camera)): Path<(u32, usize)>,
    Query(range): Query<LineRange>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let reply = blocking(move || {
        let path = dataset.video(number)?.camera(camera)?.layout.poses();
        lines(&dataset, path, range)
    });
    Ok(reply.await?.to(&headers))
}

#[expect(clippy::needless_pass_by_value, reason = "a path that was made for it")]
fn lines(dataset: &Dataset, path: PathBuf, range: LineRange) -> Result<Reply, Refusal> {
    let (bytes, stamp) = dataset.lines(&path, range.from, range.count)?;
    Ok(Reply { kind: JSON, etag: stamp.etag(), bytes })
}
