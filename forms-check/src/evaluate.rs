//! Evaluation of expressions while they are read: scalars, forms and fields, and the conditions
//! they require.

use crate::calculus::{Kind, Value, order};
use crate::expression::Operation::{Divide, Function, Jet, Multiply, Pi, Power, Variable};
use crate::expression::{Expr, rational};
use crate::field::Field;
use crate::theory::{Condition, Named, Relation, Scope, Theory};
use crate::tokens::{Reader, Token};
use crate::{Stop, malformed, uncovered};
use std::collections::{BTreeSet, HashMap};

/// Maximum nesting of brackets and signs.
const DEEPEST: usize = 120;

impl Theory {
    /// Reads `a < b <= c` as conditions on differences.
    pub(crate) fn relations(&mut self, reader: &mut Reader) -> Result<Vec<Condition>, Stop> {
        let mut all = Vec::new();
        let mut left = self.sum(reader)?;
        while let Some(sign) = reader.one_of(&["<=", ">=", "!=", "<", ">"]) {
            let right = self.sum(reader)?;
            let (more, less) = if sign.starts_with('<') { (&right, &left) } else { (&left, &right) };
            let relation = match sign {
                "!=" => Relation::NotZero,
                "<" | ">" => Relation::Positive,
                _ => Relation::NotNegative,
            };
            let difference = more.add(&mut self.pool, less, -1);
            all.push((self.as_scalar(&difference)?, relation));
            left = right;
        }
        Ok(all)
    }

    pub(crate) fn require(&mut self, expr: Expr, relation: Relation) {
        let zero = rational(0, 1);
        let holds = self.pool.as_number(expr).is_some_and(|value| match relation {
            Relation::Positive => *value > zero,
            Relation::NotNegative => *value >= zero,
            Relation::NotZero => *value != zero,
        });
        if !holds && !self.scope.conditions.contains(&(expr, relation)) {
            self.scope.conditions.push((expr, relation));
        }
    }

    pub(crate) fn require_all(&mut self, scope: &Scope) {
        self.scope.used.extend(&scope.used);
        self.scope.integrates |= scope.integrates;
        self.scope.is_narrowed |= scope.is_narrowed;
        scope.conditions.iter().for_each(|(expr, relation)| self.require(*expr, *relation));
    }

    /// Requires conditions at the images of their variables.
    pub(crate) fn require_at(&mut self, conditions: &[Condition], images: &HashMap<usize, Expr>) {
        for (expr, relation) in conditions {
            let composed = self.pool.substitute(*expr, images);
            self.require(composed, *relation);
        }
    }

    pub(crate) fn as_scalar(&mut self, value: &Value) -> Result<Expr, Stop> {
        value.as_scalar(&mut self.pool).ok_or_else(|| malformed("expected a scalar"))
    }

    pub(crate) fn scalar(&mut self, reader: &mut Reader) -> Result<Expr, Stop> {
        let value = self.sum(reader)?;
        self.as_scalar(&value)
    }

    pub(crate) fn sum(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        let mut value = self.product(reader)?;
        while let Some(sign) = reader.one_of(&["+", "-"]) {
            let right = self.product(reader)?;
            if !value.is_alike(&right) {
                return Err(malformed("a sum of different types"));
            }
            value = value.add(&mut self.pool, &right, if sign == "+" { 1 } else { -1 });
        }
        Ok(value)
    }

    fn product(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        let mut left = self.signed(reader)?;
        while let Some(sign) = reader.one_of(&["*", "/", "^"]) {
            let mut right = self.signed(reader)?;
            if sign == "/" {
                let (divisor, one) = (self.as_scalar(&right)?, self.pool.number(rational(1, 1)));
                self.require(divisor, Relation::NotZero);
                if let Some(c) = left.as_scalar(&mut self.pool) {
                    left = Value::of(0, self.pool.make(Divide, vec![c, divisor]));
                    continue;
                }
                right = Value::of(0, self.pool.make(Divide, vec![one, divisor]));
            }
            let scalars = [&left, &right].map(|value| value.as_scalar(&mut self.pool).is_some());
            let forms = [left.kind, right.kind] == [Kind::Form, Kind::Form];
            if scalars == [false, false] && forms && sign == "*" && self.in_metric {
                left = left.symmetric(&mut self.pool, &right);
                continue;
            }
            if scalars == [false, false] && (sign == "*" || !forms) {
                return Err(malformed("a product that needs a scalar"));
            }
            left = left.wedge(&mut self.pool, &right);
        }
        Ok(left)
    }

