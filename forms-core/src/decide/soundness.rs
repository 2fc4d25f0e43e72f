//! Soundness of the prover alone, without the points that refute: it proves no false statement, and
//! finds no contradiction in conditions that some point meets.
//!
//! Most false statements are refuted before their normal forms are computed, which hides the
//! outcome of the normal forms. Each rule about signs, ranges and roots has a statement here that
//! it would prove if it went a step too far.

use super::empty;
use super::goal::Outcome;
use super::problem::Problem;
use super::proof::by_normal_forms;
use super::tactics::angles;
use crate::resolve::resolve;
use crate::syntax::ast::Claim;
use crate::syntax::read;
use crate::theory::{Statement, Theory};
use std::path::Path;

/// Limit on the products of terms in one normal form.
const WORK: u64 = 2_000_000;

/// False statements that fail only at points that are easily missed, or only at the boundary of a
/// condition.
const FALSE: &[&str] = &[
    // exp u − c exp v with c > 1, where u ≥ v
    "abs(exp(x) - 2) == exp(x) - 2 where x >= 0",
    "abs(exp(x) - 2*exp(y)) == exp(x) - 2*exp(y) where x >= y",
    // A − Bρ with ρ³ = n, by its norm of second order
    "abs(1 - 2*n**(1/3)) == 1 - 2*n**(1/3) where n < 1/4",
    // A + Bρ with A² > B²f, A of any sign
    "abs(x + sqrt(n)) == x + sqrt(n) where x**2 > n",
    "abs(x - sqrt(n)) == x - sqrt(n) where x**2 > n",
    // a factor that is zero at one point cannot be divided out
    "abs(y) == y where x >= 0, (x - 1)**2*y >= 0",
    "abs(y) == y where x >= 0, x*y >= 0",
    "abs(y) == y where x**2*y >= 0",
    // log |y| for y < 0
    "abs(log(x**2) - log(y**2)) == log(x**2) - log(y**2) where x >= y, x > 0",
    "abs(log(x**2)) == -log(x**2) where x <= 1",
    // tan(x/2) nearer to a zero than to a pole
    "abs(cos(x)) == -cos(x) where pi/3 <= x, x <= 5*pi/3",
    "abs(sin(x)) == sin(x) where 0 <= x, x <= 3*pi/2",
    "abs(tan(x)) == tan(x) where 0 < x, x < 5*pi/6",
    // inverse functions of arguments with the other sign, and turns
    "4*asin(x) == -acos(1 - 8*x**2 + 8*x**4) where x < 0",
    "4*acos(x) == acos(8*x**4 - 8*x**2 + 1) where x < 0",
    "4*atan(x) == -acos(8/(1 + x**2)**2 - 8/(1 + x**2) + 1) where x < 0",
    "4*atan(x) == acos(8/(1 + x**2)**2 - 8/(1 + x**2) + 1) where x > 0",
    "4*atan2(y, x) == 4*atan2(-y, -x) where x > 0, y > 0",
    "2*atan2(y, x) == 2*atan2(-y, -x) where x < 0, y > 0",
    "2*atan2(y, x) == 2*atan2(-y, -x) where x > 0, y < 0",
    "atan2(sin(x), cos(x)) == x where -pi < x, x <= 2*pi",
    "acos(cos(x)) == x where -1 < x, x < pi",
    "asin(sin(x)) == x where 0 <= x, x < pi",
    // thirds of an inverse function are not the function
    "cos(acos(x)/3) == x",
    "sin(atan(x)/3) == x/sqrt(1 + x**2)",
    // points at which cos u = -1, where half-angle tangents say nothing
    "abs(y) == -y where (1 + cos(x))*y <= 0, abs(1 + cos(x)) >= 0",
    "abs(y)*(2 + cos(x)) == -y*abs(2 + cos(x)) where (1 + cos(x))*y <= 0",
    "abs(y) == -y where (1 + cos(x + z))*y <= 0, abs(cos(x + z)) >= 0",
    "abs(y) == -y where (1 + cos(x))*(1 + cos(z))*y <= 0, abs(cos(x)*cos(z)) >= 0",
    "abs(y) == -y where (1 + cos(x/3))*y <= 0, abs(1 + cos(x)) >= 0",
    "abs(y) == -y where (1 + cos(pi*x))*y <= 0, abs(cos(pi*x)) >= 0",
    "abs(y) == -y where (1 + cos(g))*y <= 0, abs(cos(g)) >= 0",
    "abs(cos(x)) == cos(x) where cos(x) <= -1",
    "sqrt(2 + cos(x)) == 2 where sqrt(1 + cos(x)) <= 0",
    // half of acos(-1), whose sine is not given by the quotient for the sine of half an angle
    "cos(acos(x)/2) + sin(acos(x)/2) == sqrt((1 + x)/2) where x <= -1",
    "sin(acos(x)/4) == sqrt((1 + x)/2) where x <= -1",
    // zeros of the divisors in nested radicals and exponents
    "sqrt(x + 2*sqrt(x*y) + y) + abs(z) == sqrt(x) + sqrt(y) - z where x*z <= 0, y >= 0",
    "abs(z) == -z where (sqrt(x + 2*sqrt(x*y) + y) - sqrt(y))*z <= 0, y >= 0, x >= 0",
    "exp(1/(x + sqrt(x**2 + 2*y))) + abs(z) == exp(1/(2*x)) - z where y**2*z <= 0, y**2 <= 0, x > 0",
    // isolated strata, next to nested radicals that are denested and without any
    "sqrt(3 + 2*sqrt(2)) + abs(y) == 1 + sqrt(2) + y where x >= 0, x*y >= 0",
    "sqrt(x + 1 + 2*sqrt(x)) + abs(y) == 1 + sqrt(x) + y where x*y >= 0",
    // nested radicals whose norms are not squares, or that equal the other square root
    "sqrt(3 - 2*sqrt(2)) == 1 - sqrt(2)",
    "sqrt(2 + sqrt(3)) == (1 + sqrt(3))/2",
    "sqrt(x + 1 - 2*sqrt(x)) == 1 - sqrt(x)",
    "sqrt(x + 1 + 2*sqrt(x) + x**(1/4)) == 1 + sqrt(x)",
    "sqrt(2*x + 2*sqrt(x**2 - 1)) == sqrt(x + 1) - sqrt(x - 1)",
    // angles that lose full turns, with constant derivatives
    "cos(x)*y == y where atan(tan(x))**2 <= 0",
    "x*y == 0 where atan(tan(x))**2 <= 0",
    "x*y == 0 where atan2(sin(x), cos(x))**2 <= 0",
    "(x - 1)*y == 0 where (atan(tan(x)) - 1)**2 <= 0",
    "x*y == 0 where abs(acos(cos(x))) <= 0",
    // a derivative at points where it does not exist
    "diff(abs(x), x) == 0 where x**2 <= 0",
    "diff(sqrt(x**2 + y**2), x) == 0 where x**2 + y**2 <= 0",
    // places that differ
    "g(x, y) + z == g(x, z) + z",
    "diff(f, x) == f",
    "abs(diff(h, x)) == diff(h, x)",
    // magnitudes
    "abs(x)*abs(y) == x*y where x*y*z > 0, x**2 < y",
    "sqrt(x**2*y)/y == x/sqrt(y)",
    "1/(1 + abs(x)) + 1/(2 + abs(x)) == (3 + 2*x)/((1 + x)*(2 + x)) where x > -1",
    "exp(1/(sqrt(x) - 2)) == exp((sqrt(x) - 2)/(x - 4))",
    "exp(1/(x + sqrt(x**2 + 2*y))) == exp((sqrt(x**2 + 2*y) - x)/y) where y > 0",
];

