//! End-to-end tests of the program: exit statuses, both kinds of output, and messages about
//! mistakes.

mod book;
mod checkpoints;
mod dark;
mod emission;
mod hall;
mod kernels;
mod overrides;
mod process;
mod readme;
mod robust;
mod shares;
mod simulate;
mod view_factors;

use process::{Folder, Run, forms, forms_with_threads};

const THEORY: &str = "chart Line(x);\nchart UV(u, v);\n\
    prove square: (x + 1)**2 == x**2 + 2*x + 1;\n\
    refute shifted: x + 1 == x;\n\
    let q = (x**2 - 1)/(x - 1);\n\
    form w = (u**2 - v**2)/(u - v)*du^dv;\n\
    map swap: UV -> UV = (v, u);\n\
    pub kernel ratio(a, b) = a/b where b > 0;\n\
    kernel both(x) = (x, 2*x);\n";

#[test]
fn statements_as_stated_end_in_status_0() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let run = forms(&folder, &["prove", "good.forms"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    for part in ["good.forms", "✓ square", "proved", "✓ shifted", "refuted", "2 statements", "all as stated"]
    {
        assert!(run.output.contains(part), "{part}: {}", run.output);
    }
    assert!(!run.output.contains('\u{1b}'), "no colours where nobody sees them");
}

#[test]
fn a_statement_not_as_stated_ends_in_status_1() {
    let folder =
        Folder::with(&[("false.forms", "chart L(x); prove wrong: x == x + 1; refute right: x == x;")]);
    let run = forms(&folder, &["prove", "false.forms"]);
    assert_eq!(run.status, 1);
    assert!(run.output.contains("✗ wrong") && run.output.contains("does not hold"), "{}", run.output);
    assert!(run.output.contains("✗ right") && run.output.contains("holds after all"), "{}", run.output);
}

#[test]
fn a_false_claim_of_a_kernel_is_listed_like_a_statement() {
    let kernels = "chart L(x); prove right: x == x;\n\
        kernel loses(u, v) = sqrt(u**2 + v**2) by abs(u)*sqrt(1 + (v/u)**2);\n\
        kernel differs(x, y) = abs(y) + abs(1 + cos(x)) by 1 + cos(x) - y where (1 + cos(x))*y <= 0;\n\
        kernel step(u) = if u > 0 { u + 1 } else { u };\n\
        kernel pole(a) = abs(a)/a effects { off: a = 0; };\n\
        kernel fine(w) = sqrt(w + 1) - sqrt(w) by 1/(sqrt(w + 1) + sqrt(w)) where w >= 0;\n";
    let folder = Folder::with(&[("kernels.forms", kernels)]);
    let run = forms(&folder, &["prove", "kernels.forms"]);
    assert_eq!(run.status, 1, "{}", run.errors);
    // Messages are wrapped at the width of the terminal.
    let output = run.output.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in [
        "✓ right",
        "✗ loses: by",
        "u = 0, v = 0",
        "✗ differs: by",
        "x = pi, y = 1",
        "✗ step: seam",
        "✗ pole: effect",
        "1 statement: 1 proved; 3 claims of a kernel refuted; 1 claim of a kernel unknown; 4 are not as stated",
    ] {
        assert!(output.contains(part), "{part}: {}", run.output);
    }
    assert!(!output.contains("✗ fine") && !output.contains("✓ fine"), "{}", run.output);
    let run = forms(&folder, &["prove", "--json", "kernels.forms"]);
    assert_eq!((run.status, run.errors.as_str()), (1, ""));
    let lines: Vec<&str> = run.output.lines().collect();
    assert_eq!(lines.len(), 5);
    let loses = "{\"file\":\"kernels.forms\",\"name\":\"loses\",\"kind\":\"by\",\"verdict\":\"refuted\",\
        \"ok\":false,\"conditions\":[],\"witness\":{\"u\":\"0\",\"v\":\"0\"},\"micros\":";
    assert_eq!(without_micros(lines[1]), loses);
    assert!(lines[3].contains("\"kind\":\"seam\"") && lines[4].contains("\"kind\":\"effect\""), "{lines:?}");
}

#[test]
fn every_error_of_every_file_is_reported_with_its_place() {
    let first = "chart L(x);\nprove a: y == 1;\nlet b = dx*dx;\n";
    let folder =
        Folder::with(&[("first.forms", first), ("second.forms", "chart L(x)\n"), ("good.forms", THEORY)]);
    let run = forms(&folder, &["prove", "first.forms", "second.forms", "missing.forms", "good.forms"]);
    assert_eq!(run.status, 2);
    for place in ["first.forms:2:10", "first.forms:3:11", "second.forms:1:11", "missing.forms"] {
        assert!(run.errors.contains(place), "{place}: {}", run.errors);
    }
    assert!(run.errors.contains("2 | prove a: y == 1;"), "{}", run.errors);
    assert!(run.output.contains("✓ square"), "{}", run.output);
}

#[test]
fn json_has_one_object_a_line_with_these_keys_in_this_order() {
    let folder = Folder::with(&[("good.forms", THEORY), ("bad.forms", "let a = b;")]);
    let run = forms(&folder, &["prove", "--json", "good.forms", "bad.forms"]);
    assert_eq!((run.status, run.errors.as_str()), (2, ""));
    let lines: Vec<String> = run.output.lines().map(without_micros).collect();
    let statement = |name: &str, kind: &str, verdict: &str, rest: &str| {
        format!(
            "{{\"file\":\"good.forms\",\"name\":\"{name}\",\"kind\":\"{kind}\",\"verdict\":\"{verdict}\",\
             \"ok\":true,\"conditions\":[],\"witness\":{rest}"
        )
    };
    assert_eq!(lines[0], statement("square", "prove", "proved", "null,\"micros\":"));
    let refuted = statement("shifted", "refute", "refuted", "{");
    assert!(lines[1].starts_with(&refuted) && lines[1].ends_with("},\"micros\":"), "{}", lines[1]);
    assert_eq!(
        lines[2],
        "{\"file\":\"bad.forms\",\"line\":1,\"column\":9,\"error\":\"`b` is not declared\"}"
    );
    assert_eq!(lines.len(), 3);
    let again = forms(&folder, &["prove", "--json", "good.forms", "bad.forms"]);
    assert_eq!(lines, again.output.lines().map(without_micros).collect::<Vec<_>>());
}

/// Returns a line up to the time, the only part that changes.
fn without_micros(line: &str) -> String {
    serde_json::from_str::<serde_json::Value>(line).expect("every line is an object");
    match line.split_once("\"micros\":") {
        Some((before, _)) => format!("{before}\"micros\":"),
        None => line.to_string(),
    }
}

#[test]
fn what_is_no_text_is_an_error_and_no_panic() {
    let folder =
        Folder::with(&[("nul.forms", "\0"), ("deep.forms", &format!("let a = {};", "(".repeat(100_000)))]);
    folder.write("binary.forms", &[0x63, 0x0a, 0xff, 0xfe]);
    let cases = [
        ("nul.forms", "unexpected character"),
        ("deep.forms", "nested more than 256 levels deep"),
        ("binary.forms", "binary.forms:2:1"),
        (".", "cannot read the file"),
    ];
    for (file, message) in cases {
        let run = forms(&folder, &["prove", file]);
        assert_eq!(run.status, 2, "{file}");
        assert!(run.errors.contains(message), "{file}: {}", run.errors);
    }
}

#[test]
fn expressions_beyond_every_measure_are_errors_that_name_the_limit() {
    let coordinates: Vec<String> = (0..100).map(|i| format!("x{i}")).collect();
    let two_form: Vec<String> = (0..99).map(|i| format!("x{}*dx{i}^dx{}", i + 1, i + 1)).collect();
    let wedge = format!(
        "chart R({});\nform v: 2 = {};\nprove p: {} == 0;",
        coordinates.join(", "),
        two_form.join(" + "),
        ["v"; 12].join("^")
    );
    let folder = Folder::with(&[("wedge.forms", &wedge), ("power.forms", "chart L(x); let a = x**1000001;")]);
    for (file, message) in
        [("wedge.forms", "products of terms"), ("power.forms", "beyond the limit of 1000000")]
    {
        let run = forms(&folder, &["prove", file]);
        assert_eq!(run.status, 2, "{file}");
        assert!(run.errors.contains(message), "{file}: {}", run.errors);
    }
}

#[test]
fn a_named_object_is_shown_simplified() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let cases = [
        ("q", "text", "x + 1"),
        ("w", "text", "(u + v)*du^dv"),
        ("w", "latex", "\\left(u + v\\right)\\,\\mathrm{d}u\\wedge \\mathrm{d}v"),
        ("swap", "text", "(v, u)"),
        ("both", "text", "(x, 2*x)"),
        ("Line", "text", "Line(x)"),
        ("shifted", "text", "x + 1 == x"),
    ];
    for (name, notation, expected) in cases {
        let run = forms(&folder, &["show", "good.forms", name, "--as", notation]);
        assert_eq!((run.status, run.output.trim_end()), (0, expected), "{name}");
    }
    let mathml = forms(&folder, &["show", "good.forms", "w", "--as", "mathml"]);
    assert!(mathml.output.starts_with("<math") && mathml.output.trim_end().ends_with("</math>"));
    let measured = Folder::with(&[("units.forms", "chart R(x: m, t: s); let v = x/t;")]);
    assert_eq!(forms(&measured, &["show", "units.forms", "v"]).output.trim_end(), "x/t  // in m/s");
    assert_eq!(
        forms(&measured, &["show", "units.forms", "v", "--as", "latex"]).output.trim_end(),
        "\\frac{x}{t}"
    );
    let missing = forms(&folder, &["show", "good.forms", "nothing"]);
    assert_eq!((missing.status, missing.output.as_str()), (2, ""));
    assert!(missing.errors.contains("`nothing`"));
}

