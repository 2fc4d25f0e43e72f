//! WGSL: one function per kernel over `f32`, and an entry point that computes it over buffers.
//!
//! The language has no notation for NaN, and compilers may assume that NaN does not occur: outside
//! the domain of a kernel its value is NaN if the device has NaN.

use super::c::unequal_as_less_or_greater;
use super::dialect::{Branches, Choices, Dialect};
use super::docs::{KernelDocs, documentation};
use super::number::literal;
use super::parameters::{nested_element, numbers};
use super::shader_functions::{DEFINITIONS, Definition, definition};
use super::shader_values::{nested, results, type_of};
use super::target::Precision;
use super::written::{Written, function, infix, negated};
use super::{batch, body};
use crate::expression::{Operation, Parameter, Relation, Shape};
use crate::kernel::{Constant, Instruction, ProductSum, Program};
use num_rational::Ratio;

/// Longest line of a signature.
const WIDTH: usize = 100;

/// NaN through a variable, since a constant cannot be NaN.
const NAN: &str = "\
fn forms_nan() -> f32 {
    var bits = 0x7fc00000u;
    return bitcast<f32>(bits);
}
";

/// a b − c d by the error of one product, after Kahan.
const DIFFERENCE_OF_PRODUCTS: &str = "\
// a b - c d, corrected by the rounding error of one product (Kahan); assumes that fma rounds once.
fn forms_difference_of_products(a: f32, b: f32, c: f32, d: f32) -> f32 {
    let product = c * d;
    let error = fma(-c, d, product);
    return fma(a, b, -product) + error;
}
";

/// Writes the buffers and the helper functions that these programs need.
pub(super) fn head(programs: &[&Program]) -> String {
    let needs = |is_needed: fn(&Instruction) -> bool| {
        programs.iter().any(|program| program.instructions.iter().any(is_needed))
    };
    let has_domain = programs.iter().any(|program| !program.domain.is_empty());
    let mut parts = vec![batch::BUFFERS];
    if has_domain || needs(|instruction| matches!(instruction, Instruction::Select { .. })) {
        parts.push(NAN);
    }
    let is_product = |instruction: &Instruction| {
        matches!(instruction, Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_))
    };
    if needs(is_product) {
        parts.push(DIFFERENCE_OF_PRODUCTS);
    }
    let is_called = |definition: &&Definition| programs.iter().any(|program| definition.is_called(program));
    parts.extend(DEFINITIONS.iter().filter(is_called).map(|definition| definition.text));
    parts.join("\n")
}

/// Writes the documented function of a kernel.
pub(super) fn function_of(program: &Program, docs: &KernelDocs) -> String {
    let dialect = Wgsl { results: results(program) };
    let body = body::write(&dialect, program, &numbers(program, nested_element));
    format!("{}{} {{\n{body}}}\n", documentation(program, docs, "//"), signature(program))
}

fn signature(program: &Program) -> String {
    let typed = |Parameter { name, shape }: &Parameter| format!("{name}: {}", type_of(*shape));
    let parameters: Vec<String> = program.signature.parameters.iter().map(typed).collect();
    let result = type_of(results(program));
    let line = format!("fn {}({}) -> {result}", program.name, parameters.join(", "));
    if line.len() <= WIDTH {
        return line;
    }
    format!("fn {}(\n    {},\n) -> {result}", program.name, parameters.join(",\n    "))
}

struct Wgsl {
    results: Shape,
}

impl Wgsl {
    fn returned(&self, outputs: &[&str]) -> String {
        let outputs: Vec<String> = outputs.iter().map(|&output| output.to_owned()).collect();
        format!("return {};", nested(self.results, &outputs))
    }
}

impl Dialect for Wgsl {
    fn choices(&self) -> Choices<'_> {
        Choices::Branches(self)
    }

    fn number(&self, constant: &Constant) -> Written {
        literal(constant, Precision::F32)
    }

    fn sqrt(&self, value: &Written) -> Written {
        function("sqrt", &[value])
    }

    /// `pow` takes positive numbers: integer powers of other numbers get the sign that their
    /// exponent implies.
    fn power(&self, value: &Written, exponent: Ratio<i64>) -> Written {
        let quotient = format!("{}.0f / {}.0f", exponent.numer(), exponent.denom());
        if !exponent.is_integer() {
            return function("pow", &[value, &Written::atom(quotient)]);
        }
        let whole = Written::atom(format!("{}.0f", exponent.numer()));
        let magnitude = function("pow", &[&function("abs", &[value]), &whole]);
        if exponent.numer() % 2 == 0 {
            return magnitude;
        }
        infix(&function("sign", &[value]), "*", &magnitude)
    }

    fn call(&self, operation: Operation, operands: &[&Written]) -> Written {
        let row = operation.row();
        let defined = definition(operation).map(|definition| definition.name);
        function(defined.or(row.spelling.wgsl).unwrap_or(row.name), operands)
    }

    fn difference_of_products(&self, factors: [&Written; 4]) -> Written {
        function("forms_difference_of_products", &factors)
    }

    fn sum_of_products(&self, [a, b, c, d]: [&Written; 4]) -> Written {
        function("forms_difference_of_products", &[a, b, &negated(c), d])
    }

    fn multiply_add(&self, sum: ProductSum, [a, b, c]: [&Written; 3]) -> Written {
        let [factor, other] = sum.signed(a.clone(), c.clone(), |value| negated(&value));
        function("fma", &[&factor, b, &other])
    }

    fn nan(&self) -> String {
        "forms_nan()".to_string()
    }

    fn declaration(&self, name: &str, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn results(&self, outputs: &[&str]) -> String {
        format!("    {}\n", self.returned(outputs))
    }
}

impl Branches for Wgsl {
    fn variable(&self, name: &str) -> Option<String> {
        Some(format!("var {name}: f32;"))
    }

    fn comparison(&self, left: &Written, relation: Option<Relation>, right: &Written) -> String {
        unequal_as_less_or_greater(left, relation, right)
    }

    fn condition(&self, comparison: &str) -> String {
        comparison.to_string()
    }

    fn leave_unless(&self, comparison: &str, outputs: usize) -> String {
        let nan = self.nan();
        let leave = self.returned(&vec![nan.as_str(); outputs]);
        format!("    if !({comparison}) {{\n        {leave}\n    }}\n")
    }
}
