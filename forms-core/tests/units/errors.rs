//! Unit errors that are refused, and their messages.

use crate::{SCENE, read};
use forms_core::check::read_theory;
use forms_core::syntax::Source;

/// Declarations or claims over the scene, each with its only message.
const REFUSED: &[(&str, &str)] = &[
    // Sums, comparisons, equations.
    ("let q = x + t;", "cannot add different units: the left side is in m, the right side in s"),
    ("let q = x - 1;", "cannot subtract different units: the left side is in m, the right side in 1"),
    ("let q = x + x**2;", "cannot add different units: the left side is in m, the right side in m**2"),
    ("let q = x + lambda;", "cannot add different units: the left side is in m, the right side in nm"),
    ("let q = f*dx + f*x;", "cannot add a 1-form and a scalar"),
    ("let q = dx + dt;", "cannot add different units: the left side is in m, the right side in s"),
    ("let q = @x + @t;", "cannot add different units: the left side is in 1/m, the right side in 1/s"),
    ("let q = omega + 1;", "cannot add different units: the left side is in sr, the right side in 1"),
    (
        "prove lambert: E == pi*L;",
        "`lambert` equates different units: the left side is in W/m**2, the right side in W/m**2/sr",
    ),
    (
        "refute p: E == L;",
        "`p` equates different units: the left side is in W/m**2, the right side in W/m**2/sr",
    ),
    (
        "prove p: x == x where x > t;",
        "cannot compare different units: the left side is in m, the right side in s",
    ),
    (
        "prove p: x == x where 0 < x < 1;",
        "cannot compare different units: the left side is in m, the right side in 1",
    ),
    (
        "chart Q(q: m) where q > 1;",
        "cannot compare different units: the left side is in m, the right side in 1",
    ),
    ("param q: m where q > t;", "cannot compare different units: the left side is in m, the right side in s"),
    ("fn q(x): m where q > f;", "cannot compare different units: the left side is in m, the right side in K"),
    (
        "let q = if x > t { 1 } else { 2 };",
        "cannot compare different units: the left side is in m, the right side in s",
    ),
    (
        "let q = if x > y { x } else { t };",
        "the branches of `if` have different units: the first branch is in m, the second in s",
    ),
    // Functions and powers.
    ("let q = exp(-x);", "`exp` takes a number, and this is in m"),
    ("let q = log(r);", "`log` takes a number, and this is in m"),
    ("let q = sin(omega);", "`sin` takes a number, and this is in sr"),
    ("let q = asin(x);", "`asin` takes a number, and this is in m"),
    ("let q = max(y, t);", "the arguments of `max` have different units: the first is in m, the second in s"),
    (
        "let q = hypot(x, 1);",
        "the arguments of `hypot` have different units: the first is in m, the second in 1",
    ),
    (
        "let q = atan2(y, t);",
        "the arguments of `atan2` have different units: the first is in m, the second in s",
    ),
    ("let q = 2**x;", "an exponent is a number, and this is in m"),
    ("let q = x**n;", "only a number has powers with a variable exponent, and this is in m"),
    ("let q = f(x, y, t);", "`f` takes a different unit for `z`: `z` is in m, the argument in s"),
    (
        "let q = integral(x, x = 0..t);",
        "the range of `x` has a different unit: the variable is in m, the bound in s",
    ),
    // Declarations.
    (
        "map F: Line -> Space = (s, s, 1);",
        "the component for `z` has a different unit: the coordinate is in m, the component in 1",
    ),
    ("let q: s = x;", "`q` is declared in s, and its value is in m"),
    ("let q: mm = x;", "`q` is declared in mm, and its value is in m"),
    ("let q: W/m**2 = L;", "`q` is declared in W/m**2, and its value is in W/m**2/sr"),
    ("let q: 1 = omega;", "`q` is declared in 1, and its value is in sr"),
    ("let q: m/s = 2*n;", "`q` is declared in m/s, and its value is in 1"),
    ("let q: m = n**n;", "`q` is declared in m, and its value is in 1"),
    ("let q: m = 2**n;", "`q` is declared in m, and its value is in 1"),
    ("let q: m = sin(n);", "`q` is declared in m, and its value is in 1"),
    ("let q: m = sqrt(n);", "`q` is declared in m, and its value is in 1"),
    ("let q: m = 2*free + 1;", "`q` is declared in m, and its value is in 1"),
    ("form q: 1, s on Space = dx;", "`q` is declared in s, and its value is in m"),
    ("kernel k(a: m): s = a;", "the result of `k` is declared in s, and its value is in m"),
    ("kernel k(a: m): (m, s) = (a, a);", "result 2 of `k` is declared in s, and its value is in m"),
    ("kernel k(a: m): m = (a, a);", "`k` has 2 results and 1 unit"),
    ("kernel k(a: m): (m, m) = a;", "`k` has 1 result and 2 units"),
    (
        "kernel k(a: m) = a where a < 1;",
        "cannot compare different units: the left side is in m, the right side in 1",
    ),
    (
        "kernel k(a: 1/m, b: m) = exp(-a*b) effects { absorption: a = 1; };",
        "the effect `absorption` compares different units: the variable is in 1/m, the value in 1",
    ),
    ("kernel k(x: s) = x;", "`x` is declared in m above, and here in s"),
    ("chart Again(x: mm);", "`x` is declared in m above, and here in mm"),
    // Unknown units.
    ("param q: meters;", "`meters` is not a unit"),
    ("param q: deg;", "`deg` is not a unit"),
    ("param q: furlong;", "`furlong` is not a unit"),
    ("param q: krad;", "`krad` is not a unit"),
    ("param q: 2*m;", "expected a unit"),
    ("param q: m + s;", "expected a unit"),
    ("param q: m^2;", "`^` is the wedge product, but its right operand is a number"),
    ("param q: m^s;", "`^` is the wedge product"),
    ("param q: m**n;", "the exponent of a unit is a number, as in `m**2`"),
    ("param q: m**(1/0);", "the exponent of a unit is a number, as in `m**2`"),
    ("fn q(x: m): s;", "an argument of a `fn` has the unit of the coordinate or parameter it names"),
];