#[test]
fn a_reader_that_goes_away_is_no_failure() {
    let many: String = (0..3000).map(|i| format!("prove p{i}: x + {i} == {i} + x;\n")).collect();
    let folder = Folder::with(&[("many.forms", &format!("chart L(x);\n{many}"))]);
    let errors = process::first_line_only(&folder, &["prove", "many.forms"]);
    assert_eq!(errors, "");
}

#[test]
fn help_and_version_are_there() {
    let folder = Folder::with(&[]);
    let help = forms(&folder, &["--help"]);
    assert_eq!(help.status, 0);
    for command in ["prove", "show", "eval", "emit", "simulate", "merge", "kernels"] {
        assert!(help.output.contains(command));
    }
    let version = forms(&folder, &["--version"]);
    assert_eq!(version.output.trim_end(), format!("forms {}", env!("CARGO_PKG_VERSION")));
}

#[test]
fn a_file_with_errors_is_not_called_as_stated() {
    let folder = Folder::with(&[("good.forms", THEORY), ("bad.forms", "chart L(x)")]);
    let alone = forms(&folder, &["prove", "bad.forms"]);
    assert_eq!((alone.status, alone.output.as_str()), (2, "1 file with errors, not decided\n"));
    let both = forms(&folder, &["prove", "bad.forms", "good.forms"]).output;
    assert!(both.contains("1 file with errors, not decided\n2 statements: 1 proved, 1 refuted"), "{both}");
}

