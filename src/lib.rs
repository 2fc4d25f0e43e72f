//! Forms: exterior calculus that proves identities exactly and turns them into numeric kernels.

pub use forms_core as core;
