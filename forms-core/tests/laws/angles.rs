//! Laws of angles: corners of regular polygons, inverse functions of functions, relations between
//! inverse functions on boxes. Each is compared with an evaluation in plain arithmetic; variants of
//! the prover that ignore the branch are rejected.

use forms_core::decide::{Verdict, decide};
use forms_core::enclosure::{Enclosure, Precision, enclose};
use forms_core::expression::{Expr, Operation, Pool, Rational, Symbol};
use forms_core::kernel::evaluate_f64;
use forms_core::normal::{Tower, Trigonometry, normalise};
use forms_core::resolve::resolve;
use forms_core::syntax::read;
use forms_core::theory::{Theory, Value};

fn theory_of(statement: &str) -> Theory {
    let text = format!("chart R3(x, y, z); prove it: {statement};");
    let (file, errors) = read(&text);
    assert_eq!(errors, [], "{text}");
    let (theory, errors) = resolve(&file);
    assert_eq!(errors, [], "{text}");
    theory
}

fn verdict(statement: &str) -> Verdict {
    let mut theory = theory_of(statement);
    let statement = theory.statements[0].clone();
    decide(&mut theory, &statement)
}

fn through_normal_form(pool: &mut Pool, expression: Expr) -> Expr {
    let mut tower = Tower::new(Trigonometry::Circle);
    let prepared = normalise(&mut tower, pool, &[expression]).unwrap();
    let normal = prepared.exact(&mut tower, pool).unwrap().remove(0);
    tower.raise(pool, &normal)
}

fn value(pool: &Pool, expression: Expr) -> Enclosure {
    enclose(pool, &[expression], &|_| None, &mut |_, _, _| None, Precision(200)).remove(0).unwrap()
}

/// Returns left − right at a point.
fn difference(theory: &mut Theory, point: [f64; 2]) -> f64 {
    let statement = theory.statements[0].clone();
    let (Value::Scalar(left), Value::Scalar(right)) = (&statement.left, &statement.right) else {
        panic!("both sides are scalars")
    };
    let place: Vec<(Symbol, f64)> = theory.coordinates.iter().copied().zip(point).collect();
    let values = evaluate_f64(&theory.pool, &[*left, *right], &place).unwrap();
    values[0] - values[1]
}

#[test]
fn the_corners_of_a_polygon_are_the_values_of_its_angles() {
    let mut pool = Pool::new();
    for sides in [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 18, 20, 21, 24, 25, 27, 30, 36, 60] {
        for times in [1, 2, 3, 5, 7, 11, -4, 2 * sides + 1] {
            let pi = pool.pi();
            let part = pool.number(Rational::new(times.into(), sides.into()));
            let angle = pool.multiply(part, pi);
            for operation in [Operation::Sin, Operation::Cos] {
                let written = pool.apply(operation, &[angle]);
                let radicals = through_normal_form(&mut pool, written);
                assert_ne!(written, radicals, "{operation:?} {times}/{sides} has a value by roots");
                let (a, b) = (value(&pool, written), value(&pool, radicals));
                assert!(a.intersects(&b), "{operation:?} {times}/{sides}: {}", pool.text(radicals));
                assert!(a.width().max(b.width()) < Rational::new(1.into(), (1u64 << 60).into()));
            }
        }
    }
}

#[test]
fn the_corners_of_a_polygon_add_up_to_zero() {
    for sides in [2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 15] {
        let sum = |function: &str| {
            let corners: Vec<String> =
                (0..sides).map(|k| format!("{function}(x + 2*pi*{k}/{sides})")).collect();
            format!("{} == 0", corners.join(" + "))
        };
        assert_eq!(verdict(&sum("sin")).name(), "proved", "{sides}");
        assert_eq!(verdict(&sum("cos")).name(), "proved", "{sides}");
        let one_missing = format!("{} - sin(x)", sum("sin").replace(" == 0", "")) + " == 0";
        assert_eq!(verdict(&one_missing).name(), "refuted", "{sides}");
    }
}

/// For functions f and inverse functions g, g(f(x)) = ±x + kπ on each interval between multiples of
/// π/2.
#[test]
fn an_inverse_function_of_a_function_is_proved_on_the_right_branch_and_refuted_on_the_others() {
    let pairs = ["asin(sin(x))", "acos(cos(x))", "atan(tan(x))", "atan2(sin(x), cos(x))", "acos(sin(x))"];
    for composed in pairs {
        for quarter in -4..4 {
            let inside = (f64::from(quarter) + 0.37) * std::f64::consts::FRAC_PI_2;
            for (sign, shift) in
                [-2, -1, 0, 1, 2].into_iter().flat_map(|k| [(1, 2 * k), (-1, 2 * k), (-1, 2 * k + 1)])
            {
                let statement = format!(
                    "{composed} == {sign}*x + {shift}*pi/2 where {quarter}*pi/2 < x, x < {}*pi/2",
                    quarter + 1
                );
                let mut theory = theory_of(&statement);
                let holds = difference(&mut theory, [inside, 0.0]).abs() < 1e-9;
                let expected = if holds { "proved" } else { "refuted" };
                let found = verdict(&statement);
                assert_eq!(found.name(), expected, "{statement}: {found:?}");
            }
        }
    }
}

