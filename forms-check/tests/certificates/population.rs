//! Random forgeries in large numbers: none is accepted. The claims are known to be false, or true
//! where the forgery refutes.

use crate::grammar::{Target, forgery};
use crate::support::checked;
use forms_check::{Claim, Outcome};
use forms_core::certificate::{HEADER, antiderivatives, entry, file_lines};
use forms_core::check::read_theory;
use forms_core::decide::{Verdict, decide};
use forms_testing::SplitMix;

const DECLARED: &str = "chart L(x, y, z); chart H(w) where w > 0; chart S(t, q) where 0 < t < pi; param a, b where a > 0, b > 1; param n; fn f(x, y); ";

/// True claims, each close to many false ones.
const TRUE: [&str; 44] = [
    "sqrt(x**2) == abs(x)",
    "sqrt(x**2*y**2) == abs(x)*abs(y)",
    "sqrt((b - 1)**2) == b - 1",
    "abs(w) == w",
    "sqrt(12) == 2*sqrt(3)",
    "a**(1/2)*a**(1/3) == a**(5/6)",
    "sqrt(x*y)**2 == x*y",
    "abs(x*y) == x*y where x*y >= 0",
    "abs(x) == -x where x <= 0",
    "abs(x*y) == x*abs(y) where x >= 0, y != 0",
    "abs(x)/x == 1 where x > 0",
    "sqrt(x**2 - 2*x*y + y**2) == abs(x - y)",
    "sqrt((abs(x) - 1)**2) == abs(abs(x) - 1)",
    "(x**2 - y**2)/(x - y) == x + y",
    "x**60*x**60/x**119 == x",
    "(x + 1)**3 - x**3 == 3*x**2 + 3*x + 1",
    "sin(2*x) == 2*sin(x)*cos(x)",
    "sqrt(sin(t)**2) == sin(t)",
    "sqrt(1 - cos(x)**2) == abs(sin(x))",
    "tan(x/2) == sin(x)/(1 + cos(x))",
    "abs(1 + cos(x)) == 1 + cos(x)",
    "abs(y)*(2 + cos(x)) == y*(2 + cos(x)) where y > 0",
    "sin(pi/12)**2 == (2 - sqrt(3))/4",
    "cos(2*pi/5) == (sqrt(5) - 1)/4",
    "cosh(2*x) == 1 + 2*sinh(x)**2",
    "exp(x)*exp(-x) == 1",
    "log(6*w**2*a) == log(2) + log(3) + 2*log(w) + log(a)",
    "log(abs(x)) == log(x**2)/2",
    "exp(log(w)/2)**2 == w",
    "w**(n + 1)*w**-n == w",
    "cos(atan(x)) == 1/sqrt(1 + x**2)",
    "sin(asin(x)) == x",
    "f(2*x, y) == f(x + x, y)",
    "diff(f*x, x) == f + x*diff(f, x)",
    "sqrt(f**2) == abs(f)",
    "diff(abs(x), x) == x/abs(x)",
    "integral(x**2, x = 0..3) == 9",
    "integral(cos(a*x), x = 0..y) == sin(a*y)/a",
    "integral(1/x**2, x = 1..2) == 1/2",
    "integral(1/(1 + x**2), x = -1..1) == pi/2",
    "integral(1/(1 + w)**2, w = 0..a) == 1 - 1/(1 + a)",
    "integral(diff(f, x), x = 0..1) == f(1, y) - f(0, y)",
    "integral(sin(t), t = 0..pi) == 2",
    "integral(x*y, y = 0..1) == x/2",
];

