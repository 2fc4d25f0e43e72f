//! Cut points: two expressions are compared with variables substituted for the sums that they
//! share, so that the remaining equation is small.
//!
//! ```text
//! two sides ─ sums of equal residue ─▶ shared sums ─ cut while residues stay equal ─▶ two short sides ─▶ normal form
//! ```
//! An equality for all values of the variables also holds for the values of the sums. The converse
//! can fail: a (b + c) is a b + a c, but not if b + c is a variable of its own. Residues show how
//! much can be cut, the largest sums first. Sums of different form are proved equal, again by cuts,
//! before one variable replaces them. This is the method of cut points in the equivalence checking
//! of circuits (A. Kuehlmann, F. Krohm, "Equivalence checking using cuts and heaps", 1997).

use super::residue::Residues;
use crate::decide::{Budget, Equations, Finding};
use crate::expression::{Expr, Node, Pool, SymbolKind};
use crate::polynomial::modular::neg;
use rustc_hash::{FxHashMap, FxHashSet};

/// Budget for the equation that remains after cuts, which is small.
const EFFORT: Budget = Budget { work: 1_000_000, candidates: 24, points: 4 };

/// Sum that equals a shared sum or its negative.
struct Member {
    sum: Expr,
    is_negative: bool,
}

/// Sums of equal residue, up to sign, at least one of them on each side.
type Shared = Vec<Member>;

/// Comparisons of fractions in roots of variables.
#[derive(Default)]
pub(super) struct Cuts {
    residues: Residues,
    decided: FxHashMap<(Expr, Expr), bool>,
    /// Variables that replace shared sums; every comparison uses them anew.
    variables: Vec<Expr>,
}

impl Cuts {
    /// Whether the expressions are proved equal, each to its counterpart, wherever both are
    /// defined.
    pub(super) fn are_equal(&mut self, pool: &mut Pool, left: &[Expr], right: &[Expr]) -> bool {
        left.iter().zip(right).all(|(&left, &right)| self.may_be_equal(pool, left, right))
            && left.iter().zip(right).all(|(&left, &right)| self.is_equal(pool, left, right))
    }

    /// Whether the residues do not distinguish the two expressions.
    fn may_be_equal(&mut self, pool: &Pool, left: Expr, right: Expr) -> bool {
        match (self.residues.of(pool, left), self.residues.of(pool, right)) {
            (Some(left), Some(right)) => left == right,
            _ => true,
        }
    }

    fn is_equal(&mut self, pool: &mut Pool, left: Expr, right: Expr) -> bool {
        if left == right {
            return true;
        }
        let sides = (left.min(right), left.max(right));
        if let Some(&known) = self.decided.get(&sides) {
            return known;
        }
        let have_residues = [left, right].iter().all(|&side| self.residues.of(pool, side).is_some());
        let equal = self.may_be_equal(pool, left, right)
            && if have_residues {
                self.are_equal_by_cuts(pool, [left, right])
            } else {
                are_equal_as_they_stand(pool, [left, right])
            };
        self.decided.insert(sides, equal);
        equal
    }

    fn are_equal_by_cuts(&mut self, pool: &mut Pool, sides: [Expr; 2]) -> bool {
        let mut shared = self.shared_sums(pool, sides);
        loop {
            let cut = self.most_cuts(pool, sides, &shared);
            let values = self.values(&shared, &cut);
            let met = met(pool, sides, &values);
            let different = cut.into_iter().find(|&place| !self.are_one_sum(pool, &shared[place], &met));
            let Some(different) = different else {
                let images = images(pool, sides, &values);
                return are_equal_as_they_stand(pool, images);
            };
            shared.remove(different);
        }
    }

    /// Whether the sums in `met` are proved equal to the first of them, up to sign; as elements of
    /// one field they are then equal to each other.
    fn are_one_sum(&mut self, pool: &mut Pool, sums: &Shared, met: &FxHashSet<Expr>) -> bool {
        let mut met = sums.iter().filter(|member| met.contains(&member.sum));
        let Some(first) = met.next() else { return true };
        met.all(|member| {
            let like_first =
                if member.is_negative == first.is_negative { member.sum } else { pool.negate(member.sum) };
            self.is_equal(pool, first.sum, like_first)
        })
    }

    /// Returns the sums that occur inside both sides, each before the sums that it contains.
    fn shared_sums(&mut self, pool: &Pool, sides: [Expr; 2]) -> Vec<Shared> {
        let mut by_residue: FxHashMap<u64, (Shared, [bool; 2])> = FxHashMap::default();
        for (place, &side) in sides.iter().enumerate() {
            for sum in pool.reachable(&[side]) {
                let is_sum = matches!(pool.node(sum), Node::Add(..)) && !sides.contains(&sum);
                let residue = if is_sum { self.residues.of(pool, sum) } else { None };
                let Some(residue) = residue.filter(|&residue| residue != 0) else { continue };
                let (members, occurs) = by_residue.entry(residue.min(neg(residue))).or_default();
                occurs[place] = true;
                if members.iter().all(|member| member.sum != sum) {
                    members.push(Member { sum, is_negative: residue > neg(residue) });
                }
            }
        }
        let shared = by_residue.into_values().filter(|(_, occurs)| *occurs == [true, true]);
        let mut shared: Vec<Shared> = shared.map(|(members, _)| members).collect();
        shared.sort_by_key(|members| std::cmp::Reverse(members.iter().map(|member| member.sum).max()));
        shared
    }

