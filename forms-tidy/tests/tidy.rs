//! The rules of the repository, each with its exceptions and their reasons.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use forms_tidy::cycles::{cycles_below, edges};
use forms_tidy::modules::Modules;
use forms_tidy::prose::{comments, flagged, sentences};
use forms_tidy::sizes::{functions, long_lines};
use forms_tidy::surface::public_items;
use forms_tidy::workspace::{Package, files, packages, root, shown};

/// Largest number of lines of a file, and of a function.
const LINES_OF_FILE: usize = 400;
const LINES_OF_FUNCTION: usize = 60;
/// Largest number of columns of a line.
const COLUMNS: usize = 120;
/// Largest share of comments and sentences with a phrase to reword.
const FLAGGED: f64 = 0.02;

/// Folder whose functions are tables of scenes and of their known answers.
const TABLES_OF_SCENES: &str = "forms-radiometry-testing/src/claims/";

/// Files in which long lines stand for themselves.
const WIDE_FILES: [(&str, &str); 7] = [
    ("forms-core/src/expression/operation.rs", "the table of operations"),
    ("forms-core/src/expression/partials.rs", "the pattern of a line of that table"),
    ("forms-math/src/composed.rs", "a table of functions"),
    ("forms-math/tests/special.rs", "a table of values"),
    ("forms-competitors/src/catalogue.rs", "a table of kernels"),
    ("forms-core/tests/kernel/targets/", "output of the emitter"),
    ("forms-math/src/lane/coefficients.rs", "written by another program"),
];

/// Crates with fewer public items than a number. Methods do not count.
const SURFACES: [(&str, usize); 1] = [("forms-core", 200)];

/// Crates of the workspace that a crate may depend on. The program depends on all of them.
const LAYERS: [(&str, &[&str]); 16] = [
    ("forms-math", &[]),
    ("forms-core", &["forms-math"]),
    ("forms-check", &[]),
    ("forms-macros", &["forms-core", "forms-math"]),
    ("forms", &["forms-math", "forms-core", "forms-macros"]),
    ("forms-kernels", &["forms"]),
    ("forms-radiometry", &["forms", "forms-kernels"]),
    ("forms-book", &["forms", "forms-core"]),
    ("forms-serve", &["forms", "forms-core", "forms-book", "forms-radiometry"]),
    ("forms-figures", &[]),
    ("forms-testing", &[]),
    ("forms-core-testing", &["forms-core"]),
    ("forms-radiometry-testing", &["forms-kernels", "forms-radiometry", "forms-testing"]),
    ("forms-competitors", &["forms", "forms-testing"]),
    ("forms-tidy", &[]),
    ("forms-notebooks", &["forms", "forms-core", "forms-kernels", "forms-radiometry", "forms-book"]),
];

/// Returns the Rust files in some folders of the packages, with their texts.
fn sources(folders: &[&str]) -> Vec<(String, String)> {
    let root = root();
    let of_package = |package: &Package| {
        let in_folder = |part: &&str| files(&package.folder.join(part), "rs");
        folders.iter().flat_map(in_folder).collect::<Vec<_>>()
    };
    let read = |path: PathBuf| {
        let text = fs::read_to_string(&path).expect("sources are readable");
        (shown(&path, &root), text)
    };
    packages(&root).iter().flat_map(of_package).map(read).collect()
}

fn everywhere() -> Vec<(String, String)> {
    sources(&["src", "tests", "benches", "examples"])
}

