//! `forms simulate --checkpoint`: killed work resumes to the same bits as uninterrupted work, and a
//! checkpoint of other work is rejected.

use crate::hall::{FILES, LAMP, hall};
use crate::process::{Folder, forms, forms_with_threads, killed};
use std::time::{Duration, Instant};

/// Number of kills; FORMS_KILLS overrides it.
const KILLS: u64 = 4;

/// Returns a random number from 0 to 1 that differs between runs.
fn random(number: u64) -> f64 {
    use std::hash::{BuildHasher, RandomState};
    RandomState::new().hash_one(number) as f64 / u64::MAX as f64
}

#[test]
fn work_that_was_killed_at_any_moment_goes_on_to_the_same_bits() {
    // This tolerance takes about a second of work in this build.
    let tolerance = if cfg!(debug_assertions) { 0.02 } else { 0.003 };
    let folder = Folder::with(&[("hall.toml", &hall(tolerance))]);
    let begin = Instant::now();
    let run = forms(&folder, &["simulate", "hall.toml", "--out", "whole"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    let time = begin.elapsed();
    let kills = std::env::var("FORMS_KILLS").ok().and_then(|count| count.parse().ok()).unwrap_or(KILLS);
    let mut interrupted = 0;
    for kill in 0..kills {
        let _ = std::fs::remove_file(folder.path("state"));
        let call = ["simulate", "hall.toml", "--checkpoint", "state", "--every", "0.01", "--out", "resumed"];
        // The second kill happens after the work has resumed; each run has its own number of
        // threads.
        for threads in ["1", "2"] {
            let wait: Duration = time.mul_f64(random(kill) * 0.7);
            interrupted += usize::from(killed(&folder, &call, threads, wait));
        }
        let run = forms_with_threads(&folder, &call, ["2", "1"][kill as usize % 2]);
        assert_eq!(run.status, 0, "{}", run.errors);
        for file in FILES {
            let [whole, resumed] = ["whole", "resumed"].map(|name| folder.read(&format!("{name}/{file}")));
            assert!(!whole.is_empty() && whole == resumed, "{file} after kill {kill}");
        }
    }
    assert!(interrupted > 0, "nothing was killed before its end");
}

#[test]
fn a_share_that_was_killed_is_made_by_the_same_call() {
    let folder = Folder::with(&[("hall.toml", &hall(0.05))]);
    let share = |part, out| ["simulate", "hall.toml", "--shard", part, "--out", out];
    let kept = ["--checkpoint", "state", "--every", "0"];
    for (part, out) in [("1/2", "a"), ("2/2", "b")] {
        assert_eq!(forms(&folder, &share(part, out)).status, 0);
    }
    let call = [&share("2/2", "c")[..], &kept].concat();
    killed(&folder, &call, "1", Duration::from_millis(60));
    assert_eq!(forms(&folder, &call).status, 0);
    for part in ["b", "c"] {
        let run = forms(&folder, &["merge", "a", part, "--out", &format!("with {part}")]);
        assert_eq!((run.status, run.errors.as_str()), (0, ""));
    }
    for file in FILES {
        let [one, other] = ["b", "c"].map(|part| folder.read(&format!("with {part}/{file}")));
        assert!(!one.is_empty() && one == other, "{file}");
    }
}

#[test]
fn work_that_is_done_is_not_done_again() {
    let folder = Folder::with(&[("hall.toml", &hall(0.1))]);
    let call = ["simulate", "hall.toml", "--checkpoint", "state", "--out", "out"];
    let first = forms(&folder, &call);
    assert_eq!((first.status, first.errors.as_str()), (0, ""));
    let found = folder.read("out/results.csv");
    let again = forms(&folder, &call);
    assert_eq!((again.status, again.errors.as_str()), (0, "note: resuming from `state`\n"));
    assert_eq!(folder.read("out/results.csv"), found);
}

#[test]
fn a_checkpoint_of_other_work_or_of_none_is_refused_and_stays() {
    let folder = Folder::with(&[
        ("hall.toml", &hall(0.1)),
        ("other.toml", &hall(0.2)),
        ("lamp.toml", LAMP),
        ("text", "nothing"),
    ]);
    assert_eq!(forms(&folder, &["simulate", "hall.toml", "--checkpoint", "state"]).status, 0);
    let state = folder.read("state");
    let mut damaged = state.clone();
    damaged[state.len() / 2] ^= 4;
    folder.write("damaged", &damaged);
    folder.write("cut", &state[..state.len() - 1]);
    folder.write("empty", b"");
    let cases: [(&[&str], &str); 8] = [
        (
            &["other.toml", "--checkpoint", "state"],
            "`state` does not match this run: it belongs to another scene",
        ),
        (
            &["hall.toml", "--checkpoint", "state", "--samples", "64"],
            "the number of samples that the tolerance requires",
        ),
        (&["hall.toml", "--checkpoint", "state", "--shard", "1/2", "--out", "p"], "it is shard 1/1, not 1/2"),
        (
            &["hall.toml", "--checkpoint", "text"],
            "`text` was written by another program or for another purpose",
        ),
        (
            &["hall.toml", "--checkpoint", "empty"],
            "`empty` was written by another program or for another purpose",
        ),
        (&["hall.toml", "--checkpoint", "damaged"], "`damaged` is damaged"),
        (&["hall.toml", "--checkpoint", "cut"], "`cut` is damaged"),
        (&["hall.toml", "--checkpoint", "no/where"], "`no/where` cannot be written"),
    ];
    for (arguments, message) in cases {
        let before = folder.read(arguments[2]);
        let run = forms(&folder, &[&["simulate"], arguments].concat());
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{arguments:?}");
        assert!(run.errors.contains(message), "{arguments:?}: {}", run.errors);
        assert!(arguments[2] == "no/where" || run.errors.contains("remove it to start from the beginning"));
        assert_eq!(folder.read(arguments[2]), before);
    }
}

#[test]
fn a_scene_that_is_solved_as_a_whole_is_kept_at_its_end() {
    let folder = Folder::with(&[("lamp.toml", LAMP)]);
    let call = ["simulate", "lamp.toml", "--checkpoint", "state", "--out", "found"];
    let first = forms(&folder, &call);
    assert!(first.status == 0 && first.errors.contains("written only at the end"), "{}", first.errors);
    let results = folder.read("found/results.csv");
    let again = forms(&folder, &call);
    assert!(again.status == 0 && again.errors.contains("resuming from `state`"), "{}", again.errors);
    assert_eq!(folder.read("found/results.csv"), results);
}

#[test]
fn a_checkpoint_of_another_version_is_refused() {
    let folder = Folder::with(&[("hall.toml", &hall(0.2))]);
    let title = b"forms checkpoint\n0.0.1\n".to_vec();
    let check = blake3::hash(&title);
    folder.write("old", &[title.as_slice(), check.as_bytes()].concat());
    let run = forms(&folder, &["simulate", "hall.toml", "--checkpoint", "old"]);
    let message =
        format!("`old` was written by version 0.0.1; this program is version {}", env!("CARGO_PKG_VERSION"));
    assert!(run.status == 2 && run.errors.contains(&message), "{}", run.errors);
}