/// Relations between inverse functions; `K` is the number of half turns between the sides.
const RELATIONS: &[&str] = &[
    "atan(x) + atan(y) == atan((x + y)/(1 - x*y)) + K*pi",
    "atan(x) - atan(y) == atan((x - y)/(1 + x*y)) + K*pi",
    "atan2(y, x) == atan(y/x) + K*pi",
    "atan2(y, x) == 2*atan(y/(sqrt(x**2 + y**2) + x)) + K*pi",
    "atan2(y, x) + atan2(x, y) == pi/2 + K*pi",
    "atan(x/y) + atan(y/x) == pi/2 + K*pi",
    "2*atan(x) == atan(2*x/(1 - x**2)) + K*pi",
    "atan2(x, -y) - atan2(y, x) == pi/2 + K*pi",
    "atan2(y, x) - atan2(1, 2) == atan2(2*y - x, 2*x + y) + K*pi",
];

/// Boxes in the plane, as the ends of x and of y.
const BOXES: &[[i64; 4]] = &[
    [0, 1, 0, 1],
    [1, 3, 1, 3],
    [-1, 0, 0, 1],
    [-3, -1, 1, 3],
    [-3, -1, -3, -1],
    [0, 2, -2, 0],
    [-2, 2, -2, 2],
    [1, 3, -3, 3],
];

#[test]
fn relations_between_inverse_functions_have_the_verdict_of_their_box() {
    let mut counts = [0; 3];
    for relation in RELATIONS {
        for [x0, x1, y0, y1] in BOXES {
            for half_turns in -1..=1 {
                let relation = relation.replace('K', &half_turns.to_string());
                let statement = format!("{relation} where {x0} < x, x < {x1}, {y0} < y, y < {y1}");
                let mut theory = theory_of(&statement);
                let share = |from: &i64, to: &i64, part: f64| *from as f64 + part * (to - from) as f64;
                let mut holds = true;
                for (p, q) in
                    [(0.13, 0.17), (0.13, 0.91), (0.83, 0.23), (0.87, 0.79), (0.31, 0.61), (0.57, 0.43)]
                {
                    let gap = difference(&mut theory, [share(x0, x1, p), share(y0, y1, q)]);
                    holds &= gap.is_nan() || gap.abs() < 1e-9;
                }
                match verdict(&statement) {
                    Verdict::Proved(_) => assert!(holds, "{statement} is proved"),
                    Verdict::Refuted(witness) => assert!(!holds, "{statement} is refuted at {witness}"),
                    Verdict::Unknown { .. } => counts[2] += 1,
                    Verdict::Empty { reason } => panic!("{statement} is not empty: {reason}"),
                }
                counts[usize::from(!holds)] += 1;
            }
        }
    }
    let [holding, failing, unknown] = counts;
    println!("{holding} hold, {failing} fail, {unknown} unknown");
    assert!(20 * unknown <= holding + failing, "{unknown} of {} are unknown", holding + failing);
}

/// Statements that a prover of angles would prove if it omitted part of its argument.
#[test]
fn neither_the_sine_nor_the_turn_nor_the_range_of_a_difference_is_enough() {
    let sine_vanishes = |angle: &str| verdict(&format!("sin({angle}) == 0"));
    let full_turn = |angle: &str| verdict(&format!("cos({angle}) == 1"));
    // without the cosine: an angle of π
    let half_turn = "atan2(y, x) - atan(y/x)";
    assert_eq!(sine_vanishes(half_turn).name(), "proved");
    assert_eq!(full_turn(half_turn).name(), "refuted");
    assert_eq!(verdict(&format!("{half_turn} == 0")).name(), "refuted");
    // without the range: an angle of 2π
    for angle in ["4*atan(1/5) - atan(1/239) - pi/4 + 2*pi", "atan2(sin(x), cos(x)) - x"] {
        assert_eq!(sine_vanishes(angle).name(), "proved", "{angle}");
        assert_eq!(full_turn(angle).name(), "proved", "{angle}");
        assert_eq!(verdict(&format!("{angle} == 0")).name(), "refuted", "{angle}");
    }
    // without the algebra: an angle that is small but not 0
    let small = "atan(1/1000) - asin(1/1000)";
    assert_eq!(sine_vanishes(small).name(), "refuted");
    assert_eq!(verdict(&format!("{small} == 0")).name(), "refuted");
}

#[test]
fn a_sign_that_rests_on_an_open_sign_constrains_nothing() {
    // u − 1 has a root only once its sign is known to be negative
    let statement =
        "1/sqrt(1 + (y*sqrt(x/(1 - x)))**2) == sqrt(1 - x)/sqrt(1 + (y**2 - 1)*x) where 0 < x, x < 1, y > 0";
    assert_eq!(verdict(statement).name(), "proved");
    assert_eq!(verdict(&statement.replace("y**2 - 1", "y**2 + 1")).name(), "refuted");
}
