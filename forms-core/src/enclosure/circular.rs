//! Sine, cosine and tangent, by the quarter turn in which the argument lies.

use super::bounds::{Enclosure, Undecided, Value};
use super::constants::pi;
use super::exponential::rounded_quotient;
use super::range::Range;
use super::series::{Divisors, series};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive};

/// Angles beyond 2⁴⁰⁹⁶ are not reduced: their sine is enclosed by [−1, 1].
const LARGEST_ANGLE_BITS: u64 = 4096;

/// Guard places that absorb the rounding of a computation of a few hundred steps.
const GUARD: u32 = 16;

impl Enclosure {
    /// sin a
    pub fn sin(&self) -> Enclosure {
        if self.is_zero() {
            return self.clone();
        }
        self.wave(0)
    }

    /// cos a = sin(a + π/2)
    pub fn cos(&self) -> Enclosure {
        if self.is_zero() {
            return Enclosure::integer(1, self.precision());
        }
        self.wave(1)
    }

    /// tan a; unknown where the enclosure may contain a pole, an odd multiple of π/2
    pub fn tan(&self) -> Result<Enclosure, Undecided> {
        if self.is_zero() {
            return Ok(self.clone());
        }
        let precision = self.precision().0;
        let working = precision + GUARD;
        if self.magnitude_bits() > LARGEST_ANGLE_BITS {
            return Err(Undecided::Unknown);
        }
        let image = match &self.0 {
            Value::Exact(value, _) => tangent(&Range::rational(value, working))?,
            Value::Range(range) => {
                let range = range.rescaled(working);
                if quarter_turns(&range).is_none_or(|turns| turns.contains(&1) || turns.contains(&3)) {
                    return Err(Undecided::Unknown);
                }
                tangent(&range.lower_end())?.hull(tangent(&range.upper_end())?)
            }
        };
        Ok(Enclosure::from_range(image.rescaled(precision)))
    }

    /// {sin(x + turns·π/2)}
    fn wave(&self, turns: u32) -> Enclosure {
        let (precision, working) = (self.precision().0, self.precision().0 + GUARD);
        let image = match &self.0 {
            _ if self.magnitude_bits() > LARGEST_ANGLE_BITS => whole_wave(working),
            Value::Exact(value, _) => sine(&Range::rational(value, working), turns),
            Value::Range(range) => sine_of_range(&range.rescaled(working), turns),
        };
        Enclosure::from_range(image.within_unit().rescaled(precision))
    }
}

/// [−1, 1]
fn whole_wave(precision: u32) -> Range {
    Range::integer(-1, precision).hull(Range::integer(1, precision))
}

/// Encloses {sin(x + turns·π/2)}: for a narrow range about its midpoint m, by |sin x − sin m| ≤ |x
/// − m|, otherwise by the hull of the values at both ends and of the extrema between them.
fn sine_of_range(range: &Range, turns: u32) -> Range {
    if let Some((middle, radius)) = range.narrow_ball() {
        return sine(&middle, turns).widened(&radius);
    }
    let Some(between) = quarter_turns(range) else {
        return whole_wave(range.precision);
    };
    let mut image = sine(&range.lower_end(), turns).hull(sine(&range.upper_end(), turns));
    for turn in between {
        match (turn + turns) % 4 {
            1 => image = image.hull(Range::integer(1, range.precision)),
            3 => image = image.hull(Range::integer(-1, range.precision)),
            _ => {}
        }
    }
    image
}

/// Returns the multiples j·π/2 that may lie in the range, as j mod 4; `None` stands for all of
/// them.
///
/// These are the j with ⌊lower/(π/2)⌋ < j ≤ ⌊upper/(π/2)⌋, where each quotient uses the end of the
/// enclosure of π/2 that keeps more of them.
fn quarter_turns(range: &Range) -> Option<Vec<u32>> {
    let precision = range.precision + range.magnitude_bits() as u32 + GUARD;
    let half_pi = pi(precision).halved(1);
    let fine = range.rescaled(precision);
    let below = if fine.lower.is_negative() { &half_pi.lower } else { &half_pi.upper };
    let above = if fine.upper.is_negative() { &half_pi.upper } else { &half_pi.lower };
    let first: BigInt = fine.lower.div_floor(below) + 1;
    let last = fine.upper.div_floor(above);
    let count = (&last - &first + 1i32).to_i64().filter(|&count| count < 4)?;
    Some((0..count).map(|step| quadrant(&(&first + step))).collect())
}

/// j mod 4
fn quadrant(j: &BigInt) -> u32 {
    j.mod_floor(&BigInt::from(4)).to_u32().expect("a remainder by 4 is below 4")
}

/// Returns (j mod 4, r) for x = j·π/2 + r with |r| < 1.
fn reduced(x: &Range) -> (u32, Range) {
    let precision = x.precision + x.magnitude_bits() as u32 + GUARD;
    let half_pi = pi(precision).halved(1);
    let fine = x.rescaled(precision);
    let j = rounded_quotient(&fine.lower, &half_pi.lower);
    let r = fine.subtract(&half_pi.scaled(&j.clone().into()));
    (quadrant(&j), r.rescaled(x.precision + GUARD))
}

/// sin(x + turns·π/2): with x = j·π/2 + r it is sin r, cos r, −sin r, −cos r for j + turns = 0, 1,
/// 2, 3 mod 4
fn sine(x: &Range, turns: u32) -> Range {
    let (j, r) = reduced(x);
    let value = match (j + turns) % 4 {
        0 => sine_series(&r),
        1 => cosine_series(&r),
        2 => sine_series(&r).negate(),
        _ => cosine_series(&r).negate(),
    };
    value.rescaled(x.precision)
}

/// sin r = Σ (−1)ᵏ r²ᵏ⁺¹/(2k+1)!
fn sine_series(r: &Range) -> Range {
    series(r.clone(), &r.square().negate(), |k| Divisors { step: (2 * k + 2) * (2 * k + 3), term: 1 })
}

/// cos r = Σ (−1)ᵏ r²ᵏ/(2k)!
fn cosine_series(r: &Range) -> Range {
    let one = Range::integer(1, r.precision);
    series(one, &r.square().negate(), |k| Divisors { step: (2 * k + 1) * (2 * k + 2), term: 1 })
}

/// tan r, or −1/tan r after an odd number of quarter turns, with tan r = sin r/cos r
fn tangent(x: &Range) -> Result<Range, Undecided> {
    let (j, r) = reduced(x);
    let (sine, cosine) = (sine_series(&r), cosine_series(&r));
    let (numerator, denominator) = if j % 2 == 0 { (sine, cosine) } else { (cosine.negate(), sine) };
    if denominator.contains_zero() {
        return Err(Undecided::Unknown);
    }
    Ok(numerator.divide(&denominator).rescaled(x.precision))
}
