//! Functions that WGSL lacks keep their bounds on every device, and entry points compute their
//! kernels at every row of their buffers.

use crate::emitted::{Inputs, kernels};
use crate::formula::Formulas;
use crate::shader::{Float, Shader, Value};
use crate::targets::{emitted, has_functions, sources};
use forms_core::emission::{Precision, Target, emit};
use forms_core::expression::Operation;
use forms_core::rounding::Arithmetic;
use forms_math::Real;

const UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// Value of a function in `f64`.
type Truth = fn(f64) -> f64;

/// Functions that WGSL lacks, with their values.
const FUNCTIONS: [(Operation, Truth); 3] = [
    (Operation::Expm1, |x| x.exp_m1()),
    (Operation::Log1p, |x| x.ln_1p()),
    (Operation::Erf, |x| <f64 as Real>::erf(x)),
];

/// Returns arguments of every size and sign in steps of a few per mille, and the ends of the pieces
/// of the functions with their neighbours.
fn arguments() -> Vec<f32> {
    let sizes = (0..30_000).map(|step| (step as f32 * 0.004 - 60.0).exp2());
    let ends = [0.41, 0.29, 1.0, 4.0, 18.0, 88.8, 88.7, 0.28768207, 0.4054651];
    let ends = ends.into_iter().flat_map(|end: f32| [end.next_down(), end, end.next_up()]);
    sizes.chain(ends).flat_map(|x| [x, -x]).collect()
}

fn called(operation: Operation) -> Shader {
    let mut formulas = Formulas::over("x");
    let value = formulas.parse(&format!("{}(x)", operation.row().name));
    let program = formulas.named("k").program(&[value]);
    Shader::new(&emit(&sources(&[program]), Target::Wgsl, Precision::F32).expect("a definition"))
}

#[test]
fn functions_that_wgsl_lacks_keep_their_bounds_on_every_device() {
    for (operation, truth) in FUNCTIONS {
        let bound = Arithmetic::SHADER.function_error(operation);
        let mut shader = called(operation);
        for x in arguments() {
            let exact = truth(x.into());
            let is_inside = exact.is_finite() && exact.abs() <= f32::MAX.into();
            if !is_inside {
                continue;
            }
            let value = shader.call("k", &[Value::Float(Float::exactly(x))]).float();
            let error = ((value.exact - exact).abs() + value.error) / exact.abs();
            assert!(error <= bound, "{operation:?} at {x}: {} units", error / UNIT);
            let rounded = (f64::from(value.nearest) - exact).abs() / exact.abs();
            assert!(rounded <= bound, "{operation:?} at {x}: {} is not {exact}", value.nearest);
        }
    }
}

#[test]
fn functions_that_wgsl_lacks_are_nan_at_nan_and_have_their_limits() {
    let infinity = f32::INFINITY;
    let limits = [
        (Operation::Expm1, infinity, infinity),
        (Operation::Expm1, -infinity, -1.0),
        (Operation::Expm1, 0.0, 0.0),
        (Operation::Log1p, infinity, infinity),
        (Operation::Log1p, -1.0, -infinity),
        (Operation::Log1p, 0.0, 0.0),
        (Operation::Erf, infinity, 1.0),
        (Operation::Erf, -infinity, -1.0),
        (Operation::Erf, 0.0, 0.0),
    ];
    let value =
        |operation, x| called(operation).call("k", &[Value::Float(Float::exactly(x))]).float().nearest;
    for (operation, x, limit) in limits {
        assert_eq!(value(operation, x), limit, "{operation:?} at {x}");
        assert!(value(operation, f32::NAN).is_nan(), "{operation:?}");
    }
}

