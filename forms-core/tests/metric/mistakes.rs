//! Messages about errors with metrics, potentials and boundaries.

use super::theory::errors;

const PREAMBLE: &str = "chart R2(x, y); chart R3(x, y, z); chart R4(x, y, z, w); \
    metric e2 on R2 = dx**2 + dy**2; metric e3 on R3 = dx**2 + dy**2 + dz**2; \
    field X on R3 = x*@x; map F: R2 -> R3 = (x, y, x*y);";

/// Returns the only error of an expression after the preamble.
fn said_about(expression: &str) -> String {
    let found = errors(&format!("{PREAMBLE} let it = {expression};"));
    assert_eq!(found.len(), 1, "{expression}: {found:?}");
    found[0].clone()
}

#[test]
fn operations_say_what_they_take() {
    let table = [
        ("hodge[e2](dz)", "`dz` occurs, but `z` is not a coordinate of `R2`"),
        ("hodge(dx)", "`hodge` needs a metric"),
        ("hodge[R2](dx)", "expected a metric, but `R2` is a chart"),
        ("hodge[e2](@x)", "expected a form, found a vector field"),
        ("hodge[e5](dx)", "`e5` is not declared"),
        ("hodge[e2](dx, dy)", "`hodge` takes 1 argument, found 2"),
        ("flat[e2](@z)", "`@z` occurs, but `z` is not a coordinate of `R2`"),
        ("flat[e3](dx)", "expected a vector field, found a 1-form"),
        ("sharp[e3](dx^dy)", "`sharp` takes a 1-form, and this has degree 2"),
        ("curl[e2](@x)", "`curl` needs three dimensions, and the metric has 2"),
        (
            "inner[e3](dx, dx^dy)",
            "`inner` takes two forms of one degree or two fields, found a 1-form and a 2-form",
        ),
        (
            "inner[e3](dx, @x)",
            "`inner` takes two forms of one degree or two fields, found a 1-form and a vector field",
        ),
        ("inner[e3](dx)", "`inner` takes 2 arguments, found 1"),
        ("grad[e3](dx)", "expected a scalar, found a 1-form"),
        ("volume[e3](x)", "`volume[g]` takes no arguments"),
        ("volume[x]", "expected a metric, but `x` is a coordinate"),
        ("norm[e2](dz)", "`dz` occurs, but `z` is not a coordinate of `R2`"),
    ];
    for (expression, message) in table {
        assert_eq!(said_about(expression), message, "{expression}");
    }
}

#[test]
fn metrics_are_quadratic_regular_and_on_one_chart() {
    let table = [
        ("metric g on R2 = dx**2;", "the metric is degenerate: its determinant is zero"),
        ("metric g on R2 = (dx + dy)**2;", "the metric is degenerate: its determinant is zero"),
        ("metric g on R2 = dx**2 + 2*dx*dy + dy**2;", "the metric is degenerate: its determinant is zero"),
        ("metric g on R2 = x*y;", "a metric is a quadratic form in the differentials, and this is a scalar"),
        (
            "metric g on R2 = dx + dy;",
            "a metric is a quadratic form in the differentials, and this is a 1-form",
        ),
        ("metric g on R2 = dx^dy;", "a metric is built from 1-forms, and this is a 2-form"),
        ("metric g on R2 = dx**2 + dy;", "cannot add a quadratic form and a 1-form"),
        (
            "metric g on R2 = dx**2*dy;",
            "the product of a quadratic form and a 1-form is not quadratic in the differentials",
        ),
        (
            "metric g on R2 = dx**3 + dy**2;",
            "inside a metric a 1-form is squared or multiplied by another one",
        ),
        ("metric g on R2 = dx**2 + dy**2 + dz**2;", "`dz` occurs, but `z` is not a coordinate of `R2`"),
        ("metric g = dx**2 + dz**2;", "no chart has exactly the coordinates of this metric"),
        ("chart S2(y, x); metric g = dx**2 + dy**2;", "several charts have the coordinates of this metric"),
        ("metric g on R2 = dx**2/0 + dy**2;", "division by zero"),
    ];
    for (items, message) in table {
        let text = format!("chart R2(x, y); chart R3(x, y, z); {items}");
        assert_eq!(errors(&text), [message], "{items}");
    }
}

#[test]
fn potentials_and_boundaries_say_what_they_take() {
    let table = [
        ("potential(x*dx)", "several charts fit this form: R2, R3, R4"),
        ("potential(@x)", "`potential` takes a form, and this is a vector field"),
        (
            "potential[R3](dx/(x**2 + y**2 + z**2)**(1/2))",
            "cannot integrate along the rays: a term of a coefficient is homogeneous of degree -k, where k is the \
             degree of the form",
        ),
        (
            "boundary_integral(F, x*y*dx, x = 0..1)",
            "the boundary of a box of dimension 1 takes a 0-form, found degree 1",
        ),
        ("boundary_integral(F, z*dx, x = 0..1, z = 0..1)", "`z` is not a coordinate of `R2`"),
        ("boundary_integral(F, z*dx, x = 0..1, x = 0..1)", "this variable has a range already"),
        ("boundary_integral(F, z*dx)", "`boundary_integral` needs at least one range"),
        ("boundary_integral(X, z*dx, x = 0..1)", "expected a map, but `X` is a scalar, form or field"),
        (
            "integral(x, x = 0..y, y = 0..1)",
            "the bounds of `x` mention `y`, which has no value outside its range",
        ),
        ("integral(x, x = 0..x)", "the bounds of `x` mention `x`, which has no value outside its range"),
    ];
    for (expression, message) in table {
        assert_eq!(said_about(expression), message, "{expression}");
    }
}
