//! No statement vanishes: a file with n `prove`s and `refute`s has n statements, or it has an
//! error.
//!
//! Random files declare and claim things of every kind. Some declarations use their own name, an
//! undeclared name or a name whose declaration is damaged. The generator counts its claims and
//! knows what it damaged.

use forms_core::check::read_theory;
use forms_core::diagnostic::MOST_DIAGNOSTICS;
use forms_testing::SplitMix;
use std::fmt::Write;

/// Default number of files.
const CASES: u64 = 3_000;

#[test]
fn a_declaration_that_uses_its_own_name_is_an_error() {
    let declarations = [
        ("let a = a;", "a"),
        ("let a = x + sin(a);", "a"),
        ("form a = a;", "a"),
        ("form a: 1 on P = x*dy + a;", "a"),
        ("field a = a;", "a"),
        ("field a on P = @x + a;", "a"),
        ("map a: P -> P = (a, y);", "a"),
        ("map a: P -> P = (pullback(a, x), y);", "a"),
        ("metric a on P = a;", "a"),
        ("metric a on P = norm[a](@x)*dx**2 + dy**2;", "a"),
        ("fn a(a);", "a"),
        ("kernel a(x) = a;", "a"),
        ("kernel a(a) = 1;", "a"),
        ("kernel a(x) = x by a;", "a"),
        ("kernel a(x) = x where x > a;", "a"),
        ("kernel a = grad(a; x);", "a"),
        ("chart a = a * P;", "a"),
        ("chart a(u) where u > a;", "a"),
        ("warp a(; u, v) = (u, v) onto a density 1 of dx^dy;", "a"),
        ("warp a(; u, v) = (u, a) onto P density 1 of dx^dy;", "a"),
    ];
    for (declaration, name) in declarations {
        let text = format!("chart P(x, y);\n{declaration}\nprove p: x == x;");
        let (_, diagnostics) = read_theory(&text);
        let [diagnostic] = &diagnostics[..] else { panic!("{declaration}: {diagnostics:?}") };
        assert_eq!(diagnostic.message, format!("the declaration of `{name}` uses its own name"), "{text}");
    }
}

#[test]
fn a_name_in_the_condition_of_its_own_declaration_is_none() {
    let text =
        "chart P(x) where x > 0; param a where a > 0; fn f(x) where f > 0; prove p: f*abs(a*x) == a*f*x;";
    let (theory, diagnostics) = read_theory(text);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    assert_eq!(theory.statements.len(), 1);
}

#[test]
fn every_statement_is_counted_or_the_file_is_an_error() {
    let cases = std::env::var("FORMS_FUZZ").map_or(CASES, |count| count.parse().expect("a number of cases"));
    let (mut sound, mut damaged) = (0, 0);
    for case in 0..cases {
        let file = File::random(case);
        let (theory, diagnostics) = read_theory(&file.text);
        let text = &file.text;
        assert!(diagnostics.len() <= MOST_DIAGNOSTICS + 1);
        if diagnostics.is_empty() {
            assert!(!file.is_damaged, "the damage is not reported:\n{text}");
            assert_eq!(theory.statements.len(), file.claims, "a claim is lost:\n{text}");
            sound += 1;
        } else {
            damaged += 1;
        }
    }
    assert!(sound * 10 > cases && damaged * 10 > cases, "{sound} sound files and {damaged} others");
}

/// Kinds of declarations.
const KINDS: [&str; 7] = ["let", "form", "field", "map", "metric", "fn", "chart"];

/// File with the generator's knowledge of it.
struct File {
    text: String,
    claims: usize,
    is_damaged: bool,
    /// Names of each kind declared so far.
    known: [Vec<String>; KINDS.len()],
}

impl File {
    fn random(case: u64) -> File {
        let mut random = SplitMix(case);
        let text = "chart P(x, y); param c where c > 0;\n".to_string();
        let mut file = File { text, claims: 0, is_damaged: false, known: Default::default() };
        let is_prone = random.below(2) == 0;
        for number in 0..2 + random.below(8) {
            match random.below(9) {
                kind @ 0..7 => file.declare(kind, number, is_prone, &mut random),
                7 => file.kernel_or_warp(number, is_prone, &mut random),
                _ => file.claim(number, &mut random),
            }
        }
        file.claim(99, &mut random);
        file
    }

