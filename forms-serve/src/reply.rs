//! Replies: a body with its kind, or a refusal with its reason.

use axum::body::Body;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::Response;

/// The kind of pictures that can hold styles of their own.
const PICTURE: &str = "image/svg+xml";
/// What such a picture may do where it is looked at by itself: have its styles, and nothing else.
const POLICY_OF_PICTURES: &str = "default-src 'none'; style-src 'unsafe-inline'; sandbox";

/// What a page may do that brings its own styles.
const POLICY_OF_PAGES_WITH_STYLES: &str = "default-src 'self'; script-src 'none'; style-src 'self' 'unsafe-inline'; \
     base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'";

/// The kind of a file, by the ending of its name.
pub(crate) fn kind(name: &str) -> &'static str {
    match name.rsplit_once('.').map_or("", |(_, ending)| ending) {
        "html" => "text/html; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "json" => "application/json",
        "svg" => PICTURE,
        "png" => "image/png",
        _ => "text/plain; charset=utf-8",
    }
}

/// A body of that kind.
pub(crate) fn reply(kind: &'static str, body: impl Into<Body>) -> Response {
    let mut response = Response::new(body.into());
    response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    if kind == PICTURE {
        let policy = HeaderValue::from_static(POLICY_OF_PICTURES);
        response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    response
}

/// An HTML page.
pub(crate) fn page(html: String) -> Response {
    reply(kind(".html"), html)
}

/// A page that brings its own styles, and no scripts.
pub(crate) fn page_with_styles(html: String) -> Response {
    let mut response = page(html);
    let policy = HeaderValue::from_static(POLICY_OF_PAGES_WITH_STYLES);
    response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    response
}

/// JSON.
pub(crate) fn json(value: &serde_json::Value) -> Response {
    reply(kind(".json"), value.to_string())
}

/// A refusal, with a reason for people.
pub(crate) fn refusal(status: StatusCode, reason: &str) -> Response {
    let mut response = json(&serde_json::json!({ "refusal": reason }));
    *response.status_mut() = status;
    response
}

/// There is no such page.
pub(crate) fn nothing() -> Response {
    let mut response = reply(kind(".txt"), "There is no such page. The editor is at /\n");
    *response.status_mut() = StatusCode::NOT_FOUND;
    response
}
