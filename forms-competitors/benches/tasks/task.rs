//! A task: a kernel, the functions that compute it, and typical arguments.

use crate::{as_written, by_hand};
use forms_competitors::expert::batch::InstructionSet;
use forms_testing::SplitMix;
use std::hint::black_box;

// The kernels, each with the form that the search has found.
forms::include_forms!("../tests/stability/applied.forms");

/// Function that fills the last slice with the values at these columns.
pub(crate) type Fill = fn(&[&[f64]], &mut [f64]);

/// Author and kind of a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Author {
    /// The formula as written, one value at a time.
    AsWritten,
    /// An expert's function, one value at a time.
    Expert,
    /// The generated function, one value at a time.
    Generated,
    /// An expert's function in a loop, compiled for the instruction set of the processor.
    ExpertBatch,
    /// The generated function over columns.
    GeneratedBatch,
}

impl Author {
    pub(crate) const ALL: [Self; 5] =
        [Self::AsWritten, Self::Expert, Self::Generated, Self::ExpertBatch, Self::GeneratedBatch];
}

/// Kernel with its functions, in the order of [`Author::ALL`].
pub(crate) struct Task {
    pub(crate) name: &'static str,
    /// Ranges of typical arguments.
    ranges: &'static [[f64; 2]],
    functions: [Fill; Author::ALL.len()],
}

impl Task {
    /// Returns the function of an author.
    pub(crate) fn by(&self, author: Author) -> Fill {
        self.functions[author as usize]
    }

    /// Returns columns of `count` typical arguments.
    pub(crate) fn columns(&self, count: usize) -> Vec<Vec<f64>> {
        let mut random = SplitMix(0x5eed);
        self.ranges.iter().map(|&range| (0..count).map(|_| random.between(range)).collect()).collect()
    }
}

/// Returns the columns as an array.
fn array<'a, const N: usize>(columns: &[&'a [f64]]) -> [&'a [f64]; N] {
    std::array::from_fn(|i| columns[i])
}

/// Wraps a function of one value in a loop that the compiler cannot vectorise.
macro_rules! one_at_a_time {
    ($function:path, $($argument:ident)*) => {
        |columns, out| {
            let [$($argument),*] = array(columns).map(|column: &[f64]| &column[..out.len()]);
            for i in 0..out.len() {
                out[i] = black_box($function($($argument[i]),*));
            }
        }
    };
}

/// Wraps an expert's function in a loop that is compiled for each instruction set.
macro_rules! looped {
    ($function:path, $($argument:ident)*) => {{
        #[inline(always)]
        fn portable(columns: &[&[f64]], out: &mut [f64]) {
            let [$($argument),*] = array(columns).map(|column: &[f64]| &column[..out.len()]);
            for i in 0..out.len() {
                out[i] = $function($($argument[i]),*);
            }
        }
        /// # Safety
        /// The processor must have AVX-512.
        #[cfg(target_arch = "x86_64")]
        #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
        unsafe fn avx512(columns: &[&[f64]], out: &mut [f64]) {
            portable(columns, out);
        }
        /// # Safety
        /// The processor must have AVX2 and fused multiply-add.
        #[cfg(target_arch = "x86_64")]
        #[target_feature(enable = "avx2,fma")]
        unsafe fn avx2(columns: &[&[f64]], out: &mut [f64]) {
            portable(columns, out);
        }
        |columns, out| match InstructionSet::detected() {
            InstructionSet::Baseline => portable(columns, out),
            // SAFETY: the processor has it.
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx2 => unsafe { avx2(columns, out) },
            // SAFETY: the processor has it.
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx512 => unsafe { avx512(columns, out) },
        }
    }};
}

/// Defines the functions of a kernel with these arguments, each in its typical range.
macro_rules! task {
    ($name:ident: $($argument:ident in $range:expr),*) => {
        Task {
            name: stringify!($name),
            ranges: &[$($range),*],
            functions: [
                one_at_a_time!(as_written::$name, $($argument)*),
                one_at_a_time!(by_hand::$name, $($argument)*),
                one_at_a_time!($name, $($argument)*),
                looped!(by_hand::$name, $($argument)*),
                |columns, out| {
                    let [$($argument),*] = array(columns);
                    $name::batch($($argument,)* out).expect("the columns have one length");
                },
            ],
        }
    };
}

/// Returns every task.
pub(crate) fn all() -> Vec<Task> {
    vec![
        task!(cone_sine: s in [0.0, 1.0], u in [0.0, 1.0]),
        task!(linear_sample: a in [0.1, 5.0], b in [0.1, 5.0], u in [0.0, 1.0]),
        task!(atmosphere: r in [6360.0, 6420.0], mu in [-0.1, 1.0], top in [6420.0, 6460.0]),
        task!(rotation_coefficient: t in [-3.0, 3.0]),
        task!(motion_coefficient: t in [-3.0, 3.0]),
        task!(angle_of_vectors: ax in SIDE, ay in SIDE, az in SIDE, bx in SIDE, by in SIDE, bz in SIDE),
        task!(softplus: x in [-20.0, 20.0]),
        task!(sum_of_logarithms: a in [-20.0, 20.0], b in [-20.0, 20.0]),
        task!(complement_of_logarithm: x in [0.0, 20.0]),
        task!(option_price: s in [80.0, 120.0], k in [80.0, 120.0], t in [0.1, 2.0], sigma in [0.1, 0.6]),
        task!(sphere_hit: ox in SIDE, oy in SIDE, oz in [-8.0, -4.0], dx in [-0.1, 0.1], dy in [-0.1, 0.1],
              dz in [0.5, 1.5], radius in [2.0, 3.0]),
        task!(fisheye: x in SIDE, y in SIDE, k in [-0.1, 0.1]),
        task!(distance: x1 in SIDE, y1 in SIDE, x2 in SIDE, y2 in SIDE),
        task!(logistic: x in [-20.0, 20.0]),
        task!(hyperbolic_tangent: x in [-3.0, 3.0]),
        task!(cube_roots: x in [0.0, 1000.0]),
        task!(versine: t in [-3.0, 3.0]),
    ]
}

/// Range of a coordinate.
const SIDE: [f64; 2] = [-1.0, 1.0];
