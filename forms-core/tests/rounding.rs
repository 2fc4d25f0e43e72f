//! Bounds of rounding errors: no sample exceeds them, and they are sharp.

use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::enclosure::{Enclosure, Precision, enclose};
use forms_core::expression::{Pool, Rational};
use forms_core::kernel::Program;
use forms_core::rounding::{Arithmetic, ErrorBound, Unbounded};
use forms_core::theory::Kernel;
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Maximum number of boxes for each kernel of the tests.
const BOXES: usize = 300;

struct Bounded {
    pool: Pool,
    kernel: Kernel,
    program: Program,
}

fn kernel(text: &str) -> Bounded {
    let (mut theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{text}: {errors:?}");
    let kernel = theory.kernels.last().cloned().expect("a kernel");
    let program = compile_kernel(&mut theory.pool, &kernel).expect("generated").optimised;
    Bounded { pool: theory.pool, kernel, program }
}

impl Bounded {
    fn bounds(&self) -> Result<Vec<ErrorBound>, Unbounded> {
        self.program.error_bound(BOXES)
    }

    /// Returns the values at exact arguments, to far more places than a kernel computes.
    fn truth(&self, arguments: &[f64]) -> Vec<Rational> {
        let precision = Precision(600);
        let exact =
            |value: f64| Enclosure::exact(&BigRational::from_float(value).expect("finite"), precision);
        let value = |symbol| {
            let place = self.kernel.arguments.iter().position(|&argument| argument == symbol)?;
            Some(exact(arguments[place]))
        };
        let values = enclose(&self.pool, &self.kernel.outputs, &value, &mut |_, _, _| None, precision);
        values.into_iter().map(|value| value.expect("defined inside the domain").lower()).collect()
    }
}

/// Range of each argument.
type Ranges = &'static [(f64, f64)];

/// Kernels of one or two arguments with the ranges of the arguments, and the largest relative
/// bound, in units of 2⁻⁵³, that is sharp enough.
const KERNELS: &[(&str, Ranges, f64)] = &[
    ("kernel k(x) = x*x*x where 1 <= x <= 1024;", &[(1.0, 1024.0)], 2.1),
    ("kernel k(x) = 1/3*x where 1e-3 <= x <= 1e3;", &[(1e-3, 1e3)], 2.1),
    ("kernel k(x) = sqrt(x + 1) - sqrt(x) where 1 <= x <= 16;", &[(1.0, 16.0)], 120.0),
    ("kernel k(x) = 1/(sqrt(x + 1) + sqrt(x)) where 1 <= x <= 1e4;", &[(1.0, 1e4)], 4.6),
    ("kernel k(x, y) = x/(x**2 + y**2) where 1 <= x <= 8, 1 <= y <= 8;", &[(1.0, 8.0), (1.0, 8.0)], 6.0),
    ("kernel k(x) = exp(-x)*cos(x) where 0 <= x <= 1;", &[(0.0, 1.0)], 20.0),
    ("kernel k(x) = expm1(x)/x where 1e-6 <= x <= 1;", &[(1e-6, 1.0)], 8.0),
    ("kernel k(x, y) = atan2(y, x)*log(x) where 2 <= x <= 4, 1 <= y <= 2;", &[(2.0, 4.0), (1.0, 2.0)], 20.0),
    ("kernel k(x) = x**(3/2) + x**-2 where 1/8 <= x <= 8;", &[(0.125, 8.0)], 8.0),
    (
        "kernel k(g, c) = (1 - g**2)/(4*pi*(1 + g**2 - 2*g*c)**(3/2)) where 0 <= g <= 1/2, -1 <= c <= 1;",
        &[(0.0, 0.5), (-1.0, 1.0)],
        60.0,
    ),
    // a branch without a value at 0, and a seam inside the domain
    (
        "kernel k(x) = if jump abs(x) < 1/2 { 1/6 - x**2/120 } else { (1 - sin(x)/x)/x**2 } where abs(x) <= 8;",
        &[(-8.0, 8.0)],
        150.0,
    ),
    ("kernel k(x) = if jump x < 1 { 1 + x } else { 100*x } where 0 <= x <= 4;", &[(0.0, 4.0)], 4.0),
];

/// Numbers between two ends: uniform over the binades if both ends are positive, otherwise uniform.
fn number((lower, upper): (f64, f64)) -> BoxedStrategy<f64> {
    if lower > 0.0 {
        (lower.to_bits()..=upper.to_bits()).prop_map(f64::from_bits).boxed()
    } else {
        (lower..=upper).boxed()
    }
}

#[test]
fn no_sample_exceeds_the_bound_and_the_bound_is_sharp() {
    for (text, ranges, sharp) in KERNELS {
        let bounded = kernel(text);
        let bound = bounded.bounds().unwrap_or_else(|reason| panic!("{text}: {reason}"))[0];
        let units = bound.units().unwrap_or_else(|| panic!("{text}: no relative bound"));
        assert!(units <= *sharp, "{text}: {units} units");
        let arguments: Vec<BoxedStrategy<f64>> = ranges.iter().map(|&range| number(range)).collect();
        let mut runner = TestRunner::new(Config { failure_persistence: None, ..Config::with_cases(200) });
        let within = runner.run(&arguments, |arguments| {
            let (computed, truth) = (bounded.program.interpret(&arguments)[0], &bounded.truth(&arguments)[0]);
            let exact = |value: f64| BigRational::from_float(value).expect("finite");
            let error = (exact(computed) - truth).abs();
            prop_assert!(error <= exact(bound.absolute), "{text} at {arguments:?}: {computed}");
            let relative = bound.relative.expect("seen above");
            prop_assert!(error <= exact(relative) * truth.abs(), "{text} at {arguments:?}: {computed}");
            Ok(())
        });
        within.unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn more_boxes_make_a_bound_sharper() {
    // a difference of two numbers that no rule rewrites
    let program = kernel("kernel k(x) = sqrt(x*x + x) - x*x/4 where 1 <= x <= 4;").program;
    let units = [1, 10, 100, 1000].map(|boxes| {
        program.error_bound(boxes).ok().and_then(|bounds| bounds[0].units()).unwrap_or(f64::INFINITY)
    });
    assert!(units.is_sorted_by(|a, b| a >= b) && units[3] < 0.7 * units[0], "{units:?}");
}

#[test]
fn what_is_not_bounded_says_why() {
    let reason = |text: &str| kernel(text).bounds().expect_err(text).to_string();
    assert_eq!(
        reason("kernel k(x, y) = x + y where 0 < x < 1, y > 0;"),
        "the domain does not bound `y` on both sides"
    );
    assert_eq!(reason("kernel k(x) = 1/x where -1 <= x <= 1;"), "no bound was found on the whole domain");
    assert_eq!(
        reason("kernel k(x) = log(x) where 0 <= x <= 1e-3;"),
        "no bound was found on the whole domain"
    );
}

#[test]
fn arguments_that_are_not_used_need_no_bound() {
    assert!(kernel("kernel k(x, y) = 2*x where 0 < x < 1;").bounds().is_ok());
}

#[test]
fn a_value_that_crosses_zero_has_an_absolute_bound_only() {
    let bound = kernel("kernel k(x) = x**3 - x where -2 <= x <= 2;").bounds().expect("bounded")[0];
    assert!(bound.relative.is_none() && bound.absolute < 2.5e-15, "{bound:?}");
}

/// At 1.2094912707964283e23, next to an odd multiple of π/2, glibc 2.36 is wrong by 16,655 ulps.
#[test]
fn the_cosine_of_large_angles_has_an_absolute_bound_only() {
    let units = |text: &str| kernel(text).bounds().expect("a bound")[0].units();
    assert!(units("kernel small(x) = 2 + cos(x) where 1 <= x <= 2;").is_some());
    assert!(units("kernel large(x) = 2 + cos(x) where 1e23 <= x <= 2e23;").is_some());
    assert_eq!(units("kernel near(x) = cos(x) where 1e23 <= x <= 2e23;"), None);
}

/// WGSL can round the product of `fma`, so that the correction of a compensated product can be 0, and
/// adding it is one more rounding: 1 ulp, two units.
#[test]
fn the_correction_of_a_compensated_sum_is_a_rounding_in_wgsl() {
    let units = |stable: &str| {
        let domain = "1 <= a <= 1.001, 1 <= b <= 1.001, 1 <= c <= 1.001, 1 <= d <= 1.001";
        let bounded = kernel(&format!("kernel k(a, b, c, d) = a*b + c*d {stable} where {domain};"));
        let bounds = bounded.program.error_bound_in(Arithmetic::SHADER, BOXES).expect("a bound");
        bounds[0].relative.expect("a relative bound") / Arithmetic::SHADER.unit
    };
    let (plain, compensated) = (units(""), units("by a*b + c*d"));
    assert!((3.99..4.1).contains(&plain), "{plain}");
    assert!((5.99..6.1).contains(&compensated), "{compensated}");
}
