//! Bounding box of a kernel's domain, from its conditions between an argument and a number.

use super::Unbounded;
use super::interval::Interval;
use crate::expression::{Operation, Relation};
use crate::kernel::{Comparison, Instruction, Program, Value};

/// Range of each argument.
pub(super) type Box = Vec<Interval>;

/// Returns the box given by these conditions; it contains the domain. An error if a range that is
/// used is unbounded.
pub(super) fn domain(program: &Program) -> Result<Box, Unbounded> {
    let mut found = vec![Interval::EVERYTHING; program.arguments().len()];
    for condition in program.domain() {
        narrow(program, condition, &mut found);
    }
    let used = |place: usize| program.instructions().contains(&Instruction::Argument(place as u32));
    for (place, (range, name)) in found.iter_mut().zip(program.arguments()).enumerate() {
        if !used(place) {
            *range = Interval::ZERO;
        } else if !range.is_finite() {
            return Err(Unbounded::Argument(name.clone()));
        }
    }
    Ok(found)
}

/// Narrows the range of an argument by a condition between this argument, or its absolute value, and
/// a number.
fn narrow(program: &Program, condition: &Comparison, found: &mut Box) {
    let instruction = |value: Value| &program.instructions()[value.place()];
    let (side, relation, number) = match (instruction(condition.left), instruction(condition.right)) {
        (side, Instruction::Constant(number)) => (side, condition.relation, number),
        (Instruction::Constant(number), side) => (side, condition.relation.mirrored(), number),
        _ => return,
    };
    let number = number.to_f64();
    match side {
        Instruction::Argument(place) => narrow_by(&mut found[*place as usize], relation, number),
        Instruction::Call(Operation::Abs, operands) => {
            let is_upper = matches!(relation, Relation::Less | Relation::LessEqual);
            if let (Instruction::Argument(place), true) = (instruction(operands[0]), is_upper) {
                let range = &mut found[*place as usize];
                narrow_by(range, relation, number);
                narrow_by(range, relation.mirrored(), -number);
            }
        }
        _ => {}
    }
}

fn narrow_by(range: &mut Interval, relation: Relation, number: f64) {
    match relation {
        Relation::Less => range.upper = range.upper.min(number.next_down()),
        Relation::LessEqual => range.upper = range.upper.min(number),
        Relation::Greater => range.lower = range.lower.max(number.next_up()),
        Relation::GreaterEqual => range.lower = range.lower.max(number),
        Relation::NotEqual => {}
    }
}
