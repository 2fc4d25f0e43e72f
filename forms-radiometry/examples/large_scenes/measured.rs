//! Measurement of one scene: in this process, or in a separate one with its own memory and threads.

use super::ONE;
use forms_radiometry::scene::read;
use forms_radiometry::simulation::{Unwatched, plan, simulate};
use std::io;
use std::process::Command;
use std::time::Instant;

/// Measurements: seconds, kibibytes, and the largest relative error that was printed.
pub(crate) struct Measured {
    /// Number of surfaces or receivers, whichever the series varies.
    pub(crate) count: usize,
    pub(crate) reading: f64,
    pub(crate) planning: f64,
    pub(crate) answering: f64,
    pub(crate) memory: f64,
    pub(crate) error: f64,
}

impl Measured {
    /// Returns the figures on a line, for [`elsewhere`].
    pub(crate) fn line(&self) -> String {
        let Self { count, reading, planning, answering, memory, error } = self;
        format!("{count} {reading} {planning} {answering} {memory} {error}")
    }

    fn of_line(line: &str) -> Option<Self> {
        let mut words = line.split_whitespace();
        let count = words.next()?.parse().ok()?;
        let mut number = || words.next()?.parse::<f64>().ok();
        let [reading, planning, answering, memory, error] =
            [number()?, number()?, number()?, number()?, number()?];
        Some(Self { count, reading, planning, answering, memory, error })
    }
}

/// Measures a scene of a kind in a process with this many threads.
pub(crate) fn elsewhere(kind: &str, count: usize, threads: usize) -> io::Result<Measured> {
    let program = std::env::current_exe()?;
    let mut command = Command::new(program);
    command.args([ONE, kind, &count.to_string()]).env("RAYON_NUM_THREADS", threads.to_string());
    let output = command.stderr(std::process::Stdio::inherit()).output()?;
    let text = String::from_utf8_lossy(&output.stdout);
    let unreadable = || io::Error::other(format!("no measurements of `{kind}` of size {count}: {text}"));
    text.lines().last().and_then(Measured::of_line).ok_or_else(unreadable)
}

/// Measures the scene with this text in this process.
pub(crate) fn here(count: usize, text: String) -> Measured {
    let begin = Instant::now();
    let scene = read(&text, "scene.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
    let reading = begin.elapsed().as_secs_f64();
    drop(text);
    let begin = Instant::now();
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let planning = begin.elapsed().as_secs_f64();
    let begin = Instant::now();
    let found = simulate(&plan, &Unwatched);
    let answering = begin.elapsed().as_secs_f64();
    let error = found.history.last().map_or(f64::NAN, |moment| moment.error);
    Measured { count, reading, planning, answering, memory: most_memory(), error }
}

/// Returns the peak memory of this process in kibibytes, or NaN where the system does not report
/// it.
fn most_memory() -> f64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or(f64::NAN)
}
