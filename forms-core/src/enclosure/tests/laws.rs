//! Containment: a point of the box is mapped to a point of the image, and identities of analysis
//! hold within the width.

use super::{at, exact, unit};
use crate::enclosure::{Enclosure, Precision, Undecided};
use crate::expression::{Operation, Rational};
use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::One;
use proptest::prelude::*;

/// Boxes are computed at a low precision and points at a high one, so that the true value is sharp
/// compared with the box.
const LOW: Precision = Precision(48);
const HIGH: Precision = Precision(192);

type Decided = Result<Enclosure, Undecided>;
type Function<'a> = &'a dyn Fn(&[Enclosure]) -> Decided;

/// x ∈ X ⇒ f(x) ∈ f(X): a box with an image contains only points with values, and these lie in the
/// image. An undefined box contains only undefined points, and a box that is too large contains no
/// point with a value.
fn respects_inclusion(boxed: Function, truth: Function, ends: &[[Rational; 2]], share: &Rational) -> bool {
    let boxes: Vec<Enclosure> = ends.iter().map(|[a, b]| Enclosure::between(a, b, LOW)).collect();
    let points: Vec<Enclosure> =
        ends.iter().map(|[a, b]| Enclosure::exact(&(a + (b - a) * share), HIGH)).collect();
    match (boxed(&boxes), truth(&points)) {
        (Ok(image), Ok(value)) => image.encloses(&value),
        (Ok(_), Err(_)) => false,
        (Err(Undecided::Undefined), value) => value == Err(Undecided::Undefined),
        (Err(Undecided::TooLarge), value) => value.is_err(),
        (Err(Undecided::Unknown), _) => true,
    }
}

const ENDS: [(i64, i64); 12] =
    [(-22, 7), (-3, 2), (-1, 1), (-1, 3), (-1, 7), (0, 1), (1, 9), (1, 2), (2, 3), (5, 4), (9, 4), (31, 5)];

/// Whether the law fails on one of a fixed family of boxes, at an end or at a point inside.
fn is_rejected(boxed: Function, truth: Function, arity: usize) -> bool {
    let shares = [exact(0, 1), exact(1, 3), exact(1, 1)];
    let rational = |(n, d): (i64, i64)| exact(n, d);
    let sides: Vec<[Rational; 2]> = (0..ENDS.len())
        .flat_map(|i| (i..ENDS.len()).step_by(2).map(move |j| [rational(ENDS[i]), rational(ENDS[j])]))
        .collect();
    let fails =
        |ends: &[[Rational; 2]]| shares.iter().any(|share| !respects_inclusion(boxed, truth, ends, share));
    match arity {
        1 => sides.iter().any(|side| fails(std::slice::from_ref(side))),
        _ => sides.iter().any(|a| sides.iter().step_by(3).any(|b| fails(&[a.clone(), b.clone()]))),
    }
}

const OPERATIONS: [Operation; 22] = [
    Operation::Sin,
    Operation::Cos,
    Operation::Tan,
    Operation::Asin,
    Operation::Acos,
    Operation::Atan,
    Operation::Exp,
    Operation::Log,
    Operation::Sinh,
    Operation::Cosh,
    Operation::Tanh,
    Operation::Abs,
    Operation::Expm1,
    Operation::Log1p,
    Operation::Erf,
    Operation::Expint1,
    Operation::Expint2,
    Operation::Expint3,
    Operation::Dilog,
    Operation::Clausen,
    Operation::Erfc,
    Operation::Cbrt,
];

const EXPONENTS: [(i64, i64); 9] =
    [(1, 1), (2, 1), (3, 1), (-1, 1), (-2, 1), (1, 2), (2, 3), (-5, 3), (1, 97)];

