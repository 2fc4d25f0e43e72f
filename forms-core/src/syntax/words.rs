//! Reserved words, which cannot be names, in one table.

use rustc_hash::FxHashMap;
use std::sync::OnceLock;

/// Reason why a word is reserved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// Rust reserves it, so no generated function or argument could have this name.
    Rust,
    /// It begins or structures an item: `chart`, `where`, `on`.
    Item,
    /// It is a function or constant of expressions: `d`, `pullback`, `sqrt`, `pi`.
    Function,
}

/// Words that begin an item.
pub const ITEMS: &[&str] =
    &["chart", "param", "fn", "let", "form", "field", "map", "metric", "prove", "refute", "kernel", "warp"];

/// Words that occur inside items.
pub const INSIDE: &[&str] = &["pub", "where", "on", "if", "else", "jump", "effects"];

/// Contextual keywords: they have a meaning where an item expects them, and can be names elsewhere.
pub const CONTEXTUAL: &[&str] =
    &["by", "approx", "for", "within", "onto", "density", "of", "inverse", "jacobian", "value_and_jacobian"];

/// Functions of arrays, and repetition: a file can give these names another meaning.
pub const ARRAY_FUNCTIONS: &[&str] = &["dot", "cross", "transpose", "sum", "product"];

/// Functions with common names: a file can give these names another meaning.
pub const COMMON_FUNCTIONS: &[&str] =
    &["min", "max", "copysign", "hypot", "cbrt", "erfc", "sec", "csc", "cot"];

/// Functions that take a metric in square brackets.
pub const METRIC_OPERATIONS: &[&str] =
    &["hodge", "codiff", "laplace", "flat", "sharp", "inner", "norm", "volume", "grad", "curl", "div"];

/// Functions of the language, and its constant.
pub const FUNCTIONS: &[&str] = &[
    "d",
    "interior",
    "lie",
    "bracket",
    "pair",
    "pullback",
    "diff",
    "hodge",
    "codiff",
    "laplace",
    "flat",
    "sharp",
    "inner",
    "norm",
    "volume",
    "grad",
    "curl",
    "div",
    "potential",
    "integral",
    "boundary_integral",
    "quadrature",
    "sqrt",
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "atan2",
    "exp",
    "log",
    "sinh",
    "cosh",
    "tanh",
    "abs",
    "expm1",
    "log1p",
    "erf",
    "expint1",
    "expint2",
    "expint3",
    "dilog",
    "clausen",
    "pi",
];

/// Strict and reserved keywords of every Rust edition, and the wildcard.
const RUST: &[&str] = &[
    "as", "break", "const", "continue", "crate", "else", "enum", "extern", "false", "fn", "for", "if",
    "impl", "in", "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "Self",
    "static", "struct", "super", "trait", "true", "type", "unsafe", "use", "where", "while", "async",
    "await", "dyn", "abstract", "become", "box", "do", "final", "gen", "macro", "override", "priv", "try",
    "typeof", "unsized", "virtual", "yield", "_",
];

/// Whether a word is a function of the language, in files that give it no other meaning.
pub(crate) fn is_function(text: &str) -> bool {
    [FUNCTIONS, ARRAY_FUNCTIONS, COMMON_FUNCTIONS].iter().any(|list| list.contains(&text))
}

/// Whether Rust reserves a word.
pub(crate) fn is_rust_keyword(text: &str) -> bool {
    RUST.contains(&text)
}

/// Returns the reason why `text` cannot be a name; `None` if it can. Words of both languages count
/// as words of this one.
pub fn reserved(text: &str) -> Option<Word> {
    static WORDS: OnceLock<FxHashMap<&str, Word>> = OnceLock::new();
    let words = WORDS.get_or_init(|| {
        let lists =
            [(RUST, Word::Rust), (FUNCTIONS, Word::Function), (INSIDE, Word::Item), (ITEMS, Word::Item)];
        let pairs = lists.into_iter().flat_map(|(list, word)| list.iter().map(move |text| (*text, word)));
        pairs.collect()
    });
    words.get(text).copied()
}
