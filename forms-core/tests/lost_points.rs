//! Forms that lose points: for random pairs of a formula and a form of it, the accepted forms have
//! the value of the formula at every point where the formula is defined. The same holds for the
//! results of the rules on random formulas.
//!
//! The reference shares nothing with the proof: both sides are enclosed at each point of a grid of
//! exact numbers on which the strata of the pairs lie (a = 0, a = b, |a| = 1, a b = 0).
//! `FORMS_KERNELS` sets the number of pairs.

use forms_core::accuracy::{Format, Truth, Value};
use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::expression::{Expr, Pool, Rational, Symbol};
use forms_core::theory::Kernel;
use forms_testing::SplitMix;

/// Returns the number of pairs.
fn count() -> usize {
    std::env::var("FORMS_KERNELS").ok().and_then(|text| text.parse().ok()).unwrap_or(150)
}

const GRID: [(i64, i64); 9] = [(0, 1), (1, 1), (-1, 1), (2, 1), (-2, 1), (1, 2), (-1, 2), (1, 4), (-1, 4)];

/// Formulas of a and b, each with a form that is equal to it wherever both are defined, with rare
/// exceptions.
const PAIRS: &[(&str, &str)] = &[
    ("sqrt(A**2 + B**2)", "abs(A)*sqrt(1 + (B/A)**2)"),
    ("sqrt(A**2 + B**2)", "if jump A != 0 { abs(A)*sqrt(1 + (B/A)**2) } else { abs(B) }"),
    ("A + B", "(A**2 - B**2)/(A - B)"),
    ("(A**2 - B**2)/(A - B)", "A + B"),
    ("A*B", "A**2*B/A"),
    ("1/A - 1/B", "(B - A)/(A*B)"),
    ("1/A", "B/(A*B)"),
    ("sqrt(A) - sqrt(B)", "(A - B)/(sqrt(A) + sqrt(B))"),
    ("sqrt(1 + A**2) - sqrt(A**2)", "1/(sqrt(1 + A**2) + sqrt(A**2))"),
    ("log(A*B)", "log(A) + log(B)"),
    ("log(A) + log(B)", "log(A*B)"),
    ("log(A**2)", "2*log(abs(A))"),
    ("acos(A)", "2*atan2(sqrt(1 - A), sqrt(1 + A))"),
    ("acos(A)", "atan2(sqrt((1 - A)*(1 + A)), A)"),
    ("asin(A)", "atan2(A, sqrt((1 - A)*(1 + A)))"),
    ("asin(A)", "atan(A/sqrt(1 - A**2))"),
    ("abs(A)", "sqrt(A)*sqrt(A)"),
    ("abs(A)", "A**2/abs(A)"),
    ("sqrt(A*B)", "sqrt(A)*sqrt(B)"),
    ("sqrt(A/B)", "sqrt(A)/sqrt(B)"),
    ("(-B + sqrt(B**2 - 4*A))/2", "-2*A/(B + sqrt(B**2 - 4*A))"),
    ("exp(A) - exp(B)", "exp(B)*expm1(A - B)"),
    ("exp(2*A) - 1", "expm1(A)*(exp(A) + 1)"),
    ("(exp(2*A) - 1)/(exp(A) - 1)", "(exp(2*A) - 1)/expm1(A)"),
    ("atan2(A, B)", "2*atan(A/(sqrt(A**2 + B**2) + B))"),
    ("A/(A**2 + B**2)", "1/(A + B**2/A)"),
    ("(A*B)**(1/3)", "A**(1/3)*B**(1/3)"),
    ("abs(A - B) + A + B", "if A > B { 2*A } else { 2*B }"),
    ("abs(B)", "-B"),
    ("abs(A*B)", "A*B"),
    ("abs(A) + abs(B)", "abs(A + B)"),
];

const TERMS: &[&str] = &[
    "a", "b", "a + 1", "a - b", "a*b", "a**2", "1 - a", "a**2 - 1", "abs(a)", "a + b", "2*a", "b/2",
    "a - 1/2",
];

/// Conditions; some leave only points or lines.
const CONDITIONS: &[&str] = &[
    "a > 0",
    "a >= 0",
    "b > 0",
    "b >= 0",
    "a != 0",
    "b != 0",
    "-1 <= a <= 1",
    "a*b <= 0",
    "a**2*b <= 0",
    "a*b >= 0",
    "(a - 1)**2 <= 0",
    "(a - 1)**2*b >= 0",
    "a < b",
    "a <= b",
    "a + b > 0",
    "a != b",
    "abs(a) <= abs(b)",
    "a**2 + b**2 <= 1",
    "(a**2 + b**2 - 1)*b <= 0",
];

/// Random kernels.
struct Random(SplitMix);