    /// Returns the indices of shared sums that can be variables together: as many as keep the
    /// residues of the sides equal, with earlier sums preferred to later ones.
    fn most_cuts(&mut self, pool: &mut Pool, sides: [Expr; 2], shared: &[Shared]) -> Vec<usize> {
        while self.variables.len() < shared.len() {
            let symbol = pool.declare_symbol(format!("sum_{}", self.variables.len()), SymbolKind::Local);
            self.variables.push(pool.symbol(symbol));
        }
        let order = pool.reachable(&sides);
        let mut cut: Vec<usize> = Vec::new();
        let mut open = vec![(0, shared.len())];
        while let Some((start, end)) = open.pop() {
            let more: Vec<usize> = cut.iter().copied().chain(start..end).collect();
            if self.leaves_one_residue(pool, &order, sides, &self.values(shared, &more)) {
                cut = more;
            } else if end - start > 1 {
                let middle = start.midpoint(end);
                open.extend([(middle, end), (start, middle)]);
            }
        }
        cut
    }

    /// Returns the variable that replaces each sum that is cut, and whether the sum is its
    /// negative.
    fn values(&self, shared: &[Shared], cut: &[usize]) -> FxHashMap<Expr, (Expr, bool)> {
        let members = cut.iter().flat_map(|&place| shared[place].iter().map(move |member| (place, member)));
        members.map(|(place, member)| (member.sum, (self.variables[place], member.is_negative))).collect()
    }

    fn leaves_one_residue(
        &self,
        pool: &Pool,
        order: &[Expr],
        sides: [Expr; 2],
        values: &FxHashMap<Expr, (Expr, bool)>,
    ) -> bool {
        let mut residues = Residues::default();
        for (&sum, &(variable, is_negative)) in values {
            let residue = residues.of(pool, variable);
            residues.set(sum, if is_negative { residue.map(neg) } else { residue });
        }
        residues.extend(pool, order);
        let [left, right] = sides.map(|side| residues.of(pool, side));
        left.is_some() && left == right
    }
}

/// Returns the sums with values that are reached from the sides downwards, outside other sums with
/// values.
fn met(pool: &Pool, sides: [Expr; 2], values: &FxHashMap<Expr, (Expr, bool)>) -> FxHashSet<Expr> {
    let (mut seen, mut met) = (FxHashSet::default(), FxHashSet::default());
    let mut open = sides.to_vec();
    while let Some(part) = open.pop() {
        if values.contains_key(&part) {
            met.insert(part);
        } else if seen.insert(part) {
            pool.node(part).for_each_operand(|operand| open.push(operand));
        }
    }
    met
}

/// Substitutes the values for the sums in both sides.
fn images(pool: &mut Pool, sides: [Expr; 2], values: &FxHashMap<Expr, (Expr, bool)>) -> [Expr; 2] {
    let value = |(&sum, &(variable, is_negative)): (&Expr, &(Expr, bool))| {
        (sum, if is_negative { pool.negate(variable) } else { variable })
    };
    let values: FxHashMap<Expr, Expr> = values.iter().map(value).collect();
    sides.map(|side| pool.replace(side, &values))
}

fn are_equal_as_they_stand(pool: &mut Pool, [left, right]: [Expr; 2]) -> bool {
    left == right
        || matches!(
            (Equations { sides: &[(left, right)], conditions: &[] }).decide(pool, EFFORT),
            Finding::Equal { .. }
        )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// Whether the two outputs of a kernel are proved to be equal.
    fn are_equal(outputs: &str) -> bool {
        let (theory, errors) = read_theory(&format!("kernel f(a, b, c, d, x, y) = ({outputs});"));
        assert!(errors.is_empty(), "{errors:?}");
        let (mut pool, sides) = (theory.pool, &theory.kernels[0].outputs);
        Cuts::default().are_equal(&mut pool, &sides[..1], &sides[1..])
    }

    #[test]
    fn shared_sums_need_not_be_multiplied_out() {
        assert!(are_equal("(a + b + c + d)**60*(x + y), (d + c + b + a)**60*x + y*(c + d + a + b)**60"));
        assert!(are_equal("x/(a*c - b)**70 - y/(a*c - b)**70, (y - x)*(-1)/(b - c*a)**70"));
    }

    #[test]
    fn sums_of_which_others_are_made_are_looked_into() {
        assert!(are_equal("x*(a + b) + (a + b)**60, a*x + x*b + (b + a)**60"));
        assert!(are_equal("((a + b)*(c + d) + x)**60*y, y*(a*(c + d) + b*c + b*d + x)**60"));
    }

    #[test]
    fn roots_of_variables_are_numbers_of_their_own() {
        assert!(are_equal("sqrt(a)*sqrt(a)*(b + c)**60, a*(c + b)**60"));
        assert!(!are_equal("sqrt(a)*sqrt(b)*(b + c)**60, a*(c + b)**60"));
    }

    #[test]
    fn a_lost_sign_or_an_exchanged_coefficient_is_no_equality() {
        assert!(!are_equal("(a + b)**60*(x + y), (a + b)**60*x - y*(b + a)**60"));
        assert!(!are_equal("(a + b)**60*x + (c - d)**60*y, (a + b)**60*y + (c - d)**60*x"));
        assert!(!are_equal("(a - b)**61*x, (b - a)**61*x"));
        assert!(!are_equal("(a + b)*(c + d)*x, (a + b)*(c + d)*x + (a - b)*(a + b) + b**2 - x**2"));
    }

    #[test]
    fn what_has_no_residue_is_compared_as_it_stands() {
        assert!(are_equal("sqrt(2)*(a + b), b*sqrt(2) + sqrt(2)*a"));
        assert!(!are_equal("sqrt(2)*(a + b), b*sqrt(2) + sqrt(3)*a"));
    }
}
