//! Declarations of a file: charts, params, unknown functions, maps and named values, and the places
//! of its statements.

mod declaration;
mod metric;

use crate::calculus::{Kind, Value, coordinates};
use crate::expression::{Expr, Pool, rational};
use crate::line::Offered;
use crate::tokens::{Reader, Token};
use crate::{Claim, Stop, malformed, rejected, uncovered};
use metric::Metric;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Maximum number of coordinates and params of a file: each coordinate is a bit of a blade.
const MOST_VARIABLES: usize = 128;

/// Required sign of a condition's expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Relation {
    Positive,
    NotNegative,
    NotZero,
}

/// Condition on the points of a statement.
pub(crate) type Condition = (Expr, Relation);

/// Conditions under which a value is defined, and the variables it uses.
#[derive(Clone, Debug, Default)]
pub(crate) struct Scope {
    pub(crate) conditions: Vec<Condition>,
    pub(crate) used: BTreeSet<usize>,
    /// Whether an integral was found under these conditions.
    pub(crate) integrates: bool,
    /// Whether zeros of parameters are excluded for an antiderivative.
    pub(crate) is_narrowed: bool,
}

/// Chart: its coordinates and its domain.
type Chart = (Vec<usize>, Vec<Condition>);

/// Meaning of a name.
#[derive(Clone, Debug)]
pub(crate) enum Named {
    Chart(Chart),
    Variable(usize),
    Differential(usize),
    Function(usize),
    Object(Value, Scope),
    Metric(Metric, Scope),
    /// Map: the source's coordinates, the image of each target coordinate, the target's conditions.
    Map(Vec<usize>, HashMap<usize, Expr>, Vec<Condition>, Scope),
    /// Declaration that uses something outside the checker's coverage.
    Uncovered(String),
}

/// Both sides of a statement by component, and the conditions on its points. These are the points
/// at which every condition holds and every node of the sides and conditions is real.
#[derive(Clone, Debug)]
pub(crate) struct Statement {
    pub(crate) components: BTreeMap<String, [Expr; 2]>,
    pub(crate) conditions: Vec<Condition>,
    /// All nodes of the sides and conditions.
    pub(crate) nodes: BTreeSet<Expr>,
}

impl Statement {
    pub(crate) fn new(
        pool: &Pool,
        components: BTreeMap<String, [Expr; 2]>,
        conditions: Vec<Condition>,
    ) -> Self {
        let mut roots: Vec<Expr> = components.values().flatten().copied().collect();
        roots.extend(conditions.iter().map(|condition| condition.0));
        let nodes = pool.parts(&roots);
        Statement { components, conditions, nodes }
    }
}

/// Words of the language that no declaration can take.
const WORDS: [&str; 26] = [
    "pi",
    "sqrt",
    "d",
    "interior",
    "lie",
    "bracket",
    "pair",
    "pullback",
    "diff",
    "hodge",
    "codiff",
    "laplace",
    "flat",
    "sharp",
    "inner",
    "norm",
    "volume",
    "grad",
    "curl",
    "div",
    "potential",
    "integral",
    "boundary_integral",
    "where",
    "on",
    "pub",
];

/// Functions of the language with the argument a: name, derivative, and the condition under which
/// the function is real.
pub(crate) const FUNCTIONS: [(&str, &str, &str); 8] = [
    ("sin", "cos(a)", ""),
    ("cos", "-sin(a)", ""),
    ("tan", "1 + tan(a)**2", "cos(a) != 0"),
    ("asin", "1/sqrt(1 - a**2)", "1 - a**2 >= 0"),
    ("atan", "1/(1 + a**2)", ""),
    ("exp", "exp(a)", ""),
    ("log", "1/a", "a > 0"),
    ("abs", "abs(a)/a", ""),
];

/// Functions defined by those, with the arguments a and b: name, number of arguments, definition,
/// and the condition under which the function is real.
pub(crate) const DERIVED: [(&str, usize, &str, &str); 5] = [
    ("acos", 1, "pi/2 - asin(a)", "1 - a**2 >= 0"),
    ("atan2", 2, "2*atan(a/(sqrt(a**2 + b**2) + b))", "sqrt(a**2 + b**2) + b > 0"),
    ("sinh", 1, "(exp(a) - exp(-a))/2", ""),
    ("cosh", 1, "(exp(a) + exp(-a))/2", ""),
    ("tanh", 1, "(exp(a) - exp(-a))/(exp(a) + exp(-a))", ""),
];

