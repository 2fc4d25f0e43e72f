//! Runs the program in a folder of its own.

use std::io::{BufRead, BufReader, Read, Write};
use std::path::PathBuf;
use std::process::{Child, Command, Output, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

/// Folder that is removed after its test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    /// Creates a folder with these files.
    pub(crate) fn with(files: &[(&str, &str)]) -> Self {
        static NUMBER: AtomicUsize = AtomicUsize::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let name = format!("folder-{}-{number}", std::process::id());
        let folder = Folder(PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name));
        std::fs::create_dir_all(&folder.0).expect("a folder in the build's folder");
        files.iter().for_each(|(name, text)| folder.write(name, text.as_bytes()));
        folder
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub(crate) fn write(&self, name: &str, bytes: &[u8]) {
        std::fs::write(self.path(name), bytes).expect("a file in the test's folder");
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.path(name)).unwrap_or_default()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// Exit status and printed texts of a run.
pub(crate) struct Run {
    pub(crate) status: i32,
    pub(crate) output: String,
    pub(crate) errors: String,
}

/// Runs the program without input.
pub(crate) fn forms(folder: &Folder, arguments: &[&str]) -> Run {
    forms_on(folder, arguments, "")
}

/// Runs the program on an input.
pub(crate) fn forms_on(folder: &Folder, arguments: &[&str], input: &str) -> Run {
    let mut child = started(folder, arguments);
    let mut pipe = child.stdin.take().expect("a pipe");
    // A program that rejects its arguments does not wait for its input.
    let _ = pipe.write_all(input.as_bytes());
    drop(pipe);
    run(child.wait_with_output().expect("the program ends"))
}

/// Runs the program with this number of threads.
pub(crate) fn forms_with_threads(folder: &Folder, arguments: &[&str], threads: &str) -> Run {
    let mut command = command(folder, arguments);
    run(command.env("RAYON_NUM_THREADS", threads).output().expect("the program ends"))
}

fn run(ended: Output) -> Run {
    let text = |bytes| String::from_utf8(bytes).expect("the program writes text");
    Run { status: ended.status.code().unwrap_or(-1), output: text(ended.stdout), errors: text(ended.stderr) }
}

/// Reads the first line of the output, closes it, and returns the text of standard error.
pub(crate) fn first_line_only(folder: &Folder, arguments: &[&str]) -> String {
    let mut child = started(folder, arguments);
    let mut line = String::new();
    BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut line).expect("a line");
    let mut errors = String::new();
    child.stderr.take().expect("a pipe").read_to_string(&mut errors).expect("text");
    child.wait().expect("the program ends");
    errors
}

/// Runs the program, and sends Ctrl-C once after it has written a line with this part.
#[cfg(unix)]
pub(crate) fn interrupted(folder: &Folder, arguments: &[&str], part: &str) -> Run {
    let mut child = started(folder, arguments);
    let mut output = BufReader::new(child.stdout.take().expect("a pipe"));
    let mut read = String::new();
    while !read.contains(part) && output.read_line(&mut read).expect("text") > 0 {}
    let number = i32::try_from(child.id()).expect("a process number");
    nix::sys::signal::kill(nix::unistd::Pid::from_raw(number), nix::sys::signal::SIGINT)
        .expect("Ctrl-C is sent");
    output.read_to_string(&mut read).expect("text");
    let mut ended = run(child.wait_with_output().expect("the program ends"));
    ended.output = read;
    ended
}

/// Runs the program with this number of threads and kills it after a time; returns whether it was
/// still working.
pub(crate) fn killed(folder: &Folder, arguments: &[&str], threads: &str, wait: Duration) -> bool {
    let mut command = command(folder, arguments);
    command.env("RAYON_NUM_THREADS", threads).stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().expect("the program starts");
    std::thread::sleep(wait);
    let is_working = child.try_wait().expect("the program can be asked").is_none();
    let _ = child.kill();
    child.wait().expect("the program ends");
    is_working
}

pub(crate) fn command(folder: &Folder, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_forms"));
    command.current_dir(&folder.0).args(arguments);
    command
}

fn started(folder: &Folder, arguments: &[&str]) -> Child {
    let mut command = command(folder, arguments);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().expect("the program starts")
}

/// Whether a Rust source compiles as a library without a warning.
pub(crate) fn compiles(folder: &Folder, source: &str) -> bool {
    folder.write("kernels.rs", source.as_bytes());
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_string());
    let arguments = ["--edition", "2024", "--crate-type", "lib", "-D", "warnings", "kernels.rs"];
    let ended = Command::new(rustc).current_dir(&folder.0).args(arguments).output().expect("a compiler");
    eprintln!("{}", String::from_utf8_lossy(&ended.stderr));
    ended.status.success()
}
