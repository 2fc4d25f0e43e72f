//! Kernels on the command line: evaluated, emitted, measured, listed.

use super::THEORY;
use super::process::{self, Folder, forms, forms_on};

#[test]
fn rows_are_evaluated_and_written_with_their_values() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let run = forms_on(&folder, &["eval", "good.forms", "ratio"], "b, a\n4, 1\n 3 , 1/3\n-1, 1\n");
    assert_eq!(run.status, 0, "{}", run.errors);
    let expected = "a,b,ratio\n\
        1.0000000000000000e0,4.0000000000000000e0,2.5000000000000000e-1\n\
        3.3333333333333331e-1,3.0000000000000000e0,1.1111111111111110e-1\n\
        1.0000000000000000e0,-1.0000000000000000e0,NaN\n";
    assert_eq!(run.output, expected);
    let several = forms_on(&folder, &["eval", "good.forms", "both", "--tier", "plain"], "x\n0.5\n");
    assert_eq!(
        several.output,
        "x,both_0,both_1\n5.0000000000000000e-1,5.0000000000000000e-1,1.0000000000000000e0\n"
    );
}

#[test]
fn a_kernel_is_computed_by_its_stable_form() {
    let folder = Folder::with(&[("growth.forms", "kernel growth(x) = exp(x) - 1;")]);
    let row = |tier: &[&str]| {
        forms_on(&folder, &[&["eval", "growth.forms", "growth"], tier].concat(), "x\n1e-17\n").output
    };
    assert!(row(&[]).ends_with(",1.0000000000000001e-17\n"), "{}", row(&[]));
    assert!(row(&["--tier", "plain"]).ends_with(",0.0000000000000000e0\n"), "{}", row(&["--tier", "plain"]));
    let source = forms(&folder, &["emit", "growth.forms", "--target", "c"]).output;
    assert!(source.contains("expm1("), "{source}");
}

/// Cargo compares the time of a source that a macro reads, and does not know a file of forms that
/// did not exist when the macro read it.
#[test]
fn a_first_file_of_chosen_forms_marks_its_source_as_changed() {
    let source = "kernel tri(x) = cos(x)*(exp(x) - 1 - x);";
    let folder = Folder::with(&[("tri.forms", source)]);
    let long_ago = std::time::SystemTime::UNIX_EPOCH + std::time::Duration::from_secs(1_000_000_000);
    let time =
        || std::fs::metadata(folder.path("tri.forms")).and_then(|file| file.modified()).expect("a time");
    let age = || {
        let file = std::fs::File::options().append(true).open(folder.path("tri.forms"));
        file.and_then(|file| file.set_modified(long_ago)).expect("a file whose time can be set");
    };
    for is_first in [true, false] {
        age();
        let run = forms(&folder, &["accuracy", "tri.forms", "--write"]);
        assert_eq!(run.status, 0, "{}", run.errors);
        assert!(!folder.read("tri.stable").is_empty(), "{}", run.output);
        assert_eq!(folder.read("tri.forms"), source.as_bytes());
        assert_eq!(time() > long_ago, is_first);
    }
}

#[test]
fn a_mistake_in_the_rows_is_named_and_ends_the_output() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let cases = [
        ("", "no header", 0),
        ("a\n1\n", "the column `b` is missing", 0),
        ("a,b,c\n1,2,3\n", "`c` is not an argument of `ratio`", 0),
        ("a,a,b\n1,1,2\n", "the column `a` occurs twice", 0),
        ("a,b\n1,2\n1,inf\n", "<stdin>:3", 2),
        ("a,b\n1,2\n1,2\n1\n", "expected 2 numbers in this row, found 1", 3),
    ];
    for (rows, message, lines) in cases {
        let run = forms_on(&folder, &["eval", "good.forms", "ratio"], rows);
        assert_eq!(run.status, 2, "{rows:?}");
        assert!(run.errors.contains(message), "{rows:?}: {}", run.errors);
        assert_eq!(run.output.lines().count(), lines, "{rows:?}: {}", run.output);
    }
}

