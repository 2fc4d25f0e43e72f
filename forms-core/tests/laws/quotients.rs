//! Forms over one denominator: d of their normal forms, computed by one quotient rule for all
//! partial derivatives of a basis form, is the normal form of d as the calculus writes it, by the
//! rules for each operation.

use super::scene::World;
use forms_core::calculus::{Blade, Form, exterior_derivative};
use forms_core::expression::Expr;
use forms_core::normal::{Fraction, Normal, Tower, Trigonometry, normalise};
use num_rational::Ratio;
use proptest::prelude::*;

/// c₀ + c₁ x₀x₁ + c₂ x₁² + c₃ x₂³
type Numerator = [i64; 4];

fn numerator(world: &mut World, numbers: Numerator) -> Expr {
    let x = [0, 1, 2].map(|place| world.variable(place));
    let pool = &mut world.pool;
    let monomials =
        [pool.integer(1), pool.multiply(x[0], x[1]), pool.power(x[1], 2.into()), pool.power(x[2], 3.into())];
    let mut sum = pool.integer(0);
    for (number, monomial) in numbers.into_iter().zip(monomials) {
        let number = pool.integer(number);
        let term = pool.multiply(number, monomial);
        sum = pool.add(sum, term);
    }
    sum
}

/// Returns (1 + x₀²)^(k₀/2) (2 + x₁² + x₂²)^(k₁/2) (3 + x₀x₁)^k₂, in which no factor contains every
/// coordinate.
fn denominator(world: &mut World, halves: [i64; 3]) -> Expr {
    let x = [0, 1, 2].map(|place| world.variable(place));
    let pool = &mut world.pool;
    let squares = x.map(|x| pool.power(x, 2.into()));
    let product = pool.multiply(x[0], x[1]);
    let sum = pool.add(squares[1], squares[2]);
    let mut all = pool.integer(1);
    for (constant, part, exponent) in [
        (1, squares[0], Ratio::new(halves[0], 2)),
        (2, sum, Ratio::new(halves[1], 2)),
        (3, product, Ratio::from_integer(halves[2])),
    ] {
        let constant = pool.integer(constant);
        let base = pool.add(constant, part);
        let power = pool.power(base, exponent);
        all = pool.multiply(all, power);
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::with_source_file(file!()) })]

    #[test]
    fn d_over_one_denominator_is_d_coefficient_by_coefficient(
        numerators in prop::array::uniform3(prop::array::uniform4(-3i64..=3)),
        halves in [-2i64..=4, -2i64..=4, -1i64..=2],
    ) {
        let mut world = World::new(3);
        let below = denominator(&mut world, halves);
        let along = world.coordinates();
        let mut terms = Vec::new();
        for (numbers, &coordinate) in numerators.into_iter().zip(&along) {
            let above = numerator(&mut world, numbers);
            let value = world.pool.divide(above, below);
            if !world.pool.is_zero(value) {
                terms.push((Blade::of(coordinate), value));
            }
        }
        let form = Form::from_terms(1, terms);
        let written = exterior_derivative(&mut world.ring(), &form, &along);
        let scalars: Vec<Expr> = form.terms().iter().chain(written.terms()).map(|term| term.1).collect();
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, &world.pool, &scalars).unwrap();
        let mut fractions = prepared.exact(&mut tower, &world.pool).unwrap();
        let expected = fractions.split_off(form.terms().len());
        let normal = Form::from_terms(1, form.terms().iter().map(|term| term.0).zip(fractions));
        let mut ring = Normal::new(&mut tower, &world.symbols);
        let found = exterior_derivative(&mut ring, &normal, &along);
        let twice = exterior_derivative(&mut ring, &found, &along);
        prop_assert_eq!(ring.obstacle(), None);
        prop_assert!(twice.is_zero());
        for ((blade, _), expected) in written.terms().iter().zip(&expected) {
            let value = found.coefficient(*blade).cloned().unwrap_or(Fraction::zero());
            prop_assert!(tower.subtract(&value, expected).unwrap().is_zero());
        }
        prop_assert!(found.terms().iter().all(|(blade, _)| written.coefficient(*blade).is_some()));
    }
}
