//! Choice of the instructions of lanes.

use alloc::vec::Vec;
#[cfg(feature = "std")]
use std::sync::OnceLock;

#[cfg(not(feature = "std"))]
use crate::once_lock::OnceLock;

/// Instructions chosen for this program.
static CHOSEN: OnceLock<Instructions> = OnceLock::new();

/// Vector instructions supported by this processor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instructions(pub(crate) Set);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd)]
pub(crate) enum Set {
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

    /// Whether chosen instructions, or else those of the processor, contain a fused multiply-add.
    #[inline]
    pub(crate) fn best_are_fused() -> bool {
        CHOSEN.get().map_or_else(|| Set::FUSED.is_available(), |chosen| chosen.0 >= Set::FUSED)
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
}

impl Set {
    /// The smallest set with fused multiply-add.
    #[cfg(target_arch = "x86_64")]
    const FUSED: Self = Self::Avx2;
    #[cfg(not(target_arch = "x86_64"))]
    const FUSED: Self = Self::Baseline;

    /// Whether the processor has the instructions.
    #[cfg(feature = "std")]
    fn is_available(self) -> bool {
        #[cfg(target_arch = "x86_64")]
        use std::is_x86_feature_detected;
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

    /// Whether the program is compiled for processors with the instructions: without the standard
    /// library, nothing is known about the processor at run time.
    #[cfg(not(feature = "std"))]
    fn is_available(self) -> bool {
        match self {
            Self::Baseline => true,
            #[cfg(target_arch = "x86_64")]
            Self::Avx2 => cfg!(all(target_feature = "avx2", target_feature = "fma")),
            #[cfg(target_arch = "x86_64")]
            Self::Avx512 => {
                Self::Avx2.is_available()
                    && cfg!(all(
                        target_feature = "avx512f",
                        target_feature = "avx512dq",
                        target_feature = "avx512vl"
                    ))
            }
        }
    }
}
