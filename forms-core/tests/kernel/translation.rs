//! Translation validation: an optimised kernel is proved equal to the formula as written.

use crate::counts::{BILINEAR, bilinear_formulas, known_kernels};
use crate::formula::Formulas;
use forms_core::expression::Expr;
use forms_core::normal::{Tower, Trigonometry, normalise};

/// Whether the normal form of a − b is zero, where the radicands are positive.
fn is_proved_equal(formulas: &mut Formulas, a: Expr, b: Expr) -> bool {
    let difference = formulas.pool.subtract(a, b);
    let mut tower = Tower::new(Trigonometry::Circle);
    let normalised = normalise(&mut tower, &formulas.pool, &[difference]);
    let exact = normalised.and_then(|normalised| normalised.exact(&mut tower, &formulas.pool));
    exact.is_ok_and(|fractions| fractions[0].is_zero())
}

fn is_optimised_truly(formulas: &mut Formulas, outputs: &[Expr]) -> bool {
    let optimised = formulas.program(outputs).optimise();
    let arguments = formulas.arguments.clone();
    let raised = optimised.raise(&mut formulas.pool, &arguments);
    raised.outputs.iter().zip(outputs).all(|(&raised, &written)| is_proved_equal(formulas, raised, written))
}

#[test]
fn every_optimised_kernel_is_proved_equal_to_its_formula() {
    for mut kernel in known_kernels() {
        assert!(is_optimised_truly(&mut kernel.formulas, &kernel.outputs), "{}", kernel.name);
    }
}

#[test]
fn the_optimised_bilinear_patch_is_proved_equal_to_its_formula() {
    for (name, spelling) in BILINEAR {
        let (mut formulas, output) = bilinear_formulas(spelling);
        assert!(is_optimised_truly(&mut formulas, &[output]), "{name}");
    }
}

#[test]
fn a_kernel_with_one_sign_wrong_is_not_proved() {
    let mut formulas = Formulas::over("x y");
    let [written, wrong] = ["(x - y)**2/sqrt(x)", "(x + y)**2/sqrt(x)"].map(|text| formulas.parse(text));
    assert!(!is_proved_equal(&mut formulas, wrong, written));
}
