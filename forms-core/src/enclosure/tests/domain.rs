//! Undefined, unknown and exact values.

use super::{at, exact, interval, number};
use crate::enclosure::{Enclosure, Precision, Undecided};
use crate::expression::Relation;
use num_rational::Ratio;

fn half() -> Ratio<i64> {
    Ratio::new(1, 2)
}

#[test]
fn what_no_precision_can_define_is_undefined() {
    for (name, value) in [
        ("√−1", number(-1, 1).sqrt()),
        ("√[−2, −1]", interval((-2, 1), (-1, 1)).sqrt()),
        ("(−8)^(1/3)", number(-8, 1).power(Ratio::new(1, 3))),
        ("0^(−1)", number(0, 1).power((-1).into())),
        ("0^(−1/2)", number(0, 1).power(-half())),
        ("[−1, 0]^(−1/2)", interval((-1, 1), (0, 1)).power(-half())),
        ("1/0", number(1, 1).div(&number(0, 1))),
        ("0/0", number(0, 1).div(&number(0, 1))),
        ("log 0", number(0, 1).log()),
        ("log [−1, 0]", interval((-1, 1), (0, 1)).log()),
        ("asin 2", number(2, 1).asin()),
        ("acos [−3, −2]", interval((-3, 1), (-2, 1)).acos()),
        ("atan2(0, 0)", Enclosure::atan2(&number(0, 1), &number(0, 1))),
        ("atan2(0, −1)", Enclosure::atan2(&number(0, 1), &number(-1, 1))),
    ] {
        assert_eq!(value, Err(Undecided::Undefined), "{name}");
    }
}

#[test]
fn what_a_narrower_enclosure_could_decide_is_unknown() {
    let around_zero = || interval((-1, 1), (1, 1));
    for (name, value) in [
        ("√[−1, 1]", around_zero().sqrt()),
        ("1/[−1, 1]", number(1, 1).div(&around_zero())),
        ("[−1, 1]^(−2)", around_zero().power((-2).into())),
        ("[0, 1]^(−1/2)", interval((0, 1), (1, 1)).power(-half())),
        ("log [0, 1]", interval((0, 1), (1, 1)).log()),
        ("tan [1, 2]", interval((1, 1), (2, 1)).tan()),
        ("tan [−5, −4]", interval((-5, 1), (-4, 1)).tan()),
        ("asin [0, 2]", interval((0, 1), (2, 1)).asin()),
        ("atan2([−1, 1], −1)", Enclosure::atan2(&around_zero(), &number(-1, 1))),
        ("atan2(0, [−1, 1])", Enclosure::atan2(&number(0, 1), &around_zero())),
    ] {
        assert_eq!(value, Err(Undecided::Unknown), "{name}");
    }
}

#[test]
fn absurdly_large_results_are_so_at_any_precision() {
    for (name, value) in [
        ("e^(2¹⁵)", number(1 << 15, 1).exp()),
        ("sinh −2¹⁵", number(-(1 << 15), 1).sinh()),
        ("2^(2⁴⁰)", number(2, 1).power((1 << 40).into())),
        ("(−3)^(i64::MAX)", number(-3, 1).power(i64::MAX.into())),
        ("3^(i64::MIN + 1), a root", number(3, 1).power(Ratio::new(i64::MAX, 2))),
    ] {
        assert_eq!(value, Err(Undecided::TooLarge), "{name}");
    }
}

#[test]
fn functions_of_huge_arguments_keep_their_bounds() {
    let huge = number(10, 1).power(2000.into()).unwrap();
    let unit_interval = interval((-1, 1), (1, 1));
    assert!(unit_interval.encloses(&huge.sin()) && unit_interval.encloses(&huge.cos()));
    assert!(unit_interval.encloses(&huge.tanh()) && huge.tanh().is_positive());
    assert!(huge.atan().encloses(&Enclosure::pi(Precision(300)).mul(&at(1, 2, Precision(300)))));
    assert!(huge.neg().exp().unwrap().is_nonnegative());
    let tiny = number(3, 1).power((1 << 40).into());
    assert_eq!(tiny, Err(Undecided::TooLarge));
    assert!(number(1, 3).power((1 << 12).into()).unwrap().is_nonnegative());
}

