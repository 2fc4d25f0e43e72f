//! Every command on inputs that a grammar makes, and on damaged ones: nothing ends the program, takes more memory than is
//! stated here, or does not end.
//!
//! ```text
//! seed ─┬─ theory ─┬─ as it is ──┐
//!       ├─ scene ──┴─ damaged ───┴─ file ─ command, in this process ─▶ status, and no panic
//!       └─ rows
//! ```
//! `FORMS_FUZZ=1000000` runs that many of each command, valid and damaged. Memory is bounded by the system, and a case that
//! takes longer than [`LONGEST`] is reported and ends the run; what a case may take is counted in steps elsewhere. The slowest
//! case of each command is named at its end.

mod damage;
mod scene;
mod theory;

use crate::arguments::Arguments;
use crate::commands::run_with_input;
use clap::Parser;
use damage::damaged;
use std::io::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Cases of each command where nobody asks for more: valid ones, and as many damaged ones.
const CASES: u64 = 10;

/// The memory that the whole run may take, in bytes: its threads have large stacks, most of which is not used.
#[cfg(unix)]
const MEMORY: u64 = 6 << 30;

/// A case that takes longer hangs, by all that anybody can tell.
const LONGEST: Duration = Duration::from_secs(120);

/// SplitMix64.
pub(super) struct Random(u64);

impl Random {
    pub(super) fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) % bound.max(1) as u64) as usize
    }

    pub(super) fn of<'a>(&mut self, words: &[&'a str]) -> &'a str {
        words[self.below(words.len())]
    }

    fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }
}

/// What a command is run on.
struct Case {
    arguments: Vec<String>,
    /// The files it reads.
    files: Vec<(PathBuf, Vec<u8>)>,
    input: Vec<u8>,
}

/// Commands and what makes a case of each; `true` asks for damage.
type Maker = fn(&mut Random, bool) -> Case;