#[test]
fn a_derivation_is_printed_in_every_notation_and_its_status_tells_the_verdict() {
    let folder =
        Folder::with(&[("good.forms", THEORY), ("false.forms", "chart L(x); prove wrong: x == 2*x;")]);
    let text = forms(&folder, &["derive", "good.forms", "square"]);
    assert_eq!((text.status, text.errors.as_str()), (0, ""));
    assert!(text.output.contains("1. Claimed to hold") && text.output.contains("Proved"), "{}", text.output);
    let latex = forms(&folder, &["derive", "good.forms", "square", "--as", "latex"]);
    assert!(latex.output.contains("\\left(x + 1\\right)^{2} = x^{2} + 2\\,x + 1"), "{}", latex.output);
    let page = forms(&folder, &["derive", "good.forms", "square", "--as", "mathml"]);
    assert!(page.output.starts_with("<!doctype html>") && page.output.contains("<math"), "{}", page.output);
    assert!(!page.output.contains("<merror"), "{}", page.output);
    let wrong = forms(&folder, &["derive", "false.forms", "wrong"]);
    assert_eq!(wrong.status, 1);
    assert!(wrong.output.contains("left/right = 1/2"), "{}", wrong.output);
    let missing = forms(&folder, &["derive", "good.forms", "nothing"]);
    assert_eq!(missing.status, 2);
    assert!(missing.errors.contains("it has square, shifted"), "{}", missing.errors);
}

