//! Which request gets which answer.

use crate::{dataset::Dataset, guard::guard, image_api, page, refusal::Refusal, video_api};
use axum::{Router, middleware, routing::get};
use std::{net::IpAddr, sync::Arc};

/// All answers of a server that listens at `bound`.
pub(crate) fn router(dataset: Arc<Dataset>, bound: IpAddr) -> Router {
    let api = Router::new()
        .route("/dataset", get(video_api::overview))
        .route("/videos/{video}", get(video_api::video))
        .route("/videos/{video}/timeline", get(video_api::timeline))
        .route("/videos/{video}/actors", get(video_api::actors))
        .route("/videos/{video}/frames", get(video_api::frames))
        .route("/videos/{video}/cameras/{camera}/map", get(video_api::map))
        .route("/videos/{video}/cameras/{camera}/objects", get(video_api::objects))
        .route("/videos/{video}/cameras/{camera}/poses", get(video_api::poses))
        .route("/videos/{video}/cameras/{camera}/thumbnail", get(image_api::thumbnail))
        .route("/videos/{video}/cameras/{camera}/images/{layer}/{frame}", get(image_api::stored))
        .route("/videos/{video}/cameras/{camera}/pictures/{layer}/{frame}", get(image_api::in_color))
        .with_state(dataset);
    let nothing = || async { Refusal::Missing("such page".into()) };
    Router::new()
        .merge(page::routes())
        .nest("/api", api)
        .fallback(nothing)
        .layer(middleware::from_fn_with_state(bound, guard))
}
