//! Arc sine, arc cosine, arc tangent and the angle of a point.

use super::bounds::{Enclosure, Undecided};
use super::constants::pi;
use super::range::Range;
use super::series::odd_reciprocals;
use num_bigint::BigInt;
use num_traits::One;

/// Guard places that absorb the rounding of a computation of a few hundred steps.
const GUARD: u32 = 16;

/// Number of times that the angle is halved before the series: tan(π/4/2³) < 1/10.
const HALVINGS: u32 = 3;

impl Enclosure {
    /// arctan a
    pub fn atan(&self) -> Enclosure {
        if self.is_zero() {
            return self.clone();
        }
        self.increasing(GUARD, arc_tangent)
    }

    /// arcsin a for −1 ≤ a ≤ 1
    pub fn asin(&self) -> Result<Enclosure, Undecided> {
        self.check_unit()?;
        if self.is_zero() {
            return Ok(self.clone());
        }
        Ok(self.increasing(self.precision().0 + GUARD, arc_sine))
    }

    /// arccos a = π/2 − arcsin a for −1 ≤ a ≤ 1
    pub fn acos(&self) -> Result<Enclosure, Undecided> {
        self.check_unit()?;
        if self.is_integer(1) {
            return Ok(Enclosure::integer(0, self.precision()));
        }
        let complement = self
            .neg()
            .increasing(self.precision().0 + GUARD, |x| arc_sine(x).add(&pi(x.precision).halved(1)));
        Ok(complement)
    }

    /// The angle of the point (x, y), in (−π, π), off the branch cut y = 0, x ≤ 0.
    ///
    /// arctan(y/x) for x > 0, ±π/2 − arctan(x/y) for ±y > 0
    pub fn atan2(y: &Enclosure, x: &Enclosure) -> Result<Enclosure, Undecided> {
        let precision = Enclosure::common_precision(y, x);
        let half_pi = || Enclosure::from_range(pi(precision + 1).halved(1).rescaled(precision));
        if x.is_positive() && (y.contains_zero() || x.sub(&y.abs()).is_nonnegative()) {
            return Ok(y.div(x)?.atan());
        }
        if y.is_positive() {
            return Ok(half_pi().sub(&x.div(y)?.atan()));
        }
        if y.is_negative() {
            return Ok(half_pi().add(&x.div(y)?.atan()).neg());
        }
        let on_the_cut = y.is_zero() && x.is_nonpositive();
        Err(if on_the_cut { Undecided::Undefined } else { Undecided::Unknown })
    }

    fn check_unit(&self) -> Result<(), Undecided> {
        let margin = Enclosure::integer(1, self.precision()).sub(&self.abs());
        match margin {
            _ if margin.is_negative() => Err(Undecided::Undefined),
            _ if margin.is_nonnegative() => Ok(()),
            _ => Err(Undecided::Unknown),
        }
    }
}

/// arctan x = ±π/2 − arctan(1/x) for ±x > 1
fn arc_tangent(x: &Range) -> Range {
    let one = BigInt::one() << x.precision;
    let fine = x.rescaled(x.precision + GUARD);
    let complement = || arc_tangent_of_slope(&Range::integer(1, fine.precision).divide(&fine));
    let half_pi = pi(fine.precision).halved(1);
    let angle = if x.lower > one {
        half_pi.subtract(&complement())
    } else if x.upper < -one {
        half_pi.add(&complement()).negate()
    } else {
        arc_tangent_of_slope(&fine)
    };
    angle.rescaled(x.precision)
}

/// arctan t = 2 arctan(t/(1 + √(1 + t²))), applied [`HALVINGS`] times, then Σ (−1)ᵏ t²ᵏ⁺¹/(2k+1),
/// for |t| about 1 or less
fn arc_tangent_of_slope(t: &Range) -> Range {
    let one = Range::integer(1, t.precision);
    let mut t = t.clone();
    for _ in 0..HALVINGS {
        t = t.divide(&one.add(&one.add(&t.square()).sqrt()));
    }
    let ratio = t.square().negate();
    odd_reciprocals(t, &ratio).doubled(HALVINGS)
}

/// arcsin x = 2 arctan(x/(1 + √(1 − x²))). An error ε in x² can grow to √ε, hence the doubled
/// precision.
fn arc_sine(x: &Range) -> Range {
    let one = Range::integer(1, x.precision);
    let cosine = one.subtract(&x.square()).sqrt();
    arc_tangent(&x.divide(&one.add(&cosine))).doubled(1)
}
