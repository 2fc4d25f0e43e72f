//! Tables of the integrals that a pool represents as functions.

use super::node::{Expr, FunctionId, Symbol};
use rustc_hash::FxHashMap;

/// Argument of a jet in an integrand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) enum Place {
    /// The integration variable with this number, and the order of differentiation of the jet in
    /// this argument.
    Integrated(usize, u32),
    /// The next parameter.
    Parameter,
}

/// Jet of an integrand.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Factor {
    pub(super) function: FunctionId,
    pub(super) places: Vec<Place>,
}

/// Integrand of a primitive, with the number of its integration variables and of its parameters.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Primitive {
    pub(super) factors: Vec<Factor>,
    /// Factor outside the jets, in the formal variables; its parameters follow those of the jets.
    pub(super) elementary: Expr,
    pub(super) integrated: usize,
    pub(super) parameters: usize,
}

/// The primitives of a pool and the variables they are written in.
#[derive(Clone, Debug, Default)]
pub(super) struct Primitives {
    pub(super) functions: FxHashMap<Primitive, FunctionId>,
    pub(super) integrands: FxHashMap<FunctionId, Primitive>,
    pub(super) integrated: Vec<Symbol>,
    pub(super) parameters: Vec<Symbol>,
    /// Integration variables of an integrand under construction.
    pub(super) inner: Vec<Symbol>,
    pub(super) ends: Vec<Symbol>,
}

impl Primitive {
    /// Returns the number of the first parameter that belongs to no jet.
    pub(super) fn first_beside_jets(&self) -> usize {
        let places = self.factors.iter().flat_map(|factor| &factor.places);
        self.integrated + places.filter(|place| **place == Place::Parameter).count()
    }
}

/// Integrand of a quadrature, its integration variable and its other variables.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Quadrature {
    pub(crate) integrand: Expr,
    pub(crate) variable: Symbol,
    pub(crate) parameters: Vec<Symbol>,
}

/// The quadratures of a pool.
#[derive(Clone, Debug, Default)]
pub(super) struct Quadratures {
    pub(super) functions: FxHashMap<Quadrature, FunctionId>,
    pub(super) integrands: FxHashMap<FunctionId, Quadrature>,
}
