//! Embeds the sources of the book: its pages and the files that they link to.
//!
//! ```text
//! docs/**.md, docs/**.svg · theories, kernels · scenes and their pictures ─▶ a list of (path, bytes) in $OUT_DIR/sources.rs
//! ```

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Folders below the root, with the extensions of the files to embed from each.
const FOLDERS: [(&str, &[&str]); 5] = [
    ("docs", &["md", "svg", "png"]),
    ("docs/book/scenes", &["toml"]),
    ("forms-kernels/theory", &["forms"]),
    ("forms-kernels/kernels", &["forms"]),
    ("scenes", &["md", "toml", "svg", "png"]),
];

fn main() -> io::Result<()> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").canonicalize()?;
    let mut list = String::from("&[\n");
    for (folder, endings) in FOLDERS {
        let mut files = Vec::new();
        collect(&root.join(folder), endings, &mut files)?;
        files.sort();
        for file in files {
            let name =
                file.strip_prefix(&root).map_err(io::Error::other)?.to_string_lossy().replace('\\', "/");
            list.push_str(&format!("    ({name:?}, include_bytes!({:?})),\n", file.to_string_lossy()));
        }
    }
    list.push_str("]\n");
    let out = std::env::var_os("OUT_DIR").map(PathBuf::from).ok_or_else(|| io::Error::other("no OUT_DIR"))?;
    fs::write(out.join("sources.rs"), list)
}

fn collect(folder: &Path, endings: &[&str], files: &mut Vec<PathBuf>) -> io::Result<()> {
    println!("cargo:rerun-if-changed={}", folder.display());
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, endings, files)?;
        } else if path.extension().is_some_and(|ending| endings.iter().any(|known| ending == *known)) {
            files.push(path);
        }
    }
    Ok(())
}
