//! Kernels of a file or of the library, found by name and generated.

use crate::streams::tell;
use crate::theory_file::{self, FileError, TheoryFile};
use forms::core::compile::compile_kernel;
use forms::core::diagnostic::Diagnostic;
use forms::core::expression::Pool;
use forms::core::generation::Generated;
use forms::core::theory::Kernel;

/// Value of FILE that selects the library.
pub(crate) const LIBRARY: &str = "-";

/// Reads the files named by FILE: one on disk, or the files of the library.
pub(crate) fn files(file: &str) -> Result<Vec<TheoryFile>, Vec<FileError>> {
    let files = if file == LIBRARY { library() } else { theory_file::read(file).map(|file| vec![file]) }?;
    files.iter().filter_map(|file| file.warning.as_ref()).for_each(|warning| tell!("{warning}"));
    Ok(files)
}

/// Reads the files of the library.
pub(crate) fn library() -> Result<Vec<TheoryFile>, Vec<FileError>> {
    let read = |file: &forms_kernels::TheoryFile| {
        let mut theory = theory_file::from_text(file.name, file.text)?;
        if let Some(choices) = file.choices {
            theory.choose("the choices of forms of the library", choices)?;
        }
        Ok(theory)
    };
    forms_kernels::library().iter().map(read).collect()
}

/// Finds a kernel by its name, with its file.
pub(crate) fn find<'a>(files: &'a [TheoryFile], name: &str) -> Result<(&'a TheoryFile, &'a Kernel), String> {
    let all = || files.iter().flat_map(|file| file.theory.kernels.iter().map(move |kernel| (file, kernel)));
    all().find(|(_, kernel)| kernel.name == name).ok_or_else(|| {
        let names: Vec<&str> = all().map(|(_, kernel)| kernel.name.as_str()).collect();
        match names.as_slice() {
            [] => format!("there is no kernel named `{name}`; there are no kernels"),
            names => format!("there is no kernel named `{name}`; there are {}", names.join(", ")),
        }
    })
}

/// Generates the programs of a kernel, or returns all of its errors. The kernel becomes public,
/// since its source is meant to be used elsewhere.
pub(crate) fn generated(file: &TheoryFile, kernel: &Kernel) -> Result<Generated, Vec<FileError>> {
    compiled(file, kernel, compile_kernel)
}

/// Generates the program of a kernel's formula as written.
pub(crate) fn generated_as_written(file: &TheoryFile, kernel: &Kernel) -> Result<Generated, Vec<FileError>> {
    compiled(file, kernel, Generated::of_formula)
}

fn compiled(
    file: &TheoryFile,
    kernel: &Kernel,
    compile: impl Fn(&mut Pool, &Kernel) -> Result<Generated, Vec<Diagnostic>>,
) -> Result<Generated, Vec<FileError>> {
    let mut kernel = kernel.clone();
    kernel.public = true;
    let mut pool = file.theory.pool.clone();
    compile(&mut pool, &kernel)
        .map_err(|errors| errors.iter().map(|error| FileError::at(&file.source, error)).collect())
}
