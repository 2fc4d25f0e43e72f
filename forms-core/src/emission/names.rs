//! Names of kernels and arguments in the target languages.
//!
//! Each name of a file becomes a name that the target's compiler accepts as new: the same name if
//! possible, or else the same name with trailing underscores (`printf_`), with a prefix that no
//! name of the target has (`k_forms_power`), or in the form in which Rust writes keywords
//! (`r#match`). Different names stay different.

use super::docs::KernelDocs;
use super::target::Target;
use crate::kernel::{Instruction, Program};
use crate::syntax::words;
use rustc_hash::FxHashSet;
use std::sync::OnceLock;

const C: &str = include_str!("names/c.txt");
const C_LIBRARY: &str = include_str!("names/c_library.txt");
const CUDA: &str = include_str!("names/cuda.txt");
const RUST: &str = include_str!("names/rust.txt");
const WGSL: &str = include_str!("names/wgsl.txt");

/// Names that generated functions give to their own variables, in C and in Rust.
const VARIABLES_OF_C: &str = "outputs";
const VARIABLES_OF_RUST: &str = "from to inside";

/// Prefix for a name whose own prefix is reserved.
const BEGINNING: &str = "k_";

/// Kind of object that is named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// A function, which the rest of the program can see.
    Kernel,
    /// A variable of a function.
    Argument,
}

/// Words that cannot be new names in a target.
struct Reserved {
    words: FxHashSet<&'static str>,
    beginnings: &'static [&'static str],
}

