//! LaTeX of expressions as their author wrote them, with the operators of the calculus in their
//! usual notation.
//!
//! F*w, ι_X w, ℒ_X w, [X, Y], w(X, Y), ∂²f/∂x∂y, ⋆_g w, ⟨a, b⟩_g, X♭, w♯, ∫ w.

use super::latex::{Binding, Written, bracketed, latex_of_relation, number};
use super::name::latex_name;
use crate::expression::Operation;
use crate::syntax::ast::{Argument, Binary, Condition, Expr, ExprKind, Name};
use crate::theory::{Named, Theory};
use num_traits::{One, Signed};

/// Writes an expression of the source in LaTeX, without evaluation or simplification.
pub fn latex_as_written(theory: &Theory, expression: &Expr) -> String {
    Writer { theory }.write(expression).latex
}

/// Writes a condition of the source in LaTeX.
pub fn latex_of_condition(theory: &Theory, condition: &Condition) -> String {
    let writer = Writer { theory };
    let mut latex = writer.of(&condition.first, Binding::Sum);
    for (relation, side) in &condition.rest {
        latex.push_str(&format!(" {} {}", latex_of_relation(*relation), writer.of(side, Binding::Sum)));
    }
    latex
}

struct Writer<'a> {
    theory: &'a Theory,
}

fn atom(latex: String) -> Written {
    Written { latex, binding: Binding::Atom }
}

fn prefix(latex: String) -> Written {
    Written { latex, binding: Binding::Power }
}

