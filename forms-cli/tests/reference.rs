//! Reference values: every row with a kernel of the library agrees with the program within the
//! tolerance of the row.
//!
//! The rows are computed as by a user, with `forms eval - KERNEL`, and compared as exact rationals.
//! `own.json` is written by `tests/reference/make_rows.py`, from definitions.

use forms::core::check::read_theory;
use forms_testing::exact;
use num_traits::Signed;
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::Write;
use std::process::{Command, Stdio};

const ROWS: &str = include_str!("../../tests/reference/visible.json");
const OWN_ROWS: &str = include_str!("../../tests/reference/own.json");

/// Formats a number of a row as input for the program: numbers of JSON are the nearest doubles,
/// texts are decimals.
fn text(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        number => format!("{:?}", number.as_f64().expect("a number")),
    }
}

/// Evaluates a kernel for these rows; returns the output that each row selects, by default the
/// first.
fn evaluated(kernel: &str, rows: &[&Value]) -> Vec<String> {
    let names: Vec<&String> = rows[0]["args"].as_object().expect("arguments").keys().collect();
    let line = |items: Vec<String>| items.join(",") + "\n";
    let mut input = line(names.iter().map(ToString::to_string).collect());
    for row in rows {
        input += &line(names.iter().map(|name| text(&row["args"][name.as_str()])).collect());
    }
    let mut program = Command::new(env!("CARGO_BIN_EXE_forms"))
        .args(["eval", "-", kernel])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("the program starts");
    program.stdin.take().expect("a pipe").write_all(input.as_bytes()).expect("the rows are read");
    let output = program.wait_with_output().expect("the program ends");
    assert!(output.status.success(), "{kernel}");
    let output = String::from_utf8(output.stdout).expect("text");
    let lines = output.lines().skip(1).map(|line| line.split(',').skip(names.len()).collect::<Vec<_>>());
    lines
        .zip(rows)
        .map(|(values, row)| values[row["output"].as_u64().unwrap_or(0) as usize].to_string())
        .collect()
}

/// Whether |y − value| ≤ max(rtol |value|, atol).
fn is_within(row: &Value, computed: &str) -> bool {
    if !computed.contains(|c: char| c.is_ascii_digit()) {
        return false;
    }
    let of = |key: &str| exact(&text(&row[key]));
    let value = of("value");
    let tolerance = (of("rtol") * value.abs()).max(of("atol"));
    (exact(computed) - value).abs() <= tolerance
}

/// Groups the rows by their kernel.
fn by_kernel(reference: &Value) -> BTreeMap<&str, Vec<&Value>> {
    let mut kernels: BTreeMap<&str, Vec<&Value>> = BTreeMap::new();
    for row in reference["cases"].as_array().expect("cases") {
        if let Some(kernel) = row["kernel"].as_str() {
            kernels.entry(kernel).or_default().push(row);
        }
    }
    kernels
}

fn are_within(kernels: &BTreeMap<&str, Vec<&Value>>) {
    let mut wrong = Vec::new();
    for (kernel, rows) in kernels {
        let values = evaluated(kernel, rows);
        assert_eq!(values.len(), rows.len(), "{kernel}");
        let outside = rows.iter().zip(&values).filter(|(row, value)| !is_within(row, value));
        wrong.extend(outside.map(|(row, value)| format!("{}: {value}, not {}", row["id"], row["value"])));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_row_that_names_a_kernel_is_within_its_tolerance() {
    let reference: Value = serde_json::from_str(ROWS).expect("JSON");
    let kernels = by_kernel(&reference);
    assert!(kernels.len() >= 22, "{} kernels", kernels.len());
    are_within(&kernels);
}

#[test]
fn every_kernel_has_rows_from_its_definition_and_is_within_their_tolerance() {
    let reference: Value = serde_json::from_str(OWN_ROWS).expect("JSON");
    let kernels = by_kernel(&reference);
    let library = forms_kernels::library().iter().flat_map(|file| read_theory(file.text).0.kernels);
    for kernel in library.filter(|kernel| kernel.public) {
        let rows = kernels.get(kernel.name.as_str()).map_or(0, Vec::len);
        assert!(rows >= 10, "{} has {rows} rows", kernel.name);
    }
    are_within(&kernels);
}

#[test]
fn a_value_beside_its_tolerance_is_noticed() {
    let row = serde_json::json!({"value": "0.25", "rtol": 1e-15, "atol": 5e-324});
    assert!(is_within(&row, "2.5000000000000000e-1") && is_within(&row, "2.5000000000000011e-1"));
    assert!(!is_within(&row, "2.5000000000000056e-1") && !is_within(&row, "NaN"));
}
