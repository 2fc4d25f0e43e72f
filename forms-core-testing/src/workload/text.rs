//! Workloads from text to verdict: statements that hold, each read, resolved and decided.

use super::Work;
use super::random::Random;
use forms_core::decide::decide;
use forms_core::resolve::resolve;
use forms_core::syntax::read;

/// Returns the workload of proving the only statement of a text.
fn proof(name: impl Into<String>, goal: &'static str, text: String) -> Work {
    Work::new(name, goal, move || {
        let (file, errors) = read(&text);
        assert!(errors.is_empty(), "{errors:?}");
        let (mut theory, errors) = resolve(&file);
        assert!(errors.is_empty(), "{errors:?}");
        let statement = theory.statements[0].clone();
        assert_eq!(decide(&mut theory, &statement).name(), "proved", "{text}");
    })
}

/// d(Σ (−1)ⁱ xᵢ/rⁿ dx₁∧…(without dxᵢ)…∧dxₙ) = 0
pub fn closed(n: usize) -> Work {
    let names: Vec<String> = (0..n).map(|i| format!("x{i}")).collect();
    let squares: Vec<String> = names.iter().map(|name| format!("{name}**2")).collect();
    let terms: Vec<String> = (0..n)
        .map(|place| {
            let others: Vec<String> = (0..n).filter(|i| *i != place).map(|i| format!("dx{i}")).collect();
            format!("{} x{place}*{}", if place % 2 == 0 { "+" } else { "-" }, others.join("^"))
        })
        .collect();
    let text = format!(
        "chart R({}) where {squares} > 0; prove closed: d(({sum})/sqrt({squares})**{n}) == 0;",
        names.join(", "),
        sum = terms.join(" ").trim_start_matches("+ "),
        squares = squares.join(" + ")
    );
    proof(format!("d of the solid angle in R{n}, text"), if n <= 8 { "100 µs" } else { "" }, text)
}

/// ⋆⋆w = (−1)^(k(n−k)) w for a random k-form under a random metric Σ cᵢ θᵢ² with θᵢ = dxᵢ + Σ_{j>i} lᵢⱼ dxⱼ.
pub fn two_stars(n: usize, k: usize) -> Work {
    let mut random = Random::new((n * 8 + k) as u64);
    let names = &["x", "y", "z", "w"][..n];
    let squares: Vec<String> = (0..n)
        .map(|i| {
            let others: String =
                (i + 1..n).map(|j| format!(" + {}*d{}", random.pick(names), names[j])).collect();
            format!("(1 + {}**2)*(d{}{others})**2", random.pick(names), names[i])
        })
        .collect();
    let terms: Vec<String> = subsets(n, k)
        .into_iter()
        .map(|subset| {
            let blade: Vec<String> = subset.iter().map(|&i| format!("d{}", names[i])).collect();
            format!(
                "({} - {}*{})*{}",
                random.pick(names),
                random.pick(names),
                random.pick(names),
                blade.join("^")
            )
        })
        .collect();
    let text = format!(
        "chart C({}); metric g on C = {}; form a: {k} on C = {}; prove s: hodge[g](hodge[g](a)) == {}a;",
        names.join(", "),
        squares.join(" + "),
        terms.join(" + "),
        if (k * (n - k)).is_multiple_of(2) { "" } else { "-" }
    );
    proof(format!("⋆⋆ of a {k}-form, random metric, n = {n}"), "", text)
}

/// Returns the subsets of k numbers below n.
fn subsets(n: usize, k: usize) -> Vec<Vec<usize>> {
    let masks = (0..1u32 << n).filter(|mask| mask.count_ones() as usize == k);
    masks.map(|mask| (0..n).filter(|i| mask >> i & 1 == 1).collect()).collect()
}

/// d⋆df of an unknown function in spherical coordinates.
pub fn spherical_laplacian() -> Work {
    let text = "chart S(r, theta, phi) where r > 0, theta > 0, theta < pi; fn f(r, theta, phi);\
        metric g on S = dr**2 + r**2*dtheta**2 + r**2*sin(theta)**2*dphi**2;\
        prove s: d(hodge[g](d(f))) == (diff(r**2*diff(f, r), r)*sin(theta) + diff(sin(theta)*diff(f, theta), theta)\
        + diff(diff(f, phi), phi)/sin(theta))*dr^dtheta^dphi;";
    proof("d⋆df in spherical coordinates", "", text.into())
}