const PAIRS: [(&str, Function<'static>); 6] = [
    ("sum", &|q| Ok(q[0].add(&q[1]))),
    ("difference", &|q| Ok(q[0].sub(&q[1]))),
    ("product", &|q| Ok(q[0].mul(&q[1]))),
    ("quotient", &|q| q[0].div(&q[1])),
    ("angle", &|q| Enclosure::atan2(&q[0], &q[1])),
    ("hypotenuse", &|q| Enclosure::hypot(&q[0], &q[1])),
];

#[test]
fn images_of_boxes_contain_images_of_points() {
    for operation in OPERATIONS {
        let f = |q: &[Enclosure]| Enclosure::apply(operation, q);
        assert!(!is_rejected(&f, &f, 1), "{operation:?}");
    }
    for (a, b) in EXPONENTS {
        let f = |q: &[Enclosure]| q[0].power(Ratio::new(a, b));
        assert!(!is_rejected(&f, &f, 1), "power {a}/{b}");
    }
    for (name, f) in PAIRS {
        assert!(!is_rejected(f, f, 2), "{name}");
    }
}

/// Returns the largest interval inside with ends n·2⁻²⁰, which is rounding in the wrong direction.
fn rounded_inward(value: Enclosure) -> Enclosure {
    let scale = Rational::from_integer(BigInt::one() << 20);
    let lower = (value.lower() * &scale).ceil() / &scale;
    let upper = (value.upper() * &scale).floor() / &scale;
    Enclosure::between(&lower, &upper, LOW)
}

#[test]
fn rounding_inward_is_rejected() {
    for operation in OPERATIONS.into_iter().filter(|&operation| operation != Operation::Abs) {
        let f = |q: &[Enclosure]| Enclosure::apply(operation, q);
        assert!(is_rejected(&|q| f(q).map(rounded_inward), &f, 1), "{operation:?}");
    }
    for (name, f) in PAIRS {
        assert!(is_rejected(&|q| f(q).map(rounded_inward), f, 2), "{name}");
    }
}

/// Evaluates f at the ends of the box only, as if it were monotone.
fn ends_only(f: Function, q: &[Enclosure]) -> Decided {
    let end = |value: fn(&Enclosure) -> Rational| -> Vec<Enclosure> {
        q.iter().map(|side| Enclosure::exact(&value(side), LOW)).collect()
    };
    Ok(f(&end(Enclosure::lower))?.hull(&f(&end(Enclosure::upper))?))
}

#[test]
fn forgetting_what_happens_between_the_ends_is_rejected() {
    for operation in
        [Operation::Sin, Operation::Cos, Operation::Tan, Operation::Cosh, Operation::Abs, Operation::Clausen]
    {
        let f = |q: &[Enclosure]| Enclosure::apply(operation, q);
        assert!(is_rejected(&|q| ends_only(&f, q), &f, 1), "{operation:?}");
    }
    let square = |q: &[Enclosure]| q[0].power(2.into());
    assert!(is_rejected(&|q| ends_only(&square, q), &square, 1));
    for (name, f) in &PAIRS[1..] {
        assert!(is_rejected(&|q| ends_only(f, q), f, 2), "{name}");
    }
}

#[test]
fn forgetting_a_domain_is_rejected() {
    let sqrt = |q: &[Enclosure]| q[0].sqrt();
    assert!(is_rejected(&|q| q[0].abs().sqrt(), &sqrt, 1));
    let log = |q: &[Enclosure]| q[0].log();
    assert!(is_rejected(&|_| Err(Undecided::Undefined), &log, 1));
}

/// A rational with numerator and denominator up to a thousand.
fn rational() -> impl Strategy<Value = Rational> {
    (-1000i64..=1000, 1i64..=1000).prop_map(|(n, d)| exact(n, d))
}

/// Whether two values may be equal although both are known to about the given number of places.
fn agree(a: &Enclosure, b: &Enclosure, places: u32) -> bool {
    a.intersects(b) && a.width() <= unit(places) && b.width() <= unit(places)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn random_boxes_contain_their_points(a in rational(), b in rational(), n in 0i64..=16) {
        for operation in OPERATIONS {
            let f = |q: &[Enclosure]| Enclosure::apply(operation, q);
            prop_assert!(respects_inclusion(&f, &f, &[[a.clone(), b.clone()]], &exact(n, 16)), "{:?}", operation);
        }
        for (s, t) in EXPONENTS {
            let f = |q: &[Enclosure]| q[0].power(Ratio::new(s, t));
            prop_assert!(respects_inclusion(&f, &f, &[[a.clone(), b.clone()]], &exact(n, 16)), "power {}/{}", s, t);
        }
    }

    #[test]
    fn random_pairs_of_boxes_contain_their_points(
        q in [rational(), rational(), rational(), rational()],
        n in 0i64..=16,
    ) {
        let [a, b, c, d] = q;
        for (name, f) in PAIRS {
            let sides = [[a.clone(), b.clone()], [c.clone(), d.clone()]];
            prop_assert!(respects_inclusion(f, f, &sides, &exact(n, 16)), "{}", name);
        }
    }

    #[test]
    fn a_low_precision_encloses_a_high_one(q in rational(), low in 8u32..100) {
        let (coarse, fine) = (Enclosure::exact(&q, Precision(low)), Enclosure::exact(&q, Precision(300)));
        for operation in OPERATIONS {
            let f = |x: &Enclosure| Enclosure::apply(operation, std::slice::from_ref(x));
            match (f(&coarse), f(&fine)) {
                (Ok(coarse), Ok(fine)) => {
                    prop_assert!(coarse.encloses(&fine), "{:?} at {} bits", operation, low);
                    prop_assert!(fine.is_exact() || operation == Operation::Tan
                        || fine.width() <= unit(300) * exact(2, 1), "{:?}", operation);
                }
                (coarse, fine) => prop_assert!(coarse == Err(Undecided::Unknown) || coarse.err() == fine.err()),
            }
        }
    }

    #[test]
    fn squares_of_sine_and_cosine_add_to_one(q in rational(), p in 20u32..300) {
        let q = Enclosure::exact(&q, Precision(p));
        let sum = q.sin().power(2.into()).unwrap().add(&q.cos().power(2.into()).unwrap());
        prop_assert!(sum.contains(&exact(1, 1)) && sum.width() <= unit(p - 10));
    }

    #[test]
    fn sine_and_exponential_obey_their_addition_theorems(a in rational(), b in rational()) {
        let (x, y) = (Enclosure::exact(&a, HIGH), Enclosure::exact(&b, HIGH));
        let sum = x.sin().mul(&y.cos()).add(&x.cos().mul(&y.sin()));
        prop_assert!(agree(&x.add(&y).sin(), &sum, HIGH.0 - 5));
        let (x, y) = (Enclosure::exact(&(a / exact(100, 1)), HIGH), Enclosure::exact(&(b / exact(100, 1)), HIGH));
        let product = x.exp().unwrap().mul(&y.exp().unwrap());
        prop_assert!(agree(&x.add(&y).exp().unwrap(), &product, HIGH.0 - 40));
    }

    #[test]
    fn the_logarithm_inverts_the_exponential_and_turns_products_into_sums(
        n in 1i64..=1000,
        d in 1i64..=1000,
        m in 1i64..1000,
    ) {
        let (a, b) = (at(n, d, HIGH), at(m, 17, HIGH));
        let (log_a, log_b) = (a.log().unwrap(), b.log().unwrap());
        prop_assert!(log_a.exp().unwrap().contains(&exact(n, d)));
        prop_assert!(agree(&log_a.exp().unwrap(), &a, HIGH.0 - 15));
        prop_assert!(agree(&a.mul(&b).log().unwrap(), &log_a.add(&log_b), HIGH.0 - 5));
    }

    #[test]
    fn arcs_invert_their_functions_and_tanh_is_a_quotient(q in rational()) {
        let x = Enclosure::exact(&q, HIGH);
        prop_assert!(agree(&x.atan().tan().unwrap(), &x, HIGH.0 - 30));
if let (Ok(sinh), Ok(cosh)) = (x.sinh(), x.cosh()) {
            prop_assert!(sinh.div(&cosh).unwrap().intersects(&x.tanh()));
        }
        if x.asin().is_ok() {
            prop_assert!(agree(&x.asin().unwrap().sin(), &x, HIGH.0 - 5));
            prop_assert!(agree(&x.acos().unwrap().cos(), &x, HIGH.0 - 5));
        }
    }

    #[test]
    fn the_angle_of_a_point_has_its_direction(a in rational(), b in rational()) {
        let (y, x) = (Enclosure::exact(&a, HIGH), Enclosure::exact(&b, HIGH));
        if let Ok(angle) = Enclosure::atan2(&y, &x) {
            let radius = x.mul(&x).add(&y.mul(&y)).sqrt().unwrap();
            prop_assert!(agree(&radius.mul(&angle.cos()), &x, HIGH.0 - 15));
            prop_assert!(agree(&radius.mul(&angle.sin()), &y, HIGH.0 - 15));
        }
    }

    #[test]
    fn roots_invert_powers(q in rational(), degree in 2i64..100) {
        let x = Enclosure::exact(&q, HIGH).abs();
        let root = x.power(Ratio::new(1, degree)).unwrap();
        prop_assert!(agree(&root.power(degree.into()).unwrap(), &x, HIGH.0 - 40) || x.is_zero());
    }

    #[test]
    fn f64_bounds_enclose_and_are_neighbours(a in any::<i64>(), b in 1..=i64::MAX) {
        let (lower, upper) = at(a, b, HIGH).to_f64_range();
        let rational = |float| Rational::from_float(float).unwrap();
        prop_assert!(rational(lower) <= exact(a, b) && exact(a, b) <= rational(upper));
        prop_assert!(lower == upper || lower.next_up() == upper);
    }
}
