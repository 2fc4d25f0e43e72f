//! The syntax tree: what was written, with the place of every part.

use crate::diagnostic::Span;
use num_rational::BigRational;

/// A whole `.forms` file or macro body.
#[derive(Clone, Debug, Default)]
pub struct File {
    /// Its statements in order; those that could not be parsed are left out and reported.
    pub items: Vec<Item>,
}

/// One statement, up to its `;`.
#[derive(Clone, Debug)]
pub struct Item {
    /// The lines of its `///` comment.
    pub docs: Vec<String>,
    /// Whether `pub` stands before it (kernels only).
    pub public: bool,
    /// From its first word to its `;`.
    pub span: Span,
    /// What it declares or claims.
    pub kind: ItemKind,
}

/// A name where it stands.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Name {
    /// Its characters.
    pub text: String,
    /// Its place.
    pub span: Span,
}

/// A declared variable with the unit it may carry: `x`, `x: m`.
#[derive(Clone, Debug)]
pub struct Declared {
    /// The name.
    pub name: Name,
    /// The unit, as written.
    pub unit: Option<Expr>,
}

/// What an item declares or claims.
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
        /// The units of the outputs, or none.
        units: Vec<Expr>,
        /// One expression, or several for `(a, b, …)`.
        outputs: Vec<Expr>,
        /// What stands behind `by`: an equal form to compute by, or nothing.
        computed: Vec<Expr>,
        conditions: Vec<Condition>,
        /// What stands behind `within`.
        within: Option<Expr>,
        effects: Vec<Effect>,
    },
    /// `kernel g = grad(f; u, v);`
    Gradient { name: Name, of: Name, by: Vec<Name> },
    /// `warp name(p; u, v) = (x, y, z) onto C density E of w inverse (…) where …;`
    Warp(Box<Warp>),
}

/// A map from the unit square, or from the unit interval, with the density of the points it takes uniform ones to.
#[derive(Clone, Debug)]
pub struct Warp {
    /// Its name, which is that of the map too.
    pub name: Name,
    /// What the map depends on beside the uniform numbers.
    pub parameters: Vec<Declared>,
    /// The uniform numbers, each between 0 and 1.
    pub uniforms: Vec<Declared>,
    /// One scalar for each coordinate of the target.
    pub components: Vec<Expr>,
    /// The chart it goes to.
    pub target: Name,
    /// The density, as a function of the target's coordinates …
    pub density: Expr,
    /// … with respect to this form.
    pub form: Expr,
    /// The uniform numbers as functions of the target's coordinates, or nothing.
    pub inverse: Vec<Expr>,
    /// The forms that the components are computed by, or nothing.
    pub computed: Vec<Expr>,
    /// Where it is defined.
    pub conditions: Vec<Condition>,
    /// What stands behind `within`, of all its kernels.
    pub within: Option<Expr>,
}

/// What a statement claims of its equation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Claim {
    /// It holds.
    Prove,
    /// It does not.
    Refute,
}

/// What stands behind a statement's name: `left == right where …`.
#[derive(Clone, Debug)]
pub struct Equation {
    /// The left side.
    pub left: Expr,
    /// The right side.
    pub right: Expr,
    /// The statement's own conditions.
    pub conditions: Vec<Condition>,
}

/// `absorption: sigma_a = 0` of a kernel's `effects { … }`.
#[derive(Clone, Debug)]
pub struct Effect {
    /// The effect's name.
    pub name: Name,
    /// The variable that switches it off …
    pub variable: Name,
    /// … when it has this value.
    pub value: Expr,
}

/// One condition of a `where`, perhaps a chain: `0 < theta < pi`.
#[derive(Clone, Debug)]
pub struct Condition {
    /// The leftmost side.
    pub first: Expr,
    /// Each relation with the side to its right; at least one.
    pub rest: Vec<(Relation, Expr)>,
    /// The whole chain.
    pub span: Span,
}

/// A relation between two scalars.
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

/// An expression where it stands.
#[derive(Clone, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: Box<ExprKind>,
    /// From its first character to its last, brackets included.
    pub span: Span,
}

/// An operator between two expressions.
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

/// What an expression is.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "each variant shows how its fields are written")]
pub enum ExprKind {
    /// An exact number.
    Number(BigRational),
    /// A name: scalar, form, differential `dx`, chart, …
    Name(String),
    /// `@x`, the coordinate vector field.
    Basis(Name),
    /// `-a`
    Negate(Expr),
    /// `a + b` and its like, with the operator's own place.
    Binary(Binary, Span, Expr, Expr),
    /// `f(a, b)`, `d[R3](w)`, `integral(w, u = 0..1)`.
    Call { function: Name, index: Option<Expr>, arguments: Vec<Argument> },
    /// `w[dx^dy]`, `X[x]`, `volume[g]`.
    Index { base: Expr, index: Expr },
    /// `if u > 0 { u } else { 0 }`; `jump` allows the two to differ at the seam.
    Select { condition: Condition, then: Expr, otherwise: Expr, jump: bool },
}

/// One argument of a call.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "each variant shows how its fields are written")]
pub enum Argument {
    /// A plain expression.
    Value(Expr),
    /// `u = 0..1`
    Range { variable: Name, from: Expr, to: Expr },
}
