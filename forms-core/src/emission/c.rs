//! C11 and CUDA: one function per kernel over `float` or `double`.
//!
//! Several outputs are written to an array. Products and sums are fused if the hardware has the
//! instruction: always on CUDA devices, in C if `FP_FAST_FMA` is defined.

use super::dialect::{Branches, Choices, Dialect};
use super::docs::{KernelDocs, documentation};
use super::number::literal;
use super::target::Precision;
use super::written::{Binding, Written, function, negated};
use super::{body, names};
use crate::expression::{Operation, Relation};
use crate::kernel::{Constant, Instruction, ProductSum, Program};
use num_rational::Ratio;

/// Language of the C family.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Flavour {
    C,
    Cuda,
}

/// Language of the C family with one number type.
pub(super) struct C {
    flavour: Flavour,
    precision: Precision,
}

/// Longest line of a signature.
const WIDTH: usize = 100;

/// a b + c, rounded once if there is an instruction for it.
const MULTIPLY_ADD: &str = "\
// a b + c, rounded once if the processor has a fused multiply-add.
SPECIFIERS NUMBER forms_multiply_add(NUMBER a, NUMBER b, NUMBER c) {
#ifdef FAST_FMA
    return fmaSUFFIX(a, b, c);
#else
    return a * b + c;
#endif
}
";

/// a b + c on CUDA, whose devices always round it once.
const FUSED_MULTIPLY_ADD: &str = "\
// a b + c, rounded once.
SPECIFIERS NUMBER forms_multiply_add(NUMBER a, NUMBER b, NUMBER c) {
    return fmaSUFFIX(a, b, c);
}
";

/// a b − c d = fl(a b − p) + (p − c d) with p = fl(c d), after Kahan: both differences have one
/// rounding.
const DIFFERENCE_OF_PRODUCTS: &str = "\
// a b - c d within 2 ulp, by the error of one product (Kahan).
SPECIFIERS NUMBER forms_difference_of_products(NUMBER a, NUMBER b, NUMBER c, NUMBER d) {
    const NUMBER product = c * d;
    const NUMBER error = fmaSUFFIX(-c, d, product);
    const NUMBER value = fmaSUFFIX(a, b, -product) + error;
    return isnan(value) ? a * b - product : value;
}
";

/// x^(n/d): with n/d = p + r and p rounded, x^p x^r = x^p (1 + r log x) to well below an ulp.
const POWER: &str = "\
// x^(n/d); needs x >= 0 if d > 1.
SPECIFIERS NUMBER forms_power(NUMBER x, double n, double d) {
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(x, exponent);
    return (NUMBER)(rest == 0.0 || x == 0 || isinf(x) ? value : value + value * (rest * log(x)));
}
";

impl C {
    pub(super) fn new(flavour: Flavour, precision: Precision) -> Self {
        C { flavour, precision }
    }

    fn number_type(&self) -> &'static str {
        if self.precision == Precision::F32 { "float" } else { "double" }
    }

    /// Returns the suffix of the names of functions of `float`.
    fn suffix(&self) -> &'static str {
        if self.precision == Precision::F32 { "f" } else { "" }
    }

    /// Writes the includes and the helper functions that these programs need.
    pub(super) fn head(&self, programs: &[&Program]) -> String {
        let needs = |is_needed: fn(&Instruction) -> bool| {
            programs.iter().any(|program| program.instructions.iter().any(is_needed))
        };
        let mut source = "#include <math.h>\n".to_string();
        if needs(|instruction| matches!(instruction, Instruction::MultiplyAdd(..))) {
            let is_c = self.flavour == Flavour::C;
            source += &self.helper(if is_c { MULTIPLY_ADD } else { FUSED_MULTIPLY_ADD });
        }
        let is_product = |instruction: &Instruction| {
            matches!(instruction, Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_))
        };
        if needs(is_product) {
            source += &self.helper(DIFFERENCE_OF_PRODUCTS);
        }
        if needs(|instruction| matches!(instruction, Instruction::Power(..))) {
            source += &self.helper(POWER);
        }
        source
    }

    fn helper(&self, text: &str) -> String {
        let specifiers =
            if self.flavour == Flavour::C { "static inline" } else { "__host__ __device__ static inline" };
        let fast = if self.precision == Precision::F32 { "FP_FAST_FMAF" } else { "FP_FAST_FMA" };
        let text = text.replace("SPECIFIERS", specifiers).replace("NUMBER", self.number_type());
        format!("\n{}", text.replace("SUFFIX", self.suffix()).replace("FAST_FMA", fast))
    }

    /// Writes the documented function of a kernel.
    pub(super) fn function(&self, program: &Program, docs: &KernelDocs) -> String {
        let arguments = &program.arguments;
        let mut source = documentation(program, docs, "//") + &self.signature(program, arguments) + " {\n";
        for (place, name) in arguments.iter().enumerate() {
            if !names::uses(program, place) {
                source += &format!("    (void){name};\n");
            }
        }
        source + &body::write(self, program, arguments) + "}\n"
    }

    fn signature(&self, program: &Program, arguments: &[String]) -> String {
        let number = self.number_type();
        let specifiers = if self.flavour == Flavour::C { "" } else { "__host__ __device__ inline " };
        let mut parameters: Vec<String> = arguments.iter().map(|name| format!("{number} {name}")).collect();
        let result = if let [_] = program.outputs[..] {
            number
        } else {
            parameters.push(format!("{number} *outputs"));
            "void"
        };
        if parameters.is_empty() && self.flavour == Flavour::C {
            parameters.push("void".to_string());
        }
        let head = format!("{specifiers}{result} {}(", program.name);
        let line = format!("{head}{})", parameters.join(", "));
        if line.len() <= WIDTH { line } else { format!("{head}\n    {})", parameters.join(",\n    ")) }
    }

    fn call_of(&self, name: &str, operands: &[&Written]) -> Written {
        function(&format!("{name}{}", self.suffix()), operands)
    }
}

