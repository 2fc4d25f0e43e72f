//! Value of a program in a finite field: exact, and available for every kind of instruction.
//!
//! In GF(p) with p ≡ 11 mod 12 every square has one root that is a square itself and every element
//! has one cube root, so rational powers have the meaning that they have among positive reals.
//! Functions, comparisons and π have no meaning there: fixed scrambled values replace them, which
//! is exact as long as a pass does not look into them.

use crate::expression::{Operation, Rational};
use crate::kernel::constant::Constant;
use crate::kernel::program::{Instruction, Program, Value};
use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::ToPrimitive;

/// The largest prime below 2⁶¹ that is 11 mod 12.
pub(super) const PRIME: u64 = 2305843009213693907;
/// Element assigned to π.
const PI: u64 = 314159265358979;

/// Returns the values of the sides of the conditions and of the outputs; `None` if one is
/// undefined.
pub(super) fn modular_values(program: &Program, arguments: &[u64]) -> Option<Vec<u64>> {
    let mut values: Vec<Option<u64>> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let value = modular_value(instruction, arguments, |value: Value| values[value.place()]);
        values.push(value);
    }
    program.roots().map(|root| values[root.place()]).collect()
}

fn modular_value(
    instruction: &Instruction,
    arguments: &[u64],
    of: impl Fn(Value) -> Option<u64>,
) -> Option<u64> {
    Some(match instruction {
        Instruction::Constant(constant) => number(constant)?,
        Instruction::Argument(place) => arguments[*place as usize],
        Instruction::Add(a, b) => add(of(*a)?, of(*b)?),
        Instruction::Subtract(a, b) => add(of(*a)?, PRIME - of(*b)?),
        Instruction::Multiply(a, b) => multiply(of(*a)?, of(*b)?),
        Instruction::Divide(a, b) => multiply(of(*a)?, inverse(of(*b)?)?),
        Instruction::MultiplyAdd(sum, [a, b, c]) => {
            let [left, right] = sum.terms(multiply(of(*a)?, of(*b)?), of(*c)?);
            add(left, if sum.is_difference() { PRIME - right } else { right })
        }
        Instruction::DifferenceOfProducts([a, b, c, d]) => {
            add(multiply(of(*a)?, of(*b)?), PRIME - multiply(of(*c)?, of(*d)?))
        }
        Instruction::SumOfProducts([a, b, c, d]) => {
            add(multiply(of(*a)?, of(*b)?), multiply(of(*c)?, of(*d)?))
        }
        Instruction::Negate(a) => add(0, PRIME - of(*a)?),
        Instruction::Sqrt(a) => rational_power(of(*a)?, Ratio::new(1, 2))?,
        Instruction::Power(a, exponent) => rational_power(of(*a)?, *exponent)?,
        Instruction::Call(operation, operands) => {
            let operands: Option<Vec<u64>> = operands.iter().map(|&operand| of(operand)).collect();
            scrambled(*operation, &operands?)
        }
        Instruction::Quadrature { operands, .. } => {
            let operands: Option<Vec<u64>> = operands.iter().map(|&operand| of(operand)).collect();
            operands?.into_iter().fold(1, |mixed, operand| add(multiply(mixed, PI), operand))
        }
        Instruction::Select { left, relation, right, then, otherwise } => {
            let side = multiply(of(*left)?, 3).wrapping_add(of(*right)?).wrapping_add(*relation as u64);
            // both branches have to be defined, as for the other instructions
            [of(*otherwise)?, of(*then)?][(side % 2) as usize]
        }
    })
}

fn number(constant: &Constant) -> Option<u64> {
    let pi = power(PI, constant.pi_exponent.unsigned_abs().into());
    let pi = if constant.pi_exponent < 0 { inverse(pi)? } else { pi };
    Some(multiply(residue(&constant.factor)?, pi))
}

fn residue(value: &Rational) -> Option<u64> {
    let modulus = BigInt::from(PRIME);
    let part = |part: &BigInt| ((part % &modulus + &modulus) % &modulus).to_u64();
    Some(multiply(part(value.numer())?, inverse(part(value.denom())?)?))
}

fn add(a: u64, b: u64) -> u64 {
    (a + b) % PRIME
}

fn multiply(a: u64, b: u64) -> u64 {
    (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
}

fn power(base: u64, exponent: u64) -> u64 {
    (0..u64::BITS).rev().fold(1, |power, bit| {
        let square = multiply(power, power);
        if exponent >> bit & 1 == 1 { multiply(square, base) } else { square }
    })
}

fn inverse(a: u64) -> Option<u64> {
    (a != 0).then(|| power(a, PRIME - 2))
}

/// aʳ: like negative reals, non-squares have no roots of any order; the cube root of a square is a
/// square. Denominators are products of twos and threes.
fn rational_power(a: u64, exponent: Ratio<i64>) -> Option<u64> {
    let (mut root, mut denominator) = (a, *exponent.denom());
    if denominator > 1 && a != 0 && power(a, (PRIME - 1) / 2) != 1 {
        return None;
    }
    while denominator % 2 == 0 {
        let square_root = power(root, PRIME.div_ceil(4));
        if multiply(square_root, square_root) != root {
            return None;
        }
        (root, denominator) = (square_root, denominator / 2);
    }
    while denominator % 3 == 0 {
        let third = (2 * u128::from(PRIME) - 1) / 3 % u128::from(PRIME - 1);
        (root, denominator) = (power(root, third as u64), denominator / 3);
    }
    let whole = power(root, exponent.numer().unsigned_abs());
    match (denominator, *exponent.numer() < 0) {
        (1, true) => inverse(whole),
        (1, false) => Some(whole),
        _ => None,
    }
}

fn scrambled(operation: Operation, operands: &[u64]) -> u64 {
    let start = 0x9e37_79b9_7f4a_7c15u64.wrapping_mul(operation as u64 + 1);
    let mix = |hash: u64, operand: &u64| (hash ^ operand).wrapping_mul(0xff51_afd7_ed55_8ccd).rotate_left(31);
    operands.iter().fold(start, mix) % PRIME
}
