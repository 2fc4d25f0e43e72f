//! Worker processes: a request goes in, JSON comes out, and the time for both is bounded.
//!
//! ```text
//! request ─ queue (bounded) ─ process ─┬─ ends within a second ─────────────────────────────────────────┬─▶ one object
//!                                      └─ is suspended ─ turn (one per processor) ─ ends, or is killed ─┘
//! ```
//! Every process gets its first second soon, independent of the others. Processes that need more
//! time wait for each other.
//!
//! A process that does not end is killed when its time limit is over. Its output up to then is the
//! answer, together with the reason why the answer is incomplete. If the client disconnects, the
//! process is killed too.

use crate::Worker;
use serde_json::{Map, Value, json};
use std::io;
use std::pin::pin;
use std::process::Stdio;
use std::time::Duration;
use tokio::io::{AsyncReadExt, AsyncWriteExt};
use tokio::process::{Child, Command};
use tokio::sync::{Semaphore, SemaphorePermit};
use tokio::time::timeout;

/// Limit of requests that wait for a turn or have one.
const QUEUE: usize = 64;
/// Limit of processes in their first second, which share the processors.
const BEGINNERS: usize = 16;
/// Length of the first period of a process, in which it needs no turn.
const BEGINNING: Duration = Duration::from_secs(1);
/// Longest answer, in bytes; a longer one is cut off.
const LONGEST_ANSWER: u64 = 16 << 20;

/// Worker processes and the limits of their number.
pub(crate) struct Workers {
    worker: Worker,
    time_limit: Duration,
    places: Semaphore,
    beginners: Semaphore,
    turns: Semaphore,
}

/// Reason why there is no answer.
#[derive(Debug)]
pub(crate) enum NoAnswer {
    /// Too many requests are waiting.
    Busy,
    /// The process cannot be started.
    Broken(io::Error),
}

/// Way in which a process ended.
enum End {
    Done,
    OutOfTime,
    TooLong,
    Killed,
    Failed,
}

impl Workers {
    pub(crate) fn new(worker: Worker, time_limit: Duration) -> Self {
        let processors = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
        let [places, beginners, turns] = [QUEUE, BEGINNERS, processors].map(Semaphore::new);
        Workers { worker, time_limit, places, beginners, turns }
    }

    /// Answers a request.
    pub(crate) async fn answer(&self, task: &str, request: &[u8]) -> Result<Value, NoAnswer> {
        let _place = self.places.try_acquire().map_err(|_| NoAnswer::Busy)?;
        // A request that would wait too long is rejected.
        let Ok(Ok(beginner)) = timeout(self.time_limit.saturating_mul(2), self.beginners.acquire()).await
        else {
            return Err(NoAnswer::Busy);
        };
        let mut process = self.start(task).map_err(NoAnswer::Broken)?;
        let mut written = Vec::new();
        let conversed = self.conversed(&mut process, request, beginner, &mut written).await;
        let end = match conversed {
            None => End::OutOfTime,
            Some(Ok(())) if written.len() as u64 > LONGEST_ANSWER => End::TooLong,
            Some(Ok(())) => match timeout(self.time_limit, process.wait()).await {
                Ok(Ok(status)) if status.success() => End::Done,
                // Only a process that was not killed has an exit code.
                Ok(Ok(status)) if status.code().is_some() => End::Failed,
                _ => End::Killed,
            },
            Some(Err(_)) => End::Killed,
        };
        // This has no effect on a process that has already ended.
        let _ = process.kill().await;
        Ok(merged(&written, self.reason(&end)))
    }