impl Dialect for C {
    fn choices(&self) -> Choices<'_> {
        Choices::Branches(self)
    }

    fn number(&self, constant: &Constant) -> Written {
        literal(constant, self.precision)
    }

    fn sqrt(&self, value: &Written) -> Written {
        self.call_of("sqrt", &[value])
    }

    fn power(&self, value: &Written, exponent: Ratio<i64>) -> Written {
        let [numerator, denominator] =
            [exponent.numer(), exponent.denom()].map(|part| Written::atom(format!("{part}.0")));
        function("forms_power", &[value, &numerator, &denominator])
    }

    fn call(&self, operation: Operation, operands: &[&Written]) -> Written {
        let spelling = operation.row().spelling;
        let name = if self.flavour == Flavour::C { spelling.c } else { spelling.cuda };
        self.call_of(name.unwrap_or(operation.row().name), operands)
    }

    fn difference_of_products(&self, factors: [&Written; 4]) -> Written {
        function("forms_difference_of_products", &factors)
    }

    fn sum_of_products(&self, [a, b, c, d]: [&Written; 4]) -> Written {
        function("forms_difference_of_products", &[a, b, &negated(c), d])
    }

    fn multiply_add(&self, sum: ProductSum, [a, b, c]: [&Written; 3]) -> Written {
        let [factor, other] = sum.signed(a.clone(), c.clone(), |value| negated(&value));
        function("forms_multiply_add", &[&factor, b, &other])
    }

    fn nan(&self) -> String {
        "NAN".to_string()
    }

    fn declaration(&self, name: &str, value: &str) -> String {
        format!("const {} {name} = {value};", self.number_type())
    }

    fn results(&self, outputs: &[&str]) -> String {
        match outputs {
            [single] => format!("    return {single};\n"),
            several => {
                let assign = |(place, value)| format!("    outputs[{place}] = {value};\n");
                several.iter().enumerate().map(assign).collect()
            }
        }
    }
}

impl Branches for C {
    fn variable(&self, name: &str) -> Option<String> {
        Some(format!("{} {name};", self.number_type()))
    }

    fn comparison(&self, left: &Written, relation: Option<Relation>, right: &Written) -> String {
        unequal_as_less_or_greater(left, relation, right)
    }

    fn condition(&self, comparison: &str) -> String {
        format!("({comparison})")
    }

    fn leave_unless(&self, comparison: &str, outputs: usize) -> String {
        let leave = match outputs {
            1 => "        return NAN;\n".to_string(),
            several => {
                let assign = |place| format!("        outputs[{place}] = NAN;\n");
                (0..several).map(assign).collect::<String>() + "        return;\n"
            }
        };
        format!("    if (!({comparison})) {{\n{leave}    }}\n")
    }
}

/// Writes a relation in a language in which `!=` holds for NaN: a ≠ b becomes a < b or a > b.
pub(super) fn unequal_as_less_or_greater(
    left: &Written,
    relation: Option<Relation>,
    right: &Written,
) -> String {
    let [left, right] = [left, right].map(|side| side.within(Binding::Sum));
    match relation {
        Some(Relation::NotEqual) => format!("{left} < {right} || {left} > {right}"),
        relation => format!("{left} {} {right}", relation.map_or("==", Relation::text)),
    }
}