/// False claims that no small change of a true one gives. Each has a point at which it fails, and a
/// proof by a rule applied outside its conditions, from which forgeries start.
const FALSE: [(&str, &str, &str); 27] = [
    ("abs(x) == x", "x = -1", "base x\npositive sqrt(x)**2\nzero"),
    ("abs(x) == x", "x = -1", "base x\nsplit 1\ncase +\nbase x\npositive x\nzero\nend"),
    ("x == x + 1 where x > 0", "x = 1", "base x\nnegative sqrt(-x)**2\nsplit 1\nend"),
    ("x == x + 1 where x > 0, -x > 0", "it is vacuous", "base x\nsplit 1\nend"),
    ("x**(1/3) == x**(1/2) where x > 0", "x = 64", "base x\nroot 2\npositive x\nroot 6\nzero"),
    (
        "x**(1/3)*exp(x**(1/6)) == x*exp(x**(1/6)) where x > 0",
        "x = 64",
        "base x\nroot 2\npositive x\nexponent sqrt(x)\nroot 6\nzero",
    ),
    ("abs(y) == -y where (1 + cos(x))*y <= 0", "x = pi, y = 1", "tangent x\nbase y\nnegative -y\nzero"),
    (
        "abs(y)*(2 + cos(x)) == -y*(2 + cos(x)) where (1 + cos(x))*y <= 0",
        "x = pi, y = 1",
        "tangent x\nbase y\nnegative -(1 + cos(x))*y*(1 + tan(x/2)**2)/2\nzero",
    ),
    ("abs(x) == x where x*y >= 0, y >= 0", "x = -1, y = 0", "base x\npositive x*y/y\nzero"),
    ("abs(x) == x where x*y**2 >= 0", "x = -1, y = 0", "base x\npositive x*y**2/y**2\nzero"),
    (
        "abs(x) == x where x*sin(y) >= 0, sin(y) >= 0",
        "x = -1, y = 0",
        "circle y\nbase x\npositive x*sin(y)/sin(y)\nzero",
    ),
    ("x**100*x**100*x**56 == 1", "x = 2", "zero"),
    ("x**120*x**120*x**17 == x", "x = 2", "zero"),
    (
        "(1/(x - y**60 + z)*(1/(x + y**60 + z))*(1/((x+z)**2 + (x+z)*y**60 + y**120)))*((x+z)**6 - y**104) \
         == (x+z)**2 - (x+z)*y**60 + y**120",
        "x = 1, y = 1, z = 1: the left side is 1, the right one 3",
        "zero",
    ),
    ("sqrt(3) == 1", "3 is not 1", "zero"),
    ("sin(x/2) == sin(x)", "x = pi", "circle x\nzero"),
    ("cos(x) == 2 + sin(x)", "x = 0", "tangent x\nbase 1 + tan(x/2)**2\nsplit 1\nend"),
    ("integral(1/x**2, x = -1..1) == -2", "the integral diverges", "zero"),
    ("integral(0*x, x = -1..1) == 2", "0 is not 2", "zero"),
    (
        "diff(integral(x, y = 0..1), x) == -1 where sqrt(x) + sqrt(-x) + 1 > 0",
        "x = 0",
        "base x\npositive sqrt(x)**2\nzero",
    ),
    ("integral(sqrt(x)*sqrt(x), x = -1..1) == 0", "it is real nowhere below 0", "zero"),
    (
        "diff(integral(integral(x, y = 0..1), z = 0..1), x) == -1 where sqrt(x) + sqrt(-x) + 1 > 0",
        "x = 0",
        "zero",
    ),
    ("abs(x)*x**2**2 == x*x**2**2", "x = -1", "base x\npositive x\nzero"),
    ("log(x**2) == 2*log(-x) + 1", "x = -1", "base x\nlogarithm\nnegative sqrt(-x)**2\nzero"),
    ("x/(y - y) == 1", "it is vacuous", "undefined"),
    ("log(-x**2) == 5", "it is vacuous", "base x\nlogarithm\nundefined"),
    ("f(1, y) == 0*f + 1", "f = 0", "base f\npositive f\nzero"),
];

/// Antiderivatives that lose a jump or a pole, for the false claims about integrals.
const OFFERS: [(&str, &str); 5] = [
    ("integral(sqrt(x)*sqrt(x), x", "x**2/2\nzero"),
    ("1), z", "-x*z\nbase x\npositive sqrt(x)**2\nzero"),
    ("integral(1/x**2, x", "-1/x\nzero"),
    ("integral(0*x, x", "abs(x)/x\nbase x\nzero"),
    ("integral(x, y", "-abs(x)*y\nbase x\nnegative sqrt(-x)**2\nzero"),
];

/// True claims with points at which they seem to fail.
const POINTS: [(&str, &str); 5] = [
    (
        "f(0, 1) == f(0, 1 + 1e60*(sqrt(2)**2 - 2))",
        "at f(0, 0) = 0\nat f(0, 1) = 5\ncomponent\nleft 5\nright 0",
    ),
    (
        "f(2*x, y) == f(x + x, y)",
        "at x = 1\nat y = 0\nat f(2, 0) = 1\nat f(2 + 1e-13, 0) = 2\ncomponent\nleft 1\nright 2",
    ),
    ("sqrt(x**2) == x where x > 0", "at x = -1\ncomponent\nleft 1\nright -1"),
    ("x/x == 1", "at x = 0\ncomponent\nleft 0\nright 1"),
    ("x + y == y + x", "at x = 1\nat y = 1\ncomponent\nleft 2\nright 2"),
];

