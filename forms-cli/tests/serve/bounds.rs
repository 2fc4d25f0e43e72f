//! Limits and refusals: time, size, other sites, and everything outside the page.

use crate::server::{Server, command};
use serde_json::json;
use std::io::{Read, Write};
use std::net::{TcpListener, TcpStream};
use std::time::Duration;

const SIMPLE: &str = "prove two: 1 + 1 == 2;";

/// Returns statements that take hours together: sums of roots, whose powers are multiplied out in
/// each statement.
fn endless() -> String {
    let names = ["a", "b", "c", "d", "e", "f"];
    let roots: Vec<String> = names.iter().map(|name| format!("sqrt({name})")).collect();
    let conditions: Vec<String> = names.iter().map(|name| format!("{name} > 0")).collect();
    let mut text = format!("chart L({}) where {};\n", names.join(", "), conditions.join(", "));
    text += &format!("let s = {} + sqrt(a + b) + sqrt(c + d) + sqrt(e + f);\n", roots.join(" + "));
    for number in 1..=1500 {
        text += &format!("prove e{number}: s**11/(s**10 + {number}) == s - {number}*s/(s**10 + {number});\n");
    }
    text
}

#[test]
fn an_endless_computation_is_stopped_and_others_are_answered_meanwhile() {
    let server = Server::start(&["--time-limit", "8"]);
    std::thread::scope(|scope| {
        let endless = scope.spawn(|| server.check(&format!("{SIMPLE}\n{}", endless())));
        // Its process has started by then.
        std::thread::sleep(Duration::from_millis(500));
        let answer = server.check(SIMPLE);
        assert_eq!(answer["verdicts"][0]["verdict"], "proved", "{answer}");
        assert!(!endless.is_finished(), "the other answer was not waited for");
        let answer = endless.join().expect("an answer");
        assert!(
            answer["stopped"].as_str().is_some_and(|text| text.contains("stopped after 8 s")),
            "{answer}"
        );
        assert_eq!(answer["verdicts"][0]["name"], "two", "what was decided before is told: {answer}");
        let count = |key: &str| answer[key].as_array().map_or(0, Vec::len);
        assert!(count("verdicts") < count("statements"), "{} are decided", count("verdicts"));
    });
}

#[test]
fn many_clients_at_once_are_all_answered_or_told_to_come_again() {
    let server = Server::start(&[]);
    let request = json!({ "text": SIMPLE });
    let replies: Vec<u16> = std::thread::scope(|scope| {
        let client = || scope.spawn(|| server.post("/api/check", &request).status);
        let clients: Vec<_> = std::iter::repeat_with(client).take(100).collect();
        clients.into_iter().map(|client| client.join().expect("a reply")).collect()
    });
    assert!(replies.iter().all(|status| [200, 503].contains(status)), "{replies:?}");
    assert!(replies.iter().filter(|&&status| status == 200).count() >= 2, "{replies:?}");
}

#[test]
fn a_queue_that_is_full_answers_503_and_has_room_again_when_its_clients_have_gone() {
    let server = Server::start(&["--time-limit", "60"]);
    let request = server.request("/api/check", "", &json!({ "text": endless() }).to_string());
    // More clients than the queue holds, which do not wait for their answers.
    let mut clients: Vec<TcpStream> = (0..70)
        .map(|_| {
            let mut stream = TcpStream::connect(server.address).expect("a connection");
            stream.set_read_timeout(Some(Duration::from_millis(20))).expect("a time");
            stream.write_all(request.as_bytes()).expect("the request is sent");
            stream
        })
        .collect();
    let mut answer = [0; 4096];
    let answered = (0..2000).find_map(|turn| clients[turn % 70].read(&mut answer).ok());
    let refused =
        String::from_utf8_lossy(&answer[..answered.expect("a client that is told at once")]).into_owned();
    assert!(refused.starts_with("HTTP/1.1 503") && refused.contains("try again"), "{refused}");
    // Their work is cancelled long before the time limit.
    drop(clients);
    let answers = (0..200).map(|_| {
        std::thread::sleep(Duration::from_millis(50));
        server.post("/api/check", &json!({ "text": SIMPLE })).json()
    });
    let answer = answers.into_iter().find(|answer| answer["refusal"].is_null()).expect("room for work");
    assert_eq!(answer["verdicts"][0]["verdict"], "proved", "{answer}");
}

