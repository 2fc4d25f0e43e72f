//! Named objects of a file, simplified, in the language or in LaTeX.

use super::{latex, latex_of_name, latex_of_relation, simplify, simplify_expression, text};
use crate::calculus::Coordinate;
use crate::expression::{Condition, Expr, Symbol};
use crate::theory::{Array, Named, Statement, Theory, Value};

/// Writes the object with this name in the language; for a statement, both of its sides. `None` if
/// nothing has that name.
pub fn text_of_named(theory: &mut Theory, name: &str) -> Option<String> {
    Writer { theory, is_text: true }.named(name)
}

/// Writes the object with this name in LaTeX.
pub fn latex_of_named(theory: &mut Theory, name: &str) -> Option<String> {
    Writer { theory, is_text: false }.named(name)
}

struct Writer<'a> {
    theory: &'a mut Theory,
    is_text: bool,
}

impl Writer<'_> {
    /// Writes the object with this name; a name of the language precedes the name of a statement.
    fn named(&mut self, name: &str) -> Option<String> {
        let Some(named) = self.theory.named(name).cloned() else {
            let statement = self.theory.statements.iter().find(|statement| statement.name == name)?.clone();
            return Some(self.statement(&statement));
        };
        Some(match named {
            Named::Chart(number) => self.chart(number),
            Named::Object(number) => {
                let object = self.theory.objects[number].clone();
                let shown = self.value(&object.value);
                match object.unit {
                    Some(unit) if self.is_text => format!("{shown}  // in {unit}"),
                    _ => shown,
                }
            }
            Named::Map(number) => {
                let components = self.theory.maps[number].components.clone();
                self.tuple(&components)
            }
            Named::Kernel(number) => self.kernel(number),
            Named::Definition(number) => self.definition(number),
            Named::Function(function) => {
                let arguments = self.theory.pool.function(function).arguments.clone();
                let arguments: Vec<String> =
                    arguments.into_iter().map(|symbol| self.symbol(symbol)).collect();
                format!("{}({})", self.name(name), arguments.join(", "))
            }
            Named::Differential(coordinate) => self.differential(coordinate),
            Named::Coordinate(_)
            | Named::Parameter(_)
            | Named::Metric(_)
            | Named::Array(_)
            | Named::Pending
            | Named::Poisoned => self.name(name),
        })
    }

    /// Writes the results of a kernel: a single one as it is, several in brackets.
    fn kernel(&mut self, number: usize) -> String {
        let kernel = &self.theory.kernels[number];
        let (shapes, mut outputs) = (kernel.signature.results.clone(), kernel.outputs.clone());
        let parts: Vec<String> = shapes
            .into_iter()
            .map(|shape| {
                let entries = outputs.drain(..shape.entries()).collect();
                self.value(&Array::value(shape, entries))
            })
            .collect();
        match parts.as_slice() {
            [single] => single.clone(),
            several if self.is_text => format!("({})", several.join(", ")),
            several => format!("\\left({}\\right)", several.join(", ")),
        }
    }

    /// Writes the arguments of a definition: `ease(t)`.
    fn definition(&self, number: usize) -> String {
        let definition = &self.theory.definitions[number];
        let arguments: Vec<String> = definition.arguments.iter().map(|name| self.name(name)).collect();
        format!("{}({})", self.name(&definition.name.text), arguments.join(", "))
    }

    fn name(&self, name: &str) -> String {
        if self.is_text { name.to_string() } else { latex_of_name(name) }
    }

    fn symbol(&self, symbol: Symbol) -> String {
        self.name(self.theory.pool.symbol_name(symbol))
    }

    fn differential(&self, coordinate: Coordinate) -> String {
        let name = self.name(self.theory.coordinate_name(coordinate));
        if self.is_text { format!("d{name}") } else { format!("\\mathrm{{d}}{name}") }
    }

    fn value(&mut self, value: &Value) -> String {
        let simplified = simplify(self.theory, &[], value);
        if self.is_text { text(self.theory, &simplified) } else { latex(self.theory, &simplified) }
    }

    fn scalar(&mut self, scalar: Expr) -> String {
        self.value(&Value::Scalar(scalar))
    }

    fn tuple(&mut self, scalars: &[Expr]) -> String {
        let parts: Vec<String> = scalars.iter().map(|&scalar| self.scalar(scalar)).collect();
        let inner = parts.join(", ");
        if self.is_text { format!("({inner})") } else { format!("\\left({inner}\\right)") }
    }

    fn chart(&mut self, number: usize) -> String {
        let chart = self.theory.charts[number].clone();
        let coordinates: Vec<String> =
            chart.coordinates.iter().map(|&c| self.name(self.theory.coordinate_name(c))).collect();
        let shown = format!("{}({})", self.name(&chart.name), coordinates.join(", "));
        shown + &self.conditions(&chart.conditions)
    }

    fn statement(&mut self, statement: &Statement) -> String {
        let (left, right) = (self.value(&statement.left), self.value(&statement.right));
        let equals = if self.is_text { "==" } else { "=" };
        format!("{left} {equals} {right}") + &self.conditions(&statement.conditions)
    }

    /// Writes ` where a > 0, b != 0`; empty without conditions.
    fn conditions(&mut self, conditions: &[Condition]) -> String {
        if conditions.is_empty() {
            return String::new();
        }
        let conditions: Vec<String> = conditions.iter().map(|condition| self.condition(condition)).collect();
        let between = if self.is_text { " where " } else { "\\quad\\text{where}\\quad " };
        format!("{between}{}", conditions.join(", "))
    }

    fn condition(&mut self, condition: &Condition) -> String {
        let [left, right] = [condition.left, condition.right]
            .map(|side| simplify_expression(&mut self.theory.pool, &[], side));
        let (left, right) = (Value::Scalar(left), Value::Scalar(right));
        if self.is_text {
            let (left, right) = (text(self.theory, &left), text(self.theory, &right));
            return format!("{left} {} {right}", condition.relation.text());
        }
        let (left, right) = (latex(self.theory, &left), latex(self.theory, &right));
        format!("{left} {} {right}", latex_of_relation(condition.relation))
    }
}
