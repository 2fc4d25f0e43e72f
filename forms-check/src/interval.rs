//! Interval arithmetic with rational endpoints, rounded outward: enclosures of real functions.

use crate::expression::rational;
use num_bigint::BigInt;
use num_rational::BigRational;
use std::sync::OnceLock;

/// Precision: endpoints are multiples of 2^−BITS.
const BITS: u32 = 160;

/// Number of terms of a series whose ratio is at most a half.
const TERMS: i64 = 170;

/// Largest angle, and largest logarithm, for which functions are enclosed.
const LARGEST: i64 = 4096;

/// Maximum number of bits of a numerator.
const LARGEST_BITS: u64 = 1 << 16;

/// Closed interval from `low` to `high`.
#[derive(Clone, Debug)]
pub(crate) struct Interval {
    pub(crate) low: BigRational,
    pub(crate) high: BigRational,
}

impl Interval {
    pub(crate) fn number(value: BigRational) -> Self {
        Interval { low: value.clone(), high: value }
    }

    fn rounded(self) -> Self {
        let scale = BigRational::from_integer(BigInt::from(1) << BITS);
        let is_short = |end: &BigRational| end.denom().bits() <= u64::from(BITS);
        let low = if is_short(&self.low) { self.low } else { (self.low * &scale).floor() / &scale };
        let high = if is_short(&self.high) { self.high } else { (self.high * &scale).ceil() / &scale };
        Interval { low, high }
    }

    pub(crate) fn add(&self, other: &Interval) -> Self {
        Interval { low: &self.low + &other.low, high: &self.high + &other.high }
    }

    pub(crate) fn scale(&self, by: &BigRational) -> Self {
        self.multiply(&Interval::number(by.clone()))
    }

    pub(crate) fn subtract(&self, other: &Interval) -> Self {
        Interval { low: &self.low - &other.high, high: &self.high - &other.low }
    }

    pub(crate) fn multiply(&self, other: &Interval) -> Self {
        let products = [&self.low * &other.low, &self.low * &other.high, &self.high * &other.low];
        let last = &self.high * &other.high;
        let low = products.iter().fold(last.clone(), |m, p| m.min(p.clone()));
        Interval { low, high: products.into_iter().fold(last, Ord::max) }.rounded()
    }

    /// Whether its endpoints are too long for further computation.
    pub(crate) fn is_long(&self) -> bool {
        [&self.low, &self.high].iter().any(|end| end.numer().bits().max(end.denom().bits()) > LARGEST_BITS)
    }

    /// Returns the largest absolute value.
    fn magnitude(&self) -> BigRational {
        self.high.clone().max(-self.low.clone())
    }

    /// Returns 1, −1 or 0 for an interval of one sign, `None` for any other.
    pub(crate) fn sign(&self) -> Option<i64> {
        let zero = rational(0, 1);
        match (self.low > zero, self.high < zero) {
            (true, _) => Some(1),
            (_, true) => Some(-1),
            _ => (self.low == self.high).then_some(0),
        }
    }

    pub(crate) fn divide(&self, by: &Interval) -> Option<Self> {
        by.sign().filter(|sign| *sign != 0)?;
        let one = rational(1, 1);
        Some(self.multiply(&Interval { low: &one / &by.high, high: &one / &by.low }.rounded()))
    }

    pub(crate) fn integer_power(&self, n: i64) -> Option<Self> {
        let mut power = Interval::number(rational(1, 1));
        if n.abs() > LARGEST {
            return None;
        }
        for _ in 0..n.abs() {
            power = Some(power.multiply(self)).filter(|p| p.magnitude().numer().bits() < LARGEST_BITS)?;
        }
        if n < 0 { Interval::number(rational(1, 1)).divide(&power) } else { Some(power) }
    }

    /// Returns x^(p/q) = exp((p/q) log x) for x > 0; 0 for x = 0 and p > 0.
    pub(crate) fn power(&self, p: i64, q: i64) -> Option<Self> {
        match self.sign() {
            _ if q == 1 => self.integer_power(p),
            Some(1) => self.logarithm()?.scale(&rational(p, q)).exponential(),
            Some(0) if p > 0 => Some(self.clone()),
            _ => None,
        }
    }

    /// Sums Σ xⁿ/n!, Σ (−1)ⁿ x²ⁿ/(2n)!, Σ (−1)ⁿ x²ⁿ⁺¹/(2n+1)!. The remainder is at most twice the
    /// next term if each term is at most half the previous one.
    fn taylor(&self) -> [Self; 3] {
        let (x, mut term) = (Fixed::of(self), Fixed::one());
        let mut sums = [Fixed::default(), Fixed::default(), Fixed::default()];
        let mut n = 0;
        let end = self.magnitude() * rational(4, 1) + rational(TERMS, 1);
        while rational(n, 1) < end {
            sums[0].add(&term, false);
            sums[1 + (n % 2) as usize].add(&term, n % 4 >= 2);
            n += 1;
            term = term.multiply(&x).over(n);
        }
        sums.map(|sum| sum.widened(&term).into_interval())
    }