#[test]
fn each_mistake_is_told_once() {
    for (text, message) in REFUSED {
        let (_, errors) = read(text);
        assert_eq!(errors, [*message], "{text}");
    }
}

/// Advice for fixing each error.
const ADVICE: &[(&str, &str)] = &[
    ("prove p: E == L;", "the right side lacks a solid angle: multiply it by a quantity in sr"),
    ("prove p: L == E;", "the left side lacks a solid angle: multiply it by a quantity in sr"),
    ("prove p: L == omega*E;", "the left side lacks a solid angle: multiply it by a quantity in sr**2"),
    ("let q = x + t;", "the left side divided by the right side is in m/s, but must be a pure number"),
    (
        "let q = x + lambda;",
        "1 m is 1000000000 nm: state both in one unit, or multiply by `let factor: nm/m = 1000000000;`",
    ),
    ("let q = sqrt(x) + sqrt(lambda);", "m**(1/2) and nm**(1/2) differ in size: state both in one unit"),
    (
        "let q = x + lambda*omega;",
        "the left side divided by the right side is in m/nm/sr, but must be a pure number",
    ),
    (
        "param a: h, b: min; let q = a + b;",
        "1 h is 60 min: state both in one unit, or multiply by `let factor: min/h = 60;`",
    ),
    (
        "param a: min, b: s; let q = a + b;",
        "1 min is 60 s: state both in one unit, or multiply by `let factor: s/min = 60;`",
    ),
    (
        "param a: g, b: kg; let q = a + b;",
        "1 g is 1/1000 kg: state both in one unit, or multiply by `let factor: kg/g = 1/1000;`",
    ),
    (
        "param a: L, b: m**3; let q = a + b;",
        "1 L is 1/1000 m**3: state both in one unit, or multiply by `let factor: m**3/L = 1/1000;`",
    ),
    (
        "param a: eV; let q = j + a*10**28;",
        "1 J is 5000000000000000000000000000/801088317 eV: state both in one unit, or multiply by \
         `let factor: eV/J = 5000000000000000000000000000/801088317;`",
    ),
    ("let q = exp(x);", "divide it by a quantity in m"),
    ("param q: meters;", "did you mean `m`?"),
    ("param q: HZ;", "did you mean `Hz`?"),
    ("param q: deg;", "angles are in radians: `rad`"),
    ("param q: furlong;", "use SI units such as `m`, `nm`, `s`, `kg`, `W`, `sr`"),
];

#[test]
fn each_mistake_comes_with_advice() {
    for (text, help) in ADVICE {
        let (_, errors) = read_theory(&format!("{SCENE}{text}"));
        let found: Vec<&str> = errors.iter().filter_map(|error| error.help.as_deref()).collect();
        assert_eq!(found, [*help], "{text}");
    }
}

#[test]
fn the_factor_that_is_advised_mends_the_sum() {
    let (_, errors) = read("let factor: nm/m = 1000000000; let q = x*factor + lambda;");
    assert!(errors.is_empty(), "{errors:?}");
}

#[test]
fn there_is_nothing_to_decide_about_unlike_units() {
    let (theory, _) = read("prove right: x == x; refute wrong: E == L; prove p: t == t where t > x;");
    let names: Vec<&str> = theory.statements.iter().map(|statement| statement.name.as_str()).collect();
    assert_eq!(names, ["right"]);
}

#[test]
fn the_place_is_that_of_the_mistake() {
    let source =
        Source::new("example.forms", "chart R(x: m, t: s);\nlet q = 2*x + (t + x);\nlet p = exp(q*t) - x;\n");
    let (_, errors) = read_theory(&source.text);
    let shown: String = errors.iter().map(|error| source.render(error)).collect();
    assert_eq!(
        shown,
        "error: cannot add different units: the left side is in s, the right side in m
  --> example.forms:2:18
   |
 2 | let q = 2*x + (t + x);
   |                  ^
   = help: the left side divided by the right side is in s/m, but must be a pure number
error: `exp` takes a number, and this is in m*s
  --> example.forms:3:13
   |
 3 | let p = exp(q*t) - x;
   |             ^^^
   = help: divide it by a quantity in m*s
error: cannot subtract different units: the left side is in 1, the right side in m
  --> example.forms:3:18
   |
 3 | let p = exp(q*t) - x;
   |                  ^
   = help: the left side divided by the right side is in 1/m, but must be a pure number
"
    );
}

#[test]
fn huge_and_nested_exponents_are_exact() {
    let mut text = String::from("param a0: m**1000000;");
    for step in 0..20 {
        text.push_str(&format!("let a{} = a{step}**1000000*a{step}**(-999999/7);", step + 1));
    }
    let (theory, errors) = read_theory(&text);
    assert!(errors.is_empty(), "{errors:?}");
    assert!(theory.objects.last().unwrap().unit.as_ref().unwrap().len() > 100);
}
