//! Optimisation: the passes in their order, tried with a few settings, of which the cheapest result is kept.
//!
//! ```text
//! number_values ─ collect ─┬─ expand ─ factor ─┬─ share_sums ─ share_reciprocals ─ share_products ─ linearise ─ absorb_signs
//!                          └───────────────────┘ for each setting, and once without
//! ```
//! Every pass keeps the value. Expansion is tried from the least to the most, and has to make the kernel cheaper
//! to be kept, because a formula as its author wrote it is usually the accurate one.

use super::expand::{Limits, expand};
use super::factor::{Order, factor};
use super::graph::Graph;
use super::graph::collect::collect;
use super::linearise::linearise;
use super::numbering::number_values;
use super::products::share_products;
use super::program::Program;
use super::quotients::share_reciprocals;
use super::signs::absorb_signs;
use super::sums::share_sums;

/// How far to expand, from the least to the most.
const EXPANSIONS: [Limits; 3] = [
    Limits { product: 4, sum: 12, shared: 2 },
    Limits { product: 8, sum: 24, shared: 2 },
    Limits { product: 8, sum: 24, shared: 24 },
];

impl Program {
    /// The same kernel at least cost.
    pub fn optimise(&self) -> Program {
        let numbered = number_values(self);
        let written = collect(&numbered);
        let mut best = absorb_signs(&numbered);
        let mut consider = |graph: &Graph| {
            let candidate = finished(graph, &numbered);
            if candidate.cost() < best.cost() {
                best = candidate;
            }
        };
        consider(&written);
        for order in [Order::First, Order::Last] {
            consider(&factor(&written, order));
        }
        for limits in EXPANSIONS {
            let expanded = expand(&written, limits);
            for order in [Order::First, Order::Last] {
                consider(&factor(&expanded, order));
            }
        }
        best
    }
}

/// The program of a graph, its common parts shared.
fn finished(graph: &Graph, program: &Program) -> Program {
    let shared = share_products(&share_reciprocals(&share_sums(graph)));
    absorb_signs(&number_values(&linearise(&shared, program)))
}
