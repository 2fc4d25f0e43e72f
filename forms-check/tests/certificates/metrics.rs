//! Metric operations, derived by the checker from their definitions.

use crate::support::{certificate, checked, is_accepted};
use forms_check::Outcome;

/// Statements that need every operation: a general metric on a plane, an indefinite one, a chart
/// with reversed orientation.
const METRICS: &str = "chart P(x, y); chart T(y, x); chart E(t, x, y, z); chart S(r, theta, phi) where r > 0, 0 < theta < pi;\n\
    fn A(x, y) where A > 0; fn B(x, y); fn f(r, theta, phi); fn X(t, x, y, z); fn p(x, y); fn q(x, y);\n\
    metric g on P = A*dx**2 + 2*B*dx*dy + (B**2/A + 1)*dy**2;\n\
    metric turned on T = dx**2 + dy**2;\n\
    metric m = -dt**2 + dx**2 + dy**2 + dz**2;\n\
    metric s on S = dr**2 + r**2*(dtheta**2 + sin(theta)**2*dphi**2);\n\
    metric doubled on P = 2*g;\n\
    field v on S = r*@r;\n\
    prove star_of_an_indefinite_metric: hodge[m](dt^dx) == -dy^dz;\n\
    prove twice_the_star: hodge[m](hodge[m](X*dt)) == X*dt;\n\
    prove order_of_the_chart: volume[turned] == dy^dx;\n\
    prove inverse: sharp[g](flat[g](p*@x + q*@y)) == p*@x + q*@y;\n\
    prove product: (p*dx + q*dy)^hodge[g](dx) == inner[g](p*dx + q*dy, dx)*volume[g];\n\
    prove determinant: volume[g] == sqrt(A)*dx^dy;\n\
    prove scaled: inner[doubled](dx^dy, dx^dy) == inner[g](dx^dy, dx^dy)/4;\n\
    prove laplacian: laplace[s](1/r) == 0;\n\
    prove sphere: laplace[s](f) == -diff(r**2*diff(f, r), r)/r**2\n\
        - diff(sin(theta)*diff(f, theta), theta)/(r**2*sin(theta)) - diff(f, phi, phi)/(r**2*sin(theta)**2);\n\
    prove waves: codiff[m](d(X*dx)) == laplace[m](X*dx) - d(codiff[m](X*dx));\n\
    prove expansion: div[s](v) == 3;\n\
    prove length: norm[s](v) == r;\n\
    prove slope: grad[s](r**2) == 2*v;\n\
    prove irrotational: curl[s](grad[s](f)) == 0;\n\
    refute sign: hodge[m](dt^dx) == dy^dz;\n\
    refute orientation: volume[turned] == dx^dy;\n\
    refute laplacian_with_the_other_sign: laplace[s](r**2) == 6;\n";

#[test]
fn every_metric_operation_is_covered() {
    let lines = certificate(METRICS);
    let all = checked(&lines, METRICS).expect("a certificate that can be read");
    let open: Vec<_> = all.iter().filter(|one| one.outcome != Outcome::Accepted).collect();
    assert!(open.is_empty(), "{open:?}");
}

/// Whether a claim is accepted by the proof `zero` alone.
fn is_plainly_zero(claim: &str) -> bool {
    let source = format!(
        "chart P(x, y); chart T(y, x); chart E(t, x, y, z); fn p(x, y);\n\
         metric g on P = dx**2 + dy**2; metric turned on T = dx**2 + dy**2;\n\
         metric m on E = -dt**2 + dx**2 + dy**2 + dz**2; prove claim: {claim};"
    );
    let head = forms_core::certificate::HEADER.to_string();
    let lines = head + &forms_core::certificate::file_lines("it.forms", &source) + "proved claim\nzero\n";
    is_accepted(&lines, &source)
}

#[test]
fn signs_and_orientations_are_those_of_the_conventions() {
    for (right, wrong) in [
        ("hodge[g](dx) == dy", "hodge[g](dx) == -dy"),
        ("hodge[turned](dx) == -dy", "hodge[turned](dx) == dy"),
        ("volume[turned] == dy^dx", "volume[turned] == dx^dy"),
        ("inner[m](dt, dt) == -1", "inner[m](dt, dt) == 1"),
        ("inner[m](@t, @t) == -1", "inner[m](@t, @t) == 1"),
        ("codiff[g](p*dx) == -diff(p, x)", "codiff[g](p*dx) == diff(p, x)"),
        ("laplace[g](x**2) == -2", "laplace[g](x**2) == 2"),
        ("laplace[m](t**2) == 2", "laplace[m](t**2) == -2"),
        ("div[turned](p*@x) == diff(p, x)", "div[turned](p*@x) == -diff(p, x)"),
        ("hodge[m](dt^dx) == -dy^dz", "hodge[m](dt^dx) == dy^dz"),
        ("sharp[m](dt) == -@t", "sharp[m](dt) == @t"),
    ] {
        assert!(is_plainly_zero(right), "{right}");
        assert!(!is_plainly_zero(wrong), "{wrong}");
    }
}
