//! Known digits, from tables of constants and an independent multiple-precision library.

use super::{at, exact, number};
use crate::enclosure::{Enclosure, Precision};
use crate::expression::{Operation, TABLE};
use num_rational::Ratio;

/// Precision sufficient for forty decimal places, since 2⁻¹⁴⁰ < 10⁻⁴².
const P: Precision = Precision(140);

/// Numerator and denominator.
type Fraction = (i64, i64);

/// Function, argument as a fraction, value to forty places.
#[rustfmt::skip]
const VALUES: &[(Operation, Fraction, &str)] = &[
    (Operation::Exp, (1, 1), "2.7182818284590452353602874713526624977572"),
    (Operation::Exp, (-10, 1), "0.0000453999297624848515355915155605506102"),
    (Operation::Exp, (20, 1), "485165195.4097902779691068305415405586846389889448"),
    (Operation::Exp, (1, 3), "1.3956124250860895286281253196025868375979"),
    (Operation::Log, (2, 1), "0.6931471805599453094172321214581765680755"),
    (Operation::Log, (10, 1), "2.3025850929940456840179914546843642076011"),
    (Operation::Log, (1, 1000), "-6.9077552789821370520539743640530926228033"),
    (Operation::Log, (3, 2), "0.4054651081081643819780131154643491365720"),
    (Operation::Sin, (1, 1), "0.8414709848078965066525023216302989996226"),
    (Operation::Sin, (-2, 1), "-0.9092974268256816953960198659117448427023"),
    (Operation::Sin, (1000000000000000000, 1), "-0.9929693207404050762095530172636302708600"),
    (Operation::Sin, (1, 7), "0.1423717297922636671652723207062311707869"),
    (Operation::Cos, (1, 1), "0.5403023058681397174009366074429766037323"),
    (Operation::Cos, (-2, 1), "-0.4161468365471423869975682295007621897660"),
    (Operation::Cos, (1000000000000000000, 1), "0.1183719902187107326119543333310430207098"),
    (Operation::Cos, (1, 7), "0.9898132604466150826957261370134337458740"),
    (Operation::Tan, (1, 1), "1.5574077246549022305069748074583601730873"),
    (Operation::Tan, (-2, 1), "2.1850398632615189916433061023136825434320"),
    (Operation::Asin, (1, 2), "0.5235987755982988730771072305465838140329"),
    (Operation::Asin, (-1, 1), "-1.5707963267948966192313216916397514420986"),
    (Operation::Asin, (999999, 1000000), "1.5693821131146723674682498958670957936346"),
    (Operation::Acos, (1, 3), "1.2309594173407746821349291782479873757103"),
    (Operation::Acos, (-1, 1), "3.1415926535897932384626433832795028841972"),
    (Operation::Acos, (999999, 1000000), "0.0014142136802242517630717957726556484640"),
    (Operation::Atan, (2, 1), "1.1071487177940905030170654601785370400700"),
    (Operation::Atan, (-1, 5), "-0.1973955598498807583700497651947902934476"),
    (Operation::Atan, (1000000, 1), "1.5707953267948966195646550249728847754319"),
    (Operation::Sinh, (1, 1), "1.1752011936438014568823818505956008151557"),
    (Operation::Sinh, (-1, 100), "-0.0100001666675000019841297398614117380176"),
    (Operation::Cosh, (1, 1), "1.5430806348152437784779056207570616826015"),
    (Operation::Cosh, (-3, 1), "10.0676619957777658419539360351158898368098"),
    (Operation::Tanh, (1, 1), "0.7615941559557648881194582826047935904128"),
    (Operation::Tanh, (-1, 100), "-0.0099996666799994603393289197088394975100"),
    (Operation::Tanh, (40, 1), "0.9999999999999999999999999999999999639030"),
    (Operation::Expm1, (1, 1), "1.7182818284590452353602874713526624977572"),
    (Operation::Expm1, (-10, 1), "-0.9999546000702375151484644084844394493898"),
    (Operation::Expm1, (1, 1000000000), "0.0000000010000000005000000001666666667083"),
    (Operation::Log1p, (1, 1), "0.6931471805599453094172321214581765680755"),
    (Operation::Log1p, (-999, 1000), "-6.9077552789821370520539743640530926228033"),
    (Operation::Log1p, (1, 1000000000), "0.0000000009999999995000000003333333330833"),
    (Operation::Erf, (1, 1), "0.8427007929497148693412206350826092592961"),
    (Operation::Erf, (-1, 3), "-0.3626481117660629334081786401478658796921"),
    (Operation::Erf, (5, 1), "0.9999999999984625402055719651498116565146"),
    (Operation::Erf, (8, 1), "0.9999999999999999999999999999887757028270"),
    (Operation::Erf, (1, 1000000000), "0.0000000011283791670955125735200325140897"),
    (Operation::Expint1, (1, 1), "0.2193839343955202736771637754601216490310"),
    (Operation::Expint1, (1, 1000000000), "20.1460501730448782953054110021324309929129"),
    (Operation::Expint1, (5, 2), "0.0249149178702697354956280122746096359458"),
    (Operation::Expint1, (30, 1), "0.0000000000000030215520106888125448158250"),
    (Operation::Expint1, (70, 1), "0.0000000000000000000000000000000056003063"),
    (Operation::Expint2, (1, 1), "0.1484955067759220479183599947013392184148"),
    (Operation::Expint2, (1, 1000000000), "0.9999999788539498274551217045279223312426"),
    (Operation::Expint2, (30, 1), "0.0000000000000029296693677373697046835709"),
    (Operation::Expint3, (1, 1), "0.1096919671977601368385818877300608245155"),
    (Operation::Expint3, (1, 1000000000), "0.4999999990000000108230250861891058144235"),
    (Operation::Expint3, (30, 1), "0.0000000000000028430743281403274543255979"),
    (Operation::Dilog, (1, 2), "0.5822405264650125059026563201596801087442"),
    (Operation::Dilog, (-1, 2), "-0.4484142069236462024430644059157743208343"),
    (Operation::Dilog, (1, 3), "0.3662132299770634876167462976642627638021"),
    (Operation::Dilog, (9, 10), "1.2997147230049587251710604941929533990506"),
    (Operation::Dilog, (999999, 1000000), "1.6449192513305107122030441081655980340121"),
    (Operation::Dilog, (-1, 1), "-0.8224670334241132182362075833230125946095"),
    (Operation::Dilog, (-3, 2), "-1.1473806603755707540799766338627921292154"),
    (Operation::Dilog, (-1000000, 1), "-97.0790990554596406264712991127271925268897"),
    (Operation::Clausen, (1, 1), "1.0139591323607685042945743388859146875612"),
    (Operation::Clausen, (-1, 1), "-1.0139591323607685042945743388859146875612"),
    (Operation::Clausen, (2, 1), "0.7271460508632792474298382546083581761203"),
    (Operation::Clausen, (3, 1), "0.0980262093913014211614297912406776636285"),
    (Operation::Clausen, (7, 2), "-0.2465045302347694216534254922925499154345"),
    (Operation::Clausen, (100, 1), "-0.8691792003357179907270010838243616194163"),
    (Operation::Clausen, (1, 1000000000), "0.0000000217232658369464111561758119810482"),
    (Operation::Erfc, (1, 1), "0.1572992070502851306587793649173907407039"),
    (Operation::Erfc, (-1, 3), "1.3626481117660629334081786401478658796921"),
    (Operation::Erfc, (5, 1), "0.0000000000015374597944280348501883434854"),
    (Operation::Erfc, (8, 1), "0.0000000000000000000000000000112242971730"),
    (Operation::Erfc, (1, 1000000000), "0.9999999988716208329044874264799674859103"),
    (Operation::Cbrt, (2, 1), "1.2599210498948731647672106072782283505703"),
    (Operation::Cbrt, (-2, 1), "-1.2599210498948731647672106072782283505703"),
    (Operation::Cbrt, (1, 3), "0.6933612743506347048433522747859617954459"),
    (Operation::Cbrt, (-100, 7), "-2.4264275032025865811238646560044587770197"),
];

