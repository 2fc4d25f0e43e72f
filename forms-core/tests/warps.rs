//! Warps: their consequences, and the messages about errors in them.

use forms_core::check::{decide_all, read_theory};
use forms_core::compile::compile_kernel;
use forms_core::decide::Verdict;
use forms_core::derivation::derive;
use forms_core::syntax::Source;
use forms_core::theory::Theory;

const HEMISPHERE: &str = "chart Directions(x, y, z) where z > 0;
    form omega on Directions = x*dy^dz + y*dz^dx + z*dx^dy;
    /// Cosine-weighted directions.
    pub warp cosine_hemisphere(u, v) = (sqrt(u)*cos(2*pi*v), sqrt(u)*sin(2*pi*v), sqrt(1 - u))
        onto Directions density z/pi of omega
        inverse (x**2 + y**2, atan2(-y, -x)/(2*pi) + 1/2);";

const OTHERS: &[&str] = &[
    "chart Line(t) where t > 0;
     warp flight(sigma; u) = (-log1p(-u)/sigma) onto Line density sigma*exp(-sigma*t) of dt
        inverse (-expm1(-sigma*t)) where sigma > 0;",
    "chart Disk(p, q);
     warp disk(radius; u, v) = (radius*sqrt(u)*cos(2*pi*v), radius*sqrt(u)*sin(2*pi*v)) onto Disk
        density 1/(pi*radius**2) of dp^dq where radius > 0;",
    "chart Plane(p, q); chart Square(s, t) where 0 < s < 1, 0 < t < 1; param width where width > 0;
     warp triangle(width; s, t) = (width*(1 - sqrt(s)), width*t*sqrt(s)) onto Plane
        density 2/width**2 of dp^dq inverse ((1 - p/width)**2, q/(width - p));",
];

