//! Unit of each operation.

use crate::{read, unit};
use forms_core::check::read_theory;
use forms_core::units::sentence;
use num_bigint::BigInt;

/// Expressions with their units; `-` where no unit is stated.
const LAWS: &[(&str, &str)] = &[
    // Numbers and names.
    ("3", "1"),
    ("pi", "1"),
    ("x", "m"),
    ("E", "W/m**2"),
    ("free", "-"),
    ("0", "-"),
    // Arithmetic.
    ("-x", "m"),
    ("x + y", "m"),
    ("x - 2*y", "m"),
    ("x*y", "m**2"),
    ("x/t", "m/s"),
    ("x/y", "1"),
    ("1/x", "1/m"),
    ("c*t", "m"),
    ("w/r**2", "W/m**2"),
    ("x**3", "m**3"),
    ("x**-2", "1/m**2"),
    ("x**(1/2)", "m**(1/2)"),
    ("x**(2 - 1/2)", "m**(3/2)"),
    ("x**0", "1"),
    ("n**n", "1"),
    ("2**(x/y)", "1"),
    ("0 + x", "m"),
    ("x + 0", "m"),
    ("x*free", "-"),
    ("x + free", "m"),
    ("1 + free", "1"),
    // Functions.
    ("sqrt(x)", "m**(1/2)"),
    ("sqrt(x**2 + y**2)", "m"),
    ("abs(x)", "m"),
    ("exp(x/r)", "1"),
    ("log(x/r)", "1"),
    ("sin(theta)", "1"),
    ("cos(x/r)", "1"),
    ("tanh(n)", "1"),
    ("sin(free)", "1"),
    ("min(x, r)", "m"),
    ("max(x, 0)", "m"),
    ("max(0, x)", "m"),
    ("max(n, 1)", "1"),
    ("hypot(x, y)", "m"),
    ("cbrt(x**3)", "m"),
    ("copysign(x, t)", "m"),
    ("erfc(x/r)", "1"),
    ("sec(theta)", "1"),
    ("asin(x/r)", "rad"),
    ("acos(n)", "rad"),
    ("atan(x/y)", "rad"),
    ("atan2(y, x)", "rad"),
    ("atan2(1, 2)", "1"),
    ("if x > 0 { x } else { 0 }", "m"),
    ("if jump x > y { 2*r } else { z }", "m"),
    // Unknown functions, their derivatives and their values at other arguments.
    ("f", "K"),
    ("f(r, 2*r, c*t)", "K"),
    ("diff(f, x)", "K/m"),
    ("diff(f, x, y)", "K/m**2"),
    ("diff(height, t, t)", "m/s**2"),
    ("h", "-"),
    // Forms: dx has the unit of x, d keeps it, the wedge product multiplies.
    ("dx", "m"),
    ("d(x)", "m"),
    ("d(f)", "K"),
    ("d[Line](s**2)", "m**2"),
    ("dx^dy", "m**2"),
    ("f*dx^dy + f*dy^dz", "K*m**2"),
    ("d(f*dx)", "K*m"),
    ("dtheta", "rad"),
    ("du", "-"),
    ("beta", "sr"),
    ("(x*dy^dz)[dy^dz]", "m"),
    ("beta[dx^dy]", "sr/m**2"),
    // Fields: @x has the reciprocal of the unit of x.
    ("@x", "1/m"),
    ("@t", "1/s"),
    ("X", "1"),
    ("X[x]", "m"),
    ("rise[t]", "1"),
    ("interior(@x, dx^dt)", "s"),
    ("interior(X, f*dx)", "K*m"),
    ("lie(@t, height)", "m/s"),
    ("lie(rise, t*dt)", "s"),
    ("bracket(@x, x*@t)", "1/s"),
    ("pair(dx^dt, @x, @t)", "1"),
    ("pair(f*dx, X)", "K*m"),
    // Pullbacks keep the unit.
    ("pullback(globe, f)", "K"),
    ("pullback(globe, dx^dy)", "m**2"),
    ("pullback(globe, beta)[dtheta^dphi]", "sr/rad**2"),
    ("pullback(path, dx)[dt]", "m/s"),
    // Integrals: the unit of a form is kept, the unit of a scalar is multiplied by the units of the
    // variables.
    ("integral(x*dx, x = 0..r)", "m**2"),
    ("integral(x, x = 0..r)", "m**2"),
    ("integral(E, x = 0..r, y = 0..2*r)", "W"),
    ("integral(cos(theta)*dtheta, theta = 0..pi)", "rad"),
    ("boundary_integral(path, E*x, t = 0..j/w)", "W/m"),
    // Metrics: the volume is in m**3, and raising an index divides by m**2.
    ("volume[g]", "m**3"),
    ("volume[round]", "m**2*rad**2"),
    ("hodge[g](f)", "K*m**3"),
    ("hodge[g](dx)", "m**2"),
    ("hodge[g](dx^dy)", "m"),
    ("hodge[round](dtheta)", "rad"),
    ("codiff[g](f*dx)", "K/m"),
    ("laplace[g](f)", "K/m**2"),
    ("laplace[g](f*dx)", "K/m"),
    ("flat[g](@x)", "m"),
    ("flat[g](X)", "m**2"),
    ("sharp[g](dx)", "1/m"),
    ("inner[g](@x, X)", "m"),
    ("inner[g](f*dx, f*dx)", "K**2"),
    ("inner[g](dx^dy, f*dx^dy)", "K"),
    ("inner[g](x, f)", "m*K"),
    ("norm[g](X)", "m"),
    ("norm[g](f*dx^dy)", "K"),
    ("norm[g](f)", "K"),
    ("grad[g](f)", "K/m**2"),
    ("grad[g](f)[x]", "K/m"),
    ("div[g](f*@x)", "K/m"),
    ("curl[g](f*@x)", "K/m**2"),
    ("potential(x*dy^dz)", "m**3"),
    // Prefixes and derived units.
    ("lambda*x", "nm*m"),
    ("j/t + w", "J/s"),
    // Angles: the radian can be read as 1, and its square as the steradian.
    ("L*theta*phi + E", "W/m**2"),
    ("E + L*theta*phi", "W/m**2"),
    ("theta + 1", "1"),
    ("r*theta + r", "m"),
    ("r + r*theta", "m"),
];

