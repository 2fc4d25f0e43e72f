//! What is checked of the case files and of the theory of radiance, and what is not covered.

use crate::support::{case_file, certificate, checked};
use forms_check::Outcome;

/// The statements of a text that are not accepted; none may be rejected.
fn not_covered(source: &str) -> Vec<String> {
    let all = checked(&certificate(source), source).expect("a certificate that can be read");
    assert!(!all.is_empty());
    let rejected: Vec<_> = all.iter().filter(|one| matches!(one.outcome, Outcome::Rejected(_))).collect();
    assert!(rejected.is_empty(), "{rejected:?}");
    let open = all.into_iter().filter(|one| one.outcome != Outcome::Accepted);
    open.map(|one| one.name).collect()
}

#[test]
fn of_the_theory_of_radiance_integrals_are_not_covered() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../forms-radiometry/theory/radiance.forms");
    let source = std::fs::read_to_string(path).expect("the theory");
    let open = ["uniform_hemisphere_up", "uniform_hemisphere_sideways", "whole_sphere"];
    assert_eq!(not_covered(&source), open);
}

#[test]
fn these_case_files_are_covered_in_full() {
    for name in [
        "change_of_variables",
        "etendue",
        "exterior_derivative",
        "half_vectors",
        "lie_and_cartan",
        "solid_angle",
        "sphere_pullbacks",
        "symplectic",
        "wedge_and_interior",
    ] {
        assert_eq!(not_covered(&case_file(name)), Vec::<String>::new(), "{name}");
    }
}

#[test]
fn of_these_case_files_only_what_the_prover_leaves_open_is_not_covered() {
    for name in ["not_identities", "pullbacks", "radicals", "sampling_densities", "trigonometry"] {
        let source = case_file(name);
        let lines = certificate(&source);
        for open in not_covered(&source) {
            assert!(lines.contains(&format!("uncovered {open} the statement is not decided\n")), "{open}");
        }
    }
}
