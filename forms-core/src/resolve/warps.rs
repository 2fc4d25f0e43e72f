//! Warps: a map from uniform random numbers and the density of its values become a map, statements
//! and kernels.
//!
//! ```text
//! warp w(p; u, v) = (x, y, z) onto C density E of F inverse (a, b)
//!   ├─ map w                        the components, on 0 < u < 1, 0 < v < 1
//!   ├─ prove w_density, w_inverse   pullback(w, E*F) == ±du^dv; pullback(w, a) == u, pullback(w, b) == v
//!   └─ kernels w_sample(p, u, v), w_pdf(p, x, y, z), w_inverse(p, x, y, z)
//! ```
//! `by` gives an equal form of the components, from which `w_sample` is computed; `within` applies
//! to each kernel. The density vanishes outside the chart, since the map takes no uniform random
//! numbers there.
//!
//! The orientation to claim is chosen from the sign of a value at one point; the claim is then
//! proved like any other.

use super::evaluation::Evaluated;
use super::items::Resolver;
use super::kernel_forms::check_count;
use crate::calculus::{Blade, Coordinate};
use crate::diagnostic::{Diagnostic, counted};
use crate::enclosure::{Enclosure, Precision, Undecided, enclose};
use crate::expression::{Condition, Expr, Pool, Rational, Relation, Seam, Signature, Symbol};
use crate::random::SplitMix;
use crate::syntax::ast::{self, Declared, Item, Name};
use crate::theory::{Chart, Kernel, KernelUnits, Map, Named, Value, Warp};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeSet;

/// Maximum number of points tried for the orientation of a map.
const MOST_POINTS: usize = 200;

/// Precision of these points, and the number of steps in the grid from which they are chosen.
const PRECISION: Precision = Precision(80);
const PARTS: u64 = 997;

/// Variables of a warp while it is resolved.
struct Variables {
    parameters: Vec<Symbol>,
    uniforms: Vec<Coordinate>,
    /// Variables of the target's coordinates.
    target: Vec<Symbol>,
}

impl Resolver {
    pub(super) fn warp(&mut self, item: &Item, warp: &ast::Warp) -> Evaluated<()> {
        let mut locals = Vec::new();
        let result = self.warp_with_locals(item, warp, &mut locals);
        self.forget(locals);
        result
    }

    fn warp_with_locals(&mut self, item: &Item, warp: &ast::Warp, locals: &mut Vec<String>) -> Evaluated<()> {
        self.theory.names.declare(&warp.name, Named::Pending)?;
        let (target, _, _) = self.evaluate(|evaluator| evaluator.chart(&warp.target))?;
        let (_, parameters) = self.kernel_arguments(&warp.parameters, locals)?;
        let uniforms = self.uniforms(&warp.uniforms, locals)?;
        if uniforms.is_empty() {
            return Err(Diagnostic::new(warp.name.span, "a warp needs at least one uniform random number")
                .with_help("uniform random numbers follow the `;`: `warp disk(radius; u, v) = …`"));
        }
        let coordinates = self.theory.charts[target].coordinates.clone();
        let symbol =
            |resolver: &Self, coordinate: &Coordinate| resolver.theory.coordinates[coordinate.0 as usize];
        let target_symbols: Vec<Symbol> = coordinates.iter().map(|c| symbol(self, c)).collect();
        let variables = Variables { parameters, uniforms, target: target_symbols };
        if variables.target.iter().any(|symbol| variables.parameters.contains(symbol)) {
            let message = "a coordinate of a warp's target chart cannot be a parameter of the warp";
            return Err(Diagnostic::new(warp.name.span, message));
        }
        self.map_of_warp(warp, target, &variables)?;
        self.claims_of_warp(item, warp, &variables)?;
        self.kernels_of_warp(item, warp, target, &variables)
    }

    /// Returns coordinates for the uniform random numbers: known coordinates, or new ones that are
    /// local to the warp.
    fn uniforms(&mut self, declared: &[Declared], locals: &mut Vec<String>) -> Evaluated<Vec<Coordinate>> {
        let mut uniforms = Vec::new();
        for Declared { name, .. } in declared {
            let is_new = self.theory.named(&name.text).is_none();
            let coordinate = self.coordinate(name)?;
            if is_new {
                locals.extend([name.text.clone(), format!("d{}", name.text)]);
            }
            if uniforms.contains(&coordinate) {
                return Err(Diagnostic::new(name.span, "this argument occurs twice"));
            }
            uniforms.push(coordinate);
        }
        Ok(uniforms)
    }

    /// Returns the index of the chart of the uniform random numbers: an existing chart with these
    /// coordinates in this order, or a new one that has no name in the file.
    fn square(&mut self, name: &Name, uniforms: &[Coordinate]) -> usize {
        let charts = &mut self.theory.charts;
        if let Some(known) = charts.iter().position(|chart| chart.coordinates == uniforms) {
            return known;
        }
        charts.push(Chart {
            name: name.text.clone(),
            coordinates: uniforms.to_vec(),
            conditions: Vec::new(),
        });
        charts.len() - 1
    }

