//! Hamming's cases and others from FPBench: the bits they lose as written, and with the forms
//! chosen for them.

use forms_core::accuracy::{Regime, Samples, Score, Width, sample};
use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::kernel::Program;
use forms_core::stability::Choices;
use forms_core::theory::{Kernel, Theory};

const CASES: &str = include_str!("../../tests/stability/hamming.forms");
const CHOICES: &str = include_str!("../../tests/stability/hamming.stable");

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

fn theories() -> (Theory, usize) {
    let (mut theory, errors) = read_theory(CASES);
    assert!(errors.is_empty(), "{errors:?}");
    let choices = Choices::read(CHOICES).expect("a file of choices");
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
    let promised = kernel.within.is_some();
    let after = if promised {
        loss(&samples, |arguments| generated.optimised.interpret_within(arguments, 2.0))
    } else {
        by(&generated.optimised)
    };
    (by(&generated.written), after)
}

#[test]
fn every_case_that_has_a_name_is_there() {
    let (theory, _) = theories();
    for (name, kernel) in NAMED {
        assert!(theory.kernels.iter().any(|known| known.name == kernel), "{name}");
    }
    assert_eq!(theory.kernels.len(), NAMED.len());
}

#[test]
fn chosen_forms_lose_less_than_a_bit_on_the_mean() {
    let (mut theory, applied) = theories();
    let kernels = theory.kernels.clone();
    assert_eq!(
        applied,
        kernels.len(),
        "every case has a valid entry: forms accuracy --write makes them anew"
    );
    let found: Vec<(f64, f64)> = kernels.iter().map(|kernel| losses(&mut theory, kernel)).collect();
    let lines: Vec<String> = kernels
        .iter()
        .zip(&found)
        .map(|(kernel, (before, after))| format!("{:<22}{before:>6.2}{after:>6.2}", kernel.name))
        .collect();
    println!("{}", lines.join("\n"));
    let mean = |of: fn(&(f64, f64)) -> f64| found.iter().map(of).sum::<f64>() / found.len() as f64;
    let (before, after) = (mean(|pair| pair.0), mean(|pair| pair.1));
    println!("{:<22}{before:>6.2}{after:>6.2}", "mean");
    assert!(before > 10.0 && after < 1.0, "{before} {after}\n{}", lines.join("\n"));
    for ((before, after), line) in found.iter().zip(&lines) {
        assert!(after < before && *after < MOST_LOST, "{line}");
    }
}
