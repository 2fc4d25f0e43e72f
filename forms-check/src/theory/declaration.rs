//! Items of a file: each declares a name or records a statement for later. An item that is not
//! understood is an obstacle to the statements that use it.

use super::{Chart, Condition, MOST_VARIABLES, Named, Scope, Theory};
use crate::tokens::Reader;
use crate::{Claim, Stop, malformed, uncovered};
use std::collections::{BTreeSet, HashMap};

impl Theory {
    pub(super) fn item(&mut self, reader: &mut Reader) -> Result<(), Stop> {
        reader.word("pub");
        let keyword = reader.name()?;
        if keyword == "kernel" {
            reader.pass_item();
            return Ok(());
        }
        if keyword == "param" {
            return self.parameters(reader);
        }
        let (name, start) = (reader.name()?, reader.place);
        if keyword == "warp" {
            reader.pass_item();
            for what in ["density", "inverse"] {
                self.add_statement(format!("{name}_{what}"), Claim::Prove, None);
            }
            self.declare(&name, Named::Uncovered("a warp".into()));
            return Ok(());
        }
        let claim = match keyword.as_str() {
            "prove" => Some(Claim::Prove),
            "refute" => Some(Claim::Refute),
            _ => None,
        };
        if let Some(claim) = claim {
            reader.expect(":")?;
            self.add_statement(name, claim, Some(reader.clone()));
            reader.pass_item();
            return Ok(());
        }
        self.declare(&name, Named::Uncovered("a declaration within itself".into()));
        let named = match keyword.as_str() {
            "chart" => self.chart(reader),
            "fn" => self.unknown_function(&name, reader),
            "let" | "form" | "field" => self.object(reader),
            "map" => self.map(reader),
            "metric" => self.metric(reader),
            other => return uncovered(format!("`{other}`")),
        };
        // a declaration that is not understood is an obstacle only to items that use it
        let named = named.and_then(|named| reader.expect(";").map(|()| named)).unwrap_or_else(|stop| {
            reader.place = start;
            reader.pass_item();
            Named::Uncovered(stop.into_text())
        });
        if keyword != "fn" && reader.defines_by(&name, start) {
            self.fault.get_or_insert(format!("the declaration of `{name}` uses its own name"));
        }
        self.names.insert(name, named);
        Ok(())
    }

    /// Reads a chart. If its domain is not understood, items that use its coordinates are not
    /// covered.
    fn chart(&mut self, reader: &mut Reader) -> Result<Named, Stop> {
        let (mut coordinates, mut conditions) = (vec![], vec![]);
        if reader.take("=") {
            for factor in reader.names("*")? {
                let (more, bound) = self.chart_named(&factor)?;
                coordinates.extend(more);
                conditions.extend(bound);
            }
        } else {
            reader.expect("(")?;
            for name in reader.names(",")? {
                coordinates.push(self.coordinate(&name)?);
            }
            reader.expect(")")?;
        }
        if (0..coordinates.len()).any(|n| coordinates[..n].contains(&coordinates[n])) {
            self.fault.get_or_insert("a coordinate occurs twice in a chart".into());
        }
        match self.domain(reader).and_then(|own| reader.following(";").map(|()| own)) {
            Ok(own) => conditions.extend(own),
            Err(stop) => {
                for v in coordinates {
                    let name = self.variables[v].0.clone();
                    let why = Named::Uncovered("a chart whose domain is not understood".into());
                    self.names.insert(format!("d{name}"), why.clone());
                    self.names.insert(name, why);
                }
                return Err(stop);
            }
        }
        self.charts.push((coordinates.clone(), conditions.clone()));
        Ok(Named::Chart((coordinates, conditions)))
    }

    /// Returns the coordinate with this name, a new one if necessary.
    fn coordinate(&mut self, name: &str) -> Result<usize, Stop> {
        match self.names.get(name) {
            Some(Named::Variable(v)) if self.variables[*v].1 => Ok(*v),
            Some(Named::Uncovered(what)) => uncovered(what.clone()),
            _ => {
                let number = self.new_variable(name, true)?;
                self.declare(&format!("d{name}"), Named::Differential(number));
                Ok(number)
            }
        }
    }

