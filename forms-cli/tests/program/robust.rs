//! No input crashes the program, and a run that ends early does not report success: closed pipes,
//! endless inputs, devices and pipes instead of files, full disks, two runs with one checkpoint.

use crate::hall;
use crate::process::{Folder, command, forms};
use std::io::Write;
use std::process::Stdio;

const FALSE: &str = "chart L(x); prove wrong: x == x + 1; prove right: x == x;";

/// Returns the exit status of a call whose output is not read.
fn status_unread(folder: &Folder, arguments: &[&str]) -> Option<i32> {
    let mut process = command(folder, arguments)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("it runs");
    drop(process.stdout.take());
    drop(process.stderr.take());
    process.wait().expect("it ends").code()
}

#[test]
fn a_pipe_that_closes_early_keeps_the_status_of_the_work() {
    let damaged = "chart L(x); prove p: y == x;";
    let files = [
        ("false.forms", FALSE),
        ("damaged.forms", damaged),
        ("good.forms", "chart L(x); prove p: x == x; pub kernel k(x) = x;"),
        ("dark.toml", "[[surface]]\nname = \"a\"\n"),
    ];
    let folder = Folder::with(&files);
    for (arguments, status) in [
        (&["prove", "good.forms"][..], 0),
        (&["prove", "false.forms"], 1),
        (&["prove", "--json", "false.forms"], 1),
        (&["prove", "damaged.forms"], 2),
        (&["prove", "--json", "damaged.forms"], 2),
        (&["prove", "false.forms", "missing.forms"], 2),
        (&["derive", "false.forms", "wrong"], 1),
        (&["derive", "good.forms", "p"], 0),
        (&["show", "good.forms", "nobody"], 2),
        (&["emit", "good.forms", "--target", "c"], 0),
        (&["emit", "damaged.forms", "--target", "c"], 2),
        (&["accuracy", "good.forms", "--no-times", "--samples", "2"], 0),
        (&["eval", "damaged.forms", "k"], 2),
        (&["simulate", "dark.toml"], 2),
        (&["view-factors", "dark.toml"], 2),
        (&["merge", "good.forms"], 2),
        (&["check", "good.forms"], 2),
        (&["kernels"], 0),
        (&["man"], 0),
    ] {
        assert_eq!(status_unread(&folder, arguments), Some(status), "{arguments:?}");
    }
}

#[test]
fn a_malformed_row_is_found_though_nobody_reads_the_values() {
    let folder = Folder::with(&[("k.forms", "pub kernel k(x) = x;")]);
    let rows = |last: &str| "x\n".to_string() + &"1\n".repeat(100_000) + last + "\n";
    for (last, status) in [("1", 0), ("one", 2)] {
        let mut process = command(&folder, &["eval", "k.forms", "k"])
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("it runs");
        drop(process.stdout.take());
        let mut input = process.stdin.take().expect("an input");
        input.write_all(rows(last).as_bytes()).expect("it reads all rows");
        drop(input);
        assert_eq!(process.wait().expect("it ends").code(), Some(status), "{last}");
    }
}

#[cfg(target_os = "linux")]
mod linux {
    use super::*;
    use std::fs::File;
    use std::os::unix::fs::symlink;
    use std::path::Path;

