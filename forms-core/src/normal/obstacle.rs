//! Obstacles: reasons why an expression has no normal form.

/// Reason why an expression has no normal form here.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// A finer generator is needed (a half angle, a factor of a radicand); the conversion starts
    /// again.
    Refine,
    /// The expression divides by zero everywhere.
    DivisionByZero,
    /// A part lies outside the class that is decided; the text says which.
    Outside(String),
    /// The normal form is too large; the text names the limit.
    TooLarge(String),
}
