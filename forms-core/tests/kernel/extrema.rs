//! Minima and maxima in kernels: one comparison each, exact values and derivatives.

use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::kernel::{Instruction, Program};

/// Returns the programs of the kernels of a source, as written and as optimised, which are proved.
fn programs(text: &str) -> Vec<Program> {
    let (mut theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{text}: {errors:?}");
    let kernels = theory.kernels.clone();
    let generated = kernels.iter().map(|kernel| compile_kernel(&mut theory.pool, kernel));
    let generated = generated.map(|kernel| kernel.unwrap_or_else(|errors| panic!("{text}: {errors:?}")));
    generated
        .flat_map(|kernel| {
            assert!(kernel.translation.is_proved(), "{text}: {}", kernel.translation);
            [kernel.written, kernel.optimised]
        })
        .collect()
}

#[test]
fn a_minimum_or_maximum_is_one_comparison_whatever_its_operands_are() {
    for pair in
        ["x, y", "x, 0", "0, x", "x, 3", "-1, x", "x, -y", "-x, y", "x*y, x + y", "x, x - y", "1/x, 0"]
    {
        for name in ["min", "max"] {
            for program in programs(&format!("kernel k(x, y) = {name}({pair});")) {
                let (mut choices, mut magnitudes) = (0, 0);
                for instruction in program.instructions() {
                    choices += usize::from(matches!(instruction, Instruction::Select { .. }));
                    magnitudes += usize::from(matches!(instruction, Instruction::Call(..)));
                }
                assert_eq!((choices, magnitudes), (1, 0), "{name}({pair})");
            }
        }
    }
}

#[test]
fn values_are_those_of_the_operands() {
    let cases: [(&str, [f64; 2], f64); 12] = [
        ("min(x, y)", [1e20, 1.0], 1.0),
        ("max(x, y)", [-1e20, 1.0], 1.0),
        ("min(x, y)", [1e308, -1e308], -1e308),
        ("max(x, y)", [f64::INFINITY, 2.0], f64::INFINITY),
        ("min(x, y)", [f64::INFINITY, 2.0], 2.0),
        ("min(max(x, 0), 1)", [0.3, 0.0], 0.3),
        ("min(max(x, 0), 1)", [-7.0, 0.0], 0.0),
        ("max(x, max(y, 1/10))", [0.05, 0.07], 0.1),
        ("max(x, y)*min(x, y)", [3.0, 5.0], 15.0),
        ("copysign(x, y)", [-3.0, 1e-300], 3.0),
        ("copysign(x, y)", [2.0, -5.0], -2.0),
        ("sec(x) + csc(y) + cot(y)", [0.0, std::f64::consts::FRAC_PI_2], 2.0),
    ];
    for (formula, arguments, value) in cases {
        for program in programs(&format!("kernel k(x, y) = {formula};")) {
            let found = program.interpret(&arguments)[0];
            assert!(
                (found - value).abs() <= 1e-15 * value.abs() || found == value,
                "{formula} at {arguments:?}: {found}"
            );
        }
    }
}

#[test]
fn nan_in_either_operand_gives_nan() {
    for formula in ["min(x, y)", "max(x, y)", "min(y, x)", "max(y, x)", "hypot(x, y)", "copysign(x, y)"] {
        for program in programs(&format!("kernel k(x, y) = {formula};")) {
            for arguments in [[f64::NAN, 1.0], [1.0, f64::NAN], [f64::INFINITY, f64::NAN]] {
                assert!(program.interpret(&arguments)[0].is_nan(), "{formula} at {arguments:?}");
            }
        }
    }
}

#[test]
fn the_sign_of_zero_is_that_of_the_operand_that_is_documented() {
    let sign = |formula: &str, arguments: [f64; 2]| -> Vec<bool> {
        let programs = programs(&format!("kernel k(x, y) = {formula};"));
        programs.iter().map(|program| program.interpret(&arguments)[0].is_sign_negative()).collect()
    };
    assert_eq!(sign("min(x, y)", [-0.0, 0.0]), [false, false]);
    assert_eq!(sign("min(x, y)", [0.0, -0.0]), [true, true]);
    assert_eq!(sign("max(x, y)", [-0.0, 0.0]), [true, true]);
    assert_eq!(sign("max(x, y)", [0.0, -0.0]), [false, false]);
}

#[test]
fn derivatives_are_those_of_the_selected_operand_and_do_not_exist_at_the_seam() {
    let text = "kernel k(x, y) = min(10**20*x, x + y**2); kernel j = jacobian(k; x, y);
        kernel m(x) = max(x, 0); kernel n = jacobian(m; x);";
    let programs = programs(text);
    for program in programs.iter().filter(|program| program.name() == "j") {
        assert_eq!(program.interpret(&[1.0, 3.0]), [1.0, 6.0]);
        assert_eq!(program.interpret(&[-1.0, 3.0]), [1e20, 0.0]);
    }
    for program in programs.iter().filter(|program| program.name() == "n") {
        let [left, seam, right] = [-2.0, 0.0, 2.0].map(|x| program.interpret(&[x])[0]);
        assert!((left, right) == (0.0, 1.0) && seam.is_nan(), "{left} {seam} {right}");
    }
}