#[test]
fn nothing_outside_the_page_is_served() {
    let server = Server::start(&[]);
    for path in [
        "/../../etc/passwd",
        "/page/../../../../etc/passwd",
        "/gallery/../../../etc/passwd",
        "/gallery/%2e%2e/%2e%2e/Cargo.toml",
        "/book/..%2f..%2f..%2fCargo.toml",
        "/page//etc/passwd",
        "/page/index.html",
        "/page/",
        "/api/simulate",
        "/etc/passwd",
    ] {
        let reply = server.get(path);
        assert!([404, 405].contains(&reply.status), "{path}: {} {}", reply.status, reply.body);
        assert!(!reply.body.contains("root:") && !reply.body.contains("[workspace]"), "{path}");
    }
}

#[test]
fn a_huge_request_is_refused() {
    let server = Server::start(&[]);
    let reply = server.post("/api/check", &json!({ "text": " ".repeat(300 << 10) }));
    assert_eq!(reply.status, 413, "{}", reply.body);
    assert!(reply.body.contains("256 KiB"), "{}", reply.body);
    assert_eq!(server.check(&" ".repeat(200 << 10))["stopped"], serde_json::Value::Null);
}

#[test]
fn a_text_that_is_nested_without_end_is_an_error_like_any_other() {
    let server = Server::start(&[]);
    let nested = format!("let x = {}1{};", "(".repeat(100_000), ")".repeat(100_000));
    assert!(server.check(&nested)["diagnostics"].is_array());
    assert_eq!(server.check(SIMPLE)["verdicts"][0]["ok"], true);
}

/// Starts a worker process with these limits that waits for its request.
#[cfg(target_os = "linux")]
fn worker(seconds: &str, mebibytes: &str) -> std::process::Child {
    std::process::Command::new(env!("CARGO_BIN_EXE_forms"))
        .args(["work", "--seconds", seconds, "--mebibytes", mebibytes, "check"])
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::null())
        .spawn()
        .expect("the program starts")
}

#[test]
#[cfg(target_os = "linux")]
fn a_process_whose_processor_time_is_over_is_ended_by_the_system() {
    let mut child = worker("1", "2048");
    let mut input = child.stdin.take().expect("a pipe");
    let _ = input.write_all(json!({ "text": endless() }).to_string().as_bytes());
    drop(input);
    assert_eq!(child.wait().expect("the program ends").code(), None);
}

#[test]
#[cfg(target_os = "linux")]
fn the_system_grants_a_process_the_memory_it_was_told_and_no_more() {
    let mut child = worker("60", "1000");
    let limits = || std::fs::read_to_string(format!("/proc/{}/limits", child.id())).unwrap_or_default();
    let is_bounded = (0..400).any(|_| {
        std::thread::sleep(Duration::from_millis(25));
        limits().lines().any(|line| line.starts_with("Max address space") && line.contains("1048576000"))
    });
    assert!(is_bounded, "{}", limits());
    drop(child.stdin.take());
    assert!(child.wait().expect("the program ends").success());
}

#[test]
fn other_hosts_and_other_sites_are_refused() {
    let server = Server::start(&[]);
    let port = server.address.port();
    let get = |host: &str| {
        server.send(&format!("GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n")).status
    };
    assert_eq!(get("evil.example"), 403);
    assert_eq!(get(&format!("localhost.evil.example:{port}")), 403);
    assert_eq!(get(&format!("localhost:{port}")), 200);

    let body = json!({ "text": SIMPLE }).to_string();
    let post = |head: &str| server.send(&server.request("/api/check", head, &body)).status;
    assert_eq!(post("Origin: http://evil.example\r\n"), 403);
    assert_eq!(post("Origin: null\r\n"), 403);
    assert_eq!(post(&format!("Origin: http://127.0.0.1:{}\r\n", port.wrapping_add(1))), 403);
    assert_eq!(post(&format!("Origin: http://127.0.0.1:{port}\r\n")), 200);
    // Requests that other sites can send without permission are not JSON.
    let request = server.request("/api/check", "", &body).replace("application/json", "text/plain");
    assert_eq!(server.send(&request).status, 415);
}

