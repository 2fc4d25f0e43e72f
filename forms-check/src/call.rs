//! Calls: functions of scalars, and the operators of the calculus, with their arguments.

use crate::calculus::{Kind, Value};
use crate::expression::Operation::{Function, Jet};
use crate::expression::rational;
use crate::theory::{COMMON, FUNCTIONS, Named, Theory, derived};
use crate::tokens::Reader;
use crate::{Stop, malformed, uncovered};

impl Theory {
    /// Reads the arguments of a function after its opening bracket.
    pub(crate) fn call(&mut self, name: &str, reader: &mut Reader) -> Result<Value, Stop> {
        if COMMON.iter().any(|row| row.0 == name) && self.names.contains_key(name) {
            // the name has the other meaning only below its declaration
            return uncovered(format!("`{name}`, which the file gives another meaning"));
        }
        if let Some(Named::Function(f)) = self.names.get(name) {
            let f = *f;
            let values = self.scalars(reader, self.functions[f].0.len())?;
            return Ok(Value::of(0, self.unknown(f, values)));
        }
        let plain = FUNCTIONS.iter().find(|row| row.0 == name).map(|row| row.0);
        let derived = derived().find(|row| row.0 == name);
        if plain.is_some() || derived.is_some() {
            let values = self.scalars(reader, derived.map_or(1, |row| row.1))?;
            let images = values.iter().copied().enumerate().collect();
            self.require_at(&self.domains.get(name).cloned().unwrap_or_default(), &images);
            return Ok(Value::of(
                0,
                match plain {
                    Some(function) => self.pool.make(Function(function), values),
                    None => self.pool.substitute(self.pool.templates[name], &images),
                },
            ));
        }
        if name == "sqrt" {
            let (q, half) = (self.scalars(reader, 1)?[0], self.pool.number(rational(1, 2)));
            return Ok(Value::of(0, self.raised(q, half)?));
        }
        let value = match name {
            "pullback" => self.pulled_back(reader)?.0,
            "integral" => self.integral(reader)?,
            "boundary_integral" => self.boundary_integral(reader)?,
            "diff" => {
                let mut value = self.scalar(reader)?;
                while reader.take(",") {
                    let v = self.variable(&reader.name()?)?;
                    value = self.pool.derivative(value, v);
                }
                Value::of(0, value)
            }
            "d" | "interior" | "lie" | "bracket" | "pair" => self.calculus(name, reader)?,
            _ => return uncovered(format!("`{name}`")),
        };
        reader.expect(")")?;
        if name == "diff" && reader.take("(") {
            // in certificates, `diff(f, x)(a)` is a derivative of an unknown function at other
            // arguments
            if !self.is_sealed {
                return uncovered("a derivative of a function at other arguments");
            }
            let derivative = self.as_scalar(&value)?;
            let Jet(f, orders) = self.pool.node(derivative).0.clone() else {
                return Err(malformed("only a derivative of an unknown function takes other arguments"));
            };
            let arguments = self.scalars(reader, orders.len())?;
            return Ok(Value::of(0, self.pool.make(Jet(f, orders), arguments)));
        }
        Ok(value)
    }

    /// Reads values separated by commas.
    pub(crate) fn values(&mut self, reader: &mut Reader) -> Result<Vec<Value>, Stop> {
        let mut values = vec![self.sum(reader)?];
        while reader.take(",") {
            values.push(self.sum(reader)?);
        }
        Ok(values)
    }

    fn calculus(&mut self, name: &str, reader: &mut Reader) -> Result<Value, Stop> {
        let values = self.values(reader)?;
        let along: Vec<usize> = (0..self.variables.len()).filter(|v| self.variables[*v].1).collect();
        let pool = &mut self.pool;
        let is_field = |value: &Value| value.kind == Kind::Field || value.terms.is_empty();
        let is_form = |value: &Value| value.kind == Kind::Form;
        let is_meant = match (name, values.as_slice()) {
            ("d", [w]) => is_form(w),
            ("interior", [x, w]) => is_field(x) && is_form(w),
            ("lie" | "bracket", [x, w]) => is_field(x) && w.kind != Kind::Quadratic,
            ("pair", [w, fields @ ..]) => is_form(w) && fields.iter().all(is_field),
            _ => false,
        };
        if !is_meant {
            return Err(malformed(format!("`{name}` does not accept these arguments")));
        }
        match (name, values.as_slice()) {
            ("d", [w]) => Ok(w.exterior(pool, &along)),
            ("interior", [x, w]) => Ok(w.interior(pool, x)),
            ("lie" | "bracket", [x, w]) => Ok(w.lie(pool, x, &along)),
            ("pair", [w, fields @ ..]) => Ok(fields.iter().fold(w.clone(), |w, x| w.interior(pool, x))),
            _ => Err(malformed(format!("wrong number of arguments of `{name}`"))),
        }
    }

    /// Reads a form and returns its pullback, with the source coordinates of the map. The
    /// conditions of the form are required at the image points, and so are the target chart's
    /// conditions.
    pub(crate) fn pulled_back(&mut self, reader: &mut Reader) -> Result<(Value, Vec<usize>), Stop> {
        let name = reader.name()?;
        let (source, images, bound, scope) = match self.names.get(&name).cloned() {
            Some(Named::Map(source, images, bound, scope)) => (source, images, bound, scope),
            Some(Named::Uncovered(what)) => return uncovered(what),
            _ => return Err(malformed(format!("`{name}` is not a map"))),
        };
        reader.expect(",")?;
        // conditions that a statement places on its points do not hold for their images
        let given = std::mem::take(&mut self.given);
        let read = self.apart(|theory| theory.sum(reader));
        self.given = given;
        let (value, inner) = read?;
        if value.kind != Kind::Form {
            return Err(malformed("`pullback` takes a form"));
        }
        self.scope.integrates |= inner.integrates;
        if inner.is_narrowed {
            return uncovered("the pullback of an antiderivative that is not defined for every parameter");
        }
        self.require_at(&inner.conditions, &images);
        self.require_at(&bound, &images);
        self.require_all(&scope);
        self.scope.used.extend(inner.used.into_iter().filter(|v| !images.contains_key(v)));
        Ok((value.pullback(&mut self.pool, &images, &source), source))
    }
}
