//! Display of a theory in a notebook.

use forms_core::notebook::{Session, Table};

const TEXT: &str = "
    chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
    chart UV(u, v);
    param h where h > 0;
    let r = sqrt(x**2 + y**2 + z**2);
    form beta: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3;
    form w = x*dy;
    map plane: UV -> R3 = (u, v, h);
    prove closed: d(beta) == 0;
    refute flat: pullback(plane, beta) == du^dv where u > 0;
    prove wrong: d(w) == dy^dx;
    kernel density(u, v, h) = pullback(plane, beta)[du^dv];
";

#[test]
fn a_name_is_shown_as_it_was_written_and_simplified() {
    let cases = [
        ("r", "r = sqrt(x**2 + y**2 + z**2)", r"r = \sqrt{x^{2} + y^{2} + z^{2}}"),
        ("w", "w = x*dy", r"w = x\,\mathrm{d}y"),
        ("plane", "plane = (u, v, h)", r"\mathrm{plane} = \left(u, v, h\right)"),
        ("closed", "d(beta) == 0", r"\mathrm{d}\beta = 0"),
        ("nobody", "nothing is named `nobody`", r"\text{nothing is named }\texttt{nobody}"),
    ];
    let mut session = Session::read(TEXT);
    for (name, text, latex) in cases {
        let shown = session.show(name);
        assert_eq!((shown.text.as_str(), shown.latex.as_str()), (text, latex), "{name}");
    }
    let beta = session.show("beta");
    assert!(beta.text.starts_with("beta = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3 = "), "{}", beta.text);
    let flat = session.show("flat");
    assert!(flat.text.ends_with(" == du^dv where u > 0"), "{}", flat.text);
    assert!(flat.latex.ends_with(r"\quad\text{where}\quad u > 0"), "{}", flat.latex);
    assert!(session.show("UV").text.starts_with("UV(u, v)"));
}

#[test]
fn a_claim_is_shown_with_its_verdict_and_whether_it_is_as_claimed() {
    let decided = Session::read(TEXT).decide();
    let names: Vec<&str> = decided.verdicts().map(|verdict| verdict.name()).collect();
    assert_eq!(names, ["proved", "refuted", "refuted"]);
    assert!(!decided.are_as_claimed());
    let markdown = decided.markdown();
    for part in [
        "✓ closed is **proved** where `x**2 + y**2 + z**2 > 0`\n\n$$\\mathrm{d}\\beta = 0$$",
        "✓ flat is **refuted** at $u = 2,\\; v = 1,\\; h = \\tfrac{1}{2}$: left $= 0.0415653124\\ldots$, right $= 1$",
        "; the sides differ by a factor only: `left/right = h/(h**2 + u**2 + v**2)**(3/2)`",
        "✗ wrong is **refuted** everywhere: left $= 1$, right $= -1$ in the coefficient of `dx^dy`",
        "**not as claimed**",
    ] {
        assert!(markdown.contains(part), "{part}: {markdown}");
    }
    assert_eq!(markdown.matches("not as claimed").count(), 1);
}

#[test]
fn a_derivation_has_a_title_and_a_formula_for_each_step() {
    let derivation = Session::read(TEXT).derive("closed").expect("the claim is there");
    let markdown = derivation.markdown();
    assert_eq!(markdown.matches("**").count(), 2 * derivation.steps.len());
    assert!(markdown.contains("The coefficient of dx^dy^dz:\n\n$$"), "{markdown}");
    assert_eq!(markdown.matches("$$").count() % 2, 0);
}

#[test]
fn what_is_not_there_is_told_with_what_is() {
    let error = Session::read(TEXT).derive("open").expect_err("no such claim");
    assert_eq!(error, "no claim is named `open`; the claims are: closed, flat, wrong");
    let error = Session::read("chart L(x); prove s: d(y) == 0;").derive("s").expect_err("y is unknown");
    assert!(error.contains("--> cell:1:24"), "{error}");
}

#[test]
fn the_text_of_a_table_is_no_markup() {
    let html = Table::new(["a < b"], [["x & y"]]).html();
    assert_eq!(
        html,
        "<table>\n<thead><tr><th>a &lt; b</th></tr></thead>\n<tbody>\n<tr><td>x &amp; y</td></tr>\n</tbody>\n</table>"
    );
}

#[test]
fn a_claim_of_a_kernel_that_does_not_hold_is_told() {
    let mut session = Session::read("kernel k(u, v) = sqrt(u**2 + v**2) by abs(u)*sqrt(1 + (v/u)**2);");
    let decided = session.decide();
    assert!(!decided.are_as_claimed());
    assert!(decided.markdown().contains("✗ k, `by`, is **refuted**"), "{}", decided.markdown());
}
