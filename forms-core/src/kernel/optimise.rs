//! Optimisation: runs the passes in their order with a few settings, and keeps the cheapest result.
//!
//! ```text
//! number_values ─ collect ─┬─ expand ─ factor ─┬─ share_sums ─ share_reciprocals ─ share_products ─┐
//!                          └───────────────────┘ for each setting, and once without                │
//!                                                                    ┌─────────────────────────────┘
//!                                                                    └─ linearise ─ absorb_signs
//! the cheapest ─ fuse ─ schedule
//! ```
//! Every pass preserves the value. The integrand of a quadrature is a kernel and goes through the
//! same passes before the kernel that contains it. Expansion is tried from the least to the most,
//! and is kept only if it makes the kernel cheaper, because a formula as its author wrote it is
//! usually the accurate one.

use super::constant_divisors::invert_constant_divisors;
use super::expand::{Limits, expand};
use super::factor::{Order, factor};
use super::fuse::fuse;
use super::graph::Graph;
use super::graph::collect::collect;
use super::linearise::linearise;
use super::numbering::number_values;
use super::products::share_products;
use super::program::Program;
use super::quotients::share_reciprocals;
use super::schedule::schedule;
use super::signs::absorb_signs;
use super::sums::share_sums;

/// Limits of expansion that are tried, from the least to the most.
const EXPANSIONS: [Limits; 3] = [
    Limits { product: 4, sum: 12, shared: 2 },
    Limits { product: 8, sum: 24, shared: 2 },
    Limits { product: 8, sum: 24, shared: 24 },
];

/// Largest number of instructions with a search over expansions; larger kernels are factored as
/// they are written.
const SEARCHED: usize = 4_000;

impl Program {
    /// Returns the same kernel at least cost.
    pub fn optimise(&self) -> Program {
        let numbered = number_values(&self.with_integrands(Program::optimise));
        let written = collect(&numbered).reordered();
        let is_searched = numbered.instructions.len() <= SEARCHED;
        let expansions = expansions(&written, is_searched);
        let mut best = cheaper(absorb_signs(&numbered), finished(&written, &numbered));
        let mut expansion = &written;
        for expanded in &expansions {
            let candidate = finished(&factor(expanded, Order::First), &numbered);
            if candidate.cost() < best.cost() {
                (best, expansion) = (candidate, expanded);
            }
        }
        if is_searched {
            best = cheaper(best, finished(&factor(expansion, Order::Last), &numbered));
        }
        // the product of numbers that `f64` can represent may be one that it cannot
        if best.is_representable() { schedule(&fuse(&best)) } else { self.clone() }
    }
}

/// Returns the program with each value computed once and signs absorbed, without any regrouping.
pub(super) fn grouped(program: &Program) -> Program {
    absorb_signs(&number_values(&invert_constant_divisors(program)))
}

/// Returns the cheaper of two programs, or the first if they cost the same.
fn cheaper(first: Program, second: Program) -> Program {
    if second.cost() < first.cost() { second } else { first }
}

/// Returns the distinct graphs to be tried: as written, and expanded within each limit.
fn expansions(written: &Graph, is_searched: bool) -> Vec<Graph> {
    let mut expansions = vec![written.clone()];
    for limits in EXPANSIONS.into_iter().filter(|_| is_searched) {
        add_if_new(&mut expansions, expand(written, limits).reordered());
    }
    expansions
}

fn add_if_new(graphs: &mut Vec<Graph>, graph: Graph) {
    if !graphs.iter().any(|known| known.is_same_as(&graph)) {
        graphs.push(graph);
    }
}

/// Returns the program of a graph with its common subexpressions shared.
fn finished(graph: &Graph, program: &Program) -> Program {
    let shared = share_products(&share_reciprocals(&share_sums(graph)));
    absorb_signs(&number_values(&invert_constant_divisors(&linearise(&shared, program))))
}
