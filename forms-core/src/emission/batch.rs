//! Batch functions: a kernel at every row of arrays, one array for each argument and one for each
//! output.
//!
//! *Enters*: a kernel with the names that it has in the target, and the name of its batch function.
//! *Leaves*: a loop in C, a grid-stride loop in CUDA, an entry point in WGSL. No local name is that
//! of the kernel, which would be hidden, or that of another variable.

use super::c::{C, Flavour};
use super::names::fresh;
use super::shader_values::{nested, results};
use crate::expression::{Parameter, Shape};
use crate::kernel::Program;

/// Number of invocations of a workgroup in WGSL.
const WORKGROUP: usize = 64;

/// Arrays of all entry points in WGSL: the arguments one after the other, each with `forms_count`
/// numbers, and the outputs in the same way.
pub(super) const BUFFERS: &str = "\
// Buffers of the entry points: column j of the arguments starts at j * forms_count, and so does
// column j of the outputs.
@group(0) @binding(0) var<storage, read> forms_arguments: array<f32>;
@group(0) @binding(1) var<storage, read_write> forms_outputs: array<f32>;
@group(0) @binding(2) var<uniform> forms_count: u32;
";

/// Local names of a batch function.
struct Names {
    /// One for each number among the arguments.
    arguments: Vec<String>,
    /// One for each argument as declared.
    parameters: Vec<String>,
    outputs: Vec<String>,
    values: String,
    count: String,
    row: String,
    stride: String,
}

impl Names {
    fn of(program: &Program) -> Names {
        let mut taken = vec![program.name.clone()];
        taken.extend(program.arguments.iter().filter(|argument| **argument != program.name).cloned());
        let argument = |name: &String| {
            if *name == program.name { fresh(name, &mut taken) } else { name.clone() }
        };
        let arguments = program.arguments.iter().map(argument).collect();
        let outputs = match program.outputs.len() {
            1 => vec![fresh("output", &mut taken)],
            count => (0..count).map(|place| fresh(&format!("output{place}"), &mut taken)).collect(),
        };
        let [values, count, row, stride] =
            ["values", "count", "i", "stride"].map(|name| fresh(name, &mut taken));
        let declared = |parameter: &Parameter| fresh(&parameter.name, &mut taken);
        let parameters = program.signature.parameters.iter().map(declared).collect();
        Names { arguments, parameters, outputs, values, count, row, stride }
    }
}

/// Writes the batch function of C or CUDA.
pub(super) fn of_c(language: &C, program: &Program, name: &str) -> String {
    let names = Names::of(program);
    let number = language.number_type();
    let (restrict, size) = match language.flavour {
        Flavour::C => ("FORMS_RESTRICT", "size_t"),
        Flavour::Cuda => ("__restrict__", "unsigned long long"),
    };
    let arguments = names.arguments.iter().map(|name| format!("const {number} *{restrict} {name}"));
    let outputs = names.outputs.iter().map(|name| format!("{number} *{restrict} {name}"));
    let mut parameters: Vec<String> = arguments.chain(outputs).collect();
    parameters.push(format!("{size} {}", names.count));
    let Names { count, row, stride, .. } = &names;
    let (specifiers, loop_head) = match language.flavour {
        Flavour::C => (
            "FORMS_FLATTEN static inline",
            format!("    for ({size} {row} = 0; {row} < {count}; {row}++) {{\n"),
        ),
        Flavour::Cuda => (
            "extern \"C\" __global__",
            format!(
                "    const {size} {stride} = ({size})gridDim.x * blockDim.x;\n    \
                 for ({size} {row} = ({size})blockIdx.x * blockDim.x + threadIdx.x; {row} < {count}; \
                 {row} += {stride}) {{\n"
            ),
        ),
    };
    format!(
        "// `{}` for each {row} < {count}. Outputs must not overlap other arrays.\n\
         {specifiers} void {name}(\n    {}) {{\n{loop_head}{}    }}\n}}\n",
        program.name,
        parameters.join(",\n    "),
        row_of_c(program, &names, number),
    )
}

/// Writes the statements that compute one row.
fn row_of_c(program: &Program, names: &Names, number: &str) -> String {
    let (function, row, values) = (&program.name, &names.row, &names.values);
    let (mut text, mut call) = (String::new(), Vec::new());
    let mut numbers = names.arguments.iter().map(|name| format!("{name}[{row}]"));
    for (parameter, name) in program.signature.parameters.iter().zip(&names.parameters) {
        let own: Vec<String> = numbers.by_ref().take(parameter.shape.entries()).collect();
        if parameter.shape == Shape::Number {
            call.extend(own);
        } else {
            text += &format!("        const {number} {name}[{}] = {{{}}};\n", own.len(), own.join(", "));
            call.push(name.clone());
        }
    }
    if let [output] = &names.outputs[..] {
        return text + &format!("        {output}[{row}] = {function}({});\n", call.join(", "));
    }
    call.push(values.clone());
    text += &format!(
        "        {number} {values}[{}];\n        {function}({});\n",
        names.outputs.len(),
        call.join(", ")
    );
    for (place, output) in names.outputs.iter().enumerate() {
        text += &format!("        {output}[{row}] = {values}[{place}];\n");
    }
    text
}

/// Writes the entry point of WGSL. Workgroups are numbered along x, then along y.
pub(super) fn of_wgsl(program: &Program, name: &str) -> String {
    let mut taken = vec![program.name.clone()];
    let [id, groups, row, value] = ["id", "groups", "i", "value"].map(|name| fresh(name, &mut taken));
    let column = |place: usize| match place {
        0 => row.clone(),
        1 => format!("forms_count + {row}"),
        place => format!("{place}u * forms_count + {row}"),
    };
    let mut numbers = (0..program.arguments.len()).map(|place| format!("forms_arguments[{}]", column(place)));
    let argument = |parameter: &Parameter| {
        let own: Vec<String> = numbers.by_ref().take(parameter.shape.entries()).collect();
        nested(parameter.shape, &own)
    };
    let arguments: Vec<String> = program.signature.parameters.iter().map(argument).collect();
    let call = format!("{}({})", program.name, arguments.join(", "));
    let element = |place: usize| match results(program) {
        Shape::Matrix(_, columns) => format!("[{}][{}]", place / columns, place % columns),
        _ => format!("[{place}]"),
    };
    let stores = match program.outputs.len() {
        1 => format!("    forms_outputs[{row}] = {call};\n"),
        count => (0..count).fold(format!("    let {value} = {call};\n"), |text, place| {
            text + &format!("    forms_outputs[{}] = {value}{};\n", column(place), element(place))
        }),
    };
    let columns = program.arguments.join("`, `");
    let columns = if columns.is_empty() { String::new() } else { format!(", of the columns `{columns}`") };
    format!(
        "// `{}` for each {row} < forms_count{columns}.\n\
         @compute @workgroup_size({WORKGROUP})\nfn {name}(\n    \
         @builtin(global_invocation_id) {id}: vec3u,\n    @builtin(num_workgroups) {groups}: vec3u,\n) {{\n    \
         let {row} = {id}.x + {WORKGROUP}u * {groups}.x * {id}.y;\n    \
         if {row} >= forms_count {{\n        return;\n    }}\n{stores}}}\n",
        program.name,
    )
}
