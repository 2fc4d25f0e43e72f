//! Theories: the resolved declarations and claims of a file.
//!
//! [`resolve`](crate::resolve) makes a theory from a syntax tree. Everything downstream reads it: the
//! prover, certificates, notation and the generation of kernels. All expressions of a theory belong
//! to its pool.

mod named;
pub(crate) mod names;
mod other_languages;
mod target_form;
mod value;

pub use named::Named;
pub(crate) use named::describe;
pub(crate) use target_form::{FormTarget, TargetForm};
pub use value::{Array, Value};

pub use crate::calculus::{Blade, Coordinate, Field, Form, Metric};
use crate::diagnostic::Span;
use crate::expression::{Condition, Expr, Pool, Rational, Signature, Symbol};
use crate::syntax::ast::{self, Claim};
use rustc_hash::FxHashSet;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Coordinate chart.
#[derive(Clone, Debug)]
pub struct Chart {
    /// Its name.
    pub name: String,
    /// Its coordinates in order; the order is its orientation.
    pub coordinates: Vec<Coordinate>,
    /// Its domain, including the domains of its factors.
    pub conditions: Vec<Condition>,
}

/// Map from one chart to another.
#[derive(Clone, Debug)]
pub struct Map {
    /// Its name.
    pub name: String,
    /// Index of the source chart.
    pub source: usize,
    /// Index of the target chart.
    pub target: usize,
    /// One scalar for each target coordinate.
    pub components: Vec<Expr>,
    /// Conditions under which the components are defined.
    pub domain: Vec<Condition>,
    /// Subset of these conditions under which the computed value of an integral in the map is
    /// valid.
    pub(crate) narrowing: FxHashSet<Condition>,
    /// Variables used by the components.
    pub used: Vec<Symbol>,
}

/// Named metric.
#[derive(Clone, Debug)]
pub struct NamedMetric {
    /// Index of its chart.
    pub chart: usize,
    /// Its entries, its determinant and the other quantities that its operations share.
    pub metric: Metric<Expr>,
    /// Conditions under which it is defined and not degenerate.
    pub domain: Vec<Condition>,
    /// Variables it uses.
    pub used: Vec<Symbol>,
}

/// Named scalar, form or field.
#[derive(Clone, Debug)]
pub struct Object {
    /// Its value.
    pub value: Value,
    /// Conditions under which it is defined.
    pub domain: Vec<Condition>,
    /// Subset of these conditions under which the computed value of an integral in the object is
    /// valid.
    pub(crate) narrowing: FxHashSet<Condition>,
    /// Variables it uses.
    pub used: Vec<Symbol>,
    /// Its unit in the language's notation; for a form, the unit of the whole form. `None` where no
    /// unit is stated.
    pub unit: Option<String>,
}

/// Equation that is claimed to hold or not to hold.
#[derive(Clone, Debug)]
pub struct Statement {
    /// Its name.
    pub name: String,
    /// Lines of its documentation.
    pub docs: Vec<String>,
    /// Its claim: to be proved or to be refuted.
    pub claim: Claim,
    /// Span of the whole statement in its source.
    pub span: Span,
    /// Span of its name in its source.
    pub name_span: Span,
    /// Left side.
    pub left: Value,
    /// Right side.
    pub right: Value,
    /// Reason why no value of a side was found although one can exist; the statement is then
    /// undecided.
    pub obstacle: Option<String>,
    /// Conditions on its points: every `where` that applies to it.
    pub conditions: Vec<Condition>,
    /// Further conditions on its points, under which both sides are defined.
    pub domain: Vec<Condition>,
    /// Maps and named values that it mentions.
    pub(crate) mentioned: BTreeSet<String>,
}

/// Integration over one range.
#[derive(Clone, Debug)]
pub(crate) struct Integration {
    /// Place of the range's variable in the source.
    pub(crate) place: Span,
    /// Variable of the range.
    pub(crate) variable: Symbol,
    /// Integrand.
    pub(crate) integrand: Expr,
    /// Antiderivative of the integrand, if one is valid over the whole range.
    pub(crate) antiderivative: Option<Expr>,
    /// Assumptions of the integration.
    pub(crate) conditions: Vec<Condition>,
}

/// Numeric function to be generated.
#[derive(Clone, Debug)]
pub struct Kernel {
    /// Its name.
    pub name: String,
    /// Lines of its documentation.
    pub docs: Vec<String>,
    /// Whether it is visible outside its module.
    pub public: bool,
    /// Span of the kernel in its source.
    pub span: Span,
    /// Arguments and results as declared; the lists below hold the entries of arrays by rows.
    pub signature: Signature,
    /// Its arguments.
    pub arguments: Vec<Symbol>,
    /// Its formulas, one for each output.
    pub outputs: Vec<Expr>,
    /// Form of each output that is computed instead of the formula; empty where the formula
    /// itself is computed.
    pub computed: Vec<Expr>,
    /// Largest relative error of this form where it is only close to the formula; `None` where it is
    /// equal.
    pub approximation: Option<Rational>,
    /// Forms for one precision or target language.
    pub target_forms: Vec<TargetForm>,
    /// Its stated domain; outside it the value is NaN.
    pub domain: Vec<Condition>,
    /// Promised bound of the error of its `f64` value, in units of 2⁻⁵³ of the exact value; `None`
    /// where nothing is promised.
    pub within: Option<Rational>,
    /// Effects that can be switched off; the kernel is specialised for their absence.
    pub effects: Vec<Effect>,
    /// Formula as written in the source.
    pub formula: Vec<String>,
    /// Known units of its arguments and outputs.
    pub units: KernelUnits,
    /// Names of the statements about the maps and values that the kernel uses.
    pub statements: Vec<String>,
    /// Maps and named values that it mentions.
    pub(crate) mentioned: BTreeSet<String>,
    /// Conditions under which its formulas are defined as written.
    pub(crate) defined: Vec<Condition>,
}