    pub(crate) fn chart_named(&self, name: &str) -> Result<Chart, Stop> {
        match self.names.get(name) {
            Some(Named::Chart(chart)) => Ok(chart.clone()),
            _ => Err(malformed(format!("`{name}` is not a chart"))),
        }
    }

    pub(super) fn new_variable(&mut self, name: &str, is_coordinate: bool) -> Result<usize, Stop> {
        if self.variables.len() == MOST_VARIABLES {
            return Err(malformed(format!("more than {MOST_VARIABLES} variables")));
        }
        self.variables.push((name.to_string(), is_coordinate));
        self.declare(name, Named::Variable(self.variables.len() - 1));
        Ok(self.variables.len() - 1)
    }

    pub(crate) fn variable(&self, name: &str) -> Result<usize, Stop> {
        match self.names.get(name) {
            Some(Named::Variable(number)) => Ok(*number),
            _ => Err(malformed(format!("`{name}` is not a coordinate or param"))),
        }
    }

    /// Reads params with the conditions that constrain them, directly or through others of the same
    /// declaration.
    fn parameters(&mut self, reader: &mut Reader) -> Result<(), Stop> {
        let names = reader.names(",")?;
        let numbers: Vec<usize> =
            names.iter().map(|name| self.new_variable(name, false)).collect::<Result<_, _>>()?;
        let domain = self.domain(reader).and_then(|own| reader.following(";").map(|()| own));
        let Ok(conditions) = domain else {
            for name in names {
                self.names.insert(name, Named::Uncovered("a param whose condition is not understood".into()));
            }
            reader.pass_item();
            return Ok(());
        };
        for number in &numbers {
            let (mut reached, mut found): (_, Vec<Condition>) = (BTreeSet::from([*number]), vec![]);
            while let Some(next) = conditions.iter().find(|condition| {
                !found.contains(condition) && !self.pool.variables(condition.0).is_disjoint(&reached)
            }) {
                found.push(*next);
                reached.extend(self.pool.variables(next.0).into_iter().filter(|v| numbers.contains(v)));
            }
            self.params.insert(*number, found);
        }
        reader.expect(";")
    }

    fn unknown_function(&mut self, name: &str, reader: &mut Reader) -> Result<Named, Stop> {
        reader.expect("(")?;
        let arguments = reader.names(",")?.iter().map(|a| self.variable(a)).collect::<Result<_, _>>()?;
        reader.expect(")")?;
        let number = self.functions.len();
        self.functions.push((arguments, vec![]));
        self.names.insert(name.to_string(), Named::Function(number));
        reader.pass_unit();
        self.functions[number].1 = self.domain(reader)?;
        Ok(Named::Function(number))
    }

    fn object(&mut self, reader: &mut Reader) -> Result<Named, Stop> {
        while !reader.take("=") {
            reader.place += 1;
            if reader.peek().is_none() {
                return Err(reader.wrong("="));
            }
        }
        let value = self.sum(reader)?;
        Ok(Named::Object(value, std::mem::take(&mut self.scope)))
    }

    fn map(&mut self, reader: &mut Reader) -> Result<Named, Stop> {
        reader.expect(":")?;
        let (source, _) = self.chart_named(&reader.name()?)?;
        reader.expect("->")?;
        let (target, bound) = self.chart_named(&reader.name()?)?;
        reader.expect("=")?;
        reader.expect("(")?;
        let mut images = HashMap::new();
        for (number, coordinate) in target.into_iter().enumerate() {
            if number > 0 {
                reader.expect(",")?;
            }
            images.insert(coordinate, self.scalar(reader)?);
        }
        reader.expect(")")?;
        Ok(Named::Map(source, images, bound, std::mem::take(&mut self.scope)))
    }

    /// Reads the relations of a `where`, followed by the conditions under which their sides are
    /// defined.
    pub(super) fn domain(&mut self, reader: &mut Reader) -> Result<Vec<Condition>, Stop> {
        self.scope = Scope::default();
        let mut all = self.bounds(reader)?;
        all.append(&mut self.scope.conditions);
        Ok(all)
    }

    pub(super) fn bounds(&mut self, reader: &mut Reader) -> Result<Vec<Condition>, Stop> {
        let mut all = Vec::new();
        while if all.is_empty() { reader.word("where") } else { reader.take(",") } {
            all.extend(self.relations(reader)?);
        }
        Ok(all)
    }
}
