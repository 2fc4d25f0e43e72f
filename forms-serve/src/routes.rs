//! Routes: paths and their handlers.

use crate::guard::guard;
use crate::reply::{json, nothing, refusal};
use crate::work::{NoAnswer, Workers};
use crate::{Opened, Words, book, gallery, site};
use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::{Path, State};
use axum::http::{HeaderMap, StatusCode, header};
use axum::middleware::from_fn;
use axum::response::{Redirect, Response};
use axum::routing::{get, post};
use serde_json::json as value;
use std::sync::Arc;
use std::time::Duration;
use tokio::time::timeout;

/// Longest accepted request, in bytes.
const LONGEST_REQUEST: usize = 256 << 10;
/// Time limit for the arrival of a request.
const ARRIVAL: Duration = Duration::from_secs(10);
/// Tasks of the workers.
const TASKS: [&str; 4] = ["check", "derive", "emit", "plot"];

/// Returns all routes, protected by the guard.
pub(crate) fn routes(workers: Arc<Workers>, opened: Option<Opened>, words: Words) -> Router {
    let opened = opened.map(|Opened { name, text }| value!({ "name": name, "text": text }));
    let start = value!({ "opened": opened, "examples": site::examples(), "words": words });
    Router::new()
        .route("/", get(async || site::editor()))
        .route("/page/{*name}", get(async |Path(name): Path<String>| site::file(&name)))
        .route("/gallery", get(async || Redirect::permanent("/gallery/")))
        .route("/book", get(async || Redirect::permanent("/book/")))
        .route("/gallery/", get(async || gallery::gallery("")))
        .route("/gallery/{*path}", get(async |Path(path): Path<String>| gallery::gallery(&path)))
        .route("/book/", get(async || book::book(String::new()).await))
        .route("/book/{*path}", get(async |Path(path): Path<String>| book::book(path).await))
        .route("/api/start", get(async move || json(&start)))
        .route("/api/{task}", post(work))
        .fallback(async || nothing())
        .layer(from_fn(guard))
        .with_state(workers)
}

/// Whether a request declares, exactly once, that it is JSON.
fn is_json(headers: &HeaderMap) -> bool {
    let mut kinds = headers.get_all(header::CONTENT_TYPE).iter();
    let (Some(kind), None) = (kinds.next(), kinds.next()) else { return false };
    let kind = kind.to_str().unwrap_or_default();
    let essence = kind.split(';').next().unwrap_or_default().trim();
    essence.eq_ignore_ascii_case("application/json")
}

/// Lets a worker process answer a request.
async fn work(
    State(workers): State<Arc<Workers>>,
    Path(task): Path<String>,
    headers: HeaderMap,
    body: Body,
) -> Response {
    let Some(task) = TASKS.into_iter().find(|known| *known == task) else { return nothing() };
    if !is_json(&headers) {
        return refusal(
            StatusCode::UNSUPPORTED_MEDIA_TYPE,
            "a request must be a JSON object of type application/json",
        );
    }
    let request = match timeout(ARRIVAL, to_bytes(body, LONGEST_REQUEST)).await {
        Ok(Ok(request)) => request,
        Ok(Err(_)) => {
            let reason = format!("a request must be shorter than {} KiB", LONGEST_REQUEST >> 10);
            return refusal(StatusCode::PAYLOAD_TOO_LARGE, &reason);
        }
        Err(_) => return refusal(StatusCode::REQUEST_TIMEOUT, "the request took too long to arrive"),
    };
    if let Err(error) = serde_json::from_slice::<serde_json::Map<String, serde_json::Value>>(&request) {
        return refusal(StatusCode::BAD_REQUEST, &format!("the request is not a JSON object: {error}"));
    }
    match workers.answer(task, &request).await {
        // A refusal by the task means that the request does not have the expected fields.
        Ok(answer) => match answer.get("refusal").and_then(serde_json::Value::as_str) {
            Some(reason) => refusal(StatusCode::BAD_REQUEST, reason),
            None => json(&answer),
        },
        Err(NoAnswer::Busy) => {
            let reason = "the server is busy; try again in a few seconds";
            refusal(StatusCode::SERVICE_UNAVAILABLE, reason)
        }
        Err(NoAnswer::Broken(error)) => {
            refusal(StatusCode::INTERNAL_SERVER_ERROR, &format!("cannot start a worker process: {error}"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use axum::http::HeaderValue;

    #[test]
    fn json_is_said_once_and_in_full() {
        let said = |kinds: &[&'static str]| {
            let mut headers = HeaderMap::new();
            for kind in kinds {
                headers.append(header::CONTENT_TYPE, HeaderValue::from_static(kind));
            }
            is_json(&headers)
        };
        for kind in ["application/json", "application/json; charset=utf-8", "Application/JSON ;x=y"] {
            assert!(said(&[kind]), "{kind}");
        }
        for kind in ["application/jsonfoo", "application/json-seq", "text/json", "", "application/ json"] {
            assert!(!said(&[kind]), "{kind}");
        }
        assert!(!said(&[]) && !said(&["application/json", "application/json"]));
    }
}