impl Random {
    /// Returns a kernel, with or without a form.
    fn kernel(&mut self, with_form: bool) -> String {
        let (formula, form) = PAIRS[self.0.below(PAIRS.len())];
        let terms = [self.0.of(TERMS), self.0.of(TERMS)];
        let put = |text: &str| {
            text.replace('A', &format!("({})", terms[0])).replace('B', &format!("({})", terms[1]))
        };
        let conditions: Vec<&str> = (0..self.0.below(4)).map(|_| self.0.of(CONDITIONS)).collect();
        let domain =
            if conditions.is_empty() { String::new() } else { format!(" where {}", conditions.join(", ")) };
        match (with_form, self.0.below(2)) {
            (true, _) => format!("kernel k(a, b) = {} by {}{domain};", put(formula), put(form)),
            (false, 0) => format!("kernel k(a, b) = {}{domain};", put(formula)),
            (false, _) => format!("kernel k(a, b) = {} + 0*b{domain};", put(form).replace("jump ", "")),
        }
    }
}

/// Returns the points of the grid that are certainly in the kernel's domain.
fn points(pool: &Pool, kernel: &Kernel) -> Vec<Vec<(Symbol, Rational)>> {
    let number = |(p, q): (i64, i64)| Rational::new(p.into(), q.into());
    let domain = Truth::new(pool, &[], &kernel.domain);
    let grid = GRID.iter().flat_map(|&a| GRID.iter().map(move |&b| [number(a), number(b)]));
    let points = grid.map(|values| kernel.arguments.iter().copied().zip(values).collect::<Vec<_>>());
    points.filter(|point| domain.admits(point) == Some(true)).collect()
}

fn value(pool: &Pool, expression: Expr, point: &[(Symbol, Rational)]) -> Value {
    Truth::new(pool, &[expression], &[]).at(point, Format::Digits(20)).remove(0)
}

#[test]
fn an_accepted_form_has_the_formulas_value_wherever_the_formula_has_one() {
    let mut random = Random(SplitMix(29));
    let (mut accepted, mut refused, mut losing, mut named) = (0, 0, 0, 0);
    for _ in 0..count() {
        let text = random.kernel(true);
        let (mut theory, errors) = read_theory(&text);
        if !errors.is_empty() {
            continue;
        }
        let kernel = theory.kernels[0].clone();
        let found = compile_kernel(&mut theory.pool, &kernel);
        let breach = points(&theory.pool, &kernel).into_iter().find_map(|point| {
            let formula = value(&theory.pool, kernel.outputs[0], &point);
            let form = value(&theory.pool, kernel.computed[0], &point);
            let is_breach = matches!(formula, Value::Known(_))
                && (form == Value::Undefined || matches!(form, Value::Known(_)) && form != formula);
            is_breach.then(|| format!("{point:?}: {formula:?} {form:?}"))
        });
        match (&found, &breach) {
            (Ok(_), Some(breach)) => panic!("accepted: {text}\n{breach}"),
            (Ok(_), None) => accepted += 1,
            (Err(errors), _) => {
                refused += 1;
                losing += usize::from(breach.is_some());
                let message = &errors[0].message;
                let names_the_point = message.contains("\nat ") || message.contains("\neverywhere");
                named += usize::from(breach.is_some() && names_the_point);
            }
        }
    }
    println!("{accepted} accepted, {refused} refused, of {losing} that lose a point {named} with the point");
    assert!(accepted > count() / 10 && losing > count() / 10, "{accepted} accepted, {losing} lose a point");
    assert!(named * 10 >= losing * 9, "{named} of {losing} with the point");
}

#[test]
fn what_rules_make_of_a_formula_has_its_value_wherever_it_has_one() {
    let mut random = Random(SplitMix(31));
    let (mut rewritten, mut compared) = (0, 0);
    for _ in 0..count() {
        let text = random.kernel(false);
        let (mut theory, errors) = read_theory(&text);
        if !errors.is_empty() {
            continue;
        }
        let kernel = theory.kernels[0].clone();
        let Ok(generated) = compile_kernel(&mut theory.pool, &kernel) else { continue };
        rewritten += usize::from(!generated.rewritten.is_empty());
        for point in points(&theory.pool, &kernel) {
            let arguments: Vec<f64> = point
                .iter()
                .map(|(_, value)| {
                    value.numer().to_string().parse::<f64>().unwrap_or(f64::NAN)
                        / value.denom().to_string().parse::<f64>().unwrap_or(f64::NAN)
                })
                .collect();
            if matches!(value(&theory.pool, kernel.outputs[0], &point), Value::Known(_)) {
                compared += 1;
                let values = [generated.written.interpret(&arguments)[0], generated.values(&arguments)[0]];
                assert!(
                    values[1].is_finite() || !values[0].is_finite(),
                    "{text} at {arguments:?}: {values:?}"
                );
            }
        }
    }
    println!("{rewritten} formulas rewritten, {compared} values compared");
    assert!(rewritten > count() / 50 && compared > count(), "{rewritten} rewritten, {compared} compared");
}
