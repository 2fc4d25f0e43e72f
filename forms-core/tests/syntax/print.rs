//! Printer of syntax trees: with the fewest brackets, to be parsed again, or with all of them, to
//! be compared.

use forms_core::expression::Relation;
use forms_core::syntax::ast::*;

/// Choice of brackets.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Brackets {
    /// Only the brackets that precedence requires.
    Fewest,
    /// One pair around every part, so that equal texts mean equal trees.
    All,
}

/// Precedence of an expression, and the precedence that its context requires.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Unary,
    Power,
    Postfix,
    /// Name, number or bracket; only these can be indexed and remain one operand.
    Atom,
}

impl Brackets {
    pub(crate) fn expr(self, expr: &Expr) -> String {
        self.at(Level::Sum, expr)
    }

    /// Prints an expression where at least the precedence `wanted` is required.
    fn at(self, wanted: Level, expr: &Expr) -> String {
        let (level, text) = self.bare(expr);
        let needed = match self {
            Brackets::Fewest => level < wanted,
            Brackets::All => true,
        };
        if needed { format!("({text})") } else { text }
    }

    fn bare(self, expr: &Expr) -> (Level, String) {
        match &*expr.kind {
            ExprKind::Number(value) => (Level::Atom, decimal(value)),
            ExprKind::Name(name) => (Level::Atom, name.clone()),
            ExprKind::Basis(name) => (Level::Postfix, format!("@{}", name.text)),
            ExprKind::Negate(inner) => (Level::Unary, format!("-{}", self.at(Level::Unary, inner))),
            ExprKind::Binary(operation, _, left, right) => self.binary(*operation, left, right),
            ExprKind::Call { function, index, arguments } => {
                let index = index.as_ref().map_or(String::new(), |index| format!("[{}]", self.expr(index)));
                let arguments = joined(arguments, |argument| self.argument(argument));
                (Level::Postfix, format!("{}{index}({arguments})", function.text))
            }
            ExprKind::Index { base, indices } => {
                let indices = joined(indices, |index| self.expr(index));
                (Level::Postfix, format!("{}[{indices}]", self.at(Level::Postfix, base)))
            }
            ExprKind::Array(entries) => {
                (Level::Atom, format!("[{}]", joined(entries, |entry| self.expr(entry))))
            }
            ExprKind::Select { condition, then, otherwise, jump } => {
                let jump = if *jump { "jump " } else { "" };
                let (condition, then) = (self.condition(condition), self.expr(then));
                let text = format!("if {jump}{condition} {{ {then} }} else {{ {} }}", self.expr(otherwise));
                (Level::Sum, text)
            }
        }
    }

    fn binary(self, operation: Binary, left: &Expr, right: &Expr) -> (Level, String) {
        let (symbol, level, left_wanted, right_wanted) = match operation {
            Binary::Add => (" + ", Level::Sum, Level::Sum, Level::Product),
            Binary::Subtract => (" - ", Level::Sum, Level::Sum, Level::Product),
            Binary::Multiply => ("*", Level::Product, Level::Product, Level::Unary),
            Binary::Divide => ("/", Level::Product, Level::Product, Level::Unary),
            Binary::Wedge => ("^", Level::Product, Level::Product, Level::Unary),
            Binary::Power => ("**", Level::Power, Level::Postfix, Level::Unary),
        };
        // `if … { } else { } + 1` would begin with the branch, so a branch is bracketed wherever it is an operand.
        let side = |wanted: Level, side: &Expr| match &*side.kind {
            ExprKind::Select { .. } => format!("({})", self.expr(side)),
            ExprKind::Number(_) if operation == Binary::Wedge => format!("({})", self.expr(side)),
            ExprKind::Negate(_) if operation == Binary::Wedge => format!("({})", self.expr(side)),
            _ => self.at(wanted, side),
        };
        (level, format!("{}{symbol}{}", side(left_wanted, left), side(right_wanted, right)))
    }

    fn argument(self, argument: &Argument) -> String {
        match argument {
            Argument::Value(value) => self.expr(value),
            Argument::Range { variable, from, to } => {
                format!("{} = {}..{}", variable.text, self.expr(from), self.expr(to))
            }
        }
    }

    fn condition(self, condition: &Condition) -> String {
        let mut text = self.expr(&condition.first);
        for (relation, side) in &condition.rest {
            let relation = match relation {
                Relation::Less => "<",
                Relation::LessEqual => "<=",
                Relation::Greater => ">",
                Relation::GreaterEqual => ">=",
                Relation::NotEqual => "!=",
            };
            text.push_str(&format!(" {relation} {}", self.expr(side)));
        }
        text
    }

    fn conditions(self, conditions: &[Condition]) -> String {
        let list = joined(conditions, |condition| self.condition(condition));
        if list.is_empty() { list } else { format!(" where {list}") }
    }

    pub(crate) fn file(self, file: &File) -> String {
        file.items.iter().map(|item| self.item(item)).collect()
    }

    fn item(self, item: &Item) -> String {
        let docs: String = item.docs.iter().map(|line| format!("/// {line}\n")).collect();
        let public = if item.public { "pub " } else { "" };
        format!("{docs}{public}{};\n", self.kind(&item.kind))
    }

