//! The statements of an emitted function.

use super::number::{number, receiver};
use crate::kernel::program::{Comparison, Instruction, Program, Value};
use crate::syntax::ast::Relation;
use std::fmt::Write;
use std::ops::Range;

/// The longest text of a value that is written where it is used.
const INLINED: usize = 36;
/// The longest array that stays on one line.
const ARRAY: usize = 60;

/// How tightly the outermost operator of a text binds.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Binding {
    Choice,
    Sum,
    Product,
    Sign,
    Atom,
}

/// A value's text.
pub(super) struct Written {
    pub(super) text: String,
    pub(super) binding: Binding,
}

impl Written {
    pub(super) fn atom(text: impl Into<String>) -> Self {
        Written { text: text.into(), binding: Binding::Atom }
    }

    /// The text, in brackets if it binds less tightly than its place needs.
    fn within(&self, needed: Binding) -> String {
        if self.binding >= needed { self.text.clone() } else { format!("({})", self.text) }
    }
}

/// Writes the statements that compute the program, and its outputs as the function's value.
pub(super) fn write(program: &Program, source: &mut String) {
    let mut body = Body {
        program,
        uses: uses(program),
        texts: Vec::with_capacity(program.instructions.len()),
        prefix: prefix(program),
        temporaries: 0,
    };
    let sides = program.domain.iter().flat_map(|condition| [condition.left, condition.right]);
    let head = sides.max().map_or(0, |last| last.place() + 1);
    body.write_instructions(0..head, source);
    body.write_domain(source);
    body.write_instructions(head..program.instructions.len(), source);
    body.write_outputs(source);
}

/// How often each value is used.
fn uses(program: &Program) -> Vec<usize> {
    let mut uses = vec![0; program.instructions.len()];
    let operands = program.instructions.iter().flat_map(Instruction::operands);
    for value in operands.chain(program.roots()) {
        uses[value.place()] += 1;
    }
    uses
}

/// What temporaries begin with: a `t` or as many as no argument begins with.
fn prefix(program: &Program) -> String {
    let mut prefix = "t".to_string();
    let is_taken = |prefix: &str| {
        let numbered =
            |name: &String| name.strip_prefix(prefix).is_some_and(|rest| rest.parse::<u32>().is_ok());
        program.arguments.iter().any(numbered)
    };
    while is_taken(&prefix) {
        prefix.push('t');
    }
    prefix
}

struct Body<'a> {
    program: &'a Program,
    uses: Vec<usize>,
    texts: Vec<Written>,
    prefix: String,
    temporaries: usize,
}