/// (y, x), atan2(y, x) to forty places.
#[rustfmt::skip]
const ANGLES: &[((i64, i64), &str)] = &[
    ((1, 2), "0.4636476090008061162142562314612144020285"),
    ((1, -2), "2.6779450445889871222483871518182884821686"),
    ((-1, -2), "-2.6779450445889871222483871518182884821686"),
    ((-1, 2), "-0.4636476090008061162142562314612144020285"),
    ((3, 0), "1.5707963267948966192313216916397514420986"),
    ((-3, 0), "-1.5707963267948966192313216916397514420986"),
    ((5, 1), "1.3734007669450158608612719264449611486510"),
    ((5, -1), "1.7681918866447773776013714568345417355462"),
];

/// (x, y), hypot(x, y) to forty places.
#[rustfmt::skip]
const LENGTHS: &[((i64, i64), &str)] = &[
    ((1, 2), "2.2360679774997896964091736687312762354406"),
    ((-3, 4), "5.0000000000000000000000000000000000000000"),
    ((0, -7), "7.0000000000000000000000000000000000000000"),
    ((1_000_000_000, 1), "1000000000.0000000004999999999999999998750000000000"),
];

/// Base, exponent, power to forty places; a root of degree 1000 goes through the logarithm.
#[rustfmt::skip]
const POWERS: &[(Fraction, Fraction, &str)] = &[
    ((2, 1), (1, 2), "1.4142135623730950488016887242096980785697"),
    ((2, 1), (1, 3), "1.2599210498948731647672106072782283505703"),
    ((2, 1), (-3, 2), "0.3535533905932737622004221810524245196424"),
    ((10, 1), (1, 64), "1.0366329284376979972916517249253444677089"),
    ((3, 1), (-7, 5), "0.2147980049924180835027643270295742384513"),
    ((2, 1), (1, 1000), "1.0006933874625806325375686393038591957083"),
    ((1001, 1000), (30_000, 1), "10527478897894.8062193197429110762839617837311856755113"),
];

