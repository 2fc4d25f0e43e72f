//! The competitors: what an expert writes by hand for each kernel, over slices of columns, with versions for AVX2 with
//! fused multiply-add and for AVX-512 that are chosen when the program runs, and one value at a time.
//!
//! ```text
//! vector ── elementary ──▶ one file a kernel: a formula of vectors ── batch! ──▶ scalar, batch_avx2, batch_avx512
//! ```
//! The patch is in the style of its own file, by vectorisation of the compiler.

pub(crate) mod batch;
mod elementary;
pub(crate) mod vector;

#[rustfmt::skip]
#[allow(unreachable_pub)]
#[cfg(target_arch = "x86_64")]
pub(crate) mod bilinear_expert;
pub(crate) mod double_area;
pub(crate) mod form_factor_point_rectangle;
pub(crate) mod ggx_visible_pdf;
pub(crate) mod henyey_greenstein;
pub(crate) mod solid_angle_triangle;
pub(crate) mod transmittance_with_emission;

/// The dot product.
#[inline(always)]
fn dot<V: vector::Vector>(a: [V; 3], b: [V; 3]) -> V {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

/// The cross product.
#[inline(always)]
fn cross<V: vector::Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [
        a[1].mul_add(b[2], -(a[2] * b[1])),
        a[2].mul_add(b[0], -(a[0] * b[2])),
        a[0].mul_add(b[1], -(a[1] * b[0])),
    ]
}

/// a − b
#[inline(always)]
fn difference<V: vector::Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// A function over fourteen columns.
type OverPatches = fn(&[&[f64]; 14], &mut [f64]);

/// The patch with that instruction set, if its file has a version for it.
pub(crate) fn patch(set: batch::InstructionSet) -> Option<OverPatches> {
    assert!(set <= batch::InstructionSet::detected());
    match set {
        batch::InstructionSet::Baseline => None,
        // SAFETY: the processor has it, and the file's slices are as long as `out` or it panics.
        #[cfg(target_arch = "x86_64")]
        batch::InstructionSet::Avx2 => {
            Some(|columns, out| unsafe { bilinear_expert::batch_avx2(columns, out) })
        }
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        batch::InstructionSet::Avx512 => {
            Some(|columns, out| unsafe { bilinear_expert::batch_avx512(columns, out) })
        }
    }
}
