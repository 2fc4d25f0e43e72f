//! What the bench `kernels` times is right: all functions of a kernel agree, the hand-written ones with the instruction
//! sets of this processor, and what two other generators make of the textbook's formula. The elementary functions of
//! the hand-written ones are tested beside them.

// The harness alone uses the rest of these modules.
#![allow(dead_code)]

#[path = "../benches/kernels/catalogue.rs"]
mod catalogue;
#[path = "../benches/kernels/elsewhere/mod.rs"]
mod elsewhere;
#[path = "../benches/kernels/expert/mod.rs"]
mod expert;
#[path = "../benches/kernels/inputs.rs"]
mod inputs;

use catalogue::Entry;
use expert::batch::InstructionSet;

/// No multiple of the lanes of any register, so that the rest is taken too.
const VALUES: usize = 4099;

fn columns_of(entry: &Entry) -> Vec<Vec<f64>> {
    inputs::columns(entry.domain, VALUES)
}

fn slices(columns: &[Vec<f64>]) -> Vec<&[f64]> {
    columns.iter().map(Vec::as_slice).collect()
}

/// The values of all functions of an entry.
fn values(entry: &Entry) -> Vec<Vec<f64>> {
    let columns = columns_of(entry);
    let values = entry.functions.iter().map(|(_, function)| {
        let mut out = vec![f64::NAN; VALUES];
        function(&slices(&columns), &mut out);
        out
    });
    values.collect()
}

/// How far apart values are, over the size that values of this kernel have: roundings of cancelled sums are of that size.
fn distance(values: &[f64], others: &[f64]) -> f64 {
    let size = others.iter().map(|value| value.abs()).sum::<f64>() / others.len() as f64;
    let far = values.iter().zip(others).map(|(value, other)| (value - other).abs() / (other.abs() + size));
    far.fold(0.0, |greatest: f64, far| if far <= greatest || greatest.is_nan() { greatest } else { far })
}

#[test]
fn all_functions_of_a_kernel_agree() {
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
