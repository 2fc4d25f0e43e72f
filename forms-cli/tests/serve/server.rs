//! The server under test, and a client that sends exactly the bytes of a test.

use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// Time limit of any reply.
const PATIENCE: Duration = Duration::from_secs(120);

/// `forms serve` on a free port, for the duration of its test.
pub(crate) struct Server {
    child: Child,
    pub(crate) address: SocketAddr,
}

/// Reply of the server.
pub(crate) struct Reply {
    pub(crate) status: u16,
    pub(crate) head: String,
    pub(crate) body: String,
}

impl Reply {
    pub(crate) fn json(&self) -> Value {
        serde_json::from_str(&self.body).unwrap_or_else(|error| panic!("{error}: {}", self.body))
    }
}

/// Returns the command `forms serve` with these arguments.
pub(crate) fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_forms"));
    command.arg("serve").args(arguments).stdin(Stdio::null());
    command
}

impl Server {
    pub(crate) fn start(arguments: &[&str]) -> Self {
        let mut child = command(&[&["--port", "0"], arguments].concat())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut line = String::new();
        let output = child.stdout.take().expect("a pipe");
        BufReader::new(output).read_line(&mut line).expect("a line");
        let address = line.strip_prefix("http://").and_then(|rest| rest.split('/').next());
        let address =
            address.and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("no address: {line}"));
        Server { child, address }
    }

    pub(crate) fn get(&self, path: &str) -> Reply {
        let host = self.address;
        self.send(&format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n"))
    }

    /// Sends a request to the workers.
    pub(crate) fn post(&self, path: &str, request: &Value) -> Reply {
        self.send(&self.request(path, "", &request.to_string()))
    }

    /// Returns the workers' answer for a text.
    pub(crate) fn check(&self, text: &str) -> Value {
        let reply = self.post("/api/check", &serde_json::json!({ "text": text }));
        assert_eq!(reply.status, 200, "{}", reply.body);
        reply.json()
    }

    /// Returns the text of a request, with additional header lines.
    pub(crate) fn request(&self, path: &str, head: &str, body: &str) -> String {
        let (host, length) = (self.address, body.len());
        format!(
            "POST {path} HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: {length}\r\n\
             Connection: close\r\n{head}\r\n{body}"
        )
    }

    /// Sends this text and reads until the server has replied completely.
    pub(crate) fn send(&self, request: &str) -> Reply {
        let mut stream = TcpStream::connect(self.address).expect("a connection");
        stream.set_read_timeout(Some(PATIENCE)).expect("a time");
        // A server that rejects a request does not read all of it.
        let _ = stream.write_all(request.as_bytes());
        let mut bytes = Vec::new();
        let ended = stream.read_to_end(&mut bytes);
        let text = String::from_utf8_lossy(&bytes).into_owned();
        let (head, body) =
            text.split_once("\r\n\r\n").unwrap_or_else(|| panic!("no reply, {ended:?}: {text}"));
        let status = head.split(' ').nth(1).and_then(|code| code.parse().ok()).expect("a status");
        Reply { status, head: head.to_ascii_lowercase(), body: body.to_owned() }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
