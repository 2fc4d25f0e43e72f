//! Syntax tree: the source as written, with the place of every part.

use crate::diagnostic::Span;
use crate::expression::Relation;
use num_rational::BigRational;

/// Whole `.forms` file or macro body.
#[derive(Clone, Debug, Default)]
pub struct File {
    /// Its items in order; items that could not be parsed are omitted and reported.
    pub items: Vec<Item>,
}

/// One item, up to its `;`.
#[derive(Clone, Debug)]
pub struct Item {
    /// Lines of its `///` comment.
    pub docs: Vec<String>,
    /// Whether it is marked `pub` (kernels and warps only).
    pub public: bool,
    /// Place from its first word to its `;`.
    pub span: Span,
    /// Its declaration or claim.
    pub kind: ItemKind,
}

/// Name with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// Its characters.
    pub text: String,
    /// Its place.
    pub span: Span,
}

/// Declared variable with an optional unit: `x`, `x: m`, and in a kernel `p[3]: m`.
#[derive(Clone, Debug)]
pub struct Declared {
    /// Its name.
    pub name: Name,
    /// Extents of an array, or empty for a number.
    pub extents: Vec<usize>,
    /// Its unit, as written.
    pub unit: Option<Expr>,
}

/// Declaration or claim of an item.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "each variant shows how its fields are written")]
pub enum ItemKind {
    /// `chart R3(x, y, z) where …;`
    Chart { name: Name, coordinates: Vec<Declared>, conditions: Vec<Condition> },
    /// `chart Ray = R3 * S2 where …;`
    ProductChart { name: Name, factors: Vec<Name>, conditions: Vec<Condition> },
    /// `param n, sigma: 1/m where …;`
    Param { names: Vec<Declared>, conditions: Vec<Condition> },
    /// `fn L(x, y): W/m**2 where …;`
    Function { name: Name, arguments: Vec<Name>, unit: Option<Expr>, conditions: Vec<Condition> },
    /// `let r: m = …;`
    Let { name: Name, unit: Option<Expr>, value: Expr },
    /// `let ease(t) = …;`
    Definition { name: Name, arguments: Vec<Name>, value: Expr },
    /// `form beta: 2, sr on R3 = …;`
    Form { name: Name, degree: Option<(u32, Span)>, unit: Option<Expr>, chart: Option<Name>, value: Expr },
    /// `field X on R3 = …;`
    Field { name: Name, chart: Option<Name>, value: Expr },
    /// `map patch: UV -> R3 = (…);`
    Map { name: Name, source: Name, target: Name, components: Vec<Expr> },
    /// `metric g on R3 = …;`
    Metric { name: Name, chart: Option<Name>, value: Expr },
    /// `prove name: … == … where …;` or `refute …`
    Statement { claim: Claim, name: Name, left: Expr, right: Expr, conditions: Vec<Condition> },
    /// `kernel f(u: m, v: s): m/s = … where … effects { … };`
    Kernel {
        name: Name,
        arguments: Vec<Declared>,
        /// Units of the outputs, or empty.
        units: Vec<Expr>,
        /// One expression, or several for `(a, b, …)`.
        outputs: Vec<Expr>,
        /// Form given by `by`, equal to the formula and computed instead of it; empty if there is
        /// none.
        computed: Vec<Expr>,
        /// Tolerance given by `approx` for this form.
        approximation: Option<Expr>,
        /// Forms given by `for f32 { by … }`.
        target_forms: Vec<TargetForm>,
        conditions: Vec<Condition>,
        /// Bound given by `within`.
        within: Option<Expr>,
        effects: Vec<Effect>,
    },
    /// `kernel g = grad(f; u, v);`, `kernel j = jacobian(f; u, v);` …
    Derivatives { name: Name, which: Derivatives, of: Name, by: Vec<Name> },
    /// `warp name(p; u, v) = (x, y, z) onto C density E of w inverse (…) where …;`
    Warp(Box<Warp>),
}

/// Form of a kernel for one precision or target language: `for f32 { by … approx … }`.
#[derive(Clone, Debug)]
pub struct TargetForm {
    /// The precision or target language.
    pub target: Name,
    /// The form.
    pub computed: Vec<Expr>,
    /// Tolerance given by `approx`.
    pub approximation: Option<Expr>,
}

/// Kernel made of the derivatives of another kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Derivatives {
    /// `grad`: one list of all derivatives.
    Gradient,
    /// `jacobian`: a row of derivatives for each number of the result.
    Jacobian,
    /// `value_and_jacobian`: the result, then its Jacobian matrix.
    ValueAndJacobian,
}

impl Derivatives {
    /// All of them.
    pub const ALL: [Derivatives; 3] =
        [Derivatives::Gradient, Derivatives::Jacobian, Derivatives::ValueAndJacobian];

    /// Returns the word after `=`.
    pub fn word(self) -> &'static str {
        match self {
            Derivatives::Gradient => "grad",
            Derivatives::Jacobian => "jacobian",
            Derivatives::ValueAndJacobian => "value_and_jacobian",
        }
    }
}

