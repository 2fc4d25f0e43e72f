//! Cache of expansions: code that this library has proved and emitted for a part of a source is not
//! proved again.
//!
//! ```text
//! tokens · rest · file of this library ─▶ Key ─┬─ entry with this key ─▶ [Emitted]
//!                                                 └─ none ─ compile ─ no diagnostics ─▶ [Emitted] ─▶ entry
//! ```
//! An entry is a file in a folder next to the compiled macros, which is below `target` and can be
//! deleted at any time. It contains its whole key, so it is used only for the same tokens, the same
//! rest (the name of the part, a file of choices, the kind of macro) and the same build of this
//! library: any change of the prover, of the arithmetic or of their features writes the file of this
//! library anew. The first line is a hash of all that follows, so a damaged entry is no entry.
//! Comments are not part of a key, and the documentation of kernels is inserted into what was
//! emitted. A part with diagnostics is never stored. If the folder or the file of this library cannot
//! be found, nothing is cached.

use forms_core::syntax::token::{Token, TokenKind};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::time::{SystemTime, UNIX_EPOCH};
use std::{fs, io};

/// Name of the folder of entries.
const FOLDER: &str = "forms-expansions";
/// Number of entries at which the older half is deleted.
const MOST: usize = 4000;

/// Rust text emitted for a kernel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Emitted {
    /// Its function, with a placeholder for the documentation that its author wrote.
    pub(crate) function: String,
    /// Its module, and a warning about its domain.
    pub(crate) items: String,
}

/// Input that determines an expansion, and the file of its entry.
#[derive(Debug)]
pub(crate) struct Key {
    text: String,
    file: PathBuf,
}

impl Key {
    /// Returns the key of a part of a source and of the rest of the input; nothing where nothing can
    /// be cached.
    pub(crate) fn of(tokens: &[Token], rest: &str) -> Option<Self> {
        let library = process_path::get_dylib_path()?;
        Self::at(&library, tokens, rest)
    }

    fn at(library: &Path, tokens: &[Token], rest: &str) -> Option<Self> {
        let written = fs::metadata(library).ok()?;
        let time = written.modified().ok()?.duration_since(UNIX_EPOCH).ok()?.as_nanos();
        let (path, size) = (library.display(), written.len());
        let source = spelled(tokens)?;
        let text = format!("{path} {size} {time}\n{source}\n{rest}");
        let name = hash(&text);
        Some(Key { text, file: library.parent()?.parent()?.join(FOLDER).join(name) })
    }

    /// Returns the code emitted for this key.
    pub(crate) fn read(&self) -> Option<Vec<Emitted>> {
        let entry = fs::read_to_string(&self.file).ok()?;
        let (sum, content) = entry.split_once('\n')?;
        let (count, texts) = content.split_once('\n').filter(|_| sum == hash(content))?;
        let texts = split(texts)?;
        let (key, emitted) = texts.split_first()?;
        if *key != self.text || Ok(emitted.len()) != count.parse::<usize>().map(|kernels| 2 * kernels) {
            return None;
        }
        let pair = |pair: &[&str]| Emitted { function: pair[0].to_owned(), items: pair[1].to_owned() };
        Some(emitted.chunks_exact(2).map(pair).collect())
    }

    /// Stores the code emitted for this key. An entry that cannot be written costs the time of the
    /// next expansion and nothing else, so errors are ignored.
    pub(crate) fn write(&self, emitted: &[Emitted]) {
        let _ = self.try_write(emitted);
    }

    fn try_write(&self, emitted: &[Emitted]) -> io::Result<()> {
        let Some(folder) = self.file.parent() else { return Ok(()) };
        fs::create_dir_all(folder)?;
        delete_older(folder)?;
        let mut entry = format!("{}\n", emitted.len());
        let texts = emitted.iter().flat_map(|emitted| [&emitted.function, &emitted.items]);
        for text in std::iter::once(&self.text).chain(texts) {
            entry += &format!("{}\n{text}\n", text.len());
        }
        // renamed when it is whole, since other processes read and write the same entry
        let unfinished = self.file.with_extension(std::process::id().to_string());
        let written = fs::write(&unfinished, format!("{}\n{entry}", hash(&entry)));
        let is_there = written.and_then(|()| fs::rename(&unfinished, &self.file));
        if is_there.is_err() {
            fs::remove_file(unfinished)?;
        }
        is_there
    }
}