#[test]
fn every_reply_has_the_headers_that_forbid_what_the_page_does_not_need() {
    let server = Server::start(&[]);
    for path in ["/", "/page/main.js", "/gallery/", "/book/", "/nothing"] {
        let head = server.get(path).head;
        for header in [
            "content-security-policy: default-src 'self'",
            "x-content-type-options: nosniff",
            "referrer-policy: no-referrer",
            "cross-origin-resource-policy: same-origin",
        ] {
            assert!(head.contains(header), "{path} without {header}: {head}");
        }
    }
}

#[test]
fn a_port_that_is_taken_is_an_error_that_says_what_to_do() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port().to_string();
    let output = command(&["--port", &port]).output().expect("the program ends");
    assert_eq!(output.status.code(), Some(2));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.contains(&port) && errors.contains("is in use") && errors.contains("--port"), "{errors}");
}

#[test]
fn a_file_that_cannot_be_read_is_an_error_that_names_it() {
    let output = command(&["--port", "0", "no/such.forms"]).output().expect("the program ends");
    assert_eq!(output.status.code(), Some(2));
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(errors.contains("no/such.forms") && errors.contains("cannot read the file"), "{errors}");
}

#[test]
fn connections_that_say_nothing_keep_nobody_waiting() {
    let server = Server::start(&[]);
    let silent: Vec<TcpStream> =
        (0..300).map(|_| TcpStream::connect(server.address).expect("a connection")).collect();
    let answer = server.check(SIMPLE);
    assert_eq!(answer["verdicts"][0]["verdict"], "proved", "{answer}");
    // The server did not wait for the silent connections to time out: the youngest of these
    // connections still exist.
    let mut youngest = silent.last().expect("a connection");
    youngest.set_nonblocking(true).expect("a setting");
    let read = youngest.read(&mut [0; 64]);
    assert_eq!(read.map_err(|error| error.kind()), Err(std::io::ErrorKind::WouldBlock));
}

#[test]
fn hard_work_keeps_a_simple_question_waiting_for_a_moment_only() {
    let server = Server::start(&["--time-limit", "8"]);
    let hard = endless();
    std::thread::scope(|scope| {
        let all: Vec<_> = (0..10).map(|_| scope.spawn(|| server.check(&hard))).collect();
        std::thread::sleep(Duration::from_millis(1500));
        let answer = server.check(SIMPLE);
        assert_eq!(answer["verdicts"][0]["verdict"], "proved", "{answer}");
        assert!(all.iter().all(|hard| !hard.is_finished()), "none of the others was waited for");
    });
}

#[test]
fn what_is_no_request_is_refused() {
    let server = Server::start(&[]);
    let host = server.address;
    let ask = |headers: &str, body: &str| {
        let length = body.len();
        let head = format!(
            "POST /api/check HTTP/1.1\r\n{headers}Content-Length: {length}\r\nConnection: close\r\n\r\n"
        );
        let mut stream = TcpStream::connect(host).expect("a connection");
        stream.write_all((head + body).as_bytes()).expect("it reads");
        let mut reply = String::new();
        stream.read_to_string(&mut reply).expect("a reply");
        reply.split(' ').nth(1).and_then(|status| status.parse::<u16>().ok()).expect("a status")
    };
    let json = "Content-Type: application/json\r\n";
    let one = format!("Host: {host}\r\n");
    let right = "{\"text\":\"prove p: 1 == 1;\"}";
    assert_eq!(ask(&format!("{one}{json}"), right), 200);
    assert_eq!(ask(&format!("{one}{one}{json}"), right), 400);
    assert_eq!(ask(&format!("{one}Host: localhost\r\n{json}"), right), 400);
    assert_eq!(ask(&format!("{one}Content-Type: application/jsonfoo\r\n"), right), 415);
    for malformed in
        ["", "{", "[]", "1", "{\"text\":}", "{\"text\":\"a\"", "{\"texts\":\"a\"}", "{\"text\":1}", "\u{1}"]
    {
        assert_eq!(ask(&format!("{one}{json}"), malformed), 400, "{malformed}");
    }
}