    /// Returns a name of a kind for use in the declaration of `own`: usually a name declared
    /// before, sometimes `own` or an undeclared name.
    fn name(&mut self, kind: usize, own: &str, is_prone: bool, random: &mut SplitMix) -> Option<String> {
        if is_prone && random.below(8) == 0 {
            self.is_damaged = true;
            return Some(if random.below(2) == 0 { own.to_string() } else { "nobody".to_string() });
        }
        let known = &self.known[kind];
        (!known.is_empty()).then(|| known[random.below(known.len())].clone())
    }

    fn declare(&mut self, kind: usize, number: usize, is_prone: bool, random: &mut SplitMix) {
        let own = format!("n{number}");
        // the condition of a `fn` is allowed to mention the function itself
        let used = self.name(kind, &own, is_prone && kind != 5, random);
        let text = match (kind, used) {
            (0, Some(a)) => format!("let {own} = {} + {a};", random.of(&["x*y", "sqrt(c)", "2", "sin(x)"])),
            (0, None) => format!("let {own} = {};", random.of(&["x", "c*y", "x**2 + 1"])),
            (1, Some(w)) => format!("form {own}: 1 on P = {}*{w};", random.of(&["x", "c", "3"])),
            (1, None) => format!("form {own} = x*dy - c*dx;"),
            (2, Some(v)) => format!("field {own} on P = @x + {}*{v};", random.of(&["y", "c"])),
            (2, None) => format!("field {own} = y*@x;"),
            (3, Some(f)) => format!("map {own}: P -> P = (pullback({f}, x*y), y);"),
            (3, None) => format!("map {own}: P -> P = (x + y, c*y);"),
            (4, Some(g)) => format!("metric {own} on P = dx**2 + (1 + inner[{g}](dx, dx)**2)*dy**2;"),
            (4, None) => format!("metric {own} on P = dx**2 + c*dy**2;"),
            (5, Some(f)) => format!("fn {own}(x, y) where {f} > 0;"),
            (5, None) => format!("fn {own}(x, y);"),
            (_, Some(chart)) => format!("chart {own} = {chart} * P;"),
            (_, None) => format!("chart {own}(u{number}, w{number}) where u{number} > 0;"),
        };
        self.known[kind].push(own);
        let _ = writeln!(self.text, "{text}");
    }

    fn kernel_or_warp(&mut self, number: usize, is_prone: bool, random: &mut SplitMix) {
        let own = format!("n{number}");
        let used = self.name(3, &own, is_prone, random).unwrap_or("x".to_string());
        let body = if used == "x" { "x*y".to_string() } else { format!("pullback({used}, x)") };
        let _ = match random.below(3) {
            0 => writeln!(self.text, "kernel {own}(x, y, c) = {body};"),
            1 => writeln!(self.text, "kernel {own}(x, y, c) = {body} where 0 < y < 1;"),
            _ => {
                self.claims += 1;
                let map = if used == "x" { "p".to_string() } else { format!("p + 0*pullback({used}, 1)") };
                writeln!(self.text, "warp {own}(; p, q) = ({map}, q) onto P density 1 of dx^dy;")
            }
        };
    }

    fn claim(&mut self, number: usize, random: &mut SplitMix) {
        let mut use_one = |kind: usize, otherwise: &str| match self.known[kind].last() {
            Some(name) if random.below(3) > 0 => name.clone(),
            _ => otherwise.to_string(),
        };
        let (scalar, form, field) = (use_one(0, "x"), use_one(1, "dx"), use_one(2, "@x"));
        let word = random.of(&["prove", "refute"]);
        let equation = match random.below(4) {
            0 => format!("{scalar} == {scalar}"),
            1 => format!("d({form}) == d({form})"),
            2 => format!("interior({field}, {form}) == 2 where x > {scalar}"),
            _ => "x + y == y + x".to_string(),
        };
        self.claims += 1;
        let _ = writeln!(self.text, "{word} s{number}: {equation};");
    }
}

#[test]
fn a_comment_ends_where_an_editor_ends_the_line() {
    for end in ["\n", "\r\n", "\r", "\u{2028}", "\u{2029}", "\u{85}"] {
        let (theory, errors) = read_theory(&format!("chart L(x); // a comment{end}prove p: x == x;"));
        assert!(theory.statements.len() == 1 || !errors.is_empty(), "{end:?}");
    }
}