    /// Reads a signed expression. A sign binds less tightly than a power: `-x**2` is −(x²), and
    /// `x**-2` is allowed.
    fn signed(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        reader.depth += 1;
        if reader.depth > DEEPEST {
            return uncovered(format!("brackets and signs more than {DEEPEST} deep"));
        }
        let value = if reader.take("-") {
            let inner = self.signed(reader)?;
            Value::default().add(&mut self.pool, &inner, -1)
        } else {
            self.power(reader)?
        };
        reader.depth -= 1;
        Ok(value)
    }

    fn power(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        let mut value = self.atom(reader)?;
        while reader.take("[") {
            value = self.coefficient(&value, reader)?;
        }
        if !reader.take("**") {
            return Ok(value);
        }
        let exponent = self.signed(reader)?;
        if self.in_metric && value.as_scalar(&mut self.pool).is_none() {
            let two = exponent.as_scalar(&mut self.pool).is_some_and(|n| self.pool.is(n, 2));
            let square = value.symmetric(&mut self.pool, &value);
            return if two && value.kind == Kind::Form {
                Ok(square)
            } else {
                Err(malformed("inside a metric only the square of a 1-form is allowed"))
            };
        }
        let (base, exponent) = (self.as_scalar(&value)?, self.as_scalar(&exponent)?);
        Ok(Value::of(0, self.raised(base, exponent)?))
    }

    /// Returns qʳ for a number r, exp(e log q) otherwise.
    pub(crate) fn raised(&mut self, base: Expr, exponent: Expr) -> Result<Expr, Stop> {
        let Some(value) = self.pool.as_number(exponent).cloned() else {
            // a prover that recognises this exponent as a number requires less of q
            if self.is_constant(exponent)? {
                return uncovered("an exponent that is a number and is not written as one");
            }
            self.require(base, Relation::Positive);
            let logarithm = self.pool.make(Function("log"), vec![base]);
            let product = self.pool.make(Multiply, vec![exponent, logarithm]);
            return Ok(self.pool.make(Function("exp"), vec![product]));
        };
        let small = [value.numer(), value.denom()].map(|part| i64::try_from(part).ok());
        let [Some(p), Some(q)] = small.map(|part| part.filter(|p| p.abs() <= 1 << 20)) else {
            return uncovered("exponents this large");
        };
        match (q == 1, p < 0) {
            (true, true) => self.require(base, Relation::NotZero),
            (true, false) => {}
            (false, true) => self.require(base, Relation::Positive),
            (false, false) => self.require(base, Relation::NotNegative),
        }
        Ok(self.pool.make(Power(p, q), vec![base]))
    }

    /// Whether an expression is visibly the same number everywhere.
    fn is_constant(&self, q: Expr) -> Result<bool, Stop> {
        let depends = |part: Expr| matches!(self.pool.node(part).0, Variable(_) | Jet(..));
        if !self.pool.parts(&[q]).into_iter().any(depends) {
            return Ok(true);
        }
        let element = Field::default().element(&self.pool, q)?;
        Ok(element.numerator.as_constant().is_some() && element.factors.is_empty())
    }

