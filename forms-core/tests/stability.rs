//! Hamming's cases and others from FPBench, and formulas of many fields: the bits they lose as written,
//! and with the forms chosen for them.

use forms_core::accuracy::{Regime, Samples, Score, Width, sample};
use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::kernel::Program;
use forms_core::stability::Choices;
use forms_core::theory::{Kernel, Theory};
use num_traits::ToPrimitive;

const CASES: &str = include_str!("../../tests/stability/hamming.forms");
const CHOICES: &str = include_str!("../../tests/stability/hamming.stable");
const APPLIED: &str = include_str!("../../tests/stability/applied.forms");
const APPLIED_CHOICES: &str = include_str!("../../tests/stability/applied.stable");

/// Kernels of many fields whose values need more precision at some arguments: their values vanish
/// inside the domain, or are too small for `f64` on the way.
const NEED_PRECISION: [&str; 6] =
    ["atmosphere", "angle_of_vectors", "sum_of_logarithms", "option_price", "sphere_hit", "fisheye"];

/// Number of samples in each regime, and the seed. The samples differ from those of the search, so
/// that a form is not judged by the samples for which it was chosen.
const SAMPLES: usize = 24;
const SEED: u64 = 11;

/// Names of the cases in Hamming's chapter, Herbie and FPBench, and the kernels that represent
/// them: a name of the language begins with a letter.
const NAMED: [(&str, &str); 29] = [
    ("2sqrt", "two_sqrt"),
    ("2isqrt", "two_isqrt"),
    ("2cbrt", "two_cbrt"),
    ("2frac", "two_frac"),
    ("2sin", "two_sin"),
    ("2cos", "two_cos"),
    ("2tan", "two_tan"),
    ("2log", "two_log"),
    ("2atan", "two_atan"),
    ("expm1", "exponential_less_one"),
    ("exp2", "exp2"),
    ("expq2", "expq2"),
    ("expq3", "expq3"),
    ("expax", "expax"),
    ("cos2", "cos2"),
    ("tanhf", "tanhf"),
    ("sqrtexp", "sqrtexp"),
    ("sintan", "sintan"),
    ("quadp", "quadp"),
    ("quadm", "quadm"),
    ("qlog", "qlog"),
    ("logq", "logq"),
    ("invcot", "invcot"),
    ("logs", "logs"),
    ("3frac", "three_frac"),
    ("hypot", "hypot"),
    ("Heron's triangle area", "triangle_area"),
    ("sphere cap", "sphere_cap"),
    ("disk cap", "disk_cap"),
];

/// Maximum mean loss of any case with its form, in bits over all regimes.
const MOST_LOST: f64 = 1.0;

fn theories(cases: &str, choices: &str) -> (Theory, usize) {
    let (mut theory, errors) = read_theory(cases);
    assert!(errors.is_empty(), "{errors:?}");
    let choices = Choices::read(choices).expect("a file of choices");
    let applied = choices.apply(&mut theory);
    (theory, applied)
}

/// Returns the mean over the regimes of the mean loss in each.
fn loss(samples: &[Samples], mut values: impl FnMut(&[f64]) -> Vec<f64>) -> f64 {
    let means = samples.iter().map(|regime| Score::of(regime, Width::Double, &mut values).bits.mean);
    means.sum::<f64>() / samples.len() as f64
}

/// Returns the loss as written, and with the chosen form.
fn losses(theory: &mut Theory, kernel: &Kernel) -> (f64, f64) {
    let generated = compile_kernel(&mut theory.pool, kernel).unwrap_or_else(|errors| panic!("{errors:?}"));
    assert!(generated.translation.is_proved(), "{}: {}", kernel.name, generated.translation);
    let samples = sample(&theory.pool, kernel, Width::Double, &Regime::ALL, SAMPLES, SEED);
    let by = |program: &Program| loss(&samples, |arguments| program.interpret(arguments));
    let after = match kernel.within.as_ref().and_then(ToPrimitive::to_f64) {
        Some(within) => loss(&samples, |arguments| generated.optimised.interpret_within(arguments, within)),
        None => by(&generated.optimised),
    };
    (by(&generated.written), after)
}

#[test]
fn every_case_that_has_a_name_is_there() {
    let (theory, _) = theories(CASES, CHOICES);
    for (name, kernel) in NAMED {
        assert!(theory.kernels.iter().any(|known| known.name == kernel), "{name}");
    }
    assert_eq!(theory.kernels.len(), NAMED.len());
}

/// Checks that every kernel has a valid entry, and returns its losses as written and with its form.
fn all_losses(cases: &str, choices: &str) -> Vec<(Kernel, f64, f64)> {
    let (mut theory, applied) = theories(cases, choices);
    let kernels = theory.kernels.clone();
    assert_eq!(
        applied,
        kernels.len(),
        "every case has a valid entry: forms accuracy --write makes them anew"
    );
    let losses = kernels.into_iter().map(|kernel| {
        let (before, after) = losses(&mut theory, &kernel);
        println!("{:<22}{before:>6.2}{after:>6.2}", kernel.name);
        (kernel, before, after)
    });
    losses.collect()
}

#[test]
fn chosen_forms_lose_less_than_a_bit_on_the_mean() {
    let found = all_losses(CASES, CHOICES);
    let mean = |of: fn(&(Kernel, f64, f64)) -> f64| found.iter().map(of).sum::<f64>() / found.len() as f64;
    let (before, after) = (mean(|case| case.1), mean(|case| case.2));
    println!("{:<22}{before:>6.2}{after:>6.2}", "mean");
    assert!(before > 10.0 && after < 1.0, "{before} {after}");
    for (kernel, before, after) in found {
        assert!(after < before && after < MOST_LOST, "{}: {before} {after}", kernel.name);
    }
}

#[test]
fn formulas_of_many_fields_have_forms_that_are_accurate_in_f64() {
    let found = all_losses(APPLIED, APPLIED_CHOICES);
    for (kernel, before, after) in &found {
        assert!(*after < MOST_LOST, "{}: {before} {after}", kernel.name);
    }
    let promised = found.iter().filter(|(kernel, ..)| kernel.within.is_some());
    let promised: Vec<&str> = promised.map(|(kernel, ..)| kernel.name.as_str()).collect();
    assert_eq!(promised, NEED_PRECISION);
}
