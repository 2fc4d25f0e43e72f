//! Statements of an emitted function.

use super::blocks::{Block, Blocks, FUNCTION};
use super::dialect::{Branches, ChoiceFunction, Choices, Dialect};
use super::unordered::{Unordered, unordered};
use super::written::{Binding, Written, infix, negated};
use crate::kernel::{Comparison, Instruction, Program, Value};
use std::fmt::Write;
use std::ops::Range;

/// Length of the longest text of a value that is written where it is used.
const INLINED: usize = 36;
/// Spaces of one level of indentation.
const INDENT: usize = 4;

/// Writes the statements that compute the program, and its outputs as the function's value.
/// `arguments` are the names of the arguments.
pub(super) fn write(dialect: &dyn Dialect, program: &Program, arguments: &[String]) -> String {
    let (blocks, unordered) = match dialect.choices() {
        Choices::Function(_) => (Blocks::one(program), unordered(program)),
        Choices::Branches(_) => (Blocks::nested(program), Vec::new()),
    };
    let mut body = Body {
        dialect,
        program,
        arguments,
        uses: program.uses(),
        blocks,
        unordered,
        texts: vec![None; program.instructions.len()],
        prefix: prefix(arguments),
        temporaries: 0,
        inside: None,
    };
    body.write_leaves();
    let head = program.head();
    let mut source = body.block(FUNCTION, 0..head, 1);
    if let Choices::Branches(branches) = dialect.choices() {
        source += &body.domain(branches);
    }
    source += &body.block(FUNCTION, head..program.instructions.len(), 1);
    source + &body.results()
}

/// Returns the prefix of temporaries: the shortest run of `t` for which no argument is named like a
/// temporary. An argument can be an element of an array, `p[0]`.
fn prefix(arguments: &[String]) -> String {
    let mut prefix = "t".to_string();
    let is_taken = |prefix: &str| {
        let numbered = |text: &String| {
            let name = text.split('[').next().unwrap_or_default();
            name.strip_prefix(prefix).is_some_and(|rest| rest.parse::<u32>().is_ok())
        };
        arguments.iter().any(numbered)
    };
    while is_taken(&prefix) {
        prefix.push('t');
    }
    prefix
}

struct Body<'a> {
    dialect: &'a dyn Dialect,
    program: &'a Program,
    arguments: &'a [String],
    uses: Vec<usize>,
    blocks: Blocks,
    /// For a language whose conditionals are functions, their behaviour if their sides cannot be
    /// compared.
    unordered: Vec<Unordered>,
    texts: Vec<Option<Written>>,
    prefix: String,
    temporaries: usize,
    /// Variable that says whether all conditions of the domain hold, if there is one.
    inside: Option<String>,
}