    fn map_of_warp(&mut self, warp: &ast::Warp, target: usize, variables: &Variables) -> Evaluated<()> {
        let source = self.square(&warp.name, &variables.uniforms);
        let (components, mut domain, used) = self.evaluate(|evaluator| {
            warp.components.iter().map(|component| evaluator.scalar(component)).collect::<Evaluated<Vec<_>>>()
        })?;
        domain.extend(self.conditions(&warp.all_conditions())?);
        let name = warp.name.text.clone();
        let map = Map { name, source, target, components, domain, narrowing: FxHashSet::default(), used };
        self.check_map(&map, &warp.name, &warp.components, &variables.parameters)?;
        self.theory.maps.push(map);
        self.theory.names.set(&warp.name, Named::Map(self.theory.maps.len() - 1));
        Ok(())
    }

    fn claims_of_warp(&mut self, item: &Item, warp: &ast::Warp, variables: &Variables) -> Evaluated<()> {
        if !warp.inverse.is_empty() && warp.inverse.len() != variables.uniforms.len() {
            let (wanted, found) = (variables.uniforms.len(), warp.inverse.len());
            let message = format!(
                "the inverse needs {}, one for each uniform random number, found {found}",
                counted(wanted, "value")
            );
            return Err(Diagnostic::new(warp.name.span, message));
        }
        let reverses = self.reverses(warp, &variables.uniforms)?;
        for claim in warp.claims(item, reverses) {
            self.statement(&claim)?;
        }
        self.theory.warps.push(Warp {
            name: warp.name.text.clone(),
            uniforms: variables.uniforms.len(),
            reverses,
            has_inverse: !warp.inverse.is_empty(),
        });
        Ok(())
    }

    /// Whether the pulled-back density is negative at the first point found that satisfies every
    /// condition.
    fn reverses(&mut self, warp: &ast::Warp, uniforms: &[Coordinate]) -> Evaluated<bool> {
        let left = warp.density_on_the_square();
        let (value, domain, _) = self.evaluate(|evaluator| evaluator.value(&left))?;
        let Value::Form(form) = value else { return Ok(false) };
        let mut blade = (Blade::SCALAR, 1);
        for &uniform in uniforms {
            blade = match blade.0.wedge(Blade::of(uniform)) {
                Some((wedge, sign)) => (wedge, sign * blade.1),
                None => return Ok(false),
            };
        }
        let Some(&coefficient) = form.coefficient(blade.0) else { return Ok(false) };
        let sampled: Vec<Symbol> =
            uniforms.iter().map(|uniform| self.theory.coordinates[uniform.0 as usize]).collect();
        let coefficient = if blade.1 < 0 { self.theory.pool.negate(coefficient) } else { coefficient };
        Ok(is_negative(&self.theory.pool, coefficient, &domain, &sampled))
    }

    fn kernels_of_warp(
        &mut self,
        item: &Item,
        warp: &ast::Warp,
        target: usize,
        variables: &Variables,
    ) -> Evaluated<()> {
        let map = self.theory.maps.last().map(|map| map.components.clone()).unwrap_or_default();
        let uniforms: Vec<Symbol> =
            variables.uniforms.iter().map(|uniform| self.theory.coordinates[uniform.0 as usize]).collect();
        let with_parameters = |others: &[Symbol]| [&variables.parameters, others].concat();
        let stated = self.conditions(&warp.conditions)?;
        let mut on_the_square = self.closed_square(&uniforms);
        on_the_square.extend(&stated);
        let of_the_target = self.theory.charts[target].conditions.clone();
        let on_the_target: Vec<Condition> = of_the_target.iter().chain(&stated).copied().collect();

        let arguments = with_parameters(&uniforms);
        let (computed, _, _) =
            self.evaluate(|evaluator| evaluator.kernel_outputs(&warp.computed, &arguments))?;
        check_count(&map, &computed, &warp.name, item.span)?;
        let docs = "Maps uniform random numbers to a point of the target chart.";
        self.kernel_of_warp(item, warp, ("sample", docs), (arguments, map, computed), &on_the_square)?;

        let arguments = with_parameters(&variables.target);
        let density = std::slice::from_ref(&warp.density);
        let (mut outputs, _, _) = self.evaluate(|evaluator| evaluator.kernel_outputs(density, &arguments))?;
        for output in &mut outputs {
            *output = self.zero_outside(&of_the_target, *output);
        }
        let docs = "Density of the points that the warp maps uniform random numbers to; zero outside the domain of \
                    the target chart.";
        self.kernel_of_warp(item, warp, ("pdf", docs), (arguments.clone(), outputs, Vec::new()), &stated)?;

        if warp.inverse.is_empty() {
            return Ok(());
        }
        let (outputs, _, _) =
            self.evaluate(|evaluator| evaluator.kernel_outputs(&warp.inverse, &arguments))?;
        let docs = "Uniform random numbers that the warp maps to a given point.";
        self.kernel_of_warp(item, warp, ("inverse", docs), (arguments, outputs, Vec::new()), &on_the_target)
    }

