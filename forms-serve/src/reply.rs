//! Replies: a body with its media type, or a refusal with its reason.

use axum::body::Body;
use axum::http::{HeaderValue, StatusCode, header};
use axum::response::Response;

/// Media type of pictures that can contain styles.
const PICTURE: &str = "image/svg+xml";
/// Content security policy of such a picture when it is opened directly: its own styles are
/// allowed, and nothing else.
const POLICY_OF_PICTURES: &str = "default-src 'none'; style-src 'unsafe-inline'; sandbox";

/// Content security policy of a page with its own styles.
const POLICY_OF_PAGES_WITH_STYLES: &str = "default-src 'self'; script-src 'none'; style-src 'self' 'unsafe-inline'; \
     base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'";

/// Returns the media type of a file, by the extension of its name.
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

/// Builds a reply with a body of this media type.
pub(crate) fn reply(kind: &'static str, body: impl Into<Body>) -> Response {
    let mut response = Response::new(body.into());
    response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    if kind == PICTURE {
        let policy = HeaderValue::from_static(POLICY_OF_PICTURES);
        response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    response
}

/// Builds a reply with an HTML page.
pub(crate) fn page(html: String) -> Response {
    reply(kind(".html"), html)
}

/// Builds a reply with a page that contains its own styles, and no scripts.
pub(crate) fn page_with_styles(html: String) -> Response {
    let mut response = page(html);
    let policy = HeaderValue::from_static(POLICY_OF_PAGES_WITH_STYLES);
    response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    response
}

/// Builds a reply with JSON.
pub(crate) fn json(value: &serde_json::Value) -> Response {
    reply(kind(".json"), value.to_string())
}

/// Builds a refusal with a reason for human readers.
pub(crate) fn refusal(status: StatusCode, reason: &str) -> Response {
    let mut response = json(&serde_json::json!({ "refusal": reason }));
    *response.status_mut() = status;
    response
}

/// Builds the reply for a missing page.
pub(crate) fn nothing() -> Response {
    let mut response = reply(kind(".txt"), "There is no such page. The editor is at /\n");
    *response.status_mut() = StatusCode::NOT_FOUND;
    response
}
