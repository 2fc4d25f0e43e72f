//! Notebook display: a plan and its answers as tables, a map as a picture.

use super::{measured, png, rough, total};
use crate::answer::{Answer, Layout, Map, Simulation};
use crate::effects::PlannedEffect;
use crate::plan::Plan;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use forms::core::notebook::{Table, print_content};

impl Plan {
    /// Returns a table with a row for each effect: whether it is simulated, the change that
    /// omitting it can cause, and the reason.
    pub fn table(&self) -> Table {
        let extent = |planned: &PlannedEffect| match (planned.on, planned.orders) {
            (false, _) => "off".to_owned(),
            (true, None) => "on".to_owned(),
            (true, Some(orders)) => format!("on, up to order {orders}"),
        };
        let row = |planned: &PlannedEffect| {
            let bound = planned.bound.map_or_else(|| "unknown".to_owned(), rough);
            [planned.effect.name().to_owned(), extent(planned), bound, planned.why.clone()]
        };
        Table::new(["effect", "simulated", "bound on omitted part", "why"], self.effects().iter().map(row))
    }

    /// Displays the plan in a notebook cell.
    pub fn evcxr_display(&self) {
        self.table().evcxr_display();
    }
}

impl Simulation {
    /// Returns a table with a row for each number and its error. Times are omitted, since they
    /// differ from run to run.
    pub fn table(&self) -> Table {
        let number = |number: Option<usize>| number.map_or_else(String::new, |number| number.to_string());
        let row = |answer: &Answer| {
            let [value, error] = measured(answer.value, answer.error);
            let meaning = answer.kind.words();
            let (receiver, quantity) = (answer.receiver.clone(), answer.quantity.name().to_owned());
            let error = format!("± {error} ({meaning})");
            [
                receiver,
                quantity,
                number(answer.band),
                number(answer.bin),
                value,
                error,
                answer.unit().to_owned(),
            ]
        };
        let head = ["receiver", "quantity", "band", "bin", "value", "error", "unit"];
        Table::new(head, self.answers.iter().map(row))
    }

    /// Displays the answers in a notebook cell.
    pub fn evcxr_display(&self) {
        self.table().evcxr_display();
    }
}

impl Map {
    /// Displays the map in a notebook cell, as drawn by [`png`], with a caption; points and faces in
    /// no order have the caption only.
    pub fn evcxr_display(&self) {
        if self.layout == Layout::List {
            return print_content("text/plain", &self.caption());
        }
        match png(self) {
            Ok(file) => {
                print_content("image/png", &STANDARD.encode(file));
                print_content("text/plain", &self.caption());
            }
            Err(error) => print_content("text/plain", &format!("the map cannot be drawn: {error}")),
        }
    }

    /// Returns the caption of the picture, with the values of its darkest and brightest colours.
    fn caption(&self) -> String {
        let cells = total(self);
        let values = || cells.iter().copied().filter(|value| value.is_finite());
        let (least, most) = (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max));
        let (quantity, unit) = (self.quantity.name(), self.quantity.unit());
        format!("{quantity} of {}: from {least:.3} to {most:.3} {unit}", self.receiver)
    }
}
