//! Runs every statement of the theory as its own test, and checks the page that lists the files
//! against their content.

use forms::core::check::read_theory;
use forms::core::syntax::ast::Claim;
use std::collections::BTreeSet;
use std::path::Path;

macro_rules! theory_files {
    ($($name:ident $path:literal;)*) => {
        $(mod $name {
            forms::proof_tests!($path);
        })*

        const PROVED: &[&str] = &[$($path),*];
    };
}

theory_files! {
    bsdf "theory/bsdf.forms";
    density_transport "theory/density_transport.forms";
    etendue "theory/etendue.forms";
    jacobians "theory/jacobians.forms";
    lambert "theory/lambert.forms";
    light_traps "theory/light_traps.forms";
    neumann_series "theory/neumann_series.forms";
    photons "theory/photons.forms";
    poynting "theory/poynting.forms";
    quantities "theory/quantities.forms";
    radiance "theory/radiance.forms";
    radiance_operators "theory/radiance_operators.forms";
    rays "theory/rays.forms";
    refraction "theory/refraction.forms";
    sampling "theory/sampling.forms";
    sun "theory/sun.forms";
    transport_equation "theory/transport_equation.forms";
    units "theory/units.forms";
    vector_irradiance "theory/vector_irradiance.forms";
}

/// Returns the numbers of statements to prove and to refute.
fn statements(text: &str) -> (usize, usize) {
    let (theory, diagnostics) = read_theory(text);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let to_prove = theory.statements.iter().filter(|statement| statement.claim == Claim::Prove).count();
    (to_prove, theory.statements.len() - to_prove)
}

#[test]
fn every_file_of_the_folder_is_proved_and_in_the_library() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("theory");
    let file_name =
        |entry: std::io::Result<std::fs::DirEntry>| entry.unwrap().file_name().into_string().unwrap();
    let in_folder: BTreeSet<String> = std::fs::read_dir(folder).unwrap().map(file_name).collect();
    let proved: BTreeSet<String> = PROVED.iter().map(|path| path.replace("theory/", "")).collect();
    let in_library = forms_kernels::theory().iter().map(|file| file.name.to_string()).collect();
    assert_eq!(in_folder, proved);
    assert_eq!(in_folder, in_library);
}

#[test]
fn every_topic_has_a_refuted_mistake() {
    for file in forms_kernels::theory() {
        assert!(statements(file.text).1 > 0, "{}", file.name);
    }
}

#[test]
fn every_statement_has_its_meaning_beside_it() {
    for file in forms_kernels::theory().iter().filter(|file| file.name != forms_kernels::RADIANCE.name) {
        for statement in read_theory(file.text).0.statements {
            assert!(!statement.docs.is_empty(), "{}: {}", file.name, statement.name);
        }
    }
}

/// The page has rows `| [name](path) | … | proved | refuted |`, and the totals at the end.
#[test]
fn the_page_counts_the_statements_of_each_file() {
    let page = include_str!("../../docs/theory.md");
    let mut totals = (0, 0);
    for file in forms_kernels::theory() {
        let (to_prove, to_refute) = statements(file.text);
        totals = (totals.0 + to_prove, totals.1 + to_refute);
        let row = page.lines().find(|line| line.starts_with(&format!("| [{}]", file.name)));
        let row = row.unwrap_or_else(|| panic!("no row for {}", file.name));
        assert!(row.ends_with(&format!("| {to_prove} | {to_refute} |")), "{row}: {to_prove}, {to_refute}");
    }
    let last = format!("| all {} files | | | {} | {} |", forms_kernels::theory().len(), totals.0, totals.1);
    assert!(page.contains(&last), "expected the row {last}");
}