fn theory(text: &str) -> Theory {
    let source = Source::new("w.forms", text);
    let (theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{}", errors.iter().map(|error| source.render(error)).collect::<String>());
    theory
}

/// Returns the messages about a source with an error in it.
fn errors(text: &str) -> String {
    read_theory(text).1.into_iter().map(|error| error.message + "\n").collect()
}

#[test]
fn the_density_and_the_inverse_of_a_warp_are_proved() {
    for text in std::iter::once(&HEMISPHERE).chain(OTHERS) {
        let mut theory = theory(text);
        assert!(!theory.statements.is_empty());
        for (verdict, statement) in decide_all(&mut theory).iter().zip(&theory.statements) {
            assert!(matches!(verdict, Verdict::Proved(_)), "{}: {verdict:?}", statement.name);
        }
    }
}

#[test]
fn a_warp_gives_a_sample_a_density_and_an_inverse() {
    let mut theory = theory(HEMISPHERE);
    let names: Vec<&str> = theory.kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    assert_eq!(names, ["cosine_hemisphere_sample", "cosine_hemisphere_pdf", "cosine_hemisphere_inverse"]);
    assert!(
        theory.kernels.iter().all(|kernel| kernel.public && kernel.docs[0] == "Cosine-weighted directions.")
    );
    let kernels = theory.kernels.clone();
    let [sample, pdf, inverse] = [0, 1, 2]
        .map(|number| compile_kernel(&mut theory.pool, &kernels[number]).expect("a kernel").optimised);
    let (u, v) = (0.3, 0.8);
    let point = sample.interpret(&[u, v]);
    assert!((point.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-15);
    assert!((pdf.interpret(&point)[0] - point[2] / std::f64::consts::PI).abs() < 1e-16);
    let back = inverse.interpret(&point);
    assert!((back[0] - u).abs() < 1e-15 && (back[1] - v).abs() < 1e-15, "{back:?}");
    assert!(sample.interpret(&[1.5, v])[0].is_nan() && inverse.interpret(&[0.0, 0.0, -1.0])[0].is_nan());
    assert_eq!(pdf.interpret(&[0.0, 0.0, -1.0])[0], 0.0);
}

#[test]
fn a_form_behind_by_and_an_accuracy_go_with_the_sample() {
    let by = "by (sqrt(u)*sin(2*pi*(1/4 - v)), sqrt(u)*sin(2*pi*v), sqrt(1 - u)) within 16;";
    let mut known = theory(&HEMISPHERE.replace("+ 1/2);", &format!("+ 1/2) {by}")));
    let kernels = known.kernels.clone();
    assert!(kernels.iter().all(|kernel| kernel.within.is_some()));
    let sample = compile_kernel(&mut known.pool, &kernels[0]).expect("a kernel").optimised;
    assert_eq!(sample.interpret(&[0.5, 0.25])[0], 0.0);
    let wrong = HEMISPHERE.replace("+ 1/2);", &format!("+ 1/2) {}", by.replace("1/4 - v", "1/2 - v")));
    let mut wrong = theory(&wrong);
    let kernel = wrong.kernels[0].clone();
    assert!(compile_kernel(&mut wrong.pool, &kernel).is_err());
    assert!(
        errors(&HEMISPHERE.replace("+ 1/2);", "+ 1/2) by (u, v);")).contains("3 outputs, but `by` gives 2")
    );
}

#[test]
fn the_orientation_is_found_and_said() {
    let reversed = theory(
        "chart Disk(p, q); warp disk(u, v) = (sqrt(u)*sin(2*pi*v), sqrt(u)*cos(2*pi*v)) onto Disk
            density 1/pi of dp^dq;",
    );
    assert!(reversed.warps[0].reverses);
    assert_eq!(
        reversed.statements[0].docs,
        ["The density of `disk` is the density of its map, which reverses the orientation."]
    );
    assert!(!theory(HEMISPHERE).warps[0].reverses);
}

#[test]
fn a_slip_is_refuted_with_a_point() {
    for (wrong, right, statement) in [
        ("z/(2*pi)", "z/pi", "cosine_hemisphere_density"),
        ("1/pi", "z/pi", "cosine_hemisphere_density"),
        ("sqrt(1 - u**2)", "sqrt(1 - u)", "cosine_hemisphere_density"),
        ("+ 1/4", "+ 1/2", "cosine_hemisphere_inverse"),
        ("(x**2 - y**2", "(x**2 + y**2", "cosine_hemisphere_inverse"),
    ] {
        let mut theory = theory(&HEMISPHERE.replace(right, wrong));
        let verdicts = decide_all(&mut theory);
        let place =
            theory.statements.iter().position(|known| known.name == statement).expect("the statement");
        assert!(matches!(verdicts[place], Verdict::Refuted(_)), "{wrong}: {:?}", verdicts[place]);
    }
}

#[test]
fn mistakes_are_named() {
    for (text, message) in [
        (
            "chart C(x); warp w(u) = (u, u) onto C density 1 of dx;",
            "a map to `C` needs 1 component (x), found 2",
        ),
        ("chart C(x); warp w(u, v) = (u) onto C density 1 of dx;", "cannot compare a 1-form with a 2-form"),
        ("chart C(x); warp w(u) = (k*u) onto C density 1 of dx;", "`k` is not declared"),
        ("chart C(x); warp w(u) = (u) onto D density 1 of dx;", "`D` is not declared"),
        ("chart C(x); warp w(u) = (u) density 1 of dx;", "expected `onto`, found `density`"),
        (
            "chart C(x); warp w(x; u) = (u) onto C density 1 of dx;",
            "a coordinate of a warp's target chart cannot be a parameter of the warp",
        ),
        ("chart C(x); warp w(u) = (u) onto C density 1 of dx inverse (x, x);", "the inverse needs 1 value,"),
        ("chart C(x); warp w(; u) = (u) onto C density 1 of dx; let w_pdf = 1;", "`w_pdf` is declared twice"),
    ] {
        let found = errors(text);
        assert!(found.contains(message), "{text}\n{found}");
    }
}

#[test]
fn the_names_of_uniform_numbers_are_local() {
    let two = theory(
        "chart C(x); warp a(u) = (u) onto C density 1 of dx; warp b(k; u) = (k*u) onto C density 1/k of dx where k > 0;
         let u = 5; let k = 7;",
    );
    assert_eq!(two.warps.len(), 2);
}

#[test]
fn the_claims_of_a_warp_are_derived_like_others() {
    let source = Source::new("w.forms", HEMISPHERE);
    let derivation = derive(&source, "cosine_hemisphere_density").expect("a statement");
    let text = derivation.text();
    assert!(derivation.ok && text.contains("pullback(cosine_hemisphere, z/pi*omega) = du^dv"), "{text}");
}

#[test]
fn units_of_a_warp_are_checked() {
    let flight = "chart Line(t: m) where t > 0;
        warp flight(sigma: 1/m; u: 1) = (-log1p(-u)/sigma) onto Line density sigma*exp(-sigma*t) of dt
            inverse (-expm1(-sigma*t)) where sigma > 0;";
    let known = theory(flight);
    let units: Vec<_> = known.kernels.iter().map(|kernel| kernel.units.outputs.clone()).collect();
    assert_eq!(units[..2], [vec![Some("m".to_owned())], vec![Some("1/m".to_owned())]]);
    let found = errors(&flight.replace("density sigma*", "density "));
    assert!(found.contains("`flight_density` equates different units"), "{found}");
}