    fn kind(self, kind: &ItemKind) -> String {
        let on = |chart: &Option<Name>| {
            chart.as_ref().map_or(String::new(), |chart| format!(" on {}", chart.text))
        };
        match kind {
            ItemKind::Chart { name, coordinates, conditions } => {
                format!("chart {}({}){}", name.text, self.declared(coordinates), self.conditions(conditions))
            }
            ItemKind::ProductChart { name, factors, conditions } => {
                let factors: Vec<&str> = factors.iter().map(|factor| factor.text.as_str()).collect();
                format!("chart {} = {}{}", name.text, factors.join(" * "), self.conditions(conditions))
            }
            ItemKind::Param { names, conditions } => {
                format!("param {}{}", self.declared(names), self.conditions(conditions))
            }
            ItemKind::Function { name, arguments, unit, conditions } => {
                let arguments = joined(arguments, |argument| argument.text.clone());
                format!("fn {}({arguments}){}{}", name.text, self.unit(unit), self.conditions(conditions))
            }
            ItemKind::Let { name, unit, value } => {
                format!("let {}{} = {}", name.text, self.unit(unit), self.expr(value))
            }
            ItemKind::Definition { name, arguments, value } => {
                let arguments = joined(arguments, |argument| argument.text.clone());
                format!("let {}({arguments}) = {}", name.text, self.expr(value))
            }
            ItemKind::Form { name, degree, unit, chart, value } => {
                let degree = degree.map_or(String::new(), |(degree, _)| format!(": {degree}"));
                let unit = unit.as_ref().map_or(String::new(), |unit| format!(", {}", self.expr(unit)));
                format!("form {}{degree}{unit}{} = {}", name.text, on(chart), self.expr(value))
            }
            ItemKind::Field { name, chart, value } => {
                format!("field {}{} = {}", name.text, on(chart), self.expr(value))
            }
            ItemKind::Map { name, source, target, components } => {
                let values = self.values(components);
                format!("map {}: {} -> {} = {values}", name.text, source.text, target.text)
            }
            ItemKind::Metric { name, chart, value } => {
                format!("metric {}{} = {}", name.text, on(chart), self.expr(value))
            }
            ItemKind::Statement { claim, name, left, right, conditions } => {
                let claim = if *claim == Claim::Prove { "prove" } else { "refute" };
                let (left, right) = (self.expr(left), self.expr(right));
                format!("{claim} {}: {left} == {right}{}", name.text, self.conditions(conditions))
            }
            ItemKind::Kernel {
                name,
                arguments,
                units,
                outputs,
                computed,
                approximation,
                target_forms,
                conditions,
                within,
                effects,
            } => {
                let tolerance = |given: &Expr| format!(" approx {}", self.expr(given));
                let form = |computed: &[Expr], approximation: &Option<Expr>| {
                    self.behind("by", computed) + &approximation.as_ref().map_or(String::new(), tolerance)
                };
                let mut by = form(computed, approximation);
                for TargetForm { target, computed, approximation } in target_forms {
                    by += &format!(" for {} {{{} }}", target.text, form(computed, approximation));
                }
                let within =
                    within.as_ref().map_or(String::new(), |within| format!(" within {}", self.expr(within)));
                let arguments = self.declared(arguments);
                let (values, effects) = (self.values(outputs), self.effects(effects));
                let units =
                    if units.is_empty() { String::new() } else { format!(": {}", self.values(units)) };
                format!(
                    "kernel {}({arguments}){units} = {values}{by}{}{within}{effects}",
                    name.text,
                    self.conditions(conditions)
                )
            }
            ItemKind::Derivatives { name, which, of, by } => {
                let by = joined(by, |variable| variable.text.clone());
                format!("kernel {} = {}({}; {by})", name.text, which.word(), of.text)
            }
            ItemKind::Warp(warp) => self.warp(warp),
        }
    }

    fn warp(self, warp: &Warp) -> String {
        format!(
            "warp {}({}; {}) = {} onto {} density {} of {}{}{}",
            warp.name.text,
            self.declared(&warp.parameters),
            self.declared(&warp.uniforms),
            self.values(&warp.components),
            warp.target.text,
            self.expr(&warp.density),
            self.expr(&warp.form),
            self.behind("inverse", &warp.inverse),
            self.conditions(&warp.conditions)
        )
    }

    /// Prints a word and values, or nothing if there are no values.
    fn behind(self, word: &str, values: &[Expr]) -> String {
        if values.is_empty() { String::new() } else { format!(" {word} {}", self.values(values)) }
    }

    fn values(self, values: &[Expr]) -> String {
        match values {
            [value] => self.expr(value),
            several => format!("({})", joined(several, |value| self.expr(value))),
        }
    }

    fn effects(self, effects: &[Effect]) -> String {
        let one = |effect: &Effect| {
            format!("{}: {} = {}; ", effect.name.text, effect.variable.text, self.expr(&effect.value))
        };
        let list: String = effects.iter().map(one).collect();
        if list.is_empty() { list } else { format!(" effects {{ {list}}}") }
    }

    fn declared(self, list: &[Declared]) -> String {
        joined(list, |Declared { name, extents, unit }| {
            let extents = joined(extents, usize::to_string);
            let extents = if extents.is_empty() { extents } else { format!("[{extents}]") };
            format!("{}{extents}{}", name.text, self.unit(unit))
        })
    }

    fn unit(self, unit: &Option<Expr>) -> String {
        unit.as_ref().map_or(String::new(), |unit| format!(": {}", self.expr(unit)))
    }
}

fn joined<T>(list: &[T], text: impl Fn(&T) -> String) -> String {
    list.iter().map(text).collect::<Vec<_>>().join(", ")
}

/// Prints a fraction whose denominator divides a power of ten, as a decimal.
fn decimal(value: &num_rational::BigRational) -> String {
    let mut places = 0_i32;
    let mut shifted = value.clone();
    while !shifted.is_integer() {
        shifted *= num_bigint::BigInt::from(10);
        places += 1;
    }
    if places == 0 { shifted.to_string() } else { format!("{shifted}e-{places}") }
}