#[test]
fn lengths_are_known_to_forty_places() {
    for &((x, y), digits) in LENGTHS {
        let value = Enclosure::hypot(&at(x, 1, P), &at(y, 1, P)).unwrap();
        assert_eq!(value.rounded(40).as_deref(), Some(digits), "hypot({x}, {y})");
    }
}

#[test]
fn pi_is_known_to_forty_places() {
    assert_eq!(Enclosure::pi(P).rounded(40).as_deref(), Some("3.1415926535897932384626433832795028841972"));
}

#[test]
fn every_function_is_known_to_forty_places() {
    for &(operation, (n, d), digits) in VALUES {
        let value = Enclosure::apply(operation, &[at(n, d, P)]).unwrap();
        assert_eq!(value.rounded(40).as_deref(), Some(digits), "{operation:?}({n}/{d})");
    }
}

#[test]
fn the_dilogarithm_of_one_is_a_sixth_of_the_square_of_pi() {
    let square = Enclosure::pi(P).mul(&Enclosure::pi(P)).mul(&at(1, 6, P));
    let dilogarithm = at(1, 1, P).dilog().unwrap();
    assert!(square.intersects(&dilogarithm) && dilogarithm.width() <= super::unit(138));
}

#[test]
fn angles_are_known_in_every_quadrant() {
    for &((y, x), digits) in ANGLES {
        let angle = Enclosure::atan2(&at(y, 1, P), &at(x, 1, P)).unwrap();
        assert_eq!(angle.rounded(40).as_deref(), Some(digits), "atan2({y}, {x})");
    }
}