impl Writer<'_> {
    fn of(&self, expression: &Expr, needed: Binding) -> String {
        self.write(expression).within(needed)
    }

    fn write(&self, expression: &Expr) -> Written {
        match &*expression.kind {
            ExprKind::Number(value) => {
                let (latex, binding) = number(value);
                Written { latex, binding }
            }
            ExprKind::Name(name) => atom(self.name(name)),
            ExprKind::Basis(name) => atom(format!("\\partial_{{{}}}", latex_name(&name.text))),
            ExprKind::Negate(inner) => {
                let latex = format!("-{}", self.of(inner, Binding::Product));
                Written { latex, binding: Binding::Product }
            }
            ExprKind::Binary(operator, _, left, right) => self.binary(*operator, left, right),
            ExprKind::Call { function, index, arguments } => self.call(function, index.as_ref(), arguments),
            ExprKind::Index { base, indices } => self.index(base, indices),
            ExprKind::Array(entries) => atom(self.array(entries)),
            ExprKind::Select { condition: when, then, otherwise, .. } => {
                let when = latex_of_condition(self.theory, when);
                let [then, otherwise] = [then, otherwise].map(|branch| self.of(branch, Binding::Sum));
                let cases = format!("{then} & {when} \\\\ {otherwise} & \\text{{otherwise}}");
                let latex = format!("\\begin{{cases}} {cases} \\end{{cases}}");
                Written { latex, binding: Binding::Sum }
            }
        }
    }

    fn name(&self, name: &str) -> String {
        match self.theory.named(name) {
            Some(Named::Differential(coordinate)) => {
                format!("\\mathrm{{d}}{}", latex_name(self.theory.coordinate_name(*coordinate)))
            }
            _ => latex_name(name),
        }
    }

    fn binary(&self, operator: Binary, left: &Expr, right: &Expr) -> Written {
        let sum = |sign: &str| {
            let (left, right) = (self.of(left, Binding::Sum), self.of(right, Binding::Product));
            Written { latex: format!("{left} {sign} {right}"), binding: Binding::Sum }
        };
        let product = |between: &str| {
            let (left, right) = (self.of(left, Binding::Product), self.of(right, Binding::Fraction));
            Written { latex: format!("{left}{between}{right}"), binding: Binding::Product }
        };
        match operator {
            Binary::Add => sum("+"),
            Binary::Subtract => sum("-"),
            Binary::Multiply => product("\\,"),
            Binary::Wedge => product("\\wedge "),
            Binary::Divide => {
                let (above, below) = (self.of(left, Binding::Sum), self.of(right, Binding::Sum));
                Written { latex: format!("\\frac{{{above}}}{{{below}}}"), binding: Binding::Fraction }
            }
            Binary::Power => self.power(left, right),
        }
    }

    /// sinⁿ x where that is usual, xⁿ otherwise
    fn power(&self, base: &Expr, exponent: &Expr) -> Written {
        if let (ExprKind::Call { function, index: None, arguments }, ExprKind::Number(n)) =
            (&*base.kind, &*exponent.kind)
            && n.is_positive()
            && n.denom().is_one()
            && Operation::named(&function.text).is_some_and(|f| f != Operation::Exp && f != Operation::Abs)
        {
            return self.function(&function.text, arguments, &format!("^{{{n}}}"));
        }
        let (base, exponent) = (self.of(base, Binding::Atom), self.of(exponent, Binding::Sum));
        prefix(format!("{base}^{{{exponent}}}"))
    }

    fn index(&self, base: &Expr, indices: &[Expr]) -> Written {
        let below = self.list(indices, ", ");
        if let ExprKind::Name(name) = &*base.kind
            && name == "volume"
        {
            return atom(format!("\\mathrm{{vol}}_{{{below}}}"));
        }
        let base = bracketed(&self.of(base, Binding::Sum));
        atom(format!("{base}_{{{below}}}"))
    }

    /// Writes a vector as a column, and a matrix by its rows.
    fn array(&self, entries: &[Expr]) -> String {
        let row = |entry: &Expr| match &*entry.kind {
            ExprKind::Array(row) => self.list(row, " & "),
            _ => self.of(entry, Binding::Sum),
        };
        let rows: Vec<String> = entries.iter().map(row).collect();
        format!("\\begin{{pmatrix}} {} \\end{{pmatrix}}", rows.join(" \\\\ "))
    }

    fn list(&self, expressions: &[Expr], between: &str) -> String {
        let written: Vec<String> = expressions.iter().map(|part| self.of(part, Binding::Sum)).collect();
        written.join(between)
    }

    fn call(&self, function: &Name, index: Option<&Expr>, arguments: &[Argument]) -> Written {
        let below = index.map_or(String::new(), |index| format!("_{{{}}}", self.of(index, Binding::Sum)));
        let plain: Vec<&Expr> = arguments.iter().filter_map(value).collect();
        let tight = |place: usize| self.of(plain[place], Binding::Power);
        let loose = |place: usize| self.of(plain[place], Binding::Sum);
        let lists = |from: usize| (from..plain.len()).map(loose).collect::<Vec<_>>().join(", ");
        match (function.text.as_str(), plain.len()) {
            ("d", 1) => prefix(format!("\\mathrm{{d}}{below}{}", tight(0))),
            ("pullback", 2) => prefix(format!("{}^{{*}}{}", loose(0), tight(1))),
            ("interior", 2) => prefix(format!("\\iota_{{{}}}{}", loose(0), tight(1))),
            ("lie", 2) => prefix(format!("\\mathcal{{L}}_{{{}}}{}", loose(0), tight(1))),
            ("bracket", 2) => atom(format!("\\left[{}\\right]", lists(0))),
            ("pair", 2..) => atom(format!("{}{}", tight(0), bracketed(&lists(1)))),
            ("diff", 2..) => self.partial(&plain),
            ("hodge", 1) => prefix(format!("\\star{below}{}", tight(0))),
            ("codiff", 1) => prefix(format!("\\delta{below}{}", tight(0))),
            ("laplace", 1) => prefix(format!("\\Delta{below}{}", tight(0))),
            ("flat", 1) => atom(format!("{}^{{\\flat{below}}}", self.of(plain[0], Binding::Atom))),
            ("sharp", 1) => atom(format!("{}^{{\\sharp{below}}}", self.of(plain[0], Binding::Atom))),
            ("inner", 2) => atom(format!("\\left\\langle {}\\right\\rangle{below}", lists(0))),
            ("norm", 1) => atom(format!("\\left\\|{}\\right\\|{below}", loose(0))),
            ("grad" | "curl" | "div", 1) => {
                prefix(format!("\\operatorname{{{}}}{below}{}", function.text, tight(0)))
            }
            ("sqrt", 1) => atom(format!("\\sqrt{{{}}}", loose(0))),
            ("integral", 1) => self.integral("\\int", &plain, arguments),
            ("boundary_integral", 2) => {
                let sign = format!("\\oint_{{\\partial {}}}", loose(0));
                prefix(format!("{sign} {}", tight(1)))
            }
            _ => self.function(&function.text, arguments, ""),
        }
    }

    /// ∂²f/∂x∂y
    fn partial(&self, plain: &[&Expr]) -> Written {
        let order = plain.len() - 1;
        let raised = if order > 1 { format!("^{{{order}}}") } else { String::new() };
        let by: Vec<String> =
            plain[1..].iter().map(|by| format!("\\partial {}", self.of(by, Binding::Atom))).collect();
        let f = self.of(plain[0], Binding::Power);
        let latex = format!("\\frac{{\\partial{raised}}}{{{}}}{f}", by.join("\\,"));
        Written { latex, binding: Binding::Product }
    }

    /// ∫_{u=a}^{b} ∫_{v=c}^{e} w
    fn integral(&self, sign: &str, plain: &[&Expr], arguments: &[Argument]) -> Written {
        let mut latex = String::new();
        for argument in arguments {
            if let Argument::Range { variable, from, to } = argument {
                let (from, to) = (self.of(from, Binding::Sum), self.of(to, Binding::Sum));
                latex.push_str(&format!("{sign}_{{{}={from}}}^{{{to}}}", latex_name(&variable.text)));
            }
        }
        Written {
            latex: format!("{latex} {}", self.of(plain[0], Binding::Product)),
            binding: Binding::Product,
        }
    }

    fn function(&self, name: &str, arguments: &[Argument], exponent: &str) -> Written {
        let list: Vec<String> =
            arguments.iter().filter_map(value).map(|a| self.of(a, Binding::Sum)).collect();
        let list = list.join(", ");
        match Operation::named(name) {
            Some(Operation::Exp) => prefix(format!("e^{{{list}}}")),
            Some(Operation::Abs) => atom(format!("\\left|{list}\\right|")),
            Some(operation) => prefix(format!("{}{exponent}{}", operation.row().latex, bracketed(&list))),
            None if ["min", "max", "sec", "csc", "cot"].contains(&name) => {
                prefix(format!("\\{name}{exponent}{}", bracketed(&list)))
            }
            None => atom(format!("{}{}", latex_name(name), bracketed(&list))),
        }
    }
}