/// Lists of conditions, each met by some point.
const POSSIBLE: &[&str] = &[
    "x >= y, y >= x",
    "x >= 0, x <= 0",
    "x < 0, y < 0, x*y > 1",
    "x < 0, y < 0, z < 0, x*y*z < -1",
    "1/(sin(x) - 2) < 0",
    "1/(x**2 + 1)**2 > 0",
    "-x**2 >= 0",
    "x**2 <= 0",
    "abs(x) <= 0",
    "-exp(x) < 0",
    "sqrt(x) >= 0, sqrt(x) <= 0",
    "exp(x) > 1, exp(y) < 1",
    "log(x) > 0, x > 1",
    "log(x) < 0, x < 1",
    "sqrt(2)*x > 1, x < 1",
    "pi*x < 22, x >= 7",
    "x*y >= 0, x <= 0, y <= 0",
    "abs(x) > 0",
    "x != 0, x >= 0",
    "cos(x) <= -1",
    "cos(x) <= -1, abs(cos(x)) >= 1",
    "sqrt(1 + cos(x)) <= 0",
    "cos(x) + cos(y) <= -2, abs(cos(x)*cos(y)) >= 0",
    "abs(sin(x/2)) >= 1, cos(x) <= -1",
    "cos(2*x) <= -1, abs(sin(x)) >= 1",
];