/// Values of `f64` are exact here: the squares of numbers of 24 bits have 48.
#[test]
fn lengths_in_wgsl_keep_their_bound_and_do_not_overflow() {
    let mut formulas = Formulas::over("x y");
    let value = formulas.parse("hypot(x, y)");
    let program = formulas.named("k").program(&[value]);
    let text = emit(&sources(&[program]), Target::Wgsl, Precision::F32).expect("a definition");
    let bound = Arithmetic::SHADER.function_error(Operation::Hypot);
    assert!(text.contains(&format!("relative error is at most {} * 2^-24.", bound / UNIT)), "{text}");
    let mut shader = Shader::new(&text);
    let mut at =
        |x: f32, y: f32| shader.call("k", &[Float::exactly(x), Float::exactly(y)].map(Value::Float)).float();
    for x in arguments().into_iter().step_by(97) {
        for ratio in [0.0, 1e-9, 0.01, 0.3, 0.999_999, 1.0, -1.5, 3e4] {
            let y = x * ratio;
            let exact = f64::from(x).hypot(f64::from(y));
            let value = at(x, y);
            let error = ((value.exact - exact).abs() + value.error) / exact;
            assert!(error <= bound, "hypot({x}, {y}): {} units", error / UNIT);
        }
    }
    let large = at(3e38, 1e38).nearest;
    assert!((large - 3.162_277_7e38).abs() < 1e33, "{large}");
    assert_eq!([at(0.0, 0.0), at(f32::INFINITY, 1.0)].map(|value| value.nearest), [0.0, f32::INFINITY]);
    assert!(at(f32::NAN, 1.0).nearest.is_nan() && at(0.0, f32::NAN).nearest.is_nan());
}

#[test]
fn comments_state_the_bounds_of_the_arithmetic() {
    for (operation, _) in FUNCTIONS {
        let mut formulas = Formulas::over("x");
        let value = formulas.parse(&format!("{}(x)", operation.row().name));
        let program = formulas.named("k").program(&[value]);
        let text = emit(&sources(&[program]), Target::Wgsl, Precision::F32).expect("a definition");
        let units = Arithmetic::SHADER.function_error(operation) / UNIT;
        assert!(text.contains(&format!("relative error is at most {units} * 2^-24.")), "{text}");
    }
}

#[test]
fn entry_points_compute_their_kernels_at_every_row() {
    let programs = kernels();
    let text = emitted(Target::Wgsl, Precision::F32);
    let mut inputs = Inputs(11);
    let mut numbers = std::iter::repeat_with(|| inputs.next()).filter(|x| x.is_finite() && *x > 0.0);
    let rows = 67;
    for program in &programs {
        let (arguments, outputs) = (program.arguments().len(), program.outputs().len());
        let columns: Vec<f32> = numbers.by_ref().take(arguments * rows).map(|x| x as f32).collect();
        let mut shader = Shader::new(&text);
        let floats = columns.iter().map(|&x| Value::Float(Float::exactly(x))).collect();
        shader.buffers.insert("forms_arguments".into(), floats);
        let empty = vec![Value::Float(Float::exactly(7.0)); outputs * rows + 1];
        shader.buffers.insert("forms_outputs".into(), empty);
        shader.buffers.insert("forms_count".into(), vec![Value::Unsigned(rows as u32)]);
        shader.dispatch(&format!("{}_batch", program.name()), rows as u32);
        let written = &shader.buffers["forms_outputs"];
        for row in 0..rows {
            let x: Vec<f64> = (0..arguments).map(|place| columns[place * rows + row].into()).collect();
            for (output, expected) in program.interpret(&x).into_iter().enumerate() {
                let found = f64::from(written[output * rows + row].float().nearest);
                let allowed = if has_functions(program) { 1e-4 } else { 1e-5 };
                let is_close = (found - expected).abs() <= allowed * expected.abs().max(1.0);
                let is_nan = found.is_nan() && expected.is_nan();
                assert!(is_close || is_nan, "{} at {x:?}: {found}, not {expected}", program.name());
            }
        }
        assert_eq!(written[outputs * rows].float().nearest, 7.0, "{} writes beyond its rows", program.name());
    }
}
