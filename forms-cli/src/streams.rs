//! Standard output and standard error, either of which can be closed before the work is done.
//!
//! Results do not depend on the reader: if it has gone away, output is dropped, the work continues,
//! and the exit status is that of the work.

use std::io::{BufWriter, ErrorKind, Result, StdoutLock, Write};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether the reader of standard output has gone away.
static GONE: AtomicBool = AtomicBool::new(false);

/// Buffered standard output; nothing is written after its reader has gone away.
pub(crate) struct Output(BufWriter<StdoutLock<'static>>);

impl Output {
    pub(crate) fn new() -> Self {
        Output(BufWriter::new(std::io::stdout().lock()))
    }

    /// Whether the reader of the output has gone away.
    pub(crate) fn is_gone() -> bool {
        GONE.load(Ordering::Relaxed)
    }

    /// Treats a write as successful if the reader has gone away.
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

/// Writes a line to standard error; failures are ignored.
macro_rules! tell {
    ($($text:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($text)*);
    }};
}
pub(crate) use tell;