impl Body<'_> {
    fn text(&self, value: Value) -> &Written {
        &self.texts[value.place()]
    }

    fn write_instructions(&mut self, places: Range<usize>, source: &mut String) {
        for place in places {
            let written = self.instruction(&self.program.instructions[place]);
            if self.is_inlined(place, &written) {
                self.texts.push(written);
                continue;
            }
            let name = format!("{}{}", self.prefix, self.temporaries);
            self.temporaries += 1;
            let _ = writeln!(source, "    let {name} = {};", written.text);
            self.texts.push(Written::atom(name));
        }
    }

    /// Whether a value is written where it is used: arguments, numbers, and what is short and used once.
    fn is_inlined(&self, place: usize, written: &Written) -> bool {
        let is_result = self.program.outputs == [Value(place as u32)];
        match self.program.instructions[place] {
            Instruction::Constant(_) | Instruction::Argument(_) => true,
            Instruction::Select { .. } => is_result && self.uses[place] == 1,
            _ => self.uses[place] == 1 && (is_result || written.text.len() <= INLINED),
        }
    }

    fn write_domain(&self, source: &mut String) {
        let nan = match self.program.outputs.len() {
            1 => "f64::NAN".to_string(),
            several => format!("[f64::NAN; {several}]"),
        };
        for condition in &self.program.domain {
            let holds = self.comparison(condition);
            let _ = write!(
                source,
                "    let inside = {holds};\n    if !inside {{\n        return {nan};\n    }}\n"
            );
        }
    }

    fn write_outputs(&self, source: &mut String) {
        let outputs: Vec<&str> =
            self.program.outputs.iter().map(|&output| self.text(output).text.as_str()).collect();
        let line = outputs.join(", ");
        let _ = match outputs.len() {
            1 => writeln!(source, "    {line}"),
            _ if line.len() <= ARRAY => writeln!(source, "    [{line}]"),
            _ => writeln!(source, "    [\n        {},\n    ]", outputs.join(",\n        ")),
        };
    }

    fn instruction(&self, instruction: &Instruction) -> Written {
        let of = |value: Value, needed: Binding| self.text(value).within(needed);
        let infix = |a: Value, operator: &str, b: Value, left: Binding, right: Binding| Written {
            text: format!("{} {operator} {}", of(a, left), of(b, right)),
            binding: left,
        };
        match instruction {
            Instruction::Constant(constant) => number(constant),
            Instruction::Argument(place) => Written::atom(self.program.arguments[*place as usize].as_str()),
            Instruction::Add(a, b) => infix(*a, "+", *b, Binding::Sum, Binding::Product),
            Instruction::Subtract(a, b) => infix(*a, "-", *b, Binding::Sum, Binding::Product),
            Instruction::Multiply(a, b) => infix(*a, "*", *b, Binding::Product, Binding::Sign),
            Instruction::Divide(a, b) => infix(*a, "/", *b, Binding::Product, Binding::Sign),
            Instruction::Negate(a) => {
                Written { text: format!("-{}", of(*a, Binding::Atom)), binding: Binding::Sign }
            }
            Instruction::Sqrt(a) => self.method(*a, "sqrt", ""),
            Instruction::Power(a, exponent) => {
                let numerator = format!("{}.0", exponent.numer());
                let exponent = match exponent.denom() {
                    1 => numerator,
                    denominator => format!("{numerator} / {denominator}.0"),
                };
                self.method(*a, "powf", &exponent)
            }
            Instruction::Call(operation, operands) => {
                let rest: Vec<String> =
                    operands[1..].iter().map(|&operand| of(operand, Binding::Sum)).collect();
                let row = operation.row();
                self.method(operands[0], row.spelling.rust.unwrap_or(row.real), &rest.join(", "))
            }
            Instruction::Select { left, relation, right, then, otherwise } => {
                let condition = Comparison { left: *left, relation: *relation, right: *right };
                self.select(&condition, *then, *otherwise)
            }
        }
    }

    /// `x.sqrt()`
    fn method(&self, value: Value, name: &str, rest: &str) -> Written {
        let on = match self.program.instruction(value) {
            Instruction::Constant(constant) => receiver(constant),
            _ => self.text(value).within(Binding::Atom),
        };
        Written::atom(format!("{on}.{name}({rest})"))
    }

    /// Each branch is taken where its own comparison holds, so that NaN takes neither.
    fn select(&self, condition: &Comparison, then: Value, otherwise: Value) -> Written {
        let complement = condition.relation.complement().map_or("==", Relation::text);
        let [left, right] =
            [condition.left, condition.right].map(|side| self.text(side).within(Binding::Sum));
        let [then, otherwise] = [then, otherwise].map(|branch| &self.text(branch).text);
        let holds = self.comparison(condition);
        let text = format!(
            "if {holds} {{\n        {then}\n    }} else if {left} {complement} {right} {{\n        {otherwise}\n    }} \
             else {{\n        f64::NAN\n    }}"
        );
        Written { text, binding: Binding::Choice }
    }

    /// The relation as a condition that NaN does not meet.
    fn comparison(&self, condition: &Comparison) -> String {
        let [left, right] =
            [condition.left, condition.right].map(|side| self.text(side).within(Binding::Sum));
        match condition.relation {
            Relation::NotEqual => {
                let right = format!("&{}", self.text(condition.right).within(Binding::Sign));
                let order = self.method(condition.left, "partial_cmp", &right);
                format!("{}.is_some_and(core::cmp::Ordering::is_ne)", order.text)
            }
            relation => format!("{left} {} {right}", relation.text()),
        }
    }
}
