//! Signs of sines and cosines by the ranges of their angles, compared with signs in plain
//! arithmetic; arguments of inverse functions.

use super::verdicts;
use std::f64::consts::PI;

const PREAMBLE: &str = "chart Plane(x, y); chart Line(q) where -1 < q < 1;";

fn assert_verdicts(expected: &str, statements: &[&str]) {
    verdicts::assert_verdicts(PREAMBLE, expected, statements);
}

/// Sine or cosine in plain arithmetic.
type Wave = fn(f64) -> f64;

/// Whether ±f(kx + jπ/4) is nowhere negative from aπ/12 to bπ/12.
fn never_negative(f: Wave, sign: f64, (k, j): (i32, i32), (a, b): (i32, i32)) -> bool {
    (0..=240).all(|step| {
        let twelfths = f64::from(a) + f64::from(b - a) * f64::from(step) / 240.0;
        sign * f(f64::from(k) * twelfths * PI / 12.0 + f64::from(j) * PI / 4.0) > -1e-9
    })
}

/// Every range has one of four outcomes for each sine or cosine; a claim that holds is proved, any
/// other is refuted.
#[test]
fn a_wave_is_its_magnitude_exactly_where_it_is_not_negative() {
    let waves: [(&str, Wave); 2] = [("sin", f64::sin), ("cos", f64::cos)];
    let ranges =
        [(0, 6), (0, 3), (-6, 6), (-3, 3), (3, 9), (6, 18), (12, 24), (0, 4), (-4, 2), (1, 5), (0, 18)];
    let mut counts = [0, 0];
    for (name, f) in waves {
        for angle in [(1, 0), (2, 0), (3, 0), (1, 1), (2, -1), (4, 0)] {
            for range in ranges {
                for (text, sign) in [("", 1.0), ("-", -1.0)] {
                    let ((k, j), (a, b)) = (angle, range);
                    let wave = format!("{name}({k}*x + {j}*pi/4)");
                    let statement = format!("abs({wave}) == {text}{wave} where {a}*pi/12 <= x <= {b}*pi/12");
                    let holds = never_negative(f, sign, angle, range);
                    assert_verdicts(if holds { "proved" } else { "refuted" }, &[&statement]);
                    counts[usize::from(holds)] += 1;
                }
            }
        }
    }
    assert!(counts.iter().all(|count| *count > 30), "{counts:?}");
}

#[test]
fn signs_of_sums_follow_from_what_bounds_them() {
    assert_verdicts(
        "proved",
        &[
            "abs(sin(x + y)) == sin(x + y) where 0 < x + y < pi",
            "abs(cos(x - y)) == -cos(x - y) where pi/2 <= x - y <= 3*pi/2",
            "sqrt(1 + sin(2*x)) == sin(x) + cos(x) where -pi/4 <= x <= 3*pi/4",
            "sqrt(1 - sin(2*x)) == cos(x) - sin(x) where -3*pi/4 <= x <= pi/4",
            "asin(sin(x)) == pi - x where pi/2 <= x <= 3*pi/2",
            "acos(cos(x)*cos(y) + sin(x)*sin(y)) == x - y where 0 <= x - y <= pi",
            "acos(4*cos(x)**3 - 3*cos(x)) == 3*x where 0 <= x <= pi/3",
        ],
    );
    assert_verdicts(
        "refuted",
        &[
            "abs(sin(x + y)) == sin(x + y) where 0 < x + y < 4",
            "sqrt(1 + sin(2*x)) == sin(x) + cos(x) where -pi/4 <= x <= 5*pi/6",
            "asin(sin(x)) == pi - x where pi/3 <= x <= 3*pi/2",
            "acos(cos(x)*cos(y) + sin(x)*sin(y)) == x - y where -1 <= x - y <= pi",
            "acos(4*cos(x)**3 - 3*cos(x)) == 3*x where 0 <= x <= pi/2",
        ],
    );
}

#[test]
fn parts_of_inverse_functions_solve_their_equations() {
    assert_verdicts(
        "proved",
        &[
            "4*cos(acos(q)/3)**3 - 3*cos(acos(q)/3) == q",
            "3*sin(asin(q)/3) - 4*sin(asin(q)/3)**3 == q",
            "(3*tan(atan(x)/3) - tan(atan(x)/3)**3)/(1 - 3*tan(atan(x)/3)**2) == x",
            "16*cos(acos(q)/5)**5 - 20*cos(acos(q)/5)**3 + 5*cos(acos(q)/5) == q",
            "cos(acos(q)/3) + cos((acos(q) + 2*pi)/3) + cos((acos(q) + 4*pi)/3) == 0",
            "cos(acos(q)/3)*cos((acos(q) + 2*pi)/3)*cos((acos(q) + 4*pi)/3) == q/4",
            "sin(asin(q)/3) == cos(acos(q)/3 + pi/3)",
            "4*cos(acos(2*x + y)/3)**3 - 3*cos(acos(2*x + y)/3) == 2*x + y",
            "8*cos(acos(q)/6)**2 - 4 == 4*cos(acos(q)/3)",
        ],
    );
    assert_verdicts(
        "refuted",
        &[
            "4*cos(acos(q)/3)**3 - 3*cos(acos(q)/3) == -q",
            "3*sin(asin(q)/3) - 4*sin(asin(q)/3)**3 == q**2",
            "sin(asin(q)/3) == cos(acos(q)/3 + pi/6)",
            "cos(acos(q)/3)*cos((acos(q) + 2*pi)/3)*cos((acos(q) + 4*pi)/3) == q/8",
            "cos(acos(q)/3) == q**(1/3) where q > 0",
        ],
    );
}
