//! Ends of the range of `f64`: where a formula as written gives a value to ten digits, its stable
//! form gives that value too, even where reciprocals and products of its parts would overflow or
//! underflow.
//!
//! The forms are those of scanned kernels, of random formulas by rules alone, and of random
//! formulas by a search. The reference is exact: enclosures of the formula at the given arguments,
//! computed only where the two programs disagree. `FORMS_KERNELS` sets the number of formulas.

use forms_core::accuracy::{Format, Rounded, Truth, Value};
use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::expression::{Expr, Rational};
use forms_core::generation::Generated;
use forms_core::kernel::Program;
use forms_core::stability::{Budget, Choices, search, written};
use forms_core::theory::{Kernel, Theory};
use forms_testing::SplitMix;

fn number_of(variable: &str, usual: usize) -> usize {
    std::env::var(variable).ok().and_then(|text| text.parse().ok()).unwrap_or(usual)
}

const SIMPLE: &[f64] = &[0.0, 0.25, 0.5, 1.0, 2.0, 0.1, 3.0, 1e-3, 1e3, 1e-9, 1e9];

const EDGES: &[f64] = &[5e-324, 3e-320, 1e-310, 1e-307, 1e-300, 1e-160, 1e160, 1e300, 1e307, 1.5e308];

/// Relative error from which a form has lost the value, where the formula is within [`AGREES`] of
/// it.
const LOST: f64 = 1e-3;
const AGREES: f64 = 1e-10;

/// Magnitudes from which one more rounding can overflow to infinity, and below which it can leave
/// few digits.
const LARGE: f64 = f64::MAX / 16.0;
const SMALL: f64 = f64::MIN_POSITIVE * 16.0;

/// Generator of random arguments and formulas.
pub(super) struct Random(SplitMix);

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Random(SplitMix(seed))
    }

    fn argument(&mut self) -> f64 {
        let number = if self.0.below(2) == 0 { self.0.of(EDGES) } else { self.0.of(SIMPLE) };
        if self.0.below(2) == 0 { number } else { -number }
    }

    /// Returns a formula in which digits cancel, together with factors and divisors that can be
    /// large or small.
    fn formula(&mut self, depth: usize) -> String {
        if depth == 0 {
            return self.0.of(&["x", "y", "x", "y", "1", "2", "(x + y)", "(x - y)", "x*y"]).to_string();
        }
        let part = |random: &mut Self| random.formula(depth - 1);
        match self.0.below(14) {
            0 | 1 => format!("({})*({})", part(self), part(self)),
            2 | 3 => format!("({})/({})", part(self), part(self)),
            4 => format!("(({}) - ({}))", part(self), part(self)),
            5 => format!("(1 - cos({}))", part(self)),
            6 => format!("(exp({}) - 1)", part(self)),
            7 => format!("(sqrt(1 + ({0})**2) - 1)", part(self)),
            8 => format!("log(1 + abs({}))", part(self)),
            9 => format!("(sqrt(abs({})) - sqrt(abs({})))", part(self), part(self)),
            10 => format!("(1/({}) - 1/({}))", part(self), part(self)),
            11 => format!("(({})**2 - ({})**2)", part(self), part(self)),
            12 => format!("sqrt(({})**2 + ({})**2)", part(self), part(self)),
            _ => format!("(sin({}) - sin({}))", part(self), part(self)),
        }
    }

    fn kernel(&mut self) -> String {
        let depth = 1 + self.0.below(2);
        let domain = self.0.of(&[
            "",
            "",
            " where y > 0",
            " where x >= 0",
            " where x > 0, y > 0",
            " where -1 <= x <= 1",
        ]);
        format!("kernel k(x, y) = {} + 0*x*y{domain};", self.formula(depth))
    }
}

/// Returns the value of one output, where the formula is defined and the arguments are in the
/// domain.
fn truth(theory: &Theory, kernel: &Kernel, output: Expr, arguments: &[f64]) -> Option<f64> {
    let numbers = arguments.iter().map(|&value| Rational::from_float(value).expect("finite"));
    let point: Vec<_> = kernel.arguments.iter().copied().zip(numbers).collect();
    if Truth::new(&theory.pool, &[], &kernel.domain).admits(&point) != Some(true) {
        return None;
    }
    match Truth::new(&theory.pool, &[output], &[]).up_to(4000).at(&point, Format::Double)[0] {
        Value::Known(Rounded::Double(value)) => Some(value),
        _ => None,
    }
}

