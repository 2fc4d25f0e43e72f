//! Dense products four at a time, if every number fits in 32 bits and the processor has AVX2.
//!
//! ```text
//! block[place(a) + place(b) ..] += a · b₀ b₁ b₂ b₃ │ b₄ … b₁₅        one vector multiplication for four products
//! ```
//! A 64-bit product takes several vector multiplications; a product of two 32-bit numbers takes
//! one. The values b of a run are padded with zeros to whole vectors. The terms a are processed in
//! an order in which the targets of neighbours are whole vectors apart, since a vector that was
//! written in part by each of two others is slow to read back. f(f+1) with f = (1+x+y+z+t)¹⁵ takes
//! half the instructions of single products.

use super::dense::Image;
use crate::polynomial::coefficient::Coefficient;
use std::ops::Range;

/// Number of values in a vector.
const LANES: usize = 4;
/// Largest number of values of a run: four vectors stay in registers.
pub(super) const LONGEST: usize = 4 * LANES;
/// Least mean length of runs for which partly filled vectors are worth their cost.
const MEAN: usize = 2;

/// Terms by their places in a block; neighbours are whole vectors apart, and whole runs apart where
/// possible.
pub(super) struct Scattered {
    terms: Vec<(u32, i32)>,
}

/// Runs padded to whole vectors.
pub(super) struct Padded {
    /// Place of the first value, place in `values`, number of vectors.
    runs: Vec<(usize, usize, usize)>,
    values: Vec<i64>,
}

impl Scattered {
    /// Returns the terms of an image, group by group; `None` if a number or a place is beyond 32
    /// bits.
    pub(super) fn of<C: Coefficient>(image: &Image<C>) -> Option<Scattered> {
        let numbers = C::words(&image.numbers)?;
        let mut terms = Vec::with_capacity(numbers.len());
        for group in &image.groups {
            for run in &image.runs[group.runs.clone()] {
                for (offset, &number) in numbers[run.start..run.end].iter().enumerate() {
                    let place = u32::try_from(run.low + offset).ok()?;
                    terms.push((place, i32::try_from(number).ok()?));
                }
            }
            let apart = |place: u32| (place % LANES as u32, place % LONGEST as u32, place);
            terms[group.terms.clone()].sort_unstable_by_key(|&(place, _)| apart(place));
        }
        Some(Scattered { terms })
    }
}

impl Padded {
    /// Returns the runs of an image, which are no longer than [`LONGEST`]; `None` if a number is
    /// beyond 32 bits or most runs are too short.
    pub(super) fn of<C: Coefficient>(image: &Image<C>) -> Option<Padded> {
        let numbers = C::words(&image.numbers)?;
        if numbers.iter().any(|&number| i32::try_from(number).is_err())
            || numbers.len() < MEAN * image.runs.len()
        {
            return None;
        }
        let mut padded = Padded { runs: Vec::with_capacity(image.runs.len()), values: Vec::new() };
        for run in &image.runs {
            let start = padded.values.len();
            padded.values.extend_from_slice(&numbers[run.start..run.end]);
            let vectors = (run.end - run.start).div_ceil(LANES);
            padded.values.resize(start + vectors * LANES, 0);
            padded.runs.push((run.low, start, vectors));
        }
        Some(padded)
    }
}

/// Whether the processor supports the vector multiplication.
pub(super) fn available() -> bool {
    #[cfg(target_arch = "x86_64")]
    return std::arch::is_x86_feature_detected!("avx2");
    #[cfg(not(target_arch = "x86_64"))]
    false
}

/// Adds the products of some terms and some runs to a block that has room for a run beyond its
/// places.
///
/// # Panics
/// If the vector multiplication is not [`available`].
pub(super) fn add(block: &mut [i64], left: (&Scattered, Range<usize>), right: (&Padded, Range<usize>)) {
    assert!(available(), "there is no other way here to multiply vectors");
    let terms = &left.0.terms[left.1];
    let (runs, values) = (&right.0.runs[right.1], &right.0.values[..]);
    #[cfg(target_arch = "x86_64")]
    // SAFETY: the processor has AVX2, as the assertion has verified; the call has no other
    // precondition.
    unsafe {
        avx2::add_runs(block, terms, runs, values);
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (block, terms, runs, values);
}

#[cfg(target_arch = "x86_64")]
mod avx2 {
    use super::LANES;
    use std::arch::x86_64::{
        __m256i, _mm256_add_epi64, _mm256_loadu_si256, _mm256_mul_epi32, _mm256_set1_epi32,
        _mm256_setzero_si256, _mm256_storeu_si256,
    };

    /// Adds the product of every run (place, place in `values`, vectors) and every term (place,
    /// number).
    #[target_feature(enable = "avx2")]
    pub(super) fn add_runs(
        block: &mut [i64],
        terms: &[(u32, i32)],
        runs: &[(usize, usize, usize)],
        values: &[i64],
    ) {
        for &(low, start, vectors) in runs {
            let (target, values) = (&mut block[low..], &values[start..]);
            match vectors {
                1 => add_run::<1>(target, terms, values),
                2 => add_run::<2>(target, terms, values),
                3 => add_run::<3>(target, terms, values),
                _ => add_run::<4>(target, terms, values),
            }
        }
    }

    /// target[place + k] += a·b[k] for the values b of N vectors.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn add_run<const N: usize>(target: &mut [i64], terms: &[(u32, i32)], values: &[i64]) {
        let mut vectors = [_mm256_setzero_si256(); N];
        let values: &[_; N] = values.as_chunks().0.first_chunk().expect("runs are padded");
        for (vector, values) in vectors.iter_mut().zip(values) {
            *vector = load(values);
        }
        for &(place, number) in terms {
            let number = _mm256_set1_epi32(number);
            let place = place as usize;
            let sums = target[place..place + N * LANES].as_chunks_mut().0;
            for (sum, &vector) in sums.iter_mut().zip(&vectors) {
                // the product of the lower halves of the lanes
                let product = _mm256_mul_epi32(number, vector);
                store(sum, _mm256_add_epi64(load(sum), product));
            }
        }
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn load(numbers: &[i64; LANES]) -> __m256i {
        // SAFETY: four 64-bit numbers are the 256 bits read, and the load requires no alignment.
        unsafe { _mm256_loadu_si256(numbers.as_ptr().cast()) }
    }

    #[target_feature(enable = "avx2")]
    #[inline]
    fn store(numbers: &mut [i64; LANES], vector: __m256i) {
        // SAFETY: four 64-bit numbers are the 256 bits written, and the store requires no
        // alignment.
        unsafe { _mm256_storeu_si256(numbers.as_mut_ptr().cast(), vector) }
    }
}
