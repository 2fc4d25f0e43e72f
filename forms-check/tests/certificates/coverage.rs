//! Coverage of the case files and of the theory of radiance: which statements the checker accepts,
//! and which are not covered.

use crate::support::{case_file, certificate, checked};
use forms_check::Outcome;

/// Returns the statements of a text that are not accepted.
fn not_covered(source: &str) -> Vec<String> {
    let all = checked(&certificate(source), source).expect("a certificate that can be read");
    assert!(!all.is_empty());
    let open = all.into_iter().filter(|one| one.outcome != Outcome::Accepted);
    open.map(|one| one.name).collect()
}

#[test]
fn the_theory_of_radiance_is_covered_with_its_integrals() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../forms-kernels/theory/radiance.forms");
    let source = std::fs::read_to_string(path).expect("the theory");
    assert_eq!(not_covered(&source), Vec::<String>::new());
}

#[test]
fn these_case_files_are_covered_in_full() {
    for name in [
        "change_of_variables",
        "etendue",
        "exterior_derivative",
        "half_vectors",
        "hodge",
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
fn of_these_case_files_nested_roots_and_relations_of_arcs_are_not_covered() {
    let open = [
        ("not_identities", vec!["atan_of_inverse"]),
        ("pullbacks", vec![]),
        ("radicals", vec!["nested_radicals_product", "nested_radicals_product_abs"]),
        ("sampling_densities", vec![]),
        ("trigonometry", vec![]),
    ];
    let found: Vec<_> = open.iter().map(|(name, _)| (*name, not_covered(&case_file(name)))).collect();
    assert_eq!(found, open.map(|(name, list)| (name, list.into_iter().map(String::from).collect())));
}

#[test]
fn what_follows_from_a_warp_is_not_covered_and_what_stands_beside_it_is() {
    let source = "chart Line(t) where t > 0;
        warp flight(sigma; u) = (-log1p(-u)/sigma) onto Line density sigma*exp(-sigma*t) of dt
            inverse (-expm1(-sigma*t)) where sigma > 0;
        prove beside: d(t**2) == 2*t*dt;";
    assert_eq!(not_covered(source), ["flight_density", "flight_inverse"]);
}