impl Body<'_> {
    fn text(&self, value: Value) -> &Written {
        self.texts[value.place()].as_ref().expect("operands are written before results")
    }

    fn temporary(&mut self) -> String {
        self.temporaries += 1;
        format!("{}{}", self.prefix, self.temporaries - 1)
    }

    /// Writes arguments and numbers, which appear where they are used.
    fn write_leaves(&mut self) {
        for (place, instruction) in self.program.instructions.iter().enumerate() {
            self.texts[place] = match instruction {
                Instruction::Constant(constant) => {
                    Some(Written { constant: Some(constant.clone()), ..self.dialect.number(constant) })
                }
                Instruction::Argument(argument) => {
                    Some(Written::name(self.arguments[*argument as usize].as_str()))
                }
                _ => None,
            };
        }
    }

    /// Writes the statements of a block at this level, restricted to the instructions in `places`.
    fn block(&mut self, block: Block, places: Range<usize>, level: usize) -> String {
        let mut source = String::new();
        for place in self.blocks.members(block) {
            if !places.contains(&place) {
                continue;
            }
            let written = match self.assigned(place, level, &mut source) {
                Some(variable) => variable,
                None => self.instruction(place, level),
            };
            let is_inlined = self.is_inlined(place, block, &written);
            self.texts[place] = Some(if is_inlined {
                written
            } else {
                let name = self.temporary();
                let declaration = self.dialect.declaration(&name, &written.text);
                let _ = writeln!(source, "{}{declaration}", margin(level));
                Written::name(name)
            });
        }
        source
    }

    /// Writes a conditional whose branches assign to a variable, and returns the variable.
    fn assigned(&mut self, place: usize, level: usize, source: &mut String) -> Option<Written> {
        let dialect = self.dialect;
        let Choices::Branches(branches) = dialect.choices() else { return None };
        let Instruction::Select { .. } = self.program.instructions[place] else { return None };
        let declaration = branches.variable(&format!("{}{}", self.prefix, self.temporaries))?;
        let name = self.temporary();
        let choice = self.select(branches, place, level, |value| format!("{name} = {value};"));
        let margin = margin(level);
        let _ = writeln!(source, "{margin}{declaration}\n{margin}{choice}");
        Some(Written::name(name))
    }

    /// Whether a value is written where it is used: the final value of a block, or a short value
    /// that is used once.
    fn is_inlined(&self, place: usize, block: Block, written: &Written) -> bool {
        let is_short = written.text.len() <= INLINED && written.binding != Binding::Choice;
        let is_value = self.blocks.value(block) == Some(Value(place as u32));
        written.is_name || (self.uses[place] == 1 && (is_short || is_value))
    }

    fn domain(&mut self, branches: &dyn Branches) -> String {
        let comparison = |condition: &Comparison| {
            let [left, right] = [condition.left, condition.right].map(|side| self.text(side));
            branches.comparison(left, Some(condition.relation), right)
        };
        let comparisons: Vec<String> = self.program.domain.iter().map(comparison).collect();
        if comparisons.is_empty() {
            return String::new();
        }
        let name = format!("{}{}", self.prefix, self.temporaries);
        let outputs = self.program.outputs.len();
        if let Some(declaration) = branches.inside(&name, &comparisons, outputs) {
            self.inside = Some(self.temporary());
            return format!("{}{declaration}\n", margin(1));
        }
        comparisons.iter().map(|comparison| branches.leave_unless(comparison, outputs)).collect()
    }

    /// Writes the outputs. If conditionals are functions, or the language chooses between outputs and
    /// NaN, each output is NaN where a condition of the domain fails.
    fn results(&self) -> String {
        let outputs = self.program.outputs.iter().map(|&output| match self.dialect.choices() {
            Choices::Function(function) => self.inside_domain(function, self.text(output)).text,
            Choices::Branches(branches) => {
                let (value, outputs) = (self.text(output), self.program.outputs.len());
                let chosen = self.inside.as_ref().map(|inside| branches.if_inside(inside, value, outputs));
                chosen.unwrap_or_else(|| value.clone()).text
            }
        });
        let outputs: Vec<String> = outputs.collect();
        let outputs: Vec<&str> = outputs.iter().map(String::as_str).collect();
        self.dialect.results(&outputs)
    }

    fn inside_domain(&self, function: &dyn ChoiceFunction, output: &Written) -> Written {
        let nan = Written::atom(self.dialect.nan());
        self.program.domain.iter().rev().fold(output.clone(), |value, condition| {
            let sides = [condition.left, condition.right].map(|side| self.text(side));
            function.choice(sides, condition.relation, [&value, &nan], Unordered::Otherwise)
        })
    }

    fn instruction(&mut self, place: usize, level: usize) -> Written {
        let instruction = &self.program.instructions[place];
        match instruction {
            Instruction::Constant(_) | Instruction::Argument(_) => {
                unreachable!("arguments and numbers are written before")
            }
            Instruction::Add(a, b) => infix(self.text(*a), "+", self.text(*b)),
            Instruction::Subtract(a, b) => infix(self.text(*a), "-", self.text(*b)),
            Instruction::Multiply(a, b) => infix(self.text(*a), "*", self.text(*b)),
            Instruction::Divide(a, b) => infix(self.text(*a), "/", self.text(*b)),
            Instruction::Negate(a) => negated(self.text(*a)),
            Instruction::MultiplyAdd(sum, values) => {
                self.dialect.multiply_add(*sum, values.map(|value| self.text(value)))
            }
            Instruction::DifferenceOfProducts(factors) => {
                self.dialect.difference_of_products(factors.map(|factor| self.text(factor)))
            }
            Instruction::SumOfProducts(factors) => {
                self.dialect.sum_of_products(factors.map(|factor| self.text(factor)))
            }
            Instruction::Sqrt(a) => self.dialect.sqrt(self.text(*a)),
            Instruction::Power(a, exponent) => self.dialect.power(self.text(*a), *exponent),
            Instruction::Call(operation, operands) => {
                let operands: Vec<&Written> = operands.iter().map(|&operand| self.text(operand)).collect();
                self.dialect.call(*operation, &operands)
            }
            Instruction::Quadrature { integrand, operands } => {
                let operands: Vec<&Written> = operands.iter().map(|&operand| self.text(operand)).collect();
                self.dialect.quadrature(integrand, &operands)
            }
            Instruction::Select { left, relation, right, then, otherwise } => {
                let dialect = self.dialect;
                match dialect.choices() {
                    Choices::Function(function) => {
                        let [left, right, then, otherwise] =
                            [left, right, then, otherwise].map(|&value| self.text(value));
                        function.choice([left, right], *relation, [then, otherwise], self.unordered[place])
                    }
                    Choices::Branches(branches) => {
                        let text = self.select(branches, place, level, str::to_string);
                        Written::new(text, Binding::Choice)
                    }
                }
            }
        }
    }

    /// Writes an `if` in which each branch is taken if its own comparison holds, so that NaN takes
    /// neither. A branch ends in the text that `end` makes of its value.
    fn select(
        &mut self,
        language: &dyn Branches,
        place: usize,
        level: usize,
        end: impl Fn(&str) -> String,
    ) -> String {
        let Instruction::Select { left, relation, right, then, otherwise } = self.program.instructions[place]
        else {
            unreachable!("only choices are written as choices");
        };
        let blocks = self.blocks.branches(place).expect("every choice has its branches");
        let [holds, fails] = [Some(relation), relation.complement()].map(|relation| {
            language.condition(&language.comparison(self.text(left), relation, self.text(right)))
        });
        let [then, otherwise] = [(blocks[0], then), (blocks[1], otherwise)].map(|(block, value)| {
            let lines = self.block(block, 0..place, level + 1);
            format!("{lines}{}{}", margin(level + 1), end(&self.text(value).text))
        });
        let (margin, nan) = (margin(level), end(&self.dialect.nan()));
        format!(
            "if {holds} {{\n{then}\n{margin}}} else if {fails} {{\n{otherwise}\n{margin}}} else {{\n\
             {margin}    {nan}\n{margin}}}"
        )
    }
}

/// Returns the indentation of a statement at this level.
fn margin(level: usize) -> String {
    " ".repeat(level * INDENT)
}
