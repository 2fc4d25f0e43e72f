//! C and CUDA: one function per kernel over `float` or `double`, and one over arrays.
//!
//! Several outputs are written to an array, and so are the entries of arrays, matrices by rows: an
//! array of rows cannot be passed as constant in C before C23. Products and sums are fused if the
//! hardware has the instruction: always on CUDA devices, in C if `FP_FAST_FMA` is defined. C is a
//! header for C99 and C++; helper functions have include guards of their own, so that several
//! headers can be included. CUDA includes no header and uses no macro of one, as NVRTC requires.

use super::dialect::{Branches, Choices, Dialect};
use super::docs::{KernelDocs, documentation};
use super::number::literal;
use super::parameters::{self, flat_element, numbers, storage};
use super::target::Precision;
use super::written::{Binding, Written, function, infix, negated};
use super::{body, names, vector_library};
use crate::expression::{Operation, Parameter, Relation, Shape};
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
    pub(super) flavour: Flavour,
    precision: Precision,
}

/// Longest line of a signature.
const WIDTH: usize = 100;

/// Definition of C that emitted functions use: its name and its text.
struct Helper {
    name: &'static str,
    /// Text with `NUMBER` for the number type, and `SUFFIX` for the suffix of its functions.
    text: &'static str,
}

/// a b + c, rounded once if there is an instruction for it.
const MULTIPLY_ADD: Helper = Helper {
    name: "forms_multiply_add",
    text: "\
// a b + c, rounded once if the processor has a fused multiply-add.
SPECIFIERS NUMBER forms_multiply_addSUFFIX(NUMBER a, NUMBER b, NUMBER c) {
#ifdef FAST_FMA
    return fmaSUFFIX(a, b, c);
#else
    return a * b + c;
#endif
}
",
};

/// a b + c on CUDA, whose devices always round it once.
const FUSED_MULTIPLY_ADD: Helper = Helper {
    name: "forms_multiply_add",
    text: "\
// a b + c, rounded once.
SPECIFIERS NUMBER forms_multiply_addSUFFIX(NUMBER a, NUMBER b, NUMBER c) {
    return fmaSUFFIX(a, b, c);
}
",
};

/// a b − c d = fl(a b − p) + (p − c d) with p = fl(c d), after Kahan: both differences have one
/// rounding.
const DIFFERENCE_OF_PRODUCTS: Helper = Helper {
    name: "forms_difference_of_products",
    text: "\
// a b - c d within 2 ulp, by the error of one product (Kahan).
SPECIFIERS NUMBER forms_difference_of_productsSUFFIX(NUMBER a, NUMBER b, NUMBER c, NUMBER d) {
    const NUMBER product = c * d;
    const NUMBER error = fmaSUFFIX(-c, d, product);
    return fmaSUFFIX(a, b, -product) + (isfinite(error) ? error : 0);
}
",
};

/// x^(n/d): with n/d = p + r and p rounded, x^p x^r = x^p (1 + r log x) to well below an ulp.
const POWER: Helper = Helper {
    name: "forms_power",
    text: "\
// x^(n/d); needs x >= 0 if d > 1.
SPECIFIERS NUMBER forms_powerSUFFIX(NUMBER x, double n, double d) {
    const double base = x;
    const double exponent = n / d;
    const double rest = fma(-exponent, d, n) / d;
    const double value = pow(base, exponent);
    const double power = rest == 0.0 || base == 0.0 || isinf(base) ? value : value + value * (rest * log(base));
    return (NUMBER)power;
}
",
};

/// √(x² + y²) by the library, whose value is ∞ if one number is infinite and the other NaN.
const HYPOT: Helper = Helper {
    name: "forms_hypot",
    text: "\
// sqrt(x*x + y*y) without overflow of a square; NaN if x or y is NaN.
SPECIFIERS NUMBER forms_hypotSUFFIX(NUMBER x, NUMBER y) {
    return isnan(x) || isnan(y) ? x + y : hypotSUFFIX(x, y);
}
",
};

/// NaN on CUDA, from its bits.
const NAN: Helper = Helper {
    name: "forms_nan",
    text: "\
// NaN.
SPECIFIERS NUMBER forms_nanSUFFIX() {
    return FROM_BITS;
}
",
};

