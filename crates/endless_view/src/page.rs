//! The page: files that the program holds.

use crate::reply::Reply;
use axum::{Router, http::HeaderMap, routing::get};

macro_rules! page_files {
    ($($name:literal $kind:ident),* $(,)?) => {
        &[$(PageFile {
            path: concat!("/", $name),
            kind: $kind,
            bytes: include_bytes!(concat!("../page/", $name)),
        }),*]
    };
}

/// A file of the page.
#[derive(Debug, Clone, Copy)]
struct PageFile {
    path: &'static str,
    kind: &'static str,
    bytes: &'static [u8],
}

const HTML: &str = "text/html; charset=utf-8";
const CSS: &str = "text/css; charset=utf-8";
const SCRIPT: &str = "text/javascript; charset=utf-8";
const SVG: &str = "image/svg+xml";

const FILES: &[PageFile] = page_files![
    "api.js" SCRIPT,
    "colors.js" SCRIPT,
    "dataset.js" SCRIPT,
    "dom.js" SCRIPT,
    "filters.js" SCRIPT,
    "help.js" SCRIPT,
    "icon.svg" SVG,
    "index.html" HTML,
    "inspector.js" SCRIPT,
    "labels.js" SCRIPT,
    "list.css" CSS,
    "list.js" SCRIPT,
    "main.js" SCRIPT,
    "masks.js" SCRIPT,
    "overlays.js" SCRIPT,
    "pictures.js" SCRIPT,
    "place.js" SCRIPT,
    "player.css" CSS,
    "player.js" SCRIPT,
    "scene_panel.js" SCRIPT,
    "style.css" CSS,
    "theme.js" SCRIPT,
    "timeline.js" SCRIPT,
    "transport.js" SCRIPT,
    "view.js" SCRIPT,
    "world_map.js" SCRIPT,
];

/// The routes of all files; `/` is `index.html`.
pub(crate) fn routes<S: Clone + Send + Sync + 'static>() -> Router<S> {
    let mut router = Router::new();
    for file in FILES {
        let answer = move |headers: HeaderMap| async move {
            let PageFile { kind, bytes, .. } = *file;
            // Another build is another page: its length and sum tell it.
            let etag = format!("\"{:x}-{:x}\"", bytes.len(), sum(bytes));
            Reply { kind, etag, bytes: bytes.to_vec() }.to(&headers)
        };
        let path = if file.path == "/index.html" { "/" } else { file.path };
        router = router.route(path, get(answer));
    }
    router
}

/// FNV-1a.
fn sum(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