    /// Returns exp x = exp(x/2ᵏ)^(2ᵏ).
    pub(crate) fn exponential(&self) -> Option<Self> {
        if self.magnitude() > rational(LARGEST, 1) {
            return None;
        }
        let (mut reduced, mut squarings) = (self.clone(), 0);
        while reduced.magnitude() > rational(1, 2) {
            reduced = reduced.scale(&rational(1, 2));
            squarings += 1;
        }
        if squarings > 13 {
            return None;
        }
        let [start, ..] = reduced.taylor();
        Some((0..squarings).fold(start, |power, _| power.multiply(&power)))
    }

    /// Returns cos x and sin x.
    pub(crate) fn circular(&self) -> Option<[Self; 2]> {
        let [_, cosine, sine] = self.taylor_within(64)?;
        Some([cosine, sine])
    }

    fn taylor_within(&self, largest: i64) -> Option<[Self; 3]> {
        (self.magnitude() <= rational(largest, 1)).then(|| self.taylor())
    }

    /// Sums Σ sⁿ w²ⁿ⁺¹/(2n+1) for |w| ≤ 1/2: atan w for s = −1, artanh w for s = 1.
    fn odd_series(&self, s: i64) -> Self {
        let w = Fixed::of(self);
        let (square, mut sum, mut power) = (w.multiply(&w), Fixed::default(), w);
        for n in 0..TERMS / 2 {
            sum.add(&power.over(2 * n + 1), s < 0 && n % 2 == 1);
            power = power.multiply(&square);
        }
        sum.widened(&power).into_interval()
    }

    /// Returns log x from enclosures at both endpoints: the logarithm increases.
    pub(crate) fn logarithm(&self) -> Option<Self> {
        self.sign().filter(|sign| *sign > 0)?;
        Some(Interval { low: logarithm_of(&self.low)?.low, high: logarithm_of(&self.high)?.high })
    }

    /// Returns π = 4 (atan ½ + atan ⅓).
    pub(crate) fn pi() -> Self {
        static PI: OnceLock<Interval> = OnceLock::new();
        let part = |q| Interval::number(rational(1, q)).odd_series(-1);
        PI.get_or_init(|| part(2).add(&part(3)).scale(&rational(4, 1))).clone()
    }

    /// Returns log 2 = 2 artanh ⅓.
    fn logarithm_of_two() -> Self {
        static LOGARITHM: OnceLock<Interval> = OnceLock::new();
        let third = || Interval::number(rational(1, 3));
        LOGARITHM.get_or_init(|| third().odd_series(1).scale(&rational(2, 1))).clone()
    }

    /// Returns atan x, by atan x = π/2 − atan(1/x) for x > 1 and
    /// atan x = atan ½ + atan((x − ½)/(1 + x/2)) for ½ < x ≤ 1.
    pub(crate) fn arctangent(&self) -> Option<Self> {
        let (half, one) = (Interval::number(rational(1, 2)), Interval::number(rational(1, 1)));
        if self.magnitude() <= rational(1, 2) {
            return Some(self.odd_series(-1));
        }
        if self.sign()? < 0 {
            return Some(self.scale(&rational(-1, 1)).arctangent()?.scale(&rational(-1, 1)));
        }
        if self.high > rational(1, 1) {
            let turned = Some(one.divide(self)?).filter(|turned| turned.high <= rational(1, 1))?;
            return Some(Interval::pi().multiply(&half).subtract(&turned.arctangent()?));
        }
        let w = self.subtract(&half).divide(&one.add(&self.multiply(&half)))?;
        Some(half.odd_series(-1).add(&w.odd_series(-1)))
    }

    /// Encloses a function of the language at an argument; `None` where it is not certainly
    /// defined.
    pub(crate) fn function(name: &str, x: &Interval) -> Option<Self> {
        let one = Interval::number(rational(1, 1));
        match name {
            "exp" => x.exponential(),
            "log" => x.logarithm(),
            "atan" => x.arctangent(),
            "abs" => Some(if x.sign()? < 0 { x.scale(&rational(-1, 1)) } else { x.clone() }),
            "cos" => Some(x.circular()?[0].clone()),
            "sin" => Some(x.circular()?[1].clone()),
            "tan" => {
                let [cosine, sine] = x.circular()?;
                sine.divide(&cosine)
            }
            // asin x = atan(x/√(1 − x²))
            "asin" => x.divide(&one.subtract(&x.multiply(x)).power(1, 2)?)?.arctangent(),
            _ => None,
        }
    }
}

