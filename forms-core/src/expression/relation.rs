//! Relations between two real numbers: what they mean, how they are written, what is true where they fail.

use crate::syntax::ast::Relation;
use std::cmp::Ordering;

impl Relation {
    /// Whether two numbers in this order are in the relation.
    pub fn admits(self, order: Ordering) -> bool {
        match self {
            Relation::Less => order.is_lt(),
            Relation::LessEqual => order.is_le(),
            Relation::Greater => order.is_gt(),
            Relation::GreaterEqual => order.is_ge(),
            Relation::NotEqual => order.is_ne(),
        }
    }

    /// What holds where it fails; equality, where `!=` fails, is no relation of the language.
    pub fn complement(self) -> Option<Relation> {
        match self {
            Relation::Less => Some(Relation::GreaterEqual),
            Relation::LessEqual => Some(Relation::Greater),
            Relation::Greater => Some(Relation::LessEqual),
            Relation::GreaterEqual => Some(Relation::Less),
            Relation::NotEqual => None,
        }
    }

    /// The relation read from right to left.
    pub fn mirrored(self) -> Relation {
        match self {
            Relation::Less => Relation::Greater,
            Relation::LessEqual => Relation::GreaterEqual,
            Relation::Greater => Relation::Less,
            Relation::GreaterEqual => Relation::LessEqual,
            Relation::NotEqual => Relation::NotEqual,
        }
    }

    /// How it is written.
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
