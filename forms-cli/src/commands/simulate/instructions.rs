//! Choice of vector instructions: it applies to the kernels, and to the functions of the system
//! where the system allows a choice.
//!
//! ```text
//! --isa baseline ─┬─▶ kernels over rows
//!                 └─▶ GLIBC_TUNABLES, read at start: restarts the program ─▶ sin, exp, … without fused multiply-add
//! ```
//! On a processor with fused multiply-add, the GNU C library computes its functions with other
//! instructions, which round differently.

use forms::math::Instructions;

/// Setting that stops the functions of the GNU C library from using the instructions of this
/// processor.
#[cfg(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64"))]
const SETTING: [&str; 2] =
    ["GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable,-FMA4_Usable"];

/// Selects these instructions for all further computations. The error is a message with the reason.
pub(super) fn choose(instructions: Instructions) -> Result<(), String> {
    instructions.choose();
    #[cfg(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64"))]
    if instructions.name() == "baseline" {
        return without_fused_functions();
    }
    Ok(())
}

/// Restarts the program with the setting, unless it is already set.
#[cfg(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64"))]
fn without_fused_functions() -> Result<(), String> {
    use std::os::unix::process::CommandExt;
    let [name, setting] = SETTING;
    let before = std::env::var(name).unwrap_or_default();
    if before.split(':').any(|part| part == setting) {
        return Ok(());
    }
    let all = if before.is_empty() { setting.to_owned() } else { format!("{before}:{setting}") };
    let failed = |error: std::io::Error| {
        format!("cannot select the instructions of the system's math functions: {error}")
    };
    let program = std::env::current_exe().map_err(failed)?;
    Err(failed(std::process::Command::new(program).args(std::env::args_os().skip(1)).env(name, all).exec()))
}
