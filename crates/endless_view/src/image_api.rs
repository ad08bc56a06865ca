//! Pictures: as they are stored, in colour, or small.

use crate::{
    dataset::Dataset,
    picture,
    refusal::Refusal,
    reply::{Reply, blocking, is_known},
};
use axum::{
    extract::{Path, State},
    http::HeaderMap,
    response::Response,
};
use endless_dataset::{Layer, RgbFormat};
use serde::Deserialize;
use std::sync::Arc;

/// Which image.
#[derive(Debug, Clone, Copy, Deserialize)]
pub(crate) struct ImagePlace {
    video: u32,
    camera: usize,
    layer: Layer,
    frame: u32,
}

/// What is made of an image.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shown {
    AsStored,
    InColor,
    Small,
}

/// As it is stored: what the pixels mean stands in the README.
pub(crate) async fn stored(
    State(dataset): State<Arc<Dataset>>,
    Path(place): Path<ImagePlace>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    answer(dataset, place, Shown::AsStored, headers).await
}

/// In colours for people.
pub(crate) async fn in_color(
    State(dataset): State<Arc<Dataset>>,
    Path(place): Path<ImagePlace>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    answer(dataset, place, Shown::InColor, headers).await
}

/// The first picture of a camera, small.
pub(crate) async fn thumbnail(
    State(dataset): State<Arc<Dataset>>,
    Path((video, camera)): Path<(u32, usize)>,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let place = ImagePlace { video, camera, layer: Layer::Rgb, frame: 0 };
    answer(dataset, place, Shown::Small, headers).await
}

async fn answer(
    dataset: Arc<Dataset>,
    place: ImagePlace,
    shown: Shown,
    headers: HeaderMap,
) -> Result<Response, Refusal> {
    let known = headers.clone();
    Ok(blocking(move || reply(&dataset, place, shown, &known)).await?.to(&headers))
}

fn reply(dataset: &Dataset, place: ImagePlace, shown: Shown, known: &HeaderMap) -> Result<Reply, Refusal> {
    let video = dataset.video(place.video)?;
    let format = dataset.manifest()?.recipe.rgb_format;
    let path = video.camera(place.camera)?.layout.frame(place.layer, place.frame, format);
    let etag = match shown {
        Shown::AsStored => dataset.folder.stamp(&path)?.etag(),
        Shown::InColor => dataset.folder.stamp(&path)?.etag().replacen('"', "\"c", 1),
        Shown::Small => dataset.folder.stamp(&path)?.etag().replacen('"', "\"s", 1),
    };
    let kind = match (shown, place.layer.format(format)) {
        (Shown::Small, _) | (Shown::AsStored, RgbFormat::Jpg) => "image/jpeg",
        (Shown::InColor, _) | (_, RgbFormat::Png) => "image/png",
    };
    if is_known(known, &etag) {
        return Ok(Reply { kind, etag, bytes: Vec::new() });
    }
    let (bytes, _) = dataset.folder.read(&path)?;
    let damaged = |reason: String| Refusal::damaged(&path, reason);
    let bytes = match shown {
        Shown::AsStored => bytes,
        Shown::InColor => picture::in_color(&bytes, place.layer, format).map_err(damaged)?,
        Shown::Small => picture::small(&bytes, place.layer, format).map_err(damaged)?,
    };
    Ok(Reply { kind, etag, bytes })
}