    /// Exchanges the request and the answer with a process: at once in its first second, and then
    /// when it has a turn. Returns `None` if the time limit is over before the answer is complete.
    async fn conversed(
        &self,
        process: &mut Child,
        request: &[u8],
        beginner: SemaphorePermit<'_>,
        written: &mut Vec<u8>,
    ) -> Option<io::Result<()>> {
        let id = process.id();
        let mut talk = pin!(converse(process, request, written));
        let beginning = BEGINNING.min(self.time_limit);
        if let Ok(end) = timeout(beginning, &mut talk).await {
            return Some(end);
        }
        let rest = self.time_limit.saturating_sub(beginning);
        if rest.is_zero() {
            return None;
        }
        if self.turns.available_permits() == 0 {
            signal(id, Signal::Halt);
        }
        drop(beginner);
        let _turn = timeout(self.time_limit.saturating_mul(2), self.turns.acquire()).await.ok()?;
        signal(id, Signal::GoOn);
        timeout(rest, talk).await.ok()
    }

    fn start(&self, task: &str) -> io::Result<Child> {
        let mut command = Command::new(&self.worker.program);
        command.args(&self.worker.arguments).arg(task);
        // There are as many processes as processors, so each process uses one thread.
        command.env("RAYON_NUM_THREADS", "1");
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        command.kill_on_drop(true).spawn()
    }

    /// Returns the reason why the answer is incomplete, if it is.
    fn reason(&self, end: &End) -> Option<String> {
        match end {
            End::Done => None,
            End::OutOfTime => {
                Some(format!("stopped after {} s, the time limit", self.time_limit.as_secs_f64()))
            }
            End::TooLong => Some(format!("stopped: the answer is longer than {} MiB", LONGEST_ANSWER >> 20)),
            End::Killed => Some("stopped: the request exceeded its limit of memory or time".to_owned()),
            End::Failed => Some("stopped by an internal error".to_owned()),
        }
    }
}

/// Signal to a process.
#[derive(Clone, Copy)]
enum Signal {
    Halt,
    GoOn,
}

/// Suspends or resumes a process that has not ended.
#[cfg(unix)]
fn signal(id: Option<u32>, signal: Signal) {
    use rustix::process::{Pid, Signal as Number, kill_process};
    let number = match signal {
        Signal::Halt => Number::STOP,
        Signal::GoOn => Number::CONT,
    };
    let process = id.and_then(|id| i32::try_from(id).ok()).and_then(Pid::from_raw);
    // A process that has ended meanwhile needs no signal; its number is not reused until it is
    // waited for.
    let _ = process.map(|process| kill_process(process, number));
}

/// Does nothing: on other systems the processes share the processors.
#[cfg(not(unix))]
fn signal(_: Option<u32>, _: Signal) {}

/// Sends the request and reads the output, up to one byte more than the longest answer.
async fn converse(process: &mut Child, request: &[u8], written: &mut Vec<u8>) -> io::Result<()> {
    let none = || io::Error::other("no pipe");
    let mut input = process.stdin.take().ok_or_else(none)?;
    let output = process.stdout.take().ok_or_else(none)?;
    let send = async move {
        // A process that does not read all of its request can still answer.
        let _ = input.write_all(request).await;
        drop(input);
    };
    let mut output = output.take(LONGEST_ANSWER + 1);
    let (_, read) = tokio::join!(send, output.read_to_end(written));
    read.map(|_| ())
}

/// Merges all lines into one object: lists are concatenated, other values replace earlier ones. A
/// last line that was cut off is skipped.
fn merged(written: &[u8], stopped: Option<String>) -> Value {
    let mut whole = Map::new();
    for line in written.split(|&byte| byte == b'\n') {
        let Ok(Value::Object(object)) = serde_json::from_slice(line) else { continue };
        for (key, value) in object {
            match (whole.get_mut(&key), value) {
                (Some(Value::Array(list)), Value::Array(more)) => list.extend(more),
                (_, value) => {
                    whole.insert(key, value);
                }
            }
        }
    }
    whole.insert("stopped".to_owned(), json!(stopped));
    Value::Object(whole)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_of_lines_go_behind_each_other_and_a_line_cut_off_is_left_out() {
        let written = b"{\"a\":[1],\"b\":1}\n{\"a\":[2],\"b\":2}\n{\"a\":[3";
        assert_eq!(merged(written, None), json!({ "a": [1, 2], "b": 2, "stopped": null }));
    }
}