#[test]
fn each_operation_has_its_unit() {
    for (expression, wanted) in LAWS {
        let (found, errors) = unit(expression);
        assert!(errors.is_empty(), "{expression}: {errors:?}");
        assert_eq!(found.as_deref().unwrap_or("-"), *wanted, "{expression}");
    }
}

#[test]
fn a_declared_unit_is_the_unit_of_the_value() {
    for (declaration, wanted) in [
        ("let it: W/m**2 = E;", "W/m**2"),
        ("let it: J/s/m**2 = E;", "J/s/m**2"),
        ("let it: kg/s**3 = E;", "kg/s**3"),
        ("let it: m/s = 299792458;", "m/s"),
        ("let it: J*s = 6.62607015e-34;", "J*s"),
        ("let it: nm/m = 10**9;", "nm/m"),
        ("let it: m = sqrt(2)**pi*exp(-1);", "m"),
        ("let it: sr = 2*pi;", "sr"),
        ("let it: sr = x*y/r**2;", "sr"),
        ("let it: 1/sr = x/(4*pi*y);", "1/sr"),
        ("let it: sr/m**2 = x/r**3;", "sr/m**2"),
        ("let it: sr = sin(theta)*dtheta^dphi;", "sr"),
        ("let it: m = r*theta;", "m"),
        ("form it: 2, sr on Sphere = sin(theta)*dtheta^dphi;", "sr"),
        ("form it: 1, K = d(f);", "K"),
        ("let it: m = free;", "m"),
        ("let it: m = 0;", "m"),
    ] {
        let (theory, errors) = read(declaration);
        assert!(errors.is_empty(), "{declaration}: {errors:?}");
        let found = theory.objects.last().and_then(|object| object.unit.clone());
        assert_eq!(found.as_deref(), Some(wanted), "{declaration}");
    }
}

/// Equations whose sides have units with the same meaning.
const AGREEING: &[(&str, &str)] = &[
    ("w", "j/t"),
    ("E", "w/r**2"),
    ("L*omega", "E"),
    ("L*omega*r**2", "w"),
    ("c**2", "x*y/t**2"),
    ("sqrt(x*y)", "r"),
    ("integral(L*cos(theta)*sin(theta)*dtheta^dphi, theta = 0..pi/2, phi = 0..2*pi)", "E"),
    ("diff(flux, theta, phi)/r**2", "L"),
    ("r*dtheta", "dx"),
    ("omega", "2*theta*phi"),
    ("L*pullback(globe, beta)", "E*dtheta^dphi"),
    ("diff(sin(theta), theta)", "cos(theta)"),
    ("free", "x"),
    ("0", "x"),
];

/// Derived units with their definitions.
const DERIVED: &[(&str, &str)] = &[
    ("Hz", "1/s"),
    ("N", "kg*m/s**2"),
    ("Pa", "N/m**2"),
    ("J", "N*m"),
    ("W", "J/s"),
    ("C", "A*s"),
    ("V", "W/A"),
    ("F", "C/V"),
    ("ohm", "V/A"),
    ("S", "A/V"),
    ("Wb", "V*s"),
    ("T", "Wb/m**2"),
    ("H", "Wb/A"),
    ("cd", "lm/sr"),
    ("lx", "lm/m**2"),
    ("L", "dm**3"),
    ("mol*K", "K*mol"),
];

#[test]
fn derived_units_are_what_they_are_defined_by() {
    for (unit, definition) in DERIVED {
        let (_, errors) = read(&format!("param left: {unit}, right: {definition}; prove p: left == right;"));
        assert!(errors.is_empty(), "{unit}: {errors:?}");
        let (_, errors) =
            read(&format!("param left: {unit}*mm, right: {definition}*m; prove p: left == right;"));
        assert_eq!(errors.len(), 1, "{unit}");
    }
}

