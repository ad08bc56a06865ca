//! What stands before every request, and on every answer.

use crate::{host::is_own, refusal::Refusal};
use axum::{
    body::Body,
    extract::State,
    http::{HeaderName, HeaderValue, Method, Request, header},
    middleware::Next,
    response::{IntoResponse, Response},
};
use std::net::IpAddr;

/// Scripts, styles and data of this server alone; `blob:` and `data:` are pictures that the page itself makes.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; \
                      connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

const HEADERS: [(HeaderName, &str); 6] = [
    (header::CONTENT_SECURITY_POLICY, POLICY),
    (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
    (header::X_FRAME_OPTIONS, "DENY"),
    (header::REFERRER_POLICY, "no-referrer"),
    (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
];

/// Lets requests pass that only read, and come under a name of this machine.
pub(crate) async fn guard(State(bound): State<IpAddr>, request: Request<Body>, next: Next) -> Response {
    let mut response = match refused(&request, bound) {
        Some(refusal) => refusal.into_response(),
        None => next.run(request).await,
    };
    for (name, value) in HEADERS {
        response.headers_mut().insert(name, HeaderValue::from_static(value));
    }
    response
}

fn refused(request: &Request<Body>, bound: IpAddr) -> Option<Refusal> {
    const NAME: Refusal = Refusal::Foreign("this name is not answered: use the address that endless view prints");
    let mut hosts = request.headers().get_all(header::HOST).iter();
    let (Some(host), None) = (hosts.next(), hosts.next()) else {
        return Some(Refusal::Bad("one header Host is needed".into()));
    };
    let own = host.to_str().is_ok_and(|host| is_own(host, bound));
    let target = request.uri().authority().is_none_or(|authority| is_own(authority.as_str(), bound));
    if !own || !target {
        return Some(NAME);
    }
    if !matches!(*request.method(), Method::GET | Method::HEAD) {
        return Some(Refusal::Method);
    }
    // A browser tells when another site's page asks. A link to the page itself is fine.
    let site = request.headers().get("sec-fetch-site").map(HeaderValue::as_bytes);
    if matches!(site, Some(b"cross-site" | b"same-site")) && request.uri().path() != "/" {
        return Some(Refusal::Foreign("pages of other sites get no data"));
    }
    None
}
