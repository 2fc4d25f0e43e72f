//! What a file declares and claims, resolved.

use super::value::Value;
use crate::calculus::{Blade, Coordinate, Form, Metric};
use crate::diagnostic::Span;
use crate::expression::{Condition, Expr, Pool, Rational, Symbol};
use crate::syntax::ast::Claim;
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;

/// A coordinate patch.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Its name.
    pub name: String,
    /// Its coordinates in order, which is its orientation.
    pub coordinates: Vec<Coordinate>,
    /// Its domain, those of its factors included.
    pub conditions: Vec<Condition>,
}

/// A map from one chart to another.
#[derive(Clone, Debug)]
pub struct Map {
    /// Its name.
    pub name: String,
    /// The number of the chart it starts from.
    pub source: usize,
    /// The number of the chart it ends in.
    pub target: usize,
    /// One scalar a target coordinate.
    pub components: Vec<Expr>,
    /// Where the components are defined.
    pub domain: Vec<Condition>,
    /// Those of these conditions under which the value of an integral in it is known.
    pub(crate) narrowing: FxHashSet<Condition>,
    /// The variables the components are written with.
    pub used: Vec<Symbol>,
}

/// A metric with a name.
#[derive(Clone, Debug)]
pub struct NamedMetric {
    /// The number of its chart.
    pub chart: usize,
    /// Its entries, determinant and what else its operations share.
    pub metric: Metric<Expr>,
    /// Where it is defined and not degenerate.
    pub domain: Vec<Condition>,
    /// The variables it is written with.
    pub used: Vec<Symbol>,
}

/// A scalar, form or field with a name.
#[derive(Clone, Debug)]
pub struct Object {
    /// What it is.
    pub value: Value,
    /// Where it is defined.
    pub domain: Vec<Condition>,
    /// Those of these conditions under which the value of an integral in it is known.
    pub(crate) narrowing: FxHashSet<Condition>,
    /// The variables it is written with.
    pub used: Vec<Symbol>,
    /// Its unit in the language's notation, that of a form as a whole; none where nothing states it.
    pub unit: Option<String>,
}

/// An equation that is claimed to hold or not to hold.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Its name.
    pub name: String,
    /// The lines of its documentation.
    pub docs: Vec<String>,
    /// What is claimed.
    pub claim: Claim,
    /// The whole statement in its source.
    pub span: Span,
    /// Its name in its source.
    pub name_span: Span,
    /// One side.
    pub left: Value,
    /// The other.
    pub right: Value,
    /// Why a side has no value, if it may have one that was not found; nothing is decided then.
    pub obstacle: Option<String>,
    /// The points it speaks of satisfy these: the `where`s that bind it.
    pub conditions: Vec<Condition>,
    /// And these: where both sides are defined.
    pub domain: Vec<Condition>,
    /// The maps and named values that it mentions.
    pub(super) mentioned: BTreeSet<String>,
}

/// One range that was integrated over.
#[derive(Clone, Debug)]
pub(crate) struct Integration {
    /// Where the variable of the range stands.
    pub(crate) place: Span,
    /// That variable.
    pub(crate) variable: Symbol,
    /// What was integrated.
    pub(crate) integrand: Expr,
    /// Its antiderivative, if one holds over the whole range.
    pub(crate) antiderivative: Option<Expr>,
    /// What was assumed.
    pub(crate) conditions: Vec<Condition>,
}

/// A numeric function to be generated.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// Its name.
    pub name: String,
    /// The lines of its documentation.
    pub docs: Vec<String>,
    /// Whether it is to be seen from outside its module.
    pub public: bool,
    /// The kernel in its source.
    pub span: Span,
    /// What it is a function of.
    pub arguments: Vec<Symbol>,
    /// What it computes.
    pub outputs: Vec<Expr>,
    /// What it is computed by, an equal form of each output; empty where that is the formula itself.
    pub computed: Vec<Expr>,
    /// Its stated domain; outside, the value is NaN.
    pub domain: Vec<Condition>,
    /// How far its `f64` value may be from the exact one, in units of 2⁻⁵³ of that; none where nothing is promised.
    pub within: Option<Rational>,
    /// The effects that it is specialised to be without.
    pub effects: Vec<Effect>,
    /// The formula as it was written.
    pub formula: Vec<String>,
    /// The units of its arguments and outputs, as far as they are known.
    pub units: KernelUnits,
    /// The names of the claims that speak of what the kernel is computed from.
    pub statements: Vec<String>,
    /// The maps and named values that it mentions.
    pub(super) mentioned: BTreeSet<String>,
}

impl Kernel {
    /// Whether it says itself how it is computed: by a form of its own, or to within a bound.
    pub fn has_form(&self) -> bool {
        !self.computed.is_empty() || self.within.is_some()
    }
}

