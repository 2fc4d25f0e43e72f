//! Instructions: what was chosen is taken by the kernels, and by the functions of the system as far as these let it be chosen.
//!
//! ```text
//! --isa baseline ─┬─▶ kernels over rows
//!                 └─▶ GLIBC_TUNABLES, read when a program begins: this one begins again ─▶ sin, exp, … without fused multiply-add
//! ```
//! The GNU C library computes its functions by other instructions where the processor has fused multiply-add, which rounds otherwise.

use forms::math::Instructions;

/// The setting without which the functions of the GNU C library use what the processor has.
#[cfg(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64"))]
const SETTING: [&str; 2] =
    ["GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable,-FMA4_Usable"];

/// Computes with these instructions from now on. The message says why that is not possible.
pub(super) fn choose(instructions: Instructions) -> Result<(), String> {
    instructions.choose();
    #[cfg(all(target_os = "linux", target_env = "gnu", target_arch = "x86_64"))]
    if instructions.name() == "baseline" {
        return without_fused_functions();
    }
    Ok(())
}

/// Begins the program again with the setting, unless it has it.
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
        format!("the instructions of the system's functions cannot be chosen: {error}")
    };
    let program = std::env::current_exe().map_err(failed)?;
    Err(failed(std::process::Command::new(program).args(std::env::args_os().skip(1)).env(name, all).exec()))
}
