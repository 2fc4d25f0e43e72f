//! Copies the kernels that `generate.py` has written, or empty modules in their place.

use std::path::Path;
use std::{env, fs, io};

/// Names of the generators' files, each with the configuration that says whether it exists.
const FILES: [(&str, &str); 2] = [("by_sympy.rs", "has_sympy"), ("by_wrenfold.rs", "has_wrenfold")];

fn main() -> io::Result<()> {
    let written = Path::new(&env::var("CARGO_MANIFEST_DIR").expect("Cargo sets it")).join("generated");
    let out = env::var("OUT_DIR").expect("Cargo sets it");
    // all of this folder: a folder that is not there would count as changed each time
    println!("cargo::rerun-if-changed=.");
    for (name, configuration) in FILES {
        println!("cargo::rustc-check-cfg=cfg({configuration})");
        let file = written.join(name);
        let text = if file.exists() { fs::read_to_string(file)? } else { String::new() };
        if !text.is_empty() {
            println!("cargo::rustc-cfg={configuration}");
        }
        fs::write(Path::new(&out).join(name), text)?;
    }
    Ok(())
}
