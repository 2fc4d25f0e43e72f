//! Forms given by the rules alone: no regime of any case gets worse, and they achieve most of the
//! gain that is possible without a search.

use forms_core::accuracy::{Regime, Score, Width, sample};
use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::kernel::Program;

const CASES: &str = include_str!("../../tests/stability/hamming.forms");

/// Number of samples in each regime, and their seed.
const SAMPLES: usize = 24;
const SEED: u64 = 7;

/// Tolerance for the mean of a regime in bits: a few more roundings.
const ROUNDINGS: f64 = 1.0;

#[test]
fn rules_alone_lose_nowhere_and_win_on_the_mean() {
    let (mut theory, errors) = read_theory(CASES);
    assert!(errors.is_empty(), "{errors:?}");
    let mut found: Vec<(f64, f64)> = Vec::new();
    for kernel in theory.kernels.clone() {
        let name = &kernel.name;
        let generated =
            compile_kernel(&mut theory.pool, &kernel).unwrap_or_else(|errors| panic!("{name}: {errors:?}"));
        if generated.rewritten.is_empty() {
            continue;
        }
        assert!(generated.translation.is_proved(), "{name}: {}", generated.translation);
        assert!(generated.account().contains("found by rewriting rules"), "{name}");
        for regime in sample(&theory.pool, &kernel, Width::Double, &Regime::ALL, SAMPLES, SEED) {
            let by = |program: &Program| {
                Score::of(&regime, Width::Double, |arguments| program.interpret(arguments)).bits.mean
            };
            let (before, after) = (by(&generated.written), by(&generated.optimised));
            assert!(after <= before + ROUNDINGS, "{name}, {:?}: {before} -> {after}", regime.regime);
            found.push((before, after));
        }
    }
    let mean = |of: fn(&(f64, f64)) -> f64| found.iter().map(of).sum::<f64>() / found.len() as f64;
    let (before, after) = (mean(|pair| pair.0), mean(|pair| pair.1));
    println!("{} regimes: {before:.2} bits as written, {after:.2} by rules", found.len());
    assert!(found.len() >= 30 && after < before / 3.0, "{} regimes: {before} -> {after}", found.len());
}
