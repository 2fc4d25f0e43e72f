//! Choice of the vector instructions of batches, with the functions that are compiled for them and
//! are unsafe to call elsewhere.

use super::block::{Arguments, Kernel, Values, rows_of};
use super::method::{Element, Method};
use std::sync::OnceLock;

/// Instructions chosen for this program.
static CHOSEN: OnceLock<Instructions> = OnceLock::new();

/// Vector instructions supported by this processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions(Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Set {
    /// Instructions of every processor of the architecture: SSE2, or NEON with fused multiply-add.
    Baseline,
    /// 256-bit vectors and fused multiply-add.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// 512-bit vectors.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Instructions {
    /// Returns the [chosen](Self::choose) instructions, or else the fastest ones.
    pub fn best() -> Self {
        CHOSEN.get().copied().unwrap_or_else(Self::fastest)
    }

    /// Selects these instructions for the rest of the program, so that its batches have the same
    /// bits on all processors that support them; returns whether no others were chosen before.
    pub fn choose(self) -> bool {
        *CHOSEN.get_or_init(|| self) == self
    }

    fn fastest() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if Set::Avx512.is_available() {
                return Self(Set::Avx512);
            }
            if Set::Avx2.is_available() {
                return Self(Set::Avx2);
            }
        }
        Self(Set::Baseline)
    }

    /// Returns all available instructions, the slowest first.
    pub fn available() -> Vec<Self> {
        #[cfg(target_arch = "x86_64")]
        let sets = [Set::Baseline, Set::Avx2, Set::Avx512];
        #[cfg(not(target_arch = "x86_64"))]
        let sets = [Set::Baseline];
        sets.into_iter().filter(|set| set.is_available()).map(Self).collect()
    }

    /// Returns the name.
    pub fn name(self) -> &'static str {
        match self.0 {
            Set::Baseline if cfg!(target_arch = "aarch64") => "NEON",
            Set::Baseline => "baseline",
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => "AVX2",
            #[cfg(target_arch = "x86_64")]
            Set::Avx512 => "AVX-512",
        }
    }

    /// Returns the loop over a block, compiled for these instructions.
    pub(super) fn kernel<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
        self,
    ) -> Kernel<M, E, A, O> {
        match self.0 {
            Set::Baseline => baseline::<M, E, A, O>,
            #[cfg(target_arch = "x86_64")]
            Set::Avx2 => avx2::<M, E, A, O>,
            #[cfg(target_arch = "x86_64")]
            Set::Avx512 => avx512::<M, E, A, O>,
        }
    }
}

impl Set {
    fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma"),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                Self::Avx2.is_available()
                    && is_x86_feature_detected!("avx512f")
                    && is_x86_feature_detected!("avx512dq")
                    && is_x86_feature_detected!("avx512vl")
            }
        }
    }
}

fn baseline<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    // NEON has fused multiply-add; on other processors it can be missing, and would be a function
    // call.
    #[cfg(target_arch = "aarch64")]
    return rows_of::<M, E, true, A, O>(method, columns, rows, values);
    #[cfg(not(target_arch = "aarch64"))]
    rows_of::<M, E, false, A, O>(method, columns, rows, values)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
fn avx2<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    rows_of::<M, E, true, A, O>(method, columns, rows, values)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,fma")]
fn avx512<M: Method<E, A, O>, E: Element, const A: usize, const O: usize>(
    method: M,
    columns: &Arguments<'_, E, A>,
    rows: usize,
    values: &mut Values<E, O>,
) -> bool {
    rows_of::<M, E, true, A, O>(method, columns, rows, values)
}