fn theory_of(text: &str) -> Theory {
    let (file, errors) = read(text);
    assert_eq!(errors, [], "{text}");
    let (theory, errors) = resolve(&file);
    assert_eq!(errors, [], "{text}");
    theory
}

const PREAMBLE: &str = "chart R3(x, y, z); param n where n > 0; fn f(x); fn g(x, y); fn h(x) where h > 0;";

/// Whether the normal forms, or the argument about angles, prove a statement.
fn is_proved(theory: &mut Theory, statement: &Statement) -> bool {
    let problem = Problem::new(theory, statement);
    let outcome = by_normal_forms(&mut theory.pool, &problem, WORK);
    outcome == Outcome::Zero || outcome.is_open() && angles(&mut theory.pool, &problem, WORK) == Outcome::Zero
}

#[test]
fn normal_forms_prove_no_false_statement() {
    let mut proved = Vec::new();
    for written in FALSE {
        let mut theory = theory_of(&format!("{PREAMBLE} refute it: {written};"));
        let statement = theory.statements[0].clone();
        if is_proved(&mut theory, &statement) {
            proved.push(*written);
        }
    }
    assert!(proved.is_empty(), "proved: {proved:#?}");
}

#[test]
fn normal_forms_prove_no_statement_that_a_case_file_refutes() {
    let mut count = 0;
    for folder in ["../tests/cases", "../forms-kernels/theory"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        for entry in std::fs::read_dir(folder).expect("the folder is there") {
            let text = std::fs::read_to_string(entry.expect("an entry").path()).expect("a text");
            let mut theory = theory_of(&text);
            for statement in theory.statements.clone() {
                if statement.claim == Claim::Refute {
                    assert!(!is_proved(&mut theory, &statement), "{} is proved", statement.name);
                    count += 1;
                }
            }
        }
    }
    assert!(count > 100, "{count} statements");
}

#[test]
fn conditions_that_some_point_meets_do_not_contradict_each_other() {
    let mut contradicted = Vec::new();
    for conditions in POSSIBLE {
        let mut theory = theory_of(&format!("{PREAMBLE} prove it: x*y*z == z*y*x where {conditions};"));
        let statement = theory.statements[0].clone();
        let problem = Problem::new(&mut theory, &statement);
        if let Some(reason) = empty::contradiction(&mut theory.pool, &problem) {
            contradicted.push(format!("{conditions}: {reason}"));
        }
    }
    assert!(contradicted.is_empty(), "{contradicted:#?}");
}
