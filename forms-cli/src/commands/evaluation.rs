//! Evaluation of a kernel in one arithmetic, and its values as text.

/// Kernel in one arithmetic: parsing, evaluation and formatting of its numbers.
pub(super) trait Evaluation {
    /// Number type of the arithmetic.
    type Number;
    /// Returns the kernel's name.
    fn name(&self) -> &str;
    /// Returns the names of its arguments.
    fn arguments(&self) -> &[String];
    /// Returns the names of the columns of its values.
    fn columns(&self) -> Vec<String>;
    /// Parses a number.
    fn read(&self, text: &str) -> Result<Self::Number, Unread>;
    /// Computes the kernel's values.
    fn values(&self, arguments: &[Self::Number]) -> Vec<Computed>;
    /// Formats an argument.
    fn written(&self, argument: &Self::Number) -> String;
}

/// Value of a kernel.
pub(super) struct Computed {
    /// Formatted value.
    pub(super) text: String,
    /// Whether none of the available precisions reached the promised digits.
    pub(super) is_undecided: bool,
}

/// Reason why a text is not an argument.
pub(super) enum Unread {
    /// The text is not a number.
    NoNumber,
    /// The number exceeds the largest one of this type.
    TooLarge(&'static str),
}

impl Unread {
    pub(super) fn message(&self, name: &str, text: &str) -> String {
        let found: String = text.chars().take(40).collect();
        match self {
            Unread::NoNumber => {
                format!("expected a number such as 0.5, 1e-3 or 1/3 for `{name}`, found `{found}`")
            }
            Unread::TooLarge(numbers) => format!(
                "`{found}` for `{name}` exceeds the largest {numbers} number; use `--precision exact`"
            ),
        }
    }
}
