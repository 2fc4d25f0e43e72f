//! Value numbering: common subexpressions are computed once, and unused values are not computed.
//!
//! Sums and products are looked up in one order of their operands, and a − b and b − a share one
//! subtraction. Instructions come out in the order in which the outputs need them, after the
//! instructions of the domain's conditions.

use super::constant::Constant;
use super::program::{Instruction, Program, Value};
use rustc_hash::FxHashMap;

/// Returns the program with each value computed once.
pub(crate) fn number_values(program: &Program) -> Program {
    let program = &program.unfused();
    let mut numbering = Numbering::default();
    let mut values: Vec<Option<Value>> = vec![None; program.instructions.len()];
    for place in evaluation_order(program) {
        let of = |value: Value| values[value.place()].expect("operands come before results");
        let instruction = program.instructions[place].with_operands(of);
        values[place] = Some(numbering.value(instruction));
    }
    let of = |value: Value| values[value.place()].expect("every root was computed");
    without_unused(&program.with_instructions(numbering.instructions, of))
}

/// Returns the indices of the instructions that the roots need, operands before results, in the
/// order of first use.
fn evaluation_order(program: &Program) -> Vec<usize> {
    let mut done = vec![false; program.instructions.len()];
    let mut order = Vec::with_capacity(done.len());
    for root in program.roots() {
        let mut pending = vec![(root.place(), false)];
        while let Some((place, operands_done)) = pending.pop() {
            if done[place] {
                continue;
            }
            if operands_done {
                done[place] = true;
                order.push(place);
                continue;
            }
            pending.push((place, true));
            let operands = program.instructions[place].operands();
            pending.extend(operands.iter().rev().map(|operand| (operand.place(), false)));
        }
    }
    order
}

/// Removes the instructions that no root needs (dead code).
pub(super) fn without_unused(program: &Program) -> Program {
    let order = evaluation_order(program);
    let mut places = vec![Value(0); program.instructions.len()];
    let mut instructions = Vec::with_capacity(order.len());
    for place in order {
        places[place] = Value(instructions.len() as u32);
        instructions.push(program.instructions[place].with_operands(|operand| places[operand.place()]));
    }
    program.with_instructions(instructions, |root| places[root.place()])
}

#[derive(Default)]
struct Numbering {
    instructions: Vec<Instruction>,
    known: FxHashMap<Instruction, Value>,
}

impl Numbering {
    fn push(&mut self, instruction: Instruction) -> Value {
        if let Some(&known) = self.known.get(&instruction) {
            return known;
        }
        let fresh = Value(self.instructions.len() as u32);
        self.known.insert(instruction.clone(), fresh);
        self.instructions.push(instruction);
        fresh
    }

    /// Returns the value of an instruction over numbered values. Signs move outwards, where sums
    /// absorb them.
    fn value(&mut self, instruction: Instruction) -> Value {
        match instruction {
            Instruction::Add(a, b) => self.add(a, b),
            Instruction::Subtract(a, b) => self.subtract(a, b),
            Instruction::Negate(a) => self.negate(a),
            Instruction::Multiply(a, b) => {
                let [a, b] = if self.constant(b).is_some() { [b, a] } else { [a, b] };
                self.signed(a, b, Instruction::Multiply, Constant::times)
            }
            Instruction::Divide(a, b) => {
                let undefined = matches!(self.constant(b), Some(constant) if constant.is_zero());
                if undefined {
                    return self.push(instruction);
                }
                self.signed(a, b, Instruction::Divide, |a, b| a.times(&b.reciprocal()))
            }
            other => self.push(other),
        }
    }

    fn constant(&self, value: Value) -> Option<&Constant> {
        match &self.instructions[value.place()] {
            Instruction::Constant(constant) => Some(constant),
            _ => None,
        }
    }

    /// Returns the value that this one is the negative of: a for −a, and 3 for −3.
    fn positive_part(&mut self, value: Value) -> Option<Value> {
        match &self.instructions[value.place()] {
            Instruction::Negate(inner) => Some(*inner),
            Instruction::Constant(constant) if constant.is_negative() => {
                let positive = Instruction::Constant(constant.negated());
                Some(self.push(positive))
            }
            _ => None,
        }
    }

    /// a + (−b) = a − b, (−a) + b = b − a
    fn add(&mut self, a: Value, b: Value) -> Value {
        if let (Some(p), Some(q)) = (self.constant(a), self.constant(b))
            && let Some(sum) = p.plus(q)
        {
            return self.push(Instruction::Constant(sum));
        }
        if let Some(positive) = self.positive_part(b) {
            return self.subtract(a, positive);
        }
        if let Some(positive) = self.positive_part(a) {
            return self.subtract(b, positive);
        }
        self.push(Instruction::Add(a.min(b), a.max(b)))
    }

    /// a − (−b) = a + b, (−a) − b = −(a + b), and a − b = −(b − a) if b − a is known already
    fn subtract(&mut self, a: Value, b: Value) -> Value {
        if let Some(positive) = self.positive_part(b) {
            return self.add(a, positive);
        }
        if let Some(positive) = self.positive_part(a) {
            let sum = self.add(positive, b);
            return self.negate(sum);
        }
        if let Some(&opposite) = self.known.get(&Instruction::Subtract(b, a)) {
            return self.negate(opposite);
        }
        self.push(Instruction::Subtract(a, b))
    }

    fn negate(&mut self, a: Value) -> Value {
        match &self.instructions[a.place()] {
            Instruction::Negate(inner) => *inner,
            Instruction::Constant(constant) => {
                let negated = Instruction::Constant(constant.negated());
                self.push(negated)
            }
            _ => self.push(Instruction::Negate(a)),
        }
    }

    /// Builds a product or a quotient with its sign outside: (−a) b = −(a b).
    fn signed(
        &mut self,
        a: Value,
        b: Value,
        build: fn(Value, Value) -> Instruction,
        fold: fn(&Constant, &Constant) -> Constant,
    ) -> Value {
        if let (Some(p), Some(q)) = (self.constant(a), self.constant(b)) {
            let folded = fold(p, q);
            return self.push(Instruction::Constant(folded));
        }
        let (left, right) = (self.positive_part(a), self.positive_part(b));
        let negative = left.is_some() != right.is_some();
        let value = match build(left.unwrap_or(a), right.unwrap_or(b)) {
            // a number comes first, or else the value computed first
            Instruction::Multiply(a, b) if a > b && self.constant(a).is_none() => Instruction::Multiply(b, a),
            other => other,
        };
        let value = self.push(value);
        if negative { self.negate(value) } else { value }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::formula::program;

    #[test]
    fn what_is_computed_twice_is_computed_once() {
        let cases: [(&[&str], usize); 6] = [
            (&["x + y", "y + x"], 1),
            (&["x*y", "-y*x"], 2),
            (&["x - y", "y - x"], 2),
            (&["x/y", "-x/y"], 2),
            (&["-x*-y + 2*3"], 2),
            (&["2*pi*x", "pi*2*x"], 1),
        ];
        for (formulas, expected) in cases {
            let count = number_values(&program("x y", formulas)).operations();
            assert_eq!(count.arithmetic(), expected, "{formulas:?}: {count}");
        }
    }

    #[test]
    fn a_quotient_of_equals_is_not_one_since_it_is_undefined_at_zero() {
        assert_eq!(number_values(&program("x", &["x/x"])).operations().divisions, 1);
    }
}
