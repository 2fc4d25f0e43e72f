//! Origin checks: requests that another site made a browser send are refused, and every reply
//! forbids all features that it does not need.
//!
//! A page of another site can have its own name point to this machine (DNS rebinding) and then read
//! replies as its own. Its requests name that site as their `Host`. Therefore only `localhost` and
//! IP addresses are served: no other site can own them. Such a page can also send requests here
//! without reading the replies; browsers then name the site as the `Origin`, which must equal the
//! host.

use crate::reply::refusal;
use axum::extract::Request;
use axum::http::uri::Authority;
use axum::http::{HeaderMap, HeaderValue, StatusCode, header};
use axum::middleware::Next;
use axum::response::Response;
use std::net::IpAddr;

/// Security headers of all replies.
const HEADERS: [(&str, &str); 6] = [
    (
        "content-security-policy",
        "default-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'",
    ),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cache-control", "no-store"),
];

/// Refuses the requests of other sites and adds the headers to every reply.
pub(crate) async fn guard(request: Request, next: Next) -> Response {
    let mut response = match objection(request.headers()) {
        _ if is_said_twice(request.headers()) => {
            refusal(StatusCode::BAD_REQUEST, "a request must name its host and its origin only once")
        }
        Some(reason) => refusal(StatusCode::FORBIDDEN, reason),
        None => next.run(request).await,
    };
    for (name, value) in HEADERS {
        // A reply can have its own policy.
        response.headers_mut().entry(name).or_insert(HeaderValue::from_static(value));
    }
    response
}

/// Whether a request names several hosts or origins: one program might use the first and another
/// program the last.
fn is_said_twice(headers: &HeaderMap) -> bool {
    [header::HOST, header::ORIGIN].iter().any(|name| headers.get_all(name).iter().count() > 1)
}

/// Returns the reason to refuse a request, if there is one.
fn objection(headers: &HeaderMap) -> Option<&'static str> {
    let text = |name| headers.get(name).map(|value: &HeaderValue| value.to_str().unwrap_or_default());
    let Some(host) = text(header::HOST).filter(|host| is_of_this_machine(host)) else {
        return Some(
            "this page is served only as localhost or by its IP address; open it at http://localhost or at the address",
        );
    };
    let is_foreign = text(header::ORIGIN).is_some_and(|origin| origin.strip_prefix("http://") != Some(host));
    is_foreign.then_some("this request comes from another site")
}

/// Whether a host is `localhost` or an IP address, with or without a port.
fn is_of_this_machine(host: &str) -> bool {
    let Ok(authority) = host.parse::<Authority>() else { return false };
    let name = authority.host();
    let address = name.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')).unwrap_or(name);
    !host.contains('@') && (name.eq_ignore_ascii_case("localhost") || address.parse::<IpAddr>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_host_is_named_once() {
        let mut headers = HeaderMap::new();
        headers.append(header::HOST, HeaderValue::from_static("localhost"));
        assert!(!is_said_twice(&headers));
        headers.append(header::HOST, HeaderValue::from_static("localhost"));
        assert!(is_said_twice(&headers));
    }

    #[test]
    fn this_machine_is_localhost_or_an_address() {
        for host in ["localhost", "localhost:4177", "127.0.0.1:80", "[::1]:4177", "192.168.0.7", "LOCALHOST"]
        {
            assert!(is_of_this_machine(host), "{host}");
        }
        for host in [
            "",
            "evil.example",
            "localhost.evil.example:4177",
            "127.0.0.1.evil.example",
            "me@localhost",
            "a b",
        ] {
            assert!(!is_of_this_machine(host), "{host}");
        }
    }
}