    /// Returns the value where the conditions hold, and zero elsewhere.
    fn zero_outside(&mut self, conditions: &[Condition], value: Expr) -> Expr {
        let pool = &mut self.theory.pool;
        let zero = pool.integer(0);
        conditions.iter().rev().fold(value, |value, condition| {
            let relation = (condition.left, condition.relation, condition.right);
            pool.select(relation, value, zero, Seam::Jumps)
        })
    }

    /// Returns the conditions 0 ≤ u ≤ 1 for each uniform random number.
    fn closed_square(&mut self, uniforms: &[Symbol]) -> Vec<Condition> {
        let pool = &mut self.theory.pool;
        let (zero, one) = (pool.integer(0), pool.integer(1));
        let mut conditions = Vec::new();
        for &uniform in uniforms {
            let left = pool.symbol(uniform);
            conditions.push(Condition { left, relation: Relation::GreaterEqual, right: zero });
            conditions.push(Condition { left, relation: Relation::LessEqual, right: one });
        }
        conditions
    }

    /// Adds the kernel `NAME_part`; its domain consists of the conditions that involve its
    /// arguments only.
    fn kernel_of_warp(
        &mut self,
        item: &Item,
        warp: &ast::Warp,
        (part, sentence): (&str, &str),
        (arguments, outputs, computed): (Vec<Symbol>, Vec<Expr>, Vec<Expr>),
        conditions: &[Condition],
    ) -> Evaluated<()> {
        let within = warp.within.as_ref().map(|within| self.positive_number(within)).transpose()?;
        let name = warp.part(part);
        self.theory.names.declare(&name, Named::Kernel(self.theory.kernels.len()))?;
        let pool = &self.theory.pool;
        let speaks_of_them = |condition: &&Condition| {
            let symbols = pool.symbols_in(&[condition.left, condition.right]);
            symbols.iter().all(|symbol| arguments.contains(symbol))
        };
        let domain: Vec<Condition> = conditions.iter().filter(speaks_of_them).copied().collect();
        let mut docs = item.docs.clone();
        if !docs.is_empty() {
            docs.push(String::new());
        }
        docs.push(sentence.to_owned());
        let formula = pool.texts(&outputs);
        let names: Vec<String> =
            arguments.iter().map(|&argument| pool.symbol_name(argument).to_owned()).collect();
        self.theory.kernels.push(Kernel {
            name: name.text,
            docs,
            public: item.public,
            span: item.span,
            signature: Signature::of_numbers(&names, outputs.len()),
            arguments,
            outputs,
            computed,
            approximation: None,
            target_forms: Vec::new(),
            domain,
            within,
            effects: Vec::new(),
            formula,
            units: KernelUnits::default(),
            statements: Vec::new(),
            mentioned: BTreeSet::from([warp.name.text.clone()]),
            defined: Vec::new(),
        });
        Ok(())
    }
}

/// Whether an expression is negative at the first point found that satisfies the conditions and
/// where the sign is decided.
fn is_negative(pool: &Pool, expression: Expr, conditions: &[Condition], uniforms: &[Symbol]) -> bool {
    let mut expressions = vec![expression];
    expressions.extend(conditions.iter().flat_map(|condition| [condition.left, condition.right]));
    let symbols = pool.symbols_in(&expressions);
    let mut random = SplitMix(1);
    let mut signs = (0..MOST_POINTS).filter_map(|_| {
        let point: FxHashMap<Symbol, Enclosure> = symbols
            .iter()
            .map(|&symbol| {
                let unit = Rational::new((random.next() % PARTS).into(), PARTS.into());
                let four = Rational::from_integer(4.into());
                let value = if uniforms.contains(&symbol) {
                    unit
                } else {
                    unit * four - Rational::from_integer(2.into())
                };
                (symbol, Enclosure::exact(&value, PRECISION))
            })
            .collect();
        let of = |symbol: Symbol| point.get(&symbol).cloned();
        let values = enclose(pool, &expressions, &of, &mut |_, _, _| None, PRECISION);
        let [value, sides @ ..] = values.as_slice() else { return None };
        let holds = |(condition, side): (&Condition, &[Result<Enclosure, Undecided>])| match side {
            [Ok(left), Ok(right)] => left.decide(condition.relation, right) == Some(true),
            _ => false,
        };
        let inside = conditions.iter().zip(sides.chunks_exact(2)).all(holds);
        let value = value.as_ref().ok().filter(|value| inside && !value.contains_zero())?;
        Some(value.is_negative())
    });
    signs.next().unwrap_or(false)
}