/// Cartan: L_X w = i_X dw + d i_X w for a random field and a random 2-form.
pub fn lie_derivative(n: usize) -> Work {
    let mut random = Random::new(n as u64);
    let names: Vec<String> = (0..n).map(|i| format!("x{i}")).collect();
    let mut monomials = |count: usize| -> String {
        let terms: Vec<String> = (0..count)
            .map(|_| {
                let [a, b, c] = [0; 3].map(|_| random.pick(&names).clone());
                format!("{}*{a}*{b}*{c}", random.below(9) + 1)
            })
            .collect();
        terms.join(" + ")
    };
    let field: Vec<String> = names.iter().map(|name| format!("({})*@{name}", monomials(2))).collect();
    let form: Vec<String> = subsets(n, 2)
        .into_iter()
        .map(|pair| format!("({})*dx{}^dx{}", monomials(3), pair[0], pair[1]))
        .collect();
    let text = format!(
        "chart R({}); field X on R = {}; form w: 2 on R = {};\
         prove cartan: lie(X, w) == interior(X, d(w)) + d(interior(X, w));",
        names.join(", "),
        field.join(" + "),
        form.join(" + ")
    );
    proof(format!("L_X of a random 2-form by Cartan, n = {n}"), "", text)
}

/// d commutes with the pullback of a generic 2-form by a polynomial map.
pub fn polynomial_pullback() -> Work {
    let names = ["x", "y", "z", "w"];
    let pairs = subsets(4, 2);
    let functions: String = pairs.iter().map(|p| format!("fn a{}{}(x, y, z, w);", p[0], p[1])).collect();
    let form: Vec<String> =
        pairs.iter().map(|p| format!("a{0}{1}*d{2}^d{3}", p[0], p[1], names[p[0]], names[p[1]])).collect();
    let text = format!(
        "chart R4(x, y, z, w); chart R3(u, v, t); {functions} form b: 2 on R4 = {};\
         map F: R3 -> R4 = (u**2 - v*t, u*v*t + v**2, t**3 - u*v, u + v**2*t);\
         prove s: d(pullback(F, b)) == pullback(F, d(b));",
        form.join(" + ")
    );
    proof("pullback of a generic 2-form by a cubic map", "", text)
}

/// ∫ (x + y + z)¹² over the unit box, a difference of third order of s¹⁵/(13·14·15).
pub fn box_integral() -> Work {
    let text = "chart R3(x, y, z);\
        prove s: integral((x + y + z)**12, x = 0..1, y = 0..1, z = 0..1) == (3**15 - 3*2**15 + 3)/2730;";
    proof("∫(x+y+z)¹² over a box", "", text.into())
}

/// The period of the solid-angle form.
pub fn sphere_integral() -> Work {
    let text = "chart R3(x, y, z); chart S(theta, phi); param R where R > 0;\
        form beta: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy)/(x**2 + y**2 + z**2)**(3/2);\
        map sphere: S -> R3 = (R*sin(theta)*cos(phi), R*sin(theta)*sin(phi), R*cos(theta));\
        prove s: integral(pullback(sphere, beta), theta = 0..pi, phi = 0..2*pi) == 4*pi;";
    proof("∫β over the sphere", "", text.into())
}

/// Common beginning of the statements about a triangle with its corners on the axes.
const TRIANGLE: &str = "chart R3(x, y, z) where x > 0, y > 0, z > 0;\
    param a, b, c where a > 0, b > 0, c > 0;\
    metric g on R3 = dx**2 + dy**2 + dz**2;\
    let ra = sqrt((a - x)**2 + y**2 + z**2);\
    let rb = sqrt(x**2 + (b - y)**2 + z**2);\
    let rc = sqrt(x**2 + y**2 + (c - z)**2);\
    let ab = -x*(a - x) - y*(b - y) + z**2;\
    let bc = x**2 - y*(b - y) - z*(c - z);\
    let ca = -x*(a - x) + y**2 - z*(c - z);\
    let N = a*b*c - b*c*x - a*c*y - a*b*z;\
    let D = ra*rb*rc + ab*rc + bc*ra + ca*rb;\
    let eab = (ra + rb)/(ra*rb*(ra*rb + ab));\
    let ebc = (rb + rc)/(rb*rc*(rb*rc + bc));\
    let eca = (rc + ra)/(rc*ra*(rc*ra + ca));";

/// The solid angle of a triangle is harmonic: the flux of its gradient is closed.
pub fn harmonicity() -> Work {
    let text = format!("{TRIANGLE} prove s: d(hodge[g](d(2*atan2(N, D)))) == 0;");
    proof("d⋆dΩ = 0, Ω the solid angle of a triangle", "50 ms", text)
}

/// The same statement by the Laplacian of one arc tangent, which divides by D.
pub fn harmonicity_of_arc_tangent() -> Work {
    let text = format!("{TRIANGLE} prove s: laplace[g](2*atan(N/D)) == 0;");
    proof("Δ(2 atan(N/D)) = 0 for the same triangle", "50 ms", text)
}

/// The gradient of this solid angle is a sum over the edges (Biot–Savart).
pub fn triangle_gradient() -> Work {
    let text = format!(
        "{TRIANGLE} prove s: d(2*atan(N/D)) == eab*(b*z*dx + a*z*dy + (a*b - b*x - a*y)*dz)\
         + ebc*((b*c - c*y - b*z)*dx + c*x*dy + b*x*dz) + eca*(c*y*dx + (a*c - a*z - c*x)*dy + a*y*dz);"
    );
    proof("dΩ as a sum over the edges", "20 ms", text)
}
