//! Reduction: in the normal form of a polynomial in roots and sines, every bound generator has an
//! exponent below the order of its relation, and the result equals that of a simple reduction which
//! replaces one power at a time. Wrong reductions are rejected.

use super::scene::World;
use forms_core::expression::{Expr, Operation};
use forms_core::normal::{Fraction, Tower, Trigonometry, normalise};
use forms_core::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::Ratio;
use proptest::prelude::*;

/// ρⁿ = f
#[derive(Clone, Debug)]
struct Relation {
    variable: u32,
    order: u32,
    value: Polynomial,
}

/// Reduction of a polynomial modulo relations.
type Reduction = fn(&Polynomial, &[Relation]) -> Polynomial;

/// Replaces ρᵏ by ρᵏ⁻ⁿ f, the last generator first, until no replacement is possible.
fn one_power_at_a_time(polynomial: &Polynomial, relations: &[Relation]) -> Polynomial {
    let mut reduced = polynomial.clone();
    while let Some(relation) = relations.iter().rev().find(|r| reduced.degree(r.variable) >= r.order) {
        reduced = by_terms(&reduced, |exponents, rest| {
            let power = exponent_of(exponents, relation.variable);
            if power < relation.order {
                return rest;
            }
            let lowered = rest.divide_by_monomial(&[(relation.variable, relation.order)]).unwrap();
            lowered.mul(&relation.value)
        });
    }
    reduced
}

/// Replaces ρⁿᵏ by f instead of fᵏ.
fn with_powers_taken_once(polynomial: &Polynomial, relations: &[Relation]) -> Polynomial {
    let mut reduced = polynomial.clone();
    while let Some(relation) = relations.iter().rev().find(|r| reduced.degree(r.variable) >= r.order) {
        reduced = by_terms(&reduced, |exponents, rest| {
            let power = exponent_of(exponents, relation.variable);
            let whole = power - power % relation.order;
            let lowered = rest.divide_by_monomial(&[(relation.variable, whole)]).unwrap();
            if whole == 0 { lowered } else { lowered.mul(&relation.value) }
        });
    }
    reduced
}

/// Replaces ρⁿᵏ⁺ʳ by fᵏ instead of fᵏ ρʳ.
fn without_remainders(polynomial: &Polynomial, relations: &[Relation]) -> Polynomial {
    let mut reduced = polynomial.clone();
    while let Some(relation) = relations.iter().rev().find(|r| reduced.degree(r.variable) >= r.order) {
        reduced = by_terms(&reduced, |exponents, rest| {
            let power = exponent_of(exponents, relation.variable);
            if power < relation.order {
                return rest;
            }
            let lowered = rest.divide_by_monomial(&[(relation.variable, power)]).unwrap();
            lowered.mul(&relation.value.pow(power / relation.order))
        });
    }
    reduced
}

/// Applies each relation only once, so that relations of earlier generators are not applied again.
fn in_one_pass(polynomial: &Polynomial, relations: &[Relation]) -> Polynomial {
    relations.iter().fold(polynomial.clone(), |reduced, relation| {
        one_power_at_a_time(&reduced, std::slice::from_ref(relation))
    })
}

fn by_terms(polynomial: &Polynomial, image: impl Fn(&[(u32, u32)], Polynomial) -> Polynomial) -> Polynomial {
    polynomial.terms().fold(Polynomial::zero(), |sum, (exponents, coefficient)| {
        let term = Polynomial::from_terms([(exponents.clone(), coefficient)]);
        sum.add(&image(&exponents, term))
    })
}

fn exponent_of(exponents: &[(u32, u32)], variable: u32) -> u32 {
    exponents.iter().find(|entry| entry.0 == variable).map_or(0, |entry| entry.1)
}

