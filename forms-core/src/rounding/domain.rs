//! Bounding box of a kernel's domain, from its conditions between an argument and a number.

use super::Unbounded;
use super::interval::Interval;
use crate::expression::Relation;
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

/// Narrows the range of an argument by a condition between this argument and a number.
fn narrow(program: &Program, condition: &Comparison, found: &mut Box) {
    let instruction = |value: Value| &program.instructions()[value.place()];
    let (place, relation, number) = match (instruction(condition.left), instruction(condition.right)) {
        (Instruction::Argument(place), Instruction::Constant(number)) => (*place, condition.relation, number),
        (Instruction::Constant(number), Instruction::Argument(place)) => {
            (*place, condition.relation.mirrored(), number)
        }
        _ => return,
    };
    let number = number.to_f64();
    let range = &mut found[place as usize];
    match relation {
        Relation::Less => range.upper = range.upper.min(number.next_down()),
        Relation::LessEqual => range.upper = range.upper.min(number),
        Relation::Greater => range.lower = range.lower.max(number.next_up()),
        Relation::GreaterEqual => range.lower = range.lower.max(number),
        Relation::NotEqual => {}
    }
}
