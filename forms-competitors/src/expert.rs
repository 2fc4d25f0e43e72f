//! The competitors: hand-written expert code for each kernel, over slices of columns. There are
//! versions for AVX2 with fused multiply-add and for AVX-512, selected at run time, and a version
//! for one value at a time.
//!
//! ```text
//! vector, elementary ─▶ the vector formula of a kernel ─ batch! ─▶ f64, batch_avx2, batch_avx512
//! ```
//! The patch has the style of its own file, which relies on the compiler's vectorisation.

pub mod batch;
pub mod vector;

#[rustfmt::skip]
#[allow(unreachable_pub, reason = "the file keeps the style of its author")]
#[cfg(target_arch = "x86_64")]
pub mod bilinear_expert;
pub mod double_area;
pub mod form_factor_point_rectangle;
pub mod ggx_visible_pdf;
pub mod henyey_greenstein;
pub mod solid_angle_triangle;
pub mod transmittance_with_emission;

/// Returns the dot product.
#[inline(always)]
fn dot<V: vector::Vector>(a: [V; 3], b: [V; 3]) -> V {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

/// Returns the cross product.
#[inline(always)]
fn cross<V: vector::Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [
        a[1].mul_add(b[2], -(a[2] * b[1])),
        a[2].mul_add(b[0], -(a[0] * b[2])),
        a[0].mul_add(b[1], -(a[1] * b[0])),
    ]
}

/// Returns a − b.
#[inline(always)]
fn difference<V: vector::Vector>(a: [V; 3], b: [V; 3]) -> [V; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// Function over fourteen columns.
type OverPatches = fn(&[&[f64]; 14], &mut [f64]);

/// Returns the patch with that instruction set, if its file has a version for it.
pub fn patch(set: batch::InstructionSet) -> Option<OverPatches> {
    assert!(set <= batch::InstructionSet::detected());
    match set {
        batch::InstructionSet::Baseline => None,
        // SAFETY: the processor has the instruction set; the file's function panics if a slice is
        // shorter than `out`.
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
