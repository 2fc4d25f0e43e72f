//! Powers of known factors, and lists of them in the order of the factors.

/// Number of an interned denominator factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct FactorId(pub(super) u32);

/// Fᵉ in the denominator, or in the numerator for e < 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct FactorPower {
    pub(super) factor: FactorId,
    pub(super) exponent: i32,
}

impl FactorPower {
    pub(super) fn inverse(self) -> Self {
        FactorPower { exponent: -self.exponent, ..self }
    }
}

/// Common denominator of two factor lists: the larger exponents, and the powers that each side
/// lacks.
pub(super) struct CommonPowers {
    pub(super) all: Vec<FactorPower>,
    pub(super) lacking_left: Vec<FactorPower>,
    pub(super) lacking_right: Vec<FactorPower>,
}

/// Returns the least common denominator of two factor lists. A factor that a side does not have
/// counts as F⁰.
pub(super) fn common_powers(left: &[FactorPower], right: &[FactorPower]) -> CommonPowers {
    let mut factors: Vec<FactorId> = left.iter().chain(right).map(|power| power.factor).collect();
    factors.sort_unstable();
    factors.dedup();
    let mut common = CommonPowers { all: vec![], lacking_left: vec![], lacking_right: vec![] };
    for factor in factors {
        let (a, b) = (exponent_of(left, factor), exponent_of(right, factor));
        let larger = a.max(b);
        let lacking = |exponent: i32| FactorPower { factor, exponent: larger - exponent };
        push(&mut common.all, FactorPower { factor, exponent: larger });
        push(&mut common.lacking_left, lacking(a));
        push(&mut common.lacking_right, lacking(b));
    }
    common
}

fn push(powers: &mut Vec<FactorPower>, power: FactorPower) {
    if power.exponent != 0 {
        powers.push(power);
    }
}

fn exponent_of(powers: &[FactorPower], factor: FactorId) -> i32 {
    powers.binary_search_by_key(&factor, |power| power.factor).map_or(0, |place| powers[place].exponent)
}

/// Returns the product of two factor lists.
pub(super) fn merge_powers(a: &[FactorPower], b: &[FactorPower]) -> Vec<FactorPower> {
    let mut all: Vec<FactorPower> = a.to_vec();
    for power in b {
        match all.binary_search_by_key(&power.factor, |entry| entry.factor) {
            Ok(place) => all[place].exponent += power.exponent,
            Err(place) => all.insert(place, *power),
        }
    }
    all.retain(|power| power.exponent != 0);
    all
}
