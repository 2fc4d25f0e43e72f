//! Diagnostics about the user's text: one type for every error, from the lexer to the prover.
//!
//! A [`Span`] is a range of places in the source from which a token stream was made: byte offsets
//! for a text file, token numbers for a macro. The producer of the tokens converts places back to
//! locations in its source.

/// Half-open range of places in one source. An empty range directly follows the place before it and
/// marks where something is missing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// First place in the range.
    pub start: u32,
    /// First place after the range.
    pub end: u32,
}

impl Span {
    /// Creates the range from `start` up to, not including, `end`.
    pub fn new(start: u32, end: u32) -> Self {
        Span { start, end }
    }

    /// Returns the smallest range that contains both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// Category of a diagnostic, on which its further treatment depends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// An error in the source.
    Mistake,
    /// An undeclared name. It can also be declared by an item that could not be read.
    UnknownName,
    /// The number of further diagnostics that are not shown.
    Rest,
    /// A consequence of another error, which is the one to fix.
    Consequence,
    /// No value was found although the text can be right: a statement about it is undecided.
    Open,
}

/// One problem, its place, and a suggested fix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// Characters or tokens it refers to.
    pub span: Span,
    /// Description of the problem and of the expected input, as one sentence without a full stop.
    pub message: String,
    /// Suggested replacement, where one is known.
    pub help: Option<String>,
    /// Another place it depends on, with a label: the bracket that is not closed, the first of two
    /// declarations.
    pub related: Option<(Span, String)>,
    /// Its category.
    pub kind: Kind,
}

impl Diagnostic {
    /// Creates a diagnostic without a hint.
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Diagnostic { span, message: message.into(), help: None, related: None, kind: Kind::Mistake }
    }

    /// Sets the category.
    #[must_use]
    pub fn of(mut self, kind: Kind) -> Self {
        self.kind = kind;
        self
    }

    /// Sets the hint.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Sets the related place.
    #[must_use]
    pub fn with_related(mut self, place: Span, name: impl Into<String>) -> Self {
        self.related = Some((place, name.into()));
        self
    }
}

/// Maximum number of diagnostics shown for one source.
pub const MOST_DIAGNOSTICS: usize = 128;

/// Keeps the first diagnostics and adds one with the number of the others.
pub fn limited(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    if let Some(first) = diagnostics.get(MOST_DIAGNOSTICS) {
        let rest = diagnostics.len() - MOST_DIAGNOSTICS;
        let message = counted(rest, "more error");
        let summary = Diagnostic::new(first.span, message).of(Kind::Rest);
        diagnostics.truncate(MOST_DIAGNOSTICS);
        diagnostics.push(summary);
    }
    diagnostics
}

/// Formats a count with its noun: `1 range`, `2 ranges`.
pub fn counted(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}
