//! NVRTC, the compiler of CUDA that needs neither headers nor a GPU, through `nvrtc.py`.

use std::path::Path;
use std::process::Command;

/// Exit status of the script if there is no NVRTC.
const MISSING: i32 = 77;

/// Compiles a file of CUDA and panics if NVRTC rejects it. Without Python or NVRTC the test is
/// reported as skipped; the environment variable `FORMS_PYTHON` names another Python.
#[track_caller]
pub fn accepted_by_nvrtc(test: &str, file: &Path) {
    let python = std::env::var("FORMS_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("nvrtc.py");
    match Command::new(&python).arg(script).arg(file).output() {
        Ok(run) if run.status.success() => {}
        Ok(run) if run.status.code() == Some(MISSING) => {
            super::skipped(test, "NVRTC", &String::from_utf8_lossy(&run.stderr));
        }
        Ok(run) => panic!(
            "{}: {}{}",
            file.display(),
            String::from_utf8_lossy(&run.stdout),
            String::from_utf8_lossy(&run.stderr)
        ),
        Err(error) => super::skipped(test, "NVRTC", &format!("{python} does not run: {error}")),
    }
}