#[test]
fn rows_that_no_precision_is_enough_for_are_told_of() {
    let folder = Folder::with(&[("sum.forms", "kernel k(x) = log(1 + exp(x)) within 2 where x < 1e300;")]);
    let rows = "x\n1\n1e200\n2\n1e201\n";
    for precision in ["f64", "dd"] {
        let run = forms_on(&folder, &["eval", "sum.forms", "k", "--precision", precision], rows);
        assert_eq!(run.output.lines().filter(|line| line.ends_with(",NaN")).count(), 2, "{}", run.output);
        assert!(
            run.errors.contains("2 rows without a value of `k`") && run.errors.contains("<stdin>:3"),
            "{}",
            run.errors
        );
    }
    let run = forms_on(&folder, &["eval", "sum.forms", "k"], "x\n1\n1e300\n");
    assert!(run.output.contains(",NaN") && run.errors.is_empty(), "outside the domain: {}", run.errors);
}

#[test]
fn an_argument_beyond_the_largest_number_is_refused() {
    let folder = Folder::with(&[("plain.forms", "kernel k(x) = x;")]);
    for (precision, argument) in [("f64", "1e400"), ("f64", "1/1e-400"), ("f32", "1e39"), ("dd", "-1e309")] {
        let run = forms_on(
            &folder,
            &["eval", "plain.forms", "k", "--precision", precision],
            &format!("x\n{argument}\n"),
        );
        assert_eq!(run.status, 2, "{}", run.output);
        assert!(run.errors.contains(&format!("`{argument}` for `x` exceeds the largest")), "{}", run.errors);
    }
    let run = forms_on(&folder, &["eval", "plain.forms", "k", "--precision", "exact"], "x\n1e400\n");
    assert_eq!(run.status, 0, "{}", run.errors);
}

#[test]
fn exact_evaluation_gives_fifty_digits_of_exact_arguments() {
    let source = "kernel versine(x) = (1 - cos(x))/x**2;\nkernel root(x) = sqrt(x)*sqrt(x) where x < 4;";
    let folder = Folder::with(&[("exact.forms", source)]);
    let run =
        forms_on(&folder, &["eval", "exact.forms", "versine", "--precision", "exact"], "x\n1/10\n1e-40\n0\n");
    let tenth = format!("1.{}e-1,4.9958347219742339044380121961297051614237745849160e-1", "0".repeat(49));
    let tiny = format!("1.{}e-40,5.{}e-1", "0".repeat(49), "0".repeat(49));
    assert_eq!(run.output.lines().skip(1).collect::<Vec<_>>(), [tenth.as_str(), tiny.as_str(), "0,NaN"]);
    let run = forms_on(&folder, &["eval", "exact.forms", "root", "--precision", "exact"], "x\n2\n5\n");
    let two = format!("2.{}e0", "0".repeat(49));
    assert_eq!(run.output.lines().nth(1), Some(format!("{two},{two}").as_str()));
    assert!(run.output.lines().nth(2).is_some_and(|row| row.ends_with(",NaN")), "{}", run.output);
}

#[test]
fn rows_are_evaluated_in_every_precision() {
    let folder = Folder::with(&[("third.forms", "kernel third(x) = x/3;")]);
    let value = |precision: &str| {
        let run = forms_on(&folder, &["eval", "third.forms", "third", "--precision", precision], "x\n0.1\n");
        assert_eq!(run.status, 0, "{}", run.errors);
        run.output.lines().nth(1).expect("a row").to_string()
    };
    assert_eq!(value("f32"), "1.0000000149011612e-1,3.3333335071802139e-2");
    assert_eq!(value("f64"), "1.0000000000000001e-1,3.3333333333333333e-2");
    let twice = value("dd");
    let (argument, quotient) = twice.split_once(',').expect("two columns");
    // The double-double nearest to 0.1 is below it, by a unit of the 33rd digit.
    assert!(
        argument.starts_with("9.9999999999999999999999999999999") && argument.ends_with("e-2"),
        "{twice}"
    );
    assert!(quotient.starts_with("3.33333333333333333333333333333") && quotient.len() == 40, "{twice}");
}