#[test]
fn prefixes_are_powers_of_ten() {
    let prefixes = ["f", "p", "n", "u", "m", "c", "d", "", "h", "k", "M", "G", "T"];
    let powers = [-15, -12, -9, -6, -3, -2, -1, 0, 2, 3, 6, 9, 12];
    for (a, p) in prefixes.iter().zip(powers) {
        for (b, q) in prefixes.iter().zip(powers) {
            let text = format!("param left: {a}m*{b}s, right: m*s; let q = left + right;");
            let (_, errors) = read_theory(&text);
            let help = errors.first().and_then(|error| error.help.clone()).unwrap_or_default();
            let power = BigInt::from(10).pow(i32::unsigned_abs(p + q));
            let size = if p + q < 0 { format!("1/{power}") } else { power.to_string() };
            assert_eq!(errors.is_empty(), p + q == 0, "{text}");
            assert!(p + q == 0 || help.contains(&format!("= {size};`")), "{text} {help}");
        }
    }
}

#[test]
fn units_that_mean_the_same_agree_in_either_order() {
    for (a, b) in AGREEING {
        for (left, right) in [(a, b), (b, a)] {
            let (_, errors) = read(&format!("prove equation: {left} == {right};"));
            assert!(errors.is_empty(), "{left} == {right}: {errors:?}");
        }
    }
}

#[test]
fn the_units_of_a_kernel_make_a_sentence() {
    for (kernel, wanted) in [
        ("kernel k(a: m, b: s) = a/b;", Some("Units: `a` in `m`, `b` in `s`; result in `m/s`.")),
        ("kernel k(a: m, b) = (a, a**2);", Some("Units: `a` in `m`; results in `m`, `m**2`.")),
        ("kernel k(a: m, b) = (a, b);", Some("Units: `a` in `m`.")),
        ("kernel k(a): m = a;", Some("Units: result in `m`.")),
        ("kernel k(a) = a;", None),
        ("kernel k(p[3]: m) = norm(p);", Some("Units: `p` in `m`; result in `m`.")),
        ("kernel k(p[3]: m, b: s) = p/b;", Some("Units: `p` in `m`, `b` in `s`; result in `m/s`.")),
        (
            "kernel k(p[3]: m, b: s) = (p, b*dot(p, p));",
            Some("Units: `p` in `m`, `b` in `s`; results in `m`, `s*m**2`."),
        ),
    ] {
        let (theory, errors) = read(kernel);
        assert!(errors.is_empty(), "{kernel}: {errors:?}");
        assert_eq!(sentence(&theory.kernels[0]).as_deref(), wanted, "{kernel}");
    }
}

#[test]
fn kernels_know_their_units() {
    for (kernel, arguments, outputs) in [
        ("kernel k(x) = x**2;", vec!["m"], vec!["m**2"]),
        ("kernel k(a: m, b: s) = a/b;", vec!["m", "s"], vec!["m/s"]),
        ("kernel k(a: m, b: m, cosine: 1): sr/m**2 = cosine/(a*b);", vec!["m", "m", "1"], vec!["sr/m**2"]),
        ("kernel k(a: m, b: s): (m/s, 1) = (a/b, 2);", vec!["m", "s"], vec!["m/s", "1"]),
        ("kernel k(a) = 2*a;", vec!["-"], vec!["-"]),
        ("kernel k(p[2]: m, q[2]: m) = dot(p, q);", vec!["m"; 4], vec!["m**2"]),
        ("kernel k(p[2]: m, b: s) = [p[0]/b, p[1]/b];", vec!["m", "m", "s"], vec!["m/s", "m/s"]),
        ("let mean(a, b) = (a + b)/2; kernel k(a: m, b: m) = mean(a, b);", vec!["m", "m"], vec!["m"]),
        ("let half(a) = a/2; kernel k(a: m, b: s) = half(a)*half(b);", vec!["m", "s"], vec!["m*s"]),
        ("kernel square(a: m): m**2 = a**2; kernel k(b: m) = square(b)/b;", vec!["m"], vec!["m"]),
        ("kernel k(a: m) = sum(a*j, j = 1..3);", vec!["m"], vec!["m"]),
        (
            "kernel walk(p[2]: m, b: s) = p*b; kernel k = value_and_jacobian(walk; b);",
            vec!["m", "m", "s"],
            vec!["m*s", "m*s", "m", "m"],
        ),
    ] {
        let (theory, errors) = read(kernel);
        assert!(errors.is_empty(), "{kernel}: {errors:?}");
        let units = &theory.kernels.last().expect("a kernel").units;
        let shown = |units: &[Option<String>]| {
            units.iter().map(|unit| unit.clone().unwrap_or_else(|| "-".into())).collect::<Vec<_>>()
        };
        assert_eq!(shown(&units.arguments), arguments, "{kernel}");
        assert_eq!(shown(&units.outputs), outputs, "{kernel}");
    }
}
