//! Laws of polynomial arithmetic, each checked against an independent schoolbook implementation
//! where one exists.

use forms_core::polynomial::{Polynomial, coprime_basis};
use num_bigint::BigInt;
use proptest::prelude::*;
use std::collections::BTreeMap;

type Term = (Vec<(u32, u32)>, BigInt);

/// Polynomials in x₀, x₁, x₂ with few terms.
fn small() -> impl Strategy<Value = Polynomial> {
    terms(3, 3, -9..=9, 5)
}

/// Small nonzero polynomials, for laws of division.
fn not_zero() -> impl Strategy<Value = Polynomial> {
    small().prop_map(|f| if f.is_zero() { Polynomial::one() } else { f })
}

fn terms(
    variables: u32,
    exponent: u32,
    numbers: std::ops::RangeInclusive<i64>,
    count: usize,
) -> impl Strategy<Value = Polynomial> {
    let monomial = prop::collection::vec((0..variables, 0..=exponent), 0..3);
    prop::collection::vec((monomial, numbers.prop_map(BigInt::from)), 0..=count)
        .prop_map(Polynomial::from_terms)
}

/// Terms with coefficients of every size, variables up to 199 and exponents up to 10⁴.
fn wild() -> impl Strategy<Value = Vec<Term>> {
    wild_of(0..6)
}

