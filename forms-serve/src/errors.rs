//! Errors that prevent the page from being served.

use std::fmt;
use std::io;
use std::net::SocketAddr;

/// Reason why the page cannot be served. The message includes a remedy where one is known.
#[derive(Debug)]
pub enum ServeError {
    /// Another program listens on this address.
    PortTaken(SocketAddr),
    /// The address cannot be bound.
    Address(SocketAddr, io::Error),
    /// The system provides no threads.
    Runtime(io::Error),
    /// The address could not be announced.
    Announcement(io::Error),
}

impl fmt::Display for ServeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ServeError::PortTaken(address) => {
                let port = address.port();
                write!(
                    f,
                    "port {port} of {} is in use, perhaps by another `forms serve`; choose another with --port, or 0 \
                     for any free port",
                    address.ip()
                )
            }
            ServeError::Address(address, error) => {
                write!(f, "cannot listen on {address}: {error}; choose another with --bind and --port")
            }
            ServeError::Runtime(error) => write!(f, "cannot start threads: {error}"),
            ServeError::Announcement(error) => write!(f, "cannot write the output: {error}"),
        }
    }
}

impl std::error::Error for ServeError {}
