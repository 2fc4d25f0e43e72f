//! Regimes: the kinds of arguments that errors are looked at apart for.

/// A kind of arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Regime {
    /// Moderate sizes: from about 1/64 to 64 where the domain allows, evenly over it where it is bounded.
    Typical,
    /// Every number of the domain as likely as every other, so all powers of two alike.
    Everywhere,
    /// Close to the lower end of the range of an argument.
    LowerEdge,
    /// Close to the upper end of the range of an argument.
    UpperEdge,
    /// Arguments that are subtracted from each other close together, or all far from zero.
    Coincident,
    /// Close to where a part of the formula vanishes: a divisor, a radicand, a sum whose terms cancel.
    Singular,
    /// Arguments of large size.
    Large,
    /// Arguments of small size.
    Small,
}

impl Regime {
    /// All of them, the typical one first.
    pub const ALL: [Regime; 8] = [
        Regime::Typical,
        Regime::Everywhere,
        Regime::LowerEdge,
        Regime::UpperEdge,
        Regime::Coincident,
        Regime::Singular,
        Regime::Large,
        Regime::Small,
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Regime::Typical => "typical",
            Regime::Everywhere => "everywhere",
            Regime::LowerEdge => "lower edge",
            Regime::UpperEdge => "upper edge",
            Regime::Coincident => "coincident",
            Regime::Singular => "singular",
            Regime::Large => "large",
            Regime::Small => "small",
        }
    }
}