#[test]
fn modules_of_the_top_two_levels_have_no_cycles_of_imports() {
    let mut found = Vec::new();
    for package in packages(&root()) {
        let modules = Modules::read(&package.folder.join("src"));
        let edges = edges(&modules);
        for parent in modules.0.keys().filter(|path| path.len() <= 1) {
            let place = format!("{} {}", package.name, parent.join("::"));
            found.extend(cycles_below(&edges, parent).into_iter().map(|cycle| format!("{place}: {cycle}")));
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn crates_depend_on_the_layers_below_them() {
    let allowed: BTreeMap<&str, &[&str]> = LAYERS.into_iter().collect();
    let names: BTreeSet<String> = packages(&root()).into_iter().map(|package| package.name).collect();
    for package in packages(&root()) {
        let manifest = fs::read_to_string(package.folder.join("Cargo.toml")).expect("a manifest");
        let section = manifest.split("\n[dependencies]").nth(1).unwrap_or_default();
        let section = section.split("\n[").next().unwrap_or_default();
        let own = section.lines().filter_map(|line| line.split(['.', ' ', '=']).next());
        for dependency in own.filter(|name| names.contains(*name)) {
            let may = package.name == "forms-cli" || allowed[package.name.as_str()].contains(&dependency);
            assert!(may, "{} depends on {dependency}", package.name);
        }
    }
}

#[test]
fn a_file_is_short() {
    let long = everywhere().into_iter().filter(|(_, text)| text.lines().count() > LINES_OF_FILE);
    let found: Vec<String> = long.map(|(path, _)| path).collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_function_is_short() {
    let long = |(path, text): (String, String)| {
        let long = functions(&text).into_iter().filter(|function| function.lines > LINES_OF_FUNCTION);
        long.map(move |function| format!("{path}: {}", function.name)).collect::<Vec<_>>()
    };
    let is_table = |path: &str| path.starts_with(TABLES_OF_SCENES);
    let of_files = sources(&["src"]).into_iter().filter(|(path, _)| !is_table(path));
    let found: Vec<String> = of_files.flat_map(long).collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_line_is_short() {
    let is_wide = |path: &str| WIDE_FILES.iter().any(|(wide, _)| path.starts_with(wide));
    let of_file = |(path, text): (String, String)| {
        let lines = if is_wide(&path) { Vec::new() } else { long_lines(&text, COLUMNS) };
        lines.into_iter().map(move |line| format!("{path}:{line}")).collect::<Vec<_>>()
    };
    let found: Vec<String> = everywhere().into_iter().flat_map(of_file).collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn a_module_is_a_file_beside_its_folder() {
    let found: Vec<String> = sources(&["src"]).into_iter().map(|(path, _)| path).collect();
    let found: Vec<&String> = found.iter().filter(|path| path.ends_with("/mod.rs")).collect();
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn the_public_surface_of_a_crate_is_small() {
    let limits: BTreeMap<&str, usize> = SURFACES.into_iter().collect();
    let mut large = Vec::new();
    for package in packages(&root()).iter().filter(|package| package.folder.join("src/lib.rs").exists()) {
        let items = public_items(&package.folder.join("src"));
        println!("{:18} {:4} public items", package.name, items.len());
        if limits.get(package.name.as_str()).is_some_and(|limit| items.len() >= *limit) {
            large.push(format!("{}: {} public items: {items:?}", package.name, items.len()));
        }
    }
    assert!(large.is_empty(), "{large:#?}");
}

#[test]
fn helpers_of_tests_are_crates_and_not_files_of_other_targets() {
    let is_inclusion = |line: &str| {
        let line = line.trim_start();
        let is_path = line.starts_with("#[") && line.contains("path = \"");
        is_path || (line.contains("include!(\"") && line.contains("../"))
    };
    let names_a_path = |text: &str| text.lines().any(is_inclusion);
    let found = everywhere().into_iter().filter(|(_, text)| names_a_path(text)).map(|(path, _)| path);
    assert_eq!(found.collect::<Vec<_>>(), Vec::<String>::new());
}

#[test]
fn the_code_map_names_every_top_level_module() {
    let root = root();
    let page = fs::read_to_string(root.join("docs/architecture.md")).expect("the code map");
    let names: BTreeSet<&str> = page.split('`').skip(1).step_by(2).collect();
    let mut missing = Vec::new();
    for package in packages(&root) {
        let src = package.folder.join("src");
        let top = files(&src, "rs").into_iter().filter(|path| path.parent() == Some(src.as_path()));
        let top = top.filter_map(|path| Some(path.file_stem()?.to_string_lossy().into_owned()));
        let unnamed =
            top.filter(|name| !["lib", "main"].contains(&name.as_str()) && !names.contains(name.as_str()));
        missing.extend(unnamed.map(|name| format!("{} {name}", package.name)));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn pages_name_files_that_exist() {
    let root = root();
    let folders = packages(&root)
        .into_iter()
        .flat_map(|package| ["", "src", "tests"].map(|part| package.folder.join(part)));
    let folders: Vec<PathBuf> = folders.collect();
    let is_missing = |name: &&str| {
        name.ends_with(".rs")
            && !name.contains(' ')
            && !folders.iter().any(|folder| folder.join(name).exists())
    };
    let mut missing = Vec::new();
    let others = ["README.md", "CONTRIBUTING.md"].map(|name| root.join(name));
    for page in files(&root.join("docs"), "md").into_iter().chain(others) {
        let text = fs::read_to_string(&page).expect("pages are readable");
        let names: BTreeSet<&str> = text.split('`').skip(1).step_by(2).collect();
        let place = shown(&page, &root);
        missing.extend(names.iter().filter(|name| is_missing(name)).map(|name| format!("{place}: {name}")));
    }
    assert!(missing.is_empty(), "{missing:#?}");
}

#[test]
fn comments_use_the_words_of_the_field() {
    let of_file = |(path, text): &(String, String)| {
        let place = |line| format!("{path}:{line}");
        comments(text).into_iter().map(|comment| (place(comment.line), comment.text)).collect::<Vec<_>>()
    };
    let all: Vec<(String, String)> = sources(&["src"]).iter().flat_map(of_file).collect();
    assert_few_are_flagged(&all);
}

#[test]
fn pages_use_the_words_of_the_field() {
    let root = root();
    let read = |path: PathBuf| {
        let page = fs::read_to_string(&path).expect("pages are readable");
        let path = shown(&path, &root);
        sentences(&page).into_iter().map(|sentence| (path.clone(), sentence.text)).collect::<Vec<_>>()
    };
    let all: Vec<(String, String)> = files(&root, "md").into_iter().flat_map(read).collect();
    assert_few_are_flagged(&all);
}

fn assert_few_are_flagged(passages: &[(String, String)]) {
    let hit = |(place, text): &(String, String)| Some(format!("{place}: “{}”  {text}", flagged(text)?));
    let found: Vec<String> = passages.iter().filter_map(hit).collect();
    let share = found.len() as f64 / passages.len() as f64;
    assert!(share < FLAGGED, "{} of {}: {found:#?}", found.len(), passages.len());
}
