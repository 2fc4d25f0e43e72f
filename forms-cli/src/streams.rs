//! Standard output and standard error, of which either may be closed before the work is done.
//!
//! What is decided does not depend on who reads it: where a reader has gone away, what is written is dropped, the work
//! goes on, and the exit status is that of the work.

use std::io::{BufWriter, ErrorKind, Result, StdoutLock, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the reader of standard output has gone away.
static GONE: AtomicBool = AtomicBool::new(false);

/// Standard output, buffered; nothing is written once its reader has gone away.
pub(crate) struct Output(BufWriter<StdoutLock<'static>>);

impl Output {
    pub(crate) fn new() -> Self {
        Output(BufWriter::new(std::io::stdout().lock()))
    }

    /// Whether what is written reaches nobody.
    pub(crate) fn is_gone() -> bool {
        GONE.load(Ordering::Relaxed)
    }

    /// The result of writing, which is well where nobody is left to read.
    fn kept<T>(result: Result<T>, otherwise: T) -> Result<T> {
        match result {
            Err(error) if error.kind() == ErrorKind::BrokenPipe => {
                GONE.store(true, Ordering::Relaxed);
                Ok(otherwise)
            }
            result => result,
        }
    }
}

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        if Output::is_gone() {
            return Ok(bytes.len());
        }
        Output::kept(self.0.write(bytes), bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        if Output::is_gone() {
            return Ok(());
        }
        Output::kept(self.0.flush(), ())
    }
}

/// Writes a line to standard error, if anybody reads it.
macro_rules! tell {
    ($($text:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($text)*);
    }};
}
pub(crate) use tell;
