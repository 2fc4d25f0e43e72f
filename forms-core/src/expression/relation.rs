//! Relations between two real numbers: their meaning, notation, complement and mirror image.

use std::cmp::Ordering;

/// Relation between two scalars.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Relation {
    /// `<`
    Less,
    /// `<=`
    LessEqual,
    /// `>`
    Greater,
    /// `>=`
    GreaterEqual,
    /// `!=`
    NotEqual,
}

impl Relation {
    /// Whether two numbers that compare in this way satisfy the relation.
    pub fn admits(self, order: Ordering) -> bool {
        match self {
            Relation::Less => order.is_lt(),
            Relation::LessEqual => order.is_le(),
            Relation::Greater => order.is_gt(),
            Relation::GreaterEqual => order.is_ge(),
            Relation::NotEqual => order.is_ne(),
        }
    }

    /// Returns the relation that holds where this one fails. `None` for `!=`, since equality is not
    /// a relation of the language.
    pub fn complement(self) -> Option<Relation> {
        match self {
            Relation::Less => Some(Relation::GreaterEqual),
            Relation::LessEqual => Some(Relation::Greater),
            Relation::Greater => Some(Relation::LessEqual),
            Relation::GreaterEqual => Some(Relation::Less),
            Relation::NotEqual => None,
        }
    }

    /// Returns the relation read from right to left.
    pub fn mirrored(self) -> Relation {
        match self {
            Relation::Less => Relation::Greater,
            Relation::LessEqual => Relation::GreaterEqual,
            Relation::Greater => Relation::Less,
            Relation::GreaterEqual => Relation::LessEqual,
            Relation::NotEqual => Relation::NotEqual,
        }
    }

    /// Returns the relation as the language writes it.
    pub fn text(self) -> &'static str {
        match self {
            Relation::Less => "<",
            Relation::LessEqual => "<=",
            Relation::Greater => ">",
            Relation::GreaterEqual => ">=",
            Relation::NotEqual => "!=",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_relation_or_its_complement_admits_each_order() {
        let relations = [Relation::Less, Relation::LessEqual, Relation::Greater, Relation::GreaterEqual];
        for relation in relations {
            let complement = relation.complement().expect("a complement");
            for order in [Ordering::Less, Ordering::Equal, Ordering::Greater] {
                assert_ne!(relation.admits(order), complement.admits(order), "{relation:?} {order:?}");
            }
        }
        assert!(!Relation::NotEqual.admits(Ordering::Equal) && Relation::NotEqual.complement().is_none());
    }
}
