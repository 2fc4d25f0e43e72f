//! Values in floating point: the optimised kernel against the formula as written.

use crate::counts::{BILINEAR, Known, bilinear, known_kernels};
use crate::formula::{Formulas, program};
use forms_core::expression::{Expr, Symbol};
use forms_core::kernel::{Program, evaluate_f64};
use proptest::prelude::*;

/// Tolerance in units in the last place, times the condition of the formula.
const ULPS: f64 = 32.0;

fn written(formulas: &Formulas, outputs: &[Expr], point: &[f64]) -> Vec<f64> {
    let values: Vec<(Symbol, f64)> = formulas.arguments.iter().copied().zip(point.iter().copied()).collect();
    evaluate_f64(&formulas.pool, outputs, &values).expect("a value for every variable")
}

/// Returns |f| + Σ |xᵢ ∂f/∂xᵢ| for every output: the sensitivity to relative errors in the
/// variables.
fn conditions(formulas: &Formulas, outputs: &[Expr], point: &[f64]) -> Vec<f64> {
    let step = 1e-6;
    let mut sums: Vec<f64> = written(formulas, outputs, point).iter().map(|value| value.abs()).collect();
    for place in 0..point.len() {
        let shifted = |by: f64| {
            let mut point = point.to_vec();
            point[place] *= 1.0 + by;
            written(formulas, outputs, &point)
        };
        for (sum, (above, below)) in sums.iter_mut().zip(shifted(step).iter().zip(shifted(-step))) {
            *sum += ((above - below) / (2.0 * step)).abs();
        }
    }
    sums
}

fn agrees(formulas: &Formulas, outputs: &[Expr], program: &Program, point: &[f64]) -> bool {
    let expected = written(formulas, outputs, point);
    let found = program.interpret(&point[..formulas.arguments.len()]);
    let conditions = conditions(formulas, outputs, point);
    let close = |((expected, found), condition): ((&f64, &f64), &f64)| {
        (expected - found).abs() <= ULPS * f64::EPSILON * condition
    };
    expected.iter().zip(&found).zip(&conditions).all(close)
}

#[test]
fn optimised_kernels_agree_with_their_formulas() {
    let kernels: Vec<(Known, Program)> = known_kernels()
        .into_iter()
        .map(|kernel| {
            let optimised = kernel.program().optimise();
            (kernel, optimised)
        })
        .collect();
    proptest!(ProptestConfig::with_cases(64), |(point in prop::collection::vec(0.1f64..0.9, 14))| {
        for (kernel, optimised) in &kernels {
            let point = &point[..kernel.formulas.arguments.len()];
            prop_assert!(agrees(&kernel.formulas, &kernel.outputs, optimised, point), "{}", kernel.name);
        }
    });
}

#[test]
fn every_spelling_of_the_bilinear_patch_has_one_value() {
    let written = bilinear(BILINEAR[0].1);
    let spellings = BILINEAR.map(|(_, spelling)| bilinear(spelling).optimise());
    proptest!(|(point in prop::collection::vec(0.1f64..0.9, 14))| {
        let expected = written.interpret(&point)[0];
        for spelling in &spellings {
            let value = spelling.interpret(&point)[0];
            prop_assert!((value - expected).abs() < 1e-12 * (1.0 + expected.abs()), "{value}, {expected}");
        }
    });
}

proptest! {
    #[test]
    fn polynomials_of_whole_numbers_are_exact(x in -40i32..40, y in -40i32..40) {
        let program = program("x y", &["(x - 2*y)**5 - 7*x**3*y + 3*(x + y)*(x - y) + 11"]);
        let (a, b) = (i64::from(x), i64::from(y));
        let expected = (a - 2 * b).pow(5) - 7 * a.pow(3) * b + 3 * (a + b) * (a - b) + 11;
        let point = [f64::from(x), f64::from(y)];
        prop_assert_eq!(program.interpret(&point)[0], expected as f64);
        prop_assert_eq!(program.optimise().interpret(&point)[0], expected as f64);
    }
}

#[test]
fn outside_its_domain_and_at_nan_a_kernel_is_nan() {
    let mut formulas = Formulas::over("x");
    let (x, one, value) =
        (formulas.parse("x"), formulas.parse("1"), formulas.parse("if x < 2 { x } else { 5 }"));
    let domain = [(one, forms_core::expression::Relation::LessEqual, x)];
    let program = formulas.program_where(&[value, x], &domain).optimise();
    assert_eq!(program.interpret(&[1.0]), [1.0, 1.0]);
    assert_eq!(program.interpret(&[3.0]), [5.0, 3.0]);
    for outside in [0.5, f64::NEG_INFINITY, f64::NAN] {
        assert!(program.interpret(&[outside]).iter().all(|value| value.is_nan()), "{outside}");
    }
}

#[test]
fn a_branch_not_taken_leaves_no_trace() {
    let program = program("x", &["if 0 < x { log(x) } else { sqrt(-x) + 1/(x - 1) }"]).optimise();
    assert_eq!(program.interpret(&[1.0]), [0.0]);
    assert_eq!(program.interpret(&[-1.0]), [0.5]);
    assert!(program.interpret(&[f64::NAN])[0].is_nan());
}
