//! The functions that the bench `kernels` times are right: all functions of a kernel agree. These
//! are the hand-written ones with the instruction sets of this processor, and the ones that two
//! other generators derive from the textbook's formula. The elementary functions of the
//! hand-written ones are tested too.

use forms_competitors::catalogue::{self, Entry};
use forms_competitors::expert::batch::{InstructionSet, batch};
use forms_competitors::expert::vector::Vector;
use forms_competitors::inputs;
use std::path::Path;
use std::process::Command;

/// Number of values: no multiple of the lanes of any register, so that the remainder loop runs too.
const VALUES: usize = 4099;

fn columns_of(entry: &Entry) -> Vec<Vec<f64>> {
    inputs::columns(entry.domain, VALUES)
}

fn slices(columns: &[Vec<f64>]) -> Vec<&[f64]> {
    columns.iter().map(Vec::as_slice).collect()
}

/// Returns the values of all functions of an entry.
fn values(entry: &Entry) -> Vec<Vec<f64>> {
    let columns = columns_of(entry);
    let values = entry.functions.iter().map(|(_, function)| {
        let mut out = vec![f64::NAN; VALUES];
        function(&slices(&columns), &mut out);
        out
    });
    values.collect()
}

/// Returns the largest distance between values, relative to the typical size of this kernel's
/// values: rounding errors of cancelled sums have that size.
fn distance(values: &[f64], others: &[f64]) -> f64 {
    let size = others.iter().map(|value| value.abs()).sum::<f64>() / others.len() as f64;
    let far = values.iter().zip(others).map(|(value, other)| (value - other).abs() / (other.abs() + size));
    far.fold(0.0, |greatest: f64, far| if far <= greatest || greatest.is_nan() { greatest } else { far })
}

#[test]
fn all_functions_of_a_kernel_agree() {
    for (tool, why) in forms_competitors::missing() {
        forms_testing::skipped("competitors::all_functions_of_a_kernel_agree", tool, why);
    }
    for &set in InstructionSet::all() {
        for entry in catalogue::all(set) {
            let values = values(&entry);
            for (others, (author, _)) in values.iter().zip(&entry.functions).skip(1) {
                let far = distance(&values[0], others);
                assert!(far < 1e-12, "{}, {set:?}: {author:?} differs by {far}", entry.name);
            }
        }
    }
}

/// Whether Python has a module.
fn has_module(module: &str) -> bool {
    let import = Command::new("python3").args(["-c", &format!("import {module}")]).output();
    import.is_ok_and(|output| output.status.success())
}

#[test]
fn the_code_of_other_generators_is_what_the_script_writes() {
    let crate_folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("generated");
    for (module, name) in [("sympy", "by_sympy.rs"), ("wrenfold", "by_wrenfold.rs")] {
        let Ok(compiled) = std::fs::read_to_string(crate_folder.join("generated").join(name)) else {
            continue;
        };
        if !has_module(module) {
            let test = "competitors::the_code_of_other_generators_is_what_the_script_writes";
            forms_testing::skipped(test, module, "its code cannot be written again");
            continue;
        }
        let mut script = Command::new("python3");
        let output =
            script.arg(crate_folder.join("generate.py")).args([folder.as_path(), Path::new(name)]).output();
        let output = output.expect("Python runs");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        let written = std::fs::read_to_string(folder.join(name)).expect("the script writes it");
        // the first line names the version of the generator
        let without_version = |text: &str| text.split_once('\n').map(|(_, rest)| rest.to_owned());
        assert_eq!(without_version(&compiled), without_version(&written), "{name}: run generate.py");
    }
}

fn exp_of<V: Vector>([x]: [V; 1]) -> V {
    x.exp_and_exp_m1().0
}
fn exp_m1_of<V: Vector>([x]: [V; 1]) -> V {
    x.exp_and_exp_m1().1
}
fn atan2_of<V: Vector>([y, x]: [V; 2]) -> V {
    y.atan2(x)
}
fn angle_over_sine_of<V: Vector>([s, x]: [V; 2]) -> V {
    s.angle_over_sine(x)
}
batch!(exp, 1, super::exp_of);
batch!(exp_m1, 1, super::exp_m1_of);
batch!(atan2, 2, super::atan2_of);
batch!(angle_over_sine, 2, super::angle_over_sine_of);

/// Returns the largest relative error of values compared with those of the system, in units of
/// `f64::EPSILON`.
fn roundings(values: &[f64], expected: impl Iterator<Item = f64>) -> f64 {
    let errors =
        values.iter().zip(expected).map(|(value, expected)| (value / expected - 1.0).abs() / f64::EPSILON);
    errors.fold(
        0.0,
        |greatest: f64, error| if error <= greatest || greatest.is_nan() { greatest } else { error },
    )
}

#[test]
fn exponentials_are_within_two_roundings() {
    let near = (1..200_000).map(|i| f64::from(i - 100_000) * 7e-6);
    let far = (1..200_000).map(|i| f64::from(i - 100_000) * 7e-3);
    let x: Vec<f64> = near.chain(far).filter(|&x| x != 0.0).collect();
    let mut out = vec![0.0; x.len()];
    for &set in InstructionSet::all() {
        exp::with(set, &[&x], &mut out);
        assert!(roundings(&out, x.iter().map(|x| x.exp())) <= 2.0, "{set:?}");
        exp_m1::with(set, &[&x], &mut out);
        assert!(roundings(&out, x.iter().map(|x| x.exp_m1())) <= 2.0, "{set:?}");
    }
}

#[test]
fn angles_are_within_four_roundings() {
    let turns: Vec<f64> =
        (1..200_000).map(|i| f64::from(i - 100_000) * 3.1415e-5).filter(|&x| x != 0.0).collect();
    let (y, x): (Vec<f64>, Vec<f64>) = turns.iter().map(|turn| turn.sin_cos()).unzip();
    let mut out = vec![0.0; x.len()];
    for &set in InstructionSet::all() {
        atan2::with(set, &[&y, &x], &mut out);
        assert!(roundings(&out, y.iter().zip(&x).map(|(y, x)| y.atan2(*x))) <= 4.0, "{set:?}");
        let sines: Vec<f64> = y.iter().map(|y| y.abs()).collect();
        angle_over_sine::with(set, &[&sines, &x], &mut out);
        assert!(roundings(&out, sines.iter().zip(&x).map(|(s, x)| s.atan2(*x) / s)) <= 4.0, "{set:?}");
    }
}
