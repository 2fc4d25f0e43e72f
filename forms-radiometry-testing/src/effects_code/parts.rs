//! Parts of the solver: maps each source file to its effect, and each line of generated code to its
//! kernel.
//!
//! ```text
//! source location ─┬─ a file of the crate, or the module of the function ─▶ an effect, or none
//!                  └─ generated code ─▶ the file of the kernel; the kernel, if nothing is inlined
//! ```

use super::callgrind::{Counts, Place};
use forms_kernels::library;
use forms_radiometry::scene::Effect;
use std::collections::BTreeSet;

/// Modules that serve one effect alone. Code shared by polygons, elements, readings and rays is not
/// among them.
const MODULES: [(Effect, &[&str]); 7] = [
    (Effect::Direct, &["radiosity::direct"]),
    (
        Effect::Occlusion,
        &[
            "visibility::cone",
            "form_factor::exchange::obstructed",
            "visibility::arrangement",
            "visibility::aspect",
            "visibility::occluder_search",
            "visibility::body",
            "visibility::silhouette_columns",
            "visibility::silhouette_crossing",
            "visibility::shaft",
            "visibility::visible",
        ],
    ),
    (Effect::Interreflection, &["radiosity::operator", "radiosity::solution", "radiosity::weights"]),
    (Effect::Mirror, &["paths::mirror"]),
    (Effect::Scattering, &["paths::scattering"]),
    (Effect::Refraction, &["paths::refraction"]),
    (Effect::Time, &["paths::time"]),
];
/// Effects without modules of their own in the path tracer: a path computes all three.
const OF_PIECES: [Effect; 3] = [Effect::Direct, Effect::Occlusion, Effect::Interreflection];

/// Modules that trace light along rays, which occluders block and which continue at reflecting
/// surfaces.
const RAYS: [&str; 3] = ["visibility::branches", "visibility::ray", "radiosity::directions"];

/// Returns the effects that have modules of their own in the path tracer, or in the solver of whole
/// scenes.
pub fn effects(is_by_paths: bool) -> impl Iterator<Item = Effect> {
    MODULES.iter().map(|(effect, _)| *effect).filter(move |effect| is_by_paths != OF_PIECES.contains(effect))
}

/// Returns the number of instructions that serve an effect.
pub fn of_effect(counts: &Counts, effect: Effect) -> u64 {
    MODULES.iter().filter(|(of, _)| *of == effect).map(|(_, modules)| of_modules(counts, modules)).sum()
}

/// Returns the number of instructions that trace light along rays.
pub fn of_rays(counts: &Counts) -> u64 {
    of_modules(counts, &RAYS)
}

/// Returns the number of instructions of these modules.
///
/// The optimiser merges instances of a generic function of another crate whose code is the same, and
/// keeps the lines of one of them. Therefore a line inside of such a function belongs to its module
/// only if the calls of the function can be traced back to that module, or to no module at all, as
/// those of a thread.
fn of_modules(counts: &Counts, modules: &[&str]) -> u64 {
    let is_in = |place: &Place| {
        let module = module(place);
        modules
            .iter()
            .any(|own| module.strip_prefix(own).is_some_and(|rest| rest.is_empty() || rest.starts_with("::")))
    };
    let is_meant = |place: &Place| {
        let is_own = |callers: BTreeSet<&Place>| callers.into_iter().any(is_in);
        let is_of_crate = || of_function(&place.function).is_some();
        is_in(place) && (is_of_crate() || callers(counts, place).is_none_or(is_own))
    };
    counts.instructions.iter().filter(|(place, _)| is_meant(place)).map(|(_, count)| count).sum()
}

/// Returns the locations in the crate from which the function at this location is called, through
/// functions of other crates; nothing if one of those is called from nowhere.
fn callers<'c>(counts: &'c Counts, place: &Place) -> Option<BTreeSet<&'c Place>> {
    let mut found = BTreeSet::new();
    let mut functions = vec![&place.function];
    let mut seen = BTreeSet::from([&place.function]);
    while let Some(function) = functions.pop() {
        for call in counts.calls.get(function)? {
            if !module(call).is_empty() {
                found.insert(call);
            } else if seen.insert(&call.function) {
                functions.push(&call.function);
            }
        }
    }
    Some(found)
}

