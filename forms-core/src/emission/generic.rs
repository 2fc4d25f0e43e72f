//! Generic body: `impl Formula<…> for …`, straight-line code that runs in any `Real`.
//!
//! Conditionals compute both branches, so that the same body runs in the lanes of a vector; outside
//! the domain every output is NaN. Numbers are written exactly, with two words for the precisions
//! that need no more.

use super::attributes::attributes;
use super::body;
use super::dialect::{ChoiceFunction, Choices, Dialect};
use super::docs::{KernelDocs, documentation};
use super::number::number;
use super::parameters::{nested_element, nested_type, numbers};
use super::rust_results::{array_type, result_type, results_of_array};
use super::target::Precision;
use super::unordered::Unordered;
use super::written::{Binding, Written, function, negated};
use crate::expression::{Operation, Parameter, Relation, Shape};
use crate::kernel::{Constant, Instruction, ProductSum, Program};
use num_rational::Ratio;

/// Name of the module that is pasted next to kernels.
pub(super) const MATH: &str = "forms_math";

/// Emits `impl FORMULA for TYPE`; the path `math` leads to the items that `forms_math` exports.
pub fn emit_formula(program: &Program, type_name: &str, math: &str) -> String {
    let (arguments, outputs) = (program.arguments.len(), program.outputs.len());
    let names: Vec<String> = (0..arguments).map(|place| format!("x{place}")).collect();
    let used = |place: usize| program.instructions.contains(&Instruction::Argument(place as u32));
    let bound: Vec<&str> =
        names.iter().enumerate().map(|(place, name)| if used(place) { name.as_str() } else { "_" }).collect();
    let body = body::write(&Generic { math }, program, &names);
    let gives_up = if program.instructions.iter().all(lanes_have_it_everywhere) {
        "    const MAY_GIVE_UP: bool = false;\n"
    } else {
        ""
    };
    format!(
        "impl {math}::Formula<{arguments}, {outputs}> for {type_name} {{\n{gives_up}    \
         #[inline(always)]\n    \
         fn value<T: {math}::Real>([{}]: [T; {arguments}]) -> [T; {outputs}] {{\n{body}    }}\n}}\n",
        bound.join(", ")
    )
}

/// Whether lanes can compute an instruction for all operands: arithmetic, conditionals, roots and
/// absolute values.
fn lanes_have_it_everywhere(instruction: &Instruction) -> bool {
    match instruction {
        Instruction::Call(operation, _) => *operation == Operation::Abs,
        Instruction::Power(..) | Instruction::Quadrature { .. } => false,
        _ => true,
    }
}

/// Writes a type `Formula` of the program, to be nested in a function.
pub(super) fn nested_formula(program: &Program) -> String {
    let formula = emit_formula(program, "Formula", MATH);
    let lines: String = formula.lines().map(|line| format!("    {line}\n")).collect();
    format!("    enum Formula {{}}\n{lines}")
}

/// Writes a documented function of double-doubles that contains its formula. If the kernel promises
/// an accuracy, the function keeps its digits by higher precision.
pub(super) fn double_double(program: &Program, docs: &KernelDocs, promised: bool) -> String {
    let number = "forms_math::DoubleDouble";
    let parameters = program.signature.parameters.iter();
    let parameters: Vec<String> = parameters
        .map(|Parameter { name, shape }| format!("{name}: {}", nested_type(*shape, number, array_type)))
        .collect();
    let (count, outputs) = (program.arguments.len(), program.outputs.len());
    let results = &program.signature.results;
    let formula = nested_formula(program);
    let value = if promised {
        format!("forms_math::escalate_double_double::<Formula, {count}, {outputs}>")
    } else {
        format!("<Formula as forms_math::Formula<{count}, {outputs}>>::value")
    };
    let values = format!("{value}([{}])", numbers(program, nested_element).join(", "));
    let body = match results.as_slice() {
        [Shape::Number] => format!("    {values}[0]\n"),
        results => results_of_array(results, &values),
    };
    format!(
        "{}{}{}fn {}(\n{}) -> {} {{\n{formula}{body}}}\n",
        documentation(program, docs, "///"),
        attributes(program),
        if program.public { "pub " } else { "" },
        program.name,
        parameters.iter().map(|parameter| format!("    {parameter},\n")).collect::<String>(),
        result_type(results, number),
    )
}