/// Derived functions whose names a file can give another meaning, in the same columns.
pub(crate) const COMMON: [(&str, usize, &str, &str); 7] = [
    ("min", 2, "(a + b - abs(a - b))/2", ""),
    ("max", 2, "(a + b + abs(a - b))/2", ""),
    ("copysign", 2, "abs(a)*b/abs(b)", "b != 0"),
    ("hypot", 2, "sqrt(a**2 + b**2)", ""),
    ("sec", 1, "1/cos(a)", "cos(a) != 0"),
    ("csc", 1, "1/sin(a)", "sin(a) != 0"),
    ("cot", 1, "cos(a)/sin(a)", "sin(a) != 0"),
];

/// Returns the derived functions, with the arguments a and b.
pub(crate) fn derived() -> impl Iterator<Item = (&'static str, usize, &'static str, &'static str)> {
    DERIVED.into_iter().chain(COMMON)
}

/// File that was read.
#[derive(Clone, Debug, Default)]
pub(crate) struct Theory {
    pub(crate) pool: Pool,
    pub(crate) names: HashMap<String, Named>,
    /// Names of variables, and whether each is a coordinate.
    pub(crate) variables: Vec<(String, bool)>,
    /// Arguments of unknown functions, and the conditions on their values.
    pub(crate) functions: Vec<(Vec<usize>, Vec<Condition>)>,
    pub(crate) params: HashMap<usize, Vec<Condition>>,
    /// Conditions under which each function of the language is real.
    pub(crate) domains: HashMap<&'static str, Vec<Condition>>,
    pub(crate) charts: Vec<Chart>,
    /// Claim of each statement, and the place of its sides; `None` for statements that follow from
    /// warps.
    statements: HashMap<String, (Claim, Option<Reader>)>,
    /// Reason why no statement of the file can be decided.
    fault: Option<String>,
    /// Item that is not understood and could affect any statement.
    obstacle: Option<String>,
    pub(crate) scope: Scope,
    /// Whether `*` between 1-forms is the symmetric product.
    pub(crate) in_metric: bool,
    /// Antiderivatives that the certificate offers, and the number used for each place since the
    /// item began.
    pub(crate) offered: Offered,
    pub(crate) integrated: HashMap<usize, usize>,
    /// Conditions that the current statement places on its points.
    pub(crate) given: Vec<Condition>,
    /// Variables of the integrals around the expression being read.
    pub(crate) bound: Vec<usize>,
    /// Whether the text being read comes from the certificate, where integrals are not allowed.
    pub(crate) is_sealed: bool,
}

impl Theory {
    pub(crate) fn read(text: &str, offered: Offered) -> Result<Self, Stop> {
        let mut theory = Theory { offered, ..Theory::default() };
        for name in ["a", "b"] {
            theory.new_variable(name, false)?;
        }
        for (name, text, domain) in FUNCTIONS.into_iter().chain(derived().map(|row| (row.0, row.2, row.3))) {
            let expr = theory.scalar(&mut Reader::new(text)?)?;
            theory.pool.templates.insert(name, expr);
            if !domain.is_empty() {
                let conditions = theory.relations(&mut Reader::new(domain)?)?;
                theory.domains.insert(name, conditions);
            }
        }
        theory.names.clear();
        let mut reader = Reader::new(text)?;
        while reader.peek().is_some() {
            theory.scope = Scope::default();
            theory.integrated.clear();
            theory.bound.clear();
            let start = reader.place;
            if let Err(stop) = theory.item(&mut reader) {
                theory.obstacle.get_or_insert(stop.into_text());
                reader.place = start;
                reader.pass_item();
            }
        }
        match theory.fault.take() {
            Some(fault) => Err(malformed(fault)),
            None => Ok(theory),
        }
    }

