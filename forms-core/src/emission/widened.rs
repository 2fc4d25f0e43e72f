//! Functions of C and CUDA in single precision that are computed in double precision.
//!
//! *Enters*: a kernel with its name in the target, and the same with the name of its function in double precision.
//! *Leaves*: that function, and the documented one that rounds its values.

use super::c::C;
use super::docs::KernelDocs;
use super::names::fresh;
use super::target::Precision;
use crate::expression::{Parameter, Shape};
use crate::kernel::Program;

/// Writes both functions.
pub(super) fn function(single: &C, program: &Program, in_double: &Program, docs: &KernelDocs) -> String {
    let double = C::new(single.flavour, Precision::F64);
    format!(
        "// `{}` in double precision.\n{}\n{}{} {{\n{}}}\n",
        program.name,
        double.definition(in_double),
        single.documentation(program, docs),
        single.signature(program),
        rounded(program, &in_double.name),
    )
}

/// Writes the statements that call the function in double precision and round its values.
fn rounded(program: &Program, in_double: &str) -> String {
    let parameters = &program.signature.parameters;
    let mut taken: Vec<String> = parameters.iter().map(|parameter| parameter.name.clone()).collect();
    taken.extend([program.name.clone(), in_double.to_string(), "outputs".to_string()]);
    let (mut text, mut call) = (String::new(), Vec::new());
    for Parameter { name, shape } in parameters {
        if *shape == Shape::Number {
            call.push(name.clone());
            continue;
        }
        let wide = fresh(&format!("{name}_in_double"), &mut taken);
        let entries: Vec<String> = (0..shape.entries()).map(|place| format!("{name}[{place}]")).collect();
        text += &format!("    const double {wide}[{}] = {{{}}};\n", entries.len(), entries.join(", "));
        call.push(wide);
    }
    if let [_] = program.outputs[..] {
        return text + &format!("    return (float){in_double}({});\n", call.join(", "));
    }
    let values = fresh("values", &mut taken);
    call.push(values.clone());
    text +=
        &format!("    double {values}[{}];\n    {in_double}({});\n", program.outputs.len(), call.join(", "));
    for place in 0..program.outputs.len() {
        text += &format!("    outputs[{place}] = (float){values}[{place}];\n");
    }
    text
}
