//! Quotients: a denominator that three or more quotients share is inverted once.
//!
//! x/d, y/d, z/d become x i, y i, z i with i = 1/d. Denominators that are powers of one base share
//! the reciprocal of its lowest power: 1/r, 1/r², 1/r³ come from i = 1/r. Two quotients keep their
//! divisions, which round once.

use super::graph::{Coefficient, Exponent, Factor, Form, Graph, Node, Scaled};
use num_integer::Integer;
use rustc_hash::FxHashMap;

/// Number of quotients from which a reciprocal and multiplications are cheaper and worth their
/// rounding.
const SHARED: usize = 3;

/// Returns the graph with shared reciprocals.
pub(super) fn share_reciprocals(graph: &Graph) -> Graph {
    let mut denominators: FxHashMap<Vec<Factor>, usize> = FxHashMap::default();
    let mut powers: FxHashMap<Node, Vec<i32>> = FxHashMap::default();
    for node in graph.reachable() {
        let Form::Product(factors) = graph.form(node) else { continue };
        let below = below(graph, factors);
        if let [(base, exponent)] = below[..] {
            powers.entry(base).or_default().push(exponent.0);
        }
        *denominators.entry(below).or_insert(0) += 1;
    }
    powers.retain(|_, exponents| exponents.len() >= SHARED);
    denominators.retain(|below, count| *count >= SHARED && !below.is_empty());
    graph.rebuild(|new, node, images| {
        let Form::Product(factors) = graph.form(node) else { return None };
        let below = below(graph, factors);
        let reciprocal = match below[..] {
            [(base, exponent)] if powers.contains_key(&base) => {
                let unit = powers[&base].iter().fold(0, |unit, exponent| unit.gcd(exponent));
                let root = new.product(&[(images[base.place()], Exponent(unit))]);
                (inverted(new, root), Exponent(exponent.0 / unit * Exponent::WHOLE))
            }
            _ if denominators.contains_key(&below) => {
                let factors: Vec<_> = below.iter().map(|&(n, e)| (images[n.place()], e)).collect();
                let denominator = new.product(&factors);
                (inverted(new, denominator), Exponent::ONE)
            }
            _ => return None,
        };
        let others = factors.iter().filter(|&&(n, e)| !below.contains(&(n, e.negated())));
        let is_opened = |base: Node| !matches!(graph.form(base), Form::Product(_));
        let mut product: Vec<(Scaled, Exponent, bool)> =
            others.map(|&(n, e)| (images[n.place()], e, is_opened(n))).collect();
        product.push((reciprocal.0, reciprocal.1, false));
        Some(new.product_with(&product))
    })
}

/// Returns the denominator of a product, without numbers.
fn below(graph: &Graph, factors: &[Factor]) -> Vec<Factor> {
    let is_number = |base: Node| matches!(graph.form(base), Form::Number(_));
    let denominators = factors.iter().filter(|(base, e)| e.is_negative() && !is_number(*base));
    denominators.map(|&(base, e)| (base, e.negated())).collect()
}

/// Returns 1/d as a node that is not merged into products.
fn inverted(graph: &mut Graph, denominator: Scaled) -> Scaled {
    let node = graph.product_of(vec![(denominator.node, Exponent::MINUS_ONE)]);
    let coefficient = denominator.coefficient.power(-1).unwrap_or(Coefficient::ONE);
    Scaled { coefficient, node }
}
