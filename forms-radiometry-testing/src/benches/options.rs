//! Command line of a bench: no options for criterion, `--table WORD…` for tables, `--write` for
//! tables in the page.

use forms_testing::page::replaced;
use std::io;
use std::path::Path;

/// Options of the bench.
pub struct Options {
    options: Vec<String>,
    words: Vec<String>,
}

impl Options {
    /// Reads the options of the command line.
    pub fn read() -> Self {
        let (options, words) = std::env::args().skip(1).partition(|argument| argument.starts_with('-'));
        Self { options, words }
    }

    fn has(&self, name: &str) -> bool {
        self.options.iter().any(|option| option == name)
    }

    /// Whether tables are requested instead of criterion.
    pub fn are_tables(&self) -> bool {
        self.has("--table") || self.has("--write")
    }

    /// Whether a work with this title is requested: no words are given, or the title contains one
    /// of them.
    pub fn is_wanted(&self, title: &str) -> bool {
        self.are_all() || self.words.iter().any(|word| title.contains(word.as_str()))
    }

    /// Whether all works are requested.
    pub fn are_all(&self) -> bool {
        self.words.is_empty()
    }

    /// Prints the tables, and writes them into a part of the page if that is requested and they are
    /// complete.
    pub fn put(&self, part: &str, tables: &str) -> io::Result<()> {
        print!("{tables}");
        if self.has("--write") && self.are_all() {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/benchmarks.md");
            let page = replaced(&std::fs::read_to_string(&path)?, part, tables);
            std::fs::write(path, page)?;
        }
        Ok(())
    }
}