/// Returns twenty statements, more than one task holds, some of them false equations, and a vacuous
/// one.
fn many_statements() -> String {
    let statements = (1..=20).map(|k| match k % 3 {
        0 => format!("refute s{k}: (x + y)**{k} == x**{k} + y**{k};"),
        1 => format!("prove s{k}: sqrt((x + {k})**2) == abs(x + {k});"),
        _ => format!("prove s{k}: d(x**{k}*dy) == {k}*x**{}*dx^dy;", k - 1),
    });
    let statements: Vec<String> = statements.collect();
    format!("chart R2(x, y);\n{}\nprove nothing: x == y where x < 0, x > 1;\n", statements.join("\n"))
}

#[test]
fn the_output_does_not_depend_on_the_number_of_threads() {
    let many = many_statements();
    let one = "chart R2(x, y); prove one: d(d(x*y)) == 0;";
    let folder = Folder::with(&[("many.forms", &many), ("one.forms", one), ("broken.forms", "chart R2(x")]);
    let arguments = ["prove", "--json", "one.forms", "many.forms", "broken.forms", "one.forms"];
    let [serial, parallel] = ["1", "4"].map(|threads| forms_with_threads(&folder, &arguments, threads));
    let lines = |run: &Run| run.output.lines().map(without_micros).collect::<Vec<_>>();
    assert_eq!(lines(&serial), lines(&parallel));
    assert_eq!((serial.status, parallel.status), (2, 2));
    let names: Vec<String> = (1..=20).map(|k| format!("\"name\":\"s{k}\"")).collect();
    let printed = &lines(&serial)[1..=20];
    assert!(printed.iter().zip(&names).all(|(line, name)| line.contains(name.as_str())), "{printed:?}");
    assert!(printed.iter().all(|line| line.contains("\"ok\":true")), "{printed:?}");
}

#[test]
fn what_a_kernel_claims_is_decided_when_a_certificate_is_checked() {
    let source = "chart L(x);\nkernel k(u) = u by u + 1;\nprove ok: x == x;";
    let folder = Folder::with(&[("claims.forms", source)]);
    assert_eq!(forms(&folder, &["prove", "--certificate", "claims.certificate", "claims.forms"]).status, 1);
    let run = forms(&folder, &["check", "claims.certificate"]);
    assert_eq!((run.status, run.errors.as_str()), (1, ""), "{}", run.output);
    for line in ["accepted: proved, as stated", "✗ k: by", "1 claim of kernels not proved"] {
        assert!(run.output.contains(line), "{line}: {}", run.output);
    }
}

