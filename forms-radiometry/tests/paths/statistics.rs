//! Standard errors over many seeds: the truth lies within them as often as it should, and they fall
//! with more samples.

use crate::claims::coverage::Coverage;
use crate::claims::{self, Claim, Compared};
use forms_radiometry::simulation::Budget;
use rayon::prelude::*;

fn named(name: &str) -> Claim {
    let found = claims::all_and_long().into_iter().find(|claim| claim.name == name);
    found.unwrap_or_else(|| panic!("`{name}` is a claim"))
}

#[test]
fn the_truth_lies_within_standard_errors_as_often_as_it_should() {
    const SEEDS: u64 = 100;
    let mut coverage = Coverage::default();
    for name in [
        "a slab of albedo 0.9 and thickness 1",
        "a plane mirror doubles a lamp",
        "the sky fills the cone of total reflection below water",
    ] {
        coverage += Coverage::of(&named(name), SEEDS, 0.1);
    }
    // Student's distribution of 31 degrees of freedom, and four standard deviations of counts
    for (part, expected) in coverage.parts().into_iter().zip([0.675, 0.946_f64]) {
        let spread = 4.0 * (expected * (1.0 - expected) / coverage.count as f64).sqrt();
        assert!((part - expected).abs() <= spread, "{part} ± {spread}: {coverage:?}");
    }
}

/// Returns the errors of many runs of a furnace with a mirror in it: the largest in standard
/// errors, and the root mean square relative to the truth.
fn furnace(tolerance: f64) -> (f64, f64) {
    const SEEDS: u64 = 16;
    let claim = claims::furnace_of(0.5);
    let mut squares = 0.0;
    let mut worst = 0.0_f64;
    for seed in 1..=SEEDS {
        for compared in claim.compared(seed, tolerance) {
            let Compared { answer, truth, .. } = &compared;
            squares += (answer.value / truth - 1.0).powi(2);
            worst = worst.max(compared.deviations(0.0).unwrap_or(0.0));
        }
    }
    (worst, (squares / SEEDS as f64).sqrt())
}

#[test]
fn errors_of_a_furnace_fall_with_the_number_of_samples_and_none_is_far_off() {
    let mut last = f64::INFINITY;
    // the first tolerance takes the smallest number of samples that is possible
    for tolerance in [0.1, 4e-3, 2e-3] {
        let (worst, deviation) = furnace(tolerance);
        assert!(worst <= 5.0, "{tolerance}: {worst} standard errors");
        // the tolerance holds for one standard error, and samples are doubled until it does
        assert!(deviation <= 1.3 * tolerance && deviation < 0.8 * last, "{tolerance}: {deviation}, {last}");
        last = deviation;
    }
}

/// Returns the root mean square error of all answers of a claim over seeds, with this number of
/// samples.
fn error_over_seeds(claim: &Claim, seeds: u64, samples: u64) -> f64 {
    let budget = Budget::new(samples).unwrap_or_else(|error| panic!("{error}"));
    let all = (1..=seeds).into_par_iter().flat_map_iter(|seed| claim.sampled(seed, budget));
    let squares: Vec<f64> =
        all.map(|found| ((found.answer.value - found.truth) / found.largest).powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

#[test]
fn errors_over_seeds_never_rise_with_the_number_of_samples() {
    const SEEDS: u64 = 32;
    // the root of a mean square of n numbers spreads by 1/√(2n), and the ratio of two by √2 times
    // that; three times as much is allowed
    let spread = 3.0 / (SEEDS as f64).sqrt();
    for claim in [named("a slab of albedo 0.9 and thickness 1"), claims::furnace_of(0.5)] {
        let errors: Vec<f64> = (6..=11).map(|power| error_over_seeds(&claim, SEEDS, 1 << power)).collect();
        assert!(
            errors.windows(2).all(|pair| pair[1] <= (1.0 + spread) * pair[0]),
            "{}: {errors:?}",
            claim.name
        );
        // four times as many samples halve the error, or reduce it further
        assert!(errors.windows(3).all(|three| three[2] < three[0]), "{}: {errors:?}", claim.name);
    }
}