#[test]
fn kernels_are_emitted_in_every_language() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let emitted = |arguments: &[&str]| {
        let run = forms(&folder, &[&["emit", "good.forms", "--target"], arguments].concat());
        assert_eq!(run.status, 0, "{}", run.errors);
        run.output
    };
    assert!(emitted(&["c"]).contains("double ratio(double a, double b) {"));
    assert!(emitted(&["c", "--precision", "f32"]).contains("float ratio(float a, float b) {"));
    let cuda = emitted(&["cuda"]);
    assert!(cuda.contains("__device__ inline void both(double x, double *outputs) {"), "{cuda}");
    assert!(cuda.contains("extern \"C\" __global__ void both_batch("), "{cuda}");
    let wgsl = emitted(&["wgsl"]);
    assert!(wgsl.contains("fn both(x: f32) -> array<f32, 2> {"), "{wgsl}");
    assert!(wgsl.contains("@compute @workgroup_size(64)\nfn both_batch("), "{wgsl}");
    for precision in ["f32", "f64", "dd"] {
        let source = emitted(&["rust", "--precision", precision]);
        assert!(process::compiles(&folder, &source), "{source}");
    }
}

#[test]
fn a_function_that_a_target_does_not_have_is_named() {
    let folder = Folder::with(&[("special.forms", "kernel thick(x) = expint3(x) where x > 0;")]);
    let run = forms(&folder, &["emit", "special.forms", "--target", "c"]);
    assert_eq!((run.status, run.output.as_str()), (2, ""));
    assert!(
        run.errors.contains("`thick` calls `expint3`, which the target `c` does not have"),
        "{}",
        run.errors
    );
    let source = forms(&folder, &["emit", "special.forms", "--target", "rust"]).output;
    assert!(process::compiles(&folder, &source), "{source}");
}

#[test]
fn a_number_that_f64_does_not_hold_is_an_error_and_not_an_infinity() {
    let folder = Folder::with(&[("huge.forms", "kernel huge(x) = 1e400*x; kernel tiny(x) = x/10**400;")]);
    for (kernel, size) in [("huge", "large"), ("tiny", "large")] {
        let run = forms_on(&folder, &["eval", "huge.forms", kernel], "x\n1\n");
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{kernel}");
        assert!(run.errors.contains(&format!("is too {size} for `f64`")), "{}", run.errors);
    }
}

#[test]
fn what_is_not_available_is_said() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let cases: [&[&str]; 7] = [
        &["emit", "good.forms", "--target", "wgsl", "--precision", "f64"],
        &["emit", "good.forms", "--target", "c", "--precision", "f16"],
        &["emit", "good.forms", "--target", "cobol"],
        &["emit", "good.forms", "--target", "rust", "--kernel", "nothing"],
        &["eval", "good.forms", "ratio", "--precision", "f16"],
        &["eval", "good.forms", "nothing"],
        &["conquer"],
    ];
    for arguments in cases {
        let run = forms(&folder, arguments);
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{arguments:?}");
        assert!(run.errors.starts_with("error: "), "{arguments:?}: {}", run.errors);
    }
}

#[test]
fn every_kernel_of_the_library_is_listed_evaluated_and_emitted() {
    let folder = Folder::with(&[]);
    let list = forms(&folder, &["kernels"]).output;
    for name in ["measure_area_to_solid_angle", "half_vector_jacobian", "transmittance", "basic_radiance"] {
        assert!(list.lines().any(|line| line == name), "{list}");
    }
    assert!(
        list.contains("r2 [m**2], cos_theta [1], in sr/m**2") && list.contains("= cos_theta/r2"),
        "{list}"
    );
    let run = forms_on(&folder, &["eval", "-", "half_vector_jacobian"], "cos_oh\n0.5\n");
    assert_eq!(run.output, "cos_oh,half_vector_jacobian\n5.0000000000000000e-1,5.0000000000000000e-1\n");
    let source = forms(&folder, &["emit", "-", "--target", "rust"]).output;
    assert!(process::compiles(&folder, &source), "{source}");
    assert!(
        source.contains("/// Units: `r2` in `m**2`, `cos_theta` in `1`; result in `sr/m**2`."),
        "{source}"
    );
}

#[test]
fn emitted_source_compiles_as_it_stands() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let run = forms(&folder, &["emit", "good.forms", "--target", "rust"]);
    assert_eq!(run.status, 0);
    assert!(run.output.contains("pub fn ratio(a: f64, b: f64) -> f64"), "{}", run.output);
    assert!(process::compiles(&folder, &run.output), "{}", run.output);
    let one = forms(&folder, &["emit", "good.forms", "--target", "rust", "--kernel", "both"]);
    assert!(one.output.contains("fn both") && !one.output.contains("fn ratio"), "{}", one.output);
}

