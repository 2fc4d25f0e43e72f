//! Results that miss the tolerance: numbers, cells of maps and pixels of images with larger errors,
//! and the sentence that reports them.

use forms::core::diagnostic::counted;
use forms_radiometry::output::rough;
use forms_radiometry::simulation::{Answer, Layout, MissedCells, Simulation};

/// Largest number of numbers in the sentence, and of maps and images.
const MOST: usize = 4;

/// Results of a simulation that miss a tolerance.
pub(super) struct Missed<'s> {
    found: &'s Simulation,
    tolerance: f64,
    /// Whether each answer misses the tolerance, in the order of the answers.
    numbers: Vec<bool>,
    cells: Vec<MissedCells<'s>>,
}

impl<'s> Missed<'s> {
    /// Collects the results that miss this tolerance.
    pub(super) fn of(found: &'s Simulation, tolerance: f64) -> Self {
        let accuracy = found.accuracy();
        Self {
            found,
            tolerance,
            numbers: accuracy.missed(tolerance),
            cells: accuracy.missed_cells(tolerance),
        }
    }

    /// Returns an empty collection, for a run without a tolerance.
    pub(super) fn nothing(found: &'s Simulation) -> Self {
        Self { found, tolerance: f64::INFINITY, numbers: vec![false; found.answers.len()], cells: Vec::new() }
    }

    /// Whether the answer at this index misses the tolerance, or is the mean of a map or image with
    /// cells or pixels that do.
    pub(super) fn has(&self, place: usize, answer: &Answer) -> bool {
        let is_mean = |MissedCells { map, band, .. }: &MissedCells<'_>| {
            (&map.receiver, map.quantity, *band) == (&answer.receiver, answer.quantity, answer.band)
        };
        self.numbers[place] || self.cells.iter().any(is_mean)
    }

    /// Returns the sentence that names the missed results, if there are any.
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

/// Describes an answer by its receiver, quantity, band and bin.
fn name(answer: &Answer) -> String {
    let places = [answer.band.map(|band| format!("band {band}")), answer.bin.map(|bin| format!("bin {bin}"))];
    let places: String = places.into_iter().flatten().map(|place| format!(", {place}")).collect();
    format!("`{}` ({}{places})", answer.receiver, answer.quantity.name())
}

/// Describes the missed cells or pixels of a map or image in one band, with the largest of their
/// errors.
fn cells(missed: &MissedCells<'_>) -> String {
    let MissedCells { map, band, counts: [missed, all], worst } = missed;
    let what = if map.layout == Layout::Image { "pixels" } else { "cells" };
    let band = band.map_or(String::new(), |band| format!(" in band {band}"));
    format!(
        "{missed} of {all} {what} of `{}`{band}, with relative errors up to {}",
        map.receiver,
        rough(*worst)
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::commands::simulate::answers::lines;
    use forms_radiometry::simulation::{ErrorKind, ErrorParts, Map, Quantity};

    fn number(receiver: &str, quantity: Quantity, [value, error]: [f64; 2]) -> Answer {
        Answer {
            receiver: receiver.to_owned(),
            quantity,
            band: None,
            bin: None,
            value,
            error,
            parts: ErrorParts { quadrature: error, ..ErrorParts::default() },
            kind: ErrorKind::Estimate,
            seconds: 0.0,
        }
    }

    /// Builds a simulation with one number and an image of four pixels, with these errors. A lamp
    /// is in the first pixel.
    fn simulation(of_number: f64, of_pixels: [f64; 4]) -> Simulation {
        let image = Map {
            receiver: "eye".to_owned(),
            quantity: Quantity::Radiance,
            size: [2, 2],
            values: vec![vec![90.0, 1.0, 2.0, 3.0]],
            errors: vec![of_pixels.to_vec()],
            scales: vec![2.0],
            kind: ErrorKind::Estimate,
            layout: Layout::Image,
        };
        let mean = number("eye", Quantity::Radiance, [24.0, 0.0]);
        let answers = vec![number("here", Quantity::Irradiance, [5.0, of_number]), mean];
        Simulation { answers, maps: vec![image], ..Simulation::default() }
    }

    /// Returns the results that miss a tolerance of 0.01: whether each number is marked, the
    /// sentence, and the largest error.
    fn missed(found: &Simulation) -> (Vec<bool>, Option<String>, f64) {
        let missed = Missed::of(found, 1e-2);
        let mut output = Vec::new();
        lines(found, &missed, false, &mut output).expect("memory");
        let text = String::from_utf8(output).expect("text");
        let of_numbers = text.lines().filter(|line| line.contains("\"receiver\":"));
        let marked = of_numbers.map(|line| line.contains("\"missed\":true")).collect();
        (marked, missed.sentence(), found.accuracy().largest_error())
    }

    #[test]
    fn pixels_are_judged_beside_the_scale_of_their_image_or_their_own_value() {
        // The relative errors are 0.9 of 90, 0.02 of 2 (the scale) for the darker pixels, and 0.03
        // of 3.
        let found = simulation(0.05, [0.9, 0.02, 0.02, 0.03]);
        assert_eq!(missed(&found), (vec![false, false], None, 0.01));
        let (marked, sentence, largest) = missed(&simulation(0.05, [0.9, 0.05, 0.02, 0.045]));
        assert_eq!((marked, largest), (vec![false, true], 0.025));
        let expected = "cells of maps or pixels of images miss the tolerance 1e-2: 2 of 4 pixels of `eye`, with relative errors up to 2.5e-2";
        assert_eq!(sentence.as_deref(), Some(expected));
    }

    #[test]
    fn numbers_and_pixels_that_miss_the_tolerance_are_in_one_sentence() {
        let (marked, sentence, largest) = missed(&simulation(0.1, [1.8, 0.0, 0.0, 0.0]));
        assert_eq!((marked, largest), (vec![true, true], 0.02));
        let expected = "1 number misses the tolerance 1e-2: `here` (irradiance); 1 of 4 pixels of `eye`, with relative errors up to 2.0e-2";
        assert_eq!(sentence.as_deref(), Some(expected));
    }

    #[test]
    fn many_numbers_are_judged_in_time_that_goes_with_their_number() {
        let many = |count: usize| {
            let numbers =
                (0..count).map(|index| number(&index.to_string(), Quantity::Irradiance, [1.0, 1e-3]));
            Simulation { answers: numbers.collect(), ..Simulation::default() }
        };
        // This takes seconds; a search of all numbers for each number would take minutes.
        let found = many(200_000);
        assert_eq!(found.accuracy().missed(1e-2).iter().filter(|missed| **missed).count(), 0);
        assert_eq!(found.accuracy().largest_error(), 1e-3);
    }
}