/// Returns log x = k log 2 + 2 artanh((z − 1)/(z + 1)) for x = 2ᵏ z > 0, with ½ < z < 2.
fn logarithm_of(x: &BigRational) -> Option<Interval> {
    let k = i64::try_from(x.numer().bits()).ok()? - i64::try_from(x.denom().bits()).ok()?;
    if k.abs() > LARGEST {
        return None;
    }
    let z = x * rational(2, 1).pow(i32::try_from(-k).ok()?);
    let w = (&z - rational(1, 1)) / (z + rational(1, 1));
    let two = Interval::logarithm_of_two().scale(&rational(k, 1));
    Some(two.add(&Interval::number(w).odd_series(1).scale(&rational(2, 1))))
}

/// Fixed-point interval, whose endpoints are integer multiples of 2^−BITS; used to sum series.
#[derive(Clone, Default)]
struct Fixed {
    low: BigInt,
    high: BigInt,
}

impl Fixed {
    fn one() -> Self {
        let one = BigInt::from(1) << BITS;
        Fixed { low: one.clone(), high: one }
    }

    fn of(interval: &Interval) -> Self {
        let scale = BigRational::from_integer(BigInt::from(1) << BITS);
        let (low, high) = (&interval.low * &scale, &interval.high * scale);
        Fixed { low: low.floor().to_integer(), high: high.ceil().to_integer() }
    }

    fn into_interval(self) -> Interval {
        let end = |units: BigInt| BigRational::new(units, BigInt::from(1) << BITS);
        Interval { low: end(self.low), high: end(self.high) }
    }

    fn add(&mut self, other: &Fixed, is_subtracted: bool) {
        let (low, high) =
            if is_subtracted { (-&other.high, -&other.low) } else { (other.low.clone(), other.high.clone()) };
        self.low += low;
        self.high += high;
    }

    /// Returns the product with its endpoints rounded outward: a right shift rounds down.
    fn multiply(&self, other: &Fixed) -> Self {
        let products = [
            &self.low * &other.low,
            &self.low * &other.high,
            &self.high * &other.low,
            &self.high * &other.high,
        ];
        let low = products.iter().min().cloned().unwrap_or_default() >> BITS;
        let high = products.into_iter().max().unwrap_or_default();
        Fixed { low, high: -(-high >> BITS) }
    }

    /// Returns the quotient by a positive integer.
    fn over(&self, n: i64) -> Self {
        // integer division truncates towards zero, which rounds negative numbers up
        let down = |end: &BigInt| {
            let quotient = end / n;
            if &quotient * n > *end { quotient - 1 } else { quotient }
        };
        Fixed { low: down(&self.low), high: -down(&-&self.high) }
    }

    /// Widens both ends by twice the largest magnitude of a remainder.
    fn widened(mut self, rest: &Fixed) -> Self {
        let magnitude = rest.high.clone().max(-rest.low.clone()) * 2;
        self.low -= &magnitude;
        self.high += magnitude;
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from 2⁻²⁰⁰⁰ to 2²⁰⁰⁰.
    fn numbers() -> Vec<BigRational> {
        let powers = [-2000, -161, -160, -159, -1, 0, 1, 3, 160, 2000].map(|n| rational(2, 1).pow(n));
        let factors = [rational(1, 1), rational(2, 3), rational(3, 2), rational(999_999, 1_000_000)];
        powers.iter().flat_map(|power| factors.iter().map(move |factor| power * factor)).collect()
    }

    #[test]
    fn the_logarithm_is_narrow_and_its_exponential_encloses_the_number() {
        for x in numbers() {
            let log = Interval::number(x.clone()).logarithm().expect("the number is positive");
            assert!(&log.high - &log.low < rational(2, 1).pow(-140), "{x}");
            let back = log.exponential().expect("the logarithm is below the largest");
            assert!(back.low <= x && x <= back.high, "{x}");
        }
    }

    #[test]
    fn the_logarithm_of_a_wide_interval_encloses_those_of_its_numbers() {
        let numbers = numbers();
        for low in &numbers {
            for high in numbers.iter().filter(|high| *high >= low) {
                let log = Interval { low: low.clone(), high: high.clone() }.logarithm().expect("positive");
                for x in numbers.iter().filter(|x| *x >= low && *x <= high) {
                    let inside = Interval::number(x.clone()).logarithm().expect("positive");
                    assert!(log.low <= inside.low && inside.high <= log.high, "{x} in {low} .. {high}");
                }
            }
        }
    }

    #[test]
    fn what_is_not_positive_or_is_too_large_has_no_logarithm() {
        let interval = |low: i64, high: i64| Interval { low: rational(low, 1), high: rational(high, 1) };
        assert!(interval(0, 1).logarithm().is_none());
        assert!(interval(-1, 1).logarithm().is_none());
        assert!(Interval::number(rational(2, 1).pow(5000)).logarithm().is_none());
        assert!(Interval::number(rational(2, 1).pow(-5000)).logarithm().is_none());
    }
}
