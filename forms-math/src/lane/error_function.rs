//! erf x: a polynomial of x up to 1, and 1 − e^(ln erfc x) with a polynomial of x − 1 beyond. erfc x: 1 − erf x up
//! to ½, and e^(−x²) p/(|x| + 2) beyond, with a polynomial p of (|x| − 2)/(|x| + 2).

use super::exponential::{exp, exp_of_sum};
use super::pair::{Pair, pair, two_product};
use super::word::Word;

/// Computes erf x for 0 ≤ x ≤ 1.
#[inline(always)]
fn inner_erf<W: Word>(x: W) -> W {
    let square = x * x;
    let slope = Pair::<W>::of(W::TABLE.two_over_root_pi, 0);
    let linear = two_product(x, slope.head);
    let series = (x * square).fused(square.polynomial(W::TABLE.erf), x * slope.tail);
    linear.head + (linear.tail + series)
}

/// Returns the magnitude, or the end if it is less; NaN stays NaN.
#[inline(always)]
fn magnitude_up_to<W: Word>(x: W, end: W::Raw) -> W {
    let (magnitude, end) = (x.magnitude(), W::of(end));
    if magnitude > end { end } else { magnitude }
}

/// erf x = 2/√π ∫₀ˣ e^(−t²) dt
#[inline(always)]
pub(super) fn erf<W: Word>(x: W) -> W {
    let one = W::literal(1.0);
    let magnitude = x.magnitude();
    let clamped = magnitude_up_to(x, W::TABLE.erf_is_one);
    let outer = one - exp((clamped - one).polynomial(W::TABLE.ln_erfc));
    let value = if magnitude < one { inner_erf(magnitude) } else { outer };
    let tiny = magnitude < W::two_to(W::SMALL);
    (if tiny { x * W::of(W::TABLE.two_over_root_pi[0]) } else { value }).with_sign(x)
}

/// erfc x = 1 − erf x
#[inline(always)]
pub(super) fn erfc<W: Word>(x: W) -> W {
    let [zero, half, one, two] = [0.0, 0.5, 1.0, 2.0].map(W::literal);
    let clamped = magnitude_up_to(x, W::TABLE.erfc_is_zero);
    let square = two_product(clamped, clamped);
    let shifted = clamped + two;
    let quotient = ((clamped - two) / shifted).polynomial(W::TABLE.erfc) / shifted;
    let tail = exp_of_sum(pair(-square.head, -square.tail)) * quotient;
    let tail = if clamped >= W::of(W::TABLE.erfc_is_zero) { zero } else { tail };
    let outer = if x < zero { two - tail } else { tail };
    let inner = one - inner_erf(clamped).with_sign(x);
    if clamped <= half { inner } else { outer }
}
