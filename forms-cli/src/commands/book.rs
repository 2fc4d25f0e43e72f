//! `forms book`: the embedded book, written as pages or expanded for mdBook.

use crate::commands::refuse;
use crate::decisions::workers;
use crate::status::Status;
use crate::streams::tell;
use forms::core::diagnostic::counted;
use forms_book::Problem;
use rayon::prelude::*;
use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;

/// Writes every page and figure into a folder.
pub(crate) fn book(out: &str, output: &mut dyn Write) -> io::Result<Status> {
    let book = forms_book::book();
    let names: Vec<&str> = book.names().collect();
    let made: Vec<_> = workers()?.install(|| names.par_iter().map(|&name| (name, book.html(name))).collect());
    let problems: Vec<&Problem> =
        made.iter().filter_map(|(_, page)| page.as_ref()?.err()).flatten().collect();
    if !problems.is_empty() {
        problems.iter().for_each(|problem| tell!("error: {problem}"));
        return Ok(Status::Error);
    }
    let pages =
        made.iter().filter_map(|(name, page)| Some(((*name).to_owned(), page.as_ref()?.ok()?.as_bytes())));
    let files: Vec<(String, &[u8])> = pages.chain(book.figures()).collect();
    if let Err(error) = files.iter().try_for_each(|(name, bytes)| write(&Path::new(out).join(name), bytes)) {
        return Ok(refuse(&format!("cannot write the book to {out}: {error}")));
    }
    writeln!(output, "{} written; start at {out}/index.html", counted(made.len(), "page"))?;
    Ok(Status::AsStated)
}

fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    path.parent().map_or(Ok(()), fs::create_dir_all)?;
    fs::write(path, bytes)
}

/// Answers mdBook: whether a renderer is supported, or the book with formulas and verdicts
/// inserted.
pub(crate) fn preprocess(question: &[String], output: &mut dyn Write) -> io::Result<Status> {
    if let [question, renderer] = question {
        let is_known = question == "supports" && renderer == "html";
        return Ok(if is_known { Status::AsStated } else { Status::NotAsStated });
    }
    let mut input = String::new();
    io::stdin().read_to_string(&mut input)?;
    match forms_book::preprocess(&input) {
        Ok(book) => {
            writeln!(output, "{book}")?;
            Ok(Status::AsStated)
        }
        Err(error) => Ok(refuse(&error.to_string())),
    }
}