/// Writes `quadrature(from, to, |s| …)`, preceded by names for the values that the integrand
/// depends on.
pub(super) fn closure(
    dialect: &dyn Dialect,
    quadrature: &str,
    integrand: &Program,
    operands: &[&Written],
    result: impl Fn(&str) -> String,
) -> Written {
    let [from, to, captured @ ..] = operands else { return Written::atom(dialect.nan()) };
    let names: Vec<String> = (0..captured.len()).map(|place| format!("k{place}")).collect();
    let arguments: Vec<String> = std::iter::once("s".to_string()).chain(names.iter().cloned()).collect();
    let body = result(&body::write(dialect, integrand, &arguments));
    let values: Vec<String> = captured.iter().map(|value| value.argument()).collect();
    let (from, to) = (from.argument(), to.argument());
    let captures = match captured {
        [] => String::new(),
        _ => format!("    let [{}] = [{}];\n", names.join(", "), values.join(", ")),
    };
    Written::atom(format!(
        "{{\n    let (from, to) = ({from}, {to});\n{captures}    {quadrature}(from, to, |s| {{\n{body}    }})\n}}"
    ))
}

/// Rust over any `T: Real`.
struct Generic<'a> {
    math: &'a str,
}

impl Generic<'_> {
    fn method(value: &Written, name: &str, rest: &[String]) -> Written {
        Written::atom(format!("{}.{name}({})", value.within(Binding::Atom), rest.join(", ")))
    }

    fn associated(name: &str, operands: &[&Written]) -> Written {
        function(&format!("T::{name}"), operands)
    }
}

impl Dialect for Generic<'_> {
    fn choices(&self) -> Choices<'_> {
        Choices::Function(self)
    }

    fn number(&self, constant: &Constant) -> Written {
        // the first word by its name, if it has one
        let first = number(constant, Precision::F64).text;
        if constant.is_double() {
            return Written::atom(format!("T::from_f64({first})"));
        }
        let rest = constant.words(2).get(1).copied().unwrap_or(0.0);
        let [numerator, denominator] = constant.natural_words();
        let (math, exponent) = (self.math, constant.pi_exponent);
        Written::atom(format!(
            "T::number({math}::Number::new([{first}, {rest:?}], &{numerator:?}, &{denominator:?}, {exponent}))"
        ))
    }

    fn sqrt(&self, value: &Written) -> Written {
        Self::method(value, "sqrt", &[])
    }

    fn power(&self, value: &Written, exponent: Ratio<i64>) -> Written {
        Self::method(value, "power", &[exponent.numer().to_string(), exponent.denom().to_string()])
    }

    fn call(&self, operation: Operation, operands: &[&Written]) -> Written {
        let rest: Vec<String> = operands[1..].iter().map(|operand| operand.argument()).collect();
        Self::method(operands[0], operation.row().real, &rest)
    }

    fn difference_of_products(&self, factors: [&Written; 4]) -> Written {
        Self::associated("difference_of_products", &factors)
    }

    fn sum_of_products(&self, factors: [&Written; 4]) -> Written {
        Self::associated("sum_of_products", &factors)
    }

    fn multiply_add(&self, sum: ProductSum, [a, b, c]: [&Written; 3]) -> Written {
        let [factor, summand] = sum.signed(a.clone(), c.clone(), |value| negated(&value));
        Self::method(&factor, "mul_add", &[b.argument(), summand.argument()])
    }

    fn quadrature(&self, integrand: &Program, operands: &[&Written]) -> Written {
        closure(self, "T::quadrature", integrand, operands, |value| {
            format!("let [value] = {{\n{value}}};\nvalue\n")
        })
    }

    fn nan(&self) -> String {
        "T::nan()".to_string()
    }

    fn declaration(&self, name: &str, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn results(&self, outputs: &[&str]) -> String {
        format!("    [{}]\n", outputs.join(", "))
    }
}

impl ChoiceFunction for Generic<'_> {
    fn choice(
        &self,
        [left, right]: [&Written; 2],
        relation: Relation,
        [then, otherwise]: [&Written; 2],
        unordered: Unordered,
    ) -> Written {
        // a single comparison gives the second value if it fails, and so also if the sides cannot
        // be compared
        let (relation, then, otherwise) = match (unordered, relation.complement()) {
            (Unordered::Then, Some(complement)) => (complement, otherwise, then),
            _ => (relation, then, otherwise),
        };
        let (name, operands) = match relation {
            Relation::Less => ("if_less", [left, right, then, otherwise]),
            Relation::Greater => ("if_less", [right, left, then, otherwise]),
            Relation::LessEqual => ("if_less_equal", [left, right, then, otherwise]),
            Relation::GreaterEqual => ("if_less_equal", [right, left, then, otherwise]),
            Relation::NotEqual => ("if_equal", [left, right, otherwise, then]),
        };
        let looks_twice = match unordered {
            Unordered::Nan => true,
            Unordered::Otherwise => relation == Relation::NotEqual,
            Unordered::Then | Unordered::Either => false,
        };
        let name = if looks_twice { name.to_string() } else { format!("either_{name}") };
        Self::associated(&name, &operands)
    }
}
