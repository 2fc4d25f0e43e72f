//! Turns a formula of vectors into functions over slices, and selects one of them at run time.

/// Instruction sets of processors, in increasing order.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum InstructionSet {
    /// The instruction set of every processor this is compiled for.
    Baseline,
    /// AVX2 and fused multiply-add.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// AVX-512: the foundation and its companion extensions.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl InstructionSet {
    /// Returns the instruction sets of this processor.
    pub fn all() -> &'static [Self] {
        #[cfg(target_arch = "x86_64")]
        {
            let fused = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
            let wide = is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
            if fused && wide && is_x86_feature_detected!("avx512vl") {
                return &[Self::Baseline, Self::Avx2, Self::Avx512];
            }
            if fused {
                return &[Self::Baseline, Self::Avx2];
            }
        }
        &[Self::Baseline]
    }

    /// Returns its usual name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline instructions",
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => "AVX2 and FMA",
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => "AVX-512",
        }
    }

    /// Returns the largest instruction set of this processor.
    pub fn detected() -> Self {
        Self::all().last().copied().unwrap_or(Self::Baseline)
    }
}

/// Defines the functions over columns of a formula of that many arguments, `fn value<V:
/// Vector>(arguments: [V; N]) -> V`: one for each instruction set, and one that takes the
/// instruction set as an argument.
#[macro_export]
macro_rules! batch {
    ($module:ident, $arguments:literal, $value:path) => {
        /// The formula over columns.
        pub mod $module {
            use $crate::expert::batch::InstructionSet;
            use $crate::expert::vector::Vector;

            /// The columns have as many values as `out`.
            #[inline(always)]
            fn over<V: Vector>(columns: &[&[f64]; $arguments], out: &mut [f64]) {
                let count = out.len();
                assert!(columns.iter().all(|column| column.len() == count));
                let whole = count - count % V::LANES;
                for start in (0..whole).step_by(V::LANES) {
                    // SAFETY: start + LANES ≤ count, the length of each column and of `out`.
                    unsafe {
                        let value = $value(std::array::from_fn(|i| V::load(columns[i].as_ptr().add(start))));
                        value.store(out.as_mut_ptr().add(start));
                    }
                }
                if whole == count {
                    return;
                }
                let mut rest = [[1.0; 8]; $arguments];
                for (rest, column) in rest.iter_mut().zip(columns) {
                    rest[..count - whole].copy_from_slice(&column[whole..]);
                }
                let mut values = [0.0; 8];
                // SAFETY: no vector has more than eight lanes.
                unsafe {
                    $value(std::array::from_fn(|i| V::load(rest[i].as_ptr()))).store(values.as_mut_ptr())
                };
                out[whole..].copy_from_slice(&values[..count - whole]);
            }

            /// # Safety
            /// The processor must have AVX2 and fused multiply-add.
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx2,fma")]
            pub unsafe fn batch_avx2(columns: &[&[f64]; $arguments], out: &mut [f64]) {
                over::<$crate::expert::vector::F64x4>(columns, out);
            }

            /// # Safety
            /// The processor must have AVX-512.
            #[cfg(target_arch = "x86_64")]
            #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
            pub unsafe fn batch_avx512(columns: &[&[f64]; $arguments], out: &mut [f64]) {
                over::<$crate::expert::vector::F64x8>(columns, out);
            }

            /// Evaluates the columns with the registers of that instruction set, which the
            /// processor must have.
            pub fn with(set: InstructionSet, columns: &[&[f64]; $arguments], out: &mut [f64]) {
                assert!(set <= InstructionSet::detected());
                match set {
                    InstructionSet::Baseline => over::<f64>(columns, out),
                    // SAFETY: the processor has it.
                    #[cfg(target_arch = "x86_64")]
                    InstructionSet::Avx2 => unsafe { batch_avx2(columns, out) },
                    // SAFETY: the processor has it.
                    #[cfg(target_arch = "x86_64")]
                    InstructionSet::Avx512 => unsafe { batch_avx512(columns, out) },
                }
            }
        }
    };
}
pub use batch;