/// An effect of a kernel, which vanishes where an argument has a value: `absorption: sigma_a = 0`.
#[derive(Clone, Debug)]
pub struct Effect {
    /// Its name.
    pub name: String,
    /// The argument that switches it off …
    pub variable: Symbol,
    /// … where it has this value.
    pub value: Expr,
    /// The effect in its source.
    pub span: Span,
}

/// The units of a kernel's arguments and outputs in the language's notation; none where nothing states them. Both lists
/// are empty in a file that states no unit.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct KernelUnits {
    /// One for each argument.
    pub arguments: Vec<Option<String>>,
    /// One for each output.
    pub outputs: Vec<Option<String>>,
}

/// A map from uniform numbers with the density of its values; its map, statements and kernels stand among the others.
#[derive(Clone, Debug)]
pub struct Warp {
    /// Its name, which is that of the map.
    pub name: String,
    /// How many uniform numbers it takes: the last arguments of its kernel `NAME_sample`.
    pub uniforms: usize,
    /// Whether the map reverses the orientation: its density pulls back to −du ∧ dv.
    pub reverses: bool,
    /// Whether an inverse is given, so that there is a kernel `NAME_inverse`.
    pub has_inverse: bool,
}

/// What a name of the file stands for.
#[derive(Clone, Debug)]
pub enum Named {
    /// A chart, by its number.
    Chart(usize),
    /// A coordinate.
    Coordinate(Coordinate),
    /// The differential of a coordinate.
    Differential(Coordinate),
    /// A parameter.
    Parameter(Symbol),
    /// An unknown function, by its number.
    Function(crate::expression::FunctionId),
    /// A scalar, form or field, by its number.
    Object(usize),
    /// A map, by its number.
    Map(usize),
    /// A metric, by its number.
    Metric(usize),
    /// A kernel, by its number.
    Kernel(usize),
    /// Something whose declaration is being read: it cannot use its own name.
    Pending,
    /// Something whose declaration failed.
    Poisoned,
}

/// A whole file, resolved.
#[derive(Clone, Debug, Default)]
pub struct Theory {
    /// The owner of every expression.
    pub pool: Pool,
    /// The variable of each coordinate.
    pub coordinates: Vec<Symbol>,
    /// The charts in order.
    pub charts: Vec<Chart>,
    /// The maps in order.
    pub maps: Vec<Map>,
    /// The metrics in order.
    pub metrics: Vec<NamedMetric>,
    /// The named scalars, forms and fields in order.
    pub objects: Vec<Object>,
    /// The statements in order.
    pub statements: Vec<Statement>,
    /// The kernels in order.
    pub kernels: Vec<Kernel>,
    /// The warps in order.
    pub warps: Vec<Warp>,
    /// The integrals over one range in the order in which they were found.
    pub(crate) integrations: Vec<Integration>,
    /// Conditions under which integrals have the values that were found, although they may be defined elsewhere.
    pub(crate) narrowing: FxHashSet<Condition>,
    pub(super) names: super::names::Names,
}

impl Theory {
    /// What a name stands for.
    pub fn named(&self, name: &str) -> Option<&Named> {
        self.names.get(name)
    }

    /// `dx^dy`, the differentials in ascending order.
    pub fn blade_text(&self, blade: Blade) -> String {
        let factors: Vec<String> =
            blade.coordinates().map(|coordinate| format!("d{}", self.coordinate_name(coordinate))).collect();
        factors.join("^")
    }

    /// The coordinates that occur in some expressions, in ascending order.
    pub fn coordinates_in(&self, expressions: &[Expr]) -> Vec<Coordinate> {
        let symbols = self.pool.symbols_in(expressions);
        (0..self.coordinates.len())
            .filter(|&number| symbols.binary_search(&self.coordinates[number]).is_ok())
            .map(|number| Coordinate(number as u8))
            .collect()
    }

    /// The coordinates that occur in a form, in its coefficients or as differentials, in ascending order.
    pub fn coordinates_of(&self, form: &Form<Expr>) -> Vec<Coordinate> {
        let coefficients: Vec<Expr> = form.terms().iter().map(|term| term.1).collect();
        let mut occurring = self.coordinates_in(&coefficients);
        occurring.extend(form.terms().iter().flat_map(|term| term.0.coordinates()));
        occurring.sort_unstable();
        occurring.dedup();
        occurring
    }

    /// The numbers of the charts that have all of some coordinates.
    pub fn charts_with(&self, coordinates: &[Coordinate]) -> Vec<usize> {
        let has_all = |chart: &Chart| coordinates.iter().all(|c| chart.coordinates.contains(c));
        (0..self.charts.len()).filter(|&number| has_all(&self.charts[number])).collect()
    }

    /// The name of a coordinate.
    pub fn coordinate_name(&self, coordinate: Coordinate) -> &str {
        self.pool.symbol_name(self.coordinates[coordinate.0 as usize])
    }
}
