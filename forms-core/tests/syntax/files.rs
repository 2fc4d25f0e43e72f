//! The case files of the workspace.

use forms_core::syntax::{Source, read};
use std::path::Path;

/// Where the workspace keeps `.forms` files.
const FOLDERS: &[&str] = &["../tests/cases", "../forms-radiometry/theory", "../forms-radiometry/kernels"];

/// The text of every `.forms` file of the workspace.
pub(crate) fn sources() -> Vec<Source> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources: Vec<Source> = FOLDERS
        .iter()
        .flat_map(|folder| {
            std::fs::read_dir(workspace.join(folder)).expect("the workspace has its case files")
        })
        .map(|entry| entry.expect("the folder can be read").path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "forms"))
        .map(|path| {
            let text = std::fs::read_to_string(&path).expect("case files are UTF-8");
            Source::new(path.file_name().expect("it has a name").to_string_lossy(), text)
        })
        .collect();
    sources.sort_by(|a, b| a.name.cmp(&b.name));
    sources
}

#[test]
fn every_case_file_parses_into_one_item_for_each_semicolon() {
    let sources = sources();
    assert!(sources.len() >= 20, "only {} case files", sources.len());
    for source in sources {
        let (file, diagnostics) = read(&source.text);
        let shown: String = diagnostics.iter().map(|diagnostic| source.render(diagnostic)).collect();
        assert_eq!(shown, "", "{}", source.name);
        let code = source.text.lines().filter(|line| !line.starts_with("//"));
        let semicolons: usize = code.map(|line| line.matches(';').count()).sum();
        assert_eq!(file.items.len(), semicolons, "{}", source.name);
    }
}