    #[test]
    fn rows_without_end_are_refused() {
        let folder = Folder::with(&[("k.forms", "pub kernel k(x) = x;")]);
        let input = File::open("/dev/zero").expect("the device");
        let output = command(&folder, &["eval", "k.forms", "k"]).stdin(input).output().expect("it runs");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2));
        assert!(errors.contains("a row is longer than the limit of 1 MiB"), "{errors}");
    }

    #[test]
    fn what_is_no_file_is_refused_in_the_place_of_one() {
        let scene = "[[material]]\nname = \"m\"\nkind = \"black\"\n\
                     [[surface]]\nname = \"s\"\nmaterial = \"m\"\nmesh = \"mesh.obj\"\n";
        let folder = Folder::with(&[("scene.toml", scene)]);
        let mesh = folder.path("mesh.obj");
        let refused = |arguments: &[&str], reason: &str| {
            let run = forms(&folder, arguments);
            assert_eq!(run.status, 2, "{arguments:?}: {}", run.errors);
            assert!(run.errors.contains(reason), "{arguments:?}: {}", run.errors);
        };
        let not_a_file = "it is a device, pipe or socket, not a regular file";
        symlink("/dev/zero", &mesh).expect("a link");
        refused(&["view-factors", "scene.toml"], not_a_file);
        std::fs::remove_file(&mesh).expect("removed");
        nix::unistd::mkfifo(&mesh, nix::sys::stat::Mode::S_IRWXU).expect("a pipe");
        refused(&["view-factors", "scene.toml"], not_a_file);
        std::fs::remove_file(&mesh).expect("removed");
        std::fs::create_dir(&mesh).expect("a folder");
        refused(&["view-factors", "scene.toml"], "it is a folder");
        refused(&["simulate", "/dev/zero"], not_a_file);
        refused(&["simulate", "mesh.obj"], "it is a folder");
        refused(&["merge", "/dev/zero"], not_a_file);
        refused(&["prove", "/dev/zero"], "larger than the limit of 16 MiB");
    }

    #[test]
    fn a_full_disk_is_called_that() {
        let folder = Folder::with(&[("good.forms", "chart L(x); prove p: x == x;")]);
        let full = File::options().write(true).open("/dev/full").expect("the device");
        let output = command(&folder, &["prove", "good.forms"]).stdout(full).output().expect("it runs");
        let errors = String::from_utf8_lossy(&output.stderr);
        assert_eq!(
            (output.status.code(), &*errors),
            (Some(2), "error: cannot write the output: the disk is full\n")
        );
        let run = forms(&folder, &["prove", "good.forms", "--certificate", "/dev/full"]);
        assert_eq!((run.status, &*run.errors), (2, "error: cannot write /dev/full: the disk is full\n"));
        assert!(Path::new("/dev/full").exists());
    }
}

#[test]
fn two_runs_with_one_checkpoint_know_of_each_other() {
    let folder = Folder::with(&[("hall.toml", hall::HALL)]);
    let lock = std::fs::File::create(folder.path("state.lock")).expect("a file");
    lock.lock().expect("a lock");
    let arguments = ["simulate", "hall.toml", "--checkpoint", "state", "--samples", "32"];
    let run = forms(&folder, &arguments);
    assert_eq!(run.status, 2, "{}", run.errors);
    assert!(run.errors.contains("the checkpoint `state` is in use by another run"), "{}", run.errors);
    // A killed run leaves the lock file, but holds no lock.
    drop(lock);
    let run = forms(&folder, &arguments);
    assert_eq!(run.status, 0, "{}", run.errors);
    assert!(!folder.path("state.lock").exists() && folder.path("state").exists());
}

#[test]
fn many_errors_are_counted_and_long_lines_are_cut() {
    let many = "prove ".repeat(50_000);
    let long = format!("chart L(x);\nlet a = {}y;\n", "x + ".repeat(20_000));
    let elements = format!("<scene version=\"3.0.0\">{}</scene>", "<oops/>".repeat(40_000));
    let rows = format!("{}\n", "[[surface]]\nnaem = 1\n".repeat(5_000));
    let files =
        [("many.forms", &*many), ("long.forms", &long), ("many.xml", &elements), ("many.toml", &rows)];
    let folder = Folder::with(&files);
    for (arguments, count) in [
        (["prove", "many.forms"], 129),
        (["prove", "long.forms"], 1),
        (["simulate", "many.xml"], 129),
        (["simulate", "many.toml"], 129),
    ] {
        let run = forms(&folder, &arguments);
        assert_eq!(run.status, 2);
        assert!(run.errors.len() < 100_000, "{arguments:?}: {} bytes", run.errors.len());
        let found = run.errors.lines().filter(|line| line.starts_with("error: ")).count();
        assert_eq!(found, count, "{arguments:?}: {}", run.errors);
        assert_eq!(run.errors.contains("more error"), count > 1, "{arguments:?}");
        assert!(run.errors.lines().all(|line| line.chars().count() < 400), "{arguments:?}");
    }
}