    fn atom(&mut self, reader: &mut Reader) -> Result<Value, Stop> {
        if reader.take("(") {
            let inner = self.sum(reader)?;
            reader.expect(")")?;
            return Ok(inner);
        }
        if reader.take("@") {
            let v = self.variable(&reader.name()?)?;
            self.scope.used.insert(v);
            return Ok(Value { kind: Kind::Field, ..Value::differential(&mut self.pool, v) });
        }
        if let Some(Token::Number(value)) = reader.peek().cloned() {
            reader.place += 1;
            let is_zero = value == rational(0, 1);
            return Ok(if is_zero { Value::default() } else { Value::of(0, self.pool.number(value)) });
        }
        let name = reader.name()?;
        if reader.take("(") {
            let outer = std::mem::take(&mut self.in_metric);
            let value = self.call(&name, reader);
            self.in_metric = outer;
            return value;
        }
        match self.names.get(&name).cloned() {
            _ if name == "pi" => Ok(Value::of(0, self.pool.make(Pi, vec![]))),
            Some(Named::Variable(v)) => Ok(Value::of(0, self.use_variable(v))),
            Some(Named::Differential(v)) => {
                self.scope.used.insert(v);
                Ok(Value::differential(&mut self.pool, v))
            }
            Some(Named::Function(f)) => {
                let own = self.functions[f].0.clone();
                let arguments = own.into_iter().map(|v| self.use_variable(v)).collect();
                Ok(Value::of(0, self.unknown(f, arguments)))
            }
            Some(Named::Object(value, scope)) => {
                self.require_all(&scope);
                Ok(value)
            }
            Some(Named::Metric(metric, scope)) if self.in_metric => {
                self.require_all(&scope);
                Ok(metric.quadratic(&mut self.pool))
            }
            Some(Named::Uncovered(what)) => uncovered(what),
            None if name == "d" && reader.take("[") => {
                let (along, _) = self.chart_named(&reader.name()?)?;
                reader.expect("]")?;
                reader.expect("(")?;
                let w = self.sum(reader)?;
                reader.expect(")")?;
                Ok(w.exterior(&mut self.pool, &along))
            }
            None if reader.take("[") => self.with_metric(&name, reader),
            _ => Err(malformed(format!("`{name}` has no value"))),
        }
    }

    fn use_variable(&mut self, v: usize) -> Expr {
        let conditions = self.params.get(&v).cloned().unwrap_or_default();
        self.require_all(&Scope { conditions, used: BTreeSet::from([v]), ..Scope::default() });
        self.pool.make(Variable(v), vec![])
    }

    /// Returns an unknown function at its arguments, and requires the conditions it was declared
    /// with.
    pub(crate) fn unknown(&mut self, f: usize, arguments: Vec<Expr>) -> Expr {
        let (own, conditions) = self.functions[f].clone();
        self.require_at(&conditions, &own.into_iter().zip(arguments.iter().copied()).collect());
        self.pool.make(Jet(f, vec![0; arguments.len()]), arguments)
    }

    pub(crate) fn scalars(&mut self, reader: &mut Reader, wanted: usize) -> Result<Vec<Expr>, Stop> {
        let mut values = Vec::new();
        while values.len() < wanted {
            if !values.is_empty() {
                reader.expect(",")?;
            }
            values.push(self.scalar(reader)?);
        }
        reader.expect(")")?;
        Ok(values)
    }

    /// Reads the index of `w[dx^dy]` or `X[x]` after its opening bracket.
    fn coefficient(&mut self, value: &Value, reader: &mut Reader) -> Result<Value, Stop> {
        let (mut blade, mut sign) = (0, 1);
        while blade == 0 || reader.take("^") {
            let name = reader.name()?;
            let v = match self.names.get(&name) {
                Some(Named::Variable(v)) if value.kind == Kind::Field => *v,
                Some(Named::Differential(v)) if value.kind == Kind::Form => *v,
                _ => return Err(malformed(format!("`{name}` is not a differential"))),
            };
            sign *= order(blade, 1 << v).ok_or_else(|| malformed("a differential occurs twice"))?;
            blade |= 1 << v;
        }
        reader.expect("]")?;
        let zero = self.pool.number(rational(0, 1));
        let c = value.terms.get(&blade).copied().unwrap_or(zero);
        Ok(Value::of(0, if sign < 0 { self.pool.negate(c) } else { c }))
    }
}
