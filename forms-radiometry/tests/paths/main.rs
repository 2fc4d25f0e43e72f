//! Scenes that are path traced: known answers, refused light traps, the same scene at any size and
//! place and in any unit, images, and how often the truth lies within the reported standard errors.

mod images;
mod lengths;
mod many_lights;
mod rare;
mod statistics;
mod traps;
mod unfolded;

use forms_radiometry::simulation::{ErrorKind, Quantity};
use forms_radiometry_testing::claims::{self, Claim, Compared};

/// Seed of all known answers.
const SEED: u64 = 1;
/// Number of standard errors that an answer may be off. With the number of answers here, one of
/// them exceeds it once in some ten seeds. A seed that fails is therefore no reason to choose
/// another one before the scene is examined with many seeds.
const DEVIATIONS: f64 = 4.0;

fn check(claim: &Claim) -> Vec<String> {
    let compared = claim.compared(SEED, claim.tolerance);
    assert!(!compared.is_empty(), "{} claims nothing", claim.name);
    compared.iter().filter_map(|compared| wrong(claim, compared)).collect()
}

/// Describes the fault of an answer, if there is one.
fn wrong(claim: &Claim, compared: &Compared) -> Option<String> {
    let Compared { answer, truth, largest } = compared;
    let is_near = compared.deviations(1e-12).is_none_or(|deviations| deviations <= DEVIATIONS);
    // an answer that is 0 for certain has no scale
    let is_narrow = answer.error <= claim.tolerance * largest * (1.0 + 1e-9) || *largest == 0.0;
    // rays that are not scattered anywhere need no samples
    let is_sampled = answer.quantity != Quantity::Radiance || answer.bin.is_some();
    let is_kind = answer.kind == ErrorKind::Sigma || !is_sampled;
    (!(is_near && is_narrow && is_kind))
        .then(|| format!("{}: {truth} is claimed, and {answer:?} found", claim.name))
}

#[test]
fn answers_are_those_that_are_known() {
    let wrong: Vec<String> = claims::all().iter().flat_map(check).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_claim_that_is_wrong_is_found_out() {
    let claim = claims::off_by(1.06);
    assert!(!check(&claim).is_empty());
}