fn folder() -> PathBuf {
    let folder = std::env::temp_dir().join(format!("forms-fuzz-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// The place of a file that no other thread has.
fn file(ending: &str) -> PathBuf {
    folder().join(format!("{:?}.{ending}", std::thread::current().id()).replace(['(', ')'], "-"))
}

fn hurt(text: String, random: &mut Random, is_damaged: bool) -> Vec<u8> {
    if is_damaged { damaged(&text, random) } else { text.into_bytes() }
}

fn of_theory(random: &mut Random, is_damaged: bool, command: &[&str], name: Option<&str>) -> Case {
    let theory = theory::Theory::random(random);
    let path = file("forms");
    let name = name.map(|kind| match kind {
        "kernel" => theory.kernel(random),
        _ => theory.name(random),
    });
    let mut arguments: Vec<String> = command[..1].iter().map(|word| (*word).to_string()).collect();
    arguments.push(path.to_string_lossy().into_owned());
    arguments.extend(name);
    arguments.extend(command[1..].iter().map(|word| (*word).to_string()));
    let text = theory.text;
    Case { arguments, files: vec![(path, hurt(text, random, is_damaged))], input: Vec::new() }
}

fn prove(random: &mut Random, is_damaged: bool) -> Case {
    let options: &[&str] = if random.one_in(2) { &["prove", "--json"] } else { &["prove"] };
    of_theory(random, is_damaged, options, None)
}

fn certified(random: &mut Random, is_damaged: bool) -> Case {
    let certificate = file("certificate").to_string_lossy().into_owned();
    of_theory(random, is_damaged, &["prove", "--certificate", &certificate], None)
}

fn show(random: &mut Random, is_damaged: bool) -> Case {
    let options: [&[&str]; 4] =
        [&["show"], &["show", "--as", "latex"], &["show", "--as", "mathml"], &["show", "--topology"]];
    let options = options[random.below(4)];
    of_theory(random, is_damaged, options, Some("name"))
}

fn derive(random: &mut Random, is_damaged: bool) -> Case {
    let options: [&[&str]; 3] = [&["derive"], &["derive", "--as", "latex"], &["derive", "--as", "mathml"]];
    let options = options[random.below(3)];
    of_theory(random, is_damaged, options, Some("name"))
}

fn emit(random: &mut Random, is_damaged: bool) -> Case {
    let target = random.of(&["rust", "c", "wgsl", "cuda"]);
    let precision = random.of(&["f32", "f64", "dd"]);
    of_theory(random, is_damaged, &["emit", "--target", target, "--precision", precision], None)
}

fn eval(random: &mut Random, is_damaged: bool) -> Case {
    let theory = theory::Theory::random(random);
    let (kernel, rows) = theory.rows(random);
    let precision = random.of(&["f32", "f64", "dd", "exact"]);
    let tier = random.of(&["plain", "stable"]);
    let path = file("forms");
    let words = ["eval", &path.to_string_lossy(), &kernel, "--precision", precision, "--tier", tier];
    let arguments = words.map(str::to_string).to_vec();
    let input = hurt(rows, random, is_damaged);
    Case { arguments, files: vec![(path, theory.text.into_bytes())], input }
}

fn accuracy(random: &mut Random, is_damaged: bool) -> Case {
    of_theory(random, is_damaged, &["accuracy", "--no-times", "--samples", "3"], None)
}

fn of_scene(random: &mut Random, is_damaged: bool, command: &[&str]) -> Case {
    let is_xml = random.one_in(3);
    let text = if is_xml { scene::mitsuba(random) } else { scene::toml(random) };
    let path = file(if is_xml { "xml" } else { "toml" });
    let mut arguments: Vec<String> = command.iter().map(|word| (*word).to_string()).collect();
    arguments.push(path.to_string_lossy().into_owned());
    Case { arguments, files: vec![(path, hurt(text, random, is_damaged))], input: Vec::new() }
}

fn simulate(random: &mut Random, is_damaged: bool) -> Case {
    let options: [&[&str]; 3] = [&["simulate"], &["simulate", "--json"], &["simulate", "--exposure", "2"]];
    let options = options[random.below(3)];
    of_scene(random, is_damaged, options)
}

fn view_factors(random: &mut Random, is_damaged: bool) -> Case {
    of_scene(random, is_damaged, &["view-factors"])
}

/// A file of no kind that the command expects.
fn merge(random: &mut Random, is_damaged: bool) -> Case {
    let path = file("part");
    let text = scene::toml(random);
    let arguments = vec!["merge".to_string(), path.to_string_lossy().into_owned()];
    Case { arguments, files: vec![(path, hurt(text, random, is_damaged))], input: Vec::new() }
}

fn check(random: &mut Random, is_damaged: bool) -> Case {
    let (path, certificate) = (file("forms"), file("certificate"));
    let theory = theory::Theory::random(random);
    let text = theory.certificate(&path.file_name().unwrap_or_default().to_string_lossy());
    let arguments = vec!["check".to_string(), certificate.to_string_lossy().into_owned()];
    let files = vec![(path, theory.text.into_bytes()), (certificate, hurt(text, random, is_damaged))];
    Case { arguments, files, input: Vec::new() }
}

/// The case that a thread is at, and since when.
type Watched = Arc<Mutex<Option<(Instant, String)>>>;

/// Ends the run when a case hangs.
fn watch(threads: Vec<Watched>, is_done: Arc<AtomicU64>) {
    while is_done.load(Ordering::Relaxed) == 0 {
        std::thread::sleep(Duration::from_millis(500));
        for thread in &threads {
            let case = thread.lock().expect("a case");
            if let Some((since, case)) = &*case
                && since.elapsed() > LONGEST
            {
                let report = format!("this case takes longer than {} s:\n{case}\n", LONGEST.as_secs());
                // To standard error itself: the runner loses what it has captured when the process aborts.
                let _ = std::io::stderr().lock().write_all(report.as_bytes());
                std::process::abort();
            }
        }
    }
}

/// Runs a case; the time it took.
fn run_case(case: &Case, watched: &Watched) -> Duration {
    for (path, bytes) in &case.files {
        std::fs::write(path, bytes).expect("a file");
    }
    let shown = || {
        let files = case.files.iter().map(|(_, bytes)| String::from_utf8_lossy(bytes).into_owned());
        let files: Vec<String> = files.collect();
        format!(
            "forms {}\n{}\n{}",
            case.arguments.join(" "),
            files.join("\n----\n"),
            String::from_utf8_lossy(&case.input)
        )
    };
    let arguments =
        Arguments::try_parse_from(std::iter::once("forms".to_string()).chain(case.arguments.clone()));
    let arguments = arguments.expect("the command line is right");
    let start = Instant::now();
    *watched.lock().expect("a case") = Some((start, shown()));
    let mut output = Vec::new();
    let run = || run_with_input(&arguments, &case.input[..], &mut output);
    let result = catch_unwind(AssertUnwindSafe(run));
    *watched.lock().expect("a case") = None;
    match result {
        Ok(Ok(_)) => {}
        Ok(Err(error)) => panic!("{error}: {}", shown()),
        Err(_) => panic!("the command panics:\n{}", shown()),
    }
    start.elapsed()
}

/// Runs a command on valid and damaged cases, on all processors.
fn survives(make: Maker) {
    #[cfg(unix)]
    rlimit::setrlimit(rlimit::Resource::AS, MEMORY, MEMORY).expect("a limit of memory");
    let wanted = std::env::var("FORMS_FUZZ").map_or(CASES, |count| count.parse().expect("a number of cases"));
    let first = std::env::var("FORMS_FUZZ_FROM").map_or(0, |seed| seed.parse().expect("a seed"));
    let threads = std::thread::available_parallelism().map_or(1, |threads| threads.get() as u64);
    let watched: Vec<Watched> = (0..threads).map(|_| Watched::default()).collect();
    let is_done = Arc::new(AtomicU64::new(0));
    let watcher = {
        let (watched, is_done) = (watched.clone(), Arc::clone(&is_done));
        std::thread::spawn(move || watch(watched, is_done))
    };
    let works: Vec<_> = (0..threads)
        .map(|thread| {
            let watched = Arc::clone(&watched[thread as usize]);
            let work = move || {
                let mut slowest = (Duration::ZERO, 0);
                for case in (first + thread..first + wanted).step_by(threads as usize) {
                    for is_damaged in [false, true] {
                        let mut random = Random(2 * case + u64::from(is_damaged));
                        slowest = slowest.max((run_case(&make(&mut random, is_damaged), &watched), case));
                    }
                }
                slowest
            };
            std::thread::Builder::new().stack_size(crate::STACK_BYTES).spawn(work).expect("a thread")
        })
        .collect();
    let results: Result<Vec<_>, _> = works.into_iter().map(std::thread::JoinHandle::join).collect();
    is_done.store(1, Ordering::Relaxed);
    watcher.join().expect("the watcher ends");
    let slowest = results.expect("no case ends the command").into_iter().max();
    if let Some((time, case)) = slowest {
        println!("the slowest of {wanted} cases took {time:.1?}: FORMS_FUZZ_FROM={case} FORMS_FUZZ=1");
    }
}

macro_rules! each {
    ($($name:ident)*) => {$(
        mod $name {
            #[test]
            fn ends_well() {
                super::survives(super::$name);
            }
        }
    )*};
}

each! { prove certified show derive emit eval accuracy simulate view_factors merge check }
