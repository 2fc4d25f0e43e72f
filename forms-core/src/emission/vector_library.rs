//! Vector functions of the C library, by which compilers vectorise a loop that calls functions.
//!
//! The header `math.h` of glibc declares them only for programs that give up exact arithmetic
//! (`-ffast-math`). Here they are declared for the functions that kernels call, where the program that
//! includes the header asks for them.

use crate::expression::Operation;
use crate::kernel::{Instruction, Program};
use std::collections::BTreeSet;

/// Functions with vector versions in glibc 2.35, each with the number of its arguments.
const FUNCTIONS: &[(&str, usize)] = &[
    ("acos", 1),
    ("asin", 1),
    ("atan", 1),
    ("atan2", 2),
    ("cbrt", 1),
    ("cos", 1),
    ("cosh", 1),
    ("erf", 1),
    ("erfc", 1),
    ("exp", 1),
    ("expm1", 1),
    ("hypot", 2),
    ("log", 1),
    ("log1p", 1),
    ("pow", 2),
    ("sin", 1),
    ("sinh", 1),
    ("tan", 1),
    ("tanh", 1),
];

/// Declares the vector versions of the functions that these programs call, for the number type of this
/// suffix; nothing if they call none.
pub(super) fn declarations(programs: &[&Program], suffix: &str) -> String {
    let instructions = programs.iter().flat_map(|program| &program.instructions);
    let called: BTreeSet<&str> = instructions.flat_map(called).collect();
    let number = if suffix.is_empty() { "double" } else { "float" };
    let declared = |(name, arguments): &(&str, usize)| {
        let arguments = vec![number; *arguments].join(", ");
        format!("__attribute__((simd(\"notinbranch\"), const)) {number} {name}{suffix}({arguments});\n")
    };
    let list: String = FUNCTIONS.iter().filter(|(name, _)| called.contains(name)).map(declared).collect();
    if list.is_empty() {
        return list;
    }
    format!(
        "\n// With FORMS_VECTOR_LIBRARY, loops over arrays call the vector functions of glibc (2.35 or newer), which are\n\
         // within 4 ulp. For GCC with -fno-math-errno -fno-builtin-sin -fno-builtin-cos.\n\
         #if defined(FORMS_VECTOR_LIBRARY) && defined(__GNUC__) && !defined(__clang__) && !defined(__cplusplus)\n\
         {list}#endif\n"
    )
}

/// Returns the functions of the library that an instruction calls.
fn called(instruction: &Instruction) -> Vec<&'static str> {
    match instruction {
        // the helper function for powers computes the remainder by a logarithm
        Instruction::Power(..) => vec!["pow", "log"],
        Instruction::Call(Operation::Hypot, _) => vec!["hypot"],
        Instruction::Call(operation, _) => operation.row().spelling.c.into_iter().collect(),
        _ => Vec::new(),
    }
}
