//! In-order compilation: sums and products stay grouped as they were written, for forms chosen for
//! their accuracy.
//!
//! ```text
//! written ─ powers as products ─ number_values ─ absorb_signs ─ compensate ─ fuse ─ schedule
//! ```
//! The other passes regroup sums and products: their value does not depend on the grouping, but
//! their rounding does.

use super::program::{Instruction, Program, Value};
use super::rebuild::Rebuilt;
use super::shared_divisors::share_divisors;
use num_integer::Integer;
use num_rational::Ratio;

/// Largest power that is written out as products.
const WRITTEN_OUT: i64 = 8;

impl Program {
    /// Returns the same kernel with every sum and product grouped as written; products that may
    /// cancel are compensated.
    pub fn in_order(&self) -> Program {
        self.grouped_as_written().compensate()
    }

    /// Returns the same kernel in order, with the divisors that several quotients share inverted once.
    pub(crate) fn in_order_with_shared_divisors(&self) -> Program {
        super::optimise::grouped(&share_divisors(&self.grouped_as_written())).compensate()
    }

    fn grouped_as_written(&self) -> Program {
        super::optimise::grouped(&written_out(&self.with_integrands(Program::in_order)))
    }
}

/// Writes small integer powers as products, and half-integer powers with one root.
fn written_out(program: &Program) -> Program {
    program.rebuilt(|rebuilt, instruction| match *instruction {
        Instruction::Power(base, exponent) if is_short(exponent) => {
            Some(power(rebuilt, rebuilt.value(base), exponent))
        }
        _ => None,
    })
}

fn is_short(exponent: Ratio<i64>) -> bool {
    *exponent.denom() <= 2 && exponent.numer().abs() <= WRITTEN_OUT * exponent.denom()
}

/// xⁿ by squaring, x^(n/2) = x^⌊n/2⌋ √x, x⁻ʳ = 1/xʳ
fn power(rebuilt: &mut Rebuilt, base: Value, exponent: Ratio<i64>) -> Value {
    let size = exponent.numer().abs();
    let (whole, half) = size.div_rem(exponent.denom());
    let mut factors: Vec<Value> = Vec::new();
    let (mut square, mut rest) = (base, whole);
    while rest > 0 {
        if rest.is_odd() {
            factors.push(square);
        }
        rest /= 2;
        if rest > 0 {
            square = rebuilt.push(Instruction::Multiply(square, square));
        }
    }
    if half > 0 {
        factors.push(rebuilt.push(Instruction::Sqrt(base)));
    }
    let product = factors
        .into_iter()
        .reduce(|product, factor| rebuilt.push(Instruction::Multiply(product, factor)))
        .expect("an exponent is not zero");
    if *exponent.numer() > 0 {
        return product;
    }
    let one = rebuilt.integer(1);
    rebuilt.push(Instruction::Divide(one, product))
}

#[cfg(test)]
mod tests {
    use crate::kernel::formula::program;

    #[test]
    fn sums_stay_grouped_and_powers_become_products() {
        let written = program("a b c", &["c - (a - b)", "a**6 + b**(-3/2)", "(a + b) - a"]);
        let kept = written.in_order();
        assert_eq!(kept.operations().function_calls, 0);
        let point = [1e16, 1.0, 3.0];
        assert_eq!(kept.interpret(&point)[0], 3.0 - (1e16 - 1.0));
        assert_eq!(kept.interpret(&point)[2], (1e16 + 1.0) - 1e16);
        assert_eq!(kept.interpret(&[2.0, 4.0, 0.0])[1], 64.125);
    }
}
