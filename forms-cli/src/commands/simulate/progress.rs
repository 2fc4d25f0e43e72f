//! Progress of the work: a bar with the remaining time on a terminal, nothing elsewhere. It also
//! stops the work on Ctrl-C, and when its time is over.

use crate::status::Status;
use forms_radiometry::simulation::Watch;
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressState, ProgressStyle};
use std::fmt;
use std::io::IsTerminal;
use std::process::exit;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Time before the bar appears; shorter work has none.
const PATIENCE: Duration = Duration::from_millis(300);
/// Stage shown after Ctrl-C.
const STOPPING: &str = "stopping";
/// Number of steps of a bar.
const PARTS: u64 = 1000;

/// Shows the progress of the work, and stops it at the user's request.
pub(in crate::commands) struct Progress {
    stopped: Arc<AtomicBool>,
    /// When the work ends in any case.
    deadline: Option<Instant>,
    /// Progress bar, if standard error is a terminal.
    bar: Option<Bar>,
}

struct Bar {
    start: Instant,
    drawn: ProgressBar,
    stage: Mutex<String>,
    end: End,
}

/// Predicted end of the work, if it can be predicted.
#[derive(Clone, Default)]
struct End(Arc<Mutex<Option<Instant>>>);

impl Progress {
    /// Installs the handler of Ctrl-C: the first Ctrl-C stops the work, the second one ends the
    /// program. The work stops at the deadline, too.
    pub(in crate::commands) fn watch(deadline: Option<Instant>) -> Result<Self, String> {
        let stopped = Arc::new(AtomicBool::new(false));
        let asked = Arc::clone(&stopped);
        let stop = move || {
            if asked.swap(true, Ordering::Relaxed) {
                exit(Status::Stopped.code().into());
            }
        };
        ctrlc::set_handler(stop).map_err(|error| format!("cannot install the Ctrl-C handler: {error}"))?;
        let bar = std::io::stderr().is_terminal().then(Bar::new);
        Ok(Self { stopped, deadline, bar })
    }

    /// Whether the work was stopped by its deadline, and not by the user.
    pub(in crate::commands) fn ran_out_of_time(&self) -> bool {
        self.is_late() && !self.stopped.load(Ordering::Relaxed)
    }

    fn is_late(&self) -> bool {
        self.deadline.is_some_and(|deadline| Instant::now() >= deadline)
    }

    /// Removes the bar.
    pub(in crate::commands) fn end(&self) {
        if let Some(bar) = &self.bar {
            bar.drawn.finish_and_clear();
        }
    }
}

impl Watch for Progress {
    fn progress(&self, stage: &str, fraction: f64) {
        if let Some(bar) = self.bar.as_ref().filter(|bar| bar.start.elapsed() >= PATIENCE) {
            bar.show(if self.is_stopped() { STOPPING } else { stage }, fraction);
        }
    }

    fn time_left(&self, seconds: Option<f64>) {
        if let Some(bar) = &self.bar {
            bar.end.set(seconds.filter(|_| !self.is_stopped()));
        }
    }

    fn is_stopped(&self) -> bool {
        self.stopped.load(Ordering::Relaxed) || self.is_late()
    }
}

impl Bar {
    fn new() -> Self {
        let end = End::default();
        let shown = end.clone();
        let left = move |_: &ProgressState, text: &mut dyn fmt::Write| {
            let _ = write!(text, "{}", shown.left());
        };
        let style = ProgressStyle::with_template("{msg} {wide_bar} {percent:>3} %  {left:<12}");
        let style = style.expect("the template is right").with_key("left", left);
        let drawn = ProgressBar::with_draw_target(Some(PARTS), ProgressDrawTarget::stderr());
        drawn.set_style(style);
        Self { start: Instant::now(), drawn, stage: Mutex::default(), end }
    }

    /// Shows the current stage, and the completed fraction of the whole work.
    fn show(&self, stage: &str, fraction: f64) {
        let Ok(mut current) = self.stage.lock() else { return };
        if *current != stage {
            stage.clone_into(&mut current);
            self.drawn.set_message(stage.to_owned());
        }
        self.drawn.set_position((fraction.clamp(0.0, 1.0) * PARTS as f64) as u64);
    }
}

impl End {
    /// Sets the predicted end to this number of seconds from now.
    fn set(&self, seconds: Option<f64>) {
        let left = seconds.and_then(|seconds| Duration::try_from_secs_f64(seconds).ok());
        if let Ok(mut end) = self.0.lock() {
            *end = left.and_then(|left| Instant::now().checked_add(left));
        }
    }

    /// Returns the remaining time in words; empty if it is not known.
    fn left(&self) -> String {
        let end = self.0.lock().map_or(None, |end| *end);
        let left = end.map(|end| end.saturating_duration_since(Instant::now()));
        left.map_or(String::new(), |left| format!("{:#} left", HumanDuration(left)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_follow_each_other_from_any_thread() {
        let drawn = ProgressBar::with_draw_target(Some(PARTS), ProgressDrawTarget::hidden());
        let (stage, end) = (Mutex::default(), End::default());
        let bar = Bar { start: Instant::now() - PATIENCE, drawn, stage, end };
        let progress = Progress { stopped: Arc::new(AtomicBool::new(false)), deadline: None, bar: Some(bar) };
        progress.progress("factors", 0.9);
        std::thread::scope(|scope| {
            (0..4).for_each(|part| {
                let progress = &progress;
                scope.spawn(move || progress.progress("bounces", 0.1 * f64::from(part)));
            });
        });
        progress.progress("bounces", 0.25);
        let bar = progress.bar.as_ref().expect("a bar");
        assert_eq!((bar.drawn.message(), bar.drawn.position()), ("bounces".to_owned(), 250));
        assert_eq!(bar.end.left(), "");
        progress.time_left(Some(42.4));
        assert_eq!(bar.end.left(), "42s left");
        progress.time_left(None);
        assert_eq!(bar.end.left(), "");
        progress.end();
        assert!(bar.drawn.is_finished() && !progress.is_stopped());
    }
}
