//! What misses the tolerance: numbers, cells of maps and pixels of images whose errors are larger than it allows, and the sentence that tells so.

use forms::core::diagnostic::counted;
use forms_radiometry::output::rough;
use forms_radiometry::simulation::{Answer, MissedCells, Simulation};

/// The most numbers that are named, and the most maps and images.
const MOST: usize = 4;

/// What of a simulation misses a tolerance.
pub(super) struct Missed<'s> {
    found: &'s Simulation,
    tolerance: f64,
    /// For each answer, in their order, whether it does.
    numbers: Vec<bool>,
    cells: Vec<MissedCells<'s>>,
}

impl<'s> Missed<'s> {
    /// What misses this tolerance.
    pub(super) fn of(found: &'s Simulation, tolerance: f64) -> Self {
        let accuracy = found.accuracy();
        Self {
            found,
            tolerance,
            numbers: accuracy.missed(tolerance),
            cells: accuracy.missed_cells(tolerance),
        }
    }

    /// Nothing, where no tolerance was asked for.
    pub(super) fn nothing(found: &'s Simulation) -> Self {
        Self { found, tolerance: f64::INFINITY, numbers: vec![false; found.answers.len()], cells: Vec::new() }
    }

    /// Whether the answer in this place does, or cells or pixels of the map or image that it is the mean of do.
    pub(super) fn has(&self, place: usize, answer: &Answer) -> bool {
        let is_mean = |MissedCells { map, band, .. }: &MissedCells<'_>| {
            (&map.receiver, map.quantity, *band) == (&answer.receiver, answer.quantity, answer.band)
        };
        self.numbers[place] || self.cells.iter().any(is_mean)
    }

    /// The sentence that names it, if there is anything.
    pub(super) fn sentence(&self) -> Option<String> {
        let missed: Vec<&Answer> = self
            .found
            .answers
            .iter()
            .zip(&self.numbers)
            .filter(|(_, missed)| **missed)
            .map(|(a, _)| a)
            .collect();
        let mut names: Vec<String> = missed.iter().take(MOST).map(|answer| name(answer)).collect();
        names.extend((missed.len() > MOST).then(|| format!("{} more", missed.len() - MOST)));
        let mut of_cells: Vec<String> = self.cells.iter().take(MOST).map(cells).collect();
        of_cells.extend((self.cells.len() > MOST).then(|| {
            format!("cells or pixels of {} more", counted(self.cells.len() - MOST, "band of a map or image"))
        }));
        let subject = match (missed.len(), self.cells.is_empty()) {
            (0, true) => return None,
            (0, false) => "cells of maps or pixels of images miss".to_owned(),
            (1, _) => "1 number misses".to_owned(),
            (count, _) => format!("{count} numbers miss"),
        };
        let parts = [names.join(", "), of_cells.join(", ")].into_iter().filter(|part| !part.is_empty());
        let parts: Vec<String> = parts.collect();
        Some(format!("{subject} the tolerance {:e}: {}", self.tolerance, parts.join("; ")))
    }
}

/// An answer by its receiver, quantity, band and bin.
fn name(answer: &Answer) -> String {
    let places = [answer.band.map(|band| format!("band {band}")), answer.bin.map(|bin| format!("bin {bin}"))];
    let places: String = places.into_iter().flatten().map(|place| format!(", {place}")).collect();
    format!("`{}` ({}{places})", answer.receiver, answer.quantity.name())
}

/// The cells or pixels of a map or image in one band, with the largest of their errors.
fn cells(missed: &MissedCells<'_>) -> String {
    let MissedCells { map, band, counts: [missed, all], worst } = missed;
    let what = if map.is_image { "pixels" } else { "cells" };
    let band = band.map_or(String::new(), |band| format!(" in band {band}"));
    format!(
        "{missed} of {all} {what} of `{}`{band}, by up to {} of what they are relative to",
        map.receiver,
        rough(*worst)
    )
}