fn wild_of(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Term>> {
    let exponent = prop_oneof![0..4u32, 5..9u32, 120..130u32, 9_990..=10_000u32];
    let monomial = prop::collection::btree_map(prop_oneof![0..4u32, 0..200u32], exponent, 0..4);
    let number = prop_oneof![
        (-3i64..=3).prop_map(BigInt::from),
        (i64::MAX - 3..=i64::MAX).prop_map(BigInt::from),
        (i64::MIN..=i64::MIN + 3).prop_map(BigInt::from),
        (i128::MAX - 3..=i128::MAX).prop_map(BigInt::from),
        (i128::MIN..=i128::MIN + 3).prop_map(BigInt::from),
    ];
    prop::collection::vec((monomial.prop_map(|monomial| monomial.into_iter().collect()), number), count)
}

/// Terms that densely fill a small box of exponents, with coefficients of every size.
fn crowded() -> impl Strategy<Value = Vec<Term>> {
    let number = prop_oneof![
        (-99i64..=99).prop_map(BigInt::from),
        Just(BigInt::from(i64::MAX)),
        Just(BigInt::from(i128::MIN)),
    ];
    let monomial = (0..9u32, 0..3u32, 0..12u32).prop_map(|(a, b, c)| vec![(0, a), (17, b), (18, c)]);
    prop::collection::vec((monomial, number), 10..24)
}

/// Terms in long rows, with numbers at both ends of a range and inside it.
fn rows(largest: i64) -> impl Strategy<Value = Vec<Term>> {
    let number = prop_oneof![4 => -9i64..=9, 1 => Just(largest), 1 => Just(-largest - 1)];
    let row = (0..3u32, 0..3u32, prop::collection::vec(number, 1..24));
    prop::collection::vec(row, 1..4).prop_map(|rows| {
        let row = |(a, b, numbers): (u32, u32, Vec<i64>)| {
            let term = move |(c, number)| (vec![(0, a), (5, b), (6, c as u32)], BigInt::from(number));
            numbers.into_iter().enumerate().map(term).collect::<Vec<Term>>()
        };
        rows.into_iter().flat_map(row).collect()
    })
}

/// Multiplies by the definition, on maps from exponents to numbers.
fn schoolbook(left: &[Term], right: &[Term]) -> BTreeMap<Vec<(u32, u32)>, BigInt> {
    let mut product = BTreeMap::new();
    for (a, c) in left {
        for (b, d) in right {
            let mut exponents: BTreeMap<u32, u32> = BTreeMap::new();
            for (variable, exponent) in a.iter().chain(b) {
                *exponents.entry(*variable).or_default() += exponent;
            }
            exponents.retain(|_, exponent| *exponent != 0);
            *product.entry(exponents.into_iter().collect()).or_insert(BigInt::ZERO) += c * d;
        }
    }
    product.retain(|_, coefficient| *coefficient != BigInt::ZERO);
    product
}

fn map(polynomial: &Polynomial) -> BTreeMap<Vec<(u32, u32)>, BigInt> {
    polynomial.terms().collect()
}

fn x(index: u32) -> Polynomial {
    Polynomial::variable(index)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn products_of_long_rows_are_schoolbook_products(
        within in (rows(9), rows(i64::from(i32::MAX))),
        beyond in rows(i64::from(i32::MAX) + 1),
        factor in prop_oneof![-3i64..=3, Just(i64::from(i32::MIN)), Just(1 << 33)],
    ) {
        let polynomials = [&within.0, &within.1, &beyond].map(|terms| Polynomial::from_terms(terms.clone()));
        let [f, g, h] = &polynomials;
        prop_assert_eq!(map(&(f * g)), schoolbook(&within.0, &within.1));
        prop_assert_eq!(map(&(f * h)), schoolbook(&within.0, &beyond));
        let sum = Polynomial::sum_of_products(&[(factor, f, f), (1, g, f), (-1, f, h)]);
        prop_assert_eq!(sum, &(&(f * f).scale(&factor.into()) + &(f * g)) - &(f * h));
    }
}

proptest! {
    #[test]
    fn polynomials_are_a_commutative_ring(f in small(), g in small(), h in small()) {
        prop_assert_eq!(&f + &g, &g + &f);
        prop_assert_eq!(&f * &g, &g * &f);
        prop_assert_eq!(&(&f + &g) + &h, &f + &(&g + &h));
        prop_assert_eq!(&(&f * &g) * &h, &f * &(&g * &h));
        prop_assert_eq!(&f * &(&g + &h), &(&f * &g) + &(&f * &h));
        prop_assert_eq!(&f - &g, &f + &(-&g));
        prop_assert!((&f - &f).is_zero());
        prop_assert_eq!(&f * &Polynomial::one(), f.clone());
    }

    #[test]
    fn packed_product_is_the_schoolbook_product(left in wild(), right in wild()) {
        let (f, g) = (Polynomial::from_terms(left.clone()), Polynomial::from_terms(right.clone()));
        prop_assert_eq!(map(&(&f * &g)), schoolbook(&left, &right));
    }

    #[test]
    fn long_products_are_schoolbook_products(
        scattered in (wild_of(8..20), wild_of(8..20)),
        crowded in (crowded(), crowded()),
        factor in -3i64..=3,
    ) {
        let [f, g, h, k] =
            [&scattered.0, &scattered.1, &crowded.0, &crowded.1].map(|terms| Polynomial::from_terms(terms.clone()));
        prop_assert_eq!(map(&(&f * &g)), schoolbook(&scattered.0, &scattered.1));
        prop_assert_eq!(map(&(&h * &k)), schoolbook(&crowded.0, &crowded.1));
        let sum = Polynomial::sum_of_products(&[(factor, &h, &k), (1, &k, &k), (-1, &f, &g)]);
        prop_assert_eq!(sum, &(&(&h * &k).scale(&factor.into()) + &(&k * &k)) - &(&f * &g));
    }

    #[test]
    fn terms_rebuild_the_polynomial_in_decreasing_order(terms in wild()) {
        let f = Polynomial::from_terms(terms);
        prop_assert_eq!(&Polynomial::from_terms(f.terms()), &f);
        prop_assert_eq!(f.terms().count(), f.term_count());
    }

    #[test]
    fn representation_does_not_depend_on_the_way(a in wild(), b in wild()) {
        let (f, g) = (Polynomial::from_terms(a), Polynomial::from_terms(b));
        prop_assert_eq!(&(&f + &g) - &g, f.clone());
        prop_assert_eq!(&(&f - &g) + &g, f);
    }

    #[test]
    fn derivation_obeys_leibniz(f in small(), g in small()) {
        prop_assert_eq!((&f * &g).derivative(1), &(&f.derivative(1) * &g) + &(&f * &g.derivative(1)));
    }

    #[test]
    fn exact_division_inverts_multiplication(f in small(), g in not_zero()) {
        prop_assert_eq!((&f * &g).divide_exact(&g), Some(f.clone()));
        if let Some(quotient) = f.divide_exact(&g) {
            prop_assert_eq!(&quotient * &g, f);
        }
    }

    #[test]
    fn a_common_factor_divides_the_gcd(a in not_zero(), b in not_zero(), c in not_zero()) {
        let (f, g) = (&a * &c, &b * &c);
        let gcd = f.gcd(&g);
        prop_assert!(gcd.divide_exact(&c).is_some(), "{:?} does not divide {:?}", c, gcd);
        prop_assert!(!gcd.is_negative());
        let (f, g) = (f.divide_exact(&gcd), g.divide_exact(&gcd));
        prop_assert!(f.zip(g).is_some_and(|(f, g)| f.gcd(&g).is_one()));
    }

    #[test]
    fn square_free_factors_recompose(a in small(), b in small()) {
        let f = &(&a * &a) * &b;
        let (content, factors) = f.square_free();
        prop_assert_eq!(Polynomial::from_factors(&content, &factors), f);
        for (index, (factor, _)) in factors.iter().enumerate() {
            prop_assert!(factor.is_square_free());
            prop_assert!(factors[..index].iter().all(|(other, _)| factor.gcd(other).is_one()));
        }
    }

    #[test]
    fn inputs_factor_over_their_coprime_basis(a in small(), b in small(), c in small()) {
        let inputs = [&a * &b, &b * &c, &(&a * &c) * &c];
        let basis = coprime_basis(&inputs);
        for (index, factor) in basis.iter().enumerate() {
            prop_assert!(basis[..index].iter().all(|other| factor.gcd(other).is_one()));
        }
        for input in inputs.iter().filter(|input| !input.is_zero()) {
            let (content, exponents) = input.factor_over(&basis).expect("it factors over the basis");
            let factors: Vec<_> = basis.iter().cloned().zip(exponents).collect();
            prop_assert_eq!(&Polynomial::from_factors(&content, &factors), input);
        }
    }

    #[test]
    fn evaluation_is_a_homomorphism(f in small(), g in small(), point in prop::collection::vec(-50i64..50, 3)) {
        let point: Vec<BigInt> = point.into_iter().map(BigInt::from).collect();
        prop_assert_eq!((&f * &g).evaluate(&point), f.evaluate(&point) * g.evaluate(&point));
        prop_assert_eq!((&f + &g).evaluate(&point), f.evaluate(&point) + g.evaluate(&point));
        let generic = f.evaluate_with(BigInt::clone, |variable| point[variable as usize].clone());
        prop_assert_eq!(generic, f.evaluate(&point));
    }

    #[test]
    fn substitution_commutes_with_products(f in small(), g in small(), value in small()) {
        let substitute = |polynomial: &Polynomial| polynomial.substitute(1, &value);
        prop_assert_eq!(substitute(&(&f * &g)), &substitute(&f) * &substitute(&g));
    }

    #[test]
    fn parts_rebuild_the_polynomial(f in terms(4, 5, -9..=9, 12)) {
        let mut sum = Polynomial::zero();
        for (exponents, part) in f.split_by(&[2, 0]) {
            prop_assert!(!part.contains(0) && !part.contains(2));
            sum = &sum + &part.multiply_by_monomial(&[(2, exponents[0]), (0, exponents[1])]);
        }
        prop_assert_eq!(sum, f);
    }
}

#[test]
fn powers_multiply_out() {
    let f = &x(0) + &Polynomial::integer(1);
    assert_eq!(f.pow(3).to_string(), "x0^3 + 3*x0^2 + 3*x0 + 1");
    assert_eq!((f.pow(0), f.pow(1)), (Polynomial::one(), f));
}

#[test]
fn division_holds_at_the_ends_of_the_rungs() {
    for end in
        [BigInt::from(i64::MIN), BigInt::from(i64::MAX), BigInt::from(i128::MIN), BigInt::from(i128::MAX)]
    {
        let f = &x(0).scale(&end) - &Polynomial::constant(end);
        for g in [&Polynomial::integer(1) - &x(0), &x(0) - &Polynomial::integer(1), f.neg()] {
            let quotient = f.divide_exact(&g).expect("it divides");
            assert_eq!(&quotient * &g, f);
        }
    }
}

#[test]
fn gcd_of_dense_polynomials_in_four_variables_is_their_common_factor() {
    let sum = |numbers: [i64; 5]| {
        let mut sum = Polynomial::integer(numbers[4]);
        for index in 0..4 {
            sum = &sum + &x(index).scale(&numbers[index as usize].into());
        }
        sum
    };
    let (a, b, c) = (sum([1, 2, 3, 4, 5]).pow(3), sum([2, -1, 1, 7, 1]).pow(3), sum([3, 1, -2, 1, 4]).pow(3));
    assert_eq!((&a * &c).gcd(&(&b * &c)), c);
}

#[test]
fn sums_of_products_that_cancel_are_zero_and_others_are_not() {
    let f = (&x(0) + &x(70)).pow(9);
    let g = (&x(3) - &x(40)).pow(8);
    let fg = &f * &g;
    let one = Polynomial::one();
    let middle = x(0).multiply_by_monomial(&[(0, 3), (70, 5), (3, 4), (40, 4)]);
    assert!(Polynomial::sum_of_products_is_zero(&[(1, &f, &g), (-1, &fg, &one)]));
    assert!(!Polynomial::sum_of_products_is_zero(&[(1, &f, &g), (-1, &fg, &one), (3, &middle, &one)]));
    assert!(!Polynomial::sum_of_products_is_zero(&[(1, &f, &g), (1, &fg, &one)]));
    assert_eq!(Polynomial::sum_of_products(&[(2, &f, &g), (-1, &fg, &one)]), fg);
}

#[test]
fn gcd_of_swelling_remainders_still_divides_both() {
    // With numbers beyond the prime of the images, only the remainder sequence is left, and its
    // coefficients swell.
    let sum = |step: i64| {
        (0..6).fold(Polynomial::integer(7 - step), |sum, variable| {
            let number = BigInt::from((i64::from(variable) * step + 3) % 11 - 5) * (1i64 << 50) + step;
            sum.add(&Polynomial::variable(variable).scale(&number))
        })
    };
    let common = sum(2).pow(2).add(&sum(4)).add(&Polynomial::variable(1));
    let (f, g) = (common.mul(&sum(3).pow(3).add(&sum(1))), common.mul(&sum(5).pow(3).sub(&sum(2).square())));
    assert!(f.term_count() > 200 && g.term_count() > 200);
    let found = f.gcd(&g);
    assert!(f.divide_exact(&found).is_some() && g.divide_exact(&found).is_some());
    let (content, factors) = f.square_free();
    assert_eq!(Polynomial::from_factors(&content, &factors), f);
    let basis = coprime_basis(&[f.clone(), g.clone()]);
    assert!(f.factor_over(&basis).is_some() && g.factor_over(&basis).is_some());
}
