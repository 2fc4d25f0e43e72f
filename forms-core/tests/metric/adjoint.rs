//! The codifferential is the adjoint of d: ∫ ⟨da, b⟩ vol = ∫ ⟨a, δb⟩ vol over a box on whose boundary a vanishes.

use super::theory::{assert_proved, is_refuted};
use forms_testing::SplitMix;

/// Returns a metric Σ ±θᵢ² with θ = dx + p dy, …: its determinant is ±1, so that everything stays
/// polynomial.
fn unimodular(random: &mut SplitMix) -> String {
    let signs = [0, 1, 2].map(|_| ["", "-"][random.below(2)]);
    let slopes = [0, 1, 2].map(|_| ["0", "1", "x", "y*z", "2*y"][random.below(5)]);
    format!(
        "chart C(x, y, z); metric g on C = {}(dx + {}*dy + {}*dz)**2 + {}1*(dy + {}*dz)**2 + {}1*dz**2;",
        signs[0], slopes[0], slopes[1], signs[1], slopes[2], signs[2]
    )
}

const BUMP: &str = "x*(1 - x)*y*(1 - y)*z*(1 - z)";

/// a and b of degrees k and k + 1.
const PAIRS: [(&str, &str); 3] = [
    ("(x + 2*y)", "(y*dx + x*dy - z**2*dz)"),
    ("(dx + z*dy - x*dz)", "(x*dx^dy + y*dy^dz + dz^dx)"),
    ("(z*dx^dy - dy^dz)", "((1 + x*y)*dx^dy^dz)"),
];

#[test]
fn the_codifferential_is_the_adjoint_of_d_on_a_box() {
    let mut random = SplitMix(11);
    let mut seen = false;
    for _ in 0..4 {
        let preamble = unimodular(&mut random);
        for (a, b) in PAIRS {
            let a = format!("{BUMP}*{a}");
            let box_integral =
                |density: String| format!("integral({density}*volume[g], x = 0..1, y = 0..1, z = 0..1)");
            let left = box_integral(format!("inner[g](d({a}), {b})"));
            let right = box_integral(format!("inner[g]({a}, codiff[g]({b}))"));
            assert_proved(&preamble, &left, &right);
            seen = seen || is_refuted(&preamble, &left, &format!("-{right}"));
        }
    }
    assert!(seen, "a lost sign is not seen");
}

#[test]
fn where_the_form_does_not_vanish_on_the_boundary_it_is_not() {
    let preamble = "chart C(x, y); metric g on C = dx**2 + dy**2;";
    let left = "integral(inner[g](d(x), dx)*volume[g], x = 0..1, y = 0..1)";
    let right = "integral(inner[g](x, codiff[g](dx))*volume[g], x = 0..1, y = 0..1)";
    assert!(is_refuted(preamble, left, right));
}
