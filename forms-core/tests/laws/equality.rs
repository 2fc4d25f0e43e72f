//! Tests whether expressions vanish: by the normal form, and independently by enclosures at exact
//! points.

use super::scene::World;
use forms_core::enclosure::{Enclosure, Precision, enclose};
use forms_core::expression::{Expr, FunctionId, Rational};
use forms_core::normal::{Fraction, Obstacle, Tower, Trigonometry, normalise};

const PRECISION: Precision = Precision(160);

/// Returns 10⁻⁹, the tolerance for a value that must be zero.
fn tiny() -> Rational {
    Rational::new(1.into(), 1_000_000_000.into())
}

/// Maximum number of term products for a comparison; larger comparisons are left to the enclosures.
const WORK: u64 = 3_000_000;

/// Whether every expression has the normal form zero; `None` if there is no normal form, or none
/// small enough for a test.
pub(crate) fn vanish_exactly(world: &World, expressions: &[Expr]) -> Option<bool> {
    let mut tower = Tower::new(Trigonometry::Circle).with_work_limit(WORK);
    let fractions = normalise(&mut tower, &world.pool, expressions)
        .and_then(|prepared| prepared.exact(&mut tower, &world.pool));
    match fractions {
        Ok(fractions) => Some(fractions.iter().all(Fraction::is_zero)),
        Err(Obstacle::TooLarge(_) | Obstacle::Outside(_)) => None,
        Err(obstacle) => panic!("the coefficients are in the class: {obstacle:?}"),
    }
}

/// Whether every expression is zero, to many digits, at points where all are defined; `None` if no
/// such point was found.
pub(crate) fn vanish_numerically(world: &World, expressions: &[Expr]) -> Option<bool> {
    let mut seen = false;
    for number in 1..=4 {
        let values = values_at(world, expressions, number);
        let Some(values) = values.into_iter().collect::<Option<Vec<Enclosure>>>() else { continue };
        if values.iter().any(|value| !value.contains_zero()) {
            return Some(false);
        }
        seen |= values.iter().all(|value| value.width() < tiny());
    }
    seen.then_some(true)
}

/// Encloses expressions at a point, with exp(Σ cᵢ xᵢ) for the unknown functions: its derivatives
/// are products of the cᵢ times the function itself.
fn values_at(world: &World, expressions: &[Expr], number: i64) -> Vec<Option<Enclosure>> {
    let exact = |value: &Rational| Enclosure::exact(value, PRECISION);
    let value_of = |symbol| {
        let place = world.symbols.iter().position(|known| *known == symbol)? as i64;
        Some(exact(&Rational::new(
            (2 * ((7 * place + 5 * number + 3 * place * number) % 13) - 13).into(),
            7.into(),
        )))
    };
    let mut jet = |function: FunctionId, orders: &[u32], arguments: &[Enclosure]| {
        let shift = i64::from(function == world.functions[0]);
        let (mut exponent, mut factor) = (Enclosure::integer(0, PRECISION), Enclosure::integer(1, PRECISION));
        for (place, (order, argument)) in orders.iter().zip(arguments).enumerate() {
            let slope = exact(&Rational::new((2 * shift - place as i64 + 3).into(), 11.into()));
            exponent = exponent.add(&slope.mul(argument));
            for _ in 0..*order {
                factor = factor.mul(&slope);
            }
        }
        exponent.exp().ok().map(|value| value.mul(&factor))
    };
    let values = enclose(&world.pool, expressions, &value_of, &mut jet, PRECISION);
    values.into_iter().map(Result::ok).collect()
}

/// Returns the common answer of both tests; panics if they disagree or if neither has an answer.
pub(crate) fn vanish(world: &World, expressions: &[Expr]) -> bool {
    let (exactly, numerically) = (vanish_exactly(world, expressions), vanish_numerically(world, expressions));
    if let (Some(exactly), Some(numerically)) = (exactly, numerically) {
        let texts = world.pool.texts(expressions);
        assert_eq!(exactly, numerically, "normal form and enclosure disagree on {texts:?}");
    }
    exactly.or(numerically).expect("it is small enough or defined somewhere")
}