impl Kernel {
    /// Whether its declaration fixes how it is computed: by an explicit form (`by`) or by an error
    /// bound (`within`).
    pub fn has_form(&self) -> bool {
        !self.computed.is_empty() || self.within.is_some()
    }
}

/// Effect of a kernel that vanishes where an argument has a given value: `absorption: sigma_a = 0`.
#[derive(Clone, Debug)]
pub struct Effect {
    /// Its name.
    pub name: String,
    /// Argument that switches it off …
    pub variable: Symbol,
    /// … where it has this value.
    pub value: Expr,
    /// Span of the effect in its source.
    pub span: Span,
}

/// Units of a kernel's arguments and outputs in the language's notation; `None` where no unit is
/// stated. Both lists are empty in a file that states no units.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct KernelUnits {
    /// One for each argument.
    pub arguments: Vec<Option<String>>,
    /// One for each output.
    pub outputs: Vec<Option<String>>,
}

/// Definition with arguments, such as `let ease(t) = t*t*(3 - 2*t);`: an expression to be evaluated
/// with a value in the place of each argument.
#[derive(Clone, Debug)]
pub struct Definition {
    /// Its name.
    pub name: ast::Name,
    /// Names of its arguments.
    pub arguments: Vec<String>,
    /// The expression.
    pub value: ast::Expr,
    /// Levels of nesting in the expression, with those of the definitions that it calls.
    pub(crate) nesting: usize,
}

/// Map from uniform random numbers, with the density of its values; its map, statements and kernels
/// are stored among the others.
#[derive(Clone, Debug)]
pub struct Warp {
    /// Its name, which is also the name of the map.
    pub name: String,
    /// Number of uniform random numbers it takes: the last arguments of its kernel `NAME_sample`.
    pub uniforms: usize,
    /// Whether the map reverses the orientation, that is, whether its density pulls back to −du ∧
    /// dv.
    pub reverses: bool,
    /// Whether an inverse is given; then there is a kernel `NAME_inverse`.
    pub has_inverse: bool,
}

/// Resolved file.
#[derive(Clone, Debug, Default)]
pub struct Theory {
    /// Owner of every expression.
    pub pool: Pool,
    /// Variable of each coordinate.
    pub coordinates: Vec<Symbol>,
    /// The charts in order.
    pub charts: Vec<Chart>,
    /// The maps in order.
    pub maps: Vec<Map>,
    /// The metrics in order.
    pub metrics: Vec<NamedMetric>,
    /// The named scalars, forms and fields in order.
    pub objects: Vec<Object>,
    /// The definitions with arguments in order.
    pub definitions: Vec<Arc<Definition>>,
    /// The statements in order.
    pub statements: Vec<Statement>,
    /// The kernels in order.
    pub kernels: Vec<Kernel>,
    /// Arrays among the arguments of kernels, in order.
    pub(crate) arrays: Vec<Array>,
    /// The warps in order.
    pub warps: Vec<Warp>,
    /// Integrations over one range, in the order in which they were performed.
    pub(crate) integrations: Vec<Integration>,
    /// Conditions under which the computed values of integrals are valid, although the integrals
    /// can be defined elsewhere.
    pub(crate) narrowing: FxHashSet<Condition>,
    pub(crate) names: names::Names,
}

impl Theory {
    /// Returns the meaning of a name.
    pub fn named(&self, name: &str) -> Option<&Named> {
        self.names.get(name)
    }

    /// Formats a basis form, as in `dx^dy`, with the differentials in ascending order.
    pub fn blade_text(&self, blade: Blade) -> String {
        let factors: Vec<String> =
            blade.coordinates().map(|coordinate| format!("d{}", self.coordinate_name(coordinate))).collect();
        factors.join("^")
    }

    /// Returns the coordinates that occur in some expressions, in ascending order.
    pub fn coordinates_in(&self, expressions: &[Expr]) -> Vec<Coordinate> {
        let symbols = self.pool.symbols_in(expressions);
        (0..self.coordinates.len())
            .filter(|&number| symbols.binary_search(&self.coordinates[number]).is_ok())
            .map(|number| Coordinate(number as u8))
            .collect()
    }

    /// Returns the coordinates that occur in a form, in its coefficients or as differentials, in
    /// ascending order.
    pub fn coordinates_of(&self, form: &Form<Expr>) -> Vec<Coordinate> {
        let coefficients: Vec<Expr> = form.terms().iter().map(|term| term.1).collect();
        let mut occurring = self.coordinates_in(&coefficients);
        occurring.extend(form.terms().iter().flat_map(|term| term.0.coordinates()));
        occurring.sort_unstable();
        occurring.dedup();
        occurring
    }

    /// Returns the indices of the charts that contain all of some coordinates.
    pub fn charts_with(&self, coordinates: &[Coordinate]) -> Vec<usize> {
        let has_all = |chart: &Chart| coordinates.iter().all(|c| chart.coordinates.contains(c));
        (0..self.charts.len()).filter(|&number| has_all(&self.charts[number])).collect()
    }

    /// Returns the name of a coordinate.
    pub fn coordinate_name(&self, coordinate: Coordinate) -> &str {
        self.pool.symbol_name(self.coordinates[coordinate.0 as usize])
    }
}
