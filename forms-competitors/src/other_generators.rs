//! The same kernels emitted by other generators, written by `generate.py`.

/// Kernels as SymPy emits them.
#[cfg(has_sympy)]
#[allow(
    clippy::all,
    non_snake_case,
    unused_parens,
    unreachable_pub,
    missing_docs,
    reason = "another generator's style"
)]
pub(crate) mod by_sympy {
    include!(concat!(env!("OUT_DIR"), "/by_sympy.rs"));
}

/// Kernels as wrenfold emits them.
#[cfg(has_wrenfold)]
#[allow(
    clippy::all,
    non_snake_case,
    unused_parens,
    unreachable_pub,
    missing_docs,
    reason = "another generator's style"
)]
pub(crate) mod by_wrenfold {
    include!(concat!(env!("OUT_DIR"), "/by_wrenfold.rs"));
}

/// Returns the generators whose code is not part of this build, each as the tool and the reason.
pub fn missing() -> Vec<(&'static str, &'static str)> {
    let generators = [("SymPy 1.14", cfg!(has_sympy)), ("wrenfold 0.5", cfg!(has_wrenfold))];
    let why = "its kernels are written by `python3 forms-competitors/generate.py`";
    generators.into_iter().filter(|(_, is_there)| !is_there).map(|(tool, _)| (tool, why)).collect()
}
