//! Regimes: kinds of arguments whose errors are reported separately.

/// A kind of arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Regime {
    /// Moderate sizes: from about 1/64 to 64 where the domain allows, uniform over a bounded
    /// domain.
    Typical,
    /// Every number of the domain is equally likely, so all powers of two are too.
    Everywhere,
    /// Close to the lower end of the range of an argument.
    LowerEdge,
    /// Close to the upper end of the range of an argument.
    UpperEdge,
    /// Arguments that are subtracted from each other are close together, or all far from zero; vectors
    /// are nearly parallel.
    Coincident,
    /// Close to a zero of a part of the formula: a divisor, a radicand, a sum whose terms cancel.
    Singular,
    /// Arguments of large size.
    Large,
    /// Arguments of small size.
    Small,
}

impl Regime {
    /// All regimes, the typical one first.
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

    /// Returns the name of the regime.
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
