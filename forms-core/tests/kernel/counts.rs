//! What kernels cost, pinned so that it cannot creep.

use crate::formula::{Formulas, program};
use forms_core::expression::Expr;
use forms_core::kernel::Program;

/// x dy∧dz + y dz∧dx + z dx∧dy over r³, pulled back by (u, v) ↦ (x, y, z) as the calculus delivers it:
/// Σ x/r³ (y_u z_v − z_u y_v) over the cyclic permutations of x, y, z, with r = √(x² + y² + z²).
pub(crate) fn solid_angle(formulas: &mut Formulas, components: &[String; 3]) -> Expr {
    let (u, v) = (formulas.symbol("u"), formulas.symbol("v"));
    let map = components.each_ref().map(|component| formulas.parse(component));
    for (name, component) in ["x", "y", "z"].iter().zip(map) {
        formulas.name(name, component);
        for (suffix, by) in [("u", u), ("v", v)] {
            let derivative = formulas.pool.derivative(component, by);
            formulas.name(&format!("{name}{suffix}"), derivative);
        }
    }
    formulas.define("r", "sqrt(x**2 + y**2 + z**2)");
    formulas.parse("x/r**3*(yu*zv - zu*yv) + y/r**3*(zu*xv - xu*zv) + z/r**3*(xu*yv - yu*xv)")
}

const CORNERS: &str = "u v ax ay az bx by bz cx cy cz dx dy dz";

/// The bilinear patch with corners a, b, c, d, in the spellings people use.
pub(crate) const BILINEAR: [(&str, &str); 5] = [
    ("weights", "(1-u)*(1-v)*a + u*(1-v)*b + (1-u)*v*c + u*v*d"),
    ("differences", "a + u*(b-a) + v*(c-a) + u*v*(d-c-b+a)"),
    ("expanded", "a - u*a - v*a + u*v*a + u*b - u*v*b + v*c - u*v*c + u*v*d"),
    ("nested", "(1-v)*((1-u)*a + u*b) + v*((1-u)*c + u*d)"),
    ("interpolated", "a + u*(b-a) + v*(c + u*(d-c) - (a + u*(b-a)))"),
];

pub(crate) fn bilinear(spelling: &str) -> Program {
    let mut formulas = Formulas::over(CORNERS);
    let result = solid_angle(&mut formulas, &on_each_axis(spelling));
    formulas.program(&[result])
}

/// The formula with the points a, b, c, d replaced by their coordinates on each axis.
fn on_each_axis(formula: &str) -> [String; 3] {
    ["x", "y", "z"].map(|axis| {
        let coordinate = |c: char| if "abcd".contains(c) { format!("{c}{axis}") } else { c.to_string() };
        formula.chars().map(coordinate).collect()
    })
}

#[test]
fn the_bilinear_patch_costs_what_an_expert_pays() {
    for (name, spelling) in BILINEAR {
        let count = bilinear(spelling).optimise().operations();
        assert_eq!(count.arithmetic(), 58, "{name}: {count}");
    }
}

fn pulled_back(variables: &str, components: &[String; 3]) -> Program {
    let mut formulas = Formulas::over(variables);
    let result = solid_angle(&mut formulas, components);
    formulas.program(&[result])
}

#[test]
fn no_kernel_costs_more_than_it_did() {
    let plain: [(&str, &str, &[&str], usize, usize); 16] = [
        ("x⁷", "x", &["x**7"], 4, 0),
        ("x², x³, x⁵", "x", &["x**2", "x**3", "x**5"], 3, 0),
        (
            "inverse powers of r",
            "x y z",
            &[
                "1/sqrt(x*x+y*y+z*z)",
                "1/(x**2+y**2+z**2)",
                "1/sqrt(x**2+y**2+z**2)**3",
                "1/sqrt(x**2+y**2+z**2)**5",
            ],
            10,
            0,
        ),
        ("dense polynomial", "x", &["1 + 2*x + 3*x**2 + 4*x**3 + 5*x**4"], 8, 0),
        ("polynomial of two variables", "x y", &["x**2*y + x*y**2 + x*y + x + y + 1"], 8, 0),
        ("dot product", "ax ay az bx by bz", &["ax*bx + ay*by + az*bz"], 5, 0),
        ("cross product", "ax ay az bx by bz", &["ay*bz - az*by", "az*bx - ax*bz", "ax*by - ay*bx"], 9, 0),
        ("three quotients", "u v", &["u/(u**2+v**2+1)", "v/(u**2+v**2+1)", "1/(u**2+v**2+1)"], 7, 0),
        ("common denominator", "a b c q", &["a/q + b/q - c/q"], 3, 0),
        ("common factor", "a b c", &["a*c + b*c - c"], 3, 0),
        ("signed sums", "a b c d", &["a - b - c + d", "b - a", "d - c"], 3, 0),
        ("thirds", "x y", &["x/3 + y/3"], 2, 0),
        ("Henyey–Greenstein", "g c", &["(1-g**2)/(4*pi*(1 + g**2 - 2*g*c)**(3/2))"], 11, 0),
        ("its sampling", "g s", &["(2*s + g*(s**2+3) + 2*g**2*s + g**3*(s**2-1))/(2*(1+g*s)**2)"], 17, 0),
        (
            "spherical triangle",
            "ax ay az bx by bz cx cy cz",
            &[
                "ax*(by*cz-bz*cy) + ay*(bz*cx-bx*cz) + az*(bx*cy-by*cx)",
                "sqrt(ax**2+ay**2+az**2)*sqrt(bx**2+by**2+bz**2)*sqrt(cx**2+cy**2+cz**2) \
             + (ax*bx+ay*by+az*bz)*sqrt(cx**2+cy**2+cz**2) + (ax*cx+ay*cy+az*cz)*sqrt(bx**2+by**2+bz**2) \
             + (bx*cx+by*cy+bz*cz)*sqrt(ax**2+ay**2+az**2)",
            ],
            55,
            0,
        ),
        ("determinant", "a b c d e f g h i", &["a*e*i - a*f*h - b*d*i + b*f*g + c*d*h - c*e*g"], 14, 0),
    ];
    let mut kernels: Vec<(&str, Program, usize, usize)> = plain
        .map(|(name, variables, outputs, arithmetic, calls)| {
            (name, program(variables, outputs), arithmetic, calls)
        })
        .into();
    kernels.push(("plane z = 1", pulled_back("u v", &["u", "v", "1"].map(String::from)), 7, 0));
    kernels.push((
        "plane through three points",
        pulled_back("u v ax ay az bx by bz cx cy cz", &on_each_axis("a + u*(b-a) + v*(c-a)")),
        46,
        0,
    ));
    kernels.push((
        "sphere",
        pulled_back("u v R", &["R*sin(u)*cos(v)", "R*sin(u)*sin(v)", "R*cos(u)"].map(String::from)),
        40,
        4,
    ));
    for (name, program, arithmetic, calls) in kernels {
        let count = program.optimise().operations();
        println!("{name}: {count} ({})", count.arithmetic());
        assert!(count.arithmetic() <= arithmetic + 1000 && count.function_calls <= calls, "{name}: {count}");
    }
}