impl Reserved {
    fn new(lists: &[&'static str], beginnings: &'static [&'static str]) -> Self {
        let lines = lists.iter().flat_map(|list| list.lines()).filter(|line| !line.starts_with('#'));
        Reserved { words: lines.flat_map(str::split_whitespace).collect(), beginnings }
    }

    fn of(target: Target, role: Role) -> &'static Reserved {
        static TABLE: OnceLock<[Reserved; 7]> = OnceLock::new();
        // names that begin with an underscore, or contain two, are reserved for the implementations
        // of C and C++
        const OF_C: &[&str] = &["_", "forms_", "FORMS_", "M_", "FP_", "MATH_", "HUGE_VAL"];
        const OF_CUDA: &[&str] =
            &["_", "forms_", "FORMS_", "M_", "FP_", "MATH_", "HUGE_VAL", "cuda", "CUDA", "CU_", "cu_"];
        const OF_WGSL: &[&str] = &["__", "forms_"];
        let table = TABLE.get_or_init(|| {
            [
                Reserved::new(&[RUST], &[]),
                Reserved::new(&[C, C_LIBRARY], OF_C),
                Reserved::new(&[C, VARIABLES_OF_C], OF_C),
                Reserved::new(&[C, C_LIBRARY, CUDA], OF_CUDA),
                Reserved::new(&[C, CUDA, VARIABLES_OF_C], OF_CUDA),
                Reserved::new(&[WGSL], OF_WGSL),
                Reserved::new(&[RUST, VARIABLES_OF_RUST], &[]),
            ]
        });
        match (target, role) {
            (Target::Rust, Role::Kernel) => &table[0],
            (Target::Rust, Role::Argument) => &table[6],
            (Target::C, Role::Kernel) => &table[1],
            (Target::C, Role::Argument) => &table[2],
            (Target::Cuda, Role::Kernel) => &table[3],
            (Target::Cuda, Role::Argument) => &table[4],
            (Target::Wgsl, _) => &table[5],
        }
    }

    /// Returns the name, or a similar one that is not reserved.
    fn nearest(&self, name: &str) -> String {
        let begins = name == "_" || self.beginnings.iter().any(|beginning| name.starts_with(beginning));
        let mut free = if begins { format!("{BEGINNING}{name}") } else { name.to_string() };
        while self.words.contains(free.as_str()) {
            free.push('_');
        }
        free
    }
}

/// Returns distinct names in the target. A name that can stay does.
fn chosen(target: Target, role: Role, names: &[String]) -> Vec<String> {
    let reserved = Reserved::of(target, role);
    let nearest: Vec<String> = names.iter().map(|name| reserved.nearest(name)).collect();
    let mut taken: FxHashSet<String> = names
        .iter()
        .zip(&nearest)
        .filter(|(name, near)| name == near)
        .map(|(name, _)| name.clone())
        .collect();
    let distinct = names.iter().zip(nearest).map(|(name, near)| {
        if *name == near {
            return near;
        }
        let mut free = near;
        while reserved.words.contains(free.as_str()) || !taken.insert(free.clone()) {
            free.push('_');
        }
        free
    });
    distinct.map(|name| written(target, name)).collect()
}

/// Writes a keyword of Rust as a raw identifier.
fn written(target: Target, name: String) -> String {
    let is_keyword = target == Target::Rust && words::is_rust_keyword(&name);
    if is_keyword { format!("r#{name}") } else { name }
}

/// Returns the name of an unused argument of a Rust function: its name with a leading underscore,
/// different from the others.
pub(super) fn unused(name: &str, others: &[String]) -> String {
    let mut free = format!("_{}", name.trim_start_matches("r#"));
    while others.contains(&free) {
        free.push('_');
    }
    free
}

/// Returns the names of the kernels of one file.
pub(super) fn of_kernels(target: Target, names: &[String]) -> Vec<String> {
    chosen(target, Role::Kernel, names)
}

/// Names of the functions of a kernel.
pub(super) struct Functions {
    /// Computes the kernel.
    pub(super) kernel: String,
    /// Computes it over arrays.
    pub(super) batch: String,
    /// Computes it in double precision for one in single precision.
    pub(super) in_double: String,
}

/// Returns the names of the functions of the kernels of one file: those of the kernels, and with
/// `_batch` and `_in_double` names that differ from all others.
pub(super) fn of_functions(target: Target, kernels: &[String]) -> Vec<Functions> {
    let kernels = of_kernels(target, kernels);
    let batches = with_ending(target, &kernels, "_batch");
    let taken = [&kernels[..], &batches].concat();
    let in_double = with_ending(target, &taken, "_in_double");
    let names = kernels.into_iter().zip(batches).zip(in_double);
    names.map(|((kernel, batch), in_double)| Functions { kernel, batch, in_double }).collect()
}

/// Returns names with an ending, different from each other and from all given ones.
fn with_ending(target: Target, kernels: &[String], ending: &str) -> Vec<String> {
    let reserved = Reserved::of(target, Role::Kernel);
    let mut taken: FxHashSet<String> = kernels.iter().cloned().collect();
    let of_kernel = |kernel: &String| {
        let mut free = reserved.nearest(&format!("{kernel}{ending}"));
        while reserved.words.contains(free.as_str()) || !taken.insert(free.clone()) {
            free.push('_');
        }
        free
    };
    kernels.iter().map(of_kernel).collect()
}

/// Returns the name, or the name with underscores that makes it different from the others, and adds
/// it to them.
pub(super) fn fresh(name: &str, others: &mut Vec<String>) -> String {
    let mut free = name.to_string();
    while others.contains(&free) {
        free.push('_');
    }
    others.push(free.clone());
    free
}

/// Returns the same program with names of the target: its own name is given, the names of its
/// arguments are chosen. Names that differ from the source are listed above the function.
pub(super) fn renamed(
    program: &Program,
    docs: &KernelDocs,
    target: Target,
    name: &str,
) -> (Program, KernelDocs) {
    let own: Vec<String> =
        program.signature.parameters.iter().map(|parameter| parameter.name.clone()).collect();
    let arguments = chosen(target, Role::Argument, &own);
    let mut docs = docs.clone();
    let all = std::iter::once((program.name.as_str(), name));
    let all = all.chain(own.iter().zip(&arguments).map(|(old, new)| (old.as_str(), new.as_str())));
    let mut notes: Vec<String> = Vec::new();
    for (old, new) in all.filter(|(old, new)| old != new) {
        let note = format!("`{old}` is renamed to `{new}`");
        // an argument can have the name of its kernel
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    if !notes.is_empty() {
        let reason = if notes.len() == 1 { "the name is" } else { "the names are" };
        docs.docs.push(format!("{}, because {reason} reserved in {}.", notes.join(", "), target.title()));
    }
    let mut signature = program.signature.clone();
    for (parameter, name) in signature.parameters.iter_mut().zip(arguments) {
        parameter.name = name;
    }
    let arguments = signature.arguments();
    (Program { name: name.to_string(), signature, arguments, ..program.clone() }, docs)
}

/// Whether a function uses an argument.
pub(super) fn uses(program: &Program, argument: usize) -> bool {
    program.instructions.contains(&Instruction::Argument(argument as u32))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kernels(target: Target, names: &str) -> String {
        let names: Vec<String> = names.split(' ').map(str::to_string).collect();
        of_kernels(target, &names).join(" ")
    }

    #[test]
    fn what_can_stay_stays_and_nothing_is_named_twice() {
        assert_eq!(kernels(Target::C, "printf f printf_ double"), "printf__ f printf_ double_");
        assert_eq!(
            kernels(Target::C, "forms_power k_forms_power _x _"),
            "k_forms_power_ k_forms_power k__x k__"
        );
        assert_eq!(
            kernels(Target::Rust, "match self self_ f64 Some _"),
            "r#match self__ self_ f64 Some_ k__"
        );
        assert_eq!(kernels(Target::Wgsl, "fn __a _ sin length"), "fn_ k___a k__ sin_ length_");
        assert_eq!(kernels(Target::Cuda, "threadIdx cudaMalloc float4"), "threadIdx_ k_cudaMalloc float4_");
    }

    #[test]
    fn a_batch_is_named_like_no_kernel_and_no_other_batch() {
        let batches = |names: &str| {
            let names: Vec<String> = names.split(' ').map(str::to_string).collect();
            with_ending(Target::C, &names, "_batch").join(" ")
        };
        assert_eq!(batches("f g"), "f_batch g_batch");
        assert_eq!(batches("f f_batch f_batch_batch"), "f_batch_ f_batch_batch_ f_batch_batch_batch");
    }

    #[test]
    fn lists_hold_names_and_nothing_else() {
        for list in [C, C_LIBRARY, CUDA, RUST, WGSL] {
            let reserved = Reserved::new(&[list], &[]);
            assert!(reserved.words.len() >= 10);
            for word in reserved.words {
                let is_name = word.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_');
                assert!(is_name && !word.as_bytes()[0].is_ascii_digit(), "{word}");
            }
        }
    }
}
