//! The page of the program `forms`, on this machine: requests come in by HTTP, and pages and answers go out.
//!
//! ```text
//! connection ─ server (at most so many) ─ guard (whose request is it?) ─ routes ─┬─ site ─▶ the page, its scripts, examples
//!                                                                                ├─ gallery, book ─▶ pages to read
//!                                                                                └─ work ─ a process, bounded ─▶ JSON
//! ```
//! Nothing is decided here. A request about a text is given to another process, which may take a bounded time and is killed
//! after it; at most as many work at once as there are processors, and a bounded number waits. No file is read or written.

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

/// The port that the page has where none is named.
pub const USUAL_PORT: u16 = 4177;

/// What is served, where and within which bounds.
#[derive(Clone, Debug)]
pub struct Settings {
    /// The address to listen at.
    pub bind: IpAddr,
    /// The port to listen at, or 0 for any that is free.
    pub port: u16,
    /// The time that one piece of work may take.
    pub time_limit: Duration,
    /// What works.
    pub worker: Worker,
    /// What the editor begins with, if that is not the first example.
    pub opened: Option<Opened>,
    /// The words of the language, by which the editor has colours.
    pub words: Words,
}

/// The words of the language.
#[derive(Clone, Copy, Debug, serde::Serialize)]
pub struct Words {
    /// Those that begin an item.
    pub items: &'static [&'static str],
    /// Those that stand inside items.
    pub inside: &'static [&'static str],
    /// The functions and constants of expressions.
    pub functions: &'static [&'static str],
}

/// A program that is started with these arguments and the name of a task: `check`, `derive`, `emit` or `plot`.
///
/// It reads a JSON object from standard input and writes one a line to standard output, whose lists go behind each other.
#[derive(Clone, Debug)]
pub struct Worker {
    /// The program.
    pub program: PathBuf,
    /// What stands before the name of the task.
    pub arguments: Vec<String>,
}

/// A text to begin with.
#[derive(Clone, Debug)]
pub struct Opened {
    /// Its name, as it is shown.
    pub name: String,
    /// Its characters.
    pub text: String,
}

/// Serves the page until the process is asked to end, by Ctrl-C or otherwise. The address is announced as soon as it answers.
///
/// # Errors
/// If nothing can be listened at that address, or the announcement fails.
pub fn serve(
    settings: Settings,
    announce: impl FnOnce(SocketAddr) -> io::Result<()>,
) -> Result<(), ServeError> {
    let runtime =
        tokio::runtime::Builder::new_multi_thread().enable_all().build().map_err(ServeError::Runtime)?;
    runtime.block_on(server::run(settings, announce))
}
