//! Texts of the repository that can contain kernels.

use std::fs;
use std::path::Path;

/// Folders without sources of the repository.
const OTHER: [&str; 3] = ["target", ".git", "node_modules"];

/// Returns the texts of all theory files and of all theory blocks in pages.
pub(crate) fn all() -> Vec<String> {
    let mut texts = Vec::new();
    collect(Path::new(env!("CARGO_MANIFEST_DIR")), &mut texts);
    texts
}

fn collect(folder: &Path, texts: &mut Vec<String>) {
    let entries = fs::read_dir(folder).expect("a folder of the repository");
    let mut paths: Vec<_> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        let kind = path.extension().and_then(|kind| kind.to_str()).unwrap_or_default();
        if path.is_dir() && !OTHER.contains(&name) {
            collect(&path, texts);
        } else if kind == "forms" {
            texts.push(fs::read_to_string(&path).expect("a text"));
        } else if kind == "md" {
            texts.extend(blocks(&fs::read_to_string(&path).expect("a text")));
        }
    }
}

/// Returns the theories of a page.
fn blocks(page: &str) -> Vec<String> {
    let is_theory = |block: &&str| block.starts_with("forms\n") || block.starts_with("forms,continued\n");
    let blocks = page.split("```").skip(1).step_by(2).filter(is_theory);
    blocks.filter_map(|block| Some(block.split_once('\n')?.1.to_string())).collect()
}
