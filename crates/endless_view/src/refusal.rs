//! Why a request is not answered with what it asks for.

use axum::{
    http::{StatusCode, header},
    response::{IntoResponse, Response},
};
use std::path::Path;

/// A request that gets no data. Each becomes one line of text and a status of HTTP.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub(crate) enum Refusal {
    /// There is no such video, camera, frame or file, or not yet.
    #[error("there is no {0}")]
    Missing(String),
    /// The request is not one that can be understood.
    #[error("{0}")]
    Bad(String),
    /// Under a name that is not this machine's, or from another site's page.
    #[error("{0}")]
    Foreign(&'static str),
    /// Something other than reading.
    #[error("only GET and HEAD are answered")]
    Method,
    /// A file of the dataset is not what it should be.
    #[error("{0}")]
    Damaged(String),
}

impl Refusal {
    /// The file is not there, cannot be read, or must not be.
    pub(crate) fn missing_file(path: &Path) -> Self {
        Self::Missing(format!("file {}", short(path)))
    }

    /// The file is there but is not what it should be.
    pub(crate) fn damaged(path: &Path, reason: impl std::fmt::Display) -> Self {
        Self::Damaged(format!("{}: {reason}", short(path)))
    }

    fn status(&self) -> StatusCode {
        match self {
            Self::Missing(_) => StatusCode::NOT_FOUND,
            Self::Bad(_) => StatusCode::BAD_REQUEST,
            Self::Foreign(_) => StatusCode::FORBIDDEN,
            Self::Method => StatusCode::METHOD_NOT_ALLOWED,
            Self::Damaged(_) => StatusCode::INTERNAL_SERVER_ERROR,
        }
    }
}

/// The last two parts of a path: where a dataset lies on the disk is nobody's concern.
fn short(path: &Path) -> String {
    let parts: Vec<_> = path.components().rev().take(2).map(|part| part.as_os_str().to_string_lossy()).collect();
    parts.into_iter().rev().collect::<Vec<_>>().join("/")
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let headers = [(header::CONTENT_TYPE, "text/plain; charset=utf-8"), (header::CACHE_CONTROL, "no-store")];
        (self.status(), headers, format!("{self}\n")).into_response()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_are_told_without_where_the_dataset_lies() {
        let refusal = Refusal::missing_file(Path::new("/home/somebody/out/videos/0000/camera_a/camera.json"));
        assert_eq!(refusal.to_string(), "there is no file camera_a/camera.json");
    }
}
