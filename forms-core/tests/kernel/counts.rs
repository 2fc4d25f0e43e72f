//! Operation counts of kernels, pinned so that they cannot grow unnoticed.

use crate::formula::Formulas;
use forms_core::expression::Expr;
use forms_core::kernel::Program;

/// Returns x dy∧dz + y dz∧dx + z dx∧dy over r³, pulled back by (u, v) ↦ (x, y, z), as the calculus produces it:
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

/// Bilinear patch with corners a, b, c, d, in the usual spellings.
pub(crate) const BILINEAR: [(&str, &str); 5] = [
    ("weights", "(1-u)*(1-v)*a + u*(1-v)*b + (1-u)*v*c + u*v*d"),
    ("differences", "a + u*(b-a) + v*(c-a) + u*v*(d-c-b+a)"),
    ("expanded", "a - u*a - v*a + u*v*a + u*b - u*v*b + v*c - u*v*c + u*v*d"),
    ("nested", "(1-v)*((1-u)*a + u*b) + v*((1-u)*c + u*d)"),
    ("interpolated", "a + u*(b-a) + v*(c + u*(d-c) - (a + u*(b-a)))"),
];

pub(crate) fn bilinear_formulas(spelling: &str) -> (Formulas, Expr) {
    let mut formulas = Formulas::over(CORNERS);
    let result = solid_angle(&mut formulas, &on_each_axis(spelling));
    (formulas, result)
}

pub(crate) fn bilinear(spelling: &str) -> Program {
    let (formulas, result) = bilinear_formulas(spelling);
    formulas.program(&[result])
}

/// Replaces the points a, b, c, d of a formula by their coordinates on each axis.
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

/// Two thirds of the arithmetic is in fused instructions, and few values are live at once.
#[test]
fn the_bilinear_patch_is_fused_and_fits_sixteen_registers() {
    for (name, spelling) in BILINEAR {
        let program = bilinear(spelling).optimise();
        let (fused, live) = (program.operations().fused, program.live_values());
        assert!(fused == 19 && live <= 10, "{name}: {fused} fused, {live} alive");
    }
}

/// Kernel with its maximum cost: arithmetic operations, function calls.
pub(crate) struct Known {
    pub(crate) name: &'static str,
    pub(crate) formulas: Formulas,
    pub(crate) outputs: Vec<Expr>,
    cost: (usize, usize),
}

impl Known {
    fn plain(name: &'static str, variables: &str, outputs: &[&str], cost: (usize, usize)) -> Self {
        let mut formulas = Formulas::over(variables);
        let outputs = outputs.iter().map(|output| formulas.parse(output)).collect();
        Known { name, formulas, outputs, cost }
    }

    /// Returns the solid angle of a surface (u, v) ↦ (x, y, z) per du dv.
    fn surface(name: &'static str, variables: &str, map: [&str; 3], cost: (usize, usize)) -> Self {
        let mut formulas = Formulas::over(variables);
        let outputs = vec![solid_angle(&mut formulas, &map.map(String::from))];
        Known { name, formulas, outputs, cost }
    }

    pub(crate) fn program(&self) -> Program {
        self.formulas.program(&self.outputs)
    }
}

