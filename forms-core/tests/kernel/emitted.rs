//! Kernels of every kind of instruction, which all back ends compute, and the text of emitted Rust.

use crate::formula::Formulas;
use forms_core::emission::{KernelDocs, emit_rust};
use forms_core::expression::{Expr, Relation};
use forms_core::kernel::Program;

/// Kernels of every kind of instruction: name, arguments, outputs.
const KERNELS: &[(&str, &str, &[&str])] = &[
    ("polynomial", "x", &["3*x**5 - x**3/7 + x - 2"]),
    ("inverse_square", "x y z", &["x/sqrt(x**2 + y**2 + z**2)**3"]),
    ("several", "u v", &["u/(u**2 + v**2)", "v/(u**2 + v**2)", "1/(u**2 + v**2)"]),
    ("functions", "t0 x", &["atan2(sin(t0), cos(x)) + exp(-abs(x))*tanh(t0) - log(x)"]),
    ("constants", "x", &["-x", "pi*x/4", "2/3 - x", "-1/(4*pi)", "sqrt(2)*x", "x - 1/10"]),
    ("roots", "x", &["x**(1/3) + x**(-2/3)", "x**(3/2) - x**(-5/2)", "x**-7"]),
    ("piecewise", "x y", &["if x < y { sqrt(y - x) } else { if y <= 0 { x } else { log(y) } } + x"]),
    ("extrema", "x y", &["(x + y - abs(x - y))/2", "x*(x + y + abs(x - y))/2", "(x + abs(x))/2"]),
    ("lengths", "x y", &["hypot(x, 3*y) + cbrt(x - y)"]),
    ("unused", "x y", &["y + 1"]),
    ("many", "a b c d e f g H", &["a*b + c*d - (e*f - g*H)"]),
];

/// Kernels with conditionals. Their sides occur inside the branches, next to the conditional, or in
/// neither place.
const CHOICES: &[(&str, &str, &[&str])] = &[
    (
        "in_branches",
        "x y",
        &["if x < y { x*y } else { 1 }", "if x <= 1 { 1 } else { x*y }", "if x < y { x - y } else { 1 }"],
    ),
    ("beside", "x y", &["x + (if x < 1 { y } else { 2 }) + (if x <= 1 { 1 } else { y })"]),
    (
        "together",
        "x y",
        &["(if x < y { 1 } else { 2 })*(if y < x { 3 } else { x }) + (if x <= y { 5 } else { 7 })"],
    ),
    ("nested", "x y", &["if x < 1 { if y < 1 { x } else { 1 } } else { if y < 2 { x + y } else { 2 } }"]),
    ("apart", "x y", &["x + (if x < 1 { y } else { 2 })", "if x < 2 { 1 } else { y }"]),
];

/// Generator of NaN, infinities, signed zeros and ordinary numbers: a fixed linear congruential
/// generator.
pub(crate) struct Inputs(pub(crate) u64);

impl Inputs {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        match (self.0 >> 33) % 17 {
            0 => f64::NAN,
            1 => 0.0,
            2 => f64::INFINITY,
            _ => (self.0 >> 11) as f64 / (1u64 << 53) as f64 * 8.0 - 2.0,
        }
    }
}

/// Returns the kernels as written and as optimised, one with compensated products, and two with
/// conditions.
pub(crate) fn kernels() -> Vec<Program> {
    let mut programs = written_and_optimised(KERNELS);
    let mut products = Formulas::over("a b c d");
    let difference = products.parse("a*b - c*d");
    programs.push(products.named("products").program(&[difference]).optimise().compensate());
    programs.extend(with_domains());
    programs
}

/// Returns the kernels with conditionals.
pub(crate) fn choices() -> Vec<Program> {
    written_and_optimised(CHOICES)
}

fn written_and_optimised(kernels: &[(&str, &str, &[&str])]) -> Vec<Program> {
    let mut programs = Vec::new();
    for (name, variables, outputs) in kernels {
        let mut formulas = Formulas::over(variables);
        let outputs: Vec<Expr> = outputs.iter().map(|output| formulas.parse(output)).collect();
        let written = formulas.named(name).program(&outputs);
        programs.push(formulas.named(&format!("{name}_optimised")).program(&outputs).optimise());
        programs.push(written);
    }
    programs
}

fn with_domains() -> Vec<Program> {
    let mut formulas = Formulas::over("x y");
    let [x, y, zero, five] = ["x", "y", "0", "5"].map(|text| formulas.parse(text));
    let (sum, root) = (formulas.parse("x + y"), formulas.parse("sqrt(x)/y"));
    let domain = [(zero, Relation::Less, x), (sum, Relation::LessEqual, five), (y, Relation::NotEqual, zero)];
    let one = formulas.named("inside").program_where(&[root], &domain).optimise();
    let two = formulas.named("both_inside").program_where(&[root, sum], &domain).optimise();
    vec![one, two]
}

#[test]
fn nothing_is_fused() {
    assert!(
        kernels()
            .iter()
            .all(|program| !emit_rust(program, &KernelDocs::default(), "forms_math").contains("mul_add"))
    );
}
/// Σ, one conditional, two outputs and a condition, as printed.
#[test]
fn a_kernel_reads_as_written_by_hand() {
    let mut formulas = Formulas::over("x y");
    let [x, zero, first, second] = ["x", "0", "x/sqrt(x**2 + y**2)**3", "if x < y { -2*x } else { y/pi }"]
        .map(|text| formulas.parse(text));
    let program = formulas.named("field").program_where(&[first, second], &[(x, Relation::NotEqual, zero)]);
    let docs = KernelDocs {
        formula: formulas.pool.texts(&[first, second]).join(", "),
        statements: vec!["gauss".to_string()],
        conditions: vec!["x != 0".to_string()],
        units: "Units: `x` in `m`.".to_string(),
        translation: "Proved.".to_string(),
        rounding: String::new(),
        docs: vec!["A field and a choice.".to_string()],
    };
    let expected = r#"/// A field and a choice.
///
/// ```text
/// x/(x**2 + y**2)**(3/2), (if x < y { -2*x } else { y/pi })
/// ```
///
/// Units: `x` in `m`.
///
/// Statements used: `gauss`.
///
/// Holds where `x != 0`.
///
/// Proved.
///
/// Its value is NaN outside its domain and where an argument it depends on is NaN.
/// Cost: 1 addition, 5 multiplications, 1 division, 1 square root, 1 conditional.
pub fn field(x: f64, y: f64) -> [f64; 2] {
    let inside = x.partial_cmp(&0.0).is_some_and(::core::cmp::Ordering::is_ne);
    if !inside {
        return [f64::NAN; 2];
    }
    let t0 = x * x + y * y;
    let t1 = if x < y {
        -2.0 * x
    } else if x >= y {
        ::core::f64::consts::FRAC_1_PI * y
    } else {
        f64::NAN
    };
    [x / (t0 * t0.sqrt()), t1]
}
"#;
    assert_eq!(emit_rust(&program.optimise(), &docs, "forms_math"), expected);
}