#[test]
fn powers_are_known_to_forty_places() {
    for &((n, d), (a, b), digits) in POWERS {
        let power = at(n, d, P).power(Ratio::new(a, b)).unwrap();
        assert_eq!(power.rounded(40).as_deref(), Some(digits), "({n}/{d})^({a}/{b})");
    }
}

#[test]
fn values_agree_across_the_precision_up_to_which_constants_are_kept() {
    for bits in [1000, 1020, 1100, 2000] {
        for (narrow, wide) in [
            (Enclosure::pi(Precision(bits)), Enclosure::pi(Precision(2100))),
            (at(2, 1, Precision(bits)).log().unwrap(), at(2, 1, Precision(2100)).log().unwrap()),
        ] {
            assert!(narrow.encloses(&wide), "{bits} bits");
            assert!(narrow.width() <= exact(4, 1) * super::unit(bits), "{bits} bits");
        }
    }
}

#[test]
fn functions_agree_with_double_precision() {
    let arguments = [(-7, 2), (-1, 1), (-1, 3), (1, 100), (2, 7), (9, 10), (5, 2), (30, 1)];
    let close = |float: f64, enclosure: Enclosure| {
        let (lower, upper) = enclosure.to_f64_range();
        (float - lower).abs().max((float - upper).abs()) <= 1e-15 * float.abs().max(1.0)
    };
    let mut compared = 0;
    for row in TABLE {
        for &(n, d) in &arguments {
            let (x, x_float) = (number(n, d), n as f64 / d as f64);
            let (values, floats) = match row.arity {
                1 => (vec![x], vec![x_float]),
                _ => (vec![x, number(-2, 3)], vec![x_float, -2.0 / 3.0]),
            };
            let float = row.operation.apply(&floats);
            match Enclosure::apply(row.operation, &values) {
                Ok(value) => assert!(close(float, value), "{}({n}/{d})", row.name),
                Err(_) => assert!(!float.is_finite(), "{}({n}/{d}) is {float}", row.name),
            }
            compared += 1;
        }
    }
    assert_eq!(compared, TABLE.len() * arguments.len());
}

#[test]
fn only_certain_digits_are_printed() {
    let third = at(1, 3, Precision(40));
    let nearly_four = Enclosure::between(&exact(3999, 1000), &exact(4001, 1000), P);
    for (value, digits) in [
        (Enclosure::pi(Precision(50)), "3.14159265358979"),
        (at(-5, 4, P), "-1.25"),
        (at(700, 1, P), "700"),
        (third, "0.333333333333"),
        (nearly_four, "4.00"),
        (Enclosure::between(&exact(-1, 3), &exact(7, 2), P), "[-1, 4]"),
        (at(-1, 1000, P), "-0.001"),
    ] {
        assert_eq!(value.digits(), digits);
    }
}

#[test]
fn f64_bounds_are_the_nearest_on_either_side() {
    let tenth = number(1, 10).to_f64_range();
    assert_eq!(tenth, (0.1_f64.next_down(), 0.1));
    assert_eq!(number(-1, 10).to_f64_range(), (-0.1, (-0.1_f64).next_up()));
    assert_eq!(number(3, 4).to_f64_range(), (0.75, 0.75));
    assert_eq!(number(0, 1).to_f64_range(), (0.0, 0.0));
    let power_of_two =
        |exponent: i64| at(2, 1, Precision(600)).power(exponent.into()).unwrap().to_f64_range();
    let least = f64::from_bits(1);
    assert_eq!(power_of_two(-1074), (least, least));
    assert_eq!(power_of_two(-1075), (0.0, least));
    assert_eq!(power_of_two(1023), (2.0_f64.powi(1023), 2.0_f64.powi(1023)));
    assert_eq!(power_of_two(1024), (f64::MAX, f64::INFINITY));
}