/// Returns kernels of the kinds that the library generates.
pub(crate) fn known_kernels() -> Vec<Known> {
    let plane = on_each_axis("a + u*(b-a) + v*(c-a)");
    let points = ["x", "y", "z"].map(|axis| ["a", "b", "c"].map(|point| format!("{point}{axis}")).join(" "));
    vec![
        Known::plain("x⁷", "x", &["x**7"], (4, 0)),
        Known::plain("x², x³, x⁵", "x", &["x**2", "x**3", "x**5"], (3, 0)),
        Known::plain("inverse powers of r", "x y z", &INVERSE_POWERS, (10, 0)),
        Known::plain("dense polynomial", "x", &["1 + 2*x + 3*x**2 + 4*x**3 + 5*x**4"], (8, 0)),
        Known::plain("polynomial in x and y", "x y", &["x**2*y + x*y**2 + x*y + x + y + 1"], (6, 0)),
        Known::plain("dot product", "ax ay az bx by bz", &["ax*bx + ay*by + az*bz"], (5, 0)),
        Known::plain("cross product", "ax ay az bx by bz", &CROSS_PRODUCT, (9, 0)),
        Known::plain("three quotients", "u v", &THREE_QUOTIENTS, (7, 0)),
        Known::plain("common denominator", "a b c q", &["a/q + b/q - c/q"], (3, 0)),
        Known::plain("common factor", "a b c", &["a*c + b*c - c"], (3, 0)),
        Known::plain("signed sums", "a b c d", &["a - b - c + d", "b - a", "d - c"], (3, 0)),
        Known::plain("thirds", "x y", &["x/3 + y/3"], (2, 0)),
        Known::plain("Henyey–Greenstein", "g c", &[HENYEY_GREENSTEIN], (10, 0)),
        Known::plain("its sampling", "g s", &[HENYEY_GREENSTEIN_SAMPLING], (15, 0)),
        Known::plain("spherical triangle", &points.join(" "), &SPHERICAL_TRIANGLE, (54, 0)),
        Known::plain("determinant", "a b c d e f g h i", &[DETERMINANT], (14, 0)),
        Known::surface("plane z = 1", "u v", ["u", "v", "1"], (7, 0)),
        Known::surface(
            "plane through three points",
            &format!("u v {}", points.join(" ")),
            plane.each_ref().map(String::as_str),
            (40, 0),
        ),
        Known::surface("sphere", "u v R", ["R*sin(u)*cos(v)", "R*sin(u)*sin(v)", "R*cos(u)"], (17, 4)),
    ]
}

const INVERSE_POWERS: [&str; 4] =
    ["1/sqrt(x*x+y*y+z*z)", "1/(x**2+y**2+z**2)", "1/sqrt(x**2+y**2+z**2)**3", "1/sqrt(x**2+y**2+z**2)**5"];
const CROSS_PRODUCT: [&str; 3] = ["ay*bz - az*by", "az*bx - ax*bz", "ax*by - ay*bx"];
const THREE_QUOTIENTS: [&str; 3] = ["u/(u**2+v**2+1)", "v/(u**2+v**2+1)", "1/(u**2+v**2+1)"];
const HENYEY_GREENSTEIN: &str = "(1-g**2)/(4*pi*(1 + g**2 - 2*g*c)**(3/2))";
const HENYEY_GREENSTEIN_SAMPLING: &str = "(2*s + g*(s**2+3) + 2*g**2*s + g**3*(s**2-1))/(2*(1+g*s)**2)";
/// Numerator and denominator of tan(Ω/2).
const SPHERICAL_TRIANGLE: [&str; 2] = [
    "ax*(by*cz-bz*cy) + ay*(bz*cx-bx*cz) + az*(bx*cy-by*cx)",
    "sqrt(ax**2+ay**2+az**2)*sqrt(bx**2+by**2+bz**2)*sqrt(cx**2+cy**2+cz**2) \
     + (ax*bx+ay*by+az*bz)*sqrt(cx**2+cy**2+cz**2) + (ax*cx+ay*cy+az*cz)*sqrt(bx**2+by**2+bz**2) \
     + (bx*cx+by*cy+bz*cz)*sqrt(ax**2+ay**2+az**2)",
];
const DETERMINANT: &str = "a*e*i - a*f*h - b*d*i + b*f*g + c*d*h - c*e*g";

#[test]
fn no_kernel_costs_more_than_it_did() {
    for kernel in known_kernels() {
        let count = kernel.program().optimise().operations();
        let cost = (count.arithmetic(), count.function_calls);
        assert_eq!(cost, kernel.cost, "{}: {count}", kernel.name);
    }
}
