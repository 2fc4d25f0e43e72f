//! The figure: a row for each kernel, a mark for each function, time per value along a logarithmic
//! axis. Each author has a mark of its own.

use crate::catalogue::Author;
use crate::page::processor;
use crate::table::Row;
use forms_figures::{Axis, Colour, Mark, Numbers, Plot, Series};

/// Authors shown, with their marks; the first is drawn last.
const SHOWN: [(Author, Mark, Colour); 5] = [
    (Author::Generated, Mark::Dot, Colour::Vermilion),
    (Author::Expert, Mark::Stroke, Colour::Ink),
    (Author::GeneratedScalar, Mark::Ring, Colour::Vermilion),
    (Author::Wrenfold, Mark::Square, Colour::Blue),
    (Author::SymPy, Mark::Frame, Colour::Green),
];

/// Returns the figure as the text of an SVG file.
pub(crate) fn svg(rows: &[Row]) -> String {
    // the first row is the uppermost
    let upwards = || rows.iter().rev().enumerate();
    let series = SHOWN.iter().map(|&(author, mark, colour)| {
        let place = |(number, row): (usize, &Row)| Some([row.of(author)?, number as f64]);
        Series::marks(author.name(), upwards().filter_map(place).collect(), mark).coloured(colour)
    });
    let names = upwards().map(|(_, row)| row.name.to_owned()).collect();
    let times = rows.iter().flat_map(|row| SHOWN.iter().filter_map(|shown| row.of(shown.0)));
    let plot = Plot {
        title: "Time per value of each kernel".to_owned(),
        description: "A mark for each program: left is faster.".to_owned(),
        note: format!("{}, one thread, medians of one run", processor()),
        x: Axis::logarithmic("time per value").with_numbers(Numbers::Seconds).over(Axis::decades(times)),
        y: Axis::linear("").with_numbers(Numbers::Names(names)),
        series: series.collect(),
        ..Plot::default()
    };
    plot.svg()
}