#[test]
fn short_rationals_stay_exact() {
    let one = || number(1, 1);
    for (name, value, (n, d)) in [
        ("√4", number(4, 1).sqrt(), (2, 1)),
        ("(8/27)^(−2/3)", number(8, 27).power(Ratio::new(-2, 3)), (9, 4)),
        ("1/3 + 1/6", Ok(number(1, 3).add(&number(1, 6))), (1, 2)),
        ("(1/3)/(1/7)", number(1, 3).div(&number(1, 7)), (7, 3)),
        ("(−2/3)³", number(-2, 3).power(3.into()), (-8, 27)),
        ("|−1/3|", Ok(number(-1, 3).abs()), (1, 3)),
        ("√0", number(0, 1).sqrt(), (0, 1)),
        ("sin 0", Ok(number(0, 1).sin()), (0, 1)),
        ("cos 0", Ok(number(0, 1).cos()), (1, 1)),
        ("tan 0", number(0, 1).tan(), (0, 1)),
        ("exp 0", number(0, 1).exp(), (1, 1)),
        ("log 1", one().log(), (0, 1)),
        ("atan 0", Ok(number(0, 1).atan()), (0, 1)),
        ("asin 0", number(0, 1).asin(), (0, 1)),
        ("acos 1", one().acos(), (0, 1)),
        ("sinh 0", number(0, 1).sinh(), (0, 1)),
        ("cosh 0", number(0, 1).cosh(), (1, 1)),
        ("tanh 0", Ok(number(0, 1).tanh()), (0, 1)),
        ("atan2(0, 2)", Enclosure::atan2(&number(0, 1), &number(2, 1)), (0, 1)),
        ("0·π", Ok(number(0, 1).mul(&Enclosure::pi(Precision(128)))), (0, 1)),
    ] {
        assert_eq!(value.unwrap().as_exact(), Some(&exact(n, d)), "{name}");
    }
}

#[test]
fn long_rationals_become_narrow_ranges() {
    let mut power = at(1, 3, Precision(64));
    for _ in 0..8 {
        power = power.mul(&power);
    }
    assert!(!power.is_exact() && power.is_nonnegative());
    assert!(power.width() <= super::unit(60));
}

#[test]
fn relations_are_decided_only_where_certain() {
    let (low, high, wide) = (number(1, 3), number(1, 2), interval((0, 1), (1, 1)));
    for (a, relation, b, decision) in [
        (&low, Relation::Less, &high, Some(true)),
        (&high, Relation::Less, &low, Some(false)),
        (&low, Relation::Less, &low, Some(false)),
        (&low, Relation::LessEqual, &low, Some(true)),
        (&low, Relation::GreaterEqual, &low, Some(true)),
        (&low, Relation::Greater, &wide, None),
        (&low, Relation::NotEqual, &high, Some(true)),
        (&low, Relation::NotEqual, &low, Some(false)),
        (&low, Relation::NotEqual, &wide, None),
        (&wide, Relation::LessEqual, &number(1, 1), Some(true)),
        (&wide, Relation::Less, &number(1, 1), None),
        (&wide, Relation::Greater, &number(1, 1), Some(false)),
    ] {
        assert_eq!(a.decide(relation, b), decision, "{a:?} {relation:?} {b:?}");
    }
}

#[test]
fn even_powers_of_an_interval_about_zero_reach_down_to_zero_only() {
    let square = interval((-1, 1), (2, 1)).power(2.into()).unwrap();
    assert_eq!((square.lower(), square.upper()), (exact(0, 1), exact(4, 1)));
    let cube = interval((-1, 1), (2, 1)).power(3.into()).unwrap();
    assert_eq!((cube.lower(), cube.upper()), (exact(-1, 1), exact(8, 1)));
}

#[test]
fn sine_of_a_wide_interval_holds_the_extrema_inside_and_no_more() {
    let image = interval((1, 1), (2, 1)).sin();
    assert_eq!(image.upper(), exact(1, 1));
    assert!(image.lower() > exact(84, 100) && image.lower() < exact(85, 100));
    let all = interval((-4, 1), (4, 1)).cos();
    assert_eq!((all.lower(), all.upper()), (exact(-1, 1), exact(1, 1)));
}

#[test]
fn arcs_stay_sharp_beside_the_ends_of_their_domain() {
    let beside_one = Enclosure::exact(&(exact(1, 1) - super::unit(120)), Precision(128));
    for x in [beside_one.clone(), beside_one.neg()] {
        assert!(x.asin().unwrap().width() <= super::unit(127));
        assert!(x.acos().unwrap().width() <= super::unit(127));
    }
    assert!(beside_one.acos().unwrap().is_positive());
}