/// Returns a hash of a text, in hexadecimal digits.
fn hash(text: &str) -> String {
    let mut hasher = DefaultHasher::new();
    text.hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

/// Returns the tokens without the text of their documentation; nothing if the language lacks
/// one.
fn spelled(tokens: &[Token]) -> Option<String> {
    let mut text = String::new();
    let mut is_doc = false;
    for token in tokens {
        let was_doc = std::mem::replace(&mut is_doc, matches!(token.kind, TokenKind::Doc(_)));
        match &token.kind {
            TokenKind::Name(name) | TokenKind::Number(name) => text += name,
            TokenKind::Symbol(symbol) => text += symbol.text(),
            TokenKind::Doc(_) if was_doc => continue,
            TokenKind::Doc(_) => text += "///",
            TokenKind::Unknown => return None,
        }
        text.push(' ');
    }
    Some(text)
}

/// Splits an entry into its texts, each of which stands after a line with its length in bytes.
fn split(mut entry: &str) -> Option<Vec<&str>> {
    let mut texts = Vec::new();
    while !entry.is_empty() {
        let (length, rest) = entry.split_once('\n')?;
        let (text, rest) = rest.split_at_checked(length.parse().ok()?)?;
        texts.push(text);
        entry = rest.strip_prefix('\n')?;
    }
    Some(texts)
}

/// Deletes the older half of the entries if there are too many.
fn delete_older(folder: &Path) -> io::Result<()> {
    let time = |entry: io::Result<fs::DirEntry>| -> io::Result<(SystemTime, PathBuf)> {
        let entry = entry?;
        Ok((entry.metadata()?.modified()?, entry.path()))
    };
    // times are read only if they are needed: each kernel has an entry
    if fs::read_dir(folder)?.count() < MOST {
        return Ok(());
    }
    let mut entries = fs::read_dir(folder)?.map(time).collect::<io::Result<Vec<_>>>()?;
    entries.sort();
    entries.iter().take(MOST / 2).try_for_each(|(_, path)| fs::remove_file(path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use forms_core::syntax::lex;

    /// Folder with a file in the place of the compiled macros.
    struct Library(PathBuf);

    impl Library {
        fn new(name: &str) -> Self {
            let folder = std::env::temp_dir().join(format!("forms-cache-{name}-{}", std::process::id()));
            fs::create_dir_all(folder.join("deps")).unwrap();
            let library = Library(folder);
            library.build("first");
            library
        }

        fn build(&self, content: &str) {
            fs::write(self.file(), content).unwrap();
        }

        fn file(&self) -> PathBuf {
            self.0.join("deps/macros")
        }

        fn key(&self, source: &str, rest: &str) -> Key {
            Key::at(&self.file(), &lex(source).0, rest).unwrap()
        }
    }

    impl Drop for Library {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    fn emitted() -> Vec<Emitted> {
        vec![Emitted { function: "fn one() {}\n".to_owned(), items: "mod one {\n3\n}".to_owned() }]
    }

    #[test]
    fn an_entry_is_found_for_the_same_source_whatever_its_comments_say() {
        let library = Library::new("found");
        library.key("/// One.\nkernel one(x) = x; // first", "").write(&emitted());
        let same = library.key("/// Another sentence.\n/// And more.\nkernel one(x) = x;", "");
        assert_eq!(same.read(), Some(emitted()));
    }

    #[test]
    fn an_entry_belongs_to_its_source_the_rest_and_the_build_of_the_library() {
        let library = Library::new("own");
        let source = "kernel one(x) = x;";
        library.key(source, "").write(&emitted());
        assert_eq!(library.key("kernel one(x) = 2*x;", "").read(), None);
        assert_eq!(library.key("/// One.\nkernel one(x) = x;", "").read(), None);
        assert_eq!(library.key(source, "one = x").read(), None);
        library.build("second one");
        assert_eq!(library.key(source, "").read(), None);
    }

    #[test]
    fn a_damaged_entry_is_no_entry() {
        let library = Library::new("damaged");
        let key = library.key("kernel one(x) = x;", "");
        key.write(&emitted());
        let whole = fs::read(&key.file).unwrap();
        for length in 0..whole.len() {
            fs::write(&key.file, &whole[..length]).unwrap();
            assert_eq!(key.read(), None, "{length}");
        }
        for place in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[place] ^= 1;
            fs::write(&key.file, damaged).unwrap();
            assert_eq!(key.read(), None, "{place}");
        }
    }

    #[test]
    fn an_entry_that_cannot_be_written_leaves_nothing_behind() {
        let library = Library::new("blocked");
        let key = library.key("kernel one(x) = x;", "");
        fs::create_dir_all(&key.file).unwrap();
        key.write(&emitted());
        assert_eq!(key.read(), None);
        assert_eq!(fs::read_dir(key.file.parent().unwrap()).unwrap().count(), 1);
    }

    #[test]
    fn a_source_that_cannot_be_read_has_no_key() {
        let library = Library::new("unread");
        assert!(Key::at(&library.file(), &lex("kernel one(x) = §;").0, "").is_none());
        assert!(Key::at(&library.0.join("none"), &[], "").is_none());
    }
}
