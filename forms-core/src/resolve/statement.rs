//! Statements: their claims, and the kernels to which they are relevant.

use super::evaluation::Evaluated;
use super::items::Resolver;
use crate::diagnostic::{Diagnostic, Kind};
use crate::expression::{Condition, Expr, Nature, Node, Operation, Relation, Symbol, SymbolKind};
use crate::syntax::ast::{Claim, Item, ItemKind};
use crate::theory::{Named, Statement, Value};
use std::collections::BTreeSet;

impl Resolver {
    pub(super) fn statement(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Statement { claim, name, left, right, conditions } = &item.kind else { return Ok(()) };
        if self.statement_names.contains(&name.text) {
            return Err(Diagnostic::new(
                name.span,
                format!("a statement named `{}` exists already", name.text),
            ));
        }
        let evaluated = self.evaluate(|evaluator| {
            let mut own = Vec::new();
            for condition in conditions {
                own.extend(evaluator.conditions(condition)?);
            }
            evaluator.given = own.clone();
            let sides = (evaluator.value(left)?, evaluator.value(right)?);
            comparable(&sides.0, &sides.1).map_err(|message| Diagnostic::new(item.span, message))?;
            Ok((sides, own, evaluator.scope.mentioned().clone()))
        });
        let (evaluated, obstacle) = match evaluated {
            Err(diagnostic) if diagnostic.kind == Kind::Open => {
                let nothing = ((Value::Zero, Value::Zero), Vec::new(), BTreeSet::new());
                ((nothing, Vec::new(), Vec::new()), Some(diagnostic.message))
            }
            evaluated => (evaluated?, None),
        };
        let (((left, right), mut own, mentioned), mut domain, used) = evaluated;
        self.require_divisors(&mut domain, [&left, &right], &own);
        own.extend(self.chart_conditions(&used));
        self.statement_names.insert(name.text.clone());
        self.theory.statements.push(Statement {
            name: name.text.clone(),
            docs: item.docs.clone(),
            claim: *claim,
            span: item.span,
            name_span: name.span,
            left,
            right,
            obstacle,
            conditions: own,
            domain,
            mentioned,
        });
        Ok(())
    }

    /// Adds the conditions that absolute values and roots in denominators of the sides and
    /// conditions are not zero: a derivative can divide by them where the differentiated function
    /// does not.
    fn require_divisors(&mut self, domain: &mut Vec<Condition>, sides: [&Value; 2], own: &[Condition]) {
        let mut scalars: Vec<Expr> = sides.into_iter().flat_map(Value::scalars).collect();
        scalars.extend(own.iter().flat_map(|condition| [condition.left, condition.right]));
        for condition in self.theory.pool.domain(&scalars) {
            let is_divisor = match (self.theory.pool.node(condition.left), condition.relation) {
                (Node::Apply(Operation::Abs, _) | Node::Power(..), Relation::NotEqual) => true,
                (_, Relation::Greater) => self.theory.pool.nature(condition.left) == Nature::NotNegative,
                _ => false,
            };
            if is_divisor && !domain.contains(&condition) {
                domain.push(condition);
            }
        }
    }

    /// Returns the conditions of chart domains whose coordinates are all used.
    fn chart_conditions(&self, used: &[Symbol]) -> Vec<Condition> {
        let mut found: Vec<Condition> = Vec::new();
        for chart in &self.theory.charts {
            let own = chart.coordinates.iter().map(|c| self.theory.coordinates[c.0 as usize]);
            if !own.into_iter().any(|symbol| used.contains(&symbol)) {
                continue;
            }
            for condition in &chart.conditions {
                let mentioned = self.theory.pool.symbols_in(&[condition.left, condition.right]);
                let mut coordinates = mentioned
                    .into_iter()
                    .filter(|symbol| self.theory.pool.symbol_kind(*symbol) == SymbolKind::Coordinate);
                if coordinates.all(|symbol| used.contains(&symbol)) && !found.contains(condition) {
                    found.push(*condition);
                }
            }
        }
        found
    }

    /// Assigns to each kernel the `prove` statements that mention a map it uses or, if it uses no
    /// map, a value it uses; also the statements that mention nothing but maps and values of the
    /// kernel.
    pub(super) fn attribute_statements(&mut self) {
        let theory = &mut self.theory;
        for kernel in &mut theory.kernels {
            let is_map = |name: &&String| matches!(theory.names.get(name), Some(Named::Map(_)));
            let maps: BTreeSet<&String> = kernel.mentioned.iter().filter(is_map).collect();
            let speaks_of_it = |statement: &&Statement| {
                let shared = statement.mentioned.intersection(&kernel.mentioned).collect::<BTreeSet<_>>();
                let whole = !shared.is_empty() && shared.len() == statement.mentioned.len();
                let relevant = if maps.is_empty() { !shared.is_empty() } else { !shared.is_disjoint(&maps) };
                statement.claim == Claim::Prove && (whole || relevant)
            };
            kernel.statements = theory
                .statements
                .iter()
                .filter(speaks_of_it)
                .map(|statement| statement.name.clone())
                .collect();
        }
    }
}

fn comparable(left: &Value, right: &Value) -> Result<(), String> {
    let alike = match (left, right) {
        (Value::Zero, _) | (_, Value::Zero) => true,
        (Value::Scalar(_), Value::Scalar(_)) | (Value::Field(_), Value::Field(_)) => true,
        (Value::Form(a), Value::Form(b)) => a.degree() == b.degree(),
        _ => false,
    };
    if alike { Ok(()) } else { Err(format!("cannot compare {} with {}", left.kind(), right.kind())) }
}
