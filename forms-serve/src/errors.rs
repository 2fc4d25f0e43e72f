//! Why the page cannot be served.

use std::fmt;
use std::io;
use std::net::SocketAddr;

/// Why the page cannot be served, and what to do about it.
#[derive(Debug)]
pub enum ServeError {
    /// Another program listens there.
    PortTaken(SocketAddr),
    /// The address cannot be listened at.
    Address(SocketAddr, io::Error),
    /// The system grants no threads.
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
                    "port {port} of {} is taken by another program, perhaps by `forms serve` itself; name another with \
                     --port, or 0 for any that is free",
                    address.ip()
                )
            }
            ServeError::Address(address, error) => {
                write!(f, "cannot listen at {address}: {error}; choose another with --bind and --port")
            }
            ServeError::Runtime(error) => write!(f, "no threads to serve with: {error}"),
            ServeError::Announcement(error) => write!(f, "cannot write the output: {error}"),
        }
    }
}

impl std::error::Error for ServeError {}
