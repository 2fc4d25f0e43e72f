//! The local web page of the program `forms`: HTTP requests come in, pages and answers go out.
//!
//! ```text
//! connection ─ server (bounded number) ─ guard (origin check) ─ routes ─┬─ site ─▶ the page, its scripts, examples
//!                                                                       ├─ gallery, book ─▶ pages to read
//!                                                                       └─ work ─ a process, bounded ─▶ JSON
//! ```
//! No statement is decided in this process. A request about a text is passed to a worker process,
//! which is killed when its time limit is over. At most one worker per processor runs after its
//! first second, and a bounded number of requests waits. No file is read or written.

mod book;
mod errors;
mod gallery;
mod guard;
mod markdown;
mod reply;
mod routes;
mod server;
mod site;
mod work;

pub use errors::ServeError;

use std::io;
use std::net::{IpAddr, SocketAddr};
use std::path::PathBuf;
use std::time::Duration;

/// Default port of the page.
pub const USUAL_PORT: u16 = 4177;

/// Settings of the server: its content, address and limits.
#[derive(Clone, Debug)]
pub struct Settings {
    /// IP address to bind.
    pub bind: IpAddr,
    /// Port to listen on, or 0 for any free port.
    pub port: u16,
    /// Time limit of one request to a worker.
    pub time_limit: Duration,
    /// Program that answers requests about texts.
    pub worker: Worker,
    /// Initial text of the editor; `None` shows the first example.
    pub opened: Option<Opened>,
    /// Words of the language, for highlighting in the editor.
    pub words: Words,
}

/// Words of the language.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Words {
    /// Words that begin an item.
    pub items: &'static [&'static str],
    /// Words inside items.
    pub inside: &'static [&'static str],
    /// Functions and constants of expressions.
    pub functions: &'static [&'static str],
}

/// Program that is started with these arguments and the name of a task: `check`, `derive`, `emit`
/// or `plot`.
///
/// It reads one JSON object from standard input and writes JSON objects to standard output, one per
/// line. Lists of the same key in several lines are concatenated.
#[derive(Clone, Debug)]
pub struct Worker {
    /// Path of the program.
    pub program: PathBuf,
    /// Arguments before the name of the task.
    pub arguments: Vec<String>,
}

/// Initial text of the editor.
#[derive(Clone, Debug)]
pub struct Opened {
    /// Displayed name.
    pub name: String,
    /// Content.
    pub text: String,
}

/// Serves the page until the process is asked to end, by Ctrl-C or a signal to terminate. The
/// address is announced as soon as the server listens there.
///
/// # Errors
/// If the address cannot be bound, or the announcement fails.
pub fn serve(
    settings: Settings,
    announce: impl FnOnce(SocketAddr) -> io::Result<()>,
) -> Result<(), ServeError> {
    let runtime =
        tokio::runtime::Builder::new_multi_thread().enable_all().build().map_err(ServeError::Runtime)?;
    runtime.block_on(server::run(settings, announce))
}
