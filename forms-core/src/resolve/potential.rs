//! `potential(w)`: Poincaré's homotopy operator about the origin, K w = ∫₀¹ tᵏ⁻¹ i_X w(tx) dt with
//! X = Σ xⁱ ∂ᵢ.
//!
//! Integrating L_X = d i_X + i_X d along the dilations x ↦ tx gives K d + d K = 1 on forms of
//! degree k ≥ 1.

use super::arguments::exactly;
use super::evaluation::{Evaluated, Evaluator};
use crate::calculus::{Coordinate, Field, Form, interior};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Relation, Substitution, Symbol, SymbolKind};
use crate::integral::{Region, power_integral};
use crate::syntax::ast;
use crate::theory::Value;

impl Evaluator<'_> {
    pub(super) fn potential(
        &mut self,
        index: Option<&ast::Expr>,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let [argument] = exactly::<1>(arguments, "potential", span)?;
        // the statement's conditions on its points do not hold on the segments from the origin to
        // them
        let given = std::mem::take(&mut self.given);
        let value = self.value(argument);
        self.given = given;
        let form = match value? {
            Value::Zero | Value::Scalar(_) => return Ok(Value::Zero),
            Value::Form(form) => form,
            other @ (Value::Field(_) | Value::Array(_)) => {
                let message = format!("`potential` takes a form, and this is {}", other.kind());
                return Err(Diagnostic::new(argument.span, message));
            }
        };
        let coordinates = match index {
            Some(chart) => self.chart_coordinates(chart)?,
            None => self.coordinates_of(&form, argument.span)?,
        };
        let t = self.theory.pool.declare_symbol("t", SymbolKind::Local);
        let mut terms = Vec::with_capacity(form.terms().len());
        for (blade, coefficient) in form.terms() {
            let integral = self.radial_integral(*coefficient, form.degree(), &coordinates, t);
            let integral = integral.map_err(|reason| {
                Diagnostic::new(argument.span, format!("cannot integrate along the rays: {reason}"))
            })?;
            terms.push((*blade, integral));
        }
        let integrated = Form::from_terms(form.degree(), terms);
        let dilation = self.dilation(&coordinates);
        let zero = self.zero();
        Ok(Value::from_form(interior(&mut self.ring(), &dilation, &integrated), zero))
    }

    /// Returns the dilation field Σ xⁱ ∂ᵢ.
    fn dilation(&mut self, coordinates: &[Coordinate]) -> Field<Expr> {
        let mut field = Field::zero();
        for &coordinate in coordinates {
            let x = self.theory.pool.symbol(self.theory.coordinates[coordinate.0 as usize]);
            let mut ring = self.ring();
            let part = Field::along(&ring, coordinate, x);
            field = field.add(&mut ring, &part);
        }
        field
    }

    /// Evaluates ∫₀¹ tᵏ⁻¹ c(tx) dt. A homogeneous term of degree m ≠ −k gives c/(m + k), whether or
    /// not the integral converges.
    fn radial_integral(
        &mut self,
        coefficient: Expr,
        degree: u32,
        coordinates: &[Coordinate],
        t: Symbol,
    ) -> Result<Expr, String> {
        let symbols: Vec<Symbol> =
            coordinates.iter().map(|c| self.theory.coordinates[c.0 as usize]).collect();
        self.require_domains(&[coefficient], &[]);
        let pool = &mut self.theory.pool;
        let at = pool.symbol(t);
        let dilated: Substitution = symbols
            .into_iter()
            .map(|symbol| {
                let x = pool.symbol(symbol);
                (symbol, pool.multiply(at, x))
            })
            .collect();
        let (zero, one) = (pool.integer(0), pool.integer(1));
        let composed = pool.substitute(coefficient, &dilated);
        let power = pool.power(at, i64::from(degree - 1).into());
        let integrand = pool.multiply(power, composed);
        let defined: Vec<Condition> = self.scope.conditions().to_vec();
        let mut conditions: Vec<Condition> = defined.iter().chain(&self.given).copied().collect();
        conditions.push(Condition { left: at, relation: Relation::Greater, right: zero });
        if let Some(integral) = power_integral(pool, integrand, t, &conditions)? {
            return Ok(integral);
        }
        conditions.push(Condition { left: at, relation: Relation::LessEqual, right: one });
        let mut region = Region { ranges: vec![(t, zero, one)], conditions };
        let along: Vec<Condition> =
            defined.iter().map(|condition| condition.substitute(pool, &dilated)).collect();
        if let Some(condition) = region.unmet(pool, integrand, &along) {
            return Err(format!(
                "it is not known that `{}` holds on the segment from the origin",
                condition.text(pool)
            ));
        }
        let found = region.integral(pool, integrand)?;
        self.narrow(found.conditions);
        Ok(found.value)
    }

    /// Returns the coordinates of the form's chart: the only chart with exactly the occurring
    /// coordinates, or else the only one that contains all of them.
    fn coordinates_of(&mut self, form: &Form<Expr>, span: Span) -> Evaluated<Vec<Coordinate>> {
        let occurring = self.theory.coordinates_of(form);
        let fitting = self.theory.charts_with(&occurring);
        let charts = &self.theory.charts;
        let exact: Vec<usize> = fitting
            .iter()
            .copied()
            .filter(|&number| charts[number].coordinates.len() == occurring.len())
            .collect();
        match (exact.as_slice(), fitting.as_slice()) {
            ([chart], _) | ([], [chart]) => Ok(charts[*chart].coordinates.clone()),
            ([], []) => Err(Diagnostic::new(span, "no chart has all coordinates of this form")
                .with_help("name the chart to contract along: potential[C](w)")),
            _ => {
                let names: Vec<&str> = fitting.iter().map(|&chart| charts[chart].name.as_str()).collect();
                Err(Diagnostic::new(span, format!("several charts fit this form: {}", names.join(", ")))
                    .with_help(format!("name the one to contract along: potential[{}](w)", names[0])))
            }
        }
    }
}
