//! erf x: a polynomial of x up to 1, and 1 − e^(ln erfc x) with a polynomial of x − 1 beyond.

use super::exponential::exp;
use super::pair::{Pair, two_product};
use super::word::Word;

/// erf x = 2/√π ∫₀ˣ e^(−t²) dt
#[inline(always)]
pub(super) fn erf<W: Word>(x: W) -> W {
    let one = W::literal(1.0);
    let magnitude = x.magnitude();
    let square = magnitude * magnitude;
    let slope = Pair::<W>::of(W::TABLE.two_over_root_pi, 0);
    let linear = two_product(magnitude, slope.head);
    let series = (magnitude * square).fused(square.polynomial(W::TABLE.erf), magnitude * slope.tail);
    let inner = linear.head + (linear.tail + series);
    let end = W::of(W::TABLE.erf_is_one);
    let clamped = if magnitude > end { end } else { magnitude };
    let outer = one - exp((clamped - one).polynomial(W::TABLE.ln_erfc));
    let value = if magnitude < one { inner } else { outer };
    let tiny = magnitude < W::two_to(W::SMALL);
    (if tiny { x * slope.head } else { value }).with_sign(x)
}