#[test]
fn a_certificate_is_checked_without_the_prover() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let run = forms(&folder, &["prove", "--certificate", "good.certificate", "good.forms"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    let run = forms(&folder, &["check", "good.certificate"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    assert!(run.output.contains("2 statements: 2 accepted, 0 rejected, 0 not covered"), "{}", run.output);
    for line in ["accepted: proved, as stated", "accepted: refuted, as stated"] {
        assert!(run.output.contains(line), "{}", run.output);
    }

    let lines = String::from_utf8(folder.read("good.certificate")).expect("text");
    folder.write("false.certificate", lines.replace("component", "compound").as_bytes());
    assert_eq!(forms(&folder, &["check", "false.certificate"]).status, 2);
    folder.write("false.certificate", lines.replace("left ", "left 5 + ").as_bytes());
    let run = forms(&folder, &["check", "false.certificate"]);
    assert_eq!(run.status, 1);
    assert!(run.output.contains("✗ shifted") && run.output.contains("1 rejected"), "{}", run.output);

    folder.write("good.forms", THEORY.replace("2*x + 1", "2*x + 2").as_bytes());
    let run = forms(&folder, &["check", "good.certificate"]);
    assert!(run.status == 2 && run.errors.contains("hash differs"), "{}", run.errors);
    assert_eq!(forms(&folder, &["check", "missing.certificate"]).status, 2);
}

#[test]
fn a_verdict_that_is_shown_and_is_not_the_stated_one_is_no_success() {
    let text = "chart L(x); prove p: x == x + 1; refute q: x == x;";
    let folder = Folder::with(&[("a.forms", text)]);
    assert_eq!(forms(&folder, &["prove", "--certificate", "a.certificate", "a.forms"]).status, 1);
    let run = forms(&folder, &["check", "a.certificate"]);
    assert_eq!(run.status, 1, "{}", run.output);
    for line in ["accepted: refuted, not as stated", "accepted: proved, not as stated"] {
        assert!(run.output.contains(line), "{}", run.output);
    }
}

#[test]
fn the_checker_takes_no_file_that_the_prover_refuses() {
    for text in [
        "chart L(x); prove a: 1 == 2; prove a: x == x;",
        "chart L(x); let a = a; prove q: x == x;",
        "chart L(x); form w = dx + dx^dx; prove q: x == x; prove r: w == w + x;",
        "chart L(x); let x = 1; prove q: x == x;",
    ] {
        let folder = Folder::with(&[("a.forms", text)]);
        let hash = text
            .bytes()
            .fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x0000_0100_0000_01b3));
        let name = if text.contains("prove q") { "q" } else { "a" };
        let lines = format!("forms certificate 1\nfile a.forms\nhash {hash:016x}\nproved {name}\nzero\n");
        folder.write("a.certificate", lines.as_bytes());
        let run = forms(&folder, &["check", "--allow-uncovered", "a.certificate"]);
        assert_eq!(run.status, 2, "{text}: {}", run.output);
    }
}

#[test]
fn the_checker_passes_over_units() {
    let text = "chart R(x: m, t: s); param k: m**(1/2), c: m/s where k > 0; let v: m/s = x/t; form w: 1, m on R = d(x);
prove p: v*t == x where c > 0; prove q: k**2*v*w == k**2*x/t*dx;";
    let folder = Folder::with(&[("units.forms", text)]);
    assert_eq!(forms(&folder, &["prove", "--certificate", "units.certificate", "units.forms"]).status, 0);
    let run = forms(&folder, &["check", "units.certificate"]);
    assert!(run.output.contains("2 accepted, 0 rejected, 0 not covered"), "{}", run.output);
}

#[test]
fn what_the_checker_does_not_know_is_not_accepted_unless_allowed() {
    let folder = Folder::with(&[("a.forms", "chart L(x); prove inverse: potential(d(x**2)) == x**2;")]);
    assert_eq!(forms(&folder, &["prove", "--certificate", "a.certificate", "a.forms"]).status, 0);
    let run = forms(&folder, &["check", "a.certificate"]);
    assert!(run.status == 1 && run.output.contains("1 not covered"), "{}", run.output);
    assert_eq!(forms(&folder, &["check", "--allow-uncovered", "a.certificate"]).status, 0);
}

#[test]
fn the_angle_form_is_closed_and_has_no_potential_around_the_origin() {
    let plane = "chart P(x, y) where x**2 + y**2 > 0; form angle = (x*dy - y*dx)/(x**2 + y**2); let f = x;";
    let folder = Folder::with(&[("plane.forms", plane)]);
    let run = forms(&folder, &["show", "plane.forms", "angle", "--topology"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    for part in
        ["contracts to the sphere S1 around x = 0, y = 0", "== 2*pi    (proved)", "let A = (atan2(y, x));"]
    {
        assert!(run.output.contains(part), "{part}: {}", run.output);
    }
    let scalar = forms(&folder, &["show", "plane.forms", "f", "--topology"]);
    assert_eq!(scalar.status, 2);
    assert!(scalar.errors.contains("only forms have periods"), "{}", scalar.errors);
}
