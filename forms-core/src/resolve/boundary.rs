//! `boundary_integral(F, w, u = a..b, v = c..e)`: the integral over the faces of a box with the
//! induced orientation.

use super::evaluation::{Evaluated, Evaluator};
use super::integration::Range;
use crate::calculus::{Coordinate, Form, Pullback, pullback};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Substitution};
use crate::syntax::ast::Argument;
use crate::theory::Value;

/// Form pulled back to the box, with the coordinates of the map's source chart.
struct OnBox {
    form: Form<Expr>,
    source: Vec<Coordinate>,
    /// Conditions under which the form and the bounds are defined.
    defined: Vec<Condition>,
}

impl Evaluator<'_> {
    /// Integrates a form over the boundary of a box. With the variables uᵢ from outermost to
    /// innermost and bounds that depend on outer variables,
    /// ∫_∂D η = Σᵢ (−1)^(i−1) (∫ η|uᵢ = bᵢ − ∫ η|uᵢ = aᵢ). Each face is parametrised by the other
    /// variables.
    pub(super) fn boundary_integral(&mut self, arguments: &[Argument], span: Span) -> Evaluated<Value> {
        let [Argument::Value(map), Argument::Value(form), ranges @ ..] = arguments else {
            return Err(Diagnostic::new(span, "`boundary_integral` takes a map and a form first")
                .with_help("boundary_integral(F, w, u = 0..1, v = 0..1)"));
        };
        if ranges.is_empty() {
            return Err(Diagnostic::new(span, "`boundary_integral` needs at least one range"));
        }
        let (ranges, bounds) = self.ranges(ranges)?;
        let chart = self.map(map)?.source;
        self.check_ranges(chart, &ranges)?;
        let (value, scope) = self.apart(|evaluator| evaluator.pull(&[map, form], span))?;
        let Some(form) = self.form_on_boundary(value, form.span, ranges.len())? else {
            return Ok(Value::Scalar(self.zero()));
        };
        let source = self.theory.charts[chart].coordinates.clone();
        let defined = bounds.conditions().iter().chain(scope.conditions()).copied().collect();
        let on_box = OnBox { form, source, defined };
        let mut sum = self.zero();
        for place in 0..ranges.len() {
            for upper in [true, false] {
                let face = self.face_integral(&on_box, &ranges, (place, upper), span)?;
                let outward = upper == (place % 2 == 0);
                let signed = if outward { face } else { self.theory.pool.negate(face) };
                sum = self.theory.pool.add(sum, signed);
            }
        }
        self.keep_outside(&bounds, &ranges);
        self.keep_outside(&scope, &ranges);
        Ok(Value::Scalar(sum))
    }

    /// Converts the value to a form whose degree is the dimension of the boundary; `None` for the
    /// literal zero.
    fn form_on_boundary(
        &mut self,
        value: Value,
        span: Span,
        dimension: usize,
    ) -> Evaluated<Option<Form<Expr>>> {
        let form = match value {
            Value::Zero => return Ok(None),
            Value::Scalar(f) => Form::scalar(&self.ring(), f),
            Value::Form(form) => form,
            Value::Field(_) | Value::Array(_) => return Err(Diagnostic::new(span, "expected a form")),
        };
        if form.degree() as usize + 1 != dimension {
            let message = format!(
                "the boundary of a box of dimension {dimension} takes a {}-form, found degree {}",
                dimension - 1,
                form.degree()
            );
            return Err(Diagnostic::new(span, message));
        }
        Ok(Some(form))
    }

    fn check_ranges(&self, chart: usize, ranges: &[Range]) -> Evaluated<()> {
        self.blade_of(ranges)?;
        let chart = &self.theory.charts[chart];
        for range in ranges {
            if !chart.coordinates.contains(&self.coordinate(&range.name)?) {
                return Err(Diagnostic::new(
                    range.name.span,
                    format!("`{}` is not a coordinate of `{}`", range.name.text, chart.name),
                )
                .with_help("the variables of the ranges must be coordinates of the map's source chart"));
            }
        }
        Ok(())
    }

    /// Integrates over the face where one variable equals its upper or lower bound, as a function
    /// of the outer variables.
    fn face_integral(
        &mut self,
        on_box: &OnBox,
        ranges: &[Range],
        (place, upper): (usize, bool),
        span: Span,
    ) -> Evaluated<Expr> {
        let fixed = &ranges[place];
        let bound = if upper { fixed.to } else { fixed.from };
        let at_face: Substitution = [(fixed.symbol, bound)].into_iter().collect();
        let coordinate = self.coordinate(&fixed.name)?;
        let composed = self.composed_form(&on_box.form, &at_face);
        let mut ring = self.ring();
        let face = Pullback::new(&mut ring, &[(coordinate, bound)], &on_box.source);
        let on_face = pullback(&mut ring, &face, &composed, |_, value| *value);
        let rest: Vec<Range> = ranges
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != place)
            .map(|(_, range)| {
                let bounds = self.theory.pool.substitute_all(&[range.from, range.to], &at_face);
                Range { from: bounds[0], to: bounds[1], ..range.clone() }
            })
            .collect();
        let blade = self.blade_of(&rest)?;
        let coefficient = self.signed_coefficient(&on_face, blade);
        let conditions = on_box.defined.iter();
        let defined: Vec<Condition> =
            conditions.map(|condition| condition.substitute(&mut self.theory.pool, &at_face)).collect();
        self.iterated(coefficient, &rest, &defined, span)
    }
}
