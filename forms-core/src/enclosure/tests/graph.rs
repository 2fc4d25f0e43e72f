//! Enclosures of expressions in a pool.

use super::{at, exact, interval, number};
use crate::enclosure::{Enclosure, Precision, Undecided, enclose};
use crate::expression::{Expr, Operation, Pool, Relation, Seam, Symbol, SymbolKind};

type Decided = Result<Enclosure, Undecided>;

/// A pool with two variables and their expressions.
fn plane() -> (Pool, [Symbol; 2], [Expr; 2]) {
    let mut pool = Pool::new();
    let symbols = ["x", "y"].map(|name| pool.declare_symbol(name, SymbolKind::Coordinate));
    let expressions = symbols.map(|symbol| pool.symbol(symbol));
    (pool, symbols, expressions)
}

fn value(pool: &Pool, expression: Expr, known: &[(Symbol, Enclosure)]) -> Decided {
    let values = |symbol| known.iter().find(|(name, _)| *name == symbol).map(|(_, value)| value.clone());
    enclose(pool, &[expression], &values, &mut |_, _, _| None, Precision(128)).remove(0)
}

#[test]
fn a_pythagorean_radius_is_exact() {
    let (mut pool, [x, y], [a, b]) = plane();
    let (a2, b2) = (pool.power(a, 2.into()), pool.multiply(b, b));
    let sum = pool.add(a2, b2);
    let radius = pool.sqrt(sum);
    let radius = value(&pool, radius, &[(x, number(3, 7)), (y, number(4, 7))]).unwrap();
    assert_eq!(radius.as_exact(), Some(&exact(5, 7)));
}

#[test]
fn division_by_a_hidden_zero_is_undefined() {
    let (mut pool, [x, _], [a, _]) = plane();
    let (four, two) = (pool.integer(4), pool.integer(2));
    let root = pool.sqrt(four);
    let zero = pool.subtract(root, two);
    let quotient = pool.divide(a, zero);
    let sum = pool.add(quotient, a);
    assert_eq!(value(&pool, sum, &[(x, number(1, 1))]), Err(Undecided::Undefined));
    assert_eq!(value(&pool, sum, &[]), Err(Undecided::Unknown));
}

#[test]
fn undefined_prevails_over_unknown() {
    let (mut pool, [_, y], [a, b]) = plane();
    let logarithm = pool.apply(Operation::Log, &[b]);
    for expression in
        [pool.add(a, logarithm), pool.multiply(a, logarithm), pool.apply(Operation::Atan2, &[a, logarithm])]
    {
        assert_eq!(value(&pool, expression, &[(y, number(-1, 1))]), Err(Undecided::Undefined));
    }
}

#[test]
fn a_product_with_itself_is_a_square() {
    let (mut pool, [x, _], [a, _]) = plane();
    let square = pool.multiply(a, a);
    let image = value(&pool, square, &[(x, interval((-1, 1), (1, 1)))]).unwrap();
    assert_eq!((image.lower(), image.upper()), (exact(0, 1), exact(1, 1)));
}

#[test]
fn a_branch_is_taken_where_its_condition_is_certain() {
    let (mut pool, [x, _], [a, _]) = plane();
    let zero = pool.integer(0);
    let (root, negated) = (pool.sqrt(a), pool.negate(a));
    let piecewise = pool.select((a, Relation::Greater, zero), root, negated, Seam::Agrees);
    let at = |known: Enclosure| value(&pool, piecewise, &[(x, known)]);
    assert_eq!(at(number(9, 4)).unwrap().as_exact(), Some(&exact(3, 2)));
    assert_eq!(at(number(-2, 1)).unwrap().as_exact(), Some(&exact(2, 1)));
    assert_eq!(at(interval((-1, 1), (1, 1))), Err(Undecided::Unknown));
    let hull = at(interval((0, 1), (4, 1))).unwrap();
    assert_eq!((hull.lower(), hull.upper()), (exact(-4, 1), exact(2, 1)));
}

#[test]
fn unknown_functions_take_the_values_given() {
    let (mut pool, [x, y], [a, b]) = plane();
    let f = pool.declare_function("f", vec![x, y]);
    let f_at = pool.jet(f, &[0, 0], &[a, b]);
    let derivative = pool.derivative(f_at, x);
    let values = |_| Some(number(1, 3));
    let mut asked = Vec::new();
    let results = enclose(
        &pool,
        &[derivative, f_at],
        &values,
        &mut |function, orders, arguments| {
            asked.push((function, orders.to_vec(), arguments.to_vec()));
            (orders[0] == 1).then(|| number(7, 1))
        },
        Precision(128),
    );
    assert_eq!(results, [Ok(number(7, 1)), Err(Undecided::Unknown)]);
    let arguments = vec![number(1, 3); 2];
    assert_eq!(asked, [(f, vec![0, 0], arguments.clone()), (f, vec![1, 0], arguments)]);
}

#[test]
fn repeated_squaring_ends() {
    let (mut pool, [x, _], [a, _]) = plane();
    let mut power = a;
    for _ in 0..60 {
        power = pool.multiply(power, power);
    }
    assert_eq!(value(&pool, power, &[(x, number(3, 1))]), Err(Undecided::TooLarge));
    assert!(value(&pool, power, &[(x, number(1, 3))]).unwrap().is_nonnegative());
}

#[test]
fn a_difference_that_is_not_zero_is_seen_once_the_precision_suffices() {
    // e^(π√163) agrees with an integer to twelve places, but is not an integer.
    let mut pool = Pool::new();
    let (pi, number, integer) = (pool.pi(), pool.integer(163), pool.integer(262_537_412_640_768_744));
    let root = pool.sqrt(number);
    let product = pool.multiply(pi, root);
    let power = pool.apply(Operation::Exp, &[product]);
    let difference = pool.subtract(power, integer);
    let at =
        |p| enclose(&pool, &[difference], &|_| None, &mut |_, _, _| None, Precision(p)).remove(0).unwrap();
    assert!(at(32).contains_zero() && at(128).is_negative());
    assert!(at(192).rounded(30).is_some_and(|digits| digits.starts_with("-0.000000000000749927402801814")));
}

#[test]
fn precision_mixes_to_the_higher() {
    let sum = Enclosure::pi(Precision(40)).add(&at(1, 3, Precision(100)));
    assert_eq!(sum.precision(), Precision(100));
    assert!(sum.encloses(&Enclosure::pi(Precision(200)).add(&at(1, 3, Precision(200)))));
}

#[test]
fn a_power_too_large_to_write_down_is_so_at_every_precision() {
    let (mut pool, [x, y], [a, b]) = plane();
    let power = pool.power(a, 1_000_000.into());
    let logarithm = pool.apply(Operation::Log, &[b]);
    let sum = pool.add(power, logarithm);
    assert_eq!(value(&pool, power, &[(x, number(3, 2))]), Err(Undecided::TooLarge));
    assert_eq!(value(&pool, sum, &[(x, number(3, 2))]), Err(Undecided::TooLarge));
    assert_eq!(value(&pool, sum, &[(x, number(3, 2)), (y, number(-1, 1))]), Err(Undecided::Undefined));
    assert_eq!(value(&pool, power, &[(x, number(-1, 1))]), Ok(number(1, 1)));
    assert!(value(&pool, power, &[(x, number(1, 2))]).unwrap().is_nonnegative());
}