/// Returns the number of instructions of the crate, kernels included, except those that read the
/// scene.
pub fn of_solver(counts: &Counts) -> u64 {
    let is_meant = |place: &Place| {
        let module = module(place);
        !module.is_empty() && module != "scene" && !module.starts_with("scene::")
    };
    counts.instructions.iter().filter(|(place, _)| is_meant(place)).map(|(_, count)| count).sum()
}

/// Whether lines are known. Without debug information, inlined code would be counted for the
/// function that contains it.
pub fn has_lines(counts: &Counts) -> bool {
    counts.instructions.keys().any(|place| in_crate(&place.file).is_some())
}

/// Returns the module of a line: the module of its file or, if the file is not one of the crate, of
/// its function. Line 0 marks an instruction that the compiler has merged from several lines: its
/// file is the file of any of them, so it is counted for its function.
fn module(place: &Place) -> String {
    match in_crate(&place.file).filter(|_| place.line > 0) {
        Some(path) => path.trim_end_matches(".rs").replace('/', "::"),
        None => of_function(&place.function).unwrap_or_default(),
    }
}

/// Returns the path of a file of the crate below `src`; all generated code is in `kernels.rs`.
fn in_crate(file: &str) -> Option<&str> {
    if file.ends_with(GENERATED) {
        return Some("kernels.rs");
    }
    file.split_once("forms-radiometry/src/").map(|(_, path)| path)
}

/// Returns the path of a function of the crate or of a kernel, also of one in an implementation.
fn of_function(symbol: &str) -> Option<String> {
    let name = format!("{:#}", rustc_demangle::demangle(symbol));
    let path = name.trim_start_matches('<');
    let of_kernel = || path.starts_with("forms_kernels::").then_some(path);
    path.strip_prefix("forms_radiometry::").or_else(of_kernel).map(str::to_owned)
}

/// File of the library with the macro calls that generate its kernels.
const GENERATED: &str = "forms-kernels/src/lib.rs";

/// Returns the files of the kernels that have run, as determined from lines.
pub fn kernel_files(counts: &Counts) -> BTreeSet<&'static str> {
    let lines: Vec<&str> = include_str!("../../../forms-kernels/src/lib.rs").lines().collect();
    let file = |place: &Place| {
        place.file.ends_with(GENERATED).then_some(())?;
        let line = lines.get((place.line as usize).checked_sub(1)?)?;
        library().iter().map(|file| file.name).find(|name| line.contains(&format!("kernels/{name}")))
    };
    counts.instructions.keys().filter_map(file).collect()
}

/// Function that calls the members of `gathered_light`. It is called by a pointer and is therefore
/// never inlined, while optimised members have no line of their own, since a member can be a single
/// operation.
const GATHERED: &str = "radiosity::gathered_light::gathered";

/// Returns the kernels that have run, as determined from functions: inlined kernels have none.
pub fn kernels(counts: &Counts) -> BTreeSet<String> {
    let name = |place: &Place| {
        let function = of_function(&place.function)?;
        if function == GATHERED {
            return Some("gathered_light".to_owned());
        }
        let path = function.strip_prefix("forms_kernels::")?;
        let end = path.find(|c: char| c != '_' && !c.is_ascii_alphanumeric()).unwrap_or(path.len());
        Some(path[..end].to_owned())
    };
    counts.instructions.keys().filter_map(name).collect()
}

/// Returns the file of a kernel of the library.
pub fn file_of(kernel: &str) -> Option<&'static str> {
    let warp = kernel.strip_suffix("_sample").unwrap_or(kernel);
    let declared = [format!("kernel {kernel}("), format!("warp {warp}(")];
    let declares = |text: &str| declared.iter().any(|declared| text.contains(declared.as_str()));
    library().iter().find(|file| declares(file.text)).map(|file| file.name)
}