/// Map from the unit square, or from the unit interval, with the density of the images of uniformly
/// distributed points.
#[derive(Clone, Debug)]
pub struct Warp {
    /// Its name, which is also the name of the map.
    pub name: Name,
    /// Parameters of the map, in addition to the uniform random numbers.
    pub parameters: Vec<Declared>,
    /// Uniform random numbers, each between 0 and 1.
    pub uniforms: Vec<Declared>,
    /// One scalar for each coordinate of the target.
    pub components: Vec<Expr>,
    /// Its target chart.
    pub target: Name,
    /// Its density, as a function of the target's coordinates …
    pub density: Expr,
    /// … with respect to this form.
    pub form: Expr,
    /// Uniform random numbers as functions of the target's coordinates, or empty.
    pub inverse: Vec<Expr>,
    /// Forms by which the components are computed, or empty.
    pub computed: Vec<Expr>,
    /// Conditions under which it is defined.
    pub conditions: Vec<Condition>,
    /// Bound given by `within`, which applies to all its kernels.
    pub within: Option<Expr>,
}

/// Claim of a statement about its equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Claim {
    /// The equation holds.
    Prove,
    /// The equation does not hold.
    Refute,
}

/// Equation that follows a statement's name: `left == right where …`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// Left side.
    pub left: Expr,
    /// Right side.
    pub right: Expr,
    /// Conditions of the statement itself.
    pub conditions: Vec<Condition>,
}

/// Effect in a kernel's `effects { … }`, such as `absorption: sigma_a = 0`.
#[derive(Clone, Debug)]
pub struct Effect {
    /// Its name.
    pub name: Name,
    /// Variable that switches it off …
    pub variable: Name,
    /// … when it has this value.
    pub value: Expr,
}

/// Condition of a `where`, which can be a chain: `0 < theta < pi`.
#[derive(Clone, Debug)]
pub struct Condition {
    /// Leftmost side.
    pub first: Expr,
    /// Each relation with the side to its right; at least one.
    pub rest: Vec<(Relation, Expr)>,
    /// Place of the whole chain.
    pub span: Span,
}

/// Expression with its place.
#[derive(Clone, Debug)]
pub struct Expr {
    /// Its kind.
    pub kind: Box<ExprKind>,
    /// Place from its first character to its last, brackets included.
    pub span: Span,
}

impl Expr {
    /// Returns its direct parts, in the order in which they are evaluated.
    pub fn parts(&self) -> Vec<&Expr> {
        match &*self.kind {
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Basis(_) => vec![],
            ExprKind::Negate(inner) => vec![inner],
            ExprKind::Binary(_, _, left, right) => vec![left, right],
            ExprKind::Call { index, arguments, .. } => {
                let arguments = arguments.iter().flat_map(|argument| match argument {
                    Argument::Value(value) => vec![value],
                    Argument::Range { from, to, .. } => vec![from, to],
                });
                index.iter().chain(arguments).collect()
            }
            ExprKind::Index { base, indices } => std::iter::once(base).chain(indices).collect(),
            ExprKind::Array(entries) => entries.iter().collect(),
            ExprKind::Select { condition, then, otherwise, .. } => {
                condition.sides().chain([then, otherwise]).collect()
            }
        }
    }
}

impl Condition {
    /// Returns its sides, from left to right.
    pub fn sides(&self) -> impl Iterator<Item = &Expr> {
        std::iter::once(&self.first).chain(self.rest.iter().map(|(_, side)| side))
    }
}

/// Binary operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Binary {
    /// `+`
    Add,
    /// `-`
    Subtract,
    /// `*`
    Multiply,
    /// `/`
    Divide,
    /// `^`, the wedge product
    Wedge,
    /// `**`
    Power,
}

/// Kind of an expression, with its operands.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "each variant shows how its fields are written")]
pub enum ExprKind {
    /// Exact number.
    Number(BigRational),
    /// Name of a scalar, form, differential `dx`, chart, …
    Name(String),
    /// Coordinate vector field `@x`.
    Basis(Name),
    /// `-a`
    Negate(Expr),
    /// `a + b` and the other binary operations, with the place of the operator.
    Binary(Binary, Span, Expr, Expr),
    /// `f(a, b)`, `d[R3](w)`, `integral(w, u = 0..1)`.
    Call { function: Name, index: Option<Expr>, arguments: Vec<Argument> },
    /// `w[dx^dy]`, `X[x]`, `volume[g]`, `p[0]`, `R[1, 2]`.
    Index { base: Expr, indices: Vec<Expr> },
    /// `[a, b, c]`, and nested by rows `[[a, b], [c, d]]`.
    Array(Vec<Expr>),
    /// `if u > 0 { u } else { 0 }`; `jump` allows the two branches to differ at the seam.
    Select { condition: Condition, then: Expr, otherwise: Expr, jump: bool },
}

/// One argument of a call.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "each variant shows how its fields are written")]
pub enum Argument {
    /// Plain expression.
    Value(Expr),
    /// `u = 0..1`
    Range { variable: Name, from: Expr, to: Expr },
}