#[test]
fn a_kernel_is_emitted_without_each_set_of_its_effects_too() {
    let beam = "kernel beam(e, a, s, t) = e*(1 - exp(-(a + s)*t))/(a + s) effects { absorption: a = 0; scattering: s = 0; };";
    let folder = Folder::with(&[("beam.forms", beam)]);
    for (target, function) in [("rust", "pub fn "), ("c", "double "), ("cuda", "double ")] {
        let run = forms(&folder, &["emit", "beam.forms", "--target", target]);
        assert_eq!(run.status, 0, "{}", run.errors);
        for absent in ["", "_without_absorption", "_without_scattering", "_without_absorption_scattering"] {
            assert!(run.output.contains(&format!("{function}beam{absent}(")), "{absent}: {}", run.output);
        }
        assert!(run.output.contains("e*t") || run.output.contains("e * t"), "{}", run.output);
    }
    let rust = forms(&folder, &["emit", "beam.forms", "--target", "rust"]).output;
    assert!(process::compiles(&folder, &rust), "{rust}");
}

#[test]
fn a_sheet_says_what_every_variant_loses_and_what_no_argument_exceeds() {
    let kernels = "kernel half_root(x) = sqrt(x)/3 where 1 <= x <= 4; kernel less_one(x) = exp(x) - 1;";
    let folder = Folder::with(&[("k.forms", kernels)]);
    let run = forms(&folder, &["accuracy", "k.forms", "--json", "--no-times", "--samples", "8"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    let sheets: Vec<serde_json::Value> =
        run.output.lines().map(|line| serde_json::from_str(line).expect("JSON")).collect();
    let [root, less_one] = &sheets[..] else { panic!("{}", run.output) };
    let units = root["bounds"][0]["units"].as_f64().expect("a bound");
    assert_eq!(root["variants"].as_array().map(Vec::len), Some(9));
    for variant in root["variants"].as_array().into_iter().flatten().filter(|v| v["variant"] == "f64") {
        for regime in variant["regimes"].as_array().into_iter().flatten() {
            // An ulp is one or two units of 2**-53.
            assert!(regime["ulps"]["maximum"].as_f64().is_some_and(|ulps| ulps <= units), "{variant}");
        }
    }
    assert!(less_one["bounds"].is_null() && less_one["stable_form"] == "expm1(x)", "{less_one}");
    assert_eq!(less_one["unbounded"], "the domain does not bound `x` on both sides");
}

#[test]
fn a_kernel_without_arguments_has_one_row() {
    let folder = Folder::with(&[("pi.forms", "kernel tau() = 2*pi; kernel both() = (1, 1/2);")]);
    assert_eq!(forms(&folder, &["eval", "pi.forms", "tau"]).output, "tau\n6.2831853071795862e0\n");
    let pair = forms(&folder, &["eval", "pi.forms", "both"]).output;
    assert_eq!(pair, "both_0,both_1\n1.0000000000000000e0,5.0000000000000000e-1\n");
}

#[test]
fn a_kernel_that_jumps_unsaid_is_neither_evaluated_nor_emitted() {
    let folder = Folder::with(&[("jump.forms", "kernel k(u) = if u > 0 { 1 } else { 0 };")]);
    for arguments in [&["eval", "jump.forms", "k"][..], &["emit", "jump.forms", "--target", "rust"]] {
        let run = forms(&folder, arguments);
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{arguments:?}");
        assert!(run.errors.contains("differ at the seam u = 0 of `k`"), "{}", run.errors);
        assert!(
            run.errors.contains("jump.forms:1:1") && run.errors.contains("write `if jump`"),
            "{}",
            run.errors
        );
    }
}

#[test]
fn emitted_source_says_whether_it_is_proved() {
    let text = "kernel k(x) = x**3 + x; kernel l(a) = sqrt(a + sqrt(a**2 - 1)) - (sqrt(a + 1) + sqrt(a - 1))/sqrt(2);";
    let folder = Folder::with(&[("k.forms", text)]);
    let run = forms(&folder, &["emit", "k.forms", "--target", "rust"]).output;
    let count = |part: &str| run.matches(part).count();
    let proved = count("/// Proved equal to its formula wherever both are defined.");
    let compared = count("/// Not proved equal to its formula, only compared with it at");
    assert!(proved >= 1 && proved + compared == 2, "{run}");
}