/// Returns a claim as a source, decided by the prover, with the lines of its certificate.
fn decided(claim: &str) -> Option<(Target, Verdict)> {
    let source = format!("{DECLARED}prove p: {claim};");
    let (mut theory, errors) = read_theory(&source);
    if !errors.is_empty() {
        return None;
    }
    let statement = theory.statements[0].clone();
    let verdict = decide(&mut theory, &statement);
    let nonempty = |text: String| -> Vec<String> {
        text.lines().map(|line| line.trim().to_string()).filter(|line| !line.is_empty()).collect()
    };
    let integrals = nonempty(antiderivatives(&mut theory));
    let proof = nonempty(entry(&mut theory, &statement, &verdict).to_string()).split_off(1);
    Some((Target { source, verdict: "proved", integrals, proof }, verdict))
}

/// Returns claims that differ from a true one by a number, a sign or a condition.
fn perturbed(claim: &str) -> Vec<String> {
    let (sides, conditions) = claim
        .split_once(" where ")
        .map_or((claim, String::new()), |(sides, conditions)| (sides, format!(" where {conditions}")));
    let (left, right) = sides.split_once(" == ").expect("an equation");
    let mut all = vec![
        format!("{left} == {right} + 1{conditions}"),
        format!("{left} == -({right}){conditions}"),
        format!("{left} == 2*({right}){conditions}"),
        format!("({left})**2 == {right}{conditions}"),
    ];
    if !conditions.is_empty() {
        all.push(sides.to_string());
        all.push(claim.replace(">=", "<=").replace('>', "<"));
        all.push(claim.replace("> 0", ">= 0"));
    }
    all
}

/// Returns all targets of forgeries, and real certificates from which lines are transplanted.
fn targets() -> (Vec<Target>, Vec<Target>) {
    let (mut targets, mut donors) = (Vec::new(), Vec::new());
    for claim in TRUE {
        let Some((target, Verdict::Proved(_))) = decided(claim) else { panic!("not proved: {claim}") };
        for near in perturbed(claim) {
            // refuted at an exact point: the claim is false, whatever the checker decides
            if let Some((other, Verdict::Refuted(_))) = decided(&near) {
                let proof = target.proof.clone();
                targets.push(Target { proof, integrals: other.integrals.clone(), ..other.clone() });
                let (source, integrals) = (target.source.clone(), target.integrals.clone());
                targets.push(Target { source, integrals, verdict: "refuted", proof: other.proof });
            }
        }
        donors.push(target);
    }
    let lines = |text: &str| text.lines().map(String::from).collect::<Vec<_>>();
    let mut written = Vec::new();
    for (claim, _, proof) in FALSE {
        let source = format!("{DECLARED}prove p: {claim};");
        let mut integrals = Vec::new();
        for (integral, offer) in OFFERS {
            if let Some(place) = source.find(integral) {
                integrals.extend(lines(&format!("integral {} {offer}", place + integral.len() - 1)));
            }
        }
        written.push(Target { source, verdict: "proved", integrals, proof: lines(proof) });
    }
    for (claim, point) in POINTS {
        let source = format!("{DECLARED}prove p: {claim};");
        written.push(Target { source, verdict: "refuted", integrals: Vec::new(), proof: lines(point) });
    }
    // about as many of these as of the others
    let copies = targets.len() / written.len();
    (0..copies).for_each(|_| targets.extend(written.iter().cloned()));
    (targets, donors)
}

#[test]
fn no_forgery_is_accepted() {
    let count = std::env::var("FORMS_FORGERIES").ok().and_then(|n| n.parse().ok()).unwrap_or(1_000);
    let (targets, donors) = targets();
    assert!(targets.len() > 200, "{} targets", targets.len());
    let mut outcomes = [0_usize; 3];
    for number in 0..count {
        let mut random = SplitMix(number);
        let target = targets[random.below(targets.len())].clone();
        let forged = forgery(&mut random, &target, &donors);
        let lines = HEADER.to_string() + &file_lines("it.forms", &target.source) + &forged;
        let all = checked(&lines, &target.source);
        let claim = if target.verdict == "proved" { Claim::Prove } else { Claim::Refute };
        let is_taken = all.as_ref().is_ok_and(|all| all.iter().any(|one| one.shown == Some(claim)));
        assert!(!is_taken, "forgery {number} of\n{}\n{forged}", target.source);
        outcomes[match all {
            Err(_) => 0,
            Ok(all) if matches!(all[0].outcome, Outcome::Rejected(_)) => 1,
            Ok(_) => 2,
        }] += 1;
    }
    // most are read to the end, and are rejected for their claim
    assert!(outcomes[1] * 2 > outcomes.iter().sum::<usize>(), "{outcomes:?}");
    println!("{count} forgeries of {} claims: {outcomes:?}", targets.len());
}
