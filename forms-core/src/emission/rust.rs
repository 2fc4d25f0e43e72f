//! Rust source: one function per kernel, with its documentation above it, that needs the standard
//! library and, for some instructions, `forms_math`.

use super::attributes::attributes;
use super::dialect::{Branches, Choices, Dialect};
use super::docs::{KernelDocs, documentation};
use super::generic::{MATH, closure, nested_formula};
use super::number::{number, receiver};
use super::parameters::{self, nested_element, nested_type, numbers};
use super::promise::Promise;
use super::rust_results::{array_type, result_lines, result_type, results_of_array};
use super::target::{Precision, Target};
use super::written::{Binding, Written, function};
use super::{body, names};
use crate::expression::{Operation, Rational, Relation, Shape};
use crate::kernel::{Constant, Instruction, Program, nearest_f64};
use num_rational::Ratio;

/// Longest line of a signature.
const WIDTH: usize = 100;

/// Emits a documented function. It needs the standard library only or, if that is not sufficient
/// (see [`Program::needs_math`]), also the items that `forms_math` exports, found by the path
/// `math`.
pub fn emit_rust(program: &Program, docs: &KernelDocs, math: &str) -> String {
    let (program, docs) = names::renamed(program, docs, Target::Rust, &program.name);
    written(&program, &docs, math, Precision::F64)
}

/// Emits a documented function whose values are within `within` units of 2⁻⁵³ of the exact ones,
/// relative to them. They are computed by `escalate` of `forms_math` from the type `formula`, which
/// is a formula of this program (see [`emit_formula`](super::emit_formula)).
pub fn emit_rust_within(
    program: &Program,
    docs: &KernelDocs,
    math: &str,
    formula: &str,
    within: &Rational,
) -> String {
    let (program, docs) = names::renamed(program, docs, Target::Rust, &program.name);
    let escalated = escalated(&program, math, formula, within, Precision::F64);
    Rust::of(&program, math, Precision::F64).function(
        &program,
        &promised(&docs, within),
        |_| true,
        &escalated,
    )
}

/// Emits such a function with its formula inside.
pub(super) fn escalating(
    program: &Program,
    docs: &KernelDocs,
    within: &Rational,
    precision: Precision,
) -> String {
    let body = nested_formula(program) + &escalated(program, MATH, "Formula", within, precision);
    Rust::of(program, MATH, precision).function(program, docs, |_| true, &body)
}

fn promised(docs: &KernelDocs, within: &Rational) -> KernelDocs {
    let sentence = Promise::ByPrecision.sentence(within, Target::Rust, Precision::F64);
    KernelDocs { rounding: sentence, ..docs.clone() }
}

/// Writes the statements that compute the values of a formula within the promised error.
fn escalated(
    program: &Program,
    math: &str,
    formula: &str,
    within: &Rational,
    precision: Precision,
) -> String {
    let (arguments, outputs) = (program.arguments.len(), program.outputs.len());
    let within = below(within);
    let escalate = if precision == Precision::F32 { "escalate_f32" } else { "escalate" };
    let values = format!(
        "{math}::{escalate}::<{formula}, {arguments}, {outputs}>([{}], {within:?})",
        numbers(program, nested_element).join(", ")
    );
    results_of_array(&program.signature.results, &values)
}

/// Returns the largest `f64` that does not exceed a positive number.
fn below(number: &Rational) -> f64 {
    let nearest = nearest_f64(number);
    let is_above = Rational::from_float(nearest).is_none_or(|exact| exact > *number);
    if is_above { nearest.next_down() } else { nearest }
}

/// Emits the function of `f32`s or of `f64`s.
pub(super) fn written(program: &Program, docs: &KernelDocs, math: &str, precision: Precision) -> String {
    let dialect = Rust::of(program, math, precision);
    let used = |place: usize| names::uses(program, place);
    let body = body::write(&dialect, program, &numbers(program, nested_element));
    dialect.function(program, docs, used, &body)
}

impl Program {
    /// Whether the program's Rust source needs more than the standard library.
    pub fn needs_math(&self) -> bool {
        self.instructions.iter().any(|instruction| match instruction {
            Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_) => true,
            Instruction::Quadrature { .. } => true,
            Instruction::Power(_, exponent) => !exponent.is_integer(),
            Instruction::Call(operation, _) => operation.row().spelling.rust.is_none(),
            _ => false,
        })
    }
}

/// Rust with `f32` or `f64`.
struct Rust<'a> {
    math: &'a str,
    precision: Precision,
    /// Shapes of the results of the function.
    results: &'a [Shape],
}

impl<'a> Rust<'a> {
    fn of(program: &'a Program, math: &'a str, precision: Precision) -> Self {
        Rust { math, precision, results: &program.signature.results }
    }