/// Whether the value is right only by chance: a neighbouring argument gives a quite different
/// value, as for the sine of a large number.
fn is_chance(formula: &Program, place: usize, arguments: &[f64]) -> bool {
    let value = formula.interpret(arguments)[place];
    (0..arguments.len()).any(|at| {
        let mut beside = arguments.to_vec();
        beside[at] = beside[at].next_up();
        let is_near = (formula.interpret(&beside)[place] - value).abs() <= LOST / 2.0 * value.abs();
        !is_near
    })
}

/// Value that a form has lost.
pub(super) struct Lost {
    pub(super) exact: f64,
    pub(super) text: String,
}

fn told(lost: &[Lost]) -> String {
    lost.iter().map(|lost| format!("{}\n", lost.text)).collect()
}

/// Returns the values that the form of a kernel has lost, among `points` random points.
pub(super) fn lost(
    theory: &Theory,
    kernel: &Kernel,
    generated: &Generated,
    points: usize,
    random: &mut Random,
) -> Vec<Lost> {
    let mut lost = Vec::new();
    // with a bound (`within`), a value that more bits do not determine is NaN by promise
    if kernel.within.is_some() {
        return lost;
    }
    for _ in 0..points {
        let arguments: Vec<f64> = kernel.arguments.iter().map(|_| random.argument()).collect();
        let by_formula = generated.written.interpret(&arguments);
        let by_form = generated.values(&arguments);
        for (place, (&formula, &form)) in by_formula.iter().zip(&by_form).enumerate() {
            let is_usual = formula == 0.0 || (SMALL..LARGE).contains(&formula.abs());
            if !is_usual || (form - formula).abs() <= LOST / 2.0 * formula.abs() {
                continue;
            }
            if is_chance(&generated.written, place, &arguments) {
                continue;
            }
            let Some(exact) = truth(theory, kernel, kernel.outputs[place], &arguments) else { continue };
            if !exact.is_finite() {
                continue;
            }
            // a zero can be exact by chance: there the form only has to give a number
            let allowed = |limit: f64| if exact == 0.0 { f64::MAX } else { limit * exact.abs() };
            let is_near = |value: f64, limit: f64| (value - exact).abs() <= allowed(limit);
            if is_near(formula, AGREES) && !is_near(form, LOST) {
                let text = format!("{arguments:?}: {exact:e}, as written {formula:e}, by the form {form:e}");
                lost.push(Lost { exact, text });
            }
        }
    }
    lost
}

#[test]
fn rules_alone_lose_no_value_at_the_ends_of_the_range() {
    let mut random = Random::new(37);
    let mut rewritten = 0;
    for _ in 0..number_of("FORMS_KERNELS", 150) {
        let text = random.kernel();
        let (mut theory, errors) = read_theory(&text);
        let Some(kernel) = theory.kernels.first().filter(|_| errors.is_empty()).cloned() else { continue };
        let Ok(generated) = compile_kernel(&mut theory.pool, &kernel) else { continue };
        if !generated.rewritten.is_empty() {
            rewritten += 1;
            let found = lost(&theory, &kernel, &generated, 24, &mut random);
            assert!(found.is_empty(), "{text}\n{}", told(&found));
        }
    }
    println!("{rewritten} formulas rewritten");
    assert!(rewritten > number_of("FORMS_KERNELS", 150) / 10, "{rewritten} rewritten");
}

#[test]
fn forms_that_a_search_chooses_lose_no_value_at_the_ends_of_the_range() {
    let budget = Budget { samples: 16, expansions: 12, places: 6, proofs: 8, failures: 4 };
    let mut random = Random::new(41);
    let count = number_of("FORMS_KERNELS", 300).div_ceil(100);
    let mut chosen = 0;
    for _ in 0..count {
        let text = random.kernel();
        let (mut theory, errors) = read_theory(&text);
        let Some(kernel) = theory.kernels.first().filter(|_| errors.is_empty()).cloned() else { continue };
        let Some(found) = search(&mut theory.pool, &kernel, budget) else { continue };
        let Some(choice) = written(&theory.pool, &[(&kernel, &found)]) else { continue };
        Choices::read(&choice).expect("a file of chosen forms").apply(&mut theory);
        let kernel = theory.kernels[0].clone();
        let Ok(generated) = compile_kernel(&mut theory.pool, &kernel) else { panic!("{text}\n{choice}") };
        chosen += 1;
        let found = lost(&theory, &kernel, &generated, 48, &mut random);
        assert!(found.is_empty(), "{text}\n{choice}\n{}", told(&found));
    }
    println!("{chosen} forms chosen");
    assert!(chosen > count / 8, "{chosen} chosen");
}
