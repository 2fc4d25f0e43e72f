//! What is said to the user about their own text: one type for every error, from the lexer to the prover.
//!
//! A [`Span`] is a range of places in the source a token stream was made from: byte offsets for a text file,
//! token numbers for a macro. Whoever made the tokens turns places back into something to point at.

/// A half-open range of places in one source. An empty range stands just behind the place before it: that is
/// where something is missing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// The first place that belongs to the range.
    pub start: u32,
    /// The first place after it.
    pub end: u32,
}

impl Span {
    /// The range from `start` up to, not including, `end`.
    pub fn new(start: u32, end: u32) -> Self {
        Span { start, end }
    }

    /// The smallest range that holds both.
    pub fn to(self, other: Span) -> Span {
        Span { start: self.start.min(other.start), end: self.end.max(other.end) }
    }
}

/// What sort of thing is said, for what is decided by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Something is wrong.
    Mistake,
    /// Nobody declared a name. Where an item could not be read, it may be what declares it.
    UnknownName,
    /// It says how many others are not shown.
    Rest,
    /// It follows from another error, which is the one to read.
    Consequence,
    /// The text may be right, and only its value was not found: a statement about it is undecided.
    Open,
}

/// One thing that is wrong, where, and what to do about it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    /// The characters or tokens it speaks of.
    pub span: Span,
    /// What is wrong and what was expected, as one sentence without a full stop.
    pub message: String,
    /// What to write instead, where that is known.
    pub help: Option<String>,
    /// Another place it depends on, named: the bracket that is not closed, the first of two declarations.
    pub related: Option<(Span, String)>,
    /// What sort of thing it is.
    pub kind: Kind,
}

impl Diagnostic {
    /// A diagnostic without a hint.
    pub fn new(span: Span, message: impl Into<String>) -> Self {
        Diagnostic { span, message: message.into(), help: None, related: None, kind: Kind::Mistake }
    }

    /// The same as one of another sort.
    #[must_use]
    pub fn of(mut self, kind: Kind) -> Self {
        self.kind = kind;
        self
    }

    /// The same with a hint.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// The same with another place that it depends on.
    #[must_use]
    pub fn with_related(mut self, place: Span, name: impl Into<String>) -> Self {
        self.related = Some((place, name.into()));
        self
    }
}

/// The most diagnostics that are shown of one source.
pub const MOST_DIAGNOSTICS: usize = 128;

/// The first diagnostics, and one that says how many more there are.
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

/// So many things, in words: `1 range`, `2 ranges`.
pub fn counted(count: usize, thing: &str) -> String {
    format!("{count} {thing}{}", if count == 1 { "" } else { "s" })
}
