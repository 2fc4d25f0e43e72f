//! Ranges in machine words: they contain the exact value, and every decision is true.

use super::exact;
use crate::enclosure::{Undecided, WordRange, word_ranges};
use crate::expression::{Expr, Operation, Pool, Rational, Relation, Symbol, SymbolKind};
use num_rational::Ratio;
use num_traits::Zero;
use proptest::prelude::*;

/// x and y with their expressions.
fn plane() -> (Pool, [Symbol; 2], [Expr; 2]) {
    let mut pool = Pool::new();
    let symbols = ["x", "y"].map(|name| pool.declare_symbol(name, SymbolKind::Coordinate));
    let expressions = symbols.map(|symbol| pool.symbol(symbol));
    (pool, symbols, expressions)
}

/// The range of one expression at x = p.
fn at(pool: &Pool, expression: Expr, p: &Rational) -> Result<WordRange, Undecided> {
    word_ranges(pool, &[expression], |_| WordRange::rational(p)).map(|ranges| ranges[0])
}

/// Whether the range allows this value: it is not certain that the range lies on one side of it.
fn allows(range: WordRange, value: &Rational) -> bool {
    let value = WordRange::rational(value).unwrap();
    range.intersects(value) && range.decide(Relation::NotEqual, value) != Some(true)
}

proptest! {
    #[test]
    fn sums_products_quotients_and_powers_hold_the_exact_value(
        (p, q) in (-60i64..60, 1i64..30),
        (r, s) in (-60i64..60, 1i64..30),
        n in -3i64..4,
    ) {
        let (mut pool, [x, _], [a, b]) = plane();
        let (u, v) = (exact(p, q), exact(r, s));
        let power = pool.power(a, n.into());
        let product = pool.multiply(power, b);
        let sum = pool.subtract(product, a);
        let quotient = pool.divide(sum, b);
        let ranges = word_ranges(&pool, &[quotient], |symbol| WordRange::rational(if symbol == x { &u } else { &v }));
        let undefined = v.is_zero() || (u.is_zero() && n < 0);
        match ranges {
            Ok(ranges) => {
                prop_assert!(!undefined);
                let raised = (0..n.abs()).fold(exact(1, 1), |all, _| all * &u);
                let raised = if n < 0 { raised.recip() } else { raised };
                prop_assert!(allows(ranges[0], &((raised * &v - &u) / &v)));
            }
            Err(Undecided::Undefined) => prop_assert!(undefined),
            Err(_) => {}
        }
    }

    #[test]
    fn the_square_of_a_root_holds_what_was_rooted((p, q) in (0i64..1_000_000, 1i64..1000)) {
        let (mut pool, _, [a, _]) = plane();
        let (root, square) = (pool.power(a, Ratio::new(1, 2)), pool.multiply(a, a));
        let value = exact(p, q);
        let range = at(&pool, root, &value).unwrap();
        let squared = word_ranges(&pool, &[square], |_| Ok(range)).unwrap();
        prop_assert!(allows(squared[0], &value));
    }

    #[test]
    fn a_relation_that_is_decided_is_so((p, q) in (-60i64..60, 1i64..30), (r, s) in (-60i64..60, 1i64..30)) {
        let (u, v) = (exact(p, q), exact(r, s));
        let (left, right) = (WordRange::rational(&u).unwrap(), WordRange::rational(&v).unwrap());
        for (relation, truth) in [
            (Relation::Less, u < v),
            (Relation::LessEqual, u <= v),
            (Relation::Greater, u > v),
            (Relation::GreaterEqual, u >= v),
            (Relation::NotEqual, u != v),
        ] {
            prop_assert!(left.decide(relation, right).is_none_or(|decided| decided == truth));
        }
    }
}

#[test]
fn what_is_not_real_is_undefined_and_what_does_not_fit_unknown() {
    let (mut pool, _, [a, _]) = plane();
    let (root, inverse) = (pool.sqrt(a), pool.power(a, (-2).into()));
    let (large, sine) = (pool.power(a, 40.into()), pool.apply(Operation::Sin, &[a]));
    assert_eq!(at(&pool, root, &exact(-1, 3)), Err(Undecided::Undefined));
    assert_eq!(at(&pool, inverse, &exact(0, 1)), Err(Undecided::Undefined));
    assert_eq!(at(&pool, large, &exact(3, 1)), Err(Undecided::Unknown));
    assert_eq!(at(&pool, sine, &exact(1, 1)), Err(Undecided::Unknown));
    assert!(at(&pool, root, &exact(2, 1)).is_ok());
}
