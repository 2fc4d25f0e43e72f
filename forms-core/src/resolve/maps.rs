//! Maps between charts: one scalar for each coordinate of the target, in the coordinates of the source.

use super::evaluation::Evaluated;
use super::items::Resolver;
use crate::calculus::Coordinate;
use crate::diagnostic::{Diagnostic, counted};
use crate::expression::{Expr, Symbol};
use crate::syntax::ast::{self, Name};
use crate::theory::{Map, Named};

impl Resolver {
    pub(super) fn map(
        &mut self,
        name: &Name,
        source: &Name,
        target: &Name,
        components: &[ast::Expr],
    ) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        let (mut map, domain, used) = self.evaluate(|evaluator| {
            let (source, target) = (evaluator.chart(source)?, evaluator.chart(target)?);
            let values: Vec<Expr> =
                components.iter().map(|component| evaluator.scalar(component)).collect::<Evaluated<_>>()?;
            let name = name.text.clone();
            let narrowing = evaluator.scope.narrowing().clone();
            Ok(Map { name, source, target, components: values, domain: vec![], narrowing, used: vec![] })
        })?;
        self.check_map(&map, name, components, &[])?;
        (map.domain, map.used) = (domain, used);
        self.theory.maps.push(map);
        self.theory.names.set(name, Named::Map(self.theory.maps.len() - 1));
        Ok(())
    }

    /// Checks that a map has one component for each target coordinate, and that each component is a
    /// function of the source's coordinates and of these parameters.
    pub(super) fn check_map(
        &mut self,
        map: &Map,
        name: &Name,
        components: &[ast::Expr],
        parameters: &[Symbol],
    ) -> Evaluated<()> {
        let (source, target) = (self.theory.charts[map.source].clone(), &self.theory.charts[map.target]);
        if components.len() != target.coordinates.len() {
            let names: Vec<&str> =
                target.coordinates.iter().map(|c| self.theory.coordinate_name(*c)).collect();
            return Err(Diagnostic::new(
                name.span,
                format!(
                    "a map to `{}` needs {} ({}), found {}",
                    target.name,
                    counted(names.len(), "component"),
                    names.join(", "),
                    components.len()
                ),
            ));
        }
        for (value, written) in map.components.iter().zip(components) {
            let (foreign, _, _) = self.evaluate(|evaluator| {
                let found = evaluator.theory.coordinates_in(&[*value]);
                let is_parameter =
                    |c: &Coordinate| parameters.contains(&evaluator.theory.coordinates[c.0 as usize]);
                Ok(found.into_iter().find(|c| !source.coordinates.contains(c) && !is_parameter(c)))
            })?;
            if let Some(foreign) = foreign {
                let foreign = self.theory.coordinate_name(foreign);
                return Err(Diagnostic::new(
                    written.span,
                    format!("`{foreign}` is not a coordinate of the chart `{}`", source.name),
                )
                .with_help("a map's components depend on the coordinates of its source chart"));
            }
        }
        Ok(())
    }
}