    /// `forms_math::Real::erf(x)`
    fn real(&self, name: &str, operands: &[&Written]) -> Written {
        function(&format!("<{} as {}::Real>::{name}", self.number_type(), self.math), operands)
    }

    /// Writes the documented function with this body; `uses` says whether the body uses an
    /// argument.
    fn function(
        &self,
        program: &Program,
        docs: &KernelDocs,
        uses: impl Fn(usize) -> bool,
        body: &str,
    ) -> String {
        let documentation = documentation(program, docs, "///");
        let (attributes, signature) = (attributes(program), self.signature(program, uses));
        format!("{documentation}{attributes}{signature} {{\n{body}}}\n")
    }

    fn signature(&self, program: &Program, used: impl Fn(usize) -> bool) -> String {
        let number = self.number_type();
        let parameters = &program.signature.parameters;
        let mut names: Vec<String> = parameters.iter().map(|parameter| parameter.name.clone()).collect();
        for (place, is_used) in parameters::used(program, used).into_iter().enumerate() {
            if !is_used {
                names[place] = names::unused(&names[place], &names);
            }
        }
        let types = parameters.iter().map(|parameter| nested_type(parameter.shape, number, array_type));
        let arguments: Vec<String> =
            names.iter().zip(types).map(|(name, number)| format!("{name}: {number}")).collect();
        let public = if program.public { "pub " } else { "" };
        let result = result_type(self.results, number);
        let name = &program.name;
        let line = format!("{public}fn {name}({}) -> {result}", arguments.join(", "));
        if line.len() + 2 <= WIDTH {
            return line;
        }
        let arguments: String = arguments.iter().map(|argument| format!("    {argument},\n")).collect();
        format!("{public}fn {name}(\n{arguments}) -> {result}")
    }

    fn number_type(&self) -> &'static str {
        self.precision.name()
    }

    /// `x.sqrt()`
    fn method(&self, value: &Written, name: &str, rest: &[String]) -> Written {
        Written::atom(format!("{}.{name}({})", receiver(value, self.precision), rest.join(", ")))
    }
}

impl Dialect for Rust<'_> {
    fn choices(&self) -> Choices<'_> {
        Choices::Branches(self)
    }

    fn number(&self, constant: &Constant) -> Written {
        number(constant, self.precision)
    }

    fn sqrt(&self, value: &Written) -> Written {
        self.method(value, "sqrt", &[])
    }

    fn power(&self, value: &Written, exponent: Ratio<i64>) -> Written {
        if exponent.is_integer() {
            return self.method(value, "powf", &[format!("{}.0", exponent.numer())]);
        }
        let [numerator, denominator] = [exponent.numer(), exponent.denom()].map(|part| part.to_string());
        self.real("power", &[value, &Written::atom(numerator), &Written::atom(denominator)])
    }

    fn call(&self, operation: Operation, operands: &[&Written]) -> Written {
        let Some(name) = operation.row().spelling.rust else {
            return self.real(operation.row().real, operands);
        };
        let rest: Vec<String> = operands[1..].iter().map(|operand| operand.argument()).collect();
        self.method(operands[0], name, &rest)
    }

    fn difference_of_products(&self, factors: [&Written; 4]) -> Written {
        self.real("difference_of_products", &factors)
    }

    fn sum_of_products(&self, factors: [&Written; 4]) -> Written {
        self.real("sum_of_products", &factors)
    }

    fn quadrature(&self, integrand: &Program, operands: &[&Written]) -> Written {
        let name = format!("<{} as {}::Real>::quadrature", self.number_type(), self.math);
        let of_integrand = Rust { results: &[Shape::Number], ..*self };
        closure(&of_integrand, &name, integrand, operands, str::to_string)
    }

    fn nan(&self) -> String {
        format!("{}::NAN", self.number_type())
    }

    fn declaration(&self, name: &str, value: &str) -> String {
        format!("let {name} = {value};")
    }

    fn results(&self, outputs: &[&str]) -> String {
        result_lines(self.results, outputs)
    }
}

impl Branches for Rust<'_> {
    fn variable(&self, _: &str) -> Option<String> {
        None
    }

    fn comparison(&self, left: &Written, relation: Option<Relation>, right: &Written) -> String {
        match relation {
            Some(Relation::NotEqual) => {
                let right = format!("&{}", right.within(Binding::Sign));
                let order = self.method(left, "partial_cmp", &[right]);
                format!("{}.is_some_and(::core::cmp::Ordering::is_ne)", order.text)
            }
            relation => {
                format!("{} {} {}", left.argument(), relation.map_or("==", Relation::text), right.argument())
            }
        }
    }

    fn condition(&self, condition: &str) -> String {
        condition.to_string()
    }

    fn leave_unless(&self, condition: &str, _: usize) -> String {
        let nan = result_type(self.results, &self.nan());
        format!("    let inside = {condition};\n    if !inside {{\n        return {nan};\n    }}\n")
    }
}