/// A keyword of C99 that C++ lacks, and the attribute by which GCC and Clang inline a kernel into its
/// loop over arrays, also where it is called elsewhere.
const KEYWORDS: &str = "
#ifndef FORMS_RESTRICT
#ifdef __cplusplus
#define FORMS_RESTRICT __restrict
#else
#define FORMS_RESTRICT restrict
#endif
#endif

#ifndef FORMS_FLATTEN
#ifdef __GNUC__
#define FORMS_FLATTEN __attribute__((flatten))
#else
#define FORMS_FLATTEN
#endif
#endif
";

impl C {
    pub(super) fn new(flavour: Flavour, precision: Precision) -> Self {
        C { flavour, precision }
    }

    pub(super) fn number_type(&self) -> &'static str {
        if self.precision == Precision::F32 { "float" } else { "double" }
    }

    /// Returns the suffix of the names of functions of `float`.
    fn suffix(&self) -> &'static str {
        if self.precision == Precision::F32 { "f" } else { "" }
    }

    /// Writes the beginning of the file, with the helper functions that these programs need, some of
    /// them in double precision. In C the file has the include guard `guard`.
    pub(super) fn head(&self, programs: &[&Program], in_double: &[&Program], guard: &str) -> String {
        let mut source = match self.flavour {
            Flavour::C => format!(
                "#ifndef {guard}\n#define {guard}\n\n#include <math.h>\n#include <stddef.h>\n{KEYWORDS}{}",
                vector_library::declarations(programs, self.suffix())
                    + &vector_library::declarations(in_double, "")
            ),
            Flavour::Cuda => String::new(),
        };
        for helper in self.helpers(programs) {
            source += &self.written(&helper);
        }
        let double = C { flavour: self.flavour, precision: Precision::F64 };
        for helper in double.helpers(in_double) {
            source += &double.written(&helper);
        }
        source.trim_start().to_string()
    }

    /// Returns the end of the file, if it has one.
    pub(super) fn foot(&self) -> &'static str {
        if self.flavour == Flavour::C { "#endif\n" } else { "" }
    }

    /// Returns the helper functions that these programs need.
    fn helpers(&self, programs: &[&Program]) -> Vec<Helper> {
        let is_c = self.flavour == Flavour::C;
        let needs = |is_needed: fn(&Instruction) -> bool| {
            programs.iter().any(|program| program.instructions.iter().any(is_needed))
        };
        let is_product = |instruction: &Instruction| {
            matches!(instruction, Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_))
        };
        let has_nan = programs.iter().any(|program| !program.domain.is_empty())
            || needs(|instruction| matches!(instruction, Instruction::Select { .. }));
        let mut helpers = Vec::new();
        if !is_c && has_nan {
            helpers.push(NAN);
        }
        if needs(|instruction| matches!(instruction, Instruction::MultiplyAdd(..))) {
            helpers.push(if is_c { MULTIPLY_ADD } else { FUSED_MULTIPLY_ADD });
        }
        if needs(is_product) {
            helpers.push(DIFFERENCE_OF_PRODUCTS);
        }
        if needs(|instruction| matches!(instruction, Instruction::Power(..))) {
            helpers.push(POWER);
        }
        if needs(|instruction| matches!(instruction, Instruction::Call(Operation::Hypot, _))) {
            helpers.push(HYPOT);
        }
        helpers
    }

    /// Writes a helper function; in C only if no other header has defined it.
    fn written(&self, helper: &Helper) -> String {
        let (fast, bits) = match self.precision {
            Precision::F32 => ("FP_FAST_FMAF", "__int_as_float(0x7fc00000)"),
            _ => ("FP_FAST_FMA", "__longlong_as_double(0x7ff8000000000000LL)"),
        };
        let text = helper.text.replace("SPECIFIERS", self.specifiers()).replace("NUMBER", self.number_type());
        let text = text.replace("SUFFIX", self.suffix()).replace("FAST_FMA", fast).replace("FROM_BITS", bits);
        if self.flavour == Flavour::Cuda {
            return format!("\n{text}");
        }
        let guard = format!("{}{}", helper.name, self.suffix()).to_uppercase();
        format!("\n#ifndef {guard}\n#define {guard}\n{text}#endif\n")
    }

    fn specifiers(&self) -> &'static str {
        if self.flavour == Flavour::C { "static inline" } else { "__device__ inline" }
    }

    /// Writes the documented function of a kernel.
    pub(super) fn function(&self, program: &Program, docs: &KernelDocs) -> String {
        self.documentation(program, docs) + &self.definition(program)
    }

    /// Writes the comment above the function of a kernel.
    pub(super) fn documentation(&self, program: &Program, docs: &KernelDocs) -> String {
        let mut docs = docs.clone();
        docs.docs.extend(storage(program));
        documentation(program, &docs, "//")
    }

    /// Writes the function of a kernel without its documentation.
    pub(super) fn definition(&self, program: &Program) -> String {
        let mut source = self.signature(program) + " {\n";
        let is_used = parameters::used(program, |place| names::uses(program, place));
        for (parameter, is_used) in program.signature.parameters.iter().zip(is_used) {
            if !is_used {
                source += &format!("    (void){};\n", parameter.name);
            }
        }
        source + &body::write(self, program, &numbers(program, flat_element)) + "}\n"
    }

    pub(super) fn signature(&self, program: &Program) -> String {
        let number = self.number_type();
        let specifiers = self.specifiers();
        let declared = |Parameter { name, shape }: &Parameter| match shape {
            Shape::Number => format!("{number} {name}"),
            _ => format!("const {number} {name}[{}]", shape.entries()),
        };
        let mut parameters: Vec<String> = program.signature.parameters.iter().map(declared).collect();
        let result = if let [_] = program.outputs[..] {
            number
        } else {
            parameters.push(format!("{number} *outputs"));
            "void"
        };
        if parameters.is_empty() && self.flavour == Flavour::C {
            parameters.push("void".to_string());
        }
        let head = format!("{specifiers} {result} {}(", program.name);
        let line = format!("{head}{})", parameters.join(", "));
        if line.len() <= WIDTH { line } else { format!("{head}\n    {})", parameters.join(",\n    ")) }
    }

    /// Writes a call of a function with one version for each number type.
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
        self.call_of("forms_power", &[value, &numerator, &denominator])
    }

    fn call(&self, operation: Operation, operands: &[&Written]) -> Written {
        let spelling = operation.row().spelling;
        let name = if self.flavour == Flavour::C { spelling.c } else { spelling.cuda };
        self.call_of(name.unwrap_or(operation.row().name), operands)
    }

    fn difference_of_products(&self, factors: [&Written; 4]) -> Written {
        self.call_of("forms_difference_of_products", &factors)
    }

    fn sum_of_products(&self, [a, b, c, d]: [&Written; 4]) -> Written {
        self.call_of("forms_difference_of_products", &[a, b, &negated(c), d])
    }

    fn multiply_add(&self, sum: ProductSum, [a, b, c]: [&Written; 3]) -> Written {
        let [factor, other] = sum.signed(a.clone(), c.clone(), |value| negated(&value));
        self.call_of("forms_multiply_add", &[&factor, b, &other])
    }

    fn nan(&self) -> String {
        match self.flavour {
            Flavour::C => "NAN".to_string(),
            Flavour::Cuda => format!("forms_nan{}()", self.suffix()),
        }
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

    fn inside(&self, name: &str, comparisons: &[String], outputs: usize) -> Option<String> {
        let all = match comparisons {
            [only] => only.clone(),
            several => several.iter().map(|one| format!("({one})")).collect::<Vec<_>>().join(" & "),
        };
        let (number, one) = (self.number_type(), self.number(&Constant::integer(1)).text);
        Some(match outputs {
            1 => format!("const int {name} = {all};"),
            // many choices by one condition become a branch in GCC, which no loop is vectorised with
            _ => format!("const {number} {name} = {all} ? {one} : {};", self.nan()),
        })
    }

    fn if_inside(&self, name: &str, value: &Written, outputs: usize) -> Written {
        match outputs {
            1 => Written::new(format!("{name} ? {} : {}", value.text, self.nan()), Binding::Choice),
            _ => infix(&Written::name(name), "*", value),
        }
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
