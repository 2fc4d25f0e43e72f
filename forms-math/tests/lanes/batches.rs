//! Batches of every length, with every set of instructions, with rows that lanes give up on, and
//! with columns that do not match.

use crate::arguments::Draw;
use crate::formulas::{Clausen, Sin};
use forms_math::{Column, Formula, Instructions, LengthMismatch, Real, batch, batch_by, batch_f32};

/// Lengths around those of blocks, which are powers of two.
const LENGTHS: [usize; 19] =
    [0, 1, 2, 31, 32, 33, 40, 63, 64, 65, 100, 127, 129, 255, 256, 257, 511, 513, 1000];

/// Point on a spiral, and its distance from the centre.
struct Spiral;
impl Formula<2, 3> for Spiral {
    #[inline(always)]
    fn value<T: Real>([angle, growth]: [T; 2]) -> [T; 3] {
        let radius = (angle * growth).exp();
        [radius * angle.cos(), radius * angle.sin(), radius]
    }
}

fn columns(length: usize) -> [Vec<f64>; 2] {
    let mut draw = Draw(length as u64);
    let mut column = |low, high| (0..length).map(|_| draw.between(low, high)).collect();
    [column(-40.0, 40.0), column(-0.5, 0.5)]
}

fn spirals(instructions: Instructions, [angles, growths]: [&[f64]; 2]) -> [Vec<f64>; 3] {
    let mut outputs = [(); 3].map(|()| vec![f64::NAN; angles.len()]);
    let places = outputs.each_mut().map(|output| &mut output[..]);
    batch_by::<Spiral, 2, 3>(instructions, [angles, growths], places).expect("columns have one length");
    outputs
}

fn close(left: f64, right: f64, relative: f64) -> bool {
    (left - right).abs() <= relative * right.abs() || left.to_bits() == right.to_bits()
}

#[test]
fn a_batch_has_the_values_of_the_formula() {
    for length in LENGTHS {
        let [angles, growths] = columns(length);
        for instructions in Instructions::available() {
            let outputs = spirals(instructions, [&angles, &growths]);
            for row in 0..length {
                let values = Spiral::value([angles[row], growths[row]]);
                for (output, value) in outputs.iter().zip(values) {
                    assert!(close(output[row], value, 1e-15), "{length} rows, row {row}, {instructions:?}");
                }
            }
        }
    }
}

#[test]
fn a_row_does_not_depend_on_the_rows_beside_it() {
    let [angles, growths] = columns(300);
    for instructions in Instructions::available() {
        let together = spirals(instructions, [&angles, &growths]);
        for row in [0, 1, 17, 255, 256, 299] {
            let alone = spirals(instructions, [&angles[row..=row], &growths[row..=row]]);
            let bits =
                |values: &[Vec<f64>; 3], row: usize| values.each_ref().map(|column| column[row].to_bits());
            assert_eq!(bits(&together, row), bits(&alone, 0), "row {row}, {instructions:?}");
        }
    }
}

#[test]
fn values_that_lanes_do_not_reach_are_those_of_the_formula() {
    let x: Vec<f64> =
        (0..300).map(|row| if row % 7 == 0 { 1e300 * f64::from(row) } else { f64::from(row) }).collect();
    let mut values = vec![0.0; x.len()];
    batch::<Sin, 1, 1>([&x], [&mut values]).expect("columns have one length");
    assert!(x.iter().zip(&values).all(|(x, value)| close(*value, x.sin(), 3e-16)));
    batch::<Clausen, 1, 1>([&x[1..3]], [&mut values[..2]]).expect("columns have one length");
    assert_eq!(values[..2], [x[1].clausen(), x[2].clausen()]);
}

#[test]
fn outside_of_the_domain_a_batch_is_nan() {
    let mut outputs = [[0.0; 4]; 3];
    let places = outputs.each_mut().map(|output| &mut output[..]);
    batch::<Spiral, 2, 3>([&[f64::NAN, 1.0, f64::INFINITY, 0.0], &[0.1, f64::NAN, 0.1, 0.1]], places)
        .expect("columns have one length");
    assert!(outputs[0][..3].iter().all(|value| value.is_nan()));
    assert_eq!(outputs.map(|output| output[3]), [1.0, 0.0, 1.0]);
}

#[test]
fn batches_of_f32_have_the_values_of_the_formula() {
    let (angles, growths): (Vec<f32>, Vec<f32>) =
        (0..301).map(|row| (row as f32 * 0.1 - 15.0, 0.3 - row as f32 * 0.002)).unzip();
    let mut outputs = [(); 3].map(|()| vec![0.0; 301]);
    let places = outputs.each_mut().map(|output| &mut output[..]);
    batch_f32::<Spiral, 2, 3>([&angles, &growths], places).expect("columns have one length");
    for row in 0..301 {
        let values = Spiral::value([angles[row], growths[row]]);
        for (output, value) in outputs.iter().zip(values) {
            assert!(close(output[row].into(), value.into(), 1e-6), "row {row}");
        }
    }
}

#[test]
fn columns_of_other_lengths_are_errors() {
    let (mut first, mut second, mut third) = ([0.0; 3], [0.0; 3], [0.0; 2]);
    let outputs = [&mut first[..], &mut second[..], &mut third[..]];
    let found = batch::<Spiral, 2, 3>([&[1.0; 3], &[1.0; 3]], outputs);
    assert_eq!(found, Err(LengthMismatch { column: Column::Output(2), expected: 3, found: 2 }));
    let found = batch::<Spiral, 2, 3>([&[1.0; 3], &[1.0; 4]], [&mut [], &mut [], &mut []]);
    let mismatch = LengthMismatch { column: Column::Argument(1), expected: 3, found: 4 };
    assert_eq!(found, Err(mismatch));
    assert_eq!(mismatch.to_string(), "column 1 of the arguments has 4 values where the first column has 3");
}

#[cfg(feature = "rayon")]
#[test]
fn a_batch_on_all_processors_is_the_same() {
    let [angles, growths] = columns(20_000);
    let serial = spirals(Instructions::best(), [&angles, &growths]);
    let mut outputs = [(); 3].map(|()| vec![0.0; angles.len()]);
    let places = outputs.each_mut().map(|output| &mut output[..]);
    forms_math::batch_parallel::<Spiral, 2, 3>([&angles, &growths], places).expect("columns have one length");
    assert_eq!(serial, outputs);
    let mut promised = [(); 3].map(|()| vec![0.0; angles.len()]);
    let mut all = promised.clone();
    let places = promised.each_mut().map(|output| &mut output[..]);
    forms_math::batch_within::<Spiral, 2, 3>([&angles, &growths], places, 4.0).expect("one length");
    let places = all.each_mut().map(|output| &mut output[..]);
    forms_math::batch_within_parallel::<Spiral, 2, 3>([&angles, &growths], places, 4.0).expect("one length");
    assert_eq!(promised, all);
    assert!(serial != promised, "a promise costs nothing here");
}