/// Returns x, y, ρ = (1 + x²)^(1/2), σ = (2 + y + ρ)^(1/3) and the sine of x.
fn generators(world: &mut World) -> Vec<Expr> {
    let (x, y) = (world.variable(0), world.variable(1));
    let pool = &mut world.pool;
    let (one, two, square) = (pool.integer(1), pool.integer(2), pool.power(x, 2.into()));
    let radicand = pool.add(one, square);
    let rho = pool.power(radicand, Ratio::new(1, 2));
    let (shift, sine) = (pool.add(two, y), pool.apply(Operation::Sin, &[x]));
    let radicand = pool.add(shift, rho);
    let sigma = pool.power(radicand, Ratio::new(1, 3));
    vec![x, y, rho, sigma, sine]
}

/// Terms, as a coefficient and the exponents of the five generators.
type Shape = Vec<(i64, [u32; 5])>;

fn shape() -> impl Strategy<Value = Shape> {
    let exponents = [0..=1u32, 0..=1, 0..=5, 0..=7, 0..=4];
    prop::collection::vec((prop_oneof![-3..=-1i64, 1..=3i64], exponents), 1..=4)
}

/// Returns the normal form of a shape, the shape multiplied out without any relation, and the
/// relations.
fn both(shape: &Shape) -> (Polynomial, Polynomial, Vec<Relation>) {
    let mut world = World::new(2);
    let expressions = generators(&mut world);
    let pool = &mut world.pool;
    let mut written = pool.integer(0);
    for (coefficient, exponents) in shape {
        let mut term = pool.integer(*coefficient);
        for (&expression, &exponent) in expressions.iter().zip(exponents) {
            // a `power` node would be kept as a known factor
            term = (0..exponent).fold(term, |product, _| pool.multiply(product, expression));
        }
        written = pool.add(written, term);
    }
    let all: Vec<Expr> = std::iter::once(written).chain(expressions).collect();
    let mut tower = Tower::new(Trigonometry::Circle);
    let mut fractions = normalise(&mut tower, &world.pool, &all)
        .and_then(|prepared| prepared.exact(&mut tower, &world.pool))
        .unwrap();
    let polynomial = |fraction: &Fraction| fraction.as_polynomial().expect("a polynomial").clone();
    let normal = polynomial(&fractions.remove(0));
    let generators: Vec<Polynomial> = fractions.iter().map(polynomial).collect();
    let mut plain = Polynomial::zero();
    for (coefficient, exponents) in shape {
        let powers = generators.iter().zip(exponents).map(|(generator, &exponent)| generator.pow(exponent));
        let term = powers.fold(Polynomial::one(), |product, power| product.mul(&power));
        plain = plain.add(&term.scale(&BigInt::from(*coefficient)));
    }
    let relation = |(variable, _, bound): (u32, _, Option<(u32, &Polynomial)>)| {
        bound.map(|(order, value)| Relation { variable, order, value: value.clone() })
    };
    (normal, plain, tower.generators().filter_map(relation).collect())
}

fn is_reduced(polynomial: &Polynomial, relations: &[Relation]) -> bool {
    relations.iter().all(|relation| polynomial.degree(relation.variable) < relation.order)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::with_source_file(file!()) })]

    #[test]
    fn a_normal_form_is_what_replacing_one_power_at_a_time_gives(shape in shape()) {
        let (normal, plain, relations) = both(&shape);
        prop_assert!(is_reduced(&normal, &relations));
        prop_assert_eq!(normal, one_power_at_a_time(&plain, &relations));
    }
}

#[test]
fn a_reduction_that_loses_a_power_a_remainder_or_a_pass_is_another_one() {
    let (normal, plain, relations) = both(&vec![(2, [1, 0, 1, 7, 3]), (-1, [0, 1, 4, 3, 0])]);
    let mutants: [(&str, Reduction); 3] = [
        ("powers taken once", with_powers_taken_once),
        ("no remainders", without_remainders),
        ("one pass", in_one_pass),
    ];
    for (name, mutant) in mutants {
        let wrong = mutant(&plain, &relations);
        assert!(wrong != normal || !is_reduced(&wrong, &relations), "{name} is not seen");
    }
}