    /// Derives both sides of a statement.
    pub(crate) fn statement(&mut self, name: &str) -> Result<Statement, Stop> {
        let mut reader = match self.statements.get(name).cloned() {
            None => return rejected("the file has no such statement"),
            Some((_, None)) => return uncovered("statements derived from a warp"),
            Some((_, Some(reader))) => reader,
        };
        if let Some(obstacle) = &self.obstacle {
            return uncovered(format!("an item of the file is not understood: {obstacle}"));
        }
        self.given.clear();
        self.given = self.stated(reader.clone())?;
        self.scope = Scope::default();
        self.integrated.clear();
        self.bound.clear();
        let left = self.sum(&mut reader)?;
        reader.expect("==")?;
        let sides = [left, self.sum(&mut reader)?];
        if !sides[0].is_alike(&sides[1]) {
            return Err(malformed("the sides are of different types"));
        }
        let mut conditions = self.bounds(&mut reader)?;
        reader.expect(";")?;
        conditions.append(&mut self.scope.conditions);
        let is_narrowed = self.scope.is_narrowed;
        // a chart's condition applies if the chart is used and all coordinates of the condition are
        // used
        let used = &self.scope.used;
        for (_, bound) in self.charts.iter().filter(|chart| chart.0.iter().any(|v| used.contains(v))) {
            let is_used = |v: &usize| !self.variables[*v].1 || used.contains(v);
            conditions.extend(bound.iter().filter(|c| self.pool.variables(c.0).iter().all(is_used)));
        }
        if is_narrowed && conditions.iter().any(|condition| condition.1 == Relation::NotNegative) {
            return uncovered("an antiderivative that is not defined for every parameter");
        }
        let zero = self.pool.number(rational(0, 1));
        let mut components: BTreeMap<String, [Expr; 2]> = BTreeMap::new();
        for (place, side) in sides.iter().enumerate() {
            for (blade, c) in &side.terms {
                let sign = if side.kind == Kind::Field { "@" } else { "d" };
                let names = coordinates(*blade).map(|v| format!("{sign}{}", self.variables[v].0));
                components.entry(names.collect::<Vec<_>>().join("^")).or_insert([zero, zero])[place] = *c;
            }
        }
        self.check_size()?;
        Ok(Statement::new(&self.pool, components, conditions))
    }

    /// Reads the conditions of a statement after `where`.
    fn stated(&mut self, mut reader: Reader) -> Result<Vec<Condition>, Stop> {
        while !matches!(reader.peek(), Some(Token::Sign(";")) | None) {
            if matches!(reader.peek(), Some(Token::Name(word)) if word == "where") {
                return self.domain(&mut reader);
            }
            reader.place += 1;
        }
        Ok(vec![])
    }

    pub(crate) fn statement_names(&self) -> Vec<String> {
        let mut names: Vec<String> = self.statements.keys().cloned().collect();
        names.sort();
        names
    }

    /// Returns the claim of a statement.
    pub(crate) fn claim(&self, name: &str) -> Option<Claim> {
        self.statements.get(name).map(|statement| statement.0)
    }

    fn add_statement(&mut self, name: String, claim: Claim, reader: Option<Reader>) {
        if self.statements.contains_key(&name) {
            self.fault.get_or_insert(format!("two statements are called `{name}`"));
        }
        self.statements.insert(name, (claim, reader));
    }

    /// Declares a name; its meaning cannot change afterwards.
    fn declare(&mut self, name: &str, meaning: Named) {
        let is_word = WORDS.contains(&name)
            || FUNCTIONS
                .iter()
                .map(|row| row.0)
                .chain(DERIVED.iter().map(|row| row.0))
                .any(|word| word == name);
        if is_word {
            self.fault.get_or_insert(format!("`{name}` is a reserved word of the language"));
        }
        if self.names.insert(name.to_string(), meaning).is_some() {
            self.fault.get_or_insert(format!("`{name}` is declared twice"));
        }
    }

    /// Reads a scalar of the certificate; its conditions do not become conditions of the statement.
    pub(crate) fn expression(&mut self, text: &str) -> Result<Expr, Stop> {
        let mut reader = Reader::new(text)?;
        let outer = std::mem::replace(&mut self.is_sealed, true);
        let expr = self.scalar(&mut reader);
        self.is_sealed = outer;
        let expr = expr?;
        self.check_size()?;
        if reader.peek().is_none() { Ok(expr) } else { Err(reader.wrong("the end of the line")) }
    }

    fn check_size(&self) -> Result<(), Stop> {
        if self.pool.is_full() { uncovered("expressions with too many nodes") } else { Ok(()) }
    }
}