fn value(argument: &Argument) -> Option<&Expr> {
    match argument {
        Argument::Value(expression) => Some(expression),
        Argument::Range { .. } => None,
    }
}

#[cfg(test)]
mod tests {
    use super::latex_as_written;
    use crate::check::read_file;
    use crate::syntax::ast::ItemKind;

    const DECLARED: &str = "chart P(u, v); chart R3(x, y, z); fn f(x, y); let r = sqrt(x**2 + y**2);
        map F: P -> R3 = (u, v, 1); field X on R3 = x*@y;";

    #[test]
    fn what_was_written_is_set_as_it_is_usual() {
        let cases = [
            ("d(x*dy^dz)", "\\mathrm{d}\\left(x\\,\\mathrm{d}y\\wedge \\mathrm{d}z\\right)"),
            ("pullback(F, x*dy)", "F^{*}\\left(x\\,\\mathrm{d}y\\right)"),
            ("interior(X, dx)", "\\iota_{X}\\mathrm{d}x"),
            ("lie(X, dx^dy)", "\\mathcal{L}_{X}\\left(\\mathrm{d}x\\wedge \\mathrm{d}y\\right)"),
            ("diff(f, x, y)", "\\frac{\\partial^{2}}{\\partial x\\,\\partial y}f"),
            ("sin(x)**2/r", "\\frac{\\sin^{2}\\left(x\\right)}{r}"),
            ("(x*dy)[dy]", "\\left(x\\,\\mathrm{d}y\\right)_{\\mathrm{d}y}"),
            ("integral(u*v, u = 0..1, v = 0..u)", "\\int_{u=0}^{1}\\int_{v=0}^{u} u\\,v"),
            ("x - (y - z)", "x - \\left(y - z\\right)"),
            ("pair(dx, X)", "\\mathrm{d}x\\left(X\\right)"),
        ];
        for (source, expected) in cases {
            let (file, theory, errors) = read_file(&format!("{DECLARED} prove s: {source} == 0;"));
            assert!(errors.is_empty(), "{source}: {errors:?}");
            let Some(ItemKind::Statement { left, .. }) = file.items.last().map(|item| &item.kind) else {
                panic!("{source}")
            };
            assert_eq!(latex_as_written(&theory, left), expected, "{source}");
        }
    }
}
