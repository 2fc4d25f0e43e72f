//! Certificates with one number, sign or name changed.

use crate::support::{case_file, certificate, checked, is_accepted};
use forms_check::Outcome;

/// Returns every text that differs in one number, sign or operator.
fn mutations(text: &str) -> Vec<(usize, String)> {
    let mut all = Vec::new();
    let bytes = text.as_bytes();
    for (place, byte) in text.char_indices() {
        let word = |at: usize| bytes.get(at).is_some_and(|b| b.is_ascii_alphabetic() || *b == b'_');
        let within_name = place > 0 && (word(place - 1) || (byte.is_ascii_digit() && in_name(bytes, place)));
        let others: &[&str] = match byte {
            _ if within_name => &[],
            '0'..='8' => &["9"],
            '9' => &["1", "8"],
            '+' => &["-"],
            '-' => &["+"],
            '*' if bytes.get(place + 1) != Some(&b'*') && bytes[place - 1] != b'*' => &["/", "+"],
            '/' => &["*"],
            _ => &[],
        };
        for other in others {
            all.push((place, format!("{}{other}{}", &text[..place], &text[place + 1..])));
        }
    }
    all
}

/// Whether a digit belongs to a name such as `x2`.
fn in_name(bytes: &[u8], place: usize) -> bool {
    let is_word = |b: &u8| b.is_ascii_alphanumeric() || *b == b'_';
    let start = bytes[..place].iter().rposition(|b| !is_word(b)).map_or(0, |at| at + 1);
    bytes[start].is_ascii_alphabetic()
}

fn line_at(text: &str, place: usize) -> &str {
    let start = text[..place].rfind('\n').map_or(0, |at| at + 1);
    text[start..].lines().next().unwrap_or_default().trim()
}

/// Returns the lines with a mutation that is accepted; all other mutations are rejected or
/// malformed.
fn surviving(source: &str) -> Vec<String> {
    let lines = certificate(source);
    assert!(is_accepted(&lines, source), "{:?}\n{lines}", checked(&lines, source));
    let start = lines.find("hash").unwrap_or(0);
    let survivors = mutations(&lines[start..]).into_iter().filter_map(|(place, changed)| {
        let changed = format!("{}{changed}", &lines[..start]);
        // a different value of a variable on which the sides do not depend gives another witness of
        // the same difference
        let is_free = line_at(&lines, start + place).starts_with("at p = ");
        (is_accepted(&changed, source) && !is_free).then(|| {
            let (from, to) = (line_at(&lines, start + place), line_at(&changed, start + place));
            format!("{from} -> {to}")
        })
    });
    survivors.collect()
}

const ROOTS: &str = "chart R3(x, y, z) where x**2 + y**2 + z**2 > 0; param a, b where a > 0, b > 1;\n\
    let r = sqrt(x**2 + y**2 + z**2);\n\
    prove closed: d((x*dy^dz + y*dz^dx + z*dx^dy)/r**3) == 0;\n\
    refute open: d((x*dy^dz + y*dz^dx + z*dx^dy)/r**2) == 0;\n\
    prove difference: sqrt(x**2 - 2*x*y + y**2) == abs(x - y);\n\
    prove powers: a**(1/2)*a**(1/3) == a**(5/6);\n\
    prove beyond: sqrt((b - 1)**2) == b - 1;\n\
    prove number: sqrt(12) == 2*sqrt(3);\n";

#[test]
fn no_number_of_a_proof_by_roots_can_be_changed() {
    assert_eq!(surviving(ROOTS), Vec::<String>::new());
}

const CASES: &str = "chart P(x, y);\n\
    prove square: sqrt(x**2) == abs(x);\n\
    prove product: sqrt(x*y)**2 == x*y;\n\
    prove both: sqrt(x**2*y**2) == abs(x)*abs(y);\n\
    prove inner: sqrt((abs(x) - 1)**2) == abs(abs(x) - 1);\n\
    refute wrong: sqrt(x**2*y) == x*sqrt(y);\n";

#[test]
fn no_sign_of_a_case_can_be_changed() {
    assert_eq!(surviving(CASES), Vec::<String>::new());
}

const ANGLES: &str = "chart S(t, p) where 0 < t < pi; fn f(t, p);\n\
    prove double: sin(2*t) == 2*sin(t)*cos(t);\n\
    prove root: sqrt(sin(t)**2) == sin(t);\n\
    prove mixed: d(f*sin(t)*dp) == (diff(f, t)*sin(t) + f*cos(t))*dt^dp;\n\
    refute not_mixed: d(f*sin(t)*dp) == f*cos(t)*dt^dp;\n\
    prove hyperbolic: cosh(2*t) == 1 + 2*sinh(t)**2;\n";

#[test]
fn no_number_of_a_proof_by_angles_can_be_changed() {
    assert_eq!(surviving(ANGLES), Vec::<String>::new());
}

const LOGARITHMS: &str = "chart P(x, y) where x > 0, y > 0; param q;\n\
    prove product: log(6*x**2*y) == log(2) + log(3) + 2*log(x) + log(y);\n\
    prove power: exp(log(x)/2)**2 == x;\n\
    prove symbolic: x**(q + 1)*x**-q == x;\n\
    refute sum: log(x + y) == log(x) + log(y);\n";

#[test]
fn no_number_of_a_proof_by_logarithms_can_be_changed() {
    assert_eq!(surviving(LOGARITHMS), Vec::<String>::new());
}

#[test]
fn no_number_of_a_refutation_of_the_case_files_can_be_changed() {
    let source = case_file("sphere_pullbacks");
    let lines = certificate(&source);
    let (head, _) = lines.split_once("\nproved").expect("a proof");
    let refutations = lines.split("\n\n").filter(|entry| entry.starts_with("refuted"));
    for entry in refutations {
        let name = entry.lines().next().and_then(|line| line.split(' ').nth(1)).expect("a name");
        for (place, changed) in mutations(entry) {
            let all = checked(&format!("{head}\n{changed}\n"), &source);
            let survives = all
                .is_ok_and(|all| all.iter().any(|one| one.name == name && one.outcome == Outcome::Accepted));
            let is_free =
                ["at phi = ", "at tilt = "].iter().any(|free| line_at(entry, place).starts_with(free));
            assert!(!survives || is_free, "{} -> {}", line_at(entry, place), line_at(&changed, place));
        }
    }
}

#[test]
fn a_certificate_speaks_of_the_file_it_was_made_for() {
    let lines = certificate(ROOTS);
    assert!(checked(&lines, &ROOTS.replace("r**3", "r**2")).is_err());
}

#[test]
fn malformed_certificates_are_errors_and_no_panics() {
    let lines = certificate(ROOTS);
    for end in (0..lines.len()).step_by(5) {
        let _ = checked(&lines[..end], ROOTS);
    }
    let mut state = 1_u64;
    for _ in 0..400 {
        let mut bytes = lines.clone().into_bytes();
        for _ in 0..3 {
            state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
            let place = (state >> 33) as usize % bytes.len();
            bytes[place] = b"0 \n(*-^[s"[(state >> 20) as usize % 9];
        }
        let _ = checked(&String::from_utf8_lossy(&bytes), ROOTS);
    }
    for text in ["", "forms certificate 1", "forms certificate 2\n", "forms certificate 1\nproved x\nzero\n"]
    {
        assert!(checked(text, ROOTS).map_or(true, |all| all.is_empty()), "{text}");
    }
}
