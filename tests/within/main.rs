//! `within N` compared with true values: kernels of the repository and random ones, at arguments of
//! every size, keep their promise or return NaN with an error. Subnormal results are accurate to
//! half a unit in the last place.
//!
//! ```text
//! files, pages ─┐
//! grammar ──────┴─▶ kernels ─┬─ in the required precision ─▶ values ─┐
//!                            └─ enclosures of the formula ─▶ truth ──┴─▶ tally
//! ```
//! `FORMS_WITHIN=600` tries this number of points of each kernel, `FORMS_WITHIN_KERNELS=2000` this
//! number of random kernels.

mod judge;
mod points;
mod random;
mod sources;

use judge::{Judge, Tally};
use random::Term;

/// Default numbers of points of each kernel and of random kernels.
const POINTS: usize = 2;
const KERNELS: usize = 40;
/// Largest number of NaN results per thousand existing values.
const UNKNOWN: usize = 10;

fn wanted(variable: &str, usual: usize) -> usize {
    std::env::var(variable)
        .map_or(usual, |text| text.parse().unwrap_or_else(|_| panic!("{variable} is a number")))
}

/// Adds the tallies of the numbers below a count, computed on all processors.
fn shared(count: usize, tally: impl Fn(usize) -> Tally + Sync) -> Tally {
    let threads = std::thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let next = std::sync::atomic::AtomicUsize::new(0);
    let work = || {
        let mut sum = Tally::default();
        loop {
            let number = next.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
            if number >= count {
                return sum;
            }
            sum.add(tally(number));
        }
    };
    std::thread::scope(|scope| {
        let shares: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        shares.into_iter().map(|share| share.join().expect("no kernel panics")).fold(
            Tally::default(),
            |mut sum, more| {
                sum.add(more);
                sum
            },
        )
    })
}

fn report(name: &str, tally: &Tally) {
    println!("{name}: {tally}");
    assert!(
        tally.wrong.is_empty(),
        "{} values are not within what is promised:\n{}",
        tally.wrong.len(),
        tally.wrong.join("\n")
    );
    assert!(tally.known > 0);
    let allowed = 2 + (tally.known + tally.unknown.len()) * UNKNOWN / 1000;
    assert!(
        tally.unknown.len() <= allowed,
        "{} values are NaN:\n{}",
        tally.unknown.len(),
        tally.unknown.join("\n")
    );
}

#[test]
fn kernels_of_the_repository_keep_what_they_promise() {
    let points = wanted("FORMS_WITHIN", POINTS);
    let mut judges: Vec<Judge> = sources::all().iter().flat_map(|text| Judge::of_promises(text)).collect();
    assert!(judges.len() > 70, "{}", judges.len());
    if points <= POINTS {
        judges.retain(|judge| !judge.is_long());
    }
    let tally = shared(judges.len(), |number| judges[number].tally(points, number as u64));
    report("kernels of the repository", &tally);
}

#[test]
fn random_kernels_keep_what_they_promise() {
    let (kernels, points) = (wanted("FORMS_WITHIN_KERNELS", KERNELS), wanted("FORMS_WITHIN", POINTS));
    let tally = shared(kernels, |number| {
        let term = Term::random(number as u64);
        let judges = Judge::of_promises(&term.kernel(1 + number % 4));
        let mut tally = Tally::default();
        for judge in judges {
            tally.add(judge.tally(points, number as u64));
        }
        tally
    });
    report("random kernels", &tally);
}

/// Compares the true values themselves with another library.
#[test]
fn the_truth_is_that_of_another_library() {
    let kernels = wanted("FORMS_WITHIN_KERNELS", KERNELS);
    let mut compared = 0;
    for number in 0..kernels {
        let term = Term::random(number as u64);
        for judge in Judge::of_promises(&term.kernel(2)) {
            compared += judge.agrees_with(&term, number as u64);
        }
    }
    println!("{compared} values agree");
    assert!(compared >= kernels, "{compared}");
}
