//! Answers with data.

use crate::refusal::Refusal;
use axum::{
    http::{HeaderMap, StatusCode, header},
    response::{IntoResponse, Response},
};

/// Bytes that a browser may keep, as long as it asks whether they are still the same.
#[derive(Debug)]
pub(crate) struct Reply {
    pub(crate) kind: &'static str,
    pub(crate) etag: String,
    pub(crate) bytes: Vec<u8>,
}

pub(crate) const JSON: &str = "application/json";

impl Reply {
    /// The answer, or that nothing has changed since the browser last asked.
    pub(crate) fn to(self, request: &HeaderMap) -> Response {
        let Self { kind, etag, bytes } = self;
        let headers = [(header::ETAG, etag.as_str()), (header::CACHE_CONTROL, "no-cache")];
        if is_known(request, &etag) {
            return (StatusCode::NOT_MODIFIED, headers).into_response();
        }
        (headers, [(header::CONTENT_TYPE, kind)], bytes).into_response()
    }
}

/// Whether the browser has what has this tag.
pub(crate) fn is_known(request: &HeaderMap, etag: &str) -> bool {
    let known = request.get(header::IF_NONE_MATCH).and_then(|value| value.to_str().ok());
    known.is_some_and(|known| known.split(',').any(|tag| tag.trim().trim_start_matches("W/") == etag))
}

/// Reads files on a thread where that may take its time.
pub(crate) async fn blocking<T: Send + 'static>(
    work: impl FnOnce() -> Result<T, Refusal> + Send + 'static,
) -> Result<T, Refusal> {
    match tokio::task::spawn_blocking(work).await {
        Ok(result) => result,
        Err(_it_ends) => Err(Refusal::Damaged("the answer could not be made".into())),
    }
}
